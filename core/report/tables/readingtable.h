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

/// What the table of readings shows of a reading: display only, the data stay deviations.
enum class ReadingUnit { deviations, positions };

/// Runs side by side, or all runs of one direction and then those of the other.
enum class ReadingGrouping { byRun, byDirection };

/// A column of readings.
struct ReadingColumn {
    std::size_t run = 0; ///< index in the measurement
    int number = 1;      ///< of the run in its direction, counted from 1
    Direction approach = Direction::positive;
    bool endsGroup = false; ///< a stronger rule follows

    bool operator==(const ReadingColumn &) const = default;
};

/// The columns in the order they are shown. By run, the runs of both directions that have the same number
/// stand together, ↑ first.
[[nodiscard]] std::vector<ReadingColumn> readingColumns(const PositioningMeasurement &measurement,
                                                        ReadingGrouping grouping);

/// A column computed from the readings: a quantity per target of the edition.
struct StatisticColumn {
    std::string id; ///< of targetValue
    Formula symbol; ///< without index: "x̄↑"
    QString name;   ///< the edition's term
};

/// x̄ and s of each direction, B and R, as far as the edition knows them and this test has them, in its order;
/// of a test from one direction R of that.
[[nodiscard]] std::vector<StatisticColumn> statisticColumns(const TestEvaluation &evaluation,
                                                            const Language &language);

/// A reading as it is shown.
struct ShownReading {
    QString text; ///< a dash where there is none
    bool missing = false;
    bool excluded = false; ///< set aside: shown all the same
    QString reason;        ///< why it was set aside

    bool operator==(const ShownReading &) const = default;
};

/// Texts of the cells of a table of readings. Borrows the measurement.
class ReadingTexts {
public:
    ReadingTexts(const PositioningMeasurement &measurement, Language language, ReadingUnit unit);

    [[nodiscard]] QString position(std::size_t target) const;
    [[nodiscard]] ShownReading reading(std::size_t run, std::size_t target) const;
    /// Statistics are deviations, whatever the readings are shown as.
    [[nodiscard]] QString statistic(std::optional<double> value) const;
    /// "i = 2 · ↓ 1 · 5,4 µm".
    [[nodiscard]] QString label(std::size_t run, std::size_t target) const;

    [[nodiscard]] QString positionUnit() const;
    [[nodiscard]] QString readingUnit() const; ///< of what is shown
    [[nodiscard]] QString deviationUnit() const;

    /// Mean and range of the readings of a selection, or its only one: "3 readings: mean 1,2 µm, range
    /// 0,4 µm". Empty without any. (run, target) pairs.
    [[nodiscard]] QString summary(std::span<const std::pair<std::size_t, std::size_t>> places) const;

private:
    [[nodiscard]] QString shown(double deviation, std::size_t target) const;
    [[nodiscard]] QString arrowAndNumber(std::size_t run) const;

    const PositioningMeasurement *m_measurement;
    Language m_language;
    ReadingUnit m_unit;
    ReadingsAside m_aside; ///< a table asks for every cell
    int m_positionDecimals;
    int m_readingDecimals;
    int m_statisticDecimals;
};

} // namespace palmer
