// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/findingsmodel.h"

#include "kernel/evaluation/accordance.h"
#include "report/words/findingtext.h"
#include "report/words/wording.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <tuple>

namespace palmer::ui {

namespace {

constexpr std::array pages{Page::readings,    Page::conditions,     Page::agreedPoints, Page::limits,
                           Page::uncertainty, Page::identification, Page::machine,      Page::instruments};

} // namespace

QString FindingsModel::pageName(Page page) {
    switch (page) {
    case Page::identification:
        return tr("Identification");
    case Page::machine:
        return tr("Machine");
    case Page::instruments:
        return tr("Instruments");
    case Page::readings:
        return tr("Readings");
    case Page::conditions:
        return tr("Conditions");
    case Page::agreedPoints:
        return tr("Agreed points");
    case Page::limits:
        return tr("Limits");
    case Page::uncertainty:
        return tr("Uncertainty");
    case Page::sheet: // its findings are no test's
    case Page::comparison:
    case Page::thermal:
    case Page::diagnosis: // only an interpretation, nothing is missing
        break;
    }
    return {};
}

QString FindingsModel::gradeWord(Grade grade) {
    switch (grade) {
    case Grade::requirement:
        return tr("Required");
    case Grade::recommendation:
        return tr("Recommendation");
    case Grade::note:
        return tr("Note");
    }
    return {};
}

void FindingsModel::show(const EvaluatedDocument &evaluated, std::size_t test, Page page,
                         const Language &language) {
    beginResetModel();
    m_rows.clear();
    m_summary.clear();
    m_lack.clear();
    if (test < evaluated.tests.size()) {
        const std::vector<Finding> &findings = evaluated.tests[test]->findings;
        addFindings(findings, *evaluated.document, page, language);
        for (const Page other : pages) {
            if (other != page)
                addPage(findings, *evaluated.document, other, language);
        }
        CountedFindings counted = countedFindings(*evaluated.tests[test], language);
        m_lack = std::move(counted.lack);
        m_summary = counted.all.isEmpty() ? tr("none") : std::move(counted.all);
    }
    endResetModel();
}

/// Adds a line for each finding that is resolved on the page.
void FindingsModel::addFindings(const std::vector<Finding> &findings, const Document &document, Page page,
                                const Language &language) {
    std::vector<const Finding *> here;
    for (const Finding &finding : findings) {
        if (pageOf(finding, document) == page)
            here.push_back(&finding);
    }
    std::ranges::stable_sort(here, {},
                             [](const Finding *f) { return std::tuple(f->source, f->grade, f->state); });
    for (const Finding *finding : here) {
        m_rows.push_back({finding->grade, page, fieldOf(*finding), findingText(*finding, language),
                          clauseText(finding->clause, language)});
    }
}

/// Adds one line for the findings of another page, if any.
void FindingsModel::addPage(const std::vector<Finding> &findings, const Document &document, Page page,
                            const Language &language) {
    int all = 0;
    int missing = 0;
    Grade worst = Grade::note;
    for (const Finding &finding : findings) {
        if (pageOf(finding, document) != page)
            continue;
        ++all;
        missing += lackOf(finding) == Lack::required ? 1 : 0;
        worst = std::min(worst, finding.grade);
    }
    if (all == 0)
        return;
    QStringList parts; // the number of the page's badge first
    if (missing > 0)
        parts << missingStatements(missing, language);
    if (all > missing)
        parts << tr("%n finding(s)", nullptr, all - missing);
    const QString text = parts.join(QStringLiteral(" · "));
    const QString line = tr("%1: %2", "page: what is found there").arg(pageName(page), text);
    m_rows.push_back({worst, page, {}, line, {}});
}

QVariant FindingsModel::cell(const FindingRow &line, int, int role) const {
    switch (role) {
    case Qt::DisplayRole:
        return line.text;
    case Qt::ToolTipRole:
        return gradeWord(line.grade) + QStringLiteral(" – ") + line.text;
    case Qt::AccessibleTextRole:
        return gradeWord(line.grade) + QStringLiteral(": ") + line.text + u' ' + line.clause;
    default:
        return {};
    }
}

} // namespace palmer::ui
