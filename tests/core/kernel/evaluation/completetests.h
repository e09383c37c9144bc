// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernel/evaluation/positioningdata.h"

#include <cmath>

/// Tests that state everything and meet every requirement of their edition, for tests of what is found when
/// they do not.
namespace palmer::testdata {

struct Setup {
    Machine machine{"M", "maker", "type", "1", "", {}, "", ""};
    Instrument laser{"laser", "laser interferometer", "",           "", "2", "C-1",
                     "",      "2026-01-01",           "2027-01-01", {}, {}};
    Test test;
    bool otherTest = false;
    Surroundings around; ///< what the report and the other tests say

    PositioningMeasurement &m() { return measurement(test); }
    Conditions &common() { return m().conditions.common; }

    [[nodiscard]] TestEvaluation evaluated(const char *edition = nullptr) const {
        Surroundings surroundings = around;
        surroundings.machine = &machine;
        surroundings.instruments = {&laser};
        surroundings.otherTestOfLongAxis = otherTest;
        return evaluateTest(test, surroundings, edition ? findEdition(edition) : nullptr);
    }
};

inline std::vector<std::vector<double>> readingsFor(std::size_t targets, int runs, unsigned seed) {
    std::vector<std::vector<double>> result;
    for (int j = 0; j < runs; ++j) {
        result.emplace_back();
        for (std::size_t i = 0; i < targets; ++i) {
            seed = seed * 1664525u + 1013904223u;
            result.back().push_back(static_cast<double>(seed >> 24) / 64);
        }
    }
    return result;
}

inline AgreedPoint &agreed(Test &test, std::string_view point) {
    return *std::ranges::find(test.agreedPoints, point, &AgreedPoint::point);
}

/// A test that states everything and meets every requirement of its edition.
inline Setup complete(const char *edition, std::vector<double> targets, int runs = 5) {
    Setup setup;
    const std::size_t m = targets.size();
    const double last = targets.back();
    setup.test =
        positioningTest(edition, std::move(targets), readingsFor(m, runs, 1), readingsFor(m, runs, 2));
    setup.test.date = "2026-11-20";
    setup.test.instruments = {"laser"};
    for (const AgreementPoint &point : findEdition(edition)->points)
        setup.test.agreedPoints.push_back({point.point, AgreementState::agreed, "as agreed", {}});
    if (!setup.test.agreedPoints.empty()) { // VDI has none
        agreed(setup.test, "gradient").value = 0.5;
        agreed(setup.test, "feed").value = 5000;
    }
    setup.test.purpose = Purpose::acceptance;
    PositioningMeasurement &p = setup.m();
    p.axis = {"X", Motion::linear, last + 20, Interval{-10, last + 10}, "linear scale", 0.0};
    p.cycle = Cycle::standard;
    p.targetChoice.kind = TargetChoiceKind::free;
    p.targetChoice.period = 10;
    PositioningConditions &c = p.conditions;
    c.feed = 5000;
    c.dwell = 3;
    c.approachDistance = 5;
    c.airPressure = 1013;
    c.airHumidity = 50;
    c.gradientPerHour = 0.2;
    c.gradientHoursBefore = 12;
    Conditions &common = c.common;
    common.warmUp = {WarmUpKind::procedure, "60 min", SpecifiedBy::maker};
    common.stabilised = common.shielded = common.temperatureControlled = true;
    common.instrumentCompensation = InstrumentCompensation::on;
    common.load = "none";
    common.compensation = "pitch table";
    common.otherAxes = "Y 0";
    common.levelled = common.complete = common.unloaded = true;
    common.toolOffset = {0, 0, -120};
    common.workpieceOffset = {0, 0, 180};
    for (const auto what : {SensorMeasures::machine, SensorMeasures::instrument, SensorMeasures::air})
        common.sensors.push_back({what, "table", 20.0, 20.0, {}});
    common.expansion = {11.5, 0.0};
    common.correctionTo20 = CorrectionTo20::appliedByInstrument;
    p.uncertainty.method = UncertaintyMethod::direct;
    for (const Row &row : findEdition(edition)->rows)
        p.uncertainty.expanded[row.term.id] = 1.0;
    return setup;
}

inline Setup shortAxis(const char *edition) {
    return complete(edition, {3, 104, 207, 298, 402, 511});
}

inline Setup longAxis(const char *edition) {
    std::vector<double> targets;
    for (int i = 0; i <= 16; ++i)
        targets.push_back(i * 249.0 + 7 * (i % 3));
    Setup setup = complete(edition, std::move(targets), 1);
    setup.otherTest = true;
    return setup;
}

inline Setup zoneOfLongAxis(const char *edition) {
    Setup setup = complete(edition, {1005, 1201, 1403, 1598, 1806, 2003, 2199, 2402, 2601, 2797});
    setup.m().axis.travel = 4000;
    setup.m().axis.range = Interval{0, 4000};
    setup.m().zone = Interval{1000, 3000};
    setup.otherTest = true;
    return setup;
}

inline Setup rotary(const char *edition) {
    Setup setup = complete(edition, {0, 41, 90, 137, 180, 222, 270, 311, 350});
    setup.m().axis = {"C", Motion::rotary, 360.0, Interval{-5, 365}, "rotary encoder"};
    setup.m().conditions.continuousDevice = true;
    return setup;
}

/// Two full circles of 360 points each that state everything and meet every requirement.
struct Circle {
    Machine machine{"M", "maker", "type", "1", "", {}, "", ""};
    Instrument bar{"bar", "ballbar", "", "", "2", "C-1", "", "2026-01-01", "2027-01-01", {}, {}};
    Test test;

