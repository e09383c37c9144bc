// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/edition.h"

#include "kernel/evaluation/iso230_2/editions.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/evaluation/iso230_4/editions.h"

#include <algorithm>
#include <vector>

namespace palmer {

std::span<const Edition *const> editions() {
    static const std::vector<const Edition *> all = [] {
        std::vector<const Edition *> result;
        for (const auto table : {iso230_2::editions(), iso230_4::editions()}) {
            for (const Edition &edition : table)
                result.push_back(&edition);
        }
        return result;
    }();
    return all;
}

/// Editions of a kind are adjacent, as each table contains one kind.
std::span<const Edition *const> editionsOf(Kind kind) {
    const auto all = editions();
    const auto ofKind = [kind](const Edition *edition) { return edition->kind == kind; };
    const auto first = std::ranges::find_if(all, ofKind);
    return {first, std::find_if_not(first, all.end(), ofKind)};
}

std::string wordsOf(std::span<const Edition *const> list) {
    std::string words;
    for (const Edition *edition : list)
        words += (words.empty() ? "" : ", ") + std::string(edition->word);
    return words;
}

const Edition *findEdition(std::string_view word) {
    const auto all = editions();
    const auto found =
        std::ranges::find(all, word, [](const Edition *e) { return std::string_view(e->word); });
    return found == all.end() ? nullptr : *found;
}

const Edition &defaultEdition(Kind kind) {
    return **std::ranges::find_if(editionsOf(kind),
                                  [](const Edition *edition) { return edition->isDefault; });
}

std::vector<const Term *> termsOf(const Edition &edition) {
    std::vector<const Term *> terms;
    for (const Row &row : edition.rows)
        terms.push_back(&row.term);
    for (const CircularRow &row : edition.circles ? edition.circles->rows : std::span<const CircularRow>())
        terms.push_back(&row.term);
    return terms;
}

bool isParameter(Kind kind, std::string_view id) {
    return std::ranges::any_of(editionsOf(kind), [&](const Edition *edition) {
        return std::ranges::any_of(termsOf(*edition), [&](const Term *term) { return term->isMeantBy(id); });
    });
}

bool isAgreementPoint(Kind kind, std::string_view point) {
    return std::ranges::any_of(editionsOf(kind), [&](const Edition *edition) {
        return std::ranges::any_of(edition->points,
                                   [&](const AgreementPoint &p) { return p.point == point; });
    });
}

} // namespace palmer
