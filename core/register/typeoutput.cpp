// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/typeoutput.h"

#include "document/filewords.h"
#include "figures/curvefield.h"
#include "figures/ticks.h"
#include "language/rounding.h"
#include "register/jsonline.h"
#include "register/listing.h"
#include "register/trendoutput.h"
#include "report/parts/testpart.h"
#include "report/words/wording.h"

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr int scoreDecimals = 3;
constexpr int factorDecimals = 4;
constexpr double mostTicks = 6;

QString nameOf(const ListedMachine &machine) {
    const QString title = machine.title();
    return machine.serialNumber.isEmpty() || title.contains(machine.serialNumber)
               ? title
               : title + QStringLiteral(" · ") + machine.serialNumber;
}

Text limitName(TypeDistribution distribution) {
    return distribution == TypeDistribution::logNormal ? REPORT_TEXT("report", "Tolerance limit, log-normal")
                                                       : REPORT_TEXT("report", "Tolerance limit, normal");
}

Json machineJson(const ListedMachine &machine) {
    return {{"name", orNull(machine.name.toStdString())},
            {"manufacturer", orNull(machine.manufacturer.toStdString())},
            {"model", orNull(machine.model.toStdString())},
            {"serialNumber", orNull(machine.serialNumber.toStdString())}};
}

Json testJson(const ListedMachine &machine, const ListedTest &listed) {
    return {{"machine", machineJson(machine)},
            {"date", orNull(listed.test.date)},
            {"role", fileWord(listed.test.role)},
            {"purpose", fileWord(listed.test.purpose)},
            {"file", listed.places.front().path.toStdString()},
            {"test", listed.places.front().test}};
}

Json normalityJson(const std::optional<Normality> &normality) {
    return normality ? Json{{"w", orNull(normality->w)},
                            {"probability", orNull(normality->probability)},
                            {"doubtful", normality->doubtful}}
                     : Json();
}

Json statisticsJson(const TypeTest &test) {
    const TypeStatistics &values = *test.statistics;
    return {
        {"count", values.sorted.size()},
        {"mean", orNull(values.mean)},
        {"s", orNull(values.s)},
        {"median", orNull(values.median)},
        {"smallest", orNull(values.sorted.front())},
        {"largest", orNull(values.sorted.back())},
        {"factor", orNull(values.factor)},
        {"limit", orNull(values.limit(test.distribution))},
        {"logNormalLimit", orNull(values.logNormalLimit)},
        {"normalLimit", orNull(values.normalLimit)},
        {"confidenceOfLargest", orNull(values.confidenceOfLargest)},
        {"normality",
         {{"values", normalityJson(values.normality)}, {"logarithms", normalityJson(values.logNormality)}}}};
}

class TypeReport {
public:
    TypeReport(const TypeTest &test, const Language &language)
        : m_test(test)
        , m_language(language)
        , m_quantity(test.angular ? Quantity::angularDeviation : Quantity::deviation) {}

    Report compose(bool onPaper) {
        Report report;
        report.language = m_language.code();
        const ListedMachine machine =
            m_test.members.empty() ? ListedMachine() : m_test.members.front().machine;
        report.title = say(REPORT_TEXT("report", "Type test of %1: %2 of %3"),
                           {(machine.manufacturer + u' ' + machine.model).trimmed().toStdString(),
                            plainSymbolOf(m_test.parameter).toStdString(), m_test.axis});
        report.blocks.emplace_back(Heading{2, report.title});
        report.blocks.emplace_back(
            Paragraph{m_language.text(
                          REPORT_TEXT("report", "Interpretation, not a result of ISO 230-2 or ISO 230-4. The "
                                                "machines are those in the register, no random sample.")),
                      TextSize::small});
        report.blocks.emplace_back(facts());
        if (onPaper)
            addFigures(report);
        report.blocks.emplace_back(members());
        if (!m_test.outsiders.empty()) {
            report.blocks.emplace_back(
                Heading{3, m_language.text(REPORT_TEXT("report", "Machines without a comparable test"))});
            report.blocks.emplace_back(outsiders());
        }
        report.blocks.emplace_back(Paragraph{
            m_language.text(REPORT_TEXT(
                "report",
                "The newest comparable test of each machine; U is stated and not subtracted. Upper tolerance "
                "limit: mean + k·s, log-normal exp(m + k·s) of the logarithms, k = t′(N − 1; z·√N)/√N of the "
                "noncentral t distribution (Boost.Math). Both are shown; no test chooses between them. "
                "Largest "
                "value: confidence 1 − p^N, by order statistics. Normality, from 8 machines on: Shapiro and "
                "Francia, J. Am. Stat. Assoc. 67 (1972), 215–216; probability: Royston, Statistics in "
                "Medicine "
                "12 (1993), 181–184.")),
            TextSize::small});
        return report;
    }

