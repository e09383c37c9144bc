// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnosis/diagnoser.h"

#include "kernel/diagnosis/traces.h"

namespace palmer::ui {

namespace {

ShownDiagnosis diagnosed(const EvaluatedDocument &evaluated, std::size_t test, const Language &language,
                         const std::stop_token &stop) {
    ShownDiagnosis shown;
    shown.of = evaluated.tests[test];
    shown.test = diagnosedTest(evaluated, test);
    if (!shown.test || stop.stop_requested())
        return shown;
    shown.prevailing = prevailingSources(*shown.test);
    shown.residual = residualFigure(*shown.test, language, 0);
    shown.spectrum = spectrumFigure(*shown.test, language, 0);
    for (const std::size_t other : testsAtFeedsWith(evaluated, test)) {
        if (stop.stop_requested())
            return shown;
        if (auto one = other == test ? shown.test : diagnosedTest(evaluated, other))
            shown.atFeeds.push_back(std::move(*one));
    }
    std::vector<DiagnosedCircle> circles;
    for (const DiagnosedTest &one : shown.atFeeds)
        circles.push_back(one.circle);
    if (areSeveralFeeds(circles))
        shown.together = diagnose(circles);
    if (shown.together.valid())
        shown.paths = profilesAtFeeds(shown.atFeeds);
    else
        shown.atFeeds.clear();
    return shown;
}

} // namespace

void Diagnoser::want(const EvaluatedDocument &evaluated, std::size_t test, const Language &language) {
    // Any test may be one of those at other feeds.
    std::vector<TestEvaluationPointer> of = evaluated.tests;
    of.insert(of.begin(), evaluated.tests[test]);
    if (of == m_of && language.code() == m_language)
        return;
    m_of = std::move(of);
    m_language = language.code();
    m_shown.reset();
    m_lane.cancel();
    m_traces.cancel();
    m_lane.start([evaluated, test, language](
                     const Background::Job &job) { return diagnosed(evaluated, test, language, job.stop()); },
                 [this](ShownDiagnosis shown) {
                     m_shown = std::make_shared<const ShownDiagnosis>(std::move(shown));
                     emit changed();
                 });
}

void Diagnoser::trace(const std::vector<std::size_t> &chosen) {
    m_traces.cancel();
    if (!m_shown || !m_shown->test || chosen.empty()) {
        emit traced({});
        return;
    }
    m_traces.start(
        [shown = m_shown, chosen](const Background::Job &) {
            return SyntheticPaths{shown->of, std::make_shared<const std::vector<Points>>(syntheticPath(
                                                 shown->test->circle, shown->test->diagnosis, chosen))};
        },
        [this](const SyntheticPaths &paths) { emit traced(paths); });
}

} // namespace palmer::ui
