// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/machinetrend.h"
#include "ui/madewidgets.h"

#include <QLabel>

namespace palmer::ui {

/// The facts on a trend in words, next to its chart.
class TrendFacts : public QWidget {
    Q_OBJECT

public:
    TrendFacts();

    void setTrend(const MachineTrend &trend);

private:
    QLabel *m_text = made<QLabel>("trendFacts", TextSize::base, trait::wrapped);
};

} // namespace palmer::ui