    void addFigures(Report &report) const {
        constexpr double quantileHeight = 54; // mm, like those below
        constexpr double rowOfDots = 5.6;
        constexpr double aroundDots = 26; // scale and legend
        constexpr double mostDots = 200;
        constexpr double half = 83;
        report.footerLeft = report.title;
        report.footerCentre = QStringLiteral("Palmer " PALMER_VERSION);
        report.footerRight = m_language.text(REPORT_TEXT("report", "page %1 / %2"));
        BarFigure dots = typeFigure(m_test, m_language);
        report.blocks.emplace_back(Heading{2, dots.title});
        const double height = aroundDots + rowOfDots * static_cast<double>(dots.bars.size());
        report.blocks.emplace_back(FigureBlock{std::move(dots), textWidth, std::min(height, mostDots)});
        if (!m_test.statistics)
            return;
        const auto part = [&](bool logarithms) -> std::vector<Part> {
            LineFigure figure = quantileFigure(m_test, logarithms, m_language);
            if (figure.lines.empty())
                return {};
            Heading heading{3, figure.title};
            return {std::move(heading), FigureBlock{std::move(figure), half, quantileHeight}};
        };
        report.blocks.emplace_back(SideBySide{part(false), part(true)});
        report.blocks.emplace_back(Heading{2, m_language.text(REPORT_TEXT("report", "Machines"))});
    }

private:
    [[nodiscard]] QString say(const Text &source, std::vector<Argument> arguments) const {
        return m_language.sentence({source, std::move(arguments)});
    }
    [[nodiscard]] QString value(std::optional<double> number) const {
        return number ? m_language.quantity(*number, m_quantity, 1) : QStringLiteral("–");
    }
    [[nodiscard]] QString percent(double share) const {
        return m_language.number(100 * share, Quantity::number, 1) + QStringLiteral("\u00A0%");
    }
    [[nodiscard]] QString normality(const std::optional<Normality> &found) const {
        if (!found)
            return QStringLiteral("–");
        const Text word =
            found->doubtful ? REPORT_TEXT("report", "doubtful") : REPORT_TEXT("report", "not contradicted");
        return m_language.text(word) + QStringLiteral(" (W′\u00A0") +
               m_language.number(found->w, Quantity::number, scoreDecimals) + QStringLiteral(", p\u00A0") +
               m_language.number(found->probability, Quantity::number, scoreDecimals) + u')';
    }

    [[nodiscard]] KeyValues facts() const {
        KeyValues result;
        result.labelWidth = 60; // mm
        const auto add = [&](const Text &key, const QString &text) {
            result.rows.push_back({m_language.text(key), text});
        };
        add(REPORT_TEXT("report", "Machines"), m_language.count(m_test.members.size()));
        if (!m_test.members.empty())
            add(REPORT_TEXT("report", "Comparable tests"),
                seriesText(m_test.series, m_test.angular, m_language));
        if (!m_test.statistics) {
            add(REPORT_TEXT("report", "Tolerance limit"),
                m_language.text(
                    REPORT_TEXT("report", "none: it takes three machines with a comparable test")));
            return result;
        }
        const TypeStatistics &found = *m_test.statistics;
        add(REPORT_TEXT("report", "Mean, s"), value(found.mean) + QStringLiteral(", ") + value(found.s));
        add(REPORT_TEXT("report", "Median"), value(found.median));
        add(REPORT_TEXT("report", "Content, confidence"),
            percent(m_test.tolerance.content) + QStringLiteral(", ") + percent(m_test.tolerance.confidence) +
                QStringLiteral(" (k\u00A0=\u00A0") +
                m_language.number(found.factor, Quantity::number, factorDecimals) + u')');
        for (const TypeDistribution one : {TypeDistribution::logNormal, TypeDistribution::normal})
            add(limitName(one),
                value(found.limit(one)) +
                    (one == m_test.distribution
                         ? QStringLiteral(" · ") + m_language.text(REPORT_TEXT("report", "chosen"))
                         : QString()));
        add(REPORT_TEXT("report", "Largest value"), say(REPORT_TEXT("report", "%1 with a confidence of %2"),
                                                        {value(found.sorted.back()).toStdString(),
                                                         percent(found.confidenceOfLargest).toStdString()}));
        add(REPORT_TEXT("report", "Normality of the values"), normality(found.normality));
        add(REPORT_TEXT("report", "Normality of the logarithms"), normality(found.logNormality));
        return result;
    }

