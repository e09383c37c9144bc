// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"

#include <QAbstractTableModel>
#include <QStringList>
#include <vector>

namespace palmer::ui {

/// The arcs of a circular test in measured order: points, start, end, the part left out, least squares
/// radius.
class ArcsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { sense, points, from, to, cut, radius, use, columns };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row {
        Sense sense = Sense::counterclockwise;
        QStringList texts; ///< by column
    };
    std::vector<Row> m_rows;
    QString m_unit; ///< of deviations
};

} // namespace palmer::ui
