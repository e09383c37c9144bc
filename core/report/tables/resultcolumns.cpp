// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/resultcolumns.h"

#include "document/json.h"
#include "document/resultwords.h"
#include "kernel/evaluation/coverage.h"
#include "report/words/formula.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

Json wordOrNull(std::string_view word) {
    return word.empty() ? Json(nullptr) : Json(std::string(word));
}

Json rulingTargets(const ToldResult &told) {
    Json list = Json::array();
    for (const auto &rules : told.parameter.ruling) {
        if (rules)
            list.push_back(
                {{"target", rules->target},
                 {"approach", rules->approach ? Json(fileWord(*rules->approach)) : Json(nullptr)}});
    }
    return list;
}

Json monteCarlo(const ToldResult &told) {
    const auto &simulated = told.parameter.simulated;
    const auto &simulation = told.uncertainty.simulation;
    if (!simulated || !simulation)
        return nullptr;
    return {{"u", simulated->u},
            {"low", simulated->low},
            {"high", simulated->high},
            {"shift", simulated->shift()},
            {"trials", simulation->trials},
            {"seed", simulation->seed},
            {"tolerance", simulated->tolerance()}};
}

Json coverage(const ToldResult &told) {
    const Parameter &parameter = told.parameter;
    return !parameter.expandedUncertainty                         ? ""
           : parameter.decidedBy == UncertaintyMethod::monteCarlo ? "95.45 %"
                                                                  : "k = 2";
}

QString verdictShown(const ShownResult &shown) {
    const auto &verdict = shown.result.parameter->verdict;
    return verdict ? shown.language.text(limitText(*verdict)) : QString();
}

constexpr unsigned forPeople = onPaper | onTerminal | inWindow | onClipboard;
constexpr unsigned forPrograms = inCsv | inJson;

