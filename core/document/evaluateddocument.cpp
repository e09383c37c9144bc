#include "document/evaluateddocument.h"

#include "kernel/evaluation/conformity.h"
#include "kernel/evaluation/evaluatetest.h"

#include <algorithm>

namespace palmer {

namespace {

std::optional<double> driftRange(const Document &document, const std::string &id) {
    for (const TestPointer &test : document.tests) {
        const auto *drift = std::get_if<DriftMeasurement>(&test->measurement);
        if (!drift || test->id != id || drift->deviations.empty())
            continue;
        const auto [low, high] = std::ranges::minmax(drift->deviations);
        return high - low;
    }
    return std::nullopt;
}

bool insideZone(const PositioningMeasurement &m) {
    return m.zone && !m.targets.empty() && m.targets.front() >= m.zone->from &&
           m.targets.back() <= m.zone->to;
}

/// Of a long axis a file holds two tests: the whole travel and the zone.
bool hasOtherTest(const Document &document, const Test &test, const PositioningMeasurement &measurement) {
    return std::ranges::any_of(document.tests, [&](const TestPointer &other) {
        const auto *m = std::get_if<PositioningMeasurement>(&other->measurement);
        return m && other.get() != &test && m->axis.name == measurement.axis.name &&
               m->axis.motion == measurement.axis.motion && insideZone(*m) != insideZone(measurement);
    });
}

Surroundings surroundings(const Document &document, const Test &test) {
    Surroundings result;
    result.machine = &document.machine;
    for (const std::string &id : test.instruments) {
        const auto found = std::ranges::find(document.instruments, id, &Instrument::id);
        if (found != document.instruments.end())
            result.instruments.push_back(&*found);
    }
    std::optional<std::string> drift;
    if (const auto *m = std::get_if<PositioningMeasurement>(&test.measurement)) {
        result.otherTestOfLongAxis = hasOtherTest(document, test, *m);
        drift = m->uncertainty.driftTest;
    } else if (const auto *c = std::get_if<CircularMeasurement>(&test.measurement)) {
        drift = c->uncertainty.driftTest;
    }
    if (drift)
        result.environmentalVariation = driftRange(document, *drift);
    return result;
}

bool sameContent(const Surroundings &a, const Surroundings &b) {
    return *a.machine == *b.machine && a.otherTestOfLongAxis == b.otherTestOfLongAxis &&
           a.environmentalVariation == b.environmentalVariation &&
           std::ranges::equal(a.instruments, b.instruments,
                              [](const Instrument *x, const Instrument *y) { return *x == *y; });
}

/// The evaluation `previous` has of this very test, if nothing it depends on has changed.
TestEvaluationPointer unchanged(const EvaluatedDocument &previous, const TestPointer &test,
                                const Surroundings &now, const Edition *edition) {
    const auto &tests = previous.document->tests;
    const auto found = std::ranges::find(tests, test);
    if (found == tests.end())
        return nullptr;
    const auto &evaluation = previous.tests[static_cast<std::size_t>(found - tests.begin())];
    const bool same =
        evaluation->edition == edition && sameContent(surroundings(*previous.document, *test), now);
    return same ? evaluation : nullptr;
}

} // namespace

std::optional<Verdict> EvaluatedDocument::verdict() const {
    std::optional<Verdict> result;
    for (const TestEvaluationPointer &test : tests)
        result = worst(result, test->verdict);
    return result;
}

EvaluatedDocument evaluate(std::shared_ptr<const Document> document, const EvaluatedDocument *previous,
                           std::string_view edition) {
    const std::vector<std::string> editions(document->tests.size(), std::string(edition));
    return evaluateUnder(std::move(document), editions, previous);
}

EvaluatedDocument evaluateUnder(std::shared_ptr<const Document> document,
                                std::span<const std::string> editions, const EvaluatedDocument *previous) {
    EvaluatedDocument result;
    for (std::size_t i = 0; i < document->tests.size(); ++i) {
        const TestPointer &test = document->tests[i];
        const Edition *other =
            i < editions.size() && !editions[i].empty() ? findEdition(editions[i]) : nullptr;
        const Surroundings around = surroundings(*document, *test);
        const Edition *used = editionFor(*test, other);
        TestEvaluationPointer evaluation =
            previous && previous->document ? unchanged(*previous, test, around, used) : nullptr;
        if (!evaluation)
            evaluation = std::make_shared<const TestEvaluation>(evaluateTest(*test, around, other));
        result.tests.push_back(std::move(evaluation));
    }
    result.document = std::move(document);
    return result;
}

} // namespace palmer
