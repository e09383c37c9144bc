// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/evaluateddocument.h"

#include "document/comparedtests.h"
#include "document/impossiblevalues.h"
#include "document/picture.h"
#include "document/testsofverdict.h"
#include "document/thermal.h"
#include "document/windowthread.h"

#include "kernel/evaluation/conformity.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/positioningcase.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>

namespace palmer {

namespace {

/// Identifies the axis or plane of a judged test; null where it is not named, for it may be any.
using PlaceKey = std::tuple<Kind, std::string, std::string, int>;

std::optional<PlaceKey> placeOf(const PositioningMeasurement &measurement) {
    const Axis &axis = measurement.axis;
    if (isBlank(axis.name))
        return std::nullopt;
    return PlaceKey{Kind::positioning, axis.name, {}, static_cast<int>(axis.motion)};
}
std::optional<PlaceKey> placeOf(const CircularMeasurement &measurement) {
    const Plane &plane = measurement.plane;
    return PlaceKey{Kind::circular, plane.first, plane.second, static_cast<int>(measurement.source)};
}
std::optional<PlaceKey> placeOf(const Unjudged auto & /*measurement*/) {
    return std::nullopt;
}

bool isOfZone(const PositioningMeasurement &measurement) {
    return isInsideZone(measurement);
}
bool isOfZone(const auto & /*measurement*/) {
    return false;
}

/// How many tests of a document are of each axis or plane, which each test is asked.
class Siblings {
public:
    explicit Siblings(const Document &document) {
        for (const TestPointer &test : document.tests)
            std::visit(
                [&](const auto &measurement) {
                    const auto place = placeOf(measurement);
                    if (!place)
                        return;
                    const bool inZone = isOfZone(measurement);
                    ++m_zones[{*place, inZone}];
                    ++m_editions[{*place, inZone, test->edition}];
                },
                test->measurement);
    }

