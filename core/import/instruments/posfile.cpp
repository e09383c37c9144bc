// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "import/instruments/datanumbers.h"
#include "import/instruments/otherlines.h"
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

/// Units in the headings of the tables.
struct HeadingUnits {
    SaidUnit positions;
    SaidUnit errors;

    /// `isFurther`: there were headings before; the unit of one of several is not that of all.
    void add(std::string_view heading, bool isFurther) {
        const std::size_t mark = heading.find(headingMark);
        SaidUnit said = saidUnit(heading.substr(mark));
        if (isFurther && said.isSaid() != errors.isSaid())
            said = {nullptr, said.words() + errors.words()};
        positions = unitOfBoth(positions, saidUnit(heading.substr(0, mark)));
        errors = unitOfBoth(errors, said);
    }
};

/// A position repeated in a table belongs to another table whose heading is missing.
std::vector<MeanTable> tablesOf(std::string_view text, DataNumbers &data, HeadingUnits &units,
                                OtherLines &others, Remarks &remarks) {
    std::vector<MeanTable> tables;
    bool inTable = false;
    const auto leave = [&](std::size_t place) { remarks.unlike(place); };
    for (const auto &[whole, number] : linesOf(text)) {
        const std::string_view line = withoutBlanks(whole);
        if (line.find(headingMark) != std::string_view::npos) {
            tables.push_back({directionOfTitle(line), number});
            inTable = true;
            units.add(line, tables.size() > 1);
            continue;
        }
        if (line.empty())
            continue;
        const auto numbers = data.in(line, number);
        const bool isData =
            numbers ? !tables.empty() || numbers->size() == 2 : !tables.empty() && isDamagedRow(line);
        if (!isData) {
            inTable = false;
            others.add(number, line);
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
    DataNumbers data(imported.text, choices);
    OtherLines others;
    HeadingUnits units;
    const std::vector<MeanTable> tables = tablesOf(imported.text, data, units, others, imported.remarks);
    if (tables.empty())
        refuseWithoutReadings();
    std::vector<Pass> passes = passesOf(tables, choices, imported.remarks);
    imported.remarks.note(
        {}, REPORT_TEXT("report", "The file holds means of runs, not the runs: R and A say little."));
    choices.resolve("content", "deviations", Origin::recognised);
    const FileNotes notes = others.notes();
    PassForm form;
    form.sign = resolveSaidSign(notes.sign, "actualMinusTarget", Origin::guessed, choices, imported.remarks);
    if (!choices.isChosen("sign") && notes.sign.words.empty())
        imported.remarks.assumption("sign", REPORT_TEXT("report", "Sign: it changed between the versions of "
                                                                  "the program; read as actual − target."));
    const auto settle = [&](const char *choice, const SaidUnit &inHeading, const SaidUnit &stated) {
        const SaidUnit &said = inHeading.isSaid() ? inHeading : stated.isSaid() ? stated : notes.unit;
        return resolveStatedUnit(choice, said, *unitOf("mm"), choices, imported.remarks);
    };
    form.unit = settle("unit", units.errors, notes.unit);
    form.positionUnit = settle("positionUnit", units.positions, notes.positionUnit);
    requireOneMotion(form);
    others.askForKind({}, REPORT_TEXT("report", "Kind: the file speaks of “%1”; read as a positioning test."),
                      imported.remarks);
    imported.test = testFrom(measurementOf(std::move(passes), form, imported.remarks), notes.axis, choices,
                             notes.edition);
    data.remark(imported.remarks);
    takeNotes(notes, imported);
    choices.resolve("kind", "positioning", Origin::recognised);
}

} // namespace

const ImportFormat posFormat{"pos", REPORT_TEXT("report", "API laser data"), "pos", isPosText, readPosText};

} // namespace palmer
