// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/positioningcolumns.h"

#include <functional>

namespace palmer {

/// The columns of a table of a positioning test on the way to their roles: what the steps know so far.
struct ColumnSearch {
    TableReading &reading;
    PositioningColumns result = {};
    std::vector<std::size_t> targets = {};   ///< columns that may hold the targets
    std::vector<std::size_t> positions = {}; ///< actual positions beside the deviations
    std::optional<Message> question = {};    ///< the first doubt about the columns, else the first guess
    bool isDoubtful = false;                 ///< it is a doubt
    bool hasProposal = true;                 ///< what was read may be right
};

/// What the steps share.
class ColumnStep {
protected:
    explicit ColumnStep(ColumnSearch &search)
        : m(search.reading)
        , m_heads(search.reading.body.columns)
        , m_search(search)
        , m_result(search.result) {}

    [[nodiscard]] const HeadingWords &words(std::size_t c) const { return m_heads[c].words; }
    [[nodiscard]] bool isNumeric(std::size_t c) const { return m_heads[c].kind == ColumnKind::numbers; }
    [[nodiscard]] ColumnRole &role(std::size_t c) { return m_result.columns[c].role; }
    [[nodiscard]] std::vector<double> valuesOf(std::size_t column) const; ///< of the first rows
    /// Whether the values stay near the targets, line by line.
    [[nodiscard]] bool followsTarget(std::size_t column) const;
    void ask(Message message);    ///< a doubt; the first one stays
    void assume(Message message); ///< a guess, which stands behind doubts

    TableReading &m;
    const std::vector<TableColumn> &m_heads;
    ColumnSearch &m_search;
    PositioningColumns &m_result;
};

// The steps, in their order.
void takeRolesOfHeadings(ColumnSearch &search);
void findTargetColumn(ColumnSearch &search);
void findReadings(ColumnSearch &search);
void keepReadingsOfOneKind(ColumnSearch &search);
void takeDirectionsOfHeadings(ColumnSearch &search);
void findOwnTargets(ColumnSearch &search);
void proveSign(ColumnSearch &search);
/// Takes what the user chose in the place of what was found. Throws Error for roles that make no test.
void takeChosenColumns(ColumnSearch &search, const std::string &text);

} // namespace palmer
