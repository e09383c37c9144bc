// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/measurement/positioning.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace palmer::ui {

/// A reading the pointer can find in a figure, in the units of its axes.
struct FigureReading {
    double x = 0;
    double y = 0;
    CurveRole role = CurveRole::up;
    ReadingPlace place;
};

/// The readings the pointer can find in a figure: its marks or, without marks, the points of its up and down
/// curves, which are then those of a single run or of drift. Refers to the figure without copying, as it may
/// hold a million points.
class FigureReadings {
public:
    /// No readings.
    FigureReadings() = default;
    /// Readings of a drift test's figure.
    explicit FigureReadings(std::shared_ptr<const CurveFigure> figure)
        : m_figure(std::move(figure)) {}
    /// Readings of a figure of the measurement.
    FigureReadings(std::shared_ptr<const CurveFigure> figure, const PositioningMeasurement &measurement)
        : m_figure(std::move(figure)) {
        for (std::size_t run = 0; run < measurement.runs.size(); ++run)
            m_runs[measurement.runs[run].approach == Direction::positive ? 0 : 1].push_back(run);
    }

    /// Calls `visit` with each FigureReading.
    void each(auto &&visit) const {
        if (!m_figure)
            return;
        for (const ReadingMark &mark : m_figure->readings)
            visit(FigureReading{mark.x, mark.y, mark.role, place(mark.role, mark.run, mark.target)});
        if (!m_figure->readings.empty())
            return;
        for (const Curve &curve : m_figure->curves) {
            if (curve.role == CurveRole::mean)
                continue;
            for (const FigurePoint &point : curve.points)
                visit(FigureReading{point.x, point.y, curve.role, place(curve.role, 1, point.target)});
        }
    }

private:
    /// Place in the `run`-th run of its direction, counted from 1; run index 0 if there is none.
    [[nodiscard]] ReadingPlace place(CurveRole role, int run, int target) const {
        const std::vector<std::size_t> &runs = m_runs[role == CurveRole::up ? 0 : 1];
        const auto k = static_cast<std::size_t>(run) - 1;
        return {k < runs.size() ? runs[k] : 0, static_cast<std::size_t>(target) - 1};
    }

    std::shared_ptr<const CurveFigure> m_figure;
    std::array<std::vector<std::size_t>, 2> m_runs; ///< indices in the measurement of the runs ↑ and ↓
};

} // namespace palmer::ui
