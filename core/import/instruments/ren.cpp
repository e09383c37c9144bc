// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "import/layouts/passes.h"
#include "import/layouts/sections.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace palmer {

namespace {

/// The last number of a line, used for spacing, start or end.
std::optional<double> lastNumber(std::string_view line) {
    std::optional<double> found;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t end = std::min(line.find_first_of(" \t:=", at), line.size());
        const LeadingNumber number =
            leadingNumber(line.substr(at, end - at), decimalMarkIn(line.substr(at, end - at)));
        if (end > at && number.size > 0)
            found = number.value;
        at = end + 1;
    }
    return found;
}

struct Header {
    std::optional<double> spacing;
    std::optional<double> start;
    std::optional<double> end;
    SaidUnit unit;
    bool ended = false; ///< true: the table begins
};

void readHead(std::string_view line, Header &header) {
    if (containsWord(line, "Compensation spacing"))
        header.spacing = lastNumber(line);
    else if (containsWord(line, "Compensation start"))
        header.start = lastNumber(line);
    else if (containsWord(line, "Compensation end"))
        header.end = lastNumber(line);
    else if (containsWord(line, "Axis position"))
        header.ended = true;
    if (!header.ended && containsWord(line, "unit")) {
        if (SaidUnit said = saidUnit(line); said.isSaid())
            header.unit = std::move(said);
    }
}

/// True for a damaged row: a line that begins with a number or has two.
bool isDamagedLine(std::string_view line) {
    std::size_t numbers = 0;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
        const std::string_view word = line.substr(at, end - at);
        if (!word.empty() && leadingNumber(word, decimalMarkIn(word)).size > 0)
            numbers += at == 0 ? 2 : 1;
        at = end + 1;
    }
    return numbers >= 2;
}

bool isUnknown(std::string_view line) {
    return !containsWord(line, "Compensation") && !containsWord(line, "unit") &&
           !containsWord(line, "Axis position");
}

/// True if start and end are those of the table, in either order.
bool agrees(const Header &header, double low, double high) {
    const bool startAgrees = !header.start ||
                             std::min(*header.start, header.end.value_or(*header.start)) == low ||
                             *header.start == low || *header.start == high;
    return startAgrees && (!header.end || *header.end == high || *header.end == low);
}

/// Reads the table, and the lines above it into `header`. Remarks: damaged and missing lines, unknown texts.
Pass readTable(Imported &imported, Header &header) {
    Pass pass;
    double lastNo = 0;
    bool follows = false; // a line that was read
    QuotedLines unused;
    for (const auto &[whole, number] : linesOf(imported.text)) {
        const std::string_view line = withoutBlanks(whole);
        if (line.empty())
            continue;
        readHead(line, header);
        const auto numbers = numbersIn(line);
        if (!header.ended || (!numbers && !isDamagedLine(line))) {
            if (isUnknown(line))
                unused.add(number, line);
            continue;
        }
        if (!numbers || numbers->size() != 3) {
            imported.remarks.unlike(number);
            follows = false; // reported already
            continue;
        }
        const double no = (*numbers)[0];
        if (follows && no != lastNo + 1)
            imported.remarks.problem({"unread", number},
                                     REPORT_TEXT("report", "The lines are numbered %1 and then "
                                                           "%2: some are missing, or one is there twice."),
                                     counted(lastNo), counted(no));
        lastNo = no;
        follows = true;
        pass.readings.push_back({(*numbers)[1], (*numbers)[2], static_cast<std::uint32_t>(number)});
    }
    unused.remarkUnused(imported.remarks);
    return pass;
}

PassForm resolveForm(const Header &header, Choices &choices, Remarks &remarks) {
    PassForm form;
    form.sign = choices.resolve("sign", "targetMinusActual", Origin::guessed).value;
    const Unit *stated = header.unit.unit;
    form.unit = resolveUnit(
        "unit", header.unit, stated && stated->kind == UnitKind::length ? stated : nullptr, *unitOf("um"),
        {REPORT_TEXT("report", "Unit of the compensation values: nothing in the file says it; read as %1.")},
        choices, remarks);
    form.positionUnit = unitOf(
        choices.resolve("positionUnit", form.unit->kind == UnitKind::angle ? "deg" : "mm", Origin::recognised)
            .value);
    requireOneMotion(form);
    return form;
}

bool isRenText(QByteArrayView bytes) {
    const std::string_view text(bytes.data(),
                                static_cast<std::size_t>(std::min<qsizetype>(bytes.size(), 8192)));
    return containsWord(text, "Compensation spacing") || containsWord(text, "Compensation start");
}

void readRenText(const ImportSource &source, Choices &choices, Imported &imported) {
    imported.text = decodedText(source.bytes, choices, imported);
    Header header;
    const Pass pass = readTable(imported, header);
    if (pass.readings.empty())
        refuseContent(
            REPORT_TEXT("report", "there is no table of axis positions and compensation values in it"));
    const auto [low, high] = std::ranges::minmax(pass.readings, {}, &PassReading::position);
    if (!agrees(header, low.position, high.position))
        imported.remarks.problem(
            {},
            REPORT_TEXT("report", "Start and end of the head are not those of the table; the table counts."));
    imported.remarks.assumption(
        "sign", REPORT_TEXT("report", "This is a compensation table, not a measurement: its values are read "
                                      "with the opposite sign as deviations, to compare."));
    const PassForm form = resolveForm(header, choices, imported.remarks);
    imported.test = testFrom(measurementOf({pass}, form, imported.remarks), "", choices);
    choices.resolve("kind", "positioning", Origin::recognised);
}

} // namespace

const ImportFormat renFormat{"ren", REPORT_TEXT("report", "compensation text"), "ren", isRenText,
                             readRenText};

} // namespace palmer
