// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/driftreadings.h"

#include "document/thermal.h"
#include "editing/pastedtable.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <iterator>

namespace palmer {

void setDriftReadings(Test &test, std::size_t row, const std::vector<DriftReading> &readings) {
    auto *drift = std::get_if<DriftMeasurement>(&test.measurement);
    if (!drift || !drift->channels.empty())
        return;
    row = std::min(row, drift->times.size());
    const std::size_t end = std::max(drift->times.size(), row + readings.size());
    drift->times.resize(end);
    drift->deviations.resize(end);
    for (DriftTemperature &temperature : drift->temperatures)
        temperature.values.resize(end);
    for (const DriftReading &reading : readings) {
        drift->times[row] = reading.time;
        drift->deviations[row++] = reading.deviation;
    }
}

void removeDriftReadings(Test &test, std::size_t row, std::size_t count) {
    auto *drift = std::get_if<DriftMeasurement>(&test.measurement);
    if (!drift || row >= drift->times.size())
        return;
    count = std::min(count, drift->times.size() - row);
    const auto cut = [&](auto &values) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(row);
        values.erase(first, first + static_cast<std::ptrdiff_t>(count));
    };
    cut(drift->times);
    if (drift->channels.empty())
        cut(drift->deviations);
    for (DriftChannel &channel : drift->channels)
        cut(channel.values);
    for (DriftTemperature &temperature : drift->temperatures)
        cut(temperature.values);
    if (drift->times.empty() && !drift->channels.empty()) { // so that readings can be typed again
        drift->channels.clear();
        drift->temperatures.clear();
    }
}

void putDriftReadings(Test &test, std::size_t row, const DriftMeasurement &pasted) {
    auto *drift = std::get_if<DriftMeasurement>(&test.measurement);
    if (!drift)
        return;
    if (drift->channels.empty() && pasted.channels.empty()) {
        std::vector<DriftReading> readings;
        for (std::size_t i = 0; i < pasted.times.size(); ++i)
            readings.push_back({pasted.times[i], pasted.deviations[i]});
        return setDriftReadings(test, row, readings);
    }
    DriftMeasurement replaced = pasted;
    replaced.axis = drift->axis;
    replaced.settled = drift->settled;
    nameOnlyChannel(replaced);
    *drift = std::move(replaced);
}

PastedDrift driftReadingsFrom(const std::string &pasted, Motion motion, const DisplayUnits &units,
                              const ImportOptions &answers) {
    ImportOptions known{
        {"kind", "drift"}, {"layout", "series"}, {"motion", motion == Motion::linear ? "linear" : "rotary"}};
    known.insert(answers.begin(), answers.end());
    const Imported imported = readPastedTable(pasted, known, usualUnits(motion, units));
    PastedDrift result;
    result.questions = doubtsOf(imported);
    std::ranges::copy_if(imported.choices, std::back_inserter(result.units), [](const ImportChoice &choice) {
        return choice.key == "unit" || choice.key == "timeUnit";
    });
    result.remarks = remarksOfPaste(imported);
    const auto &drift = std::get<DriftMeasurement>(imported.test->measurement);
    if (drift.axis.motion != motion)
        refuseContent(REPORT_TEXT("report", "the unit of the readings is not one of this axis"));
    result.drift = drift;
    result.taken = drift.times.size();
    return result;
}

} // namespace palmer
