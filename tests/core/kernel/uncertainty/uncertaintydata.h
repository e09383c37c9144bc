// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernel/evaluation/positioningdata.h"

/// Inputs of uncertainty for tests.
namespace palmer::testdata {

/// Machine and instrument at the same temperature from start to end, °C.
inline void setTemperature(PositioningMeasurement &m, double machine) {
    m.conditions.common.sensors = {{SensorMeasures::machine, "", machine, machine, std::nullopt}};
}

/// X1 of the specification: laser of 1.5 µm/m, misaligned up to 1 mm, machine at 25 °C ± 0.5 with
/// α = 12 ± 1 µm/(m·°C), E_VE = 3 µm.
inline void stateX1(PositioningMeasurement &m) {
    setTemperature(m, 25);
    m.conditions.common.expansion = {12.0, 0.0};
    PositioningUncertaintyInputs &inputs = m.uncertainty;
    inputs.method = UncertaintyMethod::budget;
    inputs.device.fixed = 0;
    inputs.device.perMetre = 1.5;
    inputs.misalignmentRange = 1;
    inputs.temperatureRange = {1.0, 0.0};
    inputs.expansionRange = {2.0, 0.0};
    inputs.environmentalVariation = 3;
}

/// All inputs stated to be zero.
inline void stateNothing(PositioningMeasurement &m) {
    setTemperature(m, 20);
    m.conditions.common.expansion = {12.0, 0.0};
    PositioningUncertaintyInputs &inputs = m.uncertainty;
    inputs.method = UncertaintyMethod::budget;
    inputs.device.fixed = 0;
    inputs.device.perMetre = 0;
    inputs.misalignmentRange = 0;
    inputs.temperatureRange = {0.0, 0.0};
    inputs.expansionRange = {0.0, 0.0};
    inputs.environmentalVariation = 0;
}

/// Perfect circles in both senses, R 150 mm, of n points; all contributions stated to be zero.
inline Test circularTest(int n) {
    CircularMeasurement m;
    m.plane = {"X", "Y"};
    m.nominalRadius = 150;
    m.referenceLength = {true, 0.0, 2};
    for (const Sense sense : {Sense::counterclockwise, Sense::clockwise}) {
        Arc arc;
        arc.sense = sense;
        for (int i = 0; i < n; ++i) {
            arc.angles.push_back((sense == Sense::clockwise ? -360.0 : 360.0) * i / n);
            arc.radialDeviations.push_back(0);
        }
        m.arcs.push_back(std::move(arc));
    }
    CircularUncertaintyInputs &inputs = m.uncertainty;
    inputs.method = UncertaintyMethod::budget;
    inputs.displacement.expanded = 0;
    inputs.resolution = 0;
    inputs.pointNoise = 0;
    inputs.repeatability = 0;
    inputs.environmentalVariation = 0;
    inputs.centring = 0;
    inputs.temperatureStandardUncertainty = {0.0, 0.0};
    inputs.expansionStandardUncertainty = {0.0, 0.0};
    Test test;
    test.edition = "ISO 230-4:2005";
    test.measurement = std::move(m);
    return test;
}

inline CircularMeasurement &circle(Test &test) {
    return std::get<CircularMeasurement>(test.measurement);
}

} // namespace palmer::testdata
