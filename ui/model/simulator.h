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

/// Runs Monte Carlo simulations in the background and hands the results to the evaluator test by test.
/// Starting a run stops the one before.
class Simulator : public QObject {
    Q_OBJECT

public:
    explicit Simulator(Evaluator &evaluator, QObject *parent = nullptr);

    /// Simulates these tests of `evaluated` in order, each under the edition it is evaluated under.
    void start(const EvaluatedDocument &evaluated, std::vector<std::size_t> tests);
    /// Simulates the tests whose report requires it. False if there are none.
    bool startMissing(const EvaluatedDocument &evaluated);
    /// Stops within the time of one circle fit; finished tests are kept.
    void cancel();

    [[nodiscard]] bool isRunning() const { return m_lane.isBusy(); }
    /// The test being simulated.
    [[nodiscard]] std::size_t test() const { return m_test; }
    [[nodiscard]] const SimulationProgress &progress() const { return m_progress; }
    /// Seconds left at the pace so far; null if the number of trials is open or none is done yet.
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
