// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/documenterror.h"
#include "document/evaluateddocument.h"
#include "export/compensation.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QDialog>
#include <functional>
#include <optional>
#include <vector>

namespace palmer::ui {

class Field;
class LineView;

/// "Compensation table…": a table for a control that compensates the systematic deviations of an axis. Shows
/// the table and the predicted result of using it, computed from the table as written: mean deviations over
/// the measured ones, and A, E, M, B. A table of a control can be compared with it. Changes no document.
class CompensationDialog : public Translated<QDialog> {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CompensationDialog)

public:
    /// `test` is the index of a positioning test.
    CompensationDialog(EvaluatedDocument evaluated, std::size_t test, QWidget *parent = nullptr);
    /// Hides first, so that a focused field commits its text while the dialog still exists.
    ~CompensationDialog() override { hide(); }

    [[nodiscard]] const QByteArray &written() const { return m_written; } ///< empty if there is no table
    [[nodiscard]] CompensationFormat format() const;
    /// Writes the table; on failure shows a message and returns false.
    bool saveTo(const QString &path);
    /// Compares a control's table with the written one; if it is unreadable, shows a message and returns
    /// false.
    bool compareWith(const QString &path);

signals:
    /// The user confirms that the deviations are actual − target, or withdraws this.
    void signConfirmed(bool confirmed);

private:
    struct NumberField {
        Field *field = nullptr;
        const char *label = nullptr;
        std::optional<double> CompensationOptions::*value = nullptr;
    };

    Field *addChoice(const char *name);
    Field *addNumber(const char *name, const char *label, std::optional<double> CompensationOptions::*value);
    QCheckBox *addSwitch(const char *name, bool CompensationOptions::*value);
    [[nodiscard]] CompensationOptions optionsFor(CompensationFormat kind) const;
    [[nodiscard]] QString notes() const;
    void compute();
    void predict(const CompensationTable &table);
    void showPrediction();
    void chooseFile();
    void chooseTable();
    void retranslate() final;

    EvaluatedDocument m_evaluated;
    std::size_t m_test;
    CompensationOptions m_options;
    QByteArray m_written;
    std::vector<Message> m_remarks; ///< on the written table
    std::optional<FoundTable> m_compared;
    QString m_comparedName;
    TableDifference m_difference;
    std::optional<TestEvaluation> m_before; ///< evaluated under an edition with E, M and B
    std::optional<TestEvaluation> m_after;
    std::optional<TestEvaluation> m_withCompared;
    std::optional<Error> m_refusal;
    std::vector<NumberField> m_numbers;

    Field *m_format;
    QCheckBox *m_signConfirmed; ///< shown if the readings' file does not define the sign
    QCheckBox *m_perDirection;
    Field *m_sign;
    QCheckBox *m_incremental;
    Field *m_encoder;
    Field *m_reference = nullptr; ///< made with its form row
    Field *m_mark;
    QLabel *m_reason;
    QLabel *m_tableTitle;
    QPlainTextEdit *m_table;
    QLabel *m_curveTitle;
    LineView *m_curve;
    QLabel *m_predictionTitle;
    QTableWidget *m_prediction;
    QLabel *m_note;
    QPushButton *m_compare;
    QPushButton *m_save;
    QPushButton *m_close;
};

} // namespace palmer::ui
