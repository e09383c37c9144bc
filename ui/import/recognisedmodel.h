// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "kernel/words/quantity.h"
#include "ui/theme.h"

#include <QAbstractTableModel>
#include <optional>
#include <span>
#include <vector>

namespace palmer::ui {

/// The numbers that come in with an import, in the units of the window: targets and runs, angles and radial
/// deviations of each arc, times and values.
class RecognisedModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    /// What was read; it must stay alive and unchanged while it is shown.
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
        std::span<const double> values = {};                  ///< where none is missing
        std::span<const std::optional<double>> readings = {}; ///< else
        std::vector<std::optional<double>> own = {};          ///< else, of the model
        int decimals = 0;                                     ///< those the numbers have, within sense

        [[nodiscard]] std::size_t size() const;
        [[nodiscard]] std::optional<double> value(std::size_t row) const;
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
