// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/explanations/explanation.h"
#include "ui/model/selection.h"

#include <QWidget>

namespace palmer::ui {

/// A bar per target with its part in a parameter; the determining one in the colour of explanations. A click
/// makes its target current.
class TargetBarsView : public QWidget {
    Q_OBJECT

public:
    explicit TargetBarsView(Selection &selection, QWidget *parent = nullptr);

    void setBars(const std::optional<TargetBars> &bars, const QString &title);

    [[nodiscard]] QSize sizeHint() const override { return {184, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 90}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;

private:
    [[nodiscard]] QRectF plot() const;

    Selection &m_selection;
    std::optional<TargetBars> m_bars;
    QString m_title;
};

} // namespace palmer::ui
