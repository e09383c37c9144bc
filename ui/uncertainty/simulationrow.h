// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "ui/model/simulator.h"
#include "ui/qtforward.h"

#include <QWidget>

namespace palmer::ui {

/// The simulation of the test in view on one line: number of trials, time left, progress, and the button to
/// start or cancel it. It blocks nothing else.
class SimulationRow : public QWidget {
    Q_OBJECT

public:
    SimulationRow(Simulator &simulator, QWidget *parent);

    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    /// Focuses the button that starts or cancels the simulation.
    void focusButton();

private:
    void refresh();

    Simulator &m_simulator;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    QLabel *m_text;
    QProgressBar *m_bar;
    QPushButton *m_start;
    QPushButton *m_cancel;
};

} // namespace palmer::ui
