// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/accordancetext.h"

#include "kernel/measurement/testfacts.h"
#include "kernel/words/characters.h"
#include "report/words/wording.h"

#include <QStringList>
#include <algorithm>
#include <array>

namespace palmer {

namespace {

const Text requirementsNotDeclared = REPORT_TEXT_COUNTED("report", "%n not declared");
const Text practiceNotDeclared =
    REPORT_TEXT_COUNTED_FOR("report", "%n not declared", "departures from practice");

/// ", 12 not declared"
QString notDeclared(const Text &words, int count, const Language &language) {
    return count == 0 ? QString() : QStringLiteral(", ") + language.sentence({words, {}, count});
}

class Sentence {
public:
    Sentence(const Test &test, const TestEvaluation &evaluation, const Language &language)
        : m_test(test)
        , m_evaluation(evaluation)
        , m_language(language)
        , m_standard(standardName(language, evaluation.edition))
        , m_counts(countRequirements(evaluation.findings)) {
        const auto &results = evaluation.results;
        m_countByPractice =
            partOr(false, results, [](auto &r) -> decltype(r.countByPractice) { return r.countByPractice; });
        m_stepCycle =
            partOr(false, results, [](auto &r) -> decltype(r.stepCycleAgreed) { return r.stepCycleAgreed; });
    }

    [[nodiscard]] QString text(bool page) const {
        QString result;
        switch (m_evaluation.accordance()) {
        case Accordance::notChecked:
            result = notChecked(page) + declared();
            break;
        case Accordance::no:
            result = unmet() + see(page);
            break;
        case Accordance::notShown:
            result = counted(REPORT_TEXT_COUNTED(
                                 "report", "Accordance with %1 not shown: %n requirement(s) not declared"),
                             m_counts.undeclared) +
                     see(page);
            break;
        case Accordance::partly:
            result = partly() + declared();
            break;
        case Accordance::yes:
            result = say(REPORT_TEXT("report", "Test carried out in accordance with %1"),
                         {m_standard.toStdString()});
            break;
        }
        if (m_stepCycle)
            result += m_language.text(REPORT_TEXT("report", "; step cycle by written agreement"));
        return result + u'.';
    }

private:
    [[nodiscard]] QString say(const Text &words, std::vector<Argument> arguments) const {
        return m_language.sentence(words, std::move(arguments));
    }

    /// The sentence with the name of the standard, and its checked part if only a part was checked.
    [[nodiscard]] QString counted(const Text &words, int count) const {
        QString standard = m_standard;
        if (m_evaluation.edition->textRead == TextRead::part)
            standard += u' ' + m_language.text(m_countByPractice
                                                   ? REPORT_TEXT("report", "(clauses 1 to 4.3.1 checked)")
                                                   : REPORT_TEXT("report", "(clauses 1 to 4.3.2 checked)"));
        return m_language.sentence({words, {standard.toStdString()}, count});
    }

    [[nodiscard]] QString unmet() const {
        return counted(
                   REPORT_TEXT_COUNTED("report", "Test NOT in accordance with %1: %n requirement(s) not met"),
                   m_counts.unmet) +
               notDeclared(requirementsNotDeclared, m_counts.undeclared, m_language);
    }

    [[nodiscard]] QString notChecked(bool page) const {
        QString result =
            say(REPORT_TEXT("report", "The text of %1 was not available: its requirements were not checked"),
                {m_standard.toStdString()});
        const int open = countOpenInPractice(m_evaluation.findings);
        result += m_counts.departures == 0
                      ? m_language.text(REPORT_TEXT("report", "; no departure from practice found")) +
                            notDeclared(practiceNotDeclared, open, m_language)
                      : m_language.semicolon() + requirementsText(m_evaluation, m_language);
        return m_counts.departures + open > 0 ? result + see(page) : result;
    }

    [[nodiscard]] QString partly() const {
        const std::string word = m_evaluation.edition->word;
        return m_countByPractice
                   ? say(REPORT_TEXT(
                             "report",
                             "%1: the requirements of clauses 1 to 4.3.1 are met; the rest of 4.3 and "
                             "clauses 5 to 7 were not available and not checked; number of targets and "
                             "approaches by practice"),
                         {word})
                   : say(REPORT_TEXT(
                             "report",
                             "%1: the requirements of clauses 1 to 4.3.2 are met; the rest of 4.3 and "
                             "clauses 5 to 7 were not available and not checked"),
                         {word});
    }

