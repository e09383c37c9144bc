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

/// The readings of a drift test in the order of the file: time and deviation. The row below the last takes a
/// new reading, which is one as soon as both its numbers are there. What cannot be taken stays in its cell,
/// and half a reading in its row, until it is put right: also while other tests are in view.
class DriftModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { time, deviation, columns };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    /// How readings are put into the document: from this row on.
    void setWriter(std::function<void(std::size_t row, const std::vector<DriftReading> &readings)> write) {
        m_write = std::move(write);
    }
    [[nodiscard]] std::size_t readings() const;
    /// What was typed and is in no document: refused texts, and halves of new readings.
    [[nodiscard]] QStringList unfinishedTexts() const;
    /// Takes back the text that was refused last, if no step came since; false: none was.
    bool undoRefused();
    /// A step was taken: what was refused before it stays.
    void keepRefused() { m_lastRefused = QPersistentModelIndex(); }

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;

signals:
    /// What was typed cannot be taken: why not. Empty: it can.
    void refusedText(const QString &reason);

private:
    [[nodiscard]] Quantity quantity(int column) const;
    [[nodiscard]] std::optional<double> value(const QModelIndex &index) const;
    [[nodiscard]] const RefusedTexts::Refused *refused(const QModelIndex &index) const;
    void dropRefused(const DriftMeasurement *now);

    std::shared_ptr<const Document> m_document; ///< owns the measurement
    const DriftMeasurement *m_measurement = nullptr;
    int m_rows = 0; ///< one for each reading, and one for the next
    Language m_language{Language::Id::english};
    struct NewReading {
        std::array<std::optional<double>, columns> numbers; ///< s; mm or degrees
        std::array<QString, columns> texts;                 ///< as typed
    };
    std::string m_id;                               ///< of the test
    std::map<std::string, NewReading> m_beginnings; ///< of readings that are being added, by test
    RefusedTexts m_refused;
    QPersistentModelIndex m_lastRefused;
    std::function<void(std::size_t, const std::vector<DriftReading> &)> m_write;
};

} // namespace palmer::ui
