// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/limitblock.h"
#include "report/words/formula.h"
#include "ui/forms/form.h"

class QLabel;

namespace palmer::ui {

/// The agreed limits of a test and the decision rule. Never beside a verdict.
class TablePaste;

class LimitsPage : public Form {
    Q_OBJECT

public:
    LimitsPage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);

protected:
    void prepare() override;
    void refreshOthers() override;
    /// Takes what a spreadsheet copied where a field would take its first line.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Puts the limits of the clipboard in, from that row on where no symbols stand there; or says why not.
    void pasteLimits(std::size_t row);

    /// A limit as a row of the table: what it is of, its value, edition and origin.
    void addLimit(const Formula &symbol, const std::vector<const Term *> &terms, const std::string &id,
                  Kind kind);

    struct Name {
        QLabel *label = nullptr;
        std::vector<const Term *> terms; ///< what it limits; empty: nothing of this edition
    };

    TablePaste *m_pasted; ///< what was pasted last
    std::size_t m_pastedTest = 0;
    std::vector<Name> m_names;
    Field *m_first = nullptr;       ///< the limit below the head of its column
    std::vector<LimitName> m_ids;   ///< of the rows
    std::vector<QWidget *> m_edits; ///< their limits
    Quantity m_quantity = Quantity::deviation;
    QStringList m_built; ///< for which edition and parameters there are fields
};

} // namespace palmer::ui
