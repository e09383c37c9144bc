// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "ui/model/simulator.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace palmer::ui {

/// The simulation of the test in view, in one line: how many trials, how long it still takes, its progress,
/// and the button that starts or cancels it. Nothing else is held up by it.
class SimulationRow : public QWidget {
    Q_OBJECT

public:
    SimulationRow(Simulator &simulator, QWidget *parent);

    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    /// The focus to the button that starts it, or cancels what is running.
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
