// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/validation.h"

#include "document/comparedtests.h"
#include "document/diagnosedtest.h"
#include "document/evaluateddocument.h"
#include "document/filewords.h"
#include "document/resultwords.h"
#include "document/thermal.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/minimumzone.h"

#include <QFile>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace palmer {

namespace {

/// Result of an evaluation for an expectation: a number or a word.
struct Found {
    std::optional<double> number = {};
    std::string word = {};
};

/// The evaluation of the test that is meant.
struct Evaluated {
    const ReferenceSet &set;
    const EvaluatedDocument &document;
    const Expectation &expected;
    const TestEvaluation *test; ///< null: none under that edition
};

/// A number of a parameter, by the word of `of`.
struct OfParameter {
    std::string_view word;
    std::optional<double> Parameter::*number = nullptr;
    double SimulatedParameter::*simulated = nullptr;
};

constexpr std::array ofParameter{OfParameter{"", &Parameter::value},
                                 OfParameter{"budget", &Parameter::budgetUncertainty},
                                 OfParameter{"budgetActual", &Parameter::actualUncertainty},
                                 OfParameter{"expandedUncertainty", &Parameter::expandedUncertainty},
                                 OfParameter{"mean", nullptr, &SimulatedParameter::mean},
                                 OfParameter{"u", nullptr, &SimulatedParameter::u},
                                 OfParameter{"low", nullptr, &SimulatedParameter::low},
                                 OfParameter{"high", nullptr, &SimulatedParameter::high}};

Found parameterOf(const Evaluated &e) {
    const auto parameter = std::ranges::find(e.test->parameters, e.expected.id, parameterId);
    const auto *of = std::ranges::find(ofParameter, std::string_view(e.expected.of), &OfParameter::word);
    if (parameter == e.test->parameters.end())
        return {};
    if (of == ofParameter.end())
        return {{}, parameter->verdict ? fileWord(*parameter->verdict) : ""};
    if (of->number)
        return {(*parameter).*(of->number)};
    return parameter->simulated ? Found{(*parameter->simulated).*(of->simulated)} : Found{};
}

Found statisticOf(const Evaluated &e) {
    const auto *results = std::get_if<PositioningResults>(&e.test->results);
    const auto index = static_cast<std::size_t>(e.expected.target) - 1;
    if (!results || index >= results->targets.size())
        return {};
    return {targetValue(e.expected.id, results->targets[index], e.test->edition->c)};
}

Found contributionOf(const Evaluated &e) {
    const auto &all = e.test->uncertainty.contributions;
    const auto found = std::ranges::find(all, e.expected.id, &Contribution::id);
    return found == all.end() ? Found{} : Found{found->expanded};
}

Found driftFound(const Evaluated &e) {
    if (const auto *drift = std::get_if<DriftResults>(&e.test->results))
        return {drift->range};
    const auto *results = std::get_if<PositioningResults>(&e.test->results);
    if (!results || !results->drift)
        return {};
    return {e.expected.id == "t" ? results->drift->t : results->drift->change};
}

Found correctionOf(const Evaluated &e) {
    const auto *results = std::get_if<CircularResults>(&e.test->results);
    return results ? Found{results->correction} : Found{};
}

Found influenceOf(const Evaluated &e) {
    const auto diagnosed = diagnosedTest(e.document, e.expected.test);
    const Influence *kind = findInfluence(e.expected.id.c_str());
    if (!diagnosed || !kind)
        return {};
    const PlaneAxis axis = e.expected.axis.empty()                         ? PlaneAxis::none
                           : e.expected.axis == diagnosed->diagnosis.first ? PlaneAxis::first
                                                                           : PlaneAxis::second;
    const SourceEstimate *source = diagnosed->diagnosis.find(kind->id, axis);
    return source && source->value ? Found{shownParameter(kind->id, *source->value)} : Found{};
}

/// The pair of a test is the one before it in the set; simulated once for all its rows.
const TestComparison &comparisonWithTheTestBefore(const EvaluatedDocument &evaluated, std::size_t test) {
    thread_local TestEvaluationPointer of;
    thread_local TestComparison kept;
    if (of != evaluated.tests[test]) {
        kept = compare({&evaluated, test - 1}, {&evaluated, test});
        of = evaluated.tests[test];
    }
    return kept;
}

Found comparisonFound(const Evaluated &e) {
    if (e.expected.test == 0)
        return {};
    const TestComparison &comparison = comparisonWithTheTestBefore(e.document, e.expected.test);
    const auto parameter =
        std::ranges::find(comparison.parameters, e.expected.id,
                          [](const ComparedParameter &p) { return std::string(p.term.id); });
    if (parameter == comparison.parameters.end())
        return {};
    if (e.expected.of == "word")
        return {{}, parameter->word ? fileWord(*parameter->word) : ""};
    return e.expected.of == "U" ? Found{parameter->uncertainty} : Found{parameter->difference};
}

Found compensationOf(const Evaluated &e) {
    const CompensationTable table = compensationTable(*e.document.document->tests[e.expected.test], *e.test,
                                                      e.expected.format, e.expected.table);
    const auto &values = e.expected.id == fileWord(Direction::negative) ? table.reverse : table.forward;
    const auto index = static_cast<std::size_t>(e.expected.target) - 1;
    return index < values.size() ? Found{values[index]} : Found{};
}

Found named(const std::string &id, const std::map<std::string, double> &numbers) {
    const auto number = numbers.find(id);
    return number == numbers.end() ? Found{} : Found{number->second};
}

Found ofLine(const TrendLine &line, const std::string &id) {
    if (id == "statement")
        return {{}, line.isShown() ? "shown" : "notShown"};
    if (id == "chi2PerDof")
        return {line.chi2PerDof};
    return named(id, {{"level", line.level},
                      {"slope", line.slope},
                      {"uLevel", std::sqrt(line.levelVariance)},
                      {"uSlope", line.slopeUncertainty()},
                      {"covariance", line.covariance},
                      {"scatter", line.scatter}});
}

Found trendOf(const Evaluated &e) {
    if (e.expected.test >= e.set.trends.size())
        return {};
    const ReferenceTrend &trend = e.set.trends[e.expected.test];
    const auto line = trendLine(trend.points);
    if (!line || e.expected.id != "notBefore")
        return line ? ofLine(*line, e.expected.id) : Found{};
    const NotBefore found = notBefore(*line, trend.limits, trend.reserve);
    return found.state == NotBefore::State::beyond ? Found{{}, "beyond"} : Found{found.time};
}

Found feedOf(const Evaluated &e) {
    return {iso230_4::contouringFeed(e.expected.feed)};
}

Found circleOf(const Evaluated &e) {
    if (e.expected.test >= e.set.points.size())
        return {};
    const PointsView points = e.set.points[e.expected.test].view();
    if (e.expected.id.starts_with("lsc")) {
        const LeastSquaresCircle fit = leastSquaresCircle(points);
        return !fit.valid() ? Found{}
                            : named(e.expected.id, {{"lsc_cx", fit.centre.x},
                                                    {"lsc_cy", fit.centre.y},
                                                    {"lsc_R", fit.radius},
                                                    {"lsc_width", fit.range()}});
    }
    const MinimumZone zone = minimumZone(points);
    return !(zone.valid() && zone.certified) ? Found{}
                                             : named(e.expected.id, {{"mzc_cx", zone.centre.x},
                                                                     {"mzc_cy", zone.centre.y},
                                                                     {"mzc_Ro", zone.outerRadius},
                                                                     {"mzc_Ri", zone.innerRadius},
                                                                     {"mzc_width", zone.width}});
}

Found sheetFound(const Evaluated &e) {
    const std::vector<SheetRow> &rows = e.document.document->report.sheet;
    const auto row = std::ranges::find(rows, e.expected.id, &SheetRow::number);
    if (row == rows.end())
        return {};
    return {{}, fileWord(e.document.sheet()[static_cast<std::size_t>(row - rows.begin())].state)};
}

Found responseFound(const Evaluated &e) {
    const auto *drift =
        e.test ? std::get_if<DriftMeasurement>(&e.document.document->tests[e.expected.test]->measurement)
               : nullptr;
    const std::vector<ThermalChannel> channels =
        drift ? thermalChannels(*drift) : std::vector<ThermalChannel>();
    if (channels.empty() || !channels.front().best)
        return {};
    const ThermalResponse &response = channels.front().responses[*channels.front().best];
    return named(e.expected.id, {{"k", response.k}, {"tau", response.tau}, {"slope", response.slope}});
}

Found typeFound(const Evaluated &e) {
    if (e.expected.test >= e.set.types.size())
        return {};
    const ReferenceType &type = e.set.types[e.expected.test];
    const auto found = typeStatistics(type.values, type.tolerance);
    if (!found)
        return {};
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Normality values = found->normality.value_or(Normality{none, none});
    const Normality logarithms = found->logNormality.value_or(Normality{none, none});
    return named(e.expected.id, {{"mean", found->mean},
                                 {"s", found->s},
                                 {"factor", found->factor},
                                 {"normalLimit", found->normalLimit.value_or(none)},
                                 {"logNormalLimit", found->logNormalLimit.value_or(none)},
                                 {"confidenceOfLargest", found->confidenceOfLargest},
                                 {"w", values.w},
                                 {"probability", values.probability},
                                 {"wOfLogarithms", logarithms.w},
                                 {"probabilityOfLogarithms", logarithms.probability}});
}

/// By kind of expectation; those from the trends on need no test.
constexpr std::array ways{parameterOf, statisticOf,     contributionOf, driftFound, correctionOf,
                          influenceOf, comparisonFound, compensationOf, trendOf,    feedOf,
                          circleOf,    sheetFound,      responseFound,  typeFound};

/// With an unknown edition the test's own would be used: make no comparison.
const TestEvaluation *testOf(const Expectation &expected, const EvaluatedDocument &evaluated) {
    const bool exists = expected.test < evaluated.tests.size();
    const TestEvaluation *test = exists ? evaluated.tests[expected.test].get() : nullptr;
    const bool isOwn = expected.edition.empty();
    return test && (isOwn || (test->edition && test->edition->word == expected.edition)) ? test : nullptr;
}

QString placeOf(const Expectation &expected) {
    std::string result = "test " + std::to_string(expected.test + 1);
    const std::string target = expected.target ? std::to_string(expected.target) : std::string();
    for (const std::string &word :
         {expected.id, target, expected.of, expected.axis, expected.variant, expected.edition})
        result += word.empty() ? word : ' ' + word;
    return QString::fromStdString(result);
}

Comparison compare(const Expectation &expected, const ReferenceSet &set, const EvaluatedDocument &evaluated) {
    Comparison result{expected, placeOf(expected)};
    const TestEvaluation *test = testOf(expected, evaluated);
    if (!test && expected.what < Expected::trend)
        return result;
    const Found found = ways.at(static_cast<std::size_t>(expected.what))({set, evaluated, expected, test});
    result.word = found.word;
    result.computed = found.number;
    if (found.number)
        result.difference =
            (*found.number - expected.value) / (expected.relative ? std::abs(expected.value) : 1);
    result.agrees = expected.word.empty()
                        ? result.difference && std::abs(*result.difference) <= expected.tolerance
                        : found.word == expected.word;
    return result;
}

} // namespace

