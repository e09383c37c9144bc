// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/curvechart.h"

#include "figures/ticks.h"
#include "register/listing.h"
#include "register/machinetrend.h"
#include "report/words/wording.h"
#include "ui/figures/canvaslabel.h"
#include "ui/figures/plotchart.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/register/numberaxis.h"
#include "ui/register/numbertag.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QAreaSeries>
#include <QBuffer>
#include <QButtonGroup>
#include <QCategoryAxis>
#include <QChart>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QLineSeries>
#include <QPainter>
#include <QResizeEvent>
#include <QScatterSeries>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

constexpr QSize sampleSize(54, 18);
constexpr int leastRows = 2; ///< of the list of curves, always visible

/// Axes that include all points, with round ticks.
void addAxes(QChart &chart, const QPalette &palette, const QString &title, const QString &positionTitle) {
    double left = 0;
    double right = 1;
    double least = 0;
    double most = 0;
    bool first = true;
    for (const QAbstractSeries *series : chart.series()) {
        const auto *line = qobject_cast<const QXYSeries *>(series);
        if (!line)
            continue;
        for (const QPointF &point : line->points()) {
            left = first ? point.x() : std::min(left, point.x());
            right = first ? point.x() : std::max(right, point.x());
            least = std::min(least, point.y());
            most = std::max(most, point.y());
            first = false;
        }
    }
    constexpr int parts = 6;
    const double room = most > least ? 0.08 * (most - least) : 1; // 0 is between them
    FigureAxis x;
    FigureAxis y;
    setRange(x, left, right > left ? right : left + 1, parts, TickSteps::lengths, windowLanguage());
    setRange(y, least - room, most + room, parts, TickSteps::values, windowLanguage());
    const auto add = [&](const FigureAxis &range, Qt::Alignment side, const QString &name) {
        QCategoryAxis *axis = makeNumberAxis(range, palette, name);
        chart.addAxis(axis, side);
        for (QAbstractSeries *series : chart.series())
            series->attachAxis(axis);
        QObject::connect(axis, &QValueAxis::rangeChanged, axis, [axis, range] { fillTicks(*axis, range); });
    };
    add(x, Qt::AlignBottom, positionTitle);
    add(y, Qt::AlignLeft, title);
}

/// Returns the stretches of values without gaps, in the units of a chart.
QList<QList<QPointF>> stretches(const std::vector<PlacedValue> &values, const QPointF &scales) {
    QList<QList<QPointF>> result{{}};
    for (const PlacedValue &value : values) {
        if (value.value)
            result.back().emplace_back(value.position * scales.x(), *value.value * scales.y());
        else
            result.emplace_back();
    }
    result.removeAll(QList<QPointF>());
    return result;
}

QLineSeries *lineThrough(const QList<QPointF> &points, const QPen &pen) {
    auto *line = new QLineSeries;
    line->append(points);
    line->setPen(pen);
    return line;
}

QScatterSeries::MarkerShape markerOf(std::size_t curve) {
    constexpr std::array shapes{QScatterSeries::MarkerShapeCircle, QScatterSeries::MarkerShapeRectangle,
                                QScatterSeries::MarkerShapeRotatedRectangle};
    return shapes.at(curve % shapes.size());
}

bool isFilled(std::size_t curve) {
    return markerOf(curve) == QScatterSeries::MarkerShapeCircle;
}

QString imageOf(const QPixmap &image, QSize size) {
    QByteArray png;
    QBuffer buffer(&png);
    image.save(&buffer, "PNG");
    return QStringLiteral(
               "<img width='%1' height='%2' style='vertical-align:middle' src='data:image/png;base64,%3'>")
        .arg(size.width())
        .arg(size.height())
        .arg(QString::fromLatin1(png.toBase64()));
}

QString wordsOf(const RegisteredTest &test) {
    QStringList words;
    for (const Text &word : {purposeText(test.purpose), roleText(test.role)}) {
        if (!word.empty())
            words << windowLanguage().text(word);
    }
    return words.join(QStringLiteral(" · "));
}

/// A transparent image as high as a sample, to make the header as high as a row.
QString strut() {
    constexpr QSize size(1, sampleSize.height());
    QPixmap nothing(size);
    nothing.fill(Qt::transparent);
    return imageOf(nothing, size);
}

