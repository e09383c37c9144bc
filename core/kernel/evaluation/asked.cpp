// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/asked.h"

#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/evaluation/positioningcase.h"

#include <algorithm>

namespace palmer {

namespace {

template <class Case>
std::vector<AskedStatement> askedBy(std::span<const RequirementOf<Case>> rows, const Case &test) {
    std::vector<AskedStatement> asked;
    for (const RequirementOf<Case> &row : rows) {
        const bool here = row.subject == Subject::conditions || row.subject == Subject::namedInstruments;
        if (!here || (row.applies && !row.applies(test)))
            continue;
        const bool usual =
            row.modality == Grade::note || (row.source != Source::text && row.source != Source::practice);
        for (const char *path : row.keys) {
            if (!path)
                continue;
            std::string_view key(path);
            key.remove_prefix(key.rfind('.') + 1); // npos + 1 is 0
            const auto known = std::ranges::find(asked, key, &AskedStatement::key);
            if (known == asked.end())
                asked.push_back({key, usual});
            else
                known->usual = known->usual && usual;
        }
    }
    return asked;
}

} // namespace

std::vector<AskedStatement> askedStatements(const Test &test, const TestEvaluation &evaluation) {
    const Edition *edition = evaluation.edition ? evaluation.edition : findEdition(test.edition);
    if (!edition)
        return {};
    const Surroundings surroundings;
    if (const auto *circle = std::get_if<CircularMeasurement>(&test.measurement)) {
        const auto *known = std::get_if<CircularResults>(&evaluation.results);
        const CircularResults none;
        return askedBy<CircularCase>(edition->circles->requirements,
                                     {test, *circle, surroundings, *edition, known ? *known : none});
    }
    const auto *known = std::get_if<PositioningResults>(&evaluation.results);
    const PositioningResults none;
    const PositioningResults &results = known ? *known : none;
    return askedBy<PositioningCase>(edition->requirements,
                                    {test, std::get<PositioningMeasurement>(test.measurement), surroundings,
                                     *edition, results.targets, results.drift, results.positiveRuns,
                                     results.negativeRuns});
}

} // namespace palmer
