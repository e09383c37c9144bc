#include "ui/model/simulator.h"

#include "ui/model/evaluator.h"

namespace palmer::ui {

namespace {

constexpr qint64 pauseOfProgress = 100; ///< ms

} // namespace

Simulator::Simulator(Evaluator &evaluator, QObject *parent)
    : QObject(parent)
    , m_evaluator(evaluator) {}

Simulator::~Simulator() {
    ++m_run;
    m_thread.request_stop();
}

void Simulator::start(const EvaluatedDocument &evaluated, std::vector<std::size_t> tests) {
    cancel();
    if (tests.empty())
        return;
    const int run = ++m_run;
    m_running = true;
    m_test = tests.front();
    m_progress = {};
    m_since.start();
    m_thread = std::jthread([this, run, evaluated, tests = std::move(tests)](const std::stop_token &stop) {
        for (const std::size_t test : tests) {
            QElapsedTimer told;
            const auto result =
                simulateTest(evaluated, test, simulationOptions(*evaluated.document->tests[test]), stop,
                             [&](const SimulationProgress &progress) {
                                 if (told.isValid() && told.elapsed() < pauseOfProgress)
                                     return;
                                 told.start();
                                 QMetaObject::invokeMethod(
                                     this, [this, run, test, progress] { show(run, test, progress); },
                                     Qt::QueuedConnection);
                             });
            if (stop.stop_requested())
                return;
            if (result)
                QMetaObject::invokeMethod(
                    this, [this, run, test, result] { take(run, test, *result); }, Qt::QueuedConnection);
        }
        QMetaObject::invokeMethod(
            this, [this, run] { end(run); }, Qt::QueuedConnection);
    });
    emit progressed();
}

bool Simulator::startMissing(const EvaluatedDocument &evaluated) {
    std::vector<std::size_t> tests;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (isSimulationDue(evaluated, i, SimulateWhich::allWithBudget))
            tests.push_back(i);
    }
    if (tests.empty())
        return false;
    start(evaluated, std::move(tests));
    return true;
}

void Simulator::cancel() {
    if (!m_running)
        return;
    ++m_run;
    m_running = false;
    m_thread.request_stop();
    m_thread = {}; // waits: at most the time of one circle fit
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

void Simulator::show(int run, std::size_t test, const SimulationProgress &progress) {
    if (run != m_run)
        return;
    if (test != m_test)
        m_since.start();
    m_test = test;
    m_progress = progress;
    emit progressed();
}

void Simulator::take(int run, std::size_t test, const TestSimulation &simulation) {
    if (run == m_run)
        m_evaluator.setSimulation(test, simulation);
}

void Simulator::end(int run) {
    if (run != m_run)
        return;
    m_running = false;
    emit finished(true);
}

} // namespace palmer::ui
