// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/wording.h"

#include "kernel/evaluation/applylimits.h"
#include "kernel/measurement/testfacts.h"
#include "language/rounding.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace palmer {

Text verdictText(Verdict verdict) {
    return inOrder(verdict, {REPORT_TEXT("report", "conforms"), REPORT_TEXT("report", "not proven"),
                             REPORT_TEXT("report", "does not conform")});
}

Text limitText(Verdict verdict) {
    return inOrder(verdict, {REPORT_TEXT_FOR("report", "met", "a limit"), REPORT_TEXT("report", "not proven"),
                             REPORT_TEXT_FOR("report", "exceeded", "a limit")});
}

Text limitsText(std::optional<Verdict> verdict, bool anyLimit) {
    if (!verdict)
        return anyLimit ? REPORT_TEXT("report", "no verdict")
                        : REPORT_TEXT_FOR("report", "none agreed", "limits");
    return inOrder(*verdict, {REPORT_TEXT_FOR("report", "met", "limits"),
                              REPORT_TEXT_FOR("report", "not proven", "limits"),
                              REPORT_TEXT_FOR("report", "exceeded", "limits")});
}

Text gradeText(Grade grade) {
    return inOrder(grade, {REPORT_TEXT("report", "requirement"), REPORT_TEXT("report", "recommendation"),
                           REPORT_TEXT("report", "note")});
}

Text cycleText(std::optional<Cycle> cycle, const Edition &edition) {
    if (!cycle)
        return REPORT_TEXT_FOR("report", "not stated", "cycle");
    return cycle == Cycle::standard ? edition.standardCycle : edition.stepCycle;
}

Text correctionText(CorrectionTo20 correction) {
    return correction == CorrectionTo20::notStated ? REPORT_TEXT("report", "not stated")
                                                   : statedWord("correctionTo20", correction);
}

QString clauseText(const std::string &clause, const Language &language) {
    struct Word {
        std::string_view before; ///< text before it in the tables
        std::string_view word;
        Text text;
    };
    constexpr std::array words{Word{"", "Annex ", REPORT_TEXT("report", "Annex %1")},
                               Word{"", "Foreword ", REPORT_TEXT("report", "Foreword %1")},
                               Word{", ", "Table ", REPORT_TEXT("report", "Table %1")}};
    for (const Word &one : words) {
        const std::string mark = std::string(one.before) + std::string(one.word);
        const auto at = clause.find(mark);
        if (at == std::string::npos || (one.before.empty() && at != 0))
            continue;
        return QString::fromStdString(clause.substr(0, at) + std::string(one.before)) +
               language.sentence(one.text, {clause.substr(at + mark.size())});
    }
    return QString::fromStdString(clause);
}

QString standardName(const Language &language, const Edition *edition) {
    return edition ? language.designation(edition->word) : QString();
}

Text senseText(Sense sense) {
    return sense == Sense::counterclockwise ? REPORT_TEXT("report", "anticlockwise")
                                            : REPORT_TEXT("report", "clockwise");
}

Text shortSenseText(Sense sense) {
    return sense == Sense::counterclockwise ? REPORT_TEXT_FOR("report", "anticlockwise", "short")
                                            : REPORT_TEXT_FOR("report", "clockwise", "short");
}

At20 at20(const TestEvaluation &evaluation) {
    return partOr(At20::hold, evaluation.results,
                  [](auto &results) -> decltype(results.at20) { return results.at20; });
}

bool notCorrected(const TestEvaluation &evaluation) {
    return at20(evaluation) == At20::wrong;
}

Text whyNotProven(const Parameter &parameter, const TestEvaluation &evaluation) {
    if (!parameter.expandedUncertainty)
        return notProvenWithoutUncertainty;
    if (!parameter.dependsOnTemperature || at20(evaluation) == At20::hold)
        return {};
    return notCorrected(evaluation) ? REPORT_TEXT("report", "nothing is proven: not corrected to 20 °C")
                                    : REPORT_TEXT("report", "nothing is proven: not shown to hold at 20 °C");
}

DeviationMethod deviationMethod(const TestEvaluation &evaluation) {
    return partOr(
        DeviationMethod::calculation, evaluation.results,
        [](auto &results) -> decltype(results.standardDeviation) { return results.standardDeviation; });
}