/// Number, line and marker of a curve as in the charts, as an image for rich text.
QString sampleOf(std::size_t curve, const QPen &pen, const QPalette &palette, double ratio) {
    constexpr QSize size = sampleSize;
    constexpr double half = 3.5;
    QPixmap sample(size * ratio);
    sample.setDevicePixelRatio(ratio);
    sample.fill(Qt::transparent);
    QPainter painter(&sample);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = size.height() / 2.0;
    drawNumberTag(painter, QPointF(tagRadius + 0.5, middle), static_cast<int>(curve) + 1, palette);
    painter.setPen(pen);
    painter.drawLine(QPointF(20, middle), QPointF(52, middle));
    painter.setPen(QPen(pen.color(), 1.5));
    painter.setBrush(isFilled(curve) ? pen.color() : palette.color(QPalette::Base));
    painter.translate(36, middle);
    if (isFilled(curve))
        painter.drawEllipse(QPointF(), half, half);
    if (markerOf(curve) == QScatterSeries::MarkerShapeRotatedRectangle)
        painter.rotate(45);
    if (!isFilled(curve))
        painter.drawRect(QRectF(-half, -half, 2 * half, 2 * half));
    painter.end();
    return imageOf(sample, size);
}

} // namespace

TaggedChart::TaggedChart(const char *name) {
    constexpr int roomForTags = 24;
    setObjectName(QString::fromLatin1(name));
    setUpChart(*this, {0, 4, roomForTags, 0});
    setRubberBand(QChartView::RectangleRubberBand);
    setMinimumHeight(80);                                        // for the axis titles
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored); // takes the height the list leaves
}

void TaggedChart::setTags(std::vector<Tag> tags) {
    m_tags = std::move(tags);
    viewport()->update();
}

void TaggedChart::setBox(const QPointF &at, const QString &text, const QColor &colour) {
    m_boxAt = at;
    m_box = text;
    m_boxColour = colour;
    viewport()->update();
}

std::vector<QPointF> TaggedChart::tagPlaces() const {
    constexpr double away = 13;
    const QRectF plot = chart()->plotArea();
    std::vector<QPointF> places;
    std::vector<std::size_t> order;
    for (const Tag &tag : m_tags) {
        order.push_back(places.size());
        const QPointF end = chart()->mapToPosition(tag.end);
        places.emplace_back(std::clamp(end.x(), plot.left(), plot.right()) + away,
                            std::clamp(end.y(), plot.top(), plot.bottom()));
    }
    // Downwards, each keeps its distance to the one before; those too low are moved up again.
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places[i].y(); });
    double next = plot.top() + tagRadius;
    for (const std::size_t i : order) {
        places[i].setY(std::max(places[i].y(), next));
        next = places[i].y() + leastTagDistance;
    }
    double last = plot.bottom();
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        places[*i].setY(std::min(places[*i].y(), last));
        last = places[*i].y() - leastTagDistance;
    }
    return places;
}

void TaggedChart::drawForeground(QPainter *painter, const QRectF &rect) {
    QChartView::drawForeground(painter, rect);
    const std::vector<QPointF> places = tagPlaces();
    for (std::size_t i = 0; i < places.size(); ++i)
        drawNumberTag(*painter, places[i], m_tags[i].number, palette());
    if (m_box.isEmpty())
        return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QPointF at = chart()->mapToPosition(m_boxAt);
    painter->setPen(QPen(m_boxColour, 1.5));
    painter->setBrush(palette().color(QPalette::Base));
    painter->drawEllipse(at, 4, 4);
    paintCanvasLabel(*painter, *viewport(), at, m_box, m_boxColour);
    painter->restore();
}

CurveComparison::CurveComparison(QWidget *parent)
    : QWidget(parent)
    , m_title(made<QLabel>(TextSize::head))
    , m_list(made<QLabel>("curveList"))
    , m_listArea(new QScrollArea) // limits the list, so that many curves leave height for their chart
    , m_curves(new TaggedChart("curves"))
    , m_differences(new TaggedChart("curveDifference"))
    , m_differenceTitle(made<QLabel>(TextSize::head))
    , m_first(made<QComboBox>("firstCurve"))
    , m_second(made<QComboBox>("secondCurve"))
    , m_travel(new QLabel) {
    setObjectName(QStringLiteral("curveComparison"));
    auto *head = inRow(styleSpacing, {m_title, Placed::stretch()});
    auto *choice = new QButtonGroup(this);
    for (const auto &[word, of] :
         {std::pair("x̄", CurveOf::both), std::pair("x̄↑", CurveOf::up), std::pair("x̄↓", CurveOf::down)}) {
        auto *button = new QToolButton;
        button->setText(QString::fromUtf8(word));
        button->setCheckable(true);
        button->setChecked(of == CurveOf::both);
        choice->addButton(button);
        head->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, of = of] {
            m_of = of;
            rebuild();
        });
    }
    auto *close = made<QToolButton>("closeComparison");
    close->setIcon(lineIcon(QStringLiteral("close")));
    close->setAutoRaise(true);
    nameWidget(*close, tr("Close"));
    head->addWidget(close);
    connect(close, &QToolButton::clicked, this, &CurveComparison::closed);
    auto *row = inRow(styleSpacing,
                      {m_differenceTitle, m_first, new QLabel(QStringLiteral("−")), m_second, {m_travel, 1}});
    QScrollArea *area = m_listArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    area->setWidget(m_list);
    area->viewport()->setAutoFillBackground(false);
    m_list->setAutoFillBackground(false);
    m_list->setAlignment(Qt::AlignTop);
    inColumn(this, {pageMargin, 8, pageMargin, 8}, styleSpacing,
             {head, area, {m_curves, 5}, row, {m_differences, 3}});
    for (QComboBox *box : {m_first, m_second})
        connect(box, &QComboBox::currentIndexChanged, this, &CurveComparison::rebuildDifference);
    m_travel->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_travel->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    retranslate();
}