// clang-format off
constexpr std::array columnRows{
    ResultColumn{"id", "parameter", REPORT_TEXT("report", "Quantity"), ResultLook::text, forPrograms,
        [](const ShownResult &s) { return symbolFormula(*s.result.parameter).plain(); },
        [](const ToldResult &t) { return Json(parameterId(t.parameter)); }},
    ResultColumn{"quantity", "", {}, ResultLook::text, inJson, nullptr,
        [](const ToldResult &t) { return Json(t.parameter.term.id); }},
    ResultColumn{"symbol", "symbol", REPORT_TEXT("report", "Symbol"), ResultLook::symbol, forPeople | forPrograms, nullptr,
        [](const ToldResult &t) { return Json(plainSymbol(t.parameter)); }, 7.8, 12.5},
    ResultColumn{"name", "name", REPORT_TEXT("report", "Quantity"), ResultLook::name, forPeople | forPrograms, nullptr,
        [](const ToldResult &t) { return Json(t.language.text(t.parameter.term.name).toStdString()); }, 0, 29},
    ResultColumn{"clause", "", {}, ResultLook::text, inJson, nullptr,
        [](const ToldResult &t) { return wordOrNull(t.parameter.term.clause); }},
    ResultColumn{"ruling", "", REPORT_TEXT_FOR("report", "Targets", "followed by i"), ResultLook::text, onPaper | onTerminal | inJson,
        [](const ShownResult &s) { return rulingText(*s.result.parameter); }, rulingTargets, 13.6, 0, false, true},
    ResultColumn{"other", "", {}, ResultLook::number, inWindow | onClipboard,
        [](const ShownResult &s) { return s.other ? s.other->value : QString(); }, nullptr, 0, 0, true},
    ResultColumn{"otherUncertainty", "", REPORT_TEXT("report", "U"), ResultLook::number, inWindow | onClipboard,
        [](const ShownResult &s) { return s.other ? s.other->uncertainty : QString(); }, nullptr, 0, 0, true},
    ResultColumn{"value", "value", REPORT_TEXT("report", "Value"), ResultLook::number, forPeople | forPrograms,
        [](const ShownResult &s) { return s.result.value; },
        [](const ToldResult &t) { return numberOrNull(t.parameter.value); }, 11, 11.5},
    ResultColumn{"unit", "unit", REPORT_TEXT("report", "Unit"), ResultLook::text, forPrograms,
        [](const ShownResult &s) { return s.language.unit(s.result.parameter->term.quantity); },
        [](const ToldResult &t) { return Json(resultUnit(t.parameter.term.quantity)); }},
    ResultColumn{"expandedUncertainty", "U", REPORT_TEXT("report", "U"), ResultLook::number, forPeople | forPrograms,
        [](const ShownResult &s) { return s.result.uncertainty; },
        [](const ToldResult &t) { return numberOrNull(t.parameter.expandedUncertainty); }, 14.2, 13.5},
    ResultColumn{"coverageFactor", "", {}, ResultLook::number, inJson, nullptr,
        [](const ToldResult &t) { const auto c = coverageOfU(t.parameter); return c ? Json(c->factor) : Json(nullptr); }},
    ResultColumn{"coverageProbability", "", {}, ResultLook::number, inJson, nullptr,
        [](const ToldResult &t) { const auto c = coverageOfU(t.parameter); return c ? Json(c->probability) : Json(nullptr); }},
    ResultColumn{"budgetUncertainty", "", {}, ResultLook::number, inJson, nullptr,
        [](const ToldResult &t) { return numberOrNull(t.parameter.budgetUncertainty); }},
    ResultColumn{"budgetActualUncertainty", "", {}, ResultLook::number, inJson, nullptr,
        [](const ToldResult &t) { return numberOrNull(t.parameter.actualUncertainty); }},
    ResultColumn{"", "coverage of U", {}, ResultLook::text, inCsv, nullptr, coverage},
    ResultColumn{"change", "", REPORT_TEXT("report", "Change"), ResultLook::number, inWindow | onClipboard,
        [](const ShownResult &s) { return s.change; }, nullptr, 0, 0, true},
    ResultColumn{"limit", "limit", REPORT_TEXT("report", "Limit"), ResultLook::number, forPeople | forPrograms,
        [](const ShownResult &s) { return s.result.limit; },
        [](const ToldResult &t) { return t.parameter.limit ? numberOrNull(t.parameter.limit->value) : Json(nullptr); }, 11, 11},
    ResultColumn{"limitOf", "", {}, ResultLook::text, inJson, nullptr,
        [](const ToldResult &t) { return wordOrNull(t.parameter.limitOf); }},
    ResultColumn{"guardBand", "", {}, ResultLook::number, inJson, nullptr,
        [](const ToldResult &t) { return numberOrNull(t.parameter.guardBand); }},
    ResultColumn{"picture", "", {}, ResultLook::picture, onPaper | inWindow, nullptr, nullptr, 21.6, 18.7},
    ResultColumn{"verdict", "", REPORT_TEXT("report", "Verdict"), ResultLook::verdict, forPeople | inJson, verdictShown,
        [](const ToldResult &t) { return t.parameter.verdict ? Json(fileWord(*t.parameter.verdict)) : Json(nullptr); }, 20, 20.8},
    ResultColumn{"monteCarlo", "", {}, ResultLook::text, inJson, nullptr, monteCarlo},
    ResultColumn{"limits", "limits", REPORT_TEXT("report", "Verdict"), ResultLook::text, 0, verdictShown,
        [](const ToldResult &t) { return Json(limitsWord(t.parameter.verdict)); }}, // for summaries
};
// clang-format on

} // namespace

std::span<const ResultColumn> resultColumns() {
    return columnRows;
}

std::vector<const ResultColumn *> resultColumns(ResultList list) {
    std::vector<const ResultColumn *> listed;
    for (const ResultColumn &column : columnRows) {
        if ((column.lists & list) != 0)
            listed.push_back(&column);
    }
    return listed;
}

const ResultColumn &resultColumn(std::string_view name) {
    return *std::ranges::find_if(
        columnRows, [&](const ResultColumn &column) { return column.key == name || column.heading == name; });
}

} // namespace palmer
