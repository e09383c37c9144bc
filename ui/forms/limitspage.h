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
    /// Takes a table pasted from a spreadsheet, of which a field would take only the first line.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Inserts limits from the clipboard, from that row on if without symbols; shows an error on failure.
    void pasteLimits(std::size_t row);

    /// A limit as a table row: its parameter and value; edition and origin only where those of the rows
    /// differ.
    void addLimit(const Formula &symbol, const std::vector<const Term *> &terms, const std::string &id,
                  Kind kind, bool rowByRow);
    Field *addEdition(const char *label, Kind kind, const Member<std::optional<std::string>> &member);

    struct Name {
        QLabel *label = nullptr;
        std::vector<const Term *> terms; ///< limited parameters; empty if the edition has none of them
    };

    TablePaste *m_pasted; ///< what was pasted last
    std::size_t m_pastedTest = 0;
    std::vector<Name> m_names;
    Field *m_first = nullptr;       ///< the limit below its column heading
    std::vector<LimitName> m_ids;   ///< per row
    std::vector<QWidget *> m_edits; ///< the limit fields
    Quantity m_quantity = Quantity::deviation;
    QStringList m_built; ///< edition and parameters the fields were built for
};

} // namespace palmer::ui
