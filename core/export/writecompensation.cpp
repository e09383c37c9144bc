// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/documenterror.h"
#include "document/place.h"
#include "export/compensation.h"
#include "tables/decodetext.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

// Compensation tables as files: written by the rules of each control; our own CSV is also read.

namespace palmer {

namespace {

constexpr std::string_view csvMark = "# Palmer compensation";

[[noreturn]] void refuseTable(Text text, std::vector<Argument> arguments = {}) {
    throw Error(Error::Kind::content, {text, std::move(arguments)});
}

std::string withoutExponent(double value) {
    std::array<char, 400> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
    return {digits.data(), end};
}

std::string withMark(std::string number, char mark) {
    std::ranges::replace(number, '.', mark);
    return number;
}

const char *unitOf(const CompensationTable &table) {
    return table.motion == Motion::linear ? "mm" : "deg";
}

std::string writeLinuxcnc(const CompensationTable &table) {
    std::string text; // no comments: the control stops at the first line that is not a triplet
    for (std::size_t i = 0; i < table.positions.size(); ++i) {
        const double position = table.positions[i];
        text += withoutExponent(position) + ' ' +
                withoutExponent(rounded(position - table.forward[i], positionFineness)) + ' ' +
                withoutExponent(rounded(position - table.reverse[i], positionFineness)) + '\n';
    }
    return text;
}

/// Throws unless a control could use this axis name: a letter, then letters and digits.
void requireIdentifier(const std::string &name) {
    constexpr std::size_t longest = 32;
    const auto isLetter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    if (name.empty())
        refuseTable(REPORT_TEXT("report",
                                "the axis of this test has no name; the table needs the one that the "
                                "control knows"));
    if (!isLetter(name[0]) || name.size() > longest ||
        !std::ranges::all_of(name, [&](char c) { return isLetter(c) || (c >= '0' && c <= '9'); }))
        refuseTable(REPORT_TEXT("report",
                                "the axis “%1” cannot be one of a SINUMERIK: a name is a letter with letters "
                                "and digits behind it"),
                    {excerpt(name)});
}

std::string writeSiemens(const CompensationTable &table, const CompensationOptions &options) {
    requireIdentifier(table.axis);
    if (options.encoder != 0 && options.encoder != 1)
        refuseTable(
            REPORT_TEXT("report", "a SINUMERIK has the measuring systems 0 and 1 of an axis; there is no %1"),
            {Number{static_cast<double>(options.encoder), Quantity::count}});
    const auto &positions = table.positions;
    const std::string of = '[' + std::to_string(options.encoder) + ',' + table.axis + "]";
    const double step = positions.size() > 1 ? rounded(positions[1] - positions[0], positionFineness) : 1;
    std::string text =
        "%_N_AX_EEC_INI\n; Palmer, unit=" + std::string(unitOf(table)) +
        ", value = actual - target, reference=" + withoutExponent(options.reference.value_or(0));
    if (table.measured)
        text += ", measured=" + withoutExponent(table.measured->from) + ".." +
                withoutExponent(table.measured->to);
    text += "\n; MD38000 $MA_MM_ENC_COMP_MAX_POINTS" + of + " >= " + std::to_string(positions.size()) +
            "\nCHANDATA(1)\n";
    for (std::size_t i = 0; i < positions.size(); ++i)
        text += "$AA_ENC_COMP[" + std::to_string(options.encoder) + ',' + std::to_string(i) + ',' +
                table.axis + "]=" + withoutExponent(0.0 - table.forward[i]) + '\n';
    return text + "$AA_ENC_COMP_STEP" + of + '=' + withoutExponent(step) + "\n$AA_ENC_COMP_MIN" + of + '=' +
           withoutExponent(positions.front()) + "\n$AA_ENC_COMP_MAX" + of + '=' +
           withoutExponent(positions.back()) + "\n$AA_ENC_COMP_IS_MODULO" + of + '=' +
           (table.period ? "1" : "0") + "\nM17\n";
}

std::string writeWeihong(const CompensationTable &table, const CompensationOptions &options) {
    std::string axis = table.axis;
    if (axis.size() == 1 && axis[0] >= 'x' && axis[0] <= 'z')
        axis[0] = static_cast<char>(axis[0] - 32);
    if (axis != "X" && axis != "Y" && axis != "Z")
        refuseTable(REPORT_TEXT("report", "axeserr.dat knows the axes X, Y and Z only, not “%1”"),
                    {excerpt(axis)});
    const double sign = options.deviations ? -1 : 1;
    std::string text = "unit = mm\n[" + axis + "]\n";
    for (std::size_t i = 0; i < table.positions.size(); ++i)
        text += withoutExponent(table.positions[i]) + ", " + withoutExponent(sign * table.forward[i] + 0.0) +
                ", " + withoutExponent(sign * table.reverse[i] + 0.0) + '\n';
    return text;
}

// ---- our own CSV

/// The axis name as one word of the head.
std::string oneWord(std::string name) {
    std::ranges::replace_if(
        name, [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
    return name;
}

std::string writeCsv(const CompensationTable &table, const CompensationOptions &options) {
    const double parts = table.motion == Motion::linear ? 1e4 : 1e5;
    const char mark = options.decimalMark;
    std::string text = std::string(csvMark) + " axis=" + oneWord(table.axis) + " unit=" + unitOf(table) +
                       " values=" + (table.perDirection ? "perDirection" : "combined") +
                       " form=" + (options.incremental ? "incremental" : "absolute") +
                       " sign=" + (options.deviations ? "deviation" : "correction") +
                       " decimalMark=" + (mark == ',' ? "comma" : "point") + '\n';
    text += table.perDirection ? "position;forward;reverse\n" : "position;value\n";
    double lastForward = 0;
    double lastReverse = 0;
    const double sign = options.deviations ? -1 : 1;
    for (std::size_t i = 0; i < table.positions.size(); ++i) {
        const double forward = rounded(sign * (table.forward[i] - lastForward), parts);
        const double reverse = rounded(sign * (table.reverse[i] - lastReverse), parts);
        if (options.incremental) {
            lastForward = table.forward[i];
            lastReverse = table.reverse[i];
        }
        text += withMark(withoutExponent(table.positions[i]), mark) + ';' +
                withMark(withoutExponent(forward), mark);
        if (table.perDirection)
            text += ';' + withMark(withoutExponent(reverse), mark);
        text += '\n';
    }
    return text;
}

struct Line {
    std::string_view text;
    std::size_t number = 0;
};

std::vector<Line> linesOf(std::string_view text) {
    std::vector<Line> lines;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        lines.push_back({withoutBlanks(text.substr(at, end - at)), ++number});
        at = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    }
    return lines;
}

[[noreturn]] void refuseLine(const Line &line) {
    throw Error(Error::Kind::content,
                {REPORT_TEXT("report", "“%1” is no line of a compensation table"), {excerpt(line.text)}},
                std::to_string(line.number) + ":1");
}

double numberOf(std::string_view text, DecimalMark mark, const Line &line) {
    const CellValue value = readCell(text, mark);
    if (value.kind != CellKind::number)
        refuseLine(line);
    return value.value;
}

/// Value of "key=value" in a comment.
std::optional<std::string> noted(std::string_view comment, std::string_view key) {
    const std::string wanted = ' ' + std::string(key) + '=';
    const std::size_t at = comment.find(wanted);
    if (at == std::string_view::npos)
        return {};
    const std::string_view rest = comment.substr(at + wanted.size());
    return std::string(rest.substr(0, rest.find(' ')));
}

std::vector<std::string_view> split(std::string_view text, char delimiter) {
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t end = text.find(delimiter);
        cells.push_back(withoutBlanks(text.substr(0, end)));
        if (end == std::string_view::npos)
            return cells;
        text.remove_prefix(end + 1);
    }
}

struct CsvForm {
    bool incremental = false;
    bool deviations = false;
    DecimalMark mark = DecimalMark::point;
};

CsvForm readCsvHead(const Line &line, CompensationTable &table) {
    table.axis = noted(line.text, "axis").value_or("");
    table.motion = noted(line.text, "unit") == "deg" ? Motion::rotary : Motion::linear;
    table.perDirection = noted(line.text, "values") == "perDirection";
    return {noted(line.text, "form") == "incremental", noted(line.text, "sign") == "deviation",
            noted(line.text, "decimalMark") == "comma" ? DecimalMark::comma : DecimalMark::point};
}

void readCsvRow(const Line &line, DecimalMark mark, CompensationTable &table) {
    const auto cells = split(line.text, ';');
    if (cells.size() != (table.perDirection ? 3U : 2U))
        refuseLine(line);
    const double position = numberOf(cells[0], mark, line);
    if (!table.positions.empty() && !(position > table.positions.back()))
        refuseTable(REPORT_TEXT("report", "the positions of a compensation table ascend"));
    table.positions.push_back(position);
    table.forward.push_back(numberOf(cells[1], mark, line));
    table.reverse.push_back(numberOf(cells.back(), mark, line));
}

CompensationTable readCsv(std::string_view text) {
    CompensationTable table;
    CsvForm form;
    for (const Line &line : linesOf(text)) {
        if (line.text.starts_with(csvMark))
            form = readCsvHead(line, table);
        if (!line.text.empty() && line.text.front() != '#' && !line.text.starts_with("position"))
            readCsvRow(line, form.mark, table);
    }
    if (table.positions.empty())
        refuseTable(REPORT_TEXT("report", "the compensation table has no values, no step or no begin"));
    const double parts = table.motion == Motion::linear ? 1e4 : 1e5;
    for (auto *values : {&table.forward, &table.reverse}) {
        double sum = 0;
        for (double &value : *values) {
            sum = form.incremental ? sum + value : value;
            value = rounded(form.deviations ? -sum : sum, parts);
        }
    }
    return table;
}

} // namespace

QByteArray writeCompensation(const CompensationTable &table, CompensationFormat format,
                             const CompensationOptions &options) {
    switch (format) {
    case CompensationFormat::linuxcnc:
        return QByteArray::fromStdString(writeLinuxcnc(table));
    case CompensationFormat::siemens:
        return QByteArray::fromStdString(writeSiemens(table, options));
    case CompensationFormat::weihong:
        return QByteArray::fromStdString(writeWeihong(table, options));
    case CompensationFormat::csv:
        break;
    }
    return QByteArray::fromStdString(writeCsv(table, options));
}

CompensationTable readCompensation(QByteArrayView bytes, CompensationFormat format,
                                   const CompensationOptions &options) {
    const std::string_view text(bytes.data(), static_cast<std::size_t>(bytes.size()));
    switch (format) {
    case CompensationFormat::linuxcnc:
        return readLinuxcncTable(text, LinuxcncValues::positions).table;
    case CompensationFormat::siemens:
        return readSinumerikTable(text).table;
    case CompensationFormat::weihong:
        return readWeihongTable(text, options.deviations).table;
    case CompensationFormat::csv:
        break;
    }
    return readCsv(text);
}

FoundTable readFoundTable(QByteArrayView bytes, QStringView fileName) {
    const std::string text = decodeText(bytes).text;
    if (text.starts_with(csvMark))
        return {"Palmer CSV", readCsv(text), {}};
    return readControlTable(bytes, fileName);
}

} // namespace palmer
