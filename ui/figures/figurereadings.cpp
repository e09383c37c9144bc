// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/figurereadings.h"

namespace palmer::ui {

FigureReadings::FigureReadings(std::shared_ptr<const CurveFigure> figure,
                               const PositioningMeasurement &measurement)
    : m_figure(std::move(figure)) {
    for (std::size_t run = 0; run < measurement.runs.size(); ++run)
        m_runs[measurement.runs[run].approach == Direction::positive ? 0 : 1].push_back(run);
}

} // namespace palmer::ui