    /// True if another test has the same axis or plane and edition; whole travel and zone are no repetition.
    [[nodiscard]] bool isRepeated(const Test &test) const {
        return std::visit(
            [&](const auto &measurement) {
                const auto place = placeOf(measurement);
                return place && m_editions.at({*place, isOfZone(measurement), test.edition}) > 1;
            },
            test.measurement);
    }
    /// For a long axis a file has two tests: the whole travel and the zone.
    [[nodiscard]] bool hasOther(const Test &test) const {
        return std::visit(
            [&](const auto &measurement) {
                const auto place = placeOf(measurement);
                return place && m_zones.contains({*place, !isOfZone(measurement)});
            },
            test.measurement);
    }

private:
    std::map<std::pair<PlaceKey, bool>, int> m_zones;
    std::map<std::tuple<PlaceKey, bool, std::string>, int> m_editions;
};

/// True if there is no picture or a printable one. Caches the latest results, as this is called for every
/// test on every change.
bool isReadable(const std::optional<std::string> &picture) {
    if (!picture || picture->empty())
        return true;
    struct Known {
        std::string picture;
        bool readable = false;
    };
    thread_local std::array<Known, 2> known; // logo and mark
    thread_local std::size_t oldest = 0;
    const auto found = std::ranges::find(known, *picture, &Known::picture);
    if (found != known.end())
        return found->readable;
    Known &one = known.at(oldest);
    oldest = (oldest + 1) % known.size();
    one = {*picture, isPicture(QByteArray::fromBase64(QByteArray::fromStdString(*picture)))};
    return one.readable;
}

Surroundings surroundings(const Document &document, const Siblings &siblings, const Test &test) {
    Surroundings result;
    result.machine = &document.machine;
    result.repeated = siblings.isRepeated(test);
    result.adjustmentsStated = !document.report.adjustments.empty();
    result.picturesReadable =
        isReadable(document.report.laboratory.logo) && isReadable(document.report.laboratory.mark);
    result.reportDate = document.report.date;
    result.performedFrom = document.report.performedFrom;
    result.performedTo = document.report.performedTo;
    const ReportHead &head = document.report;
    if (!head.laboratory.accreditation.empty())
        result.accredited = {!head.laboratory.address.empty(),
                             !head.number.empty(),
                             head.date.has_value(),
                             !head.place.empty(),
                             !head.customer.name.empty() && !head.customer.address.empty(),
                             !head.authorisedBy.name.empty()};
    for (const std::string &id : test.instruments) {
        const auto found = std::ranges::find(document.instruments, id, &Instrument::id);
        if (found != document.instruments.end())
            result.instruments.push_back(&*found);
    }
    result.otherTestOfLongAxis = siblings.hasOther(test);
    if (const std::string *drift = driftTestOf(test)) {
        if (const auto variation = driftVariation(document, *drift, test)) {
            result.environmentalVariation = variation->value;
            result.variationIsLowerBound = variation->isLowerBound;
        }
    }
    return result;
}

bool sameContent(const Surroundings &a, const Surroundings &b) {
    return *a.machine == *b.machine && a.otherTestOfLongAxis == b.otherTestOfLongAxis &&
           a.repeated == b.repeated && a.adjustmentsStated == b.adjustmentsStated &&
           a.picturesReadable == b.picturesReadable && a.reportDate == b.reportDate &&
           a.performedFrom == b.performedFrom && a.performedTo == b.performedTo &&
           a.accredited == b.accredited && a.environmentalVariation == b.environmentalVariation &&
           a.variationIsLowerBound == b.variationIsLowerBound && a.simulation == b.simulation &&
           a.simulationOutdated == b.simulationOutdated &&
           std::ranges::equal(a.instruments, b.instruments,
                              [](const Instrument *x, const Instrument *y) { return *x == *y; });
}

/// True if all inputs of a simulation are equal; the method and directly entered uncertainties are not
/// inputs.
bool sameForSimulation(const Test &a, const Test &b) {
    return areOfOneKind(a, b, [](auto x, const auto &y) {
        if constexpr (requires { x.uncertainty; }) {
            x.uncertainty.method = y.uncertainty.method;
            x.uncertainty.expanded = y.uncertainty.expanded;
        }
        return x == y;
    });
}

/// Returns the surroundings with a simulation of the test.
Surroundings surroundings(const Document &document, const Siblings &siblings, const TestPointer &test,
                          const TestSimulation &simulation) {
    Surroundings result = surroundings(document, siblings, *test);
    result.simulation = simulation.simulation;
    result.simulationOutdated = simulation.simulation && simulation.of != test &&
                                (!simulation.of || !sameForSimulation(*simulation.of, *test));
    result.simulationOutdated |=
        simulation.simulation && simulation.environmentalVariation != result.environmentalVariation;
    return result;
}

/// Returns the index in `previous` of this test, possibly edited since; null for a new one.
std::optional<std::size_t> placeIn(const EvaluatedDocument &previous, const Document &document,
                                   std::size_t index) {
    const auto &tests = previous.document->tests;
    const TestPointer &test = document.tests[index];
    auto found = std::ranges::find(tests, test);
    if (found == tests.end() && !test->id.empty())
        found = std::ranges::find(tests, test->id, [](const TestPointer &t) { return t->id; });
    else if (found == tests.end() && tests.size() == document.tests.size())
        found = tests.begin() + static_cast<std::ptrdiff_t>(index);
    return found == tests.end() ? std::nullopt : std::optional<std::size_t>(found - tests.begin());
}

/// Returns results without values; their lists are as long as those of the test.
PositioningResults unknownResults(const PositioningMeasurement &measurement) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const DirectionStatistics none{0, unknown, unknown, unknown};
    PositioningResults results;
    results.targets.assign(measurement.targets.size(), {none, none});
    for (const Run &run : measurement.runs)
        ++(run.approach == Direction::positive ? results.positiveRuns : results.negativeRuns);
    results.upward = results.positiveRuns > 0;
    results.downward = results.negativeRuns > 0;
    return results;
}

auto unknownResults(const auto &measurement) {
    return std::remove_cvref_t<decltype(resultsOf(measurement, TestEvaluation()))>();
}

TestEvaluation withoutResults(const Test &test, const Edition *edition) {
    TestEvaluation result;
    result.edition = edition;
    result.view = edition && test.edition != edition->word;
    std::visit([&](const auto &measurement) { result.results = unknownResults(measurement); },
               test.measurement);
    return result;
}

TestSimulation simulationOf(const EvaluatedDocument &evaluated, std::size_t test) {
    return test < evaluated.simulations.size() ? evaluated.simulations[test] : TestSimulation{};
}

/// Returns the edition requested for a test instead of its own, or null.
const Edition *askedOf(std::span<const std::string> editions, std::size_t test) {
    return test < editions.size() && !editions[test].empty() ? findEdition(editions[test]) : nullptr;
}

/// Evaluates a test and adds what its file states and cannot be.
TestEvaluationPointer evaluatedTest(const Test &test, const Surroundings &around, const Edition *edition) {
    TestEvaluation evaluation = evaluateTest(test, around, edition);
    std::ranges::move(findImpossible(test), std::back_inserter(evaluation.findings));
    return std::make_shared<const TestEvaluation>(std::move(evaluation));
}

/// Returns the evaluation of this test in `previous` if nothing it depends on has changed, otherwise null.
TestEvaluationPointer unchanged(const EvaluatedDocument &previous, const Siblings &siblings,
                                const TestPointer &test, const Surroundings &now, const Edition *edition) {
    const auto &tests = previous.document->tests;
    const auto found = std::ranges::find(tests, test);
    if (found == tests.end())
        return nullptr;
    const auto index = static_cast<std::size_t>(found - tests.begin());
    if (previous.isPending(index))
        return nullptr;
    const auto &evaluation = previous.tests[index];
    const bool same =
        evaluation->edition == edition &&
        sameContent(surroundings(*previous.document, siblings, test, simulationOf(previous, index)), now);
    return same ? evaluation : nullptr;
}

} // namespace

