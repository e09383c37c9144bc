// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/circlefigureview.h"

#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/evaluation/resultsof.h"
#include "print/figures/style.h"
#include "ui/figures/circlecanvas.h"
#include "ui/madewidgets.h"
#include "ui/theme.h"

#include <QComboBox>
#include <QIconEngine>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

namespace palmer::ui {

namespace {

/// The line style of a path, as an icon for its button.
class TraceIcon : public QIconEngine {
public:
    TraceIcon(Sense sense, bool repetition, const QWidget *owner)
        : m_sense(sense)
        , m_repetition(repetition)
        , m_owner(owner) {}

    void paint(QPainter *painter, const QRect &area, QIcon::Mode, QIcon::State state) override {
        const Medium medium = screenMedium(m_owner->palette());
        const auto draw = [&](Sense sense, double y) {
            QPen pen = figurePen(pathRole(sense), medium);
            pen.setWidthF(pen.widthF() * 96 / 72 / (m_repetition ? 2 : 1));
            pen.setCapStyle(Qt::FlatCap);
            if (state == QIcon::Off)
                pen.setColor(blend(pen.color(), figureColor(FigureRole::background, medium), 0.35));
            painter->setPen(pen);
            painter->drawLine(QPointF(area.left(), y), QPointF(area.right() + 1, y));
        };
        const double middle = QRectF(area).center().y();
        painter->setRenderHint(QPainter::Antialiasing);
        if (!m_repetition)
            return draw(m_sense, middle);
        draw(Sense::counterclockwise, middle - 2);
        draw(Sense::clockwise, middle + 2);
    }
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap result(size);
        result.fill(Qt::transparent);
        QPainter painter(&result);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return result;
    }
    [[nodiscard]] QIconEngine *clone() const override { return new TraceIcon(*this); }

private:
    Sense m_sense;
    bool m_repetition;
    const QWidget *m_owner;
};

constexpr int rowSpacing = 6;
constexpr int combined = -1;
constexpr int sideBySide = -2;

} // namespace

