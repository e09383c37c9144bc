// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "register/machinetrend.h"
#include "core/register/listedtests.h"
#include "core/register/registerdata.h"
#include "register/due.h"
#include "register/reevaluate.h"
#include "register/trendfigure.h"
#include "register/trendoutput.h"
#include "register/typeoutput.h"

#include <QTemporaryDir>
#include <QTest>
#include <functional>

using namespace palmer;
using palmer::testdata::fileOf;
using palmer::testdata::made;
using palmer::testdata::Sample;
using palmer::testdata::sinceRepair;
using palmer::testdata::writeFile;

namespace {

std::vector<InterventionKind> kindsOf(const MachineTrend &trend) {
    std::vector<InterventionKind> kinds;
    for (const Intervention &intervention : trend.interventions)
        kinds.push_back(intervention.kind);
    return kinds;
}

using Kinds = std::vector<InterventionKind>;

} // namespace

class MachineTrendTest : public QObject {
    Q_OBJECT

private slots:
    /// Values that go up and down have no trend, and still a bound; a U known only as a whole has no χ²/ν.
    void aBoundIsSaidWithoutATrend() {
        std::vector<ListedTest> tests{made("2024-01-10", 10.0), made("2024-07-10", 10.9),
                                      made("2025-01-10", 9.8),  made("2025-07-10", 10.8),
                                      made("2026-01-10", 10.0), made("2026-07-10", 10.7)};
        const MachineTrend trend = machineTrend(tests, "A");
        QVERIFY(trend.line && !trend.line->isShown());
        const Language english(Language::Id::english);
        QVERIFY2(trendStatement(trend, english).startsWith("no trend shown; not before "),
                 qPrintable(trendStatement(trend, english)));
        QVERIFY(trendStatement(trend, Language(Language::Id::french)).contains("\u202F; "));
        for (ListedTest &test : tests) {
            test.test.parts.clear();
            test.test.results.front().own = 0;
        }
        const MachineTrend whole = machineTrend(tests, "A");
        QVERIFY(whole.line && !whole.line->chi2PerDof);
        QVERIFY(trendFacts(whole, english).back().value.endsWith("χ²/ν\u00A0–"));
    }

