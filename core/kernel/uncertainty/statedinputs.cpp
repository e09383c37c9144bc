// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/uncertainty/statedinputs.h"

#include "kernel/uncertainty/inputs.h"

namespace palmer {

namespace {

class Inputs {
public:
    void add(const Text &name, std::optional<double> value, Quantity quantity) {
        if (value)
            m_stated.push_back({name, {*value, quantity}});
    }
    void addFactor(const Text &name, double k) {
        if (k != coverage)
            add(name, k, Quantity::number);
    }
    std::vector<StatedInput> take() { return std::move(m_stated); }

private:
    std::vector<StatedInput> m_stated;
};

void addInputs(Inputs &inputs, const PositioningMeasurement &measurement) {
    const PositioningUncertaintyInputs &of = measurement.uncertainty;
    const Quantity size =
        measurement.axis.motion == Motion::linear ? Quantity::micrometres : Quantity::arcSeconds;
    inputs.add(inputs::fixedPart, of.device.fixed, size);
    inputs.add(inputs::perMetre, of.device.perMetre, size);
    inputs.addFactor(inputs::certificateFactor, of.device.coverageFactor);
    inputs.add(inputs::misalignment, of.misalignmentRange, Quantity::position);
    inputs.add(inputs::thetaRangeMachine, of.temperatureRange.machine, Quantity::temperature);
    inputs.add(inputs::thetaRangeInstrument, of.temperatureRange.instrument, Quantity::temperature);
    inputs.add(inputs::alphaRangeMachine, of.expansionRange.machine, Quantity::expansion);
    inputs.add(inputs::alphaRangeInstrument, of.expansionRange.instrument, Quantity::expansion);
    inputs.add(REPORT_TEXT("report", "environmental variation error"), of.environmentalVariation, size);
    inputs.add(REPORT_TEXT("report", "length L"), of.length, Quantity::position);
}

void addInputs(Inputs &inputs, const CircularMeasurement &measurement) {
    const CircularUncertaintyInputs &of = measurement.uncertainty;
    constexpr Quantity size = Quantity::micrometres;
    inputs.add(inputs::displacement, of.displacement.expanded, size);
    inputs.addFactor(REPORT_TEXT("report", "coverage factor of the calibration of displacement"),
                     of.displacement.coverageFactor);
    inputs.add(REPORT_TEXT("report", "resolution of the instrument"), of.resolution, size);
    inputs.add(REPORT_TEXT("report", "repeatability"), of.repeatability, size);
    inputs.add(REPORT_TEXT("report", "environmental variation error"), of.environmentalVariation, size);
    inputs.add(inputs::referenceLength, measurement.referenceLength.expandedUncertainty, size);
    inputs.addFactor(REPORT_TEXT("report", "coverage factor of the reference length"),
                     measurement.referenceLength.coverageFactor);
    inputs.add(inputs::centring, of.centring, size);
    inputs.add(inputs::pointNoise, of.pointNoise, size);
    inputs.add(inputs::thetaOfMachine, of.temperatureStandardUncertainty.machine, Quantity::temperature);
    inputs.add(inputs::thetaOfInstrument, of.temperatureStandardUncertainty.instrument,
               Quantity::temperature);
    inputs.add(inputs::alphaOfMachine, of.expansionStandardUncertainty.machine, Quantity::expansion);
    inputs.add(inputs::alphaOfInstrument, of.expansionStandardUncertainty.instrument, Quantity::expansion);
}

/// A kind without inputs of the uncertainty states none.
void addInputs(Inputs & /*inputs*/,
               const auto &measurement) requires(!requires { measurement.uncertainty; }) {}

} // namespace

std::vector<StatedInput> statedInputs(const Test &test) {
    Inputs inputs;
    std::visit([&](const auto &measurement) { addInputs(inputs, measurement); }, test.measurement);
    return inputs.take();
}

} // namespace palmer
