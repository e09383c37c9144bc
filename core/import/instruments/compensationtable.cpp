// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/instruments/compensationtable.h"

#include "import/layouts/sections.h"
#include "import/readers.h"
#include "tables/contenterror.h"
#include "tables/decodetext.h"
#include "tables/numbercell.h"

#include <QRegularExpression>
#include <QString>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

double interpolated(const std::vector<double> &x, const std::vector<double> &y, double at) {
    if (at <= x.front())
        return y.front();
    if (at >= x.back())
        return y.back();
    const auto i = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
    const double part = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return y[i - 1] + part * (y[i] - y[i - 1]);
}

std::vector<std::string_view> firstLines(std::string_view text) {
    constexpr std::size_t enough = 200; // skips comments at the beginning
    std::vector<std::string_view> lines;
    for (const TextLine &each : linesOf(text)) {
        if (const auto line = withoutBlanks(each.text); !line.empty() && lines.size() < enough)
            lines.push_back(line);
    }
    return lines;
}

bool anyLine(std::string_view text, bool (*is)(std::string_view upperCaseLine)) {
    return std::ranges::any_of(firstLines(text), [is](std::string_view line) { return is(upperCase(line)); });
}

bool isSinumerik(std::string_view text) {
    return anyLine(text, [](std::string_view line) {
        return line.starts_with("$AA_ENC_COMP") || line.starts_with("$AN_CEC");
    });
}

bool isHeidenhain(std::string_view text) {
    const auto lines = firstLines(text);
    const std::string first = lines.empty() ? std::string() : upperCase(lines.front());
    const std::size_t ending = first.find(".COM");
    const bool begins = first.starts_with("BEGIN ") && ending != std::string::npos &&
                        (ending + 4 == first.size() || first[ending + 4] == ' ');
    return begins || anyLine(text, [](std::string_view line) {
               return line.find("AXISPOS") != std::string_view::npos;
           });
}

/// True for `unit = mm`, then an axis name in square brackets, then triplets with commas.
bool isWeihong(std::string_view text) {
    bool unit = false;
    bool axis = false;
    for (const std::string_view line : firstLines(text)) {
        std::string plain = upperCase(line);
        std::erase_if(plain, [](char c) { return c == ' ' || c == '\t'; });
        if (plain == "UNIT=MM" || plain == ";UNIT=MM")
            unit = true;
        else if (plain.size() == 3 && plain.front() == '[' && plain.back() == ']')
            axis = unit;
        else if (axis && !plain.starts_with(';'))
            return std::ranges::count(plain, ',') == 2;
    }
    return false;
}

/// True for the display ND 287: "COMP.N0.000 = +0.0000 = +0.0000".
bool isNd287(std::string_view text) {
    return anyLine(text, [](std::string_view line) {
        return line.starts_with("COMP.N") && std::ranges::count(line, '=') == 2;
    });
}

/// True for FANUC pitch error data, N10000 to N11023: "N10001 P12", "N10001 Q1 A1 P12".
bool isFanuc(std::string_view text) {
    static const QRegularExpression data(
        QStringLiteral(R"(^N1(?:0\d{3}|10[01]\d|102[0-3])\s*(?:Q\d+\s*)?(?:A\d+\s*)?P\s*-?\d+$)"));
    const auto lines = firstLines(text);
    const auto punched = std::ranges::count_if(lines, [](std::string_view line) {
        return data.match(QString::fromStdString(upperCase(line))).hasMatch();
    });
    return punched >= 2 && 2 * punched >= static_cast<std::ptrdiff_t>(lines.size());
}

/// Numbers of a line separated by commas or blanks; empty if the line contains anything else.
std::vector<double> numbersOf(std::string_view line) {
    std::vector<double> numbers;
    while (!line.empty()) {
        const LeadingNumber number = leadingNumber(line, DecimalMark::point);
        if (number.size == 0 || (number.size < line.size() &&
                                 std::string_view(" \t,").find(line[number.size]) == std::string_view::npos))
            return {};
        numbers.push_back(number.value);
        line = withoutBlanks(line.substr(number.size));
        if (line.starts_with(','))
            line = withoutBlanks(line.substr(1));
    }
    return numbers;
}

/// True for a KMotion grid: rows and columns, spacings, with or without offsets, then row, column and the
/// point to command, from 0,0 on.
bool isKMotion(std::string_view text) {
    const auto lines = firstLines(text);
    std::size_t at = 0;
    for (; at < lines.size() && numbersOf(lines[at]).size() == 2; ++at) {
    }
    if (at < 2 || at > 3 || at == lines.size())
        return false;
    const auto size = numbersOf(lines.front());
    const auto isSize = [](double n) { return n >= 2 && n <= 4000 && n == std::floor(n); };
    const auto first = numbersOf(lines[at]);
    return std::ranges::all_of(size, isSize) && first.size() >= 4 && first[0] == 0 && first[1] == 0 &&
           std::ranges::all_of(lines.begin() + static_cast<std::ptrdiff_t>(at), lines.end(),
                               [&](std::string_view line) { return numbersOf(line).size() == first.size(); });
}

bool isAerotech(std::string_view text) {
    return anyLine(text, [](std::string_view line) {
        return line.starts_with(":START ") || line.starts_with(":START2D ");
    });
}

bool isOwn(std::string_view text) {
    return text.starts_with("# Palmer compensation") || text.starts_with("# Palmer LinuxCNC compensation");
}

struct Control {
    const char *name = nullptr;
    bool (*recognises)(std::string_view text) = nullptr;
    FoundTable (*read)(std::string_view text) = nullptr; ///< null: its rules are not read here
};

