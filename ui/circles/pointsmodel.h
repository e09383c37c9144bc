// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/circles/arctexts.h"
#include "ui/model/selection.h"
#include "ui/refusedtexts.h"

#include <QAbstractTableModel>
#include <memory>
#include <optional>
#include <vector>

namespace palmer::ui {

/// The points of all arcs side by side in the order of measurement: number, then for each arc angle and
/// reading. Holds no texts: cells are formatted on request, so that millions of points cost nothing. Never
/// edits the document; typing is emitted as a signal.
class PointsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;

    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    void setUnit(PointUnit unit);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

    /// True if a cell shows the angle of its point, not its reading.
    [[nodiscard]] bool isAngle(const QModelIndex &index) const {
        return index.column() > 0 && (index.column() - 1) % columnsPerArc() == 0;
    }
    [[nodiscard]] PointUnit unit() const { return m_unit; }

    /// Keeps a refused text in its cell with the reason until the cell is typed again.
    void refuse(const QModelIndex &index, const QString &text, const QString &reason);
    void accept(const QModelIndex &index);
    [[nodiscard]] const RefusedTexts &refusedTexts() const { return m_refused; }

    /// The point of a cell; null in the number column and below the end of an arc.
    [[nodiscard]] std::optional<ReadingPlace> placeAt(const QModelIndex &index) const;
    [[nodiscard]] QModelIndex indexOf(const ReadingPlace &place) const;

signals:
    /// A text was typed into a cell.
    void typed(const QModelIndex &index, const QString &text);

private:
    struct ArcColumns {
        std::optional<Interval> evaluated;
        int angleDecimals = 0;
        int deviationDecimals = 0;
    };

    [[nodiscard]] int columnsPerArc() const { return m_unit == PointUnit::coordinates ? 3 : 2; }
    [[nodiscard]] std::size_t arcOf(int column) const {
        return static_cast<std::size_t>((column - 1) / columnsPerArc());
    }
    void dropRefused(const CircularMeasurement *now);
    [[nodiscard]] bool hasSameCells(const CircularMeasurement *measurement) const;
    [[nodiscard]] RefusedTexts::Cell cellOf(const QModelIndex &index) const;
    [[nodiscard]] const RefusedTexts::Refused *refused(const QModelIndex &index) const;
    [[nodiscard]] QString plainText(const QModelIndex &index, const ReadingPlace &place) const;
    [[nodiscard]] QString text(const Arc &arc, const ArcColumns &columns, std::size_t point, int part) const;

    std::shared_ptr<const Document> m_document; ///< owns the measurement
    const CircularMeasurement *m_measurement = nullptr;
    Language m_language{Language::Id::english};
    PointUnit m_unit = PointUnit::deviations;
    std::vector<ArcColumns> m_arcs;
    int m_rows = 0;
    std::string m_id; ///< ID of the test
    RefusedTexts m_refused;
};

} // namespace palmer::ui
