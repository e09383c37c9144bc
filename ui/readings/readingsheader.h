// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/readings/readingsmodel.h"

#include <QHeaderView>

namespace palmer::ui {

/// The two-row header of the readings: title of the run (or direction) above, ↑ ↓ (or run) below.
class ReadingsHeader : public QHeaderView {
    Q_OBJECT

public:
    explicit ReadingsHeader(const ReadingsModel &model, QWidget *parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void paintColumn(QPainter &painter, int column, const QRect &area) const;

    const ReadingsModel &m_model;
};

} // namespace palmer::ui
