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

/// A result as window, report and command line list it. Points into the evaluation.
struct PrintedResult : PrintedNumbers {
    const Parameter *parameter = nullptr;
    bool isFirst = true; ///< of its family: a rule stands above
};

/// Lists of results; bits, joined with |.
enum ResultList : unsigned {
    onPaper = 1U << 0U,
    onTerminal = 1U << 1U,
    inWindow = 1U << 2U,
    onClipboard = 1U << 3U,
    inCsv = 1U << 4U,
    inJson = 1U << 5U
};

/// What a cell says to people is made of that.
struct ShownResult {
    const PrintedResult &result;
    const Language &language;
    bool filledUp = false;                 ///< a limit has the decimals of the value: nothing aligns them
    const PrintedNumbers *other = nullptr; ///< of the same quantity in the test of the other role
    QString change = {};                   ///< as left − as found
};

/// What it says to programs is made of that.
struct ToldResult {
    const Parameter &parameter;
    const UncertaintyEvaluation &uncertainty;
    const Language &language;
};

/// How each list draws a cell.
enum class ResultLook { text, number, symbol, name, picture, verdict };

/// A column of results. Every list of results has the columns whose rows name it, in the order of the rows:
/// a new one is a row.
struct ResultColumn {
    const char *key = "";     ///< in JSON; for the window's own columns what code calls them
    const char *heading = ""; ///< in CSV
    Text title;               ///< for people
    ResultLook look = ResultLook::text;
    unsigned lists = 0; ///< ResultList
    /// As people read it, empty where there is nothing; null where each list draws it in its own way.
    QString (*shown)(const ShownResult &) = nullptr;
    /// Unrounded, in mm or degrees.
    nlohmann::ordered_json (*told)(const ToldResult &) = nullptr;
    double width = 0;        ///< on paper, mm; 0: what the others leave
    bool besideOnly = false; ///< there where the test of the other role stands beside
    bool axesOnly = false;   ///< circles have none
};

[[nodiscard]] std::span<const ResultColumn> resultColumns();

/// Those of a list.
[[nodiscard]] std::vector<const ResultColumn *> resultColumns(ResultList list);

/// By its key or heading, which exists.
[[nodiscard]] const ResultColumn &resultColumn(std::string_view name);

} // namespace palmer