const RuleWords &ruleWords(Rule rule) {
    constexpr Text simple = REPORT_TEXT("report", "simple acceptance");
    static constexpr std::array rules{
        // in the order of the enumeration
        RuleWords{simple, simple, simple},
        RuleWords{REPORT_TEXT("report", "ISO 14253-1"),
                  REPORT_TEXT("report", "ISO 14253-1: conformity to be proven"),
                  REPORT_TEXT("report", "ISO 14253-1, conformity has to be proven")},
        RuleWords{REPORT_TEXT("report", "rejection proven"),
                  REPORT_TEXT("report", "non-conformity to be proven"),
                  REPORT_TEXT("report", "non-conformity has to be proven")}};
    return rules.at(static_cast<std::size_t>(rule));
}

QString ruleWithBand(const DecisionRule &rule, const Text &words, const Language &language) {
    const QString text = language.text(words);
    return rule.rule == Rule::simpleAcceptance
               ? text
               : text + QStringLiteral(", ") +
                     language.sentence(REPORT_TEXT("report", "guard band %1 U"),
                                       {Number{rule.guardFactor, Quantity::number, -1}});
}

QString arrow(Direction direction) {
    return direction == Direction::positive ? QStringLiteral("↑") : QStringLiteral("↓");
}

Phrase phraseOf(const Formula &formula) {
    Phrase result;
    for (const FormulaSpan &span : formula.spans)
        result.spans.push_back({span.text, span.subscript, false, false, span.strong});
    return result;
}

Phrase symbolPhrase(const Symbol &symbol, const std::string &index) {
    return phraseOf(symbolFormula(symbol, index));
}

Phrase symbolPhrase(const Parameter &parameter) {
    return phraseOf(symbolFormula(parameter));
}

Phrase withSymbols(const QString &sentence, std::span<const Parameter> parameters) {
    struct Name {
        QString text;
        Phrase phrase;
    };
    std::vector<Name> names;
    for (const auto &[text, formula] :
         {std::pair(u"E_VE", u"E_VE"), std::pair(u"Gf", u"G_f"), std::pair(u"G(b)f", u"G(b)_f")})
        names.push_back({QString::fromUtf16(text), phraseFrom(QString::fromUtf16(formula))});
    for (const Parameter &parameter : parameters) {
        const Phrase phrase = symbolPhrase(parameter);
        if (phrase.spans.size() < 2 || !phrase.spans[1].subscript)
            continue;
        for (const QString &text : {phrase.plain(), QString::fromStdString(plainSymbol(parameter)),
                                    QString::fromStdString(parameterId(parameter))})
            names.push_back({text, phrase});
    }
    std::ranges::stable_sort(names, {}, [](const Name &name) { return -name.text.size(); });

    const auto isPart = [&](qsizetype at) {
        return at >= 0 && at < sentence.size() && (sentence[at].isLetterOrNumber() || sentence[at] == u'_');
    };
    Phrase result;
    qsizetype from = 0;
    for (qsizetype at = 0; at < sentence.size();) {
        const auto found = std::ranges::find_if(names, [&](const Name &name) {
            return QStringView(sentence).mid(at).startsWith(name.text) && !isPart(at - 1) &&
                   !isPart(at + name.text.size());
        });
        if (found == names.end()) {
            ++at;
            continue;
        }
        if (at > from)
            result.spans.push_back({sentence.mid(from, at - from)});
        result += found->phrase;
        at += found->text.size();
        from = at;
    }
    if (from < sentence.size())
        result.spans.push_back({sentence.mid(from)});
    return result;
}

Phrase phraseFrom(const QString &formula) {
    return phraseOf(formulaFrom(formula));
}

QString rulingText(const Parameter &parameter) {
    QStringList ends;
    for (const auto &ruling : parameter.ruling) {
        if (ruling)
            ends << QString::number(ruling->target) +
                        (ruling->approach ? arrow(*ruling->approach) : QString());
    }
    return ends.join(QStringLiteral(" – "));
}

std::optional<double> finestResolution(const Document &document, const Test &test) {
    std::optional<double> result;
    for (const std::string &id : test.instruments) {
        const auto found = std::ranges::find(document.instruments, id, &Instrument::id);
        if (found != document.instruments.end() && found->resolution)
            result = std::min(result.value_or(*found->resolution), *found->resolution);
    }
    return result;
}

CoverageOfResults coverageOf(const TestEvaluation &evaluation, const ReportHead &head) {
    CoverageOfResults result;
    for (const Parameter &parameter : evaluation.parameters) {
        if (!parameter.expandedUncertainty || !isPrinted(parameter, head))
            continue;
        if (parameter.decidedBy == UncertaintyMethod::monteCarlo)
            result.simulated.push_back(symbolPhrase(parameter).plain());
        else
            result.factor = true;
    }
    return result;
}

QString uncertaintyHead(const CoverageOfResults &coverage, const Language &language) {
    if (coverage.mixed())
        return QStringLiteral("U");
    return coverage.simulated.empty() ? QStringLiteral("U (k = 2)")
                                      : language.text(REPORT_TEXT("report", "U (95.45 %)"));
}

