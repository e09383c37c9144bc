// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/evaluator.h"

#include "document/windowthread.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>

namespace palmer::ui {

namespace {

std::size_t countPending(const EvaluatedDocument &awaiting) {
    std::size_t count = 0;
    for (const std::size_t test : awaiting.pending)
        count += readingsOf(*awaiting.document->tests[test]);
    return count;
}

} // namespace

Evaluator::Evaluator(QObject *parent)
    : QObject(parent) {}

void Evaluator::setDocument(std::shared_ptr<const Document> document) {
    m_document = std::move(document);
    std::erase_if(m_views, [this](const auto &view) {
        return std::ranges::none_of(m_document->tests,
                                    [&](const TestPointer &test) { return test->id == view.first; });
    });
    evaluate();
}

void Evaluator::setView(std::size_t test, const std::string &edition) {
    if (!m_document || test >= m_document->tests.size())
        return;
    const Test &viewed = *m_document->tests[test];
    if (edition.empty() || edition == viewed.edition)
        m_views.erase(viewed.id);
    else
        m_views[viewed.id] = edition;
    evaluate();
}

void Evaluator::setSimulation(std::size_t test, const TestSimulation &simulation) {
    if (!m_current.document || !simulation.of)
        return;
    m_simulations.push_back({test, simulation});
    putSimulations();
}

/// As with edits, long computations run on the worker. If an edit supersedes one, it is repeated afterwards.
void Evaluator::putSimulations() {
    while (!m_simulations.empty() && !isBusy()) {
        const auto &[test, simulation] = m_simulations.front();
        const auto &tests = m_current.document->tests;
        auto found = std::ranges::find(tests, simulation.of);
        if (found == tests.end() && test < tests.size() && tests[test]->id == simulation.of->id)
            found = tests.begin() + static_cast<std::ptrdiff_t>(test);
        if (found == tests.end()) {
            m_simulations.pop_front();
            continue;
        }
        const auto place = static_cast<std::size_t>(found - tests.begin());
        if (readingsOf(**found) <= fewReadings) {
            m_current = withSimulation(m_current, place, simulation);
            m_simulations.pop_front();
            emit evaluated(m_current);
            continue;
        }
        m_awaiting = m_current;
        m_awaiting.pending = {place};
        m_worker.start([place, current = m_current, ended = simulation](
                           const Background::Job &) { return withSimulation(current, place, ended); },
                       [this](EvaluatedDocument evaluated) {
                           m_simulations.pop_front();
                           receive(std::move(evaluated));
                       });
        emit busyChanged(true);
        emit awaiting(m_awaiting);
    }
}

std::vector<std::string> Evaluator::editions() const {
    std::vector<std::string> result;
    for (const TestPointer &test : m_document->tests) {
        const auto found = m_views.find(test->id);
        result.push_back(found == m_views.end() ? std::string() : found->second);
    }
    return result;
}

void Evaluator::evaluate() {
    m_worker.cancel();
    auto asked = editions();
    EvaluatedDocument awaiting = awaitingResults(m_document, asked, m_current);
    if (countPending(awaiting) <= fewReadings) {
        receive(evaluatePending(std::move(awaiting), asked));
        return;
    }
    m_awaiting = awaiting;
    m_worker.start([awaiting = std::move(awaiting), asked = std::move(asked)](
                       const Background::Job &) { return evaluatePending(awaiting, asked); },
                   [this](EvaluatedDocument evaluated) { receive(std::move(evaluated)); });
    emit busyChanged(true);
    emit this->awaiting(m_awaiting);
}

void Evaluator::receive(EvaluatedDocument evaluated) {
    m_current = std::move(evaluated);
    m_awaiting = {};
    emit busyChanged(false);
    emit this->evaluated(m_current);
    putSimulations(); // simulations that ended meanwhile
}

} // namespace palmer::ui
