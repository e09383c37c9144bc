// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/newtest.h"
#include "editing/typedreading.h"
#include "kernel/planning/targetplan.h"
#include "language/language.h"
#include "ui/qtforward.h"

#include <QDialog>
#include <array>
#include <optional>

namespace palmer::ui {

inline constexpr int mostRuns = 1000; ///< each way, accepted by a dialog

class PasteBar;
class StatementsBox;

/// Asks for the parameters of a new positioning test. Targets are proposed by the edition's rule, with a new
/// random part for every test; a list typed or pasted takes precedence. Typed text is left as it is; an
/// invalid number is reported below its field.
class NewTestDialog : public QDialog {
    Q_OBJECT

public:
    /// `like`: a test whose edition is proposed, and the axis following its own; may be null.
    explicit NewTestDialog(Language language, const Test *like = nullptr, QWidget *parent = nullptr);

    /// The values entered; complete once the dialog is accepted.
    [[nodiscard]] NewPositioningTest wanted() const;

    /// Offers to copy the statements of a test of the same file; initially checked.
    void offerStatementsOf(const Test &test);
    [[nodiscard]] bool takesStatements() const;

private:
    struct Problem {
        QWidget *field = nullptr; ///< null if there is no problem
        QString sentence;
    };

    void fillFields(const Test *like);
    void makeForm();
    void connectFields();
    void propose();
    void writeTargets(const QString &text);
    void check();
    [[nodiscard]] Problem problem() const;
    /// An integer from `least` to `most`; null if the field has none.
    [[nodiscard]] std::optional<std::size_t> whole(const QLineEdit *field, std::size_t least,
                                                   std::size_t most) const;
    [[nodiscard]] Axis axis() const;
    [[nodiscard]] std::optional<double> number(const QLineEdit *field) const;
    [[nodiscard]] std::optional<PastedTargets> readTargets(QString *problem = nullptr) const;
    [[nodiscard]] std::optional<std::vector<double>> targets() const;
    void showRead();
    void showListed();
    [[nodiscard]] TargetRequest request() const;
    [[nodiscard]] TargetPlan planned() const;
    [[nodiscard]] QString whyOf(const TargetPlan &plan) const;

    Language m_language;
    bool m_proposed = false; ///< the list was proposed, not typed
    bool m_listed = false;   ///< the list was typed, not proposed
    std::uint64_t m_seed;    ///< for the random part
    TargetChoice m_choice;   ///< of the last proposed targets
    QLineEdit *m_name;
    QComboBox *m_motion;
    QLineEdit *m_travel;
    QComboBox *m_edition;
    QComboBox *m_cycle;
    QLineEdit *m_runs;
    QCheckBox *m_both;
    QLineEdit *m_first;
    QLineEdit *m_last;
    QLineEdit *m_count;
    QPlainTextEdit *m_list;
    PasteBar *m_read; ///< how a list that was pasted was understood
    ImportOptions m_answers;
    StatementsBox *m_statements;
    QLabel *m_why; ///< where the last target lies, and why
    QLabel *m_problem;
    std::array<QLabel *, 4> m_units{};
    QFormLayout *m_form = nullptr;
    const QWidget *m_problemAt = nullptr; ///< the field above the message
    QPushButton *m_create;
};

} // namespace palmer::ui
