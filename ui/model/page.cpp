#include "ui/model/page.h"

#include "kernel/evaluation/iso230_4/circularcase.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace palmer::ui {

namespace {

constexpr std::string_view agreedPointPrefix = "agreedPoints.";

/// The place of the statement a finding says is missing among those of the edition; nothing for all other
/// findings.
std::optional<std::size_t> missingStatement(const Finding &finding, const Edition *edition) {
    if (!edition || finding.message.arguments.size() != 1)
        return std::nullopt;
    const auto *name = std::get_if<Text>(&finding.message.arguments.front());
    if (!name)
        return std::nullopt;
    const auto placeIn = [&](const auto &statements) -> std::optional<std::size_t> {
        const auto found = std::ranges::find_if(
            statements, [&](const auto &row) { return finding.id == row.id && *name == row.name; });
        if (found == statements.end())
            return std::nullopt;
        return static_cast<std::size_t>(found - statements.begin());
    };
    return edition->circles ? placeIn(edition->circles->statements) : placeIn(edition->statements);
}

/// The place of the first statement of that id.
std::size_t firstStatement(std::string_view id, const Edition &edition) {
    const auto placeIn = [&](const auto &statements) {
        const auto found = std::ranges::find_if(statements, [&](const auto &row) { return row.id == id; });
        return static_cast<std::size_t>(found - statements.begin());
    };
    return edition.circles ? placeIn(edition.circles->statements) : placeIn(edition.statements);
}

bool isAgreedPoint(const Finding &finding) {
    return std::string_view(finding.id).starts_with(agreedPointPrefix);
}

template <std::size_t size>
bool isOneOf(const std::array<std::string_view, size> &ids, std::string_view id) {
    return std::ranges::find(ids, id) != ids.end();
}

// The keys of the file, by the part of the document they stand in.
constexpr std::array<std::string_view, 4> ofMachine{"manufacturer", "model", "controller", "machine"};
constexpr std::array<std::string_view, 3> ofInstruments{"instruments", "certificate", "calibrationDate"};
constexpr std::array<std::string_view, 2> ofLimits{"limits", "decisionRule"};
constexpr std::array<std::string_view, 13> ofBudget{"device",
                                                    "misalignmentRange",
                                                    "temperatureRange",
                                                    "expansionRange",
                                                    "environmentalVariation",
                                                    "length",
                                                    "displacement",
                                                    "resolution",
                                                    "pointNoise",
                                                    "repeatability",
                                                    "centring",
                                                    "temperatureStandardUncertainty",
                                                    "expansionStandardUncertainty"};
constexpr std::array<std::string_view, 3> ofSimulation{"uncertaintyMethods", "monteCarlo", "monteCarloShift"};
constexpr std::array<std::string_view, 31> ofConditions{"date",
                                                        "name",
                                                        "travel",
                                                        "positionFeedback",
                                                        "targetChoice",
                                                        "toolOffset",
                                                        "otherAxes",
                                                        "sensors",
                                                        "workpieceOffset",
                                                        "correctionTo20",
                                                        "expansion",
                                                        "airPressure",
                                                        "airHumidity",
                                                        "warmUp",
                                                        "gradientPerHour",
                                                        "compensation",
                                                        "complete",
                                                        "levelled",
                                                        "unloaded",
                                                        "referenceLength",
                                                        "feed",
                                                        "dwell",
                                                        "temperature",
                                                        "centre",
                                                        "startPoint",
                                                        "stopPoint",
                                                        "cycle",
                                                        "smoothing",
                                                        "recentredBetweenRuns",
                                                        "zone",
                                                        "ends"};

/// Of an input of a budget, and no statement that the edition asks for.
bool isOfBudget(const Finding &finding, const Edition *edition) {
    // The reference length has a calibration and an uncertainty; no clause asks for the latter.
    return (isOneOf(ofBudget, finding.id) && !missingStatement(finding, edition)) ||
           (finding.id == "referenceLength" && finding.clause.empty());
}

/// An input without which there is no uncertainty: named by the finding, which no clause asks for.
bool isMissingInput(const Finding &finding, const Edition *edition) {
    return isOfBudget(finding, edition) && finding.clause.empty() && !finding.message.arguments.empty() &&
           std::holds_alternative<Text>(finding.message.arguments.back());
}

} // namespace

Page pageOf(const Finding &finding, const Edition *edition, const Document &document) {
    if (isAgreedPoint(finding))
        return Page::agreedPoints;
    const auto statement = missingStatement(finding, edition);
    // Machine and instruments both have a serial number; the machine's comes first.
    if (statement && finding.id == "serialNumber")
        return *statement == firstStatement("serialNumber", *edition) ? Page::machine : Page::instruments;
    if (isOneOf(ofMachine, finding.id))
        return Page::machine;
    if (finding.id == "instruments" && !document.instruments.empty())
        return Page::conditions;
    if (isOneOf(ofInstruments, finding.id))
        return Page::instruments;
    if (isOfBudget(finding, edition) || isOneOf(ofSimulation, finding.id))
        return Page::uncertainty;
    if (isOneOf(ofLimits, finding.id))
        return Page::limits;
    if (isOneOf(ofConditions, finding.id))
        return Page::conditions;
    return Page::readings;
}

bool isMissing(const Finding &finding, const Edition *edition) {
    return isAgreedPoint(finding) || isMissingInput(finding, edition) ||
           missingStatement(finding, edition).has_value();
}

int countMissing(const EvaluatedDocument &evaluated, std::size_t test, Page page) {
    const TestEvaluation &evaluation = *evaluated.tests[test];
    return static_cast<int>(std::ranges::count_if(evaluation.findings, [&](const Finding &finding) {
        return isMissing(finding, evaluation.edition) &&
               pageOf(finding, evaluation.edition, *evaluated.document) == page;
    }));
}

} // namespace palmer::ui
