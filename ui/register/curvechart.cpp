// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/curvechart.h"

#include "figures/ticks.h"
#include "register/listing.h"
#include "register/machinetrend.h"
#include "report/wording.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QAreaSeries>
#include <QButtonGroup>
#include <QChart>
#include <QComboBox>
#include <QEvent>
#include <QGraphicsLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLegend>
#include <QLineSeries>
#include <QLocale>
#include <QScatterSeries>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <QValueAxis>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

void clear(QChart &chart) {
    chart.removeAllSeries();
    for (QAbstractAxis *axis : chart.axes()) {
        chart.removeAxis(axis);
        delete axis;
    }
}

QChartView *makeView(const char *name) {
    auto *view = new QChartView;
    view->setObjectName(QString::fromLatin1(name));
    view->setRenderHint(QPainter::Antialiasing);
    view->setFrameShape(QFrame::NoFrame);
    view->setRubberBand(QChartView::RectangleRubberBand);
    view->chart()->legend()->hide();
    view->chart()->layout()->setContentsMargins(0, 0, 0, 0);
    view->chart()->setMargins(QMargins(0, 4, 8, 0));
    view->chart()->setBackgroundRoundness(0);
    view->setMinimumHeight(90);
    return view;
}

/// Axes that hold all points, with round ticks.
void addAxes(QChart &chart, const QPalette &palette, const QString &title, const QString &unit) {
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
    chart.setLocale(QLocale(windowLanguage().code()));
    chart.setLocalizeNumbers(true);
    constexpr int parts = 6;
    const double room = most > least ? 0.08 * (most - least) : 1;
    FigureAxis x;
    FigureAxis y;
    setRange(x, left, right > left ? right : left + 1, parts, TickSteps::lengths, windowLanguage());
    setRange(y, least - room, most + room, parts, TickSteps::values, windowLanguage());
    const auto add = [&](const FigureAxis &range, Qt::Alignment side, const QString &name) {
        auto *axis = new QValueAxis;
        axis->setRange(range.from, range.to);
        axis->setTickType(QValueAxis::TicksDynamic);
        axis->setTickAnchor(0);
        axis->setTickInterval(range.step);
        axis->setLabelFormat(range.step < 1 ? QStringLiteral("%.1f") : QStringLiteral("%.0f"));
        axis->setLabelsColor(token(Token::secondaryText, palette));
        axis->setLabelsFont(themeFont(TextSize::tiny));
        axis->setTitleFont(themeFont(TextSize::tiny));
        axis->setTitleBrush(token(Token::secondaryText, palette));
        axis->setTitleText(name);
        axis->setGridLineColor(token(Token::line, palette));
        axis->setLinePenColor(token(Token::secondaryText, palette));
        chart.addAxis(axis, side);
        for (QAbstractSeries *series : chart.series())
            series->attachAxis(axis);
    };
    add(x, Qt::AlignBottom, QStringLiteral("P"));
    add(y, Qt::AlignLeft, title + u' ' + unit);
}

} // namespace

CurveComparison::CurveComparison(QWidget *parent)
    : QWidget(parent)
    , m_title(new QLabel)
    , m_list(new QLabel)
    , m_curves(makeView("curves"))
    , m_differences(makeView("curveDifference"))
    , m_differenceTitle(new QLabel)
    , m_first(new QComboBox)
    , m_second(new QComboBox)
    , m_travel(new QLabel) {
    setObjectName(QStringLiteral("curveComparison"));
    m_title->setFont(themeFont(TextSize::head));
    m_differenceTitle->setFont(themeFont(TextSize::head));
    m_first->setObjectName(QStringLiteral("firstCurve"));
    m_second->setObjectName(QStringLiteral("secondCurve"));
    auto *head = new QHBoxLayout;
    head->addWidget(m_title);
    head->addStretch();
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
    auto *close = new QToolButton;
    close->setObjectName(QStringLiteral("closeComparison"));
    close->setIcon(lineIcon(QStringLiteral("close")));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close"));
    close->setAccessibleName(tr("Close"));
    head->addWidget(close);
    connect(close, &QToolButton::clicked, this, &CurveComparison::closed);
    auto *row = new QHBoxLayout;
    row->addWidget(m_differenceTitle);
    row->addWidget(m_first);
    row->addWidget(new QLabel(QStringLiteral("−")));
    row->addWidget(m_second);
    row->addWidget(m_travel, 1);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 8, 16, 8);
    layout->addLayout(head);
    layout->addWidget(m_list);
    layout->addWidget(m_curves, 5);
    layout->addLayout(row);
    layout->addWidget(m_differences, 3);
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