void CurveComparison::changeEvent(QEvent *event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange)
        rebuild();
}

void CurveComparison::retranslate() {
    m_title->setText(tr("Compare curves"));
    m_differenceTitle->setText(tr("Difference"));
    m_curves->setAccessibleName(tr("Compare curves"));
    m_differences->setAccessibleName(tr("Difference"));
    m_first->setAccessibleName(tr("Curve that is looked at"));
    m_second->setAccessibleName(tr("Curve that is taken off"));
}

bool CurveComparison::isAngular() const {
    return !m_tests.empty() && m_tests.front().test.angular;
}

Quantity CurveComparison::valueQuantity() const {
    return isAngular() ? Quantity::angularDeviation : Quantity::deviation;
}

Quantity CurveComparison::positionQuantity() const {
    return isAngular() ? Quantity::angle : Quantity::position;
}

QPointF CurveComparison::scales() const {
    const DisplayUnits &units = windowLanguage().units();
    return {unitScale(positionQuantity(), units), unitScale(valueQuantity(), units)};
}

/// Axes in the units of the window.
void CurveComparison::addAxes(QChart &chart, const QString &title) const {
    const Language &language = windowLanguage();
    ui::addAxes(chart, palette(), title + u' ' + language.unit(valueQuantity()),
                QStringLiteral("P ") + language.unit(positionQuantity()));
}

QPen CurveComparison::penOf(std::size_t curve) const {
    QPen pen(curveColour(curve, palette()), 1.8);
    if (curve % 2 == 1)
        pen.setDashPattern({5, 3});
    return pen;
}

void CurveComparison::setTests(std::vector<ListedTest> tests) {
    if (tests.size() > mostCurves)
        tests.resize(mostCurves);
    m_tests = std::move(tests);
    {
        const QSignalBlocker first(m_first);
        const QSignalBlocker second(m_second);
        m_first->clear();
        m_second->clear();
        for (std::size_t i = 0; i < m_tests.size(); ++i) {
            m_first->addItem(QString::number(i + 1));
            m_second->addItem(QString::number(i + 1));
        }
        if (m_tests.size() > 1)
            m_first->setCurrentIndex(1);
    }
    rebuild();
}

void CurveComparison::rebuild() {
    QChart &chart = *m_curves->chart();
    clear(chart);
    chart.setBackgroundBrush(palette().color(QPalette::Base));
    std::vector<TaggedChart::Tag> tags;
    for (std::size_t i = 0; i < m_tests.size(); ++i) {
        const QPen pen = penOf(i);
        auto *marks = new QScatterSeries;
        for (const QList<QPointF> &points : stretches(meansOf(m_tests[i].test.curve, m_of), scales())) {
            chart.addSeries(lineThrough(points, pen));
            marks->append(points);
        }
        marks->setMarkerSize(7);
        marks->setMarkerShape(markerOf(i));
        marks->setColor(isFilled(i) ? pen.color() : palette().color(QPalette::Base));
        marks->setBorderColor(pen.color());
        if (marks->count() > 0)
            tags.push_back({static_cast<int>(i) + 1, marks->points().last()});
        chart.addSeries(marks);
    }
    addAxes(chart, QStringLiteral("x̄"));
    m_curves->setTags(std::move(tags));
    showList();
    rebuildDifference();
}

/// Shows which test each number denotes, with the main results; purpose and role are cut first.
void CurveComparison::showList() {
    constexpr int unlimited = QWIDGETSIZE_MAX;
    constexpr int leastWords = 40;
    m_list->setText(listOf(unlimited));
    int widest = 0;
    for (const ListedTest &test : m_tests)
        widest = std::max(widest, m_list->fontMetrics().horizontalAdvance(wordsOf(test.test)));
    const QMargins margins = layout()->contentsMargins();
    const int room =
        width() - margins.left() - margins.right() - m_listArea->verticalScrollBar()->sizeHint().width();
    if (const int tooWide = m_list->sizeHint().width() - room; tooWide > 0)
        m_list->setText(listOf(std::max(leastWords, widest - tooWide)));
    fitList();
}

