// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/history.h"

#include "document/documenterror.h"
#include "kernel/evaluation/conformity.h"
#include "kernel/measurement/testfacts.h"
#include "language/rounding.h"
#include "language/withunit.h"
#include "register/historyfile.h"
#include "register/listing.h"
#include "register/machinetrend.h"
#include "register/scan.h"
#include "register/trendfigure.h"
#include "register/trendoutput.h"
#include "report/attachedfile.h"
#include "report/parts/testpart.h"
#include "report/words/accordancetext.h"
#include "report/words/wording.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <map>
#include <span>

namespace palmer {

namespace {

constexpr double panelHeight = 27;      ///< mm
constexpr double legendRowHeight = 4.2; ///< mm, for three texts
constexpr double legendMargin = 1.6;
constexpr std::size_t panelsOfRow = 4;
constexpr std::size_t mostWithEdition = 4;
constexpr int mostResults = 5;         ///< per test
constexpr std::size_t mostColumns = 5; ///< axes and planes next to each other in the table of campaigns

/// The trends of an axis or plane.
struct AxisTrends {
    std::string axis;
    std::vector<ListedTest> tests;
    std::vector<MachineTrend> trends;  ///< with a chart
    std::vector<MachineTrend> limited; ///< of the other parameters that have a limit
};

QString utf8(const std::string &text) {
    return QString::fromStdString(text);
}

class Composer {
public:
    Composer(const History &history, const Language &language)
        : m_history(history)
        , m_language(language) {
        for (const ListedTest &test : history.tests) {
            if (!traitsOf(test.test.kind).isJudged)
                continue;
            const auto found = std::ranges::find(m_axes, test.test.axis, &AxisTrends::axis);
            AxisTrends &axis = found == m_axes.end() ? m_axes.emplace_back() : *found;
            axis.axis = test.test.axis;
            axis.tests.push_back(test);
        }
        std::ranges::sort(m_axes, {}, [](const AxisTrends &axis) {
            return std::tuple(axis.tests.front().test.kind, axis.axis);
        });
        std::vector<MachineTrend> all;
        for (AxisTrends &axis : m_axes) {
            const std::vector<std::string> main = mainParametersOf(axis.tests);
            for (const std::string &parameter : main)
                axis.trends.push_back(machineTrend(axis.tests, parameter));
            for (const std::string &parameter : parametersOf(axis.tests)) {
                MachineTrend trend = machineTrend(axis.tests, parameter);
                if (trend.limit && std::ranges::find(main, parameter) == main.end())
                    axis.limited.push_back(std::move(trend));
            }
            all.insert(all.end(), axis.trends.begin(), axis.trends.end());
        }
        m_span = trendSpan(all, history.today);
    }

    Report compose() {
        Report report;
        report.language = m_language.code();
        const QString title = say(REPORT_TEXT("report", "History of %1"), {name().toStdString()});
        report.testFile = historyJson(m_history);
        report.testFileName = historyFileName;
        report.fingerprint = fingerprint(report.testFile);
        const QString &number = m_history.number;
        report.title = number.isEmpty() ? title : title + u' ' + number;
        report.laboratory = utf8(m_history.laboratory.name);
        report.date = m_history.today.toString(Qt::ISODate);
        report.making.program = m_history.program;
        m_blocks = &report.blocks;
        addHead(title);
        addWatch();
        addFigures();
        addCampaigns();
        addResults();
        report.blocks.emplace_back(EndMark{text(REPORT_TEXT("report", "End of the history"))});
        report.footerLeft =
            number.isEmpty() ? title : say(REPORT_TEXT("report", "History %1"), {number.toStdString()});
        report.footerCentre = say(REPORT_TEXT("report", "Fingerprint SHA-256 %1"),
                                  {shortFingerprint(report.fingerprint).toStdString()});
        report.footerRight = text(REPORT_TEXT("report", "page %1 / %2"));
        return report;
    }

private:
    [[nodiscard]] QString text(const Text &source) const {
        return source.empty() ? QString() : m_language.text(source);
    }
    [[nodiscard]] QString say(const Text &source, std::vector<Argument> arguments) const {
        return m_language.sentence({source, std::move(arguments)});
    }
    [[nodiscard]] QString name() const {
        const QString title = m_history.machine.title();
        return title.isEmpty() ? text(REPORT_TEXT("report", "a machine without name")) : title;
    }

