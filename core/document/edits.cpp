// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/edits.h"

#include <algorithm>

namespace palmer {
namespace {

/// Returns the index of that sensor in the list; the size of the list if there is none.
std::size_t indexOf(const Conditions &conditions, SensorMeasures what, std::size_t ordinal) {
    std::size_t seen = 0;
    for (std::size_t i = 0; i < conditions.sensors.size(); ++i) {
        if (conditions.sensors[i].measures == what && seen++ == ordinal)
            return i;
    }
    return conditions.sensors.size();
}

void eraseAt(auto &list, std::size_t index) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

bool isTaken(const Document &document, const std::string &id) {
    return std::ranges::find(document.instruments, id, &Instrument::id) != document.instruments.end();
}

} // namespace

void editTest(Document &document, std::size_t test, const std::function<void(Test &)> &change) {
    if (test >= document.tests.size())
        return;
    auto changed = std::make_shared<Test>(*document.tests[test]);
    change(*changed);
    document.tests[test] = std::move(changed);
}

void turnAngles(CircularMeasurement &circle, double by) {
    for (Arc &arc : circle.arcs) {
        for (double &angle : arc.angles)
            angle += by;
        if (arc.evaluated)
            arc.evaluated = Interval{arc.evaluated->from + by, arc.evaluated->to + by};
    }
}

std::string freeInstrumentId(const Document &document) {
    const std::string stem = "instrument";
    std::string id = stem;
    for (int number = 2; isTaken(document, id); ++number)
        id = stem + std::to_string(number);
    return id;
}

void addInstrument(Document &document, Instrument instrument) {
    if (instrument.id.empty() || isTaken(document, instrument.id))
        instrument.id = freeInstrumentId(document);
    const std::string id = instrument.id;
    document.instruments.push_back(std::move(instrument));
    if (document.instruments.size() > 1)
        return;
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        if (document.tests[i]->instruments.empty())
            editTest(document, i, [&](Test &test) { test.instruments = {id}; });
    }
}

void removeInstrument(Document &document, std::size_t index) {
    if (index >= document.instruments.size())
        return;
    const std::string id = document.instruments[index].id;
    eraseAt(document.instruments, index);
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        const auto &named = document.tests[i]->instruments;
        if (std::ranges::find(named, id) != named.end())
            editTest(document, i, [&](Test &test) { std::erase(test.instruments, id); });
    }
}

bool renameInstrument(Document &document, std::size_t index, const std::string &id) {
    if (index >= document.instruments.size() || id.empty())
        return false;
    const std::string former = document.instruments[index].id;
    if (former == id)
        return true;
    if (isTaken(document, id))
        return false;
    document.instruments[index].id = id;
    for (std::size_t i = 0; i < document.tests.size(); ++i) {
        const auto &named = document.tests[i]->instruments;
        if (std::ranges::find(named, former) != named.end())
            editTest(document, i, [&](Test &test) { std::ranges::replace(test.instruments, former, id); });
    }
    return true;
}

const Sensor *sensorOf(const Conditions &conditions, SensorMeasures what, std::size_t ordinal) {
    const std::size_t index = indexOf(conditions, what, ordinal);
    return index < conditions.sensors.size() ? &conditions.sensors[index] : nullptr;
}

std::size_t countSensors(const Conditions &conditions, SensorMeasures what) {
    return static_cast<std::size_t>(std::ranges::count(conditions.sensors, what, &Sensor::measures));
}

void editSensor(Conditions &conditions, SensorMeasures what, std::size_t ordinal,
                const std::function<void(Sensor &)> &change) {
    const std::size_t count = countSensors(conditions, what);
    if (ordinal > count)
        return;
    Sensor nothing;
    nothing.measures = what;
    if (ordinal == count)
        conditions.sensors.push_back(nothing);
    const std::size_t index = indexOf(conditions, what, ordinal);
    change(conditions.sensors[index]);
    conditions.sensors[index].measures = what;
    if (conditions.sensors[index] == nothing && ordinal + 1 == countSensors(conditions, what))
        eraseAt(conditions.sensors, index);
}

void removeSensor(Conditions &conditions, SensorMeasures what, std::size_t ordinal) {
    const std::size_t index = indexOf(conditions, what, ordinal);
    if (index < conditions.sensors.size())
        eraseAt(conditions.sensors, index);
}

void takeAgreedValue(Test &test, std::string_view point) {
    const auto found = std::ranges::find(test.agreedPoints, point, &AgreedPoint::point);
    if (found == test.agreedPoints.end())
        return;
    std::optional<double> &value = found->value;
    if (point == "gradient")
        value = partOr(value, test.measurement, [](auto &m) -> decltype(m.conditions.gradientPerHour) {
            return m.conditions.gradientPerHour;
        });
    else if (point == "feed")
        value = partOr(value, test.measurement, [&](auto &m) -> decltype(m.conditions.feed) {
            return m.conditions.feedMode == FeedMode::rapid ? value : m.conditions.feed;
        });
}

void setAgreedPoint(Test &test, const std::string &point, std::optional<AgreementState> state,
                    const std::string &text) {
    const auto found = std::ranges::find(test.agreedPoints, point, &AgreedPoint::point);
    if (!state) {
        if (found != test.agreedPoints.end())
            test.agreedPoints.erase(found);
    } else if (found == test.agreedPoints.end()) {
        test.agreedPoints.push_back({point, *state, text});
    } else {
        found->state = *state;
        found->text = text;
    }
}

void editLimit(Test &test, const std::string &id, const std::function<void(Limit &)> &change) {
    Limit &limit = test.limits[id];
    change(limit);
    if (limit == Limit())
        test.limits.erase(id);
}

} // namespace palmer
