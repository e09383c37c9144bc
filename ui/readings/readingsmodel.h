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

/// The readings of a positioning test as a table: one row per target; columns i, P, the runs and the
/// computed values. Never edits the document: typing goes to the ReadingsEditor. If rows and columns stay
/// the same, only their data change, so that an open editor stays open. Over 500 lines: each role of a cell
/// and of a heading has its function.
class ReadingsModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Role {
        excludedRole = Qt::UserRole + 1, ///< bool: excluded
        missingRole,                     ///< bool
        groupEndRole,                    ///< bool: a heavier rule follows the column
        refusedRole,                     ///< text: why the typed text is not a number; empty if it is
        outlierRole,                     ///< bool: possible outlier
    };
    enum Column { numberColumn, positionColumn, firstReadingColumn };

    /// Content of a column in the lower header row, and its group title above.
    struct Head {
        Formula text;
        std::optional<Direction> approach; ///< colour of the text
        QString group;                     ///< the same for neighbours that share a title
        QString name;                      ///< in words
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows test `test` of the document; empty if it is not a positioning test.
    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    void setUnit(ReadingUnit unit);
    [[nodiscard]] ReadingUnit unit() const { return m_unit; }
    [[nodiscard]] const Language &language() const { return m_language; }
    void setGrouping(ReadingGrouping grouping);
    void retranslate(); ///< updates the header texts

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

    [[nodiscard]] const PositioningMeasurement *measurement() const { return m_measurement; }
    /// The runs in column order, starting at firstReadingColumn.
    [[nodiscard]] std::vector<std::size_t> runs() const;
    /// The text of a cell for a spreadsheet or editor: all digits, ungrouped.
    [[nodiscard]] QString plainText(const QModelIndex &index) const;
    /// Shows a refused target position in its cell until it is corrected.
    void refuseTarget(std::size_t target, const QString &text, const QString &reason);
    void acceptTarget(std::size_t target);
    [[nodiscard]] const RefusedTexts &refusedTargets() const { return m_refusedTargets; }
    [[nodiscard]] const Head &head(int column) const { return m_heads[static_cast<std::size_t>(column)]; }
    [[nodiscard]] int computedColumn() const; ///< the first computed column
    [[nodiscard]] std::optional<ReadingPlace> placeAt(const QModelIndex &index) const;
    [[nodiscard]] QModelIndex indexOf(const ReadingPlace &place) const;
    /// Explains why excluded readings among the places stay and how to change them; empty if there are none.
    [[nodiscard]] static QKeySequence bringBackKeys();
    [[nodiscard]] QString keptAside(const std::vector<ReadingPlace> &places) const;
    /// Mean and range of the readings among the indexes; empty if there are none.
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
    std::string m_id;              ///< ID of the test
    RefusedTexts m_refusedTargets; ///< by row
};

} // namespace palmer::ui
