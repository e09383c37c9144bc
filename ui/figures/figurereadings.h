// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "kernel/measurement/positioning.h"
#include "kernel/measurement/readingplace.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace palmer::ui {

/// A reading that the pointer can find in a figure, in the units of its axes.
struct FigureReading {
    double x = 0;
    double y = 0;
    CurveRole role = CurveRole::up;
    ReadingPlace place;
};

/// The readings that the pointer finds in a figure: its marks, or, where it has none, the points of its
/// curves up and down, which are those of the only run, and of drift. Nothing is copied of the figure, which
/// may hold a million.
class FigureReadings {
public:
    /// None.
    FigureReadings() = default;
    /// Of a drift test.
    explicit FigureReadings(std::shared_ptr<const CurveFigure> figure)
        : m_figure(std::move(figure)) {}
    /// Of a figure made of the measurement.
    FigureReadings(std::shared_ptr<const CurveFigure> figure, const PositioningMeasurement &measurement);

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
    /// Of the k-th run of its direction, from 1; 0 where there is none.
    [[nodiscard]] ReadingPlace place(CurveRole role, int run, int target) const {
        const std::vector<std::size_t> &runs = m_runs[role == CurveRole::up ? 0 : 1];
        const auto k = static_cast<std::size_t>(run) - 1;
        return {k < runs.size() ? runs[k] : 0, static_cast<std::size_t>(target) - 1};
    }

    std::shared_ptr<const CurveFigure> m_figure;
    std::array<std::vector<std::size_t>, 2> m_runs; ///< indices in the measurement, of ↑ and of ↓
};

} // namespace palmer::ui