    [[nodiscard]] QString limitText(const std::optional<double> &limit) const {
        return limit ? m_language.number(*limit, m_quantity, limitDecimals(*limit, m_quantity)) : QString();
    }

    [[nodiscard]] Table members() const {
        Table table;
        const QString unit = m_language.unit(m_quantity);
        constexpr double name = 60; // mm
        constexpr double number = 22;
        const auto numbers = [&](const QString &title, const QString &in) {
            return columnOf(title, number, Alignment::decimal, in);
        };
        table.columns = {flexibleColumn(m_language.text(REPORT_TEXT("report", "Machine")), name),
                         columnOf(m_language.text(REPORT_TEXT("report", "Date")), 1.3 * number),
                         numbers(plainSymbolOf(m_test.parameter), unit),
                         numbers(QStringLiteral("U"), unit),
                         numbers(m_language.text(REPORT_TEXT("report", "Limit")), unit),
                         numbers(m_language.text(REPORT_TEXT("report", "Normal score")), {})};
        for (std::size_t i = 0; i < m_test.members.size(); ++i) {
            const TypeMember &member = m_test.members[i];
            const ShownValue shown = shownResult(member.result, m_test.angular, m_language);
            table.rows.push_back(
                {Cell(nameOf(member.machine)), Cell(m_language.shortDate(member.test.test.date.value_or(""))),
                 Cell(shown.value), Cell(shown.uncertainty), Cell(limitText(member.result.limit)),
                 Cell(m_language.number(normalScore(i, m_test.members.size()), Quantity::number,
                                        scoreDecimals))});
        }
        constexpr std::size_t limitColumn = 4;
        leaveOutEmptyColumns(table, limitColumn, limitColumn);
        return table;
    }

    [[nodiscard]] Table outsiders() const {
        Table table;
        table.columns = {{m_language.text(REPORT_TEXT("report", "Machine")), {}, Alignment::left, true},
                         {m_language.text(REPORT_TEXT("report", "Date"))},
                         {m_language.text(REPORT_TEXT("report", "Differs in"))}};
        for (const TypeOutsider &one : m_test.outsiders) {
            const RegisteredTest &test = one.test.test;
            const TrendSeries series{test.edition, test.feed,      test.travel, test.correction,
                                     test.setUp,   one.difference, {}};
            table.rows.push_back({Cell(nameOf(one.machine)),
                                  Cell(m_language.shortDate(test.date.value_or(""))),
                                  Cell(seriesName(series, test.angular, m_language))});
        }
        return table;
    }

    const TypeTest &m_test;
    const Language &m_language;
    Quantity m_quantity;
};

} // namespace

QByteArray typeTestJson(const TypeTest &test) {
    Json members = Json::array();
    for (const TypeMember &one : test.members) {
        Json member = testJson(one.machine, one.test);
        member["value"] = orNull(one.result.value);
        member["expandedUncertainty"] = orNull(one.result.expandedUncertainty);
        members.push_back(std::move(member));
    }
    Json outsiders = Json::array();
    for (const TypeOutsider &one : test.outsiders)
        outsiders.push_back(testJson(one.machine, one.test));
    return jsonLine("type",
                    {{"axis", test.axis},
                     {"parameter", test.parameter},
                     {"unit", test.angular ? "deg" : "mm"},
                     {"edition", orNull(test.series.edition)},
                     {"feed", orNull(test.series.feed)},
                     {"travel", orNull(test.series.travel)},
                     {"correctionTo20", fileWord(test.series.correction)},
                     {"setUp", test.series.setUp},
                     {"content", test.tolerance.content},
                     {"confidence", test.tolerance.confidence},
                     {"distribution", test.distribution == TypeDistribution::normal ? "normal" : "logNormal"},
                     {"machines", members},
                     {"notComparable", outsiders},
                     {"statistics", test.statistics ? statisticsJson(test) : Json()}});
}

