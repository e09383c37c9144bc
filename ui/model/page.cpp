#include "ui/model/page.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace palmer::ui {

namespace {

constexpr std::string_view agreedPointPrefix = "agreedPoints.";

/// The statement a finding says is missing; null for all other findings.
const Statement *missingStatement(const Finding &finding, const Edition *edition) {
    if (!edition || finding.message.arguments.size() != 1)
        return nullptr;
    const auto *name = std::get_if<Text>(&finding.message.arguments.front());
    if (!name)
        return nullptr;
    const auto found = std::ranges::find_if(
        edition->statements, [&](const Statement &row) { return finding.id == row.id && *name == row.name; });
    return found == edition->statements.end() ? nullptr : &*found;
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
constexpr std::array<std::string_view, 22> ofConditions{
    "date",        "name",    "travel",          "positionFeedback", "targetChoice", "toolOffset",
    "otherAxes",   "sensors", "workpieceOffset", "correctionTo20",   "expansion",    "airPressure",
    "airHumidity", "warmUp",  "gradientPerHour", "compensation",     "complete",     "levelled",
    "unloaded",    "feed",    "dwell",           "temperature"};

} // namespace

Page pageOf(const Finding &finding, const Edition *edition) {
    if (isAgreedPoint(finding))
        return Page::agreedPoints;
    const Statement *statement = missingStatement(finding, edition);
    // Machine and instruments both have a serial number; the machine's comes first.
    if (statement && finding.id == "serialNumber") {
        const auto first = std::ranges::find_if(edition->statements, [](const Statement &row) {
            return std::string_view(row.id) == "serialNumber";
        });
        return statement == &*first ? Page::machine : Page::instruments;
    }
    if (isOneOf(ofMachine, finding.id))
        return Page::machine;
    if (isOneOf(ofInstruments, finding.id))
        return Page::instruments;
    if (isOneOf(ofLimits, finding.id))
        return Page::limits;
    if (isOneOf(ofConditions, finding.id))
        return Page::conditions;
    return Page::readings;
}

bool isMissing(const Finding &finding, const Edition *edition) {
    return isAgreedPoint(finding) || missingStatement(finding, edition);
}

int countMissing(const TestEvaluation &evaluation, Page page) {
    return static_cast<int>(std::ranges::count_if(evaluation.findings, [&](const Finding &finding) {
        return isMissing(finding, evaluation.edition) && pageOf(finding, evaluation.edition) == page;
    }));
}

} // namespace palmer::ui
