// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/words/formula.h"

#include <QString>
#include <QWidget>
#include <array>
#include <vector>

namespace palmer::ui {

/// The small table of a target: x̄ s R B by direction and for both.
class TargetStatisticsView : public QWidget {
    Q_OBJECT

public:
    struct Row {
        Formula symbol;
        std::array<QString, 3> values; ///< ↑, ↓, both; a dash if there is none
    };

    using QWidget::QWidget;

    void setRows(const QString &unit, const QString &both, std::vector<Row> rows);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    [[nodiscard]] int columnWidth(int least) const;

    QString m_unit;
    QString m_both;
    std::vector<Row> m_rows;
};

} // namespace palmer::ui
