// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "kernel/words/quantity.h"
#include "ui/theme.h"

#include <QAbstractTableModel>
#include <optional>
#include <vector>

namespace palmer::ui {

/// The numbers that come in with an import, in the units of the window: targets and runs, angles and radial
/// deviations of each arc, times and values.
class RecognisedModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(const Imported *imported);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Column {
        QString head;
        Quantity quantity = Quantity::number;
        std::optional<Token> colour = {};
        std::vector<std::optional<double>> values = {};
        int decimals = 0; ///< those the numbers have, within sense
    };

    void add(const PositioningMeasurement &measurement);
    void add(const CircularMeasurement &measurement);
    void add(const DriftMeasurement &measurement);
    void addSensor(const Sensor &sensor);
    void countDecimals();

    std::vector<Column> m_columns;
    std::size_t m_rows = 0;
};

/// How many readings come in.
[[nodiscard]] int readingsOf(const Imported &imported);
/// How many readings of a positioning test are missing.
[[nodiscard]] int missingOf(const Imported &imported);

} // namespace palmer::ui
