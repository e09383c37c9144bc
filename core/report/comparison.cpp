// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/comparison.h"

#include "document/filewords.h"
#include "figures/circlefigure.h"
#include "figures/ticks.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/numerics/angles.h"
#include "language/decimals.h"
#include "language/visibletext.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

namespace palmer {
namespace {

constexpr double positionMargin = 0.03;
constexpr double valueMargin = 0.07;
constexpr double mostPositionTicks = 6.5;
constexpr double mostValueTicks = 10;
constexpr int circularDecimals = 2;   // 0.01 µm
constexpr double comparedStep = 0.25; ///< degrees; finer than a pixel of the image
constexpr double turnTolerance = 1;   ///< degrees that a path may begin before the turn

int decimalsFor(const Test &test) {
    return partOr(circularDecimals, test.measurement,
                  [](auto &m) -> decltype(statisticDecimals(m)) { return statisticDecimals(m); });
}

const Parameter *parameterOf(const TestEvaluation &evaluation, const std::string &id) {
    const auto found = std::ranges::find_if(
        evaluation.parameters, [&](const Parameter &parameter) { return parameterId(parameter) == id; });
    return found == evaluation.parameters.end() ? nullptr : &*found;
}

QString signedNumber(double value, Quantity quantity, int decimals, const Language &language) {
    const QString number = language.number(value, quantity, decimals);
    const bool isPositive = value > 0 && !number.startsWith(u'\u2212');
    return isPositive ? u'+' + number : number;
}

/// One row per parameter of any of the evaluations, in order of appearance.
std::vector<ComparisonRow> rowsOf(const std::vector<const TestEvaluation *> &columns, int decimals,
                                  const Language &language) {
    std::vector<ComparisonRow> rows;
    for (const TestEvaluation *column : columns) {
        for (const Parameter &parameter : column->parameters) {
            const QString id = QString::fromStdString(parameterId(parameter));
            if (std::ranges::find(rows, id, &ComparisonRow::id) == rows.end())
                rows.push_back(
                    {id, symbolFormula(parameter), language.text(parameter.term.name), {}, {}, {}});
        }
    }
    for (ComparisonRow &row : rows) {
        const Parameter *first = parameterOf(*columns.front(), row.id.toStdString());
        for (const TestEvaluation *column : columns) {
            const Parameter *parameter = parameterOf(*column, row.id.toStdString());
            const bool hasValue = parameter && parameter->value;
            row.values << (!parameter ? QString()
                           : hasValue ? language.number(*parameter->value, parameter->term.quantity, decimals)
                                      : language.number(std::numeric_limits<double>::quiet_NaN(),
                                                        parameter->term.quantity));
            row.differences << (hasValue && parameter != first && first && first->value
                                    ? signedNumber(*parameter->value - *first->value,
                                                   parameter->term.quantity, decimals, language)
                                    : QString());
        }
    }
    return rows;
}

QString unitOf(const TestEvaluation &evaluation, const Language &language) {
    return evaluation.parameters.empty() ? QString()
                                         : language.unit(evaluation.parameters.front().term.quantity);
}

const Row *rowOfEdition(const Edition &edition, std::string_view id) {
    const auto found = std::ranges::find_if(edition.rows, [&](const Row &row) { return row.term.id == id; });
    return found == edition.rows.end() ? nullptr : &*found;
}

bool knows(const Edition &edition, const std::string &id) {
    const std::string bare = id.substr(0, id.find('_'));
    return std::ranges::any_of(termsOf(edition), [&](const Term *term) { return bare == term->id; });
}

/// Editions that differ from the first one in a parameter, and how.
struct Differences {
    bool same = false; ///< the first has a value, and no other value differs
    QStringList absent;
    QStringList byMethod;
    QStringList otherwise;
    std::map<double, QStringList> byFactor;
};

void takeDifference(Differences &differences, const TestEvaluation &first, const TestEvaluation &other,
                    const std::string &id, const Language &language) {
    differences.same = false;
    const Edition &edition = *other.edition;
    const Row *row = rowOfEdition(edition, id);
    const bool scatter = row && (row->needs & palmer::scatter) != 0;
    const QString word = standardName(language, other.edition);
    const bool otherMethod = scatter && deviationMethod(other) != deviationMethod(first);
    const bool otherFactor = scatter && edition.c != first.edition->c;
    if (otherMethod)
        differences.byMethod << word;
    if (otherFactor)
        differences.byFactor[edition.c] << word;
    if (!otherMethod && !otherFactor)
        differences.otherwise << word;
}

Differences differencesOf(const std::vector<const TestEvaluation *> &columns, const std::string &id,
                          const Language &language) {
    Differences differences;
    const TestEvaluation &first = *columns.front();
    const Parameter *own = parameterOf(first, id);
    differences.same = own && own->value;
    for (const TestEvaluation *column : columns) {
        const Parameter *other = parameterOf(*column, id);
        if (!knows(*column->edition, id))
            differences.absent << standardName(language, column->edition);
        else if (column != &first && other && other->value && own && own->value &&
                 *other->value != *own->value)
            takeDifference(differences, first, *column, id, language);
    }
    return differences;
}

/// Reasons why a parameter differs between the first column and another, as sentences; may be empty.
QStringList reasons(const std::vector<const TestEvaluation *> &columns, const std::string &id,
                    const Language &language) {
    const TestEvaluation &first = *columns.front();
    const auto [same, absent, byMethod, otherwise, byFactor] = differencesOf(columns, id, language);
    QStringList sentences;
    const auto list = [](const QStringList &words) { return words.join(QStringLiteral(", ")).toStdString(); };
    const std::string firstWord = standardName(language, first.edition).toStdString();
    const bool firstByRange = deviationMethod(first) == DeviationMethod::range;
    if (!byMethod.isEmpty())
        sentences << language.sentence(
            REPORT_TEXT("report", "s from the range in %1, from the squares in %2."),
            {firstByRange ? firstWord : list(byMethod), firstByRange ? list(byMethod) : firstWord});
    for (const auto &[c, words] : byFactor)
        sentences << language.sentence(REPORT_TEXT("report", "Factor of s: %1 in %2, %3 in %4."),
                                       {Number{first.edition->c, Quantity::number, -1}, firstWord,
                                        Number{c, Quantity::number, -1}, list(words)});
    if (!otherwise.isEmpty())
        sentences << language.sentence(REPORT_TEXT("report", "Computed otherwise in %1 than in %2."),
                                       {list(otherwise), firstWord});
    if (!absent.isEmpty())
        sentences << language.sentence(REPORT_TEXT("report", "No parameter of %1."),
                                       {absent.join(QStringLiteral(", ")).toStdString()});
    if (same && absent.size() + 1 < static_cast<qsizetype>(columns.size()))
        sentences.prepend(language.text(REPORT_TEXT("report", "The same arithmetic.")));
    return sentences;
}

/// The test under another edition; its own evaluation if that is the edition.
TestEvaluationPointer under(const EvaluatedDocument &evaluated, std::size_t test,
                            const std::string &edition) {
    const TestEvaluationPointer &own = evaluated.tests[test];
    if (own->edition && edition == own->edition->word)
        return own;
    std::vector<std::string> words(evaluated.document->tests.size());
    words[test] = edition;
    return evaluateUnder(evaluated.document, words, &evaluated).tests[test];
}

} // namespace

std::vector<std::string> editionsToCompare(const Test &test) {
    const Edition *own = findEdition(test.edition);
    if (!own)
        return {};
    std::vector<std::string> words{test.edition};
    for (const Edition *other : editionsOf(own->kind)) {
        const std::string_view word = other->word;
        if (word == other->family && word != own->family) // skips aliases
            words.emplace_back(word);
    }
    return words;
}

ResultComparison compareEditions(const EvaluatedDocument &evaluated, std::size_t test,
                                 const std::vector<std::string> &editions, const Language &language) {
    ResultComparison result;
    if (test >= evaluated.tests.size() || !evaluated.tests[test]->edition)
        return result;
    const Test &shown = *evaluated.document->tests[test];
    std::vector<TestEvaluationPointer> evaluations;
    std::vector<const TestEvaluation *> columns;
    for (const std::string &word : editions) {
        const Edition *edition = findEdition(word);
        if (!edition || edition->kind != kindOf(shown))
            continue;
        evaluations.push_back(under(evaluated, test, word));
        columns.push_back(evaluations.back().get());
        result.columns << QString::fromStdString(word);
    }
    if (columns.empty())
        return result;
    result.unit = unitOf(*columns.front(), language);
    result.rows = rowsOf(columns, decimalsFor(shown), language);
    for (ComparisonRow &row : result.rows)
        row.reasons = reasons(columns, row.id.toStdString(), language);
    result.notes << language.text(REPORT_TEXT(
        "report", "The same readings under each edition; verdicts hold for the edition of the test alone."));
    return result;
}

bool isComparable(const Test &a, const Test &b) {
    return isJudged(a) && kindOf(a) == kindOf(b) && motionOf(a) == motionOf(b);
}

ResultComparison compareTests(const std::vector<ComparedTest> &tests, const Language &language) {
    ResultComparison result;
    if (tests.empty() || tests[0].test >= tests[0].evaluated.tests.size())
        return result;
    const Test &first = *tests[0].evaluated.document->tests[tests[0].test];
    std::vector<TestEvaluationPointer> evaluations;
    std::vector<const TestEvaluation *> columns;
    QStringList leftOut;
    bool otherEdition = false;
    for (const ComparedTest &compared : tests) {
        if (compared.test >= compared.evaluated.tests.size())
            continue;
        const Test &test = *compared.evaluated.document->tests[compared.test];
        if (!isComparable(first, test)) {
            leftOut << compared.name;
            continue;
        }
        otherEdition = otherEdition || test.edition != first.edition;
        evaluations.push_back(under(compared.evaluated, compared.test, first.edition));
        columns.push_back(evaluations.back().get());
        result.columns << compared.name;
    }
    if (columns.empty())
        return result;
    result.unit = unitOf(*columns.front(), language);
    result.rows = rowsOf(columns, decimalsFor(first), language);
    if (otherEdition)
        result.notes << language.sentence(REPORT_TEXT("report", "All tests as under %1."),
                                          {standardName(language, findEdition(first.edition)).toStdString()});
    if (!leftOut.isEmpty())
        result.notes << language.sentence(REPORT_TEXT("report", "Of another kind, and left out: %1."),
                                          {leftOut.join(QStringLiteral(", ")).toStdString()});
    return result;
}

namespace {

/// Ranges of the curves of a figure.
struct CurveRanges {
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    Interval x{infinite, -infinite};
    Interval y{infinite, -infinite};

