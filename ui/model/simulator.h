// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/background.h"

#include <QElapsedTimer>
#include <QObject>
#include <optional>
#include <vector>

namespace palmer::ui {

class Evaluator;

/// Runs Monte Carlo simulations on a thread of its own and hands their results to the evaluator, test by
/// test. One run at a time; starting another stops the one before.
class Simulator : public QObject {
    Q_OBJECT

public:
    explicit Simulator(Evaluator &evaluator, QObject *parent = nullptr);

    /// Simulates these tests of `evaluated`, under the editions they are evaluated under, in order.
    void start(const EvaluatedDocument &evaluated, std::vector<std::size_t> tests);
    /// Simulates the tests for whose report it is due. False: there are none.
    bool startMissing(const EvaluatedDocument &evaluated);
    /// Stops within the time of one circle fit; what was finished stays.
    void cancel();

    [[nodiscard]] bool isRunning() const { return m_lane.isBusy(); }
    /// The test that is being simulated.
    [[nodiscard]] std::size_t test() const { return m_test; }
    [[nodiscard]] const SimulationProgress &progress() const { return m_progress; }
    /// Seconds left by the pace so far; null where the number of trials is open or nothing was done yet.
    [[nodiscard]] std::optional<double> secondsLeft() const;

signals:
    void progressed();
    /// `complete`: not cancelled.
    void finished(bool complete);

private:
    void show(std::size_t test, const SimulationProgress &progress);

    Evaluator &m_evaluator;
    std::size_t m_test = 0;
    SimulationProgress m_progress;
    QElapsedTimer m_since;
    Background m_lane;
};

} // namespace palmer::ui
