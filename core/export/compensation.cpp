#include "export/compensation.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "import/numbercell.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

namespace palmer {

namespace {

constexpr std::size_t mostPoints = 100'000;
constexpr std::string_view csvMark = "# Palmer compensation";
constexpr std::string_view linuxcncMark = "# Palmer LinuxCNC compensation";

// Parts of a mm or degree that positions and values are rounded to.
double fineness(Motion motion) {
    return motion == Motion::linear ? 1e4 : 1e5;
}

constexpr double positionFineness = 1e6;

double rounded(double value, double parts) {
    return std::round(value * parts) / parts + 0.0; // no −0
}

[[noreturn]] void refuse(Text text, std::vector<Argument> arguments = {}) {
    throw Error(Error::Kind::content, {text, std::move(arguments)});
}

double interpolated(const std::vector<double> &x, const std::vector<double> &y, double at) {
    if (at <= x.front())
        return y.front();
    if (at >= x.back())
        return y.back();
    const auto i = static_cast<std::size_t>(std::ranges::upper_bound(x, at) - x.begin());
    const double part = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return y[i - 1] + part * (y[i] - y[i - 1]);
}

std::string shortest(double value) {
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr;
    return {digits.data(), end};
}

std::string withMark(std::string number, char mark) {
    std::ranges::replace(number, '.', mark);
    return number;
}

std::vector<double> positionsOf(const PositioningMeasurement &measurement, CompensationFormat format,
                                const CompensationOptions &options) {
    const double from = options.from.value_or(measurement.targets.front());
    const double to = options.to.value_or(measurement.targets.back());
    if (!(from < to) || !std::isfinite(from) || !std::isfinite(to))
        refuse(REPORT_TEXT("report", "the range of a compensation begins before it ends"));
    std::optional<double> interval = options.interval;
    if (!interval && format == CompensationFormat::siemens)
        interval =
            (to - from) / static_cast<double>(std::max<std::size_t>(measurement.targets.size(), 2) - 1);
    if (!interval && !options.from && !options.to)
        return measurement.targets;
    std::vector<double> positions;
    if (!interval) {
        positions.push_back(from);
        for (const double target : measurement.targets) {
            if (target > from && target < to)
                positions.push_back(target);
        }
        positions.push_back(to);
        return positions;
    }
    if (!(*interval > 0) || (to - from) / *interval > static_cast<double>(mostPoints))
        refuse(REPORT_TEXT("report",
                           "the interval of a compensation is positive and gives at most 100 000 points"));
    const auto steps = static_cast<std::size_t>(std::floor((to - from) / *interval + 1e-9));
    for (std::size_t i = 0; i <= steps; ++i)
        positions.push_back(rounded(from + static_cast<double>(i) * *interval, positionFineness));
    // A whole number of steps: a control that counts steps has no other; others get the end itself.
    if (format != CompensationFormat::siemens && to - positions.back() > 1e-6)
        positions.push_back(to);
    return positions;
}

// ---- reading

struct Line {
    std::string_view text;
    std::size_t number;
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

/// "key=value" of a comment.
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

CompensationTable readCsv(const std::vector<Line> &lines) {
    CompensationTable table;
    bool incremental = false;
    bool deviations = false;
    DecimalMark mark = DecimalMark::point;
    for (const Line &line : lines) {
        if (line.text.starts_with(csvMark)) {
            table.axis = noted(line.text, "axis").value_or("");
            table.motion = noted(line.text, "unit") == "deg" ? Motion::rotary : Motion::linear;
            table.perDirection = noted(line.text, "values") == "perDirection";
            incremental = noted(line.text, "form") == "incremental";
            deviations = noted(line.text, "sign") == "deviation";
            mark = noted(line.text, "decimalMark") == "comma" ? DecimalMark::comma : DecimalMark::point;
        }
        if (line.text.empty() || line.text.front() == '#' || line.text.starts_with("position"))
            continue;
        const auto cells = split(line.text, ';');
        if (cells.size() != (table.perDirection ? 3U : 2U))
            refuseLine(line);
        table.positions.push_back(numberOf(cells[0], mark, line));
        table.forward.push_back(numberOf(cells[1], mark, line));
        table.reverse.push_back(numberOf(cells.back(), mark, line));
    }
    const double parts = fineness(table.motion);
    for (auto *values : {&table.forward, &table.reverse}) {
        double sum = 0;
        for (double &value : *values) {
            sum = incremental ? sum + value : value;
            value = rounded(deviations ? -sum : sum, parts);
        }
    }
    return table;
}

CompensationTable readLinuxcnc(const std::vector<Line> &lines) {
    CompensationTable table;
    for (const Line &line : lines) {
        if (line.text.starts_with(linuxcncMark)) {
            table.axis = noted(line.text, "axis").value_or("");
            table.motion = noted(line.text, "unit") == "deg" ? Motion::rotary : Motion::linear;
            table.perDirection = noted(line.text, "values") == "perDirection";
        }
        if (line.text.empty() || line.text.front() == '#')
            continue;
        std::vector<double> numbers;
        for (std::string_view rest = line.text; !rest.empty(); rest = withoutBlanks(rest)) {
            const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
            numbers.push_back(numberOf(rest.substr(0, end), DecimalMark::point, line));
            rest.remove_prefix(end);
        }
        if (numbers.size() != 3)
            refuseLine(line);
        const double parts = fineness(table.motion);
        table.positions.push_back(numbers[0]);
        table.forward.push_back(rounded(numbers[0] - numbers[1], parts));
        table.reverse.push_back(rounded(numbers[0] - numbers[2], parts));
    }
    return table;
}

CompensationTable readSiemens(const std::vector<Line> &lines) {
    CompensationTable table;
    std::map<std::size_t, double> values;
    std::optional<double> step;
    std::optional<double> low;
    const auto value = [](const Line &line) {
        const std::string_view right = line.text.substr(line.text.find('=') + 1);
        return numberOf(right.substr(0, right.find(';')), DecimalMark::point, line);
    };
    for (const Line &line : lines) {
        if (line.text.find("unit=deg") != std::string_view::npos && line.text.front() == ';')
            table.motion = Motion::rotary;
        if (!line.text.starts_with("$AA_ENC_COMP") || line.text.find('=') == std::string_view::npos)
            continue;
        if (line.text.starts_with("$AA_ENC_COMP_STEP[")) {
            step = value(line);
        } else if (line.text.starts_with("$AA_ENC_COMP_MIN[")) {
            low = value(line);
        } else if (line.text.starts_with("$AA_ENC_COMP[")) {
            const std::size_t close = line.text.find(']');
            if (close == std::string_view::npos)
                refuseLine(line);
            const auto indexes = split(line.text.substr(13, close - 13), ',');
            if (indexes.size() != 3)
                refuseLine(line);
            const double index = numberOf(indexes[1], DecimalMark::point, line);
            if (index < 0 || index > static_cast<double>(mostPoints) || index != std::floor(index))
                refuseLine(line);
            table.axis = indexes[2];
            values[static_cast<std::size_t>(index)] = value(line);
        }
    }
    if (values.empty() || !step || !low || !(*step > 0))
        refuse(REPORT_TEXT("report", "the compensation table has no values, no step or no begin"));
    const double parts = fineness(table.motion);
    for (const auto &[index, deviation] : values) {
        table.positions.push_back(rounded(*low + static_cast<double>(index) * *step, positionFineness));
        table.forward.push_back(rounded(-deviation, parts));
        table.reverse.push_back(rounded(-deviation, parts));
    }
    return table;
}

} // namespace

double CompensationTable::correction(double position, Direction direction) const {
    if (positions.empty())
        return 0;
    return interpolated(positions, direction == Direction::positive ? forward : reverse, position);
}

CompensationTable compensationTable(const Test &test, const TestEvaluation &evaluation,
                                    CompensationFormat format, const CompensationOptions &options) {
    const auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
    const auto *results = std::get_if<PositioningResults>(&evaluation.results);
    if (!measurement || !results)
        refuse(REPORT_TEXT("report", "a compensation is made of a positioning test; this test is none"));
    if (measurement->targets.size() < 2)
        refuse(REPORT_TEXT("report", "a compensation needs two targets at least"));
    std::vector<double> forward;
    std::vector<double> reverse;
    for (std::size_t i = 0; i < measurement->targets.size(); ++i) {
        const TargetStatistics &target = results->targets[i];
        const double up = results->upward ? target.positive.mean : target.negative.mean;
        const double down = results->downward ? target.negative.mean : target.positive.mean;
        if (!std::isfinite(up) || !std::isfinite(down))
            refuse(REPORT_TEXT("report", "target %1 has no mean; a compensation needs one at every target"),
                   {Number{static_cast<double>(i + 1), Quantity::count}});
        forward.push_back(-(options.perDirection ? up : (up + down) / 2));
        reverse.push_back(-(options.perDirection ? down : (up + down) / 2));
    }
    CompensationTable table;
    table.axis = measurement->axis.name;
    table.motion = measurement->axis.motion;
    table.perDirection = options.perDirection;
    table.positions = positionsOf(*measurement, format, options);
    if (format == CompensationFormat::siemens && table.positions.size() < 2)
        refuse(REPORT_TEXT("report",
                           "the interval of a compensation is positive and gives at most 100 000 points"));
    const double parts = fineness(table.motion);
    for (const double position : table.positions) {
        table.forward.push_back(rounded(interpolated(measurement->targets, forward, position), parts));
        table.reverse.push_back(rounded(interpolated(measurement->targets, reverse, position), parts));
    }
    return table;
}

QByteArray writeCompensation(const CompensationTable &table, CompensationFormat format,
                             const CompensationOptions &options) {
    const char *const unit = table.motion == Motion::linear ? "mm" : "deg";
    const std::string axis = table.axis.empty() ? "X" : table.axis;
    const double parts = fineness(table.motion);
    std::string text;
    if (format != CompensationFormat::csv && (options.incremental || options.deviations))
        refuse(REPORT_TEXT("report",
                           "this format knows absolute values of one sign only; choose compensation-csv"));
    switch (format) {
    case CompensationFormat::linuxcnc:
        text = std::string(linuxcncMark) + " axis=" + axis + " unit=" + unit +
               " values=" + (table.perDirection ? "perDirection" : "combined") +
               "\n# COMP_FILE_TYPE = 0: nominal, actual going forward, actual going back\n";
        for (std::size_t i = 0; i < table.positions.size(); ++i) {
            const double p = table.positions[i];
            const double fine = std::max(parts, positionFineness);
            text += shortest(p) + ' ' + shortest(rounded(p - table.forward[i], fine)) + ' ' +
                    shortest(rounded(p - table.reverse[i], fine)) + '\n';
        }
        break;
    case CompensationFormat::siemens: {
        if (table.perDirection)
            refuse(REPORT_TEXT("report", "this format has one value a point; combine the directions, and "
                                         "state the reversal value as backlash"));
        const std::string head = std::to_string(options.encoder) + ',';
        text = "%_N_AX_EEC_INI\n; Palmer, unit=" + std::string(unit) +
               ", value = actual - target\nCHANDATA(1)\n";
        for (std::size_t i = 0; i < table.positions.size(); ++i)
            text += "$AA_ENC_COMP[" + head + std::to_string(i) + ',' + axis +
                    "]=" + shortest(rounded(-table.forward[i], parts)) + '\n';
        const double step = table.positions.size() > 1
                                ? rounded(table.positions[1] - table.positions[0], positionFineness)
                                : 1;
        text += "$AA_ENC_COMP_STEP[" + head + axis + "]=" + shortest(step) + "\n$AA_ENC_COMP_MIN[" + head +
                axis + "]=" + shortest(table.positions.front()) + "\n$AA_ENC_COMP_MAX[" + head + axis +
                "]=" + shortest(table.positions.back()) + "\n$AA_ENC_COMP_IS_MODULO[" + head + axis +
                "]=0\nM17\n";
        break;
    }
    case CompensationFormat::csv: {
        const char mark = options.decimalMark;
        text = std::string(csvMark) + " axis=" + axis + " unit=" + unit +
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
            text += withMark(shortest(table.positions[i]), mark) + ';' + withMark(shortest(forward), mark);
            if (table.perDirection)
                text += ';' + withMark(shortest(reverse), mark);
            text += '\n';
        }
        break;
    }
    }
    return QByteArray::fromStdString(text);
}

CompensationTable readCompensation(QByteArrayView bytes) {
    const std::string_view text(bytes.data(), static_cast<std::size_t>(bytes.size()));
    const std::vector<Line> lines = linesOf(text);
    CompensationTable table;
    if (text.find("$AA_ENC_COMP") != std::string_view::npos)
        table = readSiemens(lines);
    else if (text.starts_with(csvMark))
        table = readCsv(lines);
    else
        table = readLinuxcnc(lines);
    if (table.positions.empty())
        refuse(REPORT_TEXT("report", "the compensation table has no values, no step or no begin"));
    for (std::size_t i = 1; i < table.positions.size(); ++i) {
        if (!(table.positions[i] > table.positions[i - 1]))
            refuse(REPORT_TEXT("report", "the positions of a compensation table ascend"));
    }
    return table;
}

Test compensated(const Test &test, const CompensationTable &table) {
    Test result = test;
    if (auto *measurement = std::get_if<PositioningMeasurement>(&result.measurement)) {
        for (Run &run : measurement->runs) {
            for (std::size_t i = 0; i < run.deviations.size(); ++i) {
                if (run.deviations[i])
                    *run.deviations[i] += table.correction(measurement->targets[i], run.approach);
            }
        }
    }
    return result;
}

} // namespace palmer
