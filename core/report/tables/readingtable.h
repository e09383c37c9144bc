// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "kernel/measurement/readingsaside.h"
#include "language/language.h"
#include "report/words/formula.h"

#include <QString>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palmer {

/// How the table displays readings; the data remain deviations.
enum class ReadingUnit { deviations, positions };

/// Pairs of runs side by side, or all runs of one direction and then those of the other.
enum class ReadingGrouping { byRun, byDirection };

struct ReadingColumn {
    std::size_t run = 0; ///< index in the measurement
    int number = 1;      ///< of the run in its direction, from 1
    Direction approach = Direction::positive;
    bool endsGroup = false; ///< a stronger rule follows

    bool operator==(const ReadingColumn &) const = default;
};

/// The columns in display order. By run, runs of both directions with the same number are together, ↑ first.
[[nodiscard]] std::vector<ReadingColumn> readingColumns(const PositioningMeasurement &measurement,
                                                        ReadingGrouping grouping);

/// A column computed from the readings: a quantity per target of the edition.
struct StatisticColumn {
    std::string id; ///< as in targetValue()
    Formula symbol; ///< without index: "x̄↑"
    QString name;   ///< the edition's term
};

/// x̄ and s of each direction, B and R, if the edition defines them and the test has them, in the edition's
/// order; for a test from one direction the R of that direction.
[[nodiscard]] std::vector<StatisticColumn> statisticColumns(const TestEvaluation &evaluation,
                                                            const Language &language);

struct ShownReading {
    QString text; ///< a dash if missing
    bool missing = false;
    bool excluded = false; ///< excluded but still displayed
    QString reason;        ///< of the exclusion

    bool operator==(const ShownReading &) const = default;
};

/// Cell texts of a table of readings. Holds a reference to the measurement.
class ReadingTexts {
public:
    ReadingTexts(const PositioningMeasurement &measurement, Language language, ReadingUnit unit);

    [[nodiscard]] QString position(std::size_t target) const;
    [[nodiscard]] ShownReading reading(std::size_t run, std::size_t target) const;
    /// Statistics are deviations, however readings are displayed.
    [[nodiscard]] QString statistic(std::optional<double> value) const;
    /// "i = 2 · ↓ 1 · 5,4 µm".
    [[nodiscard]] QString label(std::size_t run, std::size_t target) const;

    [[nodiscard]] QString positionUnit() const;
    [[nodiscard]] QString readingUnit() const; ///< of displayed readings
    [[nodiscard]] QString deviationUnit() const;

    /// Mean and range of the selected readings, or the only one: "3 readings: mean 1,2 µm, range 0,4 µm".
    /// Empty if there are none. (run, target) pairs.
    [[nodiscard]] QString summary(std::span<const std::pair<std::size_t, std::size_t>> places) const;

private:
    [[nodiscard]] QString shown(double deviation, std::size_t target) const;
    [[nodiscard]] QString arrowAndNumber(std::size_t run) const;

    const PositioningMeasurement *m_measurement;
    Language m_language;
    ReadingUnit m_unit;
    ReadingsAside m_aside; ///< cached, because a table queries every cell
    int m_positionDecimals;
    int m_readingDecimals;
    int m_statisticDecimals;
};

} // namespace palmer