    [[nodiscard]] QString period() const {
        std::string first;
        std::string last;
        for (const ListedTest &test : m_history.tests) {
            if (!test.test.date)
                continue;
            first = first.empty() ? *test.test.date : first;
            last = *test.test.date;
        }
        if (first.empty())
            return text(REPORT_TEXT("report", "Results over time"));
        const QString begin = monthText(dateOf(first), m_language);
        const QString end = monthText(dateOf(last), m_language);
        const QString months =
            begin == end ? begin
                         : say(REPORT_TEXT("report", "%1 to %2"), {begin.toStdString(), end.toStdString()});
        return say(REPORT_TEXT("report", "Results over time, %1"), {months.toStdString()});
    }

    [[nodiscard]] QString counts() const {
        QStringList parts;
        for (const AxisTrends &axis : m_axes)
            parts << utf8(axis.axis) + QChar(QChar::Nbsp) + QString::number(axis.tests.size());
        return say(REPORT_TEXT("report", "%1: %2"),
                   {Number{static_cast<double>(m_history.tests.size()), Quantity::count},
                    parts.join(QStringLiteral(", ")).toStdString()});
    }

    [[nodiscard]] QString serialNumbers() const {
        const ListedMachine &machine = m_history.machine;
        QStringList all{machine.serialNumber};
        if (!machine.joined.empty())
            all << joinedText(machine, m_language);
        all.removeAll(QString());
        return all.join(m_language.semicolon());
    }

    void addHead(const QString &title) {
        TestHead head;
        head.laboratory = utf8(m_history.laboratory.name);
        head.address = utf8(m_history.laboratory.address);
        head.accreditation = utf8(m_history.laboratory.accreditation);
        if (!m_history.number.isEmpty())
            head.number = say(REPORT_TEXT("report", "History No. %1"), {m_history.number.toStdString()});
        const auto count = [](std::size_t n) { return Number{static_cast<double>(n), Quantity::count}; };
        head.numberNotes << say(REPORT_TEXT("report", "Tests: %1, campaigns: %2"),
                                {count(m_history.tests.size()), count(campaigns().size())});
        head.title = title;
        head.subtitle = period();
        const ListedMachine &machine = m_history.machine;
        QStringList type{machine.manufacturer, machine.model};
        type.removeAll(QString());
        head.left.rows = {{text(REPORT_TEXT("report", "Machine")), name()},
                          {text(REPORT_TEXT("report", "Maker, type")), type.join(QStringLiteral(", "))},
                          {text(REPORT_TEXT("report", "Serial number")), serialNumbers()}};
        QString interval = text(REPORT_TEXT("report", "none"));
        if (machine.months)
            interval = m_language.sentence(
                {REPORT_TEXT_COUNTED("report", "%n month(s)"), {}, static_cast<int>(*machine.months)});
        if (const std::optional<QDate> due = m_history.due.test())
            interval += m_language.semicolon() + say(*due < m_history.today
                                                         ? REPORT_TEXT("report", "overdue since %1 (%2)")
                                                         : REPORT_TEXT("report", "next test before %1 (%2)"),
                                                     {Date{due->toString(Qt::ISODate).toStdString()},
                                                      m_history.due.axesDue(*due).toStdString()});
        head.right.rows = {{text(REPORT_TEXT("report", "Tests")), counts()},
                           {text(REPORT_TEXT("report", "Interval")), interval},
                           {text(REPORT_TEXT("report", "Made on")),
                            m_language.date(m_history.today.toString(Qt::ISODate).toStdString())}};
        m_blocks->emplace_back(std::move(head));
    }

    struct Watched {
        const AxisTrends *axis;
        const MachineTrend *trend;
    };

    [[nodiscard]] std::vector<Watched> trendsThat(bool (*is)(const MachineTrend &)) const {
        std::vector<Watched> list;
        for (const AxisTrends &axis : m_axes) {
            for (const auto *trends : {&axis.trends, &axis.limited}) {
                for (const MachineTrend &trend : *trends) {
                    if (is(trend))
                        list.push_back({&axis, &trend});
                }
            }
        }
        return list;
    }