bool SetValidation::agrees() const {
    return std::ranges::all_of(comparisons, &Comparison::agrees);
}

SetValidation validate(const ReferenceSet &set) {
    SetValidation result{set.name, set.origin, set.quantity, {}};
    std::map<std::pair<std::string, std::string>, EvaluatedDocument> evaluations;
    for (const Expectation &expected : set.expected) {
        auto [place, isNew] = evaluations.try_emplace({expected.variant, expected.edition});
        if (isNew) // cannot be stopped
            place->second =
                withSimulations(evaluate(set.documents.at(expected.variant), nullptr, expected.edition),
                                SimulateWhich::monteCarloOnly)
                    .value();
        result.comparisons.push_back(compare(expected, set, place->second));
    }
    return result;
}

std::vector<SetValidation> validateFiles(const QStringList &names) {
    std::vector<SetValidation> result;
    for (const QString &name : names) {
        QFile file(name);
        if (!file.open(QIODevice::ReadOnly))
            throw Error(Error::Kind::unreadable, {REPORT_TEXT("report", "the file cannot be read (%1)"),
                                                  {file.errorString().toStdString()}});
        const QByteArray bytes = file.readAll();
        result.push_back(validate(readReferenceSet(bytes)));
        result.back().file = bytes;
    }
    return result;
}

bool selfTestPasses() {
    static const bool passes =
        std::ranges::all_of(validateFiles(quickReferenceFiles()), &SetValidation::agrees);
    return passes;
}

} // namespace palmer