    /// Every machine of a type is a dot with its U and limit; the tolerance limits are lines, no dots.
    void theDotsOfAType() {
        std::vector<ListedMachine> machines;
        std::vector<ListedTest> tests;
        const std::vector<double> values{9.4, 8.1, 12.2, 10.3};
        for (std::size_t i = 0; i < values.size(); ++i) {
            ListedMachine machine;
            machine.id = static_cast<int>(i) + 1;
            machine.name = QStringLiteral("M%1").arg(i);
            machines.push_back(machine);
            tests.push_back(made("2026-01-10", values[i]));
            tests.back().machine = machine.id;
        }
        tests.back().test.results.front().limit.reset();
        const TypeTest type = typeTest(machines, tests, "X", "A", {}, TypeDistribution::normal);
        const Language english(Language::Id::english);
        const BarFigure figure = typeFigure(type, english);
        QVERIFY(figure.dots && figure.dots->limit == "agreed limit");
        QCOMPARE(figure.bars.size(), values.size());
        for (std::size_t i = 1; i < figure.bars.size(); ++i)
            QVERIFY(figure.bars[i - 1].size < figure.bars[i].size);
        QCOMPARE(figure.bars.front().name, "M1");
        QCOMPARE(figure.bars.front().expanded, std::optional(1.0)); // µm
        QCOMPARE(figure.bars.front().limit, std::optional(16.0));
        QVERIFY(!figure.bars[2].limit); // 10.3
        QCOMPARE(figure.lines.size(), std::size_t{2});
        QVERIFY(!figure.lines[0].chosen && figure.lines[1].chosen);
        QCOMPARE(figure.lines[1].at, *type.statistics->normalLimit * 1000);
        for (const Bar &bar : figure.bars)
            QVERIFY(figure.x.from <= bar.size - *bar.expanded && bar.size + *bar.expanded <= figure.x.to);
        for (const BarLine &line : figure.lines)
            QVERIFY(line.at < figure.x.to);
        // Points over normal scores, and the line nearest to them: through their mean at 0.
        const LineFigure quantiles = quantileFigure(type, false, english);
        QCOMPARE(quantiles.lines.size(), std::size_t{2});
        QVERIFY(!quantiles.lines[0].dots && quantiles.lines[1].dots);
        QCOMPARE(quantiles.lines[1].points.size(), values.size());
        const auto &ends = quantiles.lines[0].points;
        QVERIFY(std::abs((ends.front().y() + ends.back().y()) / 2 - type.statistics->mean * 1000) < 1e-9);
    }
    void theLineBeginsWithTheLastIntervention() {
        const MachineTrend trend = machineTrend(sinceRepair(), "A");
        QCOMPARE(trend.series.size(), std::size_t{1});
        QCOMPARE(trend.series.front().entries.size(), std::size_t{9});
        QVERIFY(kindsOf(trend) == (Kinds{InterventionKind::collision, InterventionKind::repair}));
        QVERIFY(trend.interventions.back().fromFoundToLeft);
        QCOMPARE(trend.since, std::string("2024-04-16"));
        QCOMPARE(trend.count, std::size_t{6});
        QVERIFY(trend.line && trend.line->isShown());
        // Ordinary least squares: parts that all tests share do not turn the line. µm a year.
        QVERIFY(std::abs(trend.line->slope * 1000 - 1.2913683) < 1e-6);
        QCOMPARE(trend.notBefore.state, NotBefore::State::date);
        const QDate day = dateOfYears(trend.notBefore.time);
        QVERIFY2(day > QDate(2027, 6, 1) && day < QDate(2029, 1, 1), qPrintable(day.toString()));
    }
    void whatIsAnIntervention_data() {
        QTest::addColumn<int>("purpose");
        QTest::addColumn<int>("role");
        QTest::addColumn<int>("nextPurpose");
        QTest::addColumn<int>("nextRole");
        QTest::addColumn<int>("kind"); ///< −1: none
        const auto row = [](const char *name, Purpose a, TestRole ra, Purpose b, TestRole rb, int kind) {
            QTest::newRow(name) << int(a) << int(ra) << int(b) << int(rb) << kind;
        };
        using P = Purpose;
        using R = TestRole;
        const int adjustment = int(InterventionKind::adjustment);
        const int compensation = int(InterventionKind::compensation);
        row("nothing", P::periodic, R::asFound, P::periodic, R::asFound, -1);
        row("from left to found", P::periodic, R::asLeft, P::periodic, R::asFound, -1);
        row("not stated", P::periodic, R::notStated, P::periodic, R::asLeft, -1);
        row("from found to left", P::periodic, R::asFound, P::periodic, R::asLeft, adjustment);
        row("a compensation", P::periodic, R::asFound, P::compensation, R::asLeft, compensation);
        row("a compensation without role", P::periodic, R::asFound, P::compensation, R::notStated,
            compensation);
        row("measured for a compensation", P::compensation, R::asFound, P::periodic, R::asFound,
            compensation);
        row("about to be compensated", P::periodic, R::asFound, P::compensation, R::asFound, -1);
        row("after a repair", P::periodic, R::asFound, P::afterRepair, R::asFound,
            int(InterventionKind::repair));
        row("after a collision", P::periodic, R::asLeft, P::afterCollision, R::asFound,
            int(InterventionKind::collision));
    }
    void whatIsAnIntervention() {
        QFETCH(int, purpose);
        QFETCH(int, role);
        QFETCH(int, nextPurpose);
        QFETCH(int, nextRole);
        QFETCH(int, kind);
        const MachineTrend trend = machineTrend(
            {made("2024-01-01", 9, static_cast<Purpose>(purpose), static_cast<TestRole>(role)),
             made("2024-06-01", 9.5, static_cast<Purpose>(nextPurpose), static_cast<TestRole>(nextRole))},
            "A");
        QVERIFY(kindsOf(trend) == (kind < 0 ? Kinds{} : Kinds{static_cast<InterventionKind>(kind)}));
    }
    void whatIsRepeatedOnADayIsOneIntervention() {
        const MachineTrend trend = machineTrend(
            {made("2024-01-01", 9), made("2024-02-01", 9, Purpose::afterRepair, TestRole::asLeft),
             made("2024-02-01", 9.1, Purpose::afterRepair, TestRole::asLeft)},
            "A");
        QCOMPARE(trend.interventions.size(), std::size_t{1});
        QCOMPARE(trend.count, std::size_t{2});
    }
    void whatCannotBeComparedIsAnotherSeries_data() {
        QTest::addColumn<int>("what");
        QTest::addColumn<QString>("name");
        QTest::newRow("the same") << 0 << "";
        QTest::newRow("edition") << 1 << "ISO 230-2:1988";
        QTest::newRow("feed") << 2 << "feed 500\u00A0mm/min";
        QTest::newRow("no feed") << 3 << "no feed stated";
        QTest::newRow("travel within the tolerance") << 4 << "";
        QTest::newRow("travel beyond it") << 5 << "travel or radius 979\u00A0mm";
        QTest::newRow("correction") << 6 << "correction to 20 °C: not applied";
        QTest::newRow("cycle") << 7 << "step cycle";
        QTest::newRow("cycle only in the newest") << 8 << "step cycle: –";
    }
    void whatCannotBeComparedIsAnotherSeries() {
        QFETCH(int, what);
        QFETCH(QString, name);
        ListedTest older = made("2020-01-01", 9);
        ListedTest newest = made("2021-01-01", 9.2);
        RegisteredTest &test = older.test;
        switch (what) {
        case 1:
            test.edition = "ISO 230-2:1988";
            break;
        case 2:
            test.feed = 500;
            break;
        case 3:
            test.feed.reset();
            break;
        case 4:
            test.travel = 981;
            break;
        case 5:
            test.travel = 979;
            break;
        case 6:
            test.correction = CorrectionTo20::notApplied;
            break;
        case 7:
            test.setUp = "step";
            break;
        case 8:
            newest.test.setUp = "step";
            break;
        default:
            break;
        }
        const MachineTrend trend = machineTrend({older, newest}, "A");
        QCOMPARE(trend.series.size(), name.isEmpty() ? std::size_t{1} : std::size_t{2});
        QCOMPARE(seriesName(trend.series.back(), false, Language(Language::Id::english)), name);
        QCOMPARE(trend.series.front().entries.back().date, std::string("2021-01-01"));
    }
    /// What a file states splits its series, and the legend says it.
    void whatAFileStatesSplitsTheSeries_data() {
        using Change = std::function<void(PositioningMeasurement &)>;
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("name");
        const auto row = [](const char *title, const char *name, Change change) {
            QTest::newRow(title) << change << name;
        };
        row("nothing", "", [](PositioningMeasurement &) {});
        row("location of the sensors", "",
            [](PositioningMeasurement &m) { m.conditions.common.sensors.front().position = "scale"; });
        row("zone", "working zone: 0 … 500.5 mm", [](PositioningMeasurement &m) {
            m.zone = Interval{0, 500.5};
        });
        row("compensation", "active compensation: pitch, reversal",
            [](PositioningMeasurement &m) { m.conditions.common.compensation = " pitch; reversal"; });
        row("tool offset", "tool offset: X 10 Z 120 mm", [](PositioningMeasurement &m) {
            m.conditions.common.toolOffset = {10.0, std::nullopt, 120.0};
        });
        row("workpiece offset", "workpiece offset: Y 5 mm", [](PositioningMeasurement &m) {
            m.conditions.common.workpieceOffset = {std::nullopt, 5.0, std::nullopt};
        });
        row("number of runs", "runs in either direction: 3 + 3", [](PositioningMeasurement &m) {
            m.runs.insert(m.runs.end(), {m.runs[0], m.runs[1]});
        });
        row("several at once", "feed 500 mm/min, working zone: 0 … 500 mm, active compensation: pitch",
            [](PositioningMeasurement &m) {
                m.conditions.feed = 500;
                m.zone = Interval{0, 500};
                m.conditions.common.compensation = "pitch";
            });
        row("rapid feed", "no feed stated, rapid feed",
            [](PositioningMeasurement &m) { m.conditions.feedMode = FeedMode::rapid; });
    }
    void whatAFileStatesSplitsTheSeries() {
        QFETCH(std::function<void(PositioningMeasurement &)>, change);
        QFETCH(QString, name);
        const auto listedTest = [](const char *date, const auto &edit) {
            Sample sample;
            sample.date = date;
            Document document = readDocument(fileOf(sample));
            auto test = std::make_shared<Test>(*document.tests.front());
            edit(std::get<PositioningMeasurement>(test->measurement));
            document.tests.front() = test;
            ListedTest listed;
            listed.test =
                registeredTests(evaluate(std::make_shared<const Document>(document)), "program").front();
            listed.test.fingerprint = date;
            return listed;
        };
        const MachineTrend trend = machineTrend(
            {listedTest("2020-01-01", change), listedTest("2021-01-01", [](PositioningMeasurement &) {})},
            "A");
        QCOMPARE(trend.series.size(), name.isEmpty() ? std::size_t{1} : std::size_t{2});
        const Language english(Language::Id::english);
        QCOMPARE(seriesName(trend.series.back(), false, english).replace(QChar::Nbsp, ' '), name);
        QCOMPARE(otherSeries(trend, english).isEmpty(), name.isEmpty());
        const QString edition = QString::fromStdString(trend.series.front().edition);
        const QString others = otherSeries(trend, english);
        QCOMPARE(trendFigure("A", trend, QDate(2026, 1, 1), english).note,
                 others.isEmpty() ? edition : edition + " · " + others);
    }
    /// Circles: the nominal radius, not its calibration; the signal, and one sense or both.
    void whatSplitsTheSeriesOfCircles() {
        const auto circle = [](double radius, const char *setUp) {
            ListedTest test = made("2020-01-01", 9);
            test.test.kind = Kind::circular;
            test.test.travel = radius;
            test.test.setUp = setUp;
            return test;
        };
        const auto series = [&](const ListedTest &other) {
            return machineTrend({other, circle(150, "runs 1 + 1")}, "A").series.size();
        };
        QCOMPARE(series(circle(150.05, "runs 1 + 1")), std::size_t{1});
        QCOMPARE(series(circle(152, "runs 1 + 1")), std::size_t{2});
        QCOMPARE(series(circle(150, "runs 1 + 0")), std::size_t{2});
        QCOMPARE(series(circle(150, "feedback; runs 1 + 1")), std::size_t{2});
    }
    void ofTheSameReadingsTheNewestCounts() {
        ListedTest older = made("2020-01-01", 9);
        ListedTest newer = made("2020-01-01", 9.5);
        newer.test.fingerprint = older.test.fingerprint;
        const MachineTrend trend = machineTrend({older, newer}, "A");
        QCOMPARE(trend.series.front().entries.size(), std::size_t{1});
        QCOMPARE(*trend.series.front().entries.front().result.value, 0.0095);
        QCOMPARE(trend.sameReadings, 1);
    }
    void testsWithoutDateAreCounted() {
        ListedTest undated = made("2020-01-01", 9);
        undated.test.date.reset();
        const MachineTrend trend = machineTrend({undated, made("2021-01-01", 9)}, "A");
        QCOMPARE(trend.withoutDate, 1);
        QVERIFY(trendJson({}, "X", trend).contains("\"withoutDate\": 1"));
        QVERIFY(trendMethod(trend, Language(Language::Id::english))
                    .endsWith("1 test without a date is left out."));
        QCOMPARE(trend.series.front().entries.size(), std::size_t{1});
    }
    void threeTestsHaveNoLine() {
        auto tests = sinceRepair();
        tests.erase(tests.begin() + 6, tests.end());
        const MachineTrend trend = machineTrend(tests, "A");
        QCOMPARE(trend.count, std::size_t{3});
        QVERIFY(!trend.line);
        QVERIFY(trendJson({}, "X", trend).contains("\"line\": null"));
        QVERIFY(machineTrend({}, "A").series.empty());
        QVERIFY(machineTrend(sinceRepair(), "B").series.empty());
    }
    /// Where conformity has to be proven, the limit is nearer by g; without U nothing is said.
    void theGuardBandBringsTheLimitNearer() {
        auto tests = sinceRepair();
        const auto before = machineTrend(tests, "A").notBefore;
        tests.back().test.rule = Rule::iso14253_1;
        tests.back().test.results.front().guardBand = 0.001;
        const auto proven = machineTrend(tests, "A").notBefore;
        QCOMPARE(proven.state, NotBefore::State::date);
        QVERIFY(proven.time < before.time - 0.3);
        tests.back().test.results.front().guardBand.reset();
        QCOMPARE(machineTrend(tests, "A").notBefore.state, NotBefore::State::noLimit);
        tests.back().test.rule = Rule::rejectionProven;
        tests.back().test.results.front().guardBand = 0.001;
        QCOMPARE(machineTrend(tests, "A").notBefore.time, before.time);
    }
    void boundsLookUpAndDown_data() {
        QTest::addColumn<int>("bound");
        QTest::addColumn<double>("sign");
        QTest::addColumn<double>("limit");
        QTest::addColumn<bool>("reached");
        QTest::newRow("magnitude of growing values") << int(Bound::magnitude) << 1.0 << 0.016 << true;
        QTest::newRow("magnitude of falling values") << int(Bound::magnitude) << -1.0 << 0.016 << true;
        QTest::newRow("upper limit, falling values") << int(Bound::upper) << -1.0 << 0.016 << false;
        QTest::newRow("lower limit, falling values") << int(Bound::lower) << -1.0 << -0.016 << true;
        QTest::newRow("lower limit, growing values") << int(Bound::lower) << 1.0 << -0.016 << false;
    }
    void boundsLookUpAndDown() {
        QFETCH(int, bound);
        QFETCH(double, sign);
        QFETCH(double, limit);
        QFETCH(bool, reached);
        auto tests = sinceRepair();
        for (ListedTest &test : tests) {
            RegisteredResult &result = test.test.results.front();
            result.value = sign * *result.value;
            result.limit = limit;
            result.bound = static_cast<Bound>(bound);
        }
        QCOMPARE(machineTrend(tests, "A").notBefore.state,
                 reached ? NotBefore::State::date : NotBefore::State::beyond);
    }
    void dueDates() {
        QTemporaryDir dir;
        qputenv("XDG_DATA_HOME", dir.filePath("data").toUtf8());
        const auto add = [&](const char *name, const char *date, const char *purpose, const char *axis) {
            Sample sample;
            sample.axis = axis;
            sample.date = date;
            sample.purpose = purpose;
            writeFile(dir.filePath(name), fileOf(sample));
        };
        add("a.palmer", "2025-08-31", "periodic", "X");
        add("b.palmer", "2025-12-01", "afterRepair", "X");
        add("c.palmer", "2025-05-01", "periodic", "Y");
        add("d.palmer", "2025-06-01", "acceptance", "Y");
        add("e.palmer", "2025-07-01", "compensation", "Z");
        Register reg(dir.filePath("register.sqlite"));
        (void)scan(reg, {dir.path()});
        const ListedMachine machine = machines(reg.database()).front();
        const auto said = [&reg](const ListedMachine &one, std::optional<int> months) {
            auto list = tests(reg.database(), {});
            (void)markDue(reg.database(), one, list, months);
            std::string result;
            for (const ListedTest &test : list)
                result += test.test.axis + ' ' + test.due.value_or("-") + ' ' +
                          test.certificateDue.value_or("-") + "; ";
            return result;
        };
        QCOMPARE(said(machine, {}),
                 std::string("Y - -; Y - 2027-01-31; Z - 2027-01-31; X - -; X - 2027-01-31; "));
        // Half a year later has no 31st; Z was never tested for that.
        const std::string due =
            "Y - -; Y 2025-12-01 2027-01-31; Z - 2027-01-31; X 2026-02-28 -; X - 2027-01-31; ";
        QCOMPARE(said(machine, 6), due);
        (void)chooseMachine(reg, machine, nullptr, 6, Language(Language::Id::english));
        const auto set = machines(reg.database());
        QCOMPARE(said(set.front(), 12), due); // its own interval
        const MachineDue quick = palmer::dueDates(reg.database(), set).at(machine.id);
        QCOMPARE(quick.tests,
                 (std::map<QString, QDate>{{"X", QDate(2026, 2, 28)}, {"Y", QDate(2025, 12, 1)}}));
        QCOMPARE(quick.test(), std::optional(QDate(2025, 12, 1)));
        QCOMPARE(quick.axesDue(QDate(2025, 12, 1)), QString("Y"));
        QCOMPARE(quick.certificate, std::optional(QDate(2027, 1, 31)));
    }
    /// Under one edition all tests are one series, and what their files no longer hold is left out.
    void evaluatedAnewUnderOneEdition() {
        QTemporaryDir dir;
        for (int i = 0; i < 5; ++i) {
            Sample sample;
            sample.date = "202" + std::to_string(i) + "-01-01";
            sample.level = 9 + 0.5 * i;
            sample.edition = i < 3 ? "ISO 230-2:1988" : "ISO 230-2:2014";
            writeFile(dir.filePath(QString("%1.palmer").arg(i)), fileOf(sample));
        }
        Register reg(dir.filePath("register.sqlite"));
        (void)scan(reg, {dir.path()});
        auto list = tests(reg.database(), {});
        QCOMPARE(machineTrend(list, "A").series.size(), std::size_t{2});
        QVERIFY(!machineTrend(list, "A").line);
        QCOMPARE(reevaluate(list, *findEdition("ISO 230-2:2014")).size(), std::size_t{0});
        const MachineTrend trend = machineTrend(list, "A");
        QCOMPARE(trend.series.size(), std::size_t{1});
        QVERIFY(trend.line);
        QFile::remove(dir.filePath("1.palmer"));
        QCOMPARE(reevaluate(list, *findEdition("ISO 230-2:2006")).size(), std::size_t{1});
        QCOMPARE(list.size(), std::size_t{4});
    }
    void theDrawnTrendIsTheComputedOne() {
        auto tests = sinceRepair();
        tests.insert(tests.begin(), made("2021-01-01", 11));
        tests.front().test.edition = "ISO 230-2:1988";
        tests.front().test.results.front().limit = 0.018;
        tests[3].test.results.front().verdict = Verdict::doesNotConform;
        const MachineTrend trend = machineTrend(tests, "A");
        const QDate today(2026, 11, 22);
        const Language language(Language::Id::english);
        const TrendPanel panel = trendPanel(trend, trendSpan({trend}, today), today, language, 8);
        QCOMPARE(panel.values.size(), std::size_t{10});
        QCOMPARE(panel.values.back().mark, TrendMark::otherSeries);
        QCOMPARE(panel.values[3].mark, TrendMark::asLeft);
        QVERIFY(panel.values[2].exceeds && !panel.values[1].exceeds);
        // Joined within a role and between interventions: 2023 – 2023, and the five after the repair.
        QCOMPARE(panel.joined.size(), std::size_t{5});
        // One line of limits with one step down.
        QCOMPARE(panel.limits.size(), std::size_t{1});
        QCOMPARE(panel.limits.front().size(), std::size_t{4});
        QCOMPARE(panel.limits.front().front().y(), 18.0);
        QCOMPARE(panel.limits.front().back().y(), 16.0);
        QCOMPARE(panel.interventions.size(), std::size_t{2});
        QVERIFY(panel.interventions[1].found && panel.interventions[1].left);
        QCOMPARE(panel.interventions[1].found->y(), 19.3);
        QCOMPARE(panel.interventions[1].left->y(), 9.4);
        // "Not before" lies on the upper edge of the band and on the limit.
        QVERIFY(panel.notBefore);
        QCOMPARE(panel.notBefore->y(), 16.0);
        const auto right = std::ranges::find_if(
            panel.band, [&](const BandPoint &point) { return point.x >= panel.notBefore->x(); });
        QVERIFY(right != panel.band.begin() && right != panel.band.end());
        const BandPoint &left = *std::prev(right);
        const double part = (panel.notBefore->x() - left.x) / (right->x - left.x);
        // The edge is drawn by straight pieces of a tenth of a year, days are whole.
        QVERIFY(std::abs(left.upper + part * (right->upper - left.upper) - 16) < 0.05);
        QVERIFY(panel.y.from <= 8.4 && panel.y.to >= 20.3); // with the bars of ± U
        QVERIFY(!trendFigure("A", trend, today, language).legend.empty());
        // Without a test nothing is drawn, and nothing breaks.
        const MachineTrend none = machineTrend({}, "A");
        QVERIFY(trendPanel(none, trendSpan({none}, today), today, language, 8).values.empty());
    }
    /// From a month to twenty years, beginning anywhere in a year.
    void theTimeAxisHasALabelWhateverItsSpan() {
        const QDate today(2026, 11, 22);
        const Language english(Language::Id::english);
        const MachineTrend trend = machineTrend(sinceRepair(), "A");
        for (const int most : {1, 3, 8}) {
            for (int begin = 0; begin < 24; ++begin) {
                for (const double years : {0.1, 0.25, 0.5, 0.9, 1.5, 3.0, 7.0, 20.0}) {
                    const double from = 2024 + begin / 24.0;
                    const auto ticks = trendPanel(trend, {from, from + years}, today, english, most).x.ticks;
                    const QString place = QString("%1 + %2, %3").arg(from).arg(years).arg(most);
                    QVERIFY2(!ticks.empty(), qPrintable(place));
                    QSet<QString> labels;
                    for (const Tick &tick : ticks) {
                        QVERIFY2(tick.value >= from && tick.value <= from + years, qPrintable(place));
                        labels.insert(tick.label);
                    }
                    QCOMPARE(static_cast<std::size_t>(labels.size()), ticks.size());
                    if (ticks.front().label.contains(' ')) // months
                        QVERIFY2(ticks.size() <= static_cast<std::size_t>(most), qPrintable(place));
                }
            }
        }
        const auto ticks = trendPanel(trend, {2026.1, 2026.4}, today, english, 8).x.ticks;
        QCOMPARE(ticks.front().label, QString("Mar 2026")); // 0.1 of a year is in February
        QCOMPARE(ticks.size(), std::size_t{3});
        const Language french(Language::Id::french);
        QCOMPARE(trendPanel(trend, {2026.05, 2026.1}, today, french, 8).x.ticks.front().label,
                 QStringLiteral("f\u00e9vr. 2026"));
    }
    void statesAreThoseOfTheNewestTests() {
        QTemporaryDir dir;
        const auto add = [&](const char *name, const char *axis, const char *date, double level) {
            Sample sample;
            sample.axis = axis;
            sample.date = date;
            sample.level = level;
            writeFile(dir.filePath(name), fileOf(sample));
        };
        add("a.palmer", "X", "2025-01-01", 30);
        add("b.palmer", "X", "2026-01-01", 5);
        add("c.palmer", "Y", "2024-01-01", 30);
        Register reg(dir.filePath("register.sqlite"));
        (void)scan(reg, {dir.path()});
        const auto states = axisStates(reg.database());
        QCOMPARE(states.size(), std::size_t{1});
        const auto &axes = states.begin()->second;
        QCOMPARE(axes.size(), std::size_t{2});
        QCOMPARE(axes[0].axis, QString("X"));
        QCOMPARE(axes[0].verdict, std::optional(Verdict::conforms));
        QCOMPARE(axes[1].verdict, std::optional(Verdict::doesNotConform));
        // Of one day the test as left is the newer one.
        for (const char *role : {"asFound", "asLeft"}) {
            Sample sample;
            sample.axis = "Z";
            sample.role = role;
            sample.level = sample.role == "asLeft" ? 5 : 30;
            writeFile(dir.filePath(QString(role) + ".palmer"), fileOf(sample));
        }
        (void)scan(reg, {dir.path()});
        QCOMPARE(axisStates(reg.database()).begin()->second.back().verdict, std::optional(Verdict::conforms));
    }
    void aDayLiesWhereItIs() {
        for (const QDate day :
             {QDate(1999, 12, 31), QDate(2000, 2, 29), QDate(2026, 11, 17), QDate(2100, 3, 1)})
            QCOMPARE(dateOfYears(yearsOf(day)), day);
    }
};

QTEST_GUILESS_MAIN(MachineTrendTest)
#include "machinetrend.moc"
