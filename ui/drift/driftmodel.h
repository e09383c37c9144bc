// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "editing/driftreadings.h"
#include "language/language.h"
#include "ui/refusedtexts.h"

#include <QAbstractTableModel>
#include <QPersistentModelIndex>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace palmer::ui {

/// The readings of a drift test in file order: time and deviation. The row after the last takes a new
/// reading, which is added once both numbers are there. Refused texts and half readings stay in their cells
/// until corrected, even while other tests are in view. Channels and temperatures, which come from files, are
/// shown in columns of their own and not typed.
class DriftModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { time, deviation, columns };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    /// Callback that writes readings to the document from this row on.
    void setWriter(std::function<void(std::size_t row, const std::vector<DriftReading> &readings)> write) {
        m_write = std::move(write);
    }
    [[nodiscard]] std::size_t readings() const;
    /// Texts typed that are not in the document: refused ones and half readings.
    [[nodiscard]] QStringList unfinishedTexts() const;
    /// Undoes the last refused text if no undo step followed. False if there is none.
    bool undoRefused();
    /// An undo step followed: texts refused before can no longer be undone.
    void keepRefused() { m_lastRefused = QPersistentModelIndex(); }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

signals:
    /// Why the typed text was refused; empty if it was accepted.
    void refusedText(const QString &reason);

private:
    [[nodiscard]] bool isTyped() const { return m_measurement && m_measurement->channels.empty(); }
    [[nodiscard]] Quantity quantity(int column) const;
    /// Values of a column of channels or temperatures.
    [[nodiscard]] const std::vector<std::optional<double>> &series(int column) const;
    [[nodiscard]] std::optional<double> value(const QModelIndex &index) const;
    [[nodiscard]] const RefusedTexts::Refused *refused(const QModelIndex &index) const;
    void dropRefused(const DriftMeasurement *now);

    std::shared_ptr<const Document> m_document; ///< owns the measurement
    const DriftMeasurement *m_measurement = nullptr;
    int m_rows = 0; ///< one per reading and one for the next
    Language m_language{Language::Id::english};
    struct NewReading {
        std::array<std::optional<double>, columns> numbers; ///< s; mm or degrees
        std::array<QString, columns> texts;                 ///< as typed
    };
    std::string m_id;                               ///< ID of the test
    std::map<std::string, NewReading> m_beginnings; ///< incomplete new readings by test
    RefusedTexts m_refused;
    QPersistentModelIndex m_lastRefused;
    std::function<void(std::size_t, const std::vector<DriftReading> &)> m_write;
};

} // namespace palmer::ui
