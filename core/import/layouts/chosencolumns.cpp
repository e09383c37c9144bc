// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/columnsearch.h"
#include "tables/contenterror.h"

#include <algorithm>

namespace palmer {

namespace {

class ChosenColumns : ColumnStep {
public:
    explicit ChosenColumns(ColumnSearch &search)
        : ColumnStep(search) {}

    void takeChosen(const std::string &text) {
        const auto named = columnsOf(text);
        if (named && named->size() > m_heads.size())
            throw Error(Error::Kind::content,
                        {REPORT_TEXT_COUNTED("report", "%1 names %n column(s), the table has %2"),
                         {"columns", counted(m_heads.size())},
                         static_cast<int>(named->size())});
        std::vector<ImportColumn> chosen = m.columnsAs(text);
        m_result = {};
        const bool hasDeviations = columnOf(chosen, ColumnRole::deviation).has_value();
        ColumnRole content = ColumnRole::run;
        for (std::size_t c = 0; c < chosen.size(); ++c) {
            const auto take = [&](ColumnRole wanted, std::optional<std::size_t> &place) {
                if (chosen[c].role == wanted && !place)
                    place = c;
            };
            take(ColumnRole::target, m_result.target);
            take(ColumnRole::direction, m_result.direction);
            take(ColumnRole::number, m_result.number);
            const bool isProof = hasDeviations && chosen[c].role == ColumnRole::actual;
            if (!chosen[c].hasReadings() || isProof)
                continue;
            if (!m_result.values.empty() && chosen[c].role != content)
                refuseContent(REPORT_TEXT(
                    "report",
                    "columns of different roles cannot be read as runs of one test; ignore one of them"));
            content = chosen[c].role;
            m_result.values.push_back(c);
            if (!m_result.unit.isSaid())
                m_result.unit = m_heads[c].said();
        }
        m_result.content = content == ColumnRole::deviation ? "deviations"
                           : content == ColumnRole::actual  ? "positions"
                                                            : "";
        m_result.columns = std::move(chosen);
    }
};

} // namespace

void takeChosenColumns(ColumnSearch &search, const std::string &text) {
    ChosenColumns(search).takeChosen(text);
}

} // namespace palmer
