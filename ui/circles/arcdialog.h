// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/arctable.h"
#include "language/language.h"
#include "ui/qtforward.h"

#include <QDialog>
#include <string_view>
#include <vector>

namespace palmer::ui {

class RemarkList;

/// "New arc…": a table of points typed or pasted and, next to it, how it was understood and what the user may
/// decide. It can be accepted only once all guesses and doubts have been answered.
class ArcDialog : public QDialog {
    Q_OBJECT

public:
    /// The points are interpreted for this circle. `text`: initial text of the table.
    ArcDialog(CircularMeasurement circle, const Language &language, const QString &text,
              QWidget *parent = nullptr);

    /// The arcs as last interpreted.
    [[nodiscard]] const std::vector<Arc> &arcs() const { return m_arcs; }

    /// True if a clipboard text may be a table of points: lines of numbers.
    [[nodiscard]] static bool looksLikePoints(const QString &text);

private:
    QFormLayout *makeForm();
    QComboBox *addChoice(QFormLayout &form, const char *name, const QString &label);
    void fillWords(QComboBox &box, const char *key, bool (*isOfCircle)(std::string_view word));
    QLineEdit *addAngle(QFormLayout &form, const char *name, const QString &label, double value);
    void read();
    void showTable(const ArcTable &table);
    void showProblem(const QString &problem);
    void answer(const QString &id, const QString &word);
    void confirmAll();
    [[nodiscard]] ArcTable readTable(const std::string &text) const;

    CircularMeasurement m_circle;
    Language m_language;
    std::vector<Arc> m_arcs;
    std::vector<Question> m_questions; ///< which prevent adding the arcs
    ImportOptions m_answers;           ///< in addition to the choices, valid for the numbers as last read
    QPlainTextEdit *m_text;
    std::vector<QComboBox *> m_choices; ///< of the import, in the order of the form; each knows its key
    QComboBox *m_content = nullptr;
    QComboBox *m_sense = nullptr;
    QComboBox *m_reference = nullptr;
    QLineEdit *m_start = nullptr;
    QLineEdit *m_way = nullptr;
    QLabel *m_problem;
    QLabel *m_paths;
    RemarkList *m_remarks;
    QScrollArea *m_remarksPlace;
    QPushButton *m_confirmAll;
    QPushButton *m_add;
};

} // namespace palmer::ui
