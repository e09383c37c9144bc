// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/uncertainty/simulationrow.h"

#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"
#include "ui/theme.h"

#include <QProgressBar>
#include <QPushButton>
#include <QtMath>

namespace palmer::ui {

namespace {

constexpr int barWidth = 96;
constexpr int progressHeight = 4;
constexpr int percent = 100;

} // namespace

SimulationRow::SimulationRow(Simulator &simulator, QWidget *parent)
    : QWidget(parent)
    , m_simulator(simulator)
    , m_text(made<ElidedLabel>("simulationText", this))
    , m_bar(new QProgressBar(this))
    , m_start(made<QPushButton>("simulate", trait::notDefault, this))
    , m_cancel(made<QPushButton>("cancelSimulation", trait::notDefault, this)) {
    m_text->setProperty("secondary", true);
    m_text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(barWidth, progressHeight);
    inRow(this, noMargins, styleSpacing, {{m_text, 1}, m_bar, m_start, m_cancel});
    connect(m_start, &QPushButton::clicked, this, [this] { m_simulator.start(m_evaluated, {m_test}); });
    connect(m_cancel, &QPushButton::clicked, &simulator, &Simulator::cancel);
    connect(&simulator, &Simulator::progressed, this, &SimulationRow::refresh);
    connect(&simulator, &Simulator::finished, this, &SimulationRow::refresh);
}

void SimulationRow::show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language) {
    m_evaluated = evaluated;
    m_test = test;
    m_language = language;
    refresh();
}

void SimulationRow::focusButton() {
    (m_start->isVisibleTo(this) ? m_start : m_cancel)->setFocus(Qt::TabFocusReason);
}

void SimulationRow::refresh() {
    if (m_test >= m_evaluated.tests.size())
        return;
    const TestEvaluation &evaluation = *m_evaluated.tests[m_test];
    const auto trials = [this](long long count) {
        return tr("%1 trial(s)", nullptr, static_cast<int>(count))
            .arg(m_language.number(static_cast<double>(count), Quantity::count, 0));
    };
    const bool running = m_simulator.isRunning() && m_simulator.test() == m_test;
    m_text->setFont(themeFont(TextSize::small));
    m_start->setText(tr("Simulate"));
    m_start->setToolTip(tr("Run the Monte Carlo simulation of this test"));
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel the simulation"));
    m_bar->setAccessibleName(tr("Progress of the simulation"));
    // If the focused button is hidden, the focus moves to the one in its place.
    const bool focused = m_start->hasFocus() || m_cancel->hasFocus();
    m_start->setVisible(!running);
    m_start->setEnabled(evaluation.uncertainty.wantsSimulation() && !evaluation.view);
    m_cancel->setVisible(running);
    m_bar->setVisible(running);
    if (focused)
        (running ? m_cancel : m_start)->setFocus(Qt::OtherFocusReason);
    QStringList parts;
    if (running) {
        const SimulationProgress &progress = m_simulator.progress();
        parts << trials(progress.trials);
        if (const auto left = m_simulator.secondsLeft())
            parts << tr("%1 s left").arg(qCeil(*left));
        m_bar->setRange(0, progress.of ? percent : 0);
        if (progress.of)
            m_bar->setValue(static_cast<int>(percent * progress.trials / *progress.of));
    } else if (const auto &simulation = evaluation.uncertainty.simulation) {
        if (evaluation.uncertainty.outdated) // put first, as the last parts are elided
            parts << tr("outdated: edited since");
        parts << trials(simulation->trials) << tr("seed %1").arg(simulation->seed);
        if (simulation->stable && simulation->mayDecide())
            parts << tr("stable to half a unit of the second digit of u");
        if (!simulation->mayDecide())
            parts << tr("too few to decide");
    } else {
        parts << (evaluation.uncertainty.wantsSimulation() ? tr("not simulated yet")
                                                           : tr("needs a complete budget"));
    }
    m_text->setText(parts.join(QStringLiteral(" · ")));
    m_text->setProperty("secondary", !evaluation.uncertainty.outdated);
}

} // namespace palmer::ui
