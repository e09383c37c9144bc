// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/tables/readingtable.h"
#include "ui/model/selection.h"
#include "ui/refusedtexts.h"

#include <QAbstractTableModel>
#include <QKeySequence>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace palmer::ui {

/// The readings of a positioning test as a table: one row a target; columns i, P, the runs, and what is
/// computed of them. Shows a document, changes none: what is typed goes to the ReadingsEditor. Without a
/// change of rows and columns only their data change, so that whoever types stays where he is.
class ReadingsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role {
        excludedRole = Qt::UserRole + 1, ///< bool: set aside
        missingRole,                     ///< bool
        groupEndRole,                    ///< bool: a stronger rule follows the column
        refusedRole,                     ///< text: why what was typed is no number; empty: it is one
        outlierRole,                     ///< bool: worth a second look
    };
    enum Column { numberColumn, positionColumn, firstReadingColumn };

    /// What a column of the lower storey of the head stands for, and the title above it.
    struct Head {
        Formula text;
        std::optional<Direction> approach; ///< colour of the text
        QString group;                     ///< same for neighbours that share a title
        QString name;                      ///< in words
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows test `test` of the document, or nothing where it is no positioning test.
    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    void setUnit(ReadingUnit unit);
    [[nodiscard]] ReadingUnit unit() const { return m_unit; }
    [[nodiscard]] const Language &language() const { return m_language; }
    void setGrouping(ReadingGrouping grouping);
    void retranslate(); ///< the words of the head

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

    [[nodiscard]] const PositioningMeasurement *measurement() const { return m_measurement; }
    /// The runs in the order of the columns, from firstReadingColumn on.
    [[nodiscard]] std::vector<std::size_t> runs() const;
    /// The text of a cell for a spreadsheet or a field: all its digits, not grouped.
    [[nodiscard]] QString plainText(const QModelIndex &index) const;
    /// A target position that was typed and cannot be one: shown until it is put right.
    void refuseTarget(std::size_t target, const QString &text, const QString &reason);
    void acceptTarget(std::size_t target);
    [[nodiscard]] const RefusedTexts &refusedTargets() const { return m_refusedTargets; }
    [[nodiscard]] const Head &head(int column) const { return m_heads[static_cast<std::size_t>(column)]; }
    [[nodiscard]] int computedColumn() const; ///< the first that is computed
    [[nodiscard]] std::optional<ReadingPlace> placeAt(const QModelIndex &index) const;
    [[nodiscard]] QModelIndex indexOf(const ReadingPlace &place) const;
    /// Why readings set aside among the places stay as they are, and how they are changed; empty: none is.
    [[nodiscard]] static QKeySequence bringBackKeys();
    [[nodiscard]] QString keptAside(const std::vector<ReadingPlace> &places) const;
    /// Mean and range of the readings among the indexes; empty where there is none.
    [[nodiscard]] QString summary(const QModelIndexList &indexes) const;
    /// The longest texts of a column, for its width.
    [[nodiscard]] QStringList widestTexts(int column) const;

private:
    [[nodiscard]] bool hasSameCells(const PositioningMeasurement *measurement,
                                    const TestEvaluation *evaluation) const;
    void rebuild();
    void dropRefused(const std::string &id, const PositioningMeasurement *now);
    [[nodiscard]] const RefusedTexts::Refused *refusedTarget(int row) const;
    [[nodiscard]] bool holds(const ReadingPlace &place) const;
    [[nodiscard]] QString text(const QModelIndex &index) const;
    [[nodiscard]] QString refusal(const QModelIndex &index) const;
    [[nodiscard]] QString toolTip(const QModelIndex &index) const;
    [[nodiscard]] QString accessibleText(const QModelIndex &index) const;

    std::shared_ptr<const Document> m_document; ///< owns the measurement
    TestEvaluationPointer m_evaluation;
    bool m_pending = false; ///< the evaluation has no results yet
    const PositioningMeasurement *m_measurement = nullptr;
    Language m_language{Language::Id::english};
    ReadingUnit m_unit = ReadingUnit::deviations;
    ReadingGrouping m_grouping = ReadingGrouping::byRun;
    std::optional<ReadingTexts> m_texts;
    std::vector<ReadingColumn> m_readings;
    std::vector<StatisticColumn> m_statistics;
    std::vector<Head> m_heads;
    std::set<ReadingPlace> m_outliers;
    std::string m_id;              ///< of the test
    RefusedTexts m_refusedTargets; ///< by the row
};

} // namespace palmer::ui