CircleFigureView::CircleFigureView(Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_selection(selection)
    , m_choice(made<QComboBox>("circleChoice", this)) {
    setObjectName(QStringLiteral("circleFigureView"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    const auto toggle = [&](const char *name, Sense sense, bool repetition) {
        auto *button = made<QToolButton>(name, trait::checkable, trait::strongFocus, this);
        button->setChecked(!repetition);
        button->setAutoRaise(true);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setIconSize({22, 16});
        button->setIcon(QIcon(new TraceIcon(sense, repetition, this)));
        connect(button, &QToolButton::toggled, this, &CircleFigureView::refresh);
        return button;
    };
    m_counterclockwise = toggle("showCounterclockwise", Sense::counterclockwise, false);
    m_clockwise = toggle("showClockwise", Sense::clockwise, false);
    m_repetitions = toggle("showRepetitions", Sense::counterclockwise, true);
    auto *row =
        inRow(rowSpacing, {m_counterclockwise, m_clockwise, m_repetitions, Placed::stretch(), m_choice});
    auto *surfaces = inRow(4, {});
    for (CircleCanvas *&canvas : m_canvases) {
        canvas = new CircleCanvas(selection, this);
        surfaces->addWidget(canvas, 1);
        if (!m_current)
            m_current = canvas;
        connect(canvas, &CircleCanvas::pressed, this, [this, canvas] { m_current = canvas; });
        connect(canvas, &CircleCanvas::made, this, [this, canvas] {
            if (canvas == m_current)
                emit figureChanged();
        });
    }
    inColumn(this, noMargins, 2, {row, {surfaces, 1}});
    connect(m_choice, &QComboBox::activated, this, [this] {
        fit();
        refresh();
    });
    retranslate();
}

void CircleFigureView::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const bool other = test != m_test || m_evaluated.tests.empty();
    m_evaluated = evaluated;
    m_test = test;
    m_separate = separateCircleFigures(*evaluated.document->tests[test], *evaluated.tests[test]);
    fillChoice();
    if (other) {
        for (CircleCanvas *canvas : m_canvases)
            canvas->clear();
        m_choice->setCurrentIndex(0);
        fit(); // each test has its own zoom
    }
    refresh();
}

void CircleFigureView::setLanguage(const Language &language) {
    m_language = language;
    retranslate();
}

void CircleFigureView::setContacts(bool shown) {
    m_contacts = shown;
    refresh();
}

void CircleFigureView::setSynthetic(const SyntheticPaths &paths) {
    if (m_synthetic == paths)
        return;
    m_synthetic = paths;
    refresh();
}

void CircleFigureView::setMarking(const QString &label, const std::vector<RulingPoint> &points) {
    for (CircleCanvas *canvas : m_canvases)
        canvas->setMarking(label, points);
}

void CircleFigureView::clear() {
    m_evaluated = {};
    m_separate.clear();
    for (CircleCanvas *canvas : m_canvases)
        canvas->clear();
}

void CircleFigureView::fit() {
    for (CircleCanvas *canvas : m_canvases)
        canvas->fit();
}

void CircleFigureView::zoomBy(int steps) {
    for (CircleCanvas *canvas : m_canvases)
        canvas->zoomBy(steps);
}

std::optional<CircleFigure> CircleFigureView::paperFigure() const {
    return m_evaluated.tests.empty() ? std::nullopt : m_current->paperFigure();
}

QString CircleFigureView::deviationText(const ReadingPlace &point) const {
    return m_evaluated.tests.empty() ? QString() : m_current->deviationText(point);
}

/// Offers: combined; G(b) and G side by side; each figure of the standard.
void CircleFigureView::fillChoice() {
    const QSignalBlocker blocker(m_choice);
    const QVariant before = m_choice->currentData();
    m_choice->clear();
    m_choice->addItem(tr("Combined"), combined);
    const auto circular =
        std::ranges::count(m_separate, CircleSubject::circularDeviation, &CircleFigureOptions::subject);
    if (circular == 3)
        m_choice->addItem(tr("G(b) and G side by side"), sideBySide);
    const auto *measurement = measured<CircularMeasurement>(m_evaluated, m_test);
    for (std::size_t i = 0; measurement && i < m_separate.size(); ++i) {
        const CircleFigureOptions &one = m_separate[i];
        if (one.of == CircleOf::both)
            continue; // same as combined
        const Sense sense = one.of == CircleOf::clockwise ? Sense::clockwise : Sense::counterclockwise;
        const QString symbol =
            one.subject == CircleSubject::radialDeviation ? QStringLiteral("F") : QStringLiteral("G");
        m_choice->addItem(symbol + u' ' +
                              QString::fromStdString(iso230_4::axisIndex(measurement->plane, sense)),
                          static_cast<int>(i));
    }
    m_choice->setCurrentIndex(std::max(0, m_choice->findData(before)));
}

std::vector<CircleFigureOptions> CircleFigureView::chosen() const {
    const int choice = m_choice->currentData().toInt();
    std::vector<CircleFigureOptions> result;
    if (choice == sideBySide) {
        for (const CircleFigureOptions &one : m_separate) {
            if (one.subject == CircleSubject::circularDeviation)
                result.push_back(one);
        }
    } else if (choice >= 0 && static_cast<std::size_t>(choice) < m_separate.size()) {
        result.push_back(m_separate[static_cast<std::size_t>(choice)]);
    } else {
        result.emplace_back();
    }
    return result;
}

void CircleFigureView::refresh() {
    const auto *measurement = measured<CircularMeasurement>(m_evaluated, m_test);
    if (!measurement)
        return;
    const CircularResults &results = resultsOf(*measurement, *m_evaluated.tests[m_test]);
    const auto measured = [&](Sense sense) {
        return std::ranges::any_of(results.paths,
                                   [sense](const EvaluatedPath &path) { return path.sense == sense; });
    };
    m_counterclockwise->setVisible(measured(Sense::counterclockwise));
    m_clockwise->setVisible(measured(Sense::clockwise));
    m_repetitions->setVisible(!results.repetitions.empty());
    const std::vector<CircleFigureOptions> figures = chosen();
    for (std::size_t i = 0; i < m_canvases.size(); ++i) {
        m_canvases[i]->setVisible(i < figures.size());
        if (i >= figures.size()) {
            m_canvases[i]->clear();
            continue;
        }
        CircleCanvasContent content;
        content.options = figures[i];
        content.options.contacts = m_contacts;
        content.options.repetitions = m_repetitions->isChecked() && !results.repetitions.empty();
        content.counterclockwise = m_counterclockwise->isChecked();
        content.clockwise = m_clockwise->isChecked();
        content.synthetic = m_synthetic;
        m_canvases[i]->show(m_evaluated, m_test, content, m_language);
    }
    fitNames();
    if (!m_current->isVisibleTo(this))
        m_current = m_canvases.front();
    if (!m_current->isMaking()) // otherwise emitted when it is made
        emit figureChanged();
}

/// Without space for the words, buttons show the letters of the paths in the figure.
void CircleFigureView::fitNames() {
    const auto *measurement = measured<CircularMeasurement>(m_evaluated, m_test);
    const auto letters = [&](Sense sense) {
        return measurement ? QString::fromStdString(iso230_4::axisIndex(measurement->plane, sense))
                           : QString();
    };
    m_counterclockwise->setText(tr("anticlockwise"));
    m_clockwise->setText(tr("clockwise"));
    m_repetitions->setText(tr("repetitions"));
    int needed = m_choice->sizeHint().width();
    for (const QToolButton *button : {m_counterclockwise, m_clockwise, m_repetitions})
        needed += button->isHidden() ? 0 : button->sizeHint().width() + rowSpacing;
    if (needed <= width())
        return;
    m_counterclockwise->setText(letters(Sense::counterclockwise));
    m_clockwise->setText(letters(Sense::clockwise));
    m_repetitions->setText({});
}

void CircleFigureView::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    fitNames();
}

void CircleFigureView::describe(const QString &content) {
    for (CircleCanvas *canvas : m_canvases)
        canvas->setAccessibleDescription((canvas == m_current ? content + QStringLiteral(". ") : QString()) +
                                         tr("Plus and minus zoom, arrows move, 0 shows the whole; the wheel "
                                            "zooms"));
}

void CircleFigureView::retranslate() {
    m_choice->setAccessibleName(tr("Which figure"));
    m_choice->setToolTip(
        tr("All paths in one figure, or the figures of the standard about their own centres"));
    const auto name = [](QToolButton *button, const QString &tip) {
        nameWidget(*button, tip);
        button->setFont(themeFont(TextSize::small));
    };
    name(m_counterclockwise, tr("Show the path anticlockwise"));
    name(m_clockwise, tr("Show the path clockwise"));
    name(m_repetitions, tr("Show repeated paths"));
    m_choice->setFont(themeFont(TextSize::small));
    for (CircleCanvas *canvas : m_canvases)
        canvas->setAccessibleName(tr("Circle figure"));
    fillChoice();
    refresh();
}

} // namespace palmer::ui