constexpr std::array controls{
    Control{"SINUMERIK", isSinumerik, readSinumerikTable},
    Control{"Heidenhain", isHeidenhain, readHeidenhainTable},
    Control{"Weihong", isWeihong, [](std::string_view text) { return readWeihongTable(text, false); }},
    Control{"Aerotech", isAerotech},
    // Written for LinuxCNC with a comment on top.
    Control{"Palmer", isOwn,
            [](std::string_view text) { return readLinuxcncTable(text, LinuxcncValues::positions); }},
    Control{"ND 287", isNd287},
    Control{"FANUC", isFanuc},
    Control{"KMotion", isKMotion},
};

const Control *controlOf(std::string_view text) {
    const auto *const found =
        std::ranges::find_if(controls, [text](const Control &each) { return each.recognises(text); });
    return found == controls.end() ? nullptr : found;
}

/// True if every line has three numbers separated by blanks.
bool isTriplets(std::string_view text) {
    const auto lines = firstLines(text);
    return !lines.empty() && std::ranges::all_of(lines, [](std::string_view line) {
        return line.find(',') == std::string_view::npos && numbersOf(line).size() == 3;
    });
}

/// The ending that only controls give their tables; empty for other names.
QLatin1StringView endingOfTable(QStringView fileName) {
    constexpr std::array endings{QLatin1StringView(".comp"), QLatin1StringView(".com"),
                                 QLatin1StringView(".cmp"), QLatin1StringView(".cal"),
                                 QLatin1StringView("axeserr.dat")};
    const auto *const found = std::ranges::find_if(endings, [fileName](QLatin1StringView ending) {
        return fileName.endsWith(ending, Qt::CaseInsensitive);
    });
    return found == endings.end() ? QLatin1StringView() : *found;
}

/// The beginning of a text without its byte order mark; UTF-16 is converted to UTF-8.
std::string textOf(QByteArrayView bytes) {
    constexpr qsizetype enough = qsizetype(1) << 16;
    const std::string_view text(bytes.data(), static_cast<std::size_t>(bytes.size()));
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        try {
            return decodeText(bytes.first(std::min(bytes.size() / 2 * 2, enough))).text;
        } catch (const Error &) {
            return {}; // not text
        }
    }
    return std::string(text.starts_with("\xEF\xBB\xBF") ? text.substr(3, enough) : text.substr(0, enough));
}

[[noreturn]] void refuseUnknownTable() {
    refuseAs(Error::Kind::format,
             REPORT_TEXT("report", "this is no compensation table of a control that is known here"));
}

/// Decides whether the second and third numbers are positions near the first, or small trims.
LinuxcncValues valuesOf(std::string_view text) {
    const FoundTable positions = readLinuxcncTable(text, LinuxcncValues::positions);
    const FoundTable trims = readLinuxcncTable(text, LinuxcncValues::trims);
    const auto size = [](const std::vector<double> &values) {
        double sum = 0;
        for (const double value : values)
            sum += std::abs(value);
        return sum;
    };
    return size(positions.table.forward) <= size(trims.table.forward) ? LinuxcncValues::positions
                                                                      : LinuxcncValues::trims;
}

} // namespace

double CompensationTable::correction(double position, Direction direction) const {
    if (positions.empty())
        return 0;
    if (period && *period > 0)
        position -= std::floor((position - positions.front()) / *period) * *period;
    return interpolated(positions, direction == Direction::positive ? forward : reverse, position);
}

const char *controlOfTable(QByteArrayView bytes, QStringView fileName) {
    const std::string text = textOf(bytes);
    if (const Control *control = controlOf(text))
        return control->name;
    return !endingOfTable(fileName).isEmpty() && isTriplets(text) ? "LinuxCNC" : nullptr;
}

FoundTable readControlTable(QByteArrayView bytes, QStringView fileName) {
    const std::string text = decodeText(bytes).text;
    if (const Control *control = controlOf(textOf(bytes))) {
        if (control->read)
            return control->read(text);
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report", "the rules of this compensation table (%1) are not read here"),
                 std::string(control->name));
    }
    if (!controlOfTable(bytes, fileName) && !isTriplets(text)) // a file given for comparison is a table
        refuseUnknownTable();
    const LinuxcncValues values = valuesOf(text);
    FoundTable found = readLinuxcncTable(text, values);
    found.remarks.push_back(
        {REPORT_TEXT("report", "its values are taken for COMP_FILE_TYPE %1; the file does not say it"),
         {std::string(values == LinuxcncValues::positions ? "0" : "1")}});
    return found;
}

void refuseCompensationTable(QByteArrayView bytes, const QString &fileName) {
    if (const char *const control = controlOfTable(bytes, fileName))
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report",
                             "this is a compensation table (%1), not a measurement; compare it with a "
                             "test: export --compare, or “Compensation table…” in the window"),
                 std::string(control));
    if (const QLatin1StringView ending = endingOfTable(fileName); !ending.isEmpty())
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report",
                             "a file of this name (%1) is a compensation table, perhaps cut off, and "
                             "no measurement; if it is one, rename it, for example to .txt"),
                 std::string(ending.data(), static_cast<std::size_t>(ending.size())));
}

namespace {

bool isCompensationTable(QByteArrayView bytes) {
    return controlOfTable(bytes, {}) != nullptr;
}

/// Always throws: a compensation table is no measurement; the message says how to compare it with one.
void readCompensationTable(const ImportSource &source, Choices & /*choices*/, Imported & /*imported*/) {
    refuseCompensationTable(source.bytes, {});
    refuseUnknownTable();
}

} // namespace

const ImportFormat compensationFormat{"compensation", {}, "", isCompensationTable, readCompensationTable};

} // namespace palmer
