// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/simulator.h"

#include "ui/model/evaluator.h"

namespace palmer::ui {

namespace {

constexpr qint64 pauseOfProgress = 100; ///< ms

} // namespace

Simulator::Simulator(Evaluator &evaluator, QObject *parent)
    : QObject(parent)
    , m_evaluator(evaluator) {}

void Simulator::start(const EvaluatedDocument &evaluated, std::vector<std::size_t> tests) {
    cancel();
    if (tests.empty())
        return;
    m_test = tests.front();
    m_progress = {};
    m_since.start();
    m_lane.start(
        [this, evaluated, tests = std::move(tests)](const Background::Job &job) {
            for (const std::size_t test : tests) {
                QElapsedTimer told;
                const auto result =
                    simulateTest(evaluated, test, simulationOptions(*evaluated.document->tests[test]),
                                 job.stop(), [&](const SimulationProgress &progress) {
                                     if (told.isValid() && told.elapsed() < pauseOfProgress)
                                         return;
                                     told.start();
                                     job.post([this, test, progress] { show(test, progress); });
                                 });
                if (job.stop().stop_requested())
                    return;
                if (result)
                    job.post([this, test, result] { m_evaluator.setSimulation(test, *result); });
            }
        },
        [this] { emit finished(true); });
    emit progressed();
}

bool Simulator::startMissing(const EvaluatedDocument &evaluated) {
    std::vector<std::size_t> tests;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (isSimulationDue(evaluated, i, SimulateWhich::forReport))
            tests.push_back(i);
    }
    if (tests.empty())
        return false;
    start(evaluated, std::move(tests));
    return true;
}

void Simulator::cancel() {
    if (!isRunning())
        return;
    m_lane.cancel();
    emit finished(false);
}

std::optional<double> Simulator::secondsLeft() const {
    if (!m_progress.of || m_progress.trials <= 0)
        return std::nullopt;
    const auto done = static_cast<double>(m_progress.trials);
    constexpr double perSecond = 1000; // ms
    return static_cast<double>(m_since.elapsed()) / perSecond * (static_cast<double>(*m_progress.of) - done) /
           done;
}

void Simulator::show(std::size_t test, const SimulationProgress &progress) {
    if (test != m_test)
        m_since.start();
    m_test = test;
    m_progress = progress;
    emit progressed();
}

} // namespace palmer::ui
