// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/typeoutput.h"

#include "document/filewords.h"
#include "figures/curvefield.h"
#include "figures/ticks.h"
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

class Composer {
public:
    Composer(const TypeTest &test, const Language &language)
        : m_test(test)
        , m_language(language)
        , m_quantity(test.angular ? Quantity::angularDeviation : Quantity::deviation) {}

    Report compose(bool onPaper) {
        Report report;
        report.language = m_language.code();
        const ListedMachine machine =
            m_test.members.empty() ? ListedMachine() : m_test.members.front().machine;
        report.title = say(REPORT_TEXT("report", "Type test of %1: %2, axis or plane %3"),
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
                "noncentral t distribution. Both are shown; no test chooses between them. Largest value: "
                "confidence 1 − p^N. Normality: Shapiro–Francia, from 8 machines on.")),
            TextSize::small});
        return report;
    }

    void addFigures(Report &report) const {
        constexpr double barHeight = 6; // mm
        constexpr double axisHeight = 14;
        constexpr double quantileHeight = 62;
        constexpr double half = 83;
        report.footerLeft = report.title;
        report.footerCentre = QStringLiteral("Palmer " PALMER_VERSION);
        report.footerRight = m_language.text(REPORT_TEXT("report", "page %1 / %2"));
        BarFigure bars = typeFigure(m_test, m_language);
        report.blocks.emplace_back(Heading{2, bars.title});
        const double height = axisHeight + barHeight * static_cast<double>(bars.bars.size());
        report.blocks.emplace_back(FigureBlock{std::move(bars), textWidth, height});
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
        const auto add = [&](const Text &key, const QString &text) {
            result.rows.push_back({m_language.text(key), text});
        };
        add(REPORT_TEXT("report", "Machines"), m_language.count(m_test.members.size()));
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
        const bool isLog = m_test.distribution == TypeDistribution::logNormal;
        const auto limit = [&](const Text &key, const std::optional<double> &number, bool chosen) {
            add(key, value(number) +
                         (chosen ? QStringLiteral(" · ") + m_language.text(REPORT_TEXT("report", "chosen"))
                                 : QString()));
        };
        limit(REPORT_TEXT("report", "Tolerance limit, log-normal"), found.logNormalLimit, isLog);
        limit(REPORT_TEXT("report", "Tolerance limit, normal"), found.normalLimit, !isLog);
        add(REPORT_TEXT("report", "Largest value"), say(REPORT_TEXT("report", "%1 with a confidence of %2"),
                                                        {value(found.sorted.back()).toStdString(),
                                                         percent(found.confidenceOfLargest).toStdString()}));
        add(REPORT_TEXT("report", "Normality of the values"), normality(found.normality));
        add(REPORT_TEXT("report", "Normality of the logarithms"), normality(found.logNormality));
        return result;
    }

    [[nodiscard]] QString named(const ListedMachine &machine) const {
        const QString title = machine.title();
        return machine.serialNumber.isEmpty() || title.contains(machine.serialNumber)
                   ? title
                   : title + QStringLiteral(" · ") + machine.serialNumber;
    }

    [[nodiscard]] Table members() const {
        Table table;
        const QString unit = m_language.unit(m_quantity);
        table.columns = {{m_language.text(REPORT_TEXT("report", "Machine")), {}, Alignment::left, true},
                         {m_language.text(REPORT_TEXT("report", "Date"))},
                         {plainSymbolOf(m_test.parameter), unit, Alignment::decimal},
                         {QStringLiteral("U"), unit, Alignment::decimal},
                         {m_language.text(REPORT_TEXT("report", "Normal score")), {}, Alignment::decimal}};
        for (std::size_t i = 0; i < m_test.members.size(); ++i) {
            const TypeMember &member = m_test.members[i];
            const ShownValue shown = shownResult(member.result, m_test.angular, m_language);
            table.rows.push_back({Cell(named(member.machine)),
                                  Cell(m_language.shortDate(member.test.test.date.value_or(""))),
                                  Cell(shown.value), Cell(shown.uncertainty),
                                  Cell(m_language.number(normalScore(i, m_test.members.size()),
                                                         Quantity::number, scoreDecimals))});
        }
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
            table.rows.push_back({Cell(named(one.machine)),
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
    figure.x.symbol = symbol;
    figure.x.unit = language.unit(quantity);
    double largest = 0;
    const auto add = [&](const QString &id, const QString &name, double value, const QString &shown,
                         bool first) {
        figure.bars.push_back({id, name, {}, value * scale, shown, {}, first});
        largest = std::max(largest, value * scale);
    };
    for (std::size_t i = 0; i < test.members.size(); ++i) {
        const TypeMember &member = test.members[i];
        const ShownValue shown = shownResult(member.result, test.angular, language);
        add(QStringLiteral("machine%1").arg(i + 1), member.machine.title(), *member.result.value,
            shown.text(), false);
    }
    if (test.statistics) {
        for (const auto &[distribution, name] :
             {std::pair(TypeDistribution::logNormal, REPORT_TEXT("report", "Tolerance limit, log-normal")),
              std::pair(TypeDistribution::normal, REPORT_TEXT("report", "Tolerance limit, normal"))}) {
            if (const auto limit = test.statistics->limit(distribution))
                add(distribution == TypeDistribution::normal ? QStringLiteral("normal")
                                                             : QStringLiteral("logNormal"),
                    language.text(name), *limit, language.number(*limit, quantity, 1),
                    distribution == test.distribution);
        }
    }
    constexpr double room = 1.05;
    setRange(figure.x, 0, largest > 0 ? largest * room : 1, mostTicks, TickSteps::values, language);
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
    FigureLine line;
    Bounds y;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = values[i] * scale;
        line.points.emplace_back(normalScore(i, values.size()), logarithms ? std::log(value) : value);
        y.include(line.points.back().y());
    }
    const Bounds range = y.widened(valueMargin, 0.1);
    setRange(figure.x, line.points.front().x(), line.points.back().x(), mostTicks, TickSteps::values,
             language);
    setRange(figure.y, range.lowest, range.highest, mostTicks, TickSteps::values, language);
    figure.lines.push_back(std::move(line));
    return figure;
}

Report composeTypeTest(const TypeTest &test, const Language &language, bool onPaper) {
    return Composer(test, language).compose(onPaper);
}

} // namespace palmer