    /// Trends that may reach their limit, the earliest first. A line need not be shown as a trend: too little
    /// data must not silence the warning.
    [[nodiscard]] std::vector<Watched> watched() const {
        std::vector<Watched> list = trendsThat([](const MachineTrend &trend) {
            return trend.line && (trend.notBefore.state == NotBefore::State::date ||
                                  trend.notBefore.state == NotBefore::State::already);
        });
        std::ranges::stable_sort(list, {}, [](const Watched &one) { return one.trend->notBefore.time; });
        return list;
    }

    [[nodiscard]] QString symbolAndAxis(const Watched &one) const {
        return say(REPORT_TEXT_FOR("report", "%1 of %2", "parameter of an axis"),
                   {plainSymbolOf(one.trend->parameter).toStdString(), one.axis->axis});
    }

    /// Quantities whose newest result exceeds its limit.
    [[nodiscard]] std::vector<Watched> exceededNow() const {
        return trendsThat([](const MachineTrend &trend) {
            return !trend.series.empty() && trend.limit &&
                   trend.series.front().entries.back().result.verdict == Verdict::doesNotConform;
        });
    }

    /// "4.2 ± 0.3 µm": the newest result.
    [[nodiscard]] QString newestOf(const MachineTrend &trend) const {
        return withUnit(
            shownResult(trend.series.front().entries.back().result, trend.angular, m_language).text(),
            m_language.unit(trendQuantity(trend)));
    }

    [[nodiscard]] QString limitOf(const MachineTrend &trend) const {
        const Quantity quantity = trendQuantity(trend);
        return m_language.quantity(*trend.limit, quantity, limitDecimals(*trend.limit, quantity));
    }

    [[nodiscard]] VerdictStatement statementOf(const Text &label, const Watched &one) const {
        return {text(label), Mark::none, symbolAndAxis(one), trendStatement(*one.trend, m_language)};
    }

    /// Says why no parameter is to be watched.
    void sayWhyNone(VerdictLine &line) const {
        const std::vector<Watched> dated =
            trendsThat([](const MachineTrend &t) { return !t.series.empty(); });
        const std::vector<Watched> limited = trendsThat([](const MachineTrend &t) { return !!t.limit; });
        const std::vector<Watched> lines =
            trendsThat([](const MachineTrend &t) { return t.limit && t.line; });
        line.word = text(!dated.empty() && limited.empty() ? REPORT_TEXT("report", "no limit agreed")
                         : lines.empty() ? REPORT_TEXT("report", "too few tests: nothing is said")
                                         : REPORT_TEXT("report", "no limit within twice the observed time"));
        if (limited.empty())
            return;
        line.limits =
            statementOf(REPORT_TEXT("report", "Trend"), lines.empty() ? limited.front() : lines.front());
    }

    /// The parameter that is exceeded now, otherwise the one that may be first; then the next of these.
    void addWatch() {
        const std::vector<Watched> list = watched();
        const std::vector<Watched> exceeded = exceededNow();
        VerdictLine line;
        if (!exceeded.empty()) {
            const Watched &first = exceeded.front();
            line.mark = Mark::cross;
            line.label = text(REPORT_TEXT("report", "Exceeded at the last test"));
            line.word = say(REPORT_TEXT("report", "%1: %2"),
                            {symbolAndAxis(first).toStdString(), newestOf(*first.trend).toStdString()});
            line.limits = {text(REPORT_TEXT("report", "Limit")), Mark::none, limitOf(*first.trend), {}};
            QStringList others;
            for (const Watched &one : std::span(exceeded).subspan(1))
                others << say(REPORT_TEXT("report", "%1 (%2 against %3)"),
                              {symbolAndAxis(one).toStdString(), newestOf(*one.trend).toStdString(),
                               limitOf(*one.trend).toStdString()});
            line.limits.text = others.join(QStringLiteral(", "));
            if (!list.empty())
                line.accordance = statementOf(REPORT_TEXT("report", "To watch first"), list.front());
        } else if (list.empty()) {
            line.label = text(REPORT_TEXT("report", "To watch first"));
            sayWhyNone(line);
        } else {
            const MachineTrend &trend = *list.front().trend;
            line.label = text(REPORT_TEXT("report", "To watch first"));
            line.word =
                say(REPORT_TEXT("report", "%1: %2"), {symbolAndAxis(list.front()).toStdString(),
                                                      trendStatement(trend, m_language).toStdString()});
            line.limits = {
                text(REPORT_TEXT("report", "Limit")), Mark::none, limitOf(trend),
                say(REPORT_TEXT("report", "%1 at the last test"), {newestOf(trend).toStdString()})};
            if (list.size() > 1)
                line.accordance = statementOf(REPORT_TEXT("report", "Then"), list[1]);
        }
        m_blocks->emplace_back(std::move(line));
    }

