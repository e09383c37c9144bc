// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/translated.h"

#include <QAbstractButton>

namespace palmer::ui {

/// The row below the list of machines that, while checked, shows those without serial number instead.
class UnidentifiedRow : public Translated<QAbstractButton> {
    Q_OBJECT

public:
    explicit UnidentifiedRow(QWidget *parent = nullptr);

    void setTests(int tests);

    [[nodiscard]] QSize sizeHint() const override { return {100, rowHeight}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    static constexpr int rowHeight = 44;

    void retranslate() final;

    int m_tests = 0;
    QString m_below;
};

} // namespace palmer::ui
