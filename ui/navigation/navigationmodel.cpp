// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/navigation/navigationmodel.h"

#include "kernel/measurement/readingsaside.h"
#include "kernel/measurement/testfacts.h"
#include "report/parts/parts.h"
#include "report/words/findingtext.h"
#include "report/words/wording.h"
#include "ui/testname.h"
#include "ui/windowlanguage.h"

#include <algorithm>
#include <utility>

namespace palmer::ui {

QString testIcon(const Test &test) {
    switch (kindOf(test)) {
    case Kind::positioning:
        return QStringLiteral("axis");
    case Kind::circular:
        return QStringLiteral("circle");
    case Kind::drift:
        return QStringLiteral("trend");
    }
    return {};
}

QString shortStandard(const std::string &edition) {
    const QString word = QString::fromStdString(edition).section(u':', 0, 0);
    return word.startsWith(QLatin1StringView("ISO ")) ? word.mid(4) : word;
}

void NavigationModel::show(const EvaluatedDocument &evaluated) {
    const EvaluatedDocument before = std::exchange(m_evaluated, evaluated);
    rebuild(before);
}

void NavigationModel::retranslate() {
    rebuild({});
}

/// The row of a test, unless it is another test or outcome than before.
const NavigationRow *NavigationModel::unchanged(std::size_t test, const EvaluatedDocument &before) const {
    const bool same = test < before.tests.size() && before.tests[test] == m_evaluated.tests[test] &&
                      before.document->tests[test] == m_evaluated.document->tests[test];
    const std::size_t heads = m_rows.size() - std::min(m_rows.size(), before.tests.size());
    return same && heads + test < m_rows.size() ? &m_rows[heads + test] : nullptr;
}

std::vector<NavigationRow> NavigationModel::rows(const EvaluatedDocument &before) const {
    std::vector<NavigationRow> result;
    if (!m_evaluated.document)
        return result;
    const auto missing = [this](Page page) {
        int most = 0; // shared statements are counted in every test
        for (std::size_t test = 0; test < m_evaluated.tests.size(); ++test)
            most = std::max(most, countMissing(m_evaluated, test, page));
        return most;
    };
    const auto openRows = [this] {
        const std::vector<SheetResult> rows = m_evaluated.sheet();
        return static_cast<int>(std::ranges::count_if(rows, [](const SheetResult &row) {
            return row.state != SheetState::conforms && row.state != SheetState::notApplicable;
        }));
    };
    const auto page = [&](const QString &name, const QString &icon, Page which) {
        NavigationRow row;
        row.name = name;
        row.icon = icon;
        row.count = missing(which);
        row.page = which;
        return row;
    };
    const auto head = [](const QString &name) {
        NavigationRow row;
        row.name = name;
        return row;
    };
    result.push_back(head(tr("Report")));
    result.push_back(page(tr("Identification"), QStringLiteral("doc"), Page::identification));
    result.push_back(page(tr("Machine"), QStringLiteral("machine"), Page::machine));
    result.push_back(page(tr("Instruments"), QStringLiteral("laser"), Page::instruments));
    result.push_back(page(windowLanguage().text(REPORT_TEXT("report", "Acceptance sheet")),
                          QStringLiteral("check"), Page::sheet));
    result.back().count = openRows();
    result.push_back(head(tr("Tests")));
    for (std::size_t i = 0; i < m_evaluated.document->tests.size(); ++i) {
        if (const NavigationRow *known = unchanged(i, before)) {
            result.push_back(*known);
            continue;
        }
        const Test &test = *m_evaluated.document->tests[i];
        NavigationRow row;
        row.name = testName(test);
        row.icon = testIcon(test);
        row.test = i;
        const TestEvaluation &evaluation = *m_evaluated.tests[i];
        if (test.role != TestRole::notStated)
            row.role = windowLanguage().text(roleText(test.role));
        const bool unfinished = isUnfinished(test);
        if (unfinished) {
            row.mark = {QStringLiteral("dots"), Token::secondaryText, tr("unfinished")};
        } else if (evaluation.edition && !evaluation.view) {
            row.mark = limitsMark(evaluation.verdict, hasLimits(test.limits));
            if (evaluation.provisional)
                row.mark = {QStringLiteral("dots"), Token::secondaryText, tr("provisional")};
            row.accordance = accordanceMark(evaluation.accordance());
        }
        QStringList detail;
        if (unfinished)
            detail += tr("unfinished");
        else if (test.date)
            detail += windowLanguage().shortDate(*test.date);
        if (evaluation.edition)
            detail += shortStandard(evaluation.edition->word);
        row.detail = detail.join(QStringLiteral(" · "));
        result.push_back(std::move(row));
    }
    return result;
}

void NavigationModel::rebuild(const EvaluatedDocument &before) {
    std::vector<NavigationRow> next = rows(before);
    if (next.size() != m_rows.size())
        return reset(std::move(next));
    const auto differ = [&](std::size_t row) { return next[row] != m_rows[row]; };
    std::size_t first = 0;
    while (first < next.size() && !differ(first))
        ++first;
    std::size_t last = next.size();
    while (last > first && !differ(last - 1))
        --last;
    if (first == last)
        return;
    m_rows = std::move(next); // keeps the selection
    emit dataChanged(index(static_cast<int>(first)), index(static_cast<int>(last) - 1));
}

QModelIndex NavigationModel::indexOf(Page page) const {
    const auto found = std::ranges::find(m_rows, std::optional(page), &NavigationRow::page);
    return found == m_rows.end() ? QModelIndex() : index(static_cast<int>(found - m_rows.begin()));
}

QModelIndex NavigationModel::indexOfTest(std::size_t test) const {
    const auto found = std::ranges::find(m_rows, std::optional(test), &NavigationRow::test);
    return found == m_rows.end() ? QModelIndex() : index(static_cast<int>(found - m_rows.begin()));
}

std::optional<Page> NavigationModel::pageAt(const QModelIndex &index) const {
    return index.isValid() ? row(index.row()).page : std::nullopt;
}

std::optional<std::size_t> NavigationModel::testAt(const QModelIndex &index) const {
    return index.isValid() ? row(index.row()).test : std::nullopt;
}

QVariant NavigationModel::cell(const NavigationRow &row, int, int role) const {
    switch (role) {
    case Qt::DisplayRole:
        return row.name;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole: {
        QStringList parts{row.name};
        for (const QString &text : {row.detail, row.role, row.mark.word, row.accordance.word}) {
            if (!text.isEmpty() && !parts.contains(text))
                parts += text;
        }
        if (row.count > 0)
            parts += missingStatements(row.count, windowLanguage());
        if (role == Qt::ToolTipRole && row.isHead())
            return {};
        return parts.join(QStringLiteral(", "));
    }
    case iconRole:
        return row.icon;
    case markRole:
        return row.mark.icon;
    case accordanceRole:
        return row.accordance.icon;
    default:
        return {};
    }
}

Qt::ItemFlags NavigationModel::flags(const QModelIndex &index) const {
    const bool isHead = index.isValid() && row(index.row()).isHead();
    return isHead ? Qt::ItemFlags(Qt::NoItemFlags) : RowModel::flags(index);
}

} // namespace palmer::ui
