// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "document/filewords.h"
#include "kernel/thermal/response.h"
#include "kernel/thermal/variation.h"

namespace palmer {

// The thermal behaviour of the machine: an interpretation, no result of ISO 230-2.

/// Values with NaN for those that are missing.
[[nodiscard]] std::vector<double> withGaps(const std::vector<std::optional<double>> &values);

/// Gives the only channel the name of the axis, if there is one: it is that of the axis.
void nameOnlyChannel(DriftMeasurement &drift);

/// See variation(); the times may be unsorted.
[[nodiscard]] std::optional<Variation> variationOf(const std::vector<double> &times,
                                                   const std::vector<std::optional<double>> &values,
                                                   std::optional<double> duration);

/// A channel with its drift and its response to each temperature.
struct ThermalChannel {
    DriftChannel channel;
    std::optional<Variation> whole; ///< of the whole record; null without values
    std::vector<ThermalResponse> responses;
    std::optional<std::size_t> best; ///< the temperature that explains most; null: none is shown to
};

/// Times ascend in the record.
[[nodiscard]] std::vector<ThermalChannel> thermalChannels(const DriftMeasurement &drift);

/// True if a test names this drift test for its E_VE; a number beside it wins.
[[nodiscard]] bool takesVariation(const Test &test, const std::string &drift);

/// The judged tests that take E_VE from a drift test, which has one for them.
[[nodiscard]] std::vector<std::size_t> testsTaking(const Document &document, const std::string &drift);

/// Another drift than that of the record, and what it would make of the uncertainty of a test.
struct DriftCase {
    enum Kind { asTested, halved, none, wholeRecord, held } kind = asTested;
    double hold = 0;                             ///< held: the temperature to ± this, °C
    std::optional<double> lasts;                 ///< s; null: the whole record
    double variation = 0;                        ///< E_VE, mm or degrees; held: at most
    bool isLowerBound = false;                   ///< of E_VE, and with it of share and U; see Variation
    std::optional<double> share;                 ///< of U² of the first parameter
    std::vector<std::optional<double>> expanded; ///< U of the parameters of `DriftCases`
};
struct DriftCases {
    std::vector<std::string> parameters; ///< ids: accuracy and repeatability, as far as the test has them
    std::vector<DriftCase> cases;
};

/// The part of the budget of a test that the drift explains, and what shorter tests or steadier
/// temperatures would bring; empty without a budget.
[[nodiscard]] DriftCases driftCases(const EvaluatedDocument &evaluated, std::size_t index);

template <>
inline constexpr auto
    fileWords<ResponseState> = wordsInOrder<ResponseState>("found", "noEqualSteps", "gapInTemperature",
                                                           "tooFewValues", "notProven", "straightDrift",
                                                           "noisyTemperature");

} // namespace palmer
