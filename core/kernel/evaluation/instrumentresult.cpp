// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/instrumentresult.h"

#include "kernel/words/unit.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace palmer {

namespace {

/// Returns our result that corresponds to one of an instrument's program. Its circularity is the difference
/// between the largest and smallest radius over all its runs.
const Parameter *ourResult(const TestEvaluation &evaluation, const std::string &name) {
    const auto withId = [&](std::string_view id) -> const Parameter * {
        for (const Parameter &parameter : evaluation.parameters) {
            if (parameter.value && (parameterId(parameter) == id || parameter.term.id == id))
                return &parameter;
        }
        return nullptr;
    };
    if (name.ends_with("AF_CIRCULARITY")) {
        const Parameter *both = withId("G(b)");
        return both ? both : withId("G");
    }
    return withId(name);
}

/// Returns the unit by its sign, with either letter mu, or by its word: "µm", "um".
const Unit *unitStated(std::string_view stated) {
    constexpr std::string_view micro = "µ";
    constexpr std::string_view greekMu = "μ";
    std::string sign(stated);
    if (stated.starts_with(greekMu))
        sign.replace(0, greekMu.size(), micro);
    const Unit *unit = unitOfSign(sign);
    return unit ? unit : unitOf(stated);
}

} // namespace

std::vector<InstrumentResult> instrumentResults(const Test &test, const TestEvaluation &evaluation) {
    std::vector<InstrumentResult> results;
    for (const ImportedFile &file : test.imports) {
        for (const ImportedResult &stated : file.results) {
            InstrumentResult &result = results.emplace_back(InstrumentResult{&file, &stated});
            const Parameter *ours = ourResult(evaluation, stated.name);
            if (!ours)
                continue;
            const Unit *unit = unitStated(stated.unit);
            const bool angle = ours->term.quantity == Quantity::angularDeviation;
            if (unit && unit->kind == (angle ? UnitKind::angle : UnitKind::length)) {
                result.ours = ours;
                result.value = unit->toBase(stated.value);
            }
        }
    }
    return results;
}

void findOtherResults(TestEvaluation &evaluation, const Test &test, const Surroundings &surroundings) {
    constexpr double share = 0.05;
    constexpr double resolutions = 2;
    constexpr double micrometre = 1e-3;
    constexpr double arcSecond = 1.0 / 3600;
    double resolution = 0;
    for (const Instrument *instrument : surroundings.instruments)
        resolution = std::max(resolution, instrument->resolution.value_or(0));
    for (const InstrumentResult &result : instrumentResults(test, evaluation)) {
        if (!result.ours)
            continue;
        const Quantity quantity = result.ours->term.quantity;
        const double least = 0.2 * (quantity == Quantity::angularDeviation ? arcSecond : micrometre);
        const double most = std::max({share * std::abs(result.value), resolutions * resolution, least});
        const double ours = *result.ours->value;
        if (std::abs(ours - result.value) <= most * (1 + 1e-9)) // allows for unit conversions
            continue;
        constexpr int decimals = 2;
        Finding finding;
        finding.id = "instrumentResult";
        finding.keys = {"imports"};
        finding.message = {REPORT_TEXT("report", "%1: the instrument's program states %2, here %3: edition, "
                                                 "correction or readings differ."),
                           {plainSymbol(*result.ours), Number{result.value, quantity, decimals},
                            Number{ours, quantity, decimals}}};
        evaluation.findings.push_back(std::move(finding));
    }
}

} // namespace palmer