Surroundings surroundingsOf(const Document &document, std::size_t test) {
    return surroundings(document, Siblings(document), *document.tests[test]);
}

std::optional<TakenVariation> takenVariation(const Document &document, const std::string &id,
                                             const Test &test) {
    const auto quantity =
        motionOf(test) == Motion::linear ? ChannelQuantity::deviation : ChannelQuantity::angularDeviation;
    const std::string axes = axesOf(test);
    constexpr double minute = 60;
    const auto duration = test.duration ? std::optional(*test.duration * minute) : std::nullopt;
    std::optional<TakenVariation> largest;
    for (const TestPointer &other : document.tests) {
        const auto *drift = std::get_if<DriftMeasurement>(&other->measurement);
        if (!drift || other->id != id)
            continue;
        for (const DriftChannel &channel : channelsOf(*drift)) {
            const bool named =
                drift->channels.empty() || channel.name == axes ||
                (drift->channels.size() == 1 && drift->axis.name.empty()) ||
                (!axisOf(test) && !channel.name.empty() && axes.find(channel.name) != std::string::npos);
            const auto found = named && channel.quantity == quantity
                                   ? variationOf(drift->times, channel.values, duration)
                                   : std::nullopt;
            if (found && (!largest || found->value > largest->variation.value))
                largest = {channel, *found};
        }
    }
    return largest;
}

std::optional<Variation> driftVariation(const Document &document, const std::string &id, const Test &test) {
    const auto taken = takenVariation(document, id, test);
    return taken ? std::optional(taken->variation) : std::nullopt;
}

std::optional<Verdict> EvaluatedDocument::verdict() const {
    std::optional<Verdict> result = verdictOf(sheet());
    for (std::size_t i = 0; i < tests.size(); ++i) {
        if (countsForVerdict(*document, i))
            result = worst(result, tests[i]->verdict);
    }
    return result;
}

std::vector<SheetResult> EvaluatedDocument::sheet() const {
    std::vector<NamedTest> named;
    for (std::size_t i = 0; i < tests.size(); ++i)
        named.push_back({document->tests[i]->id, tests[i].get()});
    return evaluateSheet(document->report.sheet, document->report.decisionRule, named);
}

bool EvaluatedDocument::isPending(std::size_t test) const {
    return std::ranges::find(pending, test) != pending.end();
}

EvaluatedDocument evaluate(std::shared_ptr<const Document> document, const EvaluatedDocument *previous,
                           std::string_view edition) {
    std::vector<std::string> editions(document->tests.size(), std::string(edition));
    const Edition *asked = findEdition(edition);
    for (std::size_t i = 0; asked && i < editions.size(); ++i) {
        const Edition *own = findEdition(document->tests[i]->edition);
        if (own && std::string_view(own->family) == asked->family) // the same under another name
            editions[i].clear();
    }
    return evaluateUnder(std::move(document), editions, previous);
}

EvaluatedDocument awaitingResults(std::shared_ptr<const Document> document,
                                  std::span<const std::string> editions, const EvaluatedDocument &previous) {
    EvaluatedDocument result;
    const Siblings siblings(*document);
    const Siblings before(previous.document ? *previous.document : *document);
    for (std::size_t i = 0; i < document->tests.size(); ++i) {
        const TestPointer &test = document->tests[i];
        const Edition *other = askedOf(editions, i);
        const auto place = previous.document ? placeIn(previous, *document, i) : std::optional<std::size_t>();
        TestSimulation simulation = place ? simulationOf(previous, *place) : TestSimulation{};
        const Edition *used = editionFor(*test, other);
        TestEvaluationPointer evaluation;
        if (place)
            evaluation =
                unchanged(previous, before, test, surroundings(*document, siblings, test, simulation), used);
        if (!evaluation) {
            TestEvaluation awaiting = withoutResults(*test, used);
            if (place) {
                awaiting.findings = previous.tests[*place]->findings;
                awaiting.verdict = previous.tests[*place]->verdict;
                if (previous.tests[*place]->edition == used) {
                    awaiting.parameters = previous.tests[*place]->parameters;
                    awaiting.uncertainty = previous.tests[*place]->uncertainty;
                }
            }
            evaluation = std::make_shared<const TestEvaluation>(std::move(awaiting));
            result.pending.push_back(i);
        }
        result.tests.push_back(std::move(evaluation));
        result.simulations.push_back(std::move(simulation));
    }
    result.document = std::move(document);
    return result;
}

