// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/targetcard.h"

#include "figures/targetstrip.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/evaluation/targetvalue.h"
#include "report/tables/readingtable.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/readings/targetstatisticsview.h"
#include "ui/readings/targetstripview.h"
#include "ui/theme.h"

#include <QLabel>
#include <QToolButton>
#include <algorithm>

namespace palmer::ui {

namespace {

/// A row of the small table: quantities of targetValue for ↑, ↓ and both; "" if there is none.
struct Quantities {
    const char *symbol = nullptr;
    std::array<const char *, 3> ids{};
};

constexpr std::array rows{
    Quantities{"x̄", {"mean+", "mean-", "mean"}},
    Quantities{"s", {"s+", "s-", ""}},
    Quantities{"R", {"R+", "R-", "R"}},
    Quantities{"B", {"", "", "reversal"}},
};

} // namespace

TargetCard::TargetCard(Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_selection(selection)
    , m_title(made<QLabel>("targetTitle", this))
    , m_position(made<QLabel>(trait::secondary, this))
    , m_previous(made<QToolButton>("previousTarget", trait::iconOnly, trait::strongFocus, this))
    , m_next(made<QToolButton>("nextTarget", trait::iconOnly, trait::strongFocus, this))
    , m_strip(new TargetStripView(selection, this))
    , m_statistics(made<TargetStatisticsView>("targetStatistics", this)) {
    setObjectName(QStringLiteral("targetCard"));
    m_previous->setIcon(lineIcon(QStringLiteral("left")));
    m_next->setIcon(lineIcon(QStringLiteral("right")));
    connect(m_previous, &QToolButton::clicked, this, [this] { step(-1); });
    connect(m_next, &QToolButton::clicked, this, [this] { step(1); });

    auto *head = inRow(8, {m_title, m_position, Placed::stretch(), m_previous, m_next});
    auto *body = inRow(20, {{m_strip, 1}, {m_statistics, 0, Qt::AlignTop}});
    inColumn(this, {pageMargin, 4, pageMargin, 4}, 2, {head, {body, 1}});

    connect(&selection, &Selection::targetChanged, this, &TargetCard::refresh);
    retranslate();
}

void TargetCard::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    refresh();
}

void TargetCard::setLanguage(const Language &language) {
    m_language = language;
    refresh();
}

void TargetCard::addStripActions(const QList<QAction *> &actions) {
    m_strip->addActions(actions);
    m_strip->setContextMenuPolicy(Qt::ActionsContextMenu);
}

std::size_t TargetCard::count() const {
    const auto *m = measured<PositioningMeasurement>(m_evaluated, m_test);
    return m ? m->targets.size() : 0;
}

std::size_t TargetCard::current() const {
    return count() == 0 ? 0 : std::min(m_selection.target().value_or(0), count() - 1);
}

void TargetCard::step(int by) {
    if (count() == 0)
        return;
    const auto last = static_cast<std::ptrdiff_t>(count()) - 1;
    const auto target = static_cast<std::size_t>(
        std::clamp(static_cast<std::ptrdiff_t>(current()) + by, std::ptrdiff_t{0}, last));
    // The current cell moves too, so that table and card show the same target.
    if (const auto reading = m_selection.reading())
        m_selection.setReading(ReadingPlace{reading->run, target});
    else
        m_selection.setTarget(target);
}

void TargetCard::refresh() {
    const std::size_t targets = count();
    m_strip->setVisible(targets > 0);
    m_statistics->setVisible(targets > 0);
    m_previous->setEnabled(targets > 0 && current() > 0);
    m_next->setEnabled(targets > 0 && current() + 1 < targets);
    if (targets == 0) {
        m_title->clear();
        m_position->clear();
        return;
    }
    const Test &test = *m_evaluated.document->tests[m_test];
    const TestEvaluation &evaluation = *m_evaluated.tests[m_test];
    const PositioningMeasurement &measurement = *measured<PositioningMeasurement>(m_evaluated, m_test);
    const PositioningResults &results = resultsOf(measurement, evaluation);
    const std::size_t target = current();
    const ReadingTexts texts(measurement, m_language, ReadingUnit::deviations);
    m_title->setText(tr("Target %1").arg(target + 1));
    m_title->setFont(themeFont(TextSize::head));
    const QString unit = texts.positionUnit(); // degrees follow their number without a space
    m_position->setText(
        QStringLiteral("P = %1%2%3")
            .arg(texts.position(target), unit.size() == 1 ? QString() : QString(QChar(u'\u00a0')), unit));
    m_strip->setStrip(targetStrip(test, evaluation, target, m_language), target);
    m_strip->setAccessibleName(tr("Readings of target %1").arg(target + 1));
    m_statistics->setAccessibleName(tr("Statistics of target %1").arg(target + 1));
    const double c = evaluation.edition ? evaluation.edition->c : 0;
    std::vector<TargetStatisticsView::Row> shown;
    for (const Quantities &row : rows) {
        TargetStatisticsView::Row line{formulaFrom(QString::fromUtf8(row.symbol)), {}};
        for (std::size_t k = 0; k < row.ids.size(); ++k)
            line.values[k] = texts.statistic(targetValue(row.ids[k], results.targets[target], c));
        shown.push_back(std::move(line));
    }
    m_statistics->setRows(texts.deviationUnit(), tr("bidir.", "short for bidirectional"), std::move(shown));
}

void TargetCard::retranslate() {
    nameWidget(*m_previous, tr("Previous target"));
    nameWidget(*m_next, tr("Next target"));
    refresh();
}

} // namespace palmer::ui
