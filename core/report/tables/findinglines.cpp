// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/findinglines.h"

#include "report/words/findingtext.h"
#include "report/words/wording.h"

#include <algorithm>
#include <tuple>

namespace palmer {

namespace {

/// Clause that decides the line: "6 (4.4 b)" is printed with "6".
std::string_view mainClause(const std::string &clause) {
    return std::string_view(clause).substr(0, clause.find(" ("));
}

/// True if two findings are printed on one line. Sentences without a clause stay apart, as they have nothing
/// in common; so do points that were not agreed and points that were not declared.
bool onOneLine(const Finding &a, const Finding &b) {
    const bool anySentence = !a.clause.empty() && a.subject != Subject::agreedPoints;
    return a.source == b.source && a.grade == b.grade && a.state == b.state &&
           mainClause(a.clause) == mainClause(b.clause) &&
           (anySentence || (!a.name.empty() && !b.name.empty() && a.message.text == b.message.text));
}

auto orderOf(const Finding &finding) {
    const int state = finding.state ? static_cast<int>(*finding.state) : 2;
    return std::tuple(finding.source, finding.grade, state);
}

QString headingOf(Source source, const Edition *edition, const Language &language) {
    switch (source) {
    case Source::text:
        return language.sentence(REPORT_TEXT("report", "Asked by the text of %1"),
                                 {standardName(language, edition).toStdString()});
    case Source::practice:
        return language.text(REPORT_TEXT("report", "Practice (text not available)"));
    case Source::laboratory:
        return language.text(REPORT_TEXT_FOR("report", "Laboratory", "source of findings"));
    case Source::program:
        return QStringLiteral("Palmer");
    }
    return {};
}

QString clauseOf(const std::vector<const Finding *> &line, const Language &language) {
    const std::string &first = line.front()->clause;
    const bool same = std::ranges::all_of(line, [&](const Finding *f) { return f->clause == first; });
    return clauseText(same ? first : std::string(mainClause(first)), language);
}

} // namespace

FindingsBlock findingLines(const TestEvaluation &evaluation, const Language &language, FindingsOf which) {
    std::vector<std::vector<const Finding *>> lines;
    for (const Finding &finding : evaluation.findings) {
        if (which != FindingsOf::all && (finding.source == Source::text) != (which == FindingsOf::text))
            continue;
        const auto found =
            std::ranges::find_if(lines, [&](const auto &line) { return onOneLine(*line.front(), finding); });
        if (found == lines.end())
            lines.push_back({&finding});
        else
            found->push_back(&finding);
    }
    std::ranges::stable_sort(lines, {}, [](const auto &line) { return orderOf(*line.front()); });

    FindingsBlock block;
    std::optional<Source> source;
    for (const auto &line : lines) {
        const Finding &first = *line.front();
        FindingLine printed;
        if (source != first.source && which != FindingsOf::text)
            printed.heading = headingOf(first.source, evaluation.edition, language);
        source = first.source;
        // An undeclared requirement is no fault: it has the mark of an open one.
        printed.grade =
            first.state == State::undeclared ? std::max(first.grade, Grade::recommendation) : first.grade;
        printed.gradeName = language.text(gradeText(first.grade));
        printed.clause = clauseOf(line, language);
        printed.sentence = withSymbols(findingsText(line, language), evaluation.parameters);
        block.lines.push_back(std::move(printed));
    }
    return block;
}

} // namespace palmer