QString CurveComparison::listOf(int mostWords) const {
    const std::vector<std::string> parameters = mainParametersOf(m_tests);
    const QString cell =
        QStringLiteral("<td align='%1' valign='middle' style='padding:1px 8px 1px 0'>%2</td>");
    QString html = QStringLiteral("<table width='100%'><tr>") +
                   cell.arg(QStringLiteral("left"), strut() + tr("Test")) +
                   cell.arg(QStringLiteral("left"), QString()) +
                   cell.arg(QStringLiteral("right"), windowLanguage().unit(valueQuantity()));
    for (const std::string &parameter : parameters)
        html += cell.arg(QStringLiteral("right"), plainSymbolOf(parameter).toHtmlEscaped());
    html += QStringLiteral("</tr>");
    for (std::size_t i = 0; i < m_tests.size(); ++i) {
        const RegisteredTest &test = m_tests[i].test;
        const QString words = m_list->fontMetrics().elidedText(wordsOf(test), Qt::ElideRight, mostWords);
        html += QStringLiteral("<tr>") +
                cell.arg(QStringLiteral("left"), sampleOf(i, penOf(i), palette(), devicePixelRatioF())) +
                cell.arg(QStringLiteral("left"),
                         (test.date ? windowLanguage().shortDate(*test.date) : QString()).toHtmlEscaped()) +
                cell.arg(QStringLiteral("left"), words.toHtmlEscaped());
        for (const std::string &parameter : parameters) {
            const RegisteredResult *result = resultOf(test, parameter);
            html += cell.arg(QStringLiteral("right"),
                             result ? shownResult(*result, test.angular, windowLanguage()).value
                                    : QStringLiteral("–"));
        }
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

/// Shows whole rows, as many as leave the charts their height.
void CurveComparison::fitList() {
    const int rows = static_cast<int>(m_tests.size()) + 1;
    const int row = (m_list->sizeHint().height() + rows - 1) / rows;
    const int others = heightOfOthers();
    const int least = std::min(rows, leastRows + 1);
    m_listArea->setFixedHeight(std::clamp((height() - others) / row, least, rows) * row);
    setMinimumHeight(others + least * row);
}

int CurveComparison::heightOfOthers() const {
    return layout()->minimumSize().height() - m_listArea->minimumHeight();
}

int CurveComparison::wantedHeight() const {
    constexpr int goodCharts = 110; // more than they need
    return heightOfOthers() + m_list->sizeHint().height() + goodCharts;
}

void CurveComparison::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        showList();
    else
        fitList();
}

void CurveComparison::rebuildDifference() {
    QChart &chart = *m_differences->chart();
    clear(chart);
    chart.setBackgroundBrush(palette().color(QPalette::Base));
    m_difference.reset();
    m_differences->setBox({}, {}, {});
    const int first = m_first->currentIndex();
    const int second = m_second->currentIndex();
    if (first < 0 || second < 0)
        return;
    const auto curve = [&](int index) {
        return meansOf(m_tests[static_cast<std::size_t>(index)].test.curve, m_of);
    };
    m_difference = differenceOf(curve(first), curve(second));
    if (!m_difference) {
        m_travel->setText(tr("no common travel"));
        return;
    }
    const QPen pen = penOf(static_cast<std::size_t>(first));
    for (const QList<QPointF> &points : stretches(m_difference->values, scales())) {
        QLineSeries *line = lineThrough(points, pen);
        auto *zero = new QLineSeries(line);
        zero->append({{points.front().x(), 0}, {points.back().x(), 0}});
        auto *area = new QAreaSeries(line, zero);
        QColor fill = pen.color();
        fill.setAlphaF(0.20F);
        area->setBrush(fill);
        area->setPen(Qt::NoPen);
        chart.addSeries(area);
        chart.addSeries(line);
    }
    addAxes(chart, QStringLiteral("Δx̄"));
    sayDifference(pen.color());
}

void CurveComparison::sayDifference(const QColor &ink) {
    const Quantity position = positionQuantity();
    m_travel->setText(tr("common travel %1 to %2")
                          .arg(windowLanguage().number(m_difference->from, position),
                               windowLanguage().quantity(m_difference->to, position)));
    if (m_difference->largest) {
        const PlacedValue &largest = *m_difference->largest;
        const QString where = windowLanguage().quantity(*largest.value, valueQuantity(), 1) +
                              QStringLiteral(" · ") + windowLanguage().quantity(largest.position, position);
        m_differences->setBox({largest.position * scales().x(), *largest.value * scales().y()},
                              *largest.value > 0 ? u'+' + where : where, ink);
    }
}

} // namespace palmer::ui
