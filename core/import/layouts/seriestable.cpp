// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/tablereading.h"

#include "document/place.h"
#include "document/thermal.h"
#include "import/layouts/passes.h"
#include "import/notelabels.h"
#include "tables/contenterror.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace palmer {

namespace {

constexpr double secondsPerDay = 86'400;

class SeriesReader {
public:
    SeriesReader(TableReading &reading, bool temperatures)
        : m(reading)
        , m_temperatures(temperatures) {}

    void read() {
        chooseColumns();
        const auto layout = m.choices.resolve("layout", "series", Origin::recognised);
        if (layout.value != "series")
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 for values over time"),
                          nameOfChoice("layout"), nameOfWord("layout", layout.value));
        readTimes();
        if (m_temperatures)
            readTemperatures();
        else
            readDrift();
    }

private:
    void chooseColumns() {
        const TableBody &body = m.body;
        m_clock = body.columnOf(ColumnKind::clock);
        m_date = body.columnOf(ColumnKind::dates);
        m.result.columns = m.columnsAs({});
        m_time = m_clock ? *m_clock : timeColumn();
        m.result.columns[m_time].role = ColumnRole::time;
        chooseValues();
        if (auto chosen = m.resolveColumns(m.result.columns, m_question, RemarkGrade::problem))
            takeChosen(std::move(*chosen));
        if (m_values.empty())
            refuseContent(
                REPORT_TEXT("report", "one column of numbers is no series; expected times and values"));
        chooseSeries();
    }

    [[nodiscard]] std::size_t timeColumn() {
        const std::vector<std::size_t> columns = m.body.numberColumns();
        for (const std::size_t c : columns) {
            const TableColumn &column = m.body.columns[c];
            if (column.isTime())
                return c;
        }
        const bool counts = columns.size() > 2 && isCounter(m, columns.front());
        if (counts && m.body.columns[columns.front()].heading.empty())
            m_question = {REPORT_TEXT("report", "Columns: the first counts the "
                                                "lines and is not read; the times are those of the next.")};
        return columns[counts ? 1 : 0];
    }

    [[nodiscard]] bool statesLengthOrAngle(std::size_t column) const {
        const SaidUnit said = m.body.columns[column].said();
        return said.unit && (said.unit->kind == UnitKind::length || said.unit->kind == UnitKind::angle);
    }

    /// Takes the readings of the wanted kind and no others.
    void chooseValues() {
        std::vector<std::size_t> temperatures;
        std::vector<std::size_t> deviations;
        std::vector<std::size_t> others;
        for (const std::size_t c : m.body.numberColumns()) {
            const TableColumn &column = m.body.columns[c];
            if (c == m_time || column.meaning == Meaning::index || column.meaning == Meaning::time)
                continue;
            if (column.isTemperature())
                temperatures.push_back(c);
            else if (column.meaning == Meaning::deviation)
                deviations.push_back(c);
            else if (column.meaning != Meaning::statistic && column.meaning != Meaning::other &&
                     !(c < m_time && isCounter(m, c)))
                others.push_back(c);
        }
        for (const std::size_t c : temperatures)
            m.result.columns[c].role = ColumnRole::temperature;
        if (m_temperatures) {
            m_values = temperatures.empty() ? others : temperatures;
        } else {
            if (deviations.empty() && !temperatures.empty()) // "X (µm)", "Y (µm)"
                std::ranges::copy_if(others, std::back_inserter(deviations),
                                     [this](std::size_t c) { return statesLengthOrAngle(c); });
            m_values = !deviations.empty() ? deviations : others;
            m_heat = temperatures;
            if (m_values.size() > 1 && deviations.empty()) {
                m_question = {REPORT_TEXT("report", "Columns: several hold deviations; “%1” is read, the "
                                                    "others are a test of their own."),
                              {excerpt(m.body.columns[m_values.front()].heading)}};
                m_values.resize(1);
            }
        }
        for (const std::size_t c : m_values)
            m.result.columns[c].role = m_temperatures ? ColumnRole::temperature : ColumnRole::deviation;
    }