    CircularMeasurement &m() { return std::get<CircularMeasurement>(test.measurement); }
    Conditions &common() { return m().conditions.common; }

    [[nodiscard]] TestEvaluation evaluated(const char *edition = nullptr) const {
        Surroundings surroundings;
        surroundings.machine = &machine;
        if (!bar.id.empty()) // else the test names none
            surroundings.instruments = {&bar};
        return evaluateTest(test, surroundings, edition ? findEdition(edition) : nullptr);
    }
};

inline Arc arc(Sense sense, double from, double to) {
    Arc result;
    result.sense = sense;
    const double sign = sense == Sense::counterclockwise ? 1 : -1;
    for (double angle = from; angle < to; angle += 1) {
        result.angles.push_back(sign * angle);
        result.radialDeviations.push_back(0.001 * std::sin(2 * angle * M_PI / 180) +
                                          0.0001 * std::cos(7 * angle * M_PI / 180) * sign);
    }
    return result;
}

inline Circle circle() {
    Circle result;
    result.test.edition = "ISO 230-4:2005";
    result.test.date = "2026-11-20";
    result.test.purpose = Purpose::acceptance;
    result.test.instruments = {"bar"};
    for (const AgreementPoint &point : findEdition("ISO 230-4:2005")->points)
        result.test.agreedPoints.push_back({point.point, AgreementState::agreed, "as agreed", {}});
    CircularMeasurement m;
    m.plane = {"X", "Y"};
    m.positionFeedback = "linear scales";
    m.nominalRadius = 150;
    m.feed = 1000;
    m.referenceLength = {true, 0.5, 2};
    m.arcs = {arc(Sense::counterclockwise, 0, 360), arc(Sense::clockwise, 0, 360)};
    m.conditions.centre = {0, 0, 0};
    m.conditions.startPoint = "+X";
    m.conditions.stopPoint = "+X";
    m.conditions.smoothing = "none";
    m.conditions.recentredBetweenRuns = false;
    Conditions &common = m.conditions.common;
    common.warmUp = {WarmUpKind::procedure, "60 min", SpecifiedBy::maker};
    common.stabilised = common.shielded = common.temperatureControlled = true;
    common.levelled = common.complete = common.unloaded = true;
    common.compensation = "none";
    common.otherAxes = "Z 0";
    common.load = "none";
    common.toolOffset = {0, 0, -120};
    common.workpieceOffset = {0, 0, 180};
    for (const auto what : {SensorMeasures::machine, SensorMeasures::instrument, SensorMeasures::air})
        common.sensors.push_back({what, "table", 20.0, 20.0, {}});
    common.expansion = {11.5, 11.5};
    common.correctionTo20 = CorrectionTo20::notApplied;
    m.uncertainty.method = UncertaintyMethod::direct;
    for (const char *id : {"G(b)", "G", "F", "D"})
        m.uncertainty.expanded[id] = 1.0;
    result.test.measurement = std::move(m);
    return result;
}

} // namespace palmer::testdata
