// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/thermal.h"
#include "figures/figure.h"
#include "language/language.h"
#include "report/blocks/report.h"

namespace palmer {

/// Why the data of a channel show no response to a temperature; empty if they do.
[[nodiscard]] Text noResponseText(ResponseState state);

/// Its name, in sentences and tables also if it is empty.
[[nodiscard]] std::string shownName(const DriftChannel &channel);

/// States that all of it is an interpretation.
[[nodiscard]] Text thermalNature();

/// True if a drift test has a page of its own: several channels, or temperatures.
[[nodiscard]] bool hasThermalPage(const Test &test);

/// The channels of a drift test over its time, the temperatures, and E_VE over the duration of a window; of
/// lengths and angles those in the unit of the channel `shown`, or of `quantity`. With the response of
/// `shown` to its best temperature, if it has one, and a band over the window of the largest range, `worst`.
[[nodiscard]] LineFigure channelFigure(const DriftMeasurement &drift,
                                       const std::vector<ThermalChannel> &channels, std::size_t shown,
                                       const Language &language,
                                       const std::optional<TakenVariation> &worst = {});
[[nodiscard]] LineFigure temperatureFigure(const DriftMeasurement &drift, const Language &language,
                                           const std::optional<TakenVariation> &worst = {});
[[nodiscard]] LineFigure variationFigure(const DriftMeasurement &drift, Quantity quantity,
                                         const Language &language);

/// Channel, temperature, k, τ, b, residual with intervals of 95 %, a row per channel; a sentence where the
/// data carry no response.
[[nodiscard]] Table responseTable(const DriftMeasurement &drift, const std::vector<ThermalChannel> &channels,
                                  const Language &language);

/// "Ranges of the record: X 0.9 µm; Z 3.1 µm"; empty without values.
[[nodiscard]] QString rangesOfChannels(const DriftMeasurement &drift, const Language &language);

/// The part of U that the drift explains, and what shorter tests or steadier temperatures would bring.
[[nodiscard]] Table driftCaseTable(const DriftCases &cases, bool angular, const Language &language);

/// How their U come about; `cases` are not empty.
[[nodiscard]] QString driftCaseNote(const DriftCases &cases, const Language &language);

/// Sentences below both tables: the model, warming up.
[[nodiscard]] QStringList thermalNotes(const DriftMeasurement &drift,
                                       const std::vector<ThermalChannel> &channels, const Language &language);

/// All of this of one drift test without its head.
[[nodiscard]] std::vector<Block> thermalBlocks(const EvaluatedDocument &evaluated, std::size_t test,
                                               const Language &language);

} // namespace palmer