    /// Returns the travel of the newest tests.
    [[nodiscard]] QString travelOf(const MachineTrend &trend) const {
        if (trend.series.empty() || !trend.series.front().travel)
            return {};
        const QString length = m_language.quantity(*trend.series.front().travel,
                                                   trend.angular ? Quantity::angle : Quantity::position, 0);
        return traitsOf(trend.kind).isOfAxis ? length : QStringLiteral("R ") + length;
    }

    /// Returns the units of the charts: rotary axes differ from the rest.
    [[nodiscard]] QString units() const {
        QStringList result;
        for (const AxisTrends &axis : m_axes) {
            for (const MachineTrend &trend : axis.trends)
                result << unitInWords(trend, m_language);
        }
        result.removeDuplicates();
        return result.join(QStringLiteral(", "));
    }

    void addFigures() {
        if (m_axes.empty())
            return;
        const std::vector<Watched> list = watched();
        m_blocks->emplace_back(Heading{2, text(REPORT_TEXT("report", "Trends")), Phrase(units())});
        bool withoutParts = false;
        std::vector<MachineTrend> all;
        for (const AxisTrends &axis : m_axes)
            all.insert(all.end(), axis.trends.begin(), axis.trends.end());
        for (const AxisTrends &axis : m_axes) {
            TrendFigure figure;
            figure.title = utf8(axis.axis);
            figure.label = utf8(axis.axis);
            for (const MachineTrend &trend : axis.trends) {
                figure.panels.push_back(smallTrendPanel(trend, m_span, m_history.today, m_language));
                figure.panels.back().isFirst = !list.empty() && list.front().trend == &trend;
                withoutParts = withoutParts || trend.withoutParts;
                figure.note = travelOf(trend);
            }
            const bool isLast = &axis == &m_axes.back();
            const bool hasRoom = figure.panels.size() < panelsOfRow;
            if (isLast && hasRoom)
                figure.legend = trendLegend(m_language, all);
            m_blocks->emplace_back(FigureBlock{std::move(figure), 175, panelHeight});
            if (isLast && !hasRoom) {
                TrendFigure legend;
                legend.legend = trendLegend(m_language, all);
                const std::size_t rows = (legend.legend.size() + 2) / 3;
                m_blocks->emplace_back(FigureBlock{
                    std::move(legend), 175, static_cast<double>(rows) * legendRowHeight + legendMargin});
            }
        }
        MachineTrend method;
        method.withoutParts = withoutParts;
        method.withoutDate = static_cast<int>(std::ranges::count_if(m_history.tests, [](const ListedTest &t) {
            return traitsOf(t.test.kind).isJudged && !t.test.date;
        }));
        m_blocks->emplace_back(Paragraph{
            say(REPORT_TEXT("report",
                            "%1 * not reached within twice the observed time: nothing is said beyond."),
                {trendMethod(method, m_language).toStdString()}),
            TextSize::small});
    }

    /// Tests with the same day, purpose and role, by axis. Further tests of an axis, as of its zone, are in
    /// rows of their own.
    using Row = std::map<std::string, const ListedTest *>;
    using Campaigns = std::map<std::tuple<std::string, TestRole, Purpose>, std::vector<Row>>;

    [[nodiscard]] Campaigns campaigns() const {
        Campaigns result;
        for (const AxisTrends &axis : m_axes) {
            for (const ListedTest &test : axis.tests) {
                if (!test.test.date)
                    continue;
                std::vector<Row> &rows = result[{*test.test.date, test.test.role, test.test.purpose}];
                const auto free =
                    std::ranges::find_if(rows, [&](const Row &row) { return !row.contains(axis.axis); });
                (free == rows.end() ? rows.emplace_back() : *free)[axis.axis] = &test;
            }
        }
        return result;
    }

