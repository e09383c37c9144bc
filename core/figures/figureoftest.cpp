// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "figures/circlefigure.h"

namespace palmer {

namespace {

struct Maker {
    const Test &test;
    const TestEvaluation &evaluation;
    const Language &language;

    Figure operator()(const PositioningMeasurement & /*measurement*/) const {
        return deviationFigure(test, evaluation, language);
    }
    Figure operator()(const CircularMeasurement & /*measurement*/) const {
        return circleFigure(test, evaluation, language);
    }
    Figure operator()(const DriftMeasurement & /*measurement*/) const {
        return driftFigure(test, evaluation, language);
    }
};

} // namespace

Figure figureOfTest(const Test &test, const TestEvaluation &evaluation, const Language &language) {
    return std::visit(Maker{test, evaluation, language}, test.measurement);
}

} // namespace palmer
