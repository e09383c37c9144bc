// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/place.h"
#include "import/instruments/datanumbers.h"
#include "import/instruments/otherlines.h"
#include "import/layouts/passes.h"
#include "import/layouts/phrases.h"
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
    std::optional<double> spacing = {};
    std::optional<double> start = {};
    std::optional<double> end = {};
    std::optional<double> reference = {};
    SaidUnit positionUnit = {};
    SaidUnit resolution = {}; ///< the unit in which the values count
    bool ended = false;       ///< true: the table begins
    OtherLines others = {};
};

/// The value of a resolution other than 1 is a factor of the readings.
SaidUnit resolutionOf(std::string_view line) {
    const std::string_view value = line.substr(std::min(line.find_first_of(":=") + 1, line.size()));
    const SaidUnit said = saidUnit(line);
    return said.unit && lastNumber(value) == 1 ? said : SaidUnit{nullptr, excerpt(line)};
}

void refuseIncrements(std::string_view line, std::size_t number) {
    if (containsWord(line.substr(0, line.find_first_of(":=")), "calculation") &&
        containsWord(line, "increment"))
        refuseContentAt(placeOfLine(number),
                        REPORT_TEXT("report", "the table holds increments from one position to the next, not "
                                              "values at the positions; save it as an absolute table"));
}

void readHead(std::string_view line, std::size_t number, Header &header) {
    struct Key {
        const char *words;
        std::optional<double> Header::*value;
    };
    constexpr std::array rows{
        Key{"Compensation spacing", &Header::spacing}, Key{"Compensation start", &Header::start},
        Key{"Compensation end", &Header::end}, Key{"Reference position", &Header::reference}};
    refuseIncrements(line, number);
    const auto *const key =
        std::ranges::find_if(rows, [&](const Key &row) { return containsWord(line, row.words); });
    const auto value = key == rows.end() ? std::nullopt : lastNumber(line);
    if (value) {
        header.*key->value = value;
        header.positionUnit = unitOfBoth(header.positionUnit, saidUnit(line));
    } else if (containsWord(line, "Compensation resolution")) {
        header.resolution = resolutionOf(line);
    } else if (containsWord(line, "Axis position")) {
        header.ended = true;
    } else {
        header.others.add(number, line);
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

/// True if start and end are those of the table, in either order.
bool agrees(const Header &header, double low, double high) {
    const bool startAgrees = !header.start ||
                             std::min(*header.start, header.end.value_or(*header.start)) == low ||
                             *header.start == low || *header.start == high;
    return startAgrees && (!header.end || *header.end == high || *header.end == low);
}

/// Reads the table, and the lines above it into `header`. Remarks: damaged and missing lines.
Pass readTable(Imported &imported, DataNumbers &data, Header &header) {
    Pass pass;
    double lastNo = 0;
    bool follows = false; // a line that was read
    for (const auto &[whole, number] : linesOf(imported.text)) {
        const std::string_view line = withoutBlanks(whole);
        if (line.empty())
            continue;
        const auto numbers = header.ended ? data.in(line, number) : std::nullopt;
        if (!header.ended || (!numbers && !isDamagedLine(line))) {
            readHead(line, number, header);
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
    return pass;
}

SaidSign signOf(const FileNotes &notes) {
    SaidSign said = notes.sign;
    if (said.sign.empty() && containsWord(said.words, "error"))
        said.sign = "actualMinusTarget";
    else if (said.sign.empty() &&
             (containsWord(said.words, "compens") || containsWord(said.words, "correct")))
        said.sign = "targetMinusActual";
    return said;
}

PassForm resolveForm(const Header &header, const FileNotes &notes, Choices &choices, Remarks &remarks) {
    constexpr std::string_view usual = "targetMinusActual";
    PassForm form;
    const SaidSign sign = signOf(notes);
    if (sign.words.empty() || sign.sign == usual)
        remarks.assumption(
            "sign", REPORT_TEXT("report", "This is a compensation table, not a measurement: its values are "
                                          "read with the opposite sign as deviations, to compare."));
    form.sign = resolveSaidSign(sign, usual, Origin::guessed, choices, remarks);
    const SaidUnit &position = header.positionUnit.isSaid() ? header.positionUnit : notes.positionUnit;
    const bool isAngle = position.unit && position.unit->kind == UnitKind::angle;
    const bool isScaled = !header.resolution.foreign.empty();
    const SaidUnit &said = isScaled || !notes.unit.isSaid() ? header.resolution : notes.unit;
    form.unit = resolveUnit(
        "unit", said, said.unit && (isAngle || said.unit->kind == UnitKind::length) ? said.unit : nullptr,
        *unitOf(isAngle ? "arcsec" : "um"),
        {REPORT_TEXT("report", "Unit of the compensation values: nothing in the file says it; read as %1.")},
        choices, remarks);
    form.positionUnit =
        resolveStatedUnit("positionUnit", position,
                          *unitOf(form.unit->kind == UnitKind::angle ? "deg" : "mm"), choices, remarks);
    requireOneMotion(form);
    return form;
}

/// The direction of the table; if a line names one, it is to be confirmed.
Direction resolveDirection(const OtherLines &others, Choices &choices, Remarks &remarks) {
    if (others.direction().empty() && !choices.isChosen("directions"))
        return Direction::positive;
    const bool isNegative = readHeading(others.direction()).direction == Direction::negative;
    const auto choice = choices.resolve("directions", isNegative ? "negative" : "positive", Origin::guessed);
    if (choice.origin == Origin::guessed)
        remarks.problem("directions",
                        choice.value == "negative"
                            ? REPORT_TEXT("report", "Directions: the file says “%1”; read as ↓.")
                            : REPORT_TEXT("report", "Directions: the file says “%1”; read as ↑."),
                        excerpt(others.direction()));
    return choice.value == "negative" ? Direction::negative : Direction::positive;
}

bool isRenText(QByteArrayView bytes) {
    const std::string_view text(bytes.data(),
                                static_cast<std::size_t>(std::min<qsizetype>(bytes.size(), 8192)));
    return containsWord(text, "Compensation spacing") || containsWord(text, "Compensation start");
}

void readRenText(const ImportSource &source, Choices &choices, Imported &imported) {
    imported.text = decodedText(source.bytes, choices, imported);
    DataNumbers data(imported.text, choices);
    Header header;
    Pass pass = readTable(imported, data, header);
    if (pass.readings.empty())
        refuseContent(
            REPORT_TEXT("report", "there is no table of axis positions and compensation values in it"));
    const auto [low, high] = std::ranges::minmax(pass.readings, {}, &PassReading::position);
    if (!agrees(header, low.position, high.position))
        imported.remarks.problem(
            {},
            REPORT_TEXT("report", "Start and end of the head are not those of the table; the table counts."));
    const FileNotes notes = header.others.notes();
    pass.direction = resolveDirection(header.others, choices, imported.remarks);
    const PassForm form = resolveForm(header, notes, choices, imported.remarks);
    header.others.askForKind(
        {}, REPORT_TEXT("report", "Kind: the file speaks of “%1”; read as a positioning test."),
        imported.remarks);
    imported.test =
        testFrom(measurementOf({pass}, form, imported.remarks), notes.axis, choices, notes.edition);
    data.remark(imported.remarks);
    takeNotes(notes, imported);
    choices.resolve("kind", "positioning", Origin::recognised);
}

} // namespace

const ImportFormat renFormat{"ren", REPORT_TEXT("report", "compensation text"), "ren", isRenText,
                             readRenText};

} // namespace palmer
