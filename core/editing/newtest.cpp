// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/newtest.h"

#include "editing/takestatements.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace palmer {

namespace {

bool hasTest(const Document &document, const std::string &id) {
    return std::ranges::any_of(document.tests, [&](const TestPointer &test) { return test->id == id; });
}

void forgetReadings(PositioningMeasurement &measurement) {
    for (Run &run : measurement.runs)
        std::ranges::fill(run.deviations, std::nullopt);
    measurement.excluded.clear();
    measurement.refused.clear();
}

void forgetReadings(CircularMeasurement &measurement) {
    measurement.arcs.clear();
}

void forgetReadings(DriftMeasurement &measurement) {
    measurement.channels.clear();
    measurement.temperatures.clear();
    measurement.times.clear();
    measurement.deviations.clear();
}

} // namespace

Test newTest(const NewPositioningTest &wanted) {
    PositioningMeasurement measurement;
    measurement.axis = wanted.axis;
    measurement.cycle = wanted.cycle;
    measurement.targets = wanted.targets;
    measurement.targetChoice = wanted.targetChoice;
    for (int run = 0; run < wanted.runs; ++run) {
        for (const Direction approach : {Direction::positive, Direction::negative}) {
            if (approach == Direction::positive || wanted.bothDirections)
                measurement.runs.push_back(
                    {approach, std::vector<std::optional<double>>(wanted.targets.size())});
        }
    }
    Test test;
    test.edition = wanted.edition;
    test.measurement = std::move(measurement);
    return test;
}

Test newTest(const NewCircularTest &wanted) {
    CircularMeasurement measurement;
    measurement.plane = wanted.plane;
    measurement.nominalRadius = wanted.nominalRadius;
    measurement.feed = wanted.feed;
    measurement.source = wanted.source;
    Test test;
    test.edition = wanted.edition;
    test.measurement = std::move(measurement);
    return test;
}

Test newDriftTest(const Axis &axis) {
    DriftMeasurement measurement;
    measurement.axis.name = axis.name;
    measurement.axis.motion = axis.motion;
    Test test;
    test.measurement = std::move(measurement);
    return test;
}

std::vector<double> evenTargets(double first, double last, std::size_t count, double resolution) {
    std::vector<double> targets;
    if (!(first < last))
        return targets;
    for (std::size_t i = 0; i < count; ++i) {
        const double position =
            count == 1 ? first
                       : first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1);
        const double steps = std::round(position / resolution);
        // For resolutions below 1 divides instead of multiplying, as 3 · 0.1 is not 0.3.
        const double whole = !(resolution > 0) ? position
                             : resolution < 1  ? steps / std::round(1 / resolution)
                                               : steps * resolution;
        if (targets.empty() || targets.back() < whole)
            targets.push_back(whole);
    }
    return targets;
}

std::string freshId(const Document &document, const Test &test) {
    std::string stem;
    for (const char c : axesOf(test)) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            stem += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (stem.empty())
        stem = "t";
    int number = 1;
    while (hasTest(document, stem + std::to_string(number)))
        ++number;
    return stem + std::to_string(number);
}

std::size_t insertTest(Document &document, std::size_t index, Test test) {
    if (test.id.empty() || hasTest(document, test.id))
        test.id = freshId(document, test);
    const std::size_t place = std::min(index + 1, document.tests.size());
    document.tests.insert(document.tests.begin() + static_cast<std::ptrdiff_t>(place),
                          std::make_shared<const Test>(std::move(test)));
    return place;
}

std::size_t duplicateTest(Document &document, std::size_t index, bool withReadings) {
    Test copy = *document.tests.at(index);
    if (!withReadings) {
        std::visit([](auto &measurement) { forgetReadings(measurement); }, copy.measurement);
        copy.imports.clear();
        forgetDay(copy);
    }
    return insertTest(document, index, std::move(copy));
}

void removeTest(Document &document, std::size_t index) {
    if (index >= document.tests.size())
        return;
    const std::string id = document.tests[index]->id;
    document.tests.erase(document.tests.begin() + static_cast<std::ptrdiff_t>(index));
    for (auto &other : document.tests) {
        const std::string *named = driftTestOf(*other);
        const bool isDrift = named && *named == id;
        const bool isCompared = other->comparedWith && other->comparedWith->test == id;
        if (id.empty() || (!isDrift && !isCompared))
            continue;
        auto test = std::make_shared<Test>(*other);
        if (isDrift)
            withUncertainty(*test, [](auto &inputs) { inputs.driftTest.reset(); });
        if (isCompared)
            test->comparedWith.reset();
        other = std::move(test);
    }
}

} // namespace palmer
