// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "import/layouts/passes.h"
#include "import/layouts/phrases.h"
#include "import/layouts/sections.h"
#include "tables/contenterror.h"
#include "tables/folded.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <set>

namespace palmer {

namespace {

constexpr std::string_view headingMark = "Avg Error";

/// A table of means, below "Position Forward Directional Avg Error".
struct MeanTable {
    std::optional<Direction> direction; ///< null: means of both directions
    std::size_t line = 0;               ///< line of its heading
    Pass pass = {};
    std::set<double> positions = {};
};

std::optional<Direction> directionOfTitle(std::string_view line) {
    const std::string low = folded(line);
    if (low.find("bidirectional") != std::string::npos)
        return {};
    return readHeading(line).direction;
}

/// True for a damaged row: a line that begins with a number, or a word followed by a number.
bool isDamagedRow(std::string_view line) {
    const auto begins = [](std::string_view text) {
        return leadingNumber(text, decimalMarkIn(text)).size > 0;
    };
    const std::size_t blank = line.find_first_of(" \t");
    if (begins(line) || blank == std::string_view::npos)
        return begins(line);
    const std::string_view rest = withoutBlanks(line.substr(blank));
    return rest.find_first_of(" \t") == std::string_view::npos && begins(rest);
}

/// A position repeated in a table belongs to another table whose heading is missing.
std::vector<MeanTable> tablesOf(std::string_view text, Remarks &remarks) {
    std::vector<MeanTable> tables;
    bool inTable = false;
    const auto leave = [&](std::size_t place) { remarks.unlike(place); };
    for (const auto &[whole, number] : linesOf(text)) {
        const std::string_view line = withoutBlanks(whole);
        if (line.find(headingMark) != std::string_view::npos) {
            tables.push_back({directionOfTitle(line), number});
            inTable = true;
            continue;
        }
        const auto numbers = numbersIn(line);
        const bool isData = numbers || isDamagedRow(line);
        if (line.empty() || tables.empty())
            continue;
        if (!isData) {
            inTable = false;
        } else if (inTable && numbers && numbers->size() == 2 &&
                   tables.back().positions.insert((*numbers)[0]).second) {
            tables.back().pass.readings.push_back(
                {(*numbers)[0], (*numbers)[1], static_cast<std::uint32_t>(number)});
        } else {
            leave(number);
        }
    }
    for (const MeanTable &table : tables) {
        if (table.pass.readings.empty())
            leave(table.line);
    }
    std::erase_if(tables, [](const MeanTable &table) { return table.pass.readings.empty(); });
    return tables;
}

/// Means of each direction, or if missing those of both, for which the direction is a choice.
std::vector<Pass> passesOf(const std::vector<MeanTable> &tables, Choices &choices, Remarks &remarks) {
    std::vector<Pass> passes;
    for (const MeanTable &table : tables) {
        if (table.direction) {
            passes.push_back(table.pass);
            passes.back().direction = *table.direction;
        }
    }
    const auto choice = choices.resolve("directions", passes.empty() ? "positive" : "stated",
                                        passes.empty() ? Origin::guessed : Origin::recognised);
    if (passes.empty())
        passes.push_back(tables.front().pass);
    for (Pass &pass : passes) {
        const bool isReversed = choice.value == "reversed" && pass.direction == Direction::positive;
        if (choice.value == "negative" || isReversed)
            pass.direction = Direction::negative;
        else if (choice.value == "reversed")
            pass.direction = Direction::positive;
    }
    if (choice.origin == Origin::guessed)
        remarks.assumption("directions", REPORT_TEXT("report", "Directions: the file has means of "
                                                               "both directions only; they are read as ↑."));
    return passes;
}

bool isPosText(QByteArrayView bytes) {
    const std::string_view text(bytes.data(),
                                static_cast<std::size_t>(std::min<qsizetype>(bytes.size(), 1 << 20)));
    return text.find("Bidirectional Avg Error") != std::string_view::npos;
}

void readPosText(const ImportSource &source, Choices &choices, Imported &imported) {
    imported.text = decodedText(source.bytes, choices, imported);
    const std::vector<MeanTable> tables = tablesOf(imported.text, imported.remarks);
    if (tables.empty())
        refuseWithoutReadings();
    std::vector<Pass> passes = passesOf(tables, choices, imported.remarks);
    imported.remarks.note(
        {}, REPORT_TEXT("report", "The file holds means of runs, not the runs: R and A say little."));
    choices.resolve("content", "deviations", Origin::recognised);
    PassForm form;
    form.sign = choices.resolve("sign", "actualMinusTarget", Origin::guessed).value;
    if (!choices.isChosen("sign"))
        imported.remarks.assumption("sign", REPORT_TEXT("report", "Sign: it changed between the versions of "
                                                                  "the program; read as actual − target."));
    form.unit = unitOf(choices.resolve("unit", "mm", Origin::recognised).value);
    form.positionUnit = unitOf(choices.resolve("positionUnit", "mm", Origin::recognised).value);
    requireOneMotion(form);
    imported.test = testFrom(measurementOf(std::move(passes), form, imported.remarks), "", choices);
    choices.resolve("kind", "positioning", Origin::recognised);
}

} // namespace

const ImportFormat posFormat{"pos", REPORT_TEXT("report", "API laser data"), "pos", isPosText, readPosText};

} // namespace palmer
