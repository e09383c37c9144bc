// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/explanations/explanation.h"

#include <QWidget>

namespace palmer::ui {

/// Formula, steps and text of an explanation, wrapped.
class ExplanationView : public QWidget {
    Q_OBJECT

public:
    explicit ExplanationView(QWidget *parent = nullptr);

    void setExplanation(const Explanation &explanation);
    [[nodiscard]] QString plainText() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    double draw(QPainter *painter, double width) const;

    Explanation m_explanation;
};

} // namespace palmer::ui