QString coverageNote(const CoverageOfResults &coverage, const Language &language) {
    if (coverage.simulated.empty())
        return coverage.factor ? QStringLiteral("k = 2") : QString();
    if (!coverage.factor)
        return language.text(REPORT_TEXT("report", "95.45 %"));
    const QStringList symbols(coverage.simulated.begin(), coverage.simulated.end());
    return language.sentence(REPORT_TEXT("report", "95.45 % for %1; k = 2 for the others"),
                             {symbols.join(QStringLiteral(", ")).toStdString()});
}

QString letterOfTargets(const Edition &edition) {
    return QString::fromUtf8(edition.targetLetter);
}

QString letterOfRuns(const Edition &edition) {
    return QString::fromUtf8(edition.runLetter);
}

QString inLettersOf(const Edition &edition, const char *formula) {
    static const QRegularExpression target(QStringLiteral("_i(?!j)"));
    return QString::fromUtf8(formula).replace(target, u'_' + letterOfTargets(edition));
}

bool guardsSimulated(const TestEvaluation &evaluation) {
    return std::ranges::any_of(evaluation.parameters, [](const Parameter &p) {
        return p.guardBand && p.decidedBy == UncertaintyMethod::monteCarlo;
    });
}

QString notEvaluableSentence(const TestEvaluation &evaluation, const Language &language) {
    std::map<NotEvaluable, QStringList> symbols;
    for (const AgreedLimit &limit : evaluation.limits) {
        if (limit.reason)
            symbols[*limit.reason] << QString::fromStdString(limit.symbol);
    }
    QStringList items;
    for (const auto &[reason, limits] : symbols)
        items << limits.join(QStringLiteral(", ")) + QStringLiteral(" (") +
                     language.text(notEvaluableText(reason)) + u')';
    if (items.empty())
        return {};
    const std::string all = items.join(QStringLiteral(", ")).toStdString();
    return language.sentence(REPORT_TEXT("report", "Not evaluable: %1."), {all});
}

bool isPrinted(const Parameter &parameter, const ReportHead &head) {
    if (parameter.limit) // an agreed limit must be answered
        return true;
    if (!parameter.required)
        return false;
    return parameter.term.printed == Printed::always ||
           std::ranges::find(head.include, ReportExtra::meanRepeatability) != head.include.end();
}

bool hasScatter(const TestEvaluation &evaluation) {
    const int runs = partOr(0, evaluation.results, [](auto &results) -> decltype(results.positiveRuns) {
        return std::max(results.positiveRuns, results.negativeRuns);
    });
    return runs > 1;
}

bool isShown(const TargetTerm &term, const PositioningResults &results) {
    const bool several = std::max(results.positiveRuns, results.negativeRuns) > 1;
    const bool range = results.standardDeviation == DeviationMethod::range;
    const unsigned has = (results.upward ? upward : 0U) | (results.downward ? downward : 0U) |
                         (several ? scatter : 0U) | (range ? byRange : 0U);
    return (term.needs & ~has) == 0;
}

const Row *rowOf(const Edition &edition, const Parameter &parameter) {
    const auto found = std::ranges::find(edition.rows, std::string_view(parameter.term.id),
                                         [](const Row &row) { return std::string_view(row.term.id); });
    return found == edition.rows.end() ? nullptr : &*found;
}

const KindWords &kindWords(const Test &test) {
    static constexpr std::array kinds{
        // in the order of Measurement
        KindWords{REPORT_TEXT("report", "Positioning test of the %1 axis"),
                  REPORT_TEXT("report", "Positioning test of axis %1"), REPORT_TEXT("report", "%1 axis"),
                  REPORT_TEXT("report", "Contributors as public drafts of annex A name them; combined by "
                                        "propagation after the GUM.")},
        KindWords{REPORT_TEXT("report", "Circular test in the %1 plane"),
                  REPORT_TEXT("report", "Circular test in the plane %1"),
                  REPORT_TEXT("report", "%1 circle, R %2"),
                  REPORT_TEXT("report",
                              "Contributors of ISO 230-4:2005, 4.6; combined by propagation after the GUM.")},
        KindWords{REPORT_TEXT("report", "Drift test of the %1 axis"),
                  REPORT_TEXT("report", "Drift test of axis %1"),
                  REPORT_TEXT("report", "%1 axis"),
                  {}}};
    static_assert(kinds.size() == allKinds.size());
    return kinds.at(static_cast<std::size_t>(kindOf(test)));
}

} // namespace palmer
