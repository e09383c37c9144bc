// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/words/printednumbers.h"

#include <QString>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace palmer {

/// A result as listed in window, report and command line. Points into the evaluation.
struct PrintedResult : PrintedNumbers {
    const Parameter *parameter = nullptr;
    bool isFirst = true; ///< first of its family, with a rule above
};

/// Lists of results; bits that can be combined with |.
enum ResultList : unsigned {
    onPaper = 1U << 0U,
    onTerminal = 1U << 1U,
    inWindow = 1U << 2U,
    onClipboard = 1U << 3U,
    inCsv = 1U << 4U,
    inJson = 1U << 5U
};

/// Inputs of a cell for people.
struct ShownResult {
    const PrintedResult &result;
    const Language &language;
    const PrintedNumbers *other = nullptr; ///< same quantity in the test of the other role
    QString change = {};                   ///< as left − as found
};

/// Inputs of a cell for programs.
struct ToldResult {
    const Parameter &parameter;
    const UncertaintyEvaluation &uncertainty;
    const Language &language;
};

/// Appearance of a cell; each list draws it in its way.
enum class ResultLook { text, number, symbol, name, picture, verdict };

/// A column of results. Every list contains the columns that name it in `lists`, in table order: a new column
/// only needs a new row.
struct ResultColumn {
    const char *key = "";     ///< in JSON; for columns of the window only, their name in the code
    const char *heading = ""; ///< in CSV
    Text title;               ///< for people
    ResultLook look = ResultLook::text;
    unsigned lists = 0; ///< ResultList
    /// Text for people, empty if there is none; null if each list draws the cell itself.
    QString (*shown)(const ShownResult &) = nullptr;
    /// Value for programs: unrounded, in mm or degrees.
    nlohmann::ordered_json (*told)(const ToldResult &) = nullptr;
    double width = 0;        ///< on paper, mm; 0: the remaining width
    double summaryWidth = 0; ///< in the summary of a report, mm; 0: not there
    bool besideOnly = false; ///< shown only with a test of the other role
    bool axesOnly = false;   ///< not for circles; the letter of the targets follows the title
};

[[nodiscard]] std::span<const ResultColumn> resultColumns();

/// The columns of a list.
[[nodiscard]] std::vector<const ResultColumn *> resultColumns(ResultList list);

/// The column with this key or heading. Precondition: it exists.
[[nodiscard]] const ResultColumn &resultColumn(std::string_view name);

} // namespace palmer
