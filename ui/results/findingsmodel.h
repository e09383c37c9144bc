// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "ui/model/page.h"
#include "ui/quiettable.h"

#include <vector>

namespace palmer::ui {

struct FindingRow {
    Grade grade = Grade::note;
    Page page = Page::readings;
    QString id;     ///< of its field; empty if the line represents a page
    QString text;   ///< as in the report
    QString clause; ///< empty if unknown
};

/// The findings of a test as a list: those of the page in view one by one, those of each other page in one
/// line.
class FindingsModel : public RowModel<FindingRow> {
    Q_OBJECT

public:
    [[nodiscard]] static QString pageName(Page page);
    using Line = FindingRow;
    using RowModel::RowModel;

    /// Shows nothing if `test` is not in the document.
    void show(const EvaluatedDocument &evaluated, std::size_t test, Page page, const Language &language);
    [[nodiscard]] const Line &line(int row) const { return this->row(row); }
    /// "7 required missing · 1 warning · 2 notes".
    [[nodiscard]] QString summary() const { return m_summary; }
    /// The same without notes; empty if there is nothing to do.
    [[nodiscard]] QString lack() const { return m_lack; }

protected:
    [[nodiscard]] QVariant cell(const FindingRow &line, int column, int role) const override;

private:
    [[nodiscard]] static QString gradeWord(Grade grade);
    void addFindings(const std::vector<Finding> &findings, const Document &document, Page page,
                     const Language &language);
    void addPage(const std::vector<Finding> &findings, const Document &document, Page page,
                 const Language &language);

    QString m_summary;
    QString m_lack;
};

} // namespace palmer::ui