    void take(const FigurePoint &point) {
        x = {std::min(x.from, point.x), std::max(x.to, point.x)};
        y = {std::min(y.from, point.y), std::max(y.to, point.y)};
    }
    [[nodiscard]] bool isEmpty() const { return !(x.from <= x.to); }
};

ComparisonCurve meanCurve(const PositioningMeasurement &measurement, const PositioningResults &results,
                          const Language &language, CurveRanges &ranges) {
    ComparisonCurve curve;
    const double scale = unitScale(deviationQuantity(measurement.axis), language.units());
    const double positionScale = unitScale(positionQuantity(measurement.axis), language.units());
    bool open = false;
    for (std::size_t i = 0; i < std::min(results.targets.size(), measurement.targets.size()); ++i) {
        const TargetStatistics &target = results.targets[i];
        const double mean = results.upward && results.downward ? target.mean()
                            : results.upward                   ? target.positive.mean
                                                               : target.negative.mean;
        if (!std::isfinite(mean)) {
            open = false;
            continue;
        }
        if (!open)
            curve.lines.emplace_back();
        open = true;
        curve.lines.back().push_back(
            {measurement.targets[i] * positionScale, mean * scale, static_cast<int>(i) + 1});
        ranges.take(curve.lines.back().back());
    }
    return curve;
}

/// The evaluated part of a profile; `points` are indices of the arc.
PathProfile onlyPoints(const PathProfile &profile, const std::vector<std::size_t> &points) {
    PathProfile result;
    result.ordered = profile.ordered;
    for (std::size_t i = 0; i < profile.source.size(); ++i) {
        if (profile.source[i] < points.front() || profile.source[i] > points.back())
            continue;
        result.angles.push_back(profile.angles[i]);
        result.deviations.push_back(profile.deviations[i]);
        result.source.push_back(profile.source[i]);
    }
    return result;
}

/// The angles of every path begin in the first turn, so that the paths of several tests overlap.
ComparisonCurve pathCurve(const Test &test, const TestEvaluation &evaluation, const EvaluatedPath &path,
                          const Language &language, CurveRanges &ranges) {
    ComparisonCurve curve;
    curve.sense = path.sense;
    if (path.source.empty())
        return curve;
    const double micrometre = unitScale(Quantity::deviation, language.units()) / 1000;
    const double turns = std::floor((path.evaluated.from + turnTolerance) / fullTurn) * fullTurn;
    const PathProfile profile = onlyPoints(wholeArc(test, evaluation, path.arc), path.source);
    for (const CircleTrace &trace : decimated(profile, comparedStep)) {
        curve.lines.emplace_back();
        for (const TracePoint &point : trace.points) {
            curve.lines.back().push_back({point.angle - turns, point.deviation * micrometre, 0});
            ranges.take(curve.lines.back().back());
        }
    }
    return curve;
}

/// Inputs for the curves of a test, and the ranges they cover.
struct CurveSource {
    const Test &test;
    const TestEvaluation &evaluation;
    const Language &language;
    CurveRanges &ranges;
};

// Curves of a test, each with a distinguishing name.

std::vector<ComparisonCurve> curvesOf(const CurveSource &source, const PositioningMeasurement &measurement,
                                      const PositioningResults &results) {
    return {meanCurve(measurement, results, source.language, source.ranges)};
}

std::vector<ComparisonCurve> curvesOf(const CurveSource &source, const CircularMeasurement & /*measurement*/,
                                      const CircularResults &results) {
    std::vector<ComparisonCurve> curves;
    for (const EvaluatedPath &path : results.paths) {
        curves.push_back(pathCurve(source.test, source.evaluation, path, source.language, source.ranges));
        curves.back().name = QString::fromStdString(path.index);
    }
    return curves;
}

std::vector<ComparisonCurve> curvesOf(const CurveSource & /*source*/, const auto & /*drift*/, const auto &) {
    return {};
}

void setAxes(ComparisonFigure &figure, const Test &first, const CurveRanges &ranges,
             const Language &language) {
    const bool alongAxis = axisOf(first);
    const bool angles = !alongAxis || motionOf(first) == Motion::rotary;
    const auto [x, y] = ranges;
    const double width = x.to > x.from ? x.to - x.from : 1;
    const double height = y.to > y.from ? y.to - y.from : 1;
    setRange(figure.x, x.from - positionMargin * width, x.to + positionMargin * width, mostPositionTicks,
             angles ? TickSteps::angles : TickSteps::lengths, language);
    setRange(figure.y, y.from - valueMargin * height, y.to + valueMargin * height, mostValueTicks,
             TickSteps::values, language);
    figure.x.quantity =
        language.text(alongAxis ? REPORT_TEXT("report", "Target position") : REPORT_TEXT("report", "Angle"));
    figure.x.unit = language.unit(angles ? Quantity::angle : Quantity::position);
    figure.x.angle = angles;
    figure.y.quantity = language.text(alongAxis ? REPORT_TEXT("report", "Mean deviation")
                                                : REPORT_TEXT("report", "Radial deviation"));
    figure.y.unit = language.unit(deviationQuantity(first));
}

} // namespace

ComparisonFigure comparisonFigure(const std::vector<ComparedTest> &tests, const Language &language) {
    ComparisonFigure figure;
    CurveRanges ranges;
    const Test *first = nullptr;
    std::size_t shown = 0;
    for (const ComparedTest &compared : tests) {
        if (compared.test >= compared.evaluated.tests.size())
            continue;
        const Test &test = *compared.evaluated.document->tests[compared.test];
        if (!isJudged(test) || (first && !isComparable(*first, test)))
            continue;
        first = first ? first : &test;
        const TestEvaluation &evaluation = *compared.evaluated.tests[compared.test];
        const CurveSource source{test, evaluation, language, ranges};
        auto curves = withResults(test, evaluation, [&](const auto &measurement, const auto &results) {
            return curvesOf(source, measurement, results);
        });
        for (ComparisonCurve &curve : curves) {
            curve.name = curve.name.isEmpty() ? compared.name
                                              : QStringLiteral("%1 (%2)").arg(compared.name, curve.name);
            curve.test = shown;
            figure.curves.push_back(std::move(curve));
        }
        ++shown;
    }
    if (first && !ranges.isEmpty())
        setAxes(figure, *first, ranges, language);
    return figure;
}

QString asTabSeparated(const ResultComparison &comparison) {
    const auto plain = [](QString text) {
        text.replace(u'\u2212', u'-');
        text.remove(u'\u202f');
        return cellText(text);
    };
    const bool hasReasons =
        std::ranges::any_of(comparison.rows, [](const ComparisonRow &row) { return !row.reasons.isEmpty(); });
    QString table = comparison.unit;
    for (qsizetype i = 0; i < comparison.columns.size(); ++i) {
        table += u'\t' + plain(comparison.columns[i]);
        if (!hasReasons && i > 0)
            table += QStringLiteral("\tΔ");
    }
    table += u'\n';
    for (const ComparisonRow &row : comparison.rows) {
        table += row.symbol.plain();
        for (qsizetype i = 0; i < row.values.size(); ++i) {
            table += u'\t' + plain(row.values[i]);
            if (!hasReasons && i > 0)
                table += u'\t' + plain(row.differences[i]);
        }
        if (hasReasons)
            table += u'\t' + plain(row.reason());
        table += u'\n';
    }
    return table;
}

} // namespace palmer
