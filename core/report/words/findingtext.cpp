// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/findingtext.h"

#include "kernel/evaluation/accordance.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/testevaluation.h"
#include "report/words/accordancetext.h"

#include <QStringList>
#include <algorithm>
#include <array>

namespace palmer {

namespace {

QString withRemark(const QString &sentence, Source source, const Language &language) {
    return source == Source::practice
               ? sentence + u' ' + language.text(REPORT_TEXT("report", "(practice; text not available)"))
               : sentence;
}

/// The sentences of a line; names that complete the same sentence are listed in it.
QString sentencesOf(std::span<const Finding *const> line, const Language &language, bool counted) {
    QStringList sentences;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Finding &finding = *line[i];
        if (finding.name.empty()) {
            sentences << language.sentence(finding.message);
            continue;
        }
        const auto same = [&](const Finding *other) {
            return !other->name.empty() && other->message.text == finding.message.text;
        };
        const auto end = line.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::any_of(line.begin(), end, same))
            continue;
        QStringList names;
        for (const Finding *other : line) {
            if (same(other))
                names << findingName(*other, language);
        }
        Message message = finding.message;
        const bool composed =
            std::ranges::any_of(names, [](const QString &name) { return name.contains(u','); });
        message.arguments.at(0) =
            names.join(composed ? language.semicolon() : QStringLiteral(", ")).toStdString();
        if (counted)
            message.arguments.at(1) = " (" + std::to_string(names.size()) + ')';
        sentences << language.sentence(message);
    }
    sentences.removeDuplicates();
    return sentences.join(u' ');
}

} // namespace

QString findingName(const Finding &finding, const Language &language) {
    if (finding.name.empty())
        return {};
    QString name = language.text(finding.name);
    if (!finding.results.empty())
        name += QStringLiteral(" (") + QString::fromStdString(finding.results) + u')';
    return finding.letter.empty() ? name
                                  : QString::fromStdString(finding.letter) + QStringLiteral(") ") + name;
}

QString findingsText(std::span<const Finding *const> findings, const Language &language) {
    return sentencesOf(findings, language, true);
}

QString findingText(const Finding &finding, const Language &language) {
    return withRemark(sentencesOf(std::array{&finding}, language, false), finding.source, language);
}

QString missingStatements(int count, const Language &language) {
    return language.sentence({REPORT_TEXT_COUNTED("report", "%n required statement(s) missing"), {}, count});
}

QString findingsByGrade(const TestEvaluation &evaluation, const Language &language) {
    const bool wasRead = evaluation.edition && evaluation.edition->textRead != TextRead::none;
    QStringList parts{requirementsText(evaluation, language)};
    const auto add = [&](const Text &words, Grade grade) {
        const auto count = std::ranges::count_if(evaluation.findings, [&](const Finding &finding) {
            return finding.grade == grade && !countsForAccordance(finding, wasRead);
        });
        if (count > 0)
            parts << language.sentence({words, {}, static_cast<int>(count)});
    };
    add(REPORT_TEXT_COUNTED("report", "%n recommendation(s)"), Grade::recommendation);
    add(REPORT_TEXT_COUNTED("report", "%n note(s)"), Grade::note);
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

CountedFindings countedFindings(const TestEvaluation &evaluation, const Language &language) {
    const bool wasRead = evaluation.edition && evaluation.edition->textRead != TextRead::none;
    int missing = 0;
    std::array<int, 3> others{}; // by grade; requirements are those of the text, counted above
    for (const Finding &finding : evaluation.findings) {
        if (!countsForAccordance(finding, wasRead))
            ++(lackOf(finding) == Lack::required ? missing
                                                 : others.at(static_cast<std::size_t>(finding.grade)));
    }
    QStringList parts;
    if (QString requirements = requirementsText(evaluation, language); !requirements.isEmpty())
        parts << std::move(requirements);
    const auto add = [&](const Text &words, int count) {
        if (count > 0)
            parts << language.sentence({words, {}, count});
    };
    if (parts.isEmpty() && missing > 0)
        parts << missingStatements(missing, language);
    else
        add(REPORT_TEXT_COUNTED("report", "%n other required statement(s) missing"), missing);
    add(REPORT_TEXT_COUNTED("report", "%n recommendation(s)"), others[1]);
    const QString between = QStringLiteral(" · ");
    QString lack = parts.join(between);
    add(REPORT_TEXT_COUNTED("report", "%n note(s)"), others[2]);
    return {std::move(lack), parts.join(between)};
}

} // namespace palmer
