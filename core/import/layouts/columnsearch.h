// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/layouts/positioningcolumns.h"
#include "tables/contenterror.h"

#include <functional>

namespace palmer {

/// State of the search for the column roles of a positioning table.
struct ColumnSearch {
    TableReading &reading;
    PositioningColumns result = {};
    std::vector<std::size_t> targets = {};   ///< columns that may hold the targets
    std::vector<std::size_t> positions = {}; ///< actual positions in addition to deviations
    std::optional<Message> question = {};    ///< the first doubt about the columns, otherwise the first guess
    bool isDoubtful = false;                 ///< the question is a doubt
    bool hasProposal = true;                 ///< what was read may be right
};

/// Shared by the steps.
class ColumnStep {
public:
    explicit ColumnStep(ColumnSearch &search)
        : m(search.reading)
        , m_heads(search.reading.body.columns)
        , m_search(search)
        , m_result(search.result) {}

protected:
    [[nodiscard]] const HeadingWords &words(std::size_t c) const { return m_heads[c].words; }
    [[nodiscard]] bool isNumeric(std::size_t c) const { return m_heads[c].kind == ColumnKind::numbers; }
    [[nodiscard]] ColumnRole &role(std::size_t c) { return m_result.columns[c].role; }
    /// Values of the first rows.
    [[nodiscard]] std::vector<double> valuesOf(std::size_t column) const { return m.valuesOf(column, 5000); }
    /// True if the values stay close to the targets, line by line.
    [[nodiscard]] bool followsTarget(std::size_t column) const;
    /// A doubt; only the first is kept.
    template <class... Arguments>
    void ask(Text text, Arguments... arguments) {
        if (!m_search.isDoubtful)
            m_search.question = messageOf(text, std::move(arguments)...);
        m_search.isDoubtful = true;
    }
    /// A guess; doubts take precedence.
    template <class... Arguments>
    void assume(Text text, Arguments... arguments) {
        if (!m_search.question)
            m_search.question = messageOf(text, std::move(arguments)...);
    }

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

} // namespace palmer