    [[nodiscard]] QString declared() const {
        const DeclaredAccordance &declared = m_test.declaredAccordance;
        if (isBlank(declared.by))
            return {};
        QStringList words{QString::fromStdString(declared.by)};
        if (declared.date && !declared.date->empty())
            words << m_language.date(*declared.date);
        if (!isBlank(declared.text))
            words << QString::fromStdString(declared.text);
        return say(REPORT_TEXT("report", "; the laboratory declares the rest met (%1)"),
                   {words.join(QStringLiteral(", ")).toStdString()});
    }

    [[nodiscard]] QString see(bool page) const {
        return page ? QStringLiteral(", ") + m_language.text(REPORT_TEXT("report", "see page %1"))
                    : QString();
    }

    const Test &m_test;
    const TestEvaluation &m_evaluation;
    const Language &m_language;
    QString m_standard;
    RequirementCounts m_counts;
    bool m_countByPractice = false;
    bool m_stepCycle = false;
};

} // namespace

QString accordanceText(const Test &test, const TestEvaluation &evaluation, const Language &language,
                       bool page) {
    return evaluation.edition ? Sentence(test, evaluation, language).text(page) : QString();
}

QString requirementsText(const TestEvaluation &evaluation, const Language &language) {
    const RequirementCounts counts = countRequirements(evaluation.findings);
    if (!evaluation.edition || evaluation.edition->textRead == TextRead::none) {
        const int open = countOpenInPractice(evaluation.findings);
        return counts.departures + open == 0
                   ? QString()
                   : language.sentence({REPORT_TEXT_COUNTED("report", "%n departure(s) from practice"),
                                        {},
                                        counts.departures}) +
                         notDeclared(practiceNotDeclared, open, language);
    }
    if (counts.unmet > 0)
        return language.sentence(
                   {REPORT_TEXT_COUNTED("report", "%n requirement(s) not met"), {}, counts.unmet}) +
               notDeclared(requirementsNotDeclared, counts.undeclared, language);
    return counts.undeclared == 0
               ? QString()
               : language.sentence({REPORT_TEXT_COUNTED("report", "%n requirement(s) not declared"),
                                    {},
                                    counts.undeclared});
}

Text accordanceWords(Accordance accordance) {
    return inOrder(accordance, {REPORT_TEXT("report", "text of the edition not available"),
                                REPORT_TEXT("report", "NOT in accordance with the edition"),
                                REPORT_TEXT("report", "accordance not shown"),
                                REPORT_TEXT("report", "in accordance in part"),
                                REPORT_TEXT("report", "in accordance with the edition")});
}

Mark markOf(Accordance accordance) {
    // No tick for partly, because only a part of the text was read.
    return inOrder(accordance,
                   {Mark::openCircle, Mark::warning, Mark::openCircle, Mark::openCircle, Mark::check});
}

VerdictStatement accordanceStatement(const Test &test, const TestEvaluation &evaluation,
                                     const Language &language, bool page) {
    VerdictStatement result{language.text(REPORT_TEXT_FOR("report", "Test", "part of a verdict")),
                            markOf(evaluation.accordance()),
                            accordanceText(test, evaluation, language, page),
                            {}};
    const qsizetype colon = result.state.indexOf(QLatin1String(": "));
    if (colon > 0) {
        result.text = result.state.mid(colon + 2);
        result.state.truncate(colon + 1);
    }
    return result;
}

QString accordanceOfAll(std::span<const Accordance> tests, const Language &language) {
    const auto count = [&](Accordance one) { return static_cast<int>(std::ranges::count(tests, one)); };
    if (count(Accordance::yes) == static_cast<int>(tests.size()))
        return language.text(
            REPORT_TEXT("report", "All tests carried out in accordance with their editions."));
    struct CountedPart {
        Accordance accordance = Accordance::notChecked;
        Text words;
    };
    const std::array parts{CountedPart{Accordance::yes, REPORT_TEXT("report", "In accordance: %1")},
                           CountedPart{Accordance::partly, REPORT_TEXT("report", "; in part: %1")},
                           CountedPart{Accordance::notShown, REPORT_TEXT("report", "; not shown: %1")},
                           CountedPart{Accordance::no, REPORT_TEXT("report", "; not: %1")},
                           CountedPart{Accordance::notChecked, REPORT_TEXT("report", "; not checked: %1")}};
    constexpr Text none = REPORT_TEXT_FOR("report", "none", "number of tests");
    QString result;
    for (const CountedPart &part : parts) {
        const Number number = wholeNumber(count(part.accordance));
        if (number.value > 0 || part.accordance == Accordance::yes)
            result += number.value > 0 ? language.sentence(part.words, {number})
                                       : language.sentence(part.words, {language.text(none).toStdString()});
    }
    return result + u'.';
}

} // namespace palmer