    void takeChosen(std::vector<ImportColumn> chosen) {
        m_values.clear();
        m_heat.clear();
        for (std::size_t c = 0; c < chosen.size(); ++c) {
            if (!m_temperatures && chosen[c].role == ColumnRole::temperature)
                m_heat.push_back(c);
            if (chosen[c].role == ColumnRole::time && !m_clock)
                m_time = c;
            if (chosen[c].role == (m_temperatures ? ColumnRole::temperature : ColumnRole::deviation) ||
                (!m_temperatures && chosen[c].hasReadings()))
                m_values.push_back(c);
        }
        m.result.columns = std::move(chosen);
    }

    /// How many names a column has, and those of at least two rows: a log begins with the last change of each
    /// variable, and one that does not change has no other.
    [[nodiscard]] std::pair<std::size_t, std::vector<std::string>> seriesNamedIn(std::size_t column) const {
        std::vector<std::string> names;
        std::vector<std::string> repeated;
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                std::string name(m.cellText(row, column));
                if (std::ranges::find(repeated, name) != repeated.end())
                    continue;
                if (std::ranges::find(names, name) != names.end())
                    repeated.push_back(std::move(name));
                else if (names.size() < 100)
                    names.push_back(std::move(name));
            }
        }
        const std::size_t count = names.size();
        if (!repeated.empty())
            std::erase_if(names, [&repeated](const std::string &name) {
                return std::ranges::find(repeated, name) == repeated.end();
            });
        return {count, std::move(names)};
    }

    /// Takes one of several process variables in a log.
    void chooseSeries() {
        for (std::size_t c = 0; c < m_time; ++c) {
            if (m.body.columns[c].kind != ColumnKind::words || !m_clock)
                continue;
            const auto [count, names] = seriesNamedIn(c);
            if (names.empty())
                continue;
            m_names = c;
            const std::string chosen(m.choices.chosen("series"));
            const bool isOne = std::ranges::find(names, chosen) != names.end();
            if (!chosen.empty() && !isOne) {
                std::string list;
                for (const std::string &name : names)
                    list += (list.empty() ? "" : ", ") + name;
                refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("series"),
                              chosen, excerpt(list));
            }
            m_series = isOne ? chosen : names.front();
            m.choices.resolve("series", m_series, count > 1 ? Origin::guessed : Origin::recognised);
            if (count < 2)
                return;
            m.remarks
                .assumption("series",
                            REPORT_TEXT("report", "Process variable: the file has %1; “%2” is read."),
                            counted(count), excerpt(m_series))
                .answers = names;
            return;
        }
    }

    [[nodiscard]] bool isOfOtherSeries(std::uint32_t row) const {
        return m_names && m.cellText(row, *m_names) != m_series;
    }

    /// Time in seconds: from clock and date, or from the column.
    [[nodiscard]] std::optional<double> timeOf(std::uint32_t row) {
        if (!m_clock)
            return m.number(row, m_time);
        auto time = clockTime(m.cellText(row, m_time));
        // "Time (mm:ss)": what would else be hours and minutes.
        const std::string form = folded(m.body.columns[m_time].heading);
        if (time && form.find("mm:ss") != std::string::npos && form.find("h:mm") == std::string::npos &&
            std::ranges::count(m.cellText(row, m_time), ':') == 1)
            *time /= 60;
        auto date = dayOf(m.cellText(row, m_time));
        if (!date && m_date)
            date = dayOf(m.cellText(row, *m_date));
        if (time && date) {
            *time += static_cast<double>(*date) * secondsPerDay;
            m_isDated = true;
        }
        return time;
    }

    /// "t min", "t/s": a time unit without brackets.
    [[nodiscard]] static SaidUnit lastWord(std::string_view heading) {
        const std::size_t before = heading.find_last_of(" /");
        if (before == std::string_view::npos)
            return {};
        SaidUnit said = saidUnit('(' + std::string(heading.substr(before + 1)) + ')');
        return said.unit && said.unit->kind == UnitKind::time ? said : SaidUnit{};
    }

    /// Settles the unit of the times; returns it in seconds.
    double resolveTimeUnit() {
        const TableColumn &column = m.body.columns[m_time];
        SaidUnit said = column.said();
        if (!said.isSaid())
            said = lastWord(column.heading);
        if (!said.isSaid())
            said = m.notes.timeUnit;
        if (!said.isSaid() && m.notes.interval && isCounter(m, m_time) && !column.isTime()) {
            m.remarks.note("timeUnit",
                           REPORT_TEXT("report", "Times: the lines are counted; they are %1 apart."),
                           Number{*m.notes.interval, Quantity::time});
            return *m.notes.interval;
        }
        const bool isTime = said.unit && said.unit->kind == UnitKind::time;
        // Milliseconds are a unit of files, not a choice.
        return resolveUnit(
                   "timeUnit", said, isTime ? said.unit : nullptr, *unitOf("s"),
                   {REPORT_TEXT("report", "Unit of the times: nothing in the file says it; read as %1.")},
                   m.choices, m.result.remarks)
            ->toBase(1);
    }

    void readTimes() {
        collectTimes(m_clock ? 1 : resolveTimeUnit());
        if (m_times.empty() || (m_times.size() < 2 && !m.choices.isChosen("layout")))
            refuseContent(
                REPORT_TEXT("report", "one column of numbers is no series; expected times and values"));
        const double first = m_times.front();
        if (m_isDated)
            m.result.seriesStart = first;
        for (double &time : m_times)
            time = m_clock ? time - first : time;
    }

    void collectTimes(double multiplier) {
        double turn = 0;
        std::optional<double> last;
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                if (isOfOtherSeries(row))
                    continue;
                std::optional<double> time = timeOf(row);
                if (!time)
                    continue;
                if (m_clock && !m_isDated && last && *time + turn < *last - secondsPerDay / 2)
                    turn += secondsPerDay; // past midnight
                *time = m_clock ? *time + turn : *time * multiplier;
                if (last && *time < *last)
                    refuseContentAt(
                        placeOfLine(m.row(row).line),
                        REPORT_TEXT("report", "the times do not rise; expected a series over time"));
                last = time;
                m_rows.push_back(row);
                m_times.push_back(*time);
                m.setRole(row, m_time, CellRole::position);
            }
        }
    }

    void readTemperatures() {
        m.choices.resolve("kind", "temperatures", Origin::recognised);
        bool air = false;
        for (const std::size_t column : m_values) {
            Sensor sensor;
            sensor.position = withoutUnit(m.body.columns[column].heading);
            sensor.measures = measuredBy(sensor.position);
            TemperatureSeries series;
            const std::vector<std::optional<double>> values = temperaturesOf(column);
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (values[i]) {
                    series.times.push_back(m_times[i]);
                    series.temperatures.push_back(*values[i]);
                }
            }
            if (series.times.empty())
                continue;
            // The editions refer to the environment.
            const bool ofAir = sensor.measures == SensorMeasures::air;
            air = air || ofAir;
            const auto gradient = ofAir ? gradientPerHour(series) : std::nullopt;
            if (gradient)
                m.result.gradientPerHour = std::max(m.result.gradientPerHour.value_or(0), *gradient);
            m.remarks.assumption({}, REPORT_TEXT("report", "Sensor “%1”: read as the temperature of the %2."),
                                 excerpt(sensor.position),
                                 sensor.measures == SensorMeasures::air ? REPORT_TEXT("report", "air")
                                 : sensor.measures == SensorMeasures::instrument
                                     ? REPORT_TEXT("report", "instrument")
                                     : REPORT_TEXT("report", "machine"));
            sensor.series = std::move(series);
            m.result.sensors.push_back(std::move(sensor));
        }
        if (m.result.gradientPerHour)
            m.remarks.note({}, REPORT_TEXT("report", "Largest change within an hour: %1."),
                           Number{*m.result.gradientPerHour, Quantity::gradient, 2});
        else
            m.remarks.note(
                {}, air ? REPORT_TEXT("report", "The series is shorter than an hour: no gradient per hour.")
                        : REPORT_TEXT("report", "No sensor is of the air: no gradient per hour."));
    }

    /// The unit of a column of deviations; the first column settles it for those that say none.
    const Unit *unitOfDeviations(std::size_t c, double most) {
        const TableColumn &column = m.body.columns[c];
        const SaidUnit said = column.said().isSaid() ? column.said() : m.notes.unit;
        const Unit *stated = said.unit;
        const bool known = stated && (stated->kind == UnitKind::length || stated->kind == UnitKind::angle);
        if (c != m_values.front() && known)
            return stated;
        const bool rotary = m.choices.isChosen("motion") ? m.choices.chosen("motion") == "rotary"
                                                         : known && stated->kind == UnitKind::angle;
        const char *guess = rotary ? "arcsec" : most < 0.5 ? "mm" : "um";
        return resolveUnit("unit", said, known ? stated : nullptr, *unitOf(guess),
                           {REPORT_TEXT("report", "Unit of the deviations: nothing in the "
                                                  "file says it; read as %1 after their size.")},
                           m.choices, m.result.remarks);
    }

    std::vector<std::optional<double>> numbersOf(std::size_t c) {
        std::vector<std::optional<double>> numbers;
        for (const std::uint32_t row : m_rows) {
            numbers.push_back(m.number(row, c));
            if (numbers.back())
                m.setRole(row, c, CellRole::positive);
        }
        return numbers;
    }

    /// The temperatures of a column in °C; empty if they are in no unit that is known.
    std::vector<std::optional<double>> temperaturesOf(std::size_t c) {
        const std::string &heading = m.body.columns[c].heading;
        SaidUnit said = m.body.columns[c].said();
        if (const std::size_t bracket = heading.find_last_of("([");
            !said.isSaid() && bracket != std::string::npos)
            said.unit = temperatureUnitIn(heading.substr(bracket));
        if (!said.isSaid())
            said = m.notes.temperatureUnit;
        if (said.isSaid() && !(said.unit && said.unit->kind == UnitKind::temperature)) {
            m.remarks.problem(
                "unread",
                REPORT_TEXT("report", "Temperatures in “%1” are not read, only those in °C, °F or K."),
                excerpt(said.words()));
            return {};
        }
        std::vector<std::optional<double>> values = numbersOf(c);
        std::size_t broken = 0;
        for (auto &value : values) {
            if (value && said.unit)
                value = said.unit->toBase(*value);
            broken += value && !isPlausibleTemperature(*value) ? 1 : 0;
        }
        if (broken > 0)
            m.remarks.problem("temperatures",
                              REPORT_TEXT("report",
                                          "“%1” has values that no room and no machine has: %2. Are the "
                                          "sensor and the unit right?"),
                              excerpt(heading), counted(broken));
        return values;
    }

    /// "X" of "X (µm)" and of "Deviation X"; else the heading.
    static std::string channelName(std::string_view heading) {
        std::string name = withoutUnit(heading);
        const std::size_t before = name.find_last_of(' ');
        if (before != std::string::npos && name.size() == before + 2 && name.back() >= 'A' &&
            name.back() <= 'Z')
            return name.substr(before + 1);
        return name;
    }

    /// "X", "Z2": a heading that is one names the axis; others are names of sensors.
    static bool isAxisName(const std::string &name) {
        return !name.empty() && std::string_view("XYZUVWABC").find(name[0]) != std::string_view::npos &&
               name.find_first_not_of("0123456789", 1) == std::string::npos;
    }

    /// Several channels, or temperatures beside one: all columns on the same times, gaps stay.
    void readChannels() {
        DriftMeasurement drift;
        drift.times = m_times;
        for (const std::size_t c : m_values) {
            DriftChannel channel;
            channel.name = channelName(m.body.columns[c].heading);
            channel.values = numbersOf(c);
            double most = 0;
            for (const auto &value : channel.values)
                most = std::max(most, std::abs(value.value_or(0)));
            const Unit *unit = unitOfDeviations(c, most);
            channel.quantity = unit->kind == UnitKind::angle ? ChannelQuantity::angularDeviation
                                                             : ChannelQuantity::deviation;
            for (auto &value : channel.values) {
                if (value)
                    value = unit->toBase(*value);
            }
            drift.channels.push_back(std::move(channel));
        }
        for (const std::size_t c : m_heat) {
            if (auto values = temperaturesOf(c); !values.empty())
                drift.temperatures.push_back({withoutUnit(m.body.columns[c].heading), {}, std::move(values)});
        }
        drift.axis.motion = drift.channels.front().quantity == ChannelQuantity::angularDeviation
                                ? Motion::rotary
                                : Motion::linear;
        const auto ofAxis = std::ranges::find_if(drift.channels, isAxisName, &DriftChannel::name);
        drift.axis.name =
            m.choices
                .resolve("axis",
                         m.notes.axis.empty() && ofAxis != drift.channels.end() ? ofAxis->name : m.notes.axis,
                         Origin::recognised)
                .value;
        nameOnlyChannel(drift);
        m.remarks.note(
            {},
            REPORT_TEXT("report", "Understood: a drift test; channels: %1; temperatures: %2; points: %3; "
                                  "duration: %4."),
            counted(drift.channels.size()), counted(drift.temperatures.size()), counted(drift.times.size()),
            Number{drift.times.back() - drift.times.front(), Quantity::time});
        finish(std::move(drift));
    }

    /// The day of the first reading is that of the test.
    void finish(DriftMeasurement drift) {
        Test test;
        test.measurement = std::move(drift);
        if (m_isDated)
            test.date = isoDate(m.cellText(m_rows.front(), m_date.value_or(m_time)));
        m.result.test = std::move(test);
    }

    void readDrift() {
        if (m_values.size() > 1 || !m_heat.empty())
            return readChannels();
        DriftMeasurement drift;
        std::vector<double> values;
        std::size_t missing = 0;
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            const auto value = m.number(m_rows[i], m_values.front());
            if (!value) {
                ++missing;
                continue;
            }
            drift.times.push_back(m_times[i]);
            values.push_back(*value);
            m.setRole(m_rows[i], m_values.front(), CellRole::positive);
        }
        if (values.empty())
            refuseContent(
                REPORT_TEXT("report", "there are no readings in it; expected times and deviations"));
        if (missing > 0)
            m.remarks.problem({}, REPORT_TEXT("report", "Points without a number were left out: %1."),
                              counted(missing));
        const auto [low, high] = std::ranges::minmax(values);
        const Unit *unit = unitOfDeviations(m_values.front(), std::max(std::abs(low), std::abs(high)));
        for (const double value : values)
            drift.deviations.push_back(unit->toBase(value));
        drift.axis.motion = unit->kind == UnitKind::angle ? Motion::rotary : Motion::linear;
        drift.axis.name = m.choices.resolve("axis", m.notes.axis, Origin::recognised).value;
        m.remarks.note({}, REPORT_TEXT("report", "Understood: a drift test; points: %1; duration: %2."),
                       counted(drift.times.size()),
                       Number{drift.times.back() - drift.times.front(), Quantity::time});
        finish(std::move(drift));
    }

    TableReading &m;
    bool m_temperatures;
    std::optional<std::size_t> m_clock;
    std::size_t m_time = 0;
    std::vector<std::size_t> m_values;
    std::vector<std::size_t> m_heat; ///< columns of temperatures beside deviations
    std::optional<std::size_t> m_date;
    std::optional<std::size_t> m_names; ///< column of process variable names
    std::string m_series;
    std::optional<Message> m_question;
    bool m_isDated = false;
    std::vector<std::uint32_t> m_rows;
    std::vector<double> m_times;
};

} // namespace

void readSeries(TableReading &reading, bool temperatures) {
    SeriesReader(reading, temperatures).read();
}

} // namespace palmer