EvaluatedDocument evaluatePending(EvaluatedDocument awaiting, std::span<const std::string> editions) {
    const Document &document = *awaiting.document;
    const Siblings siblings(document);
    for (const std::size_t i : std::exchange(awaiting.pending, {})) {
        const TestPointer &test = document.tests[i];
        requireBackground(readingsOf(*test));
        awaiting.tests[i] = evaluatedTest(
            *test, surroundings(document, siblings, test, awaiting.simulations[i]), askedOf(editions, i));
    }
    return awaiting;
}

EvaluatedDocument evaluateUnder(std::shared_ptr<const Document> document,
                                std::span<const std::string> editions, const EvaluatedDocument *previous) {
    static const EvaluatedDocument none;
    return evaluatePending(awaitingResults(std::move(document), editions, previous ? *previous : none),
                           editions);
}

std::optional<TestSimulation> simulateTest(const EvaluatedDocument &evaluated, std::size_t test,
                                           const SimulationOptions &options, const std::stop_token &stop,
                                           const std::function<void(const SimulationProgress &)> &progress) {
    const Edition *edition = evaluated.tests[test]->edition;
    if (!edition)
        return std::nullopt;
    const TestPointer &source = evaluated.document->tests[test];
    const Surroundings around = surroundings(*evaluated.document, Siblings(*evaluated.document), *source);
    auto simulation = simulate(*source, around, *edition, options, stop, progress);
    if (!simulation)
        return std::nullopt;
    return TestSimulation{std::make_shared<const Simulation>(std::move(*simulation)), source,
                          around.environmentalVariation};
}

EvaluatedDocument withSimulation(const EvaluatedDocument &evaluated, std::size_t test,
                                 TestSimulation simulation) {
    EvaluatedDocument result = evaluated;
    const TestPointer &source = evaluated.document->tests[test];
    result.simulations.resize(result.tests.size());
    result.simulations[test] = std::move(simulation);
    const Surroundings around =
        surroundings(*evaluated.document, Siblings(*evaluated.document), source, result.simulations[test]);
    result.tests[test] = evaluatedTest(*source, around, evaluated.tests[test]->edition);
    return result;
}

bool isTooLargeUnasked(const Test &test) {
    return static_cast<double>(readingsOf(test)) * static_cast<double>(fewestDecidingTrials) >=
           mostDrawsUnasked;
}

bool isSimulationDue(const EvaluatedDocument &evaluated, std::size_t test, SimulateWhich which) {
    const UncertaintyEvaluation &uncertainty = evaluated.tests[test]->uncertainty;
    if (!uncertainty.wantsSimulation() || (uncertainty.simulation && !uncertainty.outdated))
        return false;
    const auto &leftOut = evaluated.document->report.leaveOut;
    const bool isPrinted = std::ranges::none_of(leftOut, [](ReportPart part) {
        return part == ReportPart::uncertainty || part == ReportPart::annex; // the budget stands in the annex
    });
    return uncertainty.method == UncertaintyMethod::monteCarlo ||
           (which == SimulateWhich::forReport && isPrinted &&
            !isTooLargeUnasked(*evaluated.document->tests[test]));
}

std::optional<EvaluatedDocument>
withSimulations(EvaluatedDocument evaluated, SimulateWhich which, int threads, const std::stop_token &stop,
                const std::function<void(std::size_t, const SimulationProgress &)> &progress) {
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (!isSimulationDue(evaluated, i, which))
            continue;
        SimulationOptions options = simulationOptions(*evaluated.document->tests[i]);
        options.threads = threads;
        auto simulation = simulateTest(evaluated, i, options, stop, [&](const SimulationProgress &done) {
            if (progress)
                progress(i, done);
        });
        if (stop.stop_requested())
            return std::nullopt;
        if (simulation)
            evaluated = withSimulation(evaluated, i, std::move(*simulation));
    }
    return evaluated;
}

std::optional<Accordance> worstAccordance(const EvaluatedDocument &evaluated) {
    const auto isOf = [&](Accordance wanted) {
        for (std::size_t test = 0; test < evaluated.tests.size(); ++test) {
            const TestEvaluation &evaluation = *evaluated.tests[test];
            if (evaluation.edition && countsForVerdict(*evaluated.document, test) &&
                evaluation.accordance() == wanted)
                return true;
        }
        return false;
    };
    for (const Accordance accordance : {Accordance::no, Accordance::notShown, Accordance::notChecked,
                                        Accordance::partly, Accordance::yes}) {
        if (isOf(accordance))
            return accordance;
    }
    return std::nullopt;
}

} // namespace palmer