    void addCampaigns() {
        const Campaigns all = campaigns();
        if (all.empty())
            return;
        m_blocks->emplace_back(Heading{
            2, text(REPORT_TEXT("report", "Campaigns")),
            Phrase(text(REPORT_TEXT("report", "the first quantity of each axis; all are listed below")))});
        Table table;
        table.columns = {{text(REPORT_TEXT("report", "Date")), {}, Alignment::left, false, 21},
                         {text(REPORT_TEXT("report", "Purpose")), {}, Alignment::left, true},
                         {text(REPORT_TEXT("report", "Role")), {}, Alignment::left, false, 21}};
        const std::size_t shown = std::min(m_axes.size(), mostColumns);
        const bool hasEdition = shown < mostWithEdition; // all tests repeat it below
        if (hasEdition)
            table.columns.push_back({text(REPORT_TEXT("report", "Edition")), QStringLiteral("230-2"),
                                     Alignment::left, false, 12});
        for (std::size_t i = 0; i < shown; ++i) {
            const AxisTrends &axis = m_axes[i];
            const QString symbol =
                axis.trends.empty() ? QString() : plainSymbolOf(quantityOf(axis.trends.front().parameter));
            table.columns.push_back(
                {Phrase(std::vector<Span>{{symbol}, {utf8(axis.axis), true}}),
                 axis.trends.empty() ? QString() : m_language.unit(trendQuantity(axis.trends.front())),
                 Alignment::decimal, false, 12});
        }
        table.columns.push_back({text(REPORT_TEXT("report", "Limits")), {}, Alignment::left, false, 23});
        table.columns.push_back({text(REPORT_TEXT("report", "Tests")), {}, Alignment::left, false, 28});
        table.columns.back().fitting = hasEdition; // there is room then
        for (const auto &[key, rows] : all) {
            const auto &[date, role, purpose] = key;
            for (const Row &tests : rows) {
                std::vector<Cell> row{Cell(m_language.shortDate(date)), Cell(text(purposeText(purpose))),
                                      Cell(text(roleText(role)))};
                if (hasEdition)
                    row.emplace_back(editionsOf(tests));
                for (std::size_t i = 0; i < shown; ++i) {
                    const auto test = tests.find(m_axes[i].axis);
                    row.push_back(test == tests.end() ? Cell() : firstResult(m_axes[i], test->second->test));
                }
                row.push_back(limitsOf(tests));
                row.push_back(accordanceOf(tests));
                table.rows.push_back(std::move(row));
            }
        }
        leaveOutEmptyColumns(table, 1, 2); // purpose, role
        m_blocks->emplace_back(std::move(table));
    }

    /// Returns the combined state of all tests of a row relative to their limits.
    [[nodiscard]] Cell limitsOf(const Row &tests) const {
        std::optional<Verdict> verdict;
        bool anyLimit = false;
        for (const auto &[axis, listed] : tests) {
            const RegisteredTest &test = listed->test;
            verdict = worst(verdict, test.verdict);
            anyLimit = anyLimit || hasLimit(test);
        }
        Cell limits(text(limitsText(verdict, anyLimit)));
        if (verdict)
            limits.mark = markOf(*verdict);
        limits.bold = verdict == Verdict::doesNotConform;
        return limits;
    }

    /// Returns the editions used for the axes, of ISO 230-2 the year.
    [[nodiscard]] static QString editionsOf(const Row &tests) {
        const auto iso = QStringLiteral("ISO 230-2:");
        QStringList editions;
        for (const auto &[axis, listed] : tests) {
            if (traitsOf(listed->test.kind).isOfAxis)
                editions << utf8(listed->test.edition);
            if (!editions.isEmpty() && editions.back().startsWith(iso))
                editions.back().remove(0, iso.size());
        }
        editions.removeDuplicates();
        editions.sort();
        return editions.join(QStringLiteral(", "));
    }