BarFigure typeFigure(const TypeTest &test, const Language &language) {
    const Quantity quantity = test.angular ? Quantity::angularDeviation : Quantity::deviation;
    const double scale = unitScale(quantity, language.units());
    BarFigure figure;
    const QString symbol = plainSymbolOf(test.parameter);
    figure.title = language.sentence(
        {REPORT_TEXT("report", "%1 of the machines of the type"), {symbol.toStdString()}, {}});
    if (!test.members.empty())
        figure.note = seriesText(test.series, test.angular, language);
    figure.x.symbol = symbol;
    figure.x.unit = language.unit(quantity);
    figure.dots = DotLegend{language.text(REPORT_TEXT("report", "value ± U")), {}};
    Bounds range;
    for (std::size_t i = 0; i < test.members.size(); ++i) {
        const TypeMember &member = test.members[i];
        Bar dot{QStringLiteral("machine%1").arg(i + 1),
                nameOf(member.machine),
                {},
                *member.result.value * scale,
                shownResult(member.result, test.angular, language).text(),
                {}};
        if (member.result.expandedUncertainty)
            dot.expanded = *member.result.expandedUncertainty * scale;
        if (member.result.limit) {
            dot.limit = *member.result.limit * scale;
            figure.dots->limit = language.text(REPORT_TEXT("report", "agreed limit"));
            range.include(*dot.limit);
        }
        range.include(std::max(dot.size - dot.expanded.value_or(0), 0.0));
        range.include(dot.size + dot.expanded.value_or(0));
        figure.bars.push_back(std::move(dot));
    }
    for (const TypeDistribution distribution : {TypeDistribution::logNormal, TypeDistribution::normal}) {
        const auto limit = test.statistics ? test.statistics->limit(distribution) : std::nullopt;
        if (!limit)
            continue;
        figure.lines.push_back(
            {*limit * scale,
             language.text(limitName(distribution)) + u' ' + language.quantity(*limit, quantity, 1),
             distribution == test.distribution});
        range.include(*limit * scale);
    }
    const Bounds shown = range.widened(valueMargin, scale * 1e-6);
    setRange(figure.x, std::max(shown.lowest, 0.0), shown.highest, mostTicks, TickSteps::values, language);
    return figure;
}

LineFigure quantileFigure(const TypeTest &test, bool logarithms, const Language &language) {
    const Quantity quantity = test.angular ? Quantity::angularDeviation : Quantity::deviation;
    const double scale = unitScale(quantity, language.units());
    LineFigure figure;
    const auto &values = test.statistics ? test.statistics->sorted : std::vector<double>();
    if (values.empty() || (logarithms && values.front() <= 0))
        return figure;
    figure.title = language.text(logarithms ? REPORT_TEXT("report", "Logarithms over normal scores")
                                            : REPORT_TEXT("report", "Values over normal scores"));
    figure.x.quantity = language.text(REPORT_TEXT("report", "Normal score"));
    const QString symbol = plainSymbolOf(test.parameter);
    figure.y.quantity = logarithms ? QStringLiteral("ln ") + symbol : symbol;
    figure.y.unit = language.unit(quantity);
    FigureLine dots{LineRole::measuredUp, {}, {}, {}, true};
    Bounds x;
    Bounds y;
    double squares = 0; // the mean of the scores is 0
    double product = 0;
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = logarithms ? std::log(values[i] * scale) : values[i] * scale;
        const double score = normalScore(i, values.size());
        dots.points.emplace_back(score, value);
        squares += score * score;
        product += score * value;
        sum += value;
    }
    FigureLine line{LineRole::predictedUp, {}, {}, {}};
    for (const QPointF &end : {dots.points.front(), dots.points.back()})
        line.points.emplace_back(end.x(),
                                 sum / static_cast<double>(values.size()) + product / squares * end.x());
    for (const FigureLine *one : {&dots, &line}) {
        for (const QPointF &point : one->points) {
            x.include(point.x());
            y.include(point.y());
        }
    }
    const Bounds scores = x.widened(valueMargin, 0.1);
    const Bounds range = y.widened(valueMargin, 0.1);
    setRange(figure.x, scores.lowest, scores.highest, mostTicks, TickSteps::values, language);
    setRange(figure.y, range.lowest, range.highest, mostTicks, TickSteps::values, language);
    figure.lines = {std::move(line), std::move(dots)};
    return figure;
}

Report composeTypeTest(const TypeTest &test, const Language &language, bool onPaper) {
    return TypeReport(test, language).compose(onPaper);
}

} // namespace palmer