double CurveComparison::scale() const {
    const bool angular = !m_tests.empty() && m_tests.front().test.angular;
    return unitScale(angular ? Quantity::angularDeviation : Quantity::deviation, windowLanguage().units());
}

QString CurveComparison::unit() const {
    const bool angular = !m_tests.empty() && m_tests.front().test.angular;
    return windowLanguage().unit(angular ? Quantity::angularDeviation : Quantity::deviation);
}

QPen CurveComparison::penOf(std::size_t curve) const {
    const std::array colours{palette().color(QPalette::Text), token(Token::explanation, palette()),
                             token(Token::accent, palette()), token(Token::downText, palette()),
                             token(Token::ok, palette()),     token(Token::secondaryText, palette())};
    QPen pen(colours.at(curve % colours.size()), 1.8);
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
    QStringList names;
    for (std::size_t i = 0; i < m_tests.size(); ++i) {
        const RegisteredTest &test = m_tests[i].test;
        const QPen pen = penOf(i);
        auto *line = new QLineSeries;
        auto *marks = new QScatterSeries;
        const auto end = [&] {
            if (line->count() > 0) {
                line->setPen(pen);
                chart.addSeries(line);
                line = new QLineSeries;
            }
        };
        for (const PlacedValue &value : meansOf(test.curve, m_of)) {
            if (!value.value) { // nothing is known between its neighbours
                end();
                continue;
            }
            line->append(value.position, *value.value * scale());
            marks->append(value.position, *value.value * scale());
        }
        end();
        delete line;
        marks->setMarkerSize(7);
        marks->setMarkerShape(i % 3 == 0   ? QScatterSeries::MarkerShapeCircle
                              : i % 3 == 1 ? QScatterSeries::MarkerShapeRectangle
                                           : QScatterSeries::MarkerShapeRotatedRectangle);
        marks->setColor(i % 3 == 0 ? pen.color() : palette().color(QPalette::Base));
        marks->setBorderColor(pen.color());
        chart.addSeries(marks);
        QStringList words{test.date ? windowLanguage().shortDate(*test.date) : QString()};
        for (const Text &word : {purposeText(test.purpose), roleText(test.role)}) {
            if (!word.empty())
                words << windowLanguage().text(word);
        }
        names << QStringLiteral("<b style='color:%1'>%2</b>&nbsp; %3")
                     .arg(pen.color().name())
                     .arg(i + 1)
                     .arg(words.join(QStringLiteral(" · ")).toHtmlEscaped());
    }
    addAxes(chart, palette(), QStringLiteral("x̄"), unit());
    m_list->setText(names.join(QStringLiteral("<br>")));
    rebuildDifference();
}

void CurveComparison::rebuildDifference() {
    QChart &chart = *m_differences->chart();
    clear(chart);
    chart.setBackgroundBrush(palette().color(QPalette::Base));
    m_difference.reset();
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
    auto *line = new QLineSeries;
    const auto end = [&] {
        if (line->count() == 0)
            return;
        auto *zero = new QLineSeries(line);
        for (const QPointF &point : line->points())
            zero->append(point.x(), 0);
        line->setPen(pen);
        auto *area = new QAreaSeries(line, zero);
        QColor fill = pen.color();
        fill.setAlphaF(0.20F);
        area->setBrush(fill);
        area->setPen(Qt::NoPen);
        chart.addSeries(area);
        chart.addSeries(line);
        line = new QLineSeries;
    };
    for (const PlacedValue &value : m_difference->values) {
        if (value.value)
            line->append(value.position, *value.value * scale());
        else
            end();
    }
    end();
    delete line;
    addAxes(chart, palette(), QStringLiteral("Δx̄"), unit());
    const bool angular = m_tests.front().test.angular;
    const Quantity position = angular ? Quantity::angle : Quantity::position;
    QString text = tr("common travel %1 to %2")
                       .arg(windowLanguage().number(m_difference->from, position, 0),
                            windowLanguage().quantity(m_difference->to, position, 0));
    if (m_difference->largest)
        text =
            tr("largest %1 at %2")
                .arg(windowLanguage().quantity(*m_difference->largest->value,
                                               angular ? Quantity::angularDeviation : Quantity::deviation, 1),
                     windowLanguage().quantity(m_difference->largest->position, position, 0)) +
            QStringLiteral(" · ") + text;
    m_travel->setText(text);
}

} // namespace palmer::ui