    /// Returns the weakest accordance of its tests.
    [[nodiscard]] Cell accordanceOf(const Row &tests) const {
        constexpr std::array fromWeakest{Accordance::no, Accordance::notShown, Accordance::notChecked,
                                         Accordance::partly, Accordance::yes};
        for (const Accordance accordance : fromWeakest) {
            int unmet = 0;
            int undeclared = 0;
            bool isThere = false;
            for (const auto &[axis, listed] : tests) {
                if (listed->test.accordance != accordance)
                    continue;
                isThere = true;
                unmet += listed->test.counts.unmet;
                undeclared += listed->test.counts.undeclared;
            }
            if (!isThere)
                continue;
            QString words = text(accordanceWords(accordance));
            if (accordance == Accordance::no)
                words = m_language.sentence({REPORT_TEXT_COUNTED("report", "%n not met"), {}, unmet});
            else if (accordance == Accordance::notShown)
                words =
                    m_language.sentence({REPORT_TEXT_COUNTED("report", "%n not declared"), {}, undeclared});
            Cell cell(words);
            cell.mark = markOf(accordance);
            return cell;
        }
        return {};
    }

    [[nodiscard]] Cell firstResult(const AxisTrends &axis, const RegisteredTest &test) const {
        if (axis.trends.empty())
            return {};
        const RegisteredResult *found = resultOf(test, axis.trends.front().parameter);
        return !found || !found->value ? Cell() : Cell(shownResult(*found, test.angular, m_language).value);
    }

    void addResults() {
        m_blocks->emplace_back(Heading{2, text(REPORT_TEXT("report", "All tests"))});
        Table table;
        table.columns = {{text(REPORT_TEXT("report", "Date")), {}, Alignment::left, false, 22},
                         {text(REPORT_TEXT("report", "Axis")), {}, Alignment::left, false, 10},
                         {text(REPORT_TEXT("report", "Edition")), {}, Alignment::left, false, 27},
                         {text(REPORT_TEXT("report", "Results ± U")), {}, Alignment::left, true},
                         {text(REPORT_TEXT("report", "File")), {}, Alignment::left, false, 45}};
        for (const ListedTest &listed : m_history.tests) {
            const RegisteredTest &test = listed.test;
            table.rows.push_back({Cell(test.date ? m_language.shortDate(*test.date) : QString()),
                                  Cell(utf8(test.axis)), Cell(utf8(test.edition)), Cell(resultsOf(test)),
                                  Cell(QFileInfo(listed.places.front().path).fileName())});
        }
        m_blocks->emplace_back(std::move(table));
    }

    [[nodiscard]] Phrase resultsOf(const RegisteredTest &test) const {
        ListedTest one;
        one.test = test;
        std::vector<Span> results;
        int count = 0;
        for (const std::string &id : parametersOf({one})) {
            const QString symbol = plainSymbolOf(id);
            const std::size_t end = id.find('_');
            const QString index = end == std::string::npos ? QString() : utf8(id.substr(end + 1));
            results.push_back(
                {(count == 0 ? QString() : m_language.semicolon()) + symbol.chopped(index.size())});
            if (!index.isEmpty())
                results.push_back({index, true});
            results.push_back(
                {QChar(QChar::Nbsp) + shownResult(*resultOf(test, id), test.angular, m_language).text()});
            if (++count == mostResults)
                break;
        }
        return Phrase(std::move(results));
    }

    const History &m_history;
    const Language &m_language;
    std::vector<AxisTrends> m_axes;
    TrendSpan m_span;
    std::vector<Block> *m_blocks = nullptr;
};

} // namespace

History historyOf(Database &database, const ListedMachine &machine, const QDate &today,
                  const QString &program) {
    History history;
    history.machine = machine;
    TestFilter filter;
    filter.machines = {machine.id};
    history.tests = tests(database, filter);
    history.due = markDue(database, machine, history.tests);
    history.today = today;
    history.program = program;
    history.number = proposedHistoryNumber(machine, today);
    for (auto test = history.tests.rbegin(); test != history.tests.rend(); ++test) {
        try {
            if (const auto document = documentOfFile(test->places.front().path)) {
                history.laboratory = document->report.laboratory;
                break;
            }
        } catch (const Error &) { // file not found any more: an older one will do
            continue;
        }
    }
    return history;
}

QString proposedHistoryNumber(const ListedMachine &machine, const QDate &today) {
    const QString serial = machine.serialNumber.simplified().replace(u' ', u'-');
    return serial.isEmpty() ? QString() : QStringLiteral("HI-%1-%2").arg(today.year()).arg(serial);
}

Report composeHistory(const History &history, const Language &language) {
    return Composer(history, language).compose();
}

} // namespace palmer
