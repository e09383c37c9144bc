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

/// The numbers to be imported, in the window's units: targets and runs, angles and radial deviations of each
/// arc, times and values.
class RecognisedModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    /// The data as read; must stay alive and unchanged while shown.
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
        std::span<const double> values = {};                  ///< if none is missing
        std::span<const std::optional<double>> readings = {}; ///< otherwise
        std::vector<std::optional<double>> own = {};          ///< otherwise, owned by the model
        int decimals = 0;                                     ///< as many as the numbers have, up to a limit

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

/// Number of readings to import.
[[nodiscard]] int readingsOf(const Imported &imported);
/// Number of missing readings of a positioning test.
[[nodiscard]] int missingOf(const Imported &imported);

} // namespace palmer::ui
