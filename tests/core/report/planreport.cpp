// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/planreport.h"

#include "report/blocks/plaintext.h"

#include <QTest>
#include <array>

using namespace palmer;

namespace {

TargetRequest request() {
    TargetRequest result;
    result.from = -50;
    result.travel = 400;
    result.decimals = 2;
    result.seed = 4711;
    result.rule = TargetRule::nominalInterval;
    return result;
}

TargetPlan plan() {
    TargetPlan result;
    result.targets = {-49.25, 50.5, 349.75};
    result.interval = 100;
    result.randomPart = 25;
    return result;
}

CycleProgram program() {
    CycleProgram result;
    result.axis = "X";
    result.targets = plan().targets;
    result.runs = 7;
    result.dwell = 4;
    result.approach = 0.5;
    return result;
}

QString value(const Report &report, const char *key) {
    for (const Block &block : report.blocks) {
        if (const auto *values = std::get_if<KeyValues>(&block)) {
            for (const KeyValue &row : values->rows) {
                if (row.key == key)
                    return QString(row.value).replace(QChar(0xA0), ' ');
            }
        }
    }
    return {};
}

Report composed(const TargetRequest &request, const TargetPlan &plan, const CycleProgram &program) {
    return composePlan(std::array{PlannedMeasurement{request, plan}}, programOf({request, plan}, program),
                       Language(Language::Id::english));
}

} // namespace

/// The plan that is taken to the machine.
class PlanReportTest : public QObject {
    Q_OBJECT

private slots:
    /// A long axis has two measurements, on pages of their own.
    void theZoneOfALongAxisHasItsPage() {
        TargetRequest whole;
        whole.travel = 3000;
        whole.axisTravel = 3000;
        const auto plans = planMeasurements(whole);
        QCOMPARE(plans.size(), std::size_t(2));
        const Report report =
            composePlan(plans, programOf(plans.front(), {}), Language(Language::Id::english));
        const auto isBreak = [](const Block &block) { return std::holds_alternative<PageBreak>(block); };
        QCOMPARE(std::ranges::count_if(report.blocks, isBreak), 1);
        const auto next = std::next(std::ranges::find_if(report.blocks, isBreak));
        const auto *title = std::get_if<Heading>(&*next);
        QVERIFY(title && title->text.contains("zone of the long axis"));
    }

    void saysWhatWasPlannedAndHow() {
        const Report report = composed(request(), plan(), program());
        QCOMPARE(value(report, "Axis"), QString("X"));
        QCOMPARE(value(report, "Measurement travel"), QString("−50 mm to 350 mm"));
        QCOMPARE(value(report, "Targets"), QString("3"));
        QCOMPARE(value(report, "Nominal interval"), QString("100.00 mm"));
        QCOMPARE(value(report, "Random part"), QString("± 25.00 mm, new for every target"));
        QCOMPARE(value(report, "Rule"), QString());
        QCOMPARE(value(report, "Seed"), QString("4711"));
        QCOMPARE(value(report, "Cycle"), QString("standard test cycle"));
        QCOMPARE(value(report, "Runs each way"), QString("7"));
        QCOMPARE(value(report, "Feed rate"), QString("rapid feed"));
        QCOMPARE(value(report, "Dwell at each target"), QString("4 s"));
        QCOMPARE(value(report, "Approach distance"), QString("0.5 mm"));
    }

    void saysOtherRulesCyclesAndFeeds() {
        TargetRequest asked = request();
        asked.rule = TargetRule::pitches1988;
        asked.period = 10;
        CycleProgram cycle = program();
        cycle.cycle = Cycle::step;
        cycle.feed = 1000;
        Report report = composed(asked, plan(), cycle);
        QCOMPARE(value(report, "Random part"), QString("P = (N + r)·p, p = 10 mm"));
        QCOMPARE(value(report, "Cycle"), QString("step cycle"));
        QCOMPARE(value(report, "Feed rate"), QString::fromUtf8("1 000 mm/min"));
        TargetPlan bound = plan();
        bound.boundOf2006 = true;
        report = composed(asked, bound, cycle);
        QCOMPARE(value(report, "Random part"), QString("± 25.00 mm, new for every target"));
        QVERIFY(value(report, "Rule").startsWith("that of ISO 230-2:2006"));
        asked.motion = Motion::rotary;
        report = composed(asked, bound, cycle);
        QCOMPARE(value(report, "Measurement travel"), QString("−50° to 350°"));
        QCOMPARE(value(report, "Nominal interval"), QString("100.00°"));
    }

    /// Of quarter turns and free targets an interval and a random part would be false.
    void saysQuarterTurnsAndFurtherTargets() {
        TargetRequest asked = request();
        asked.motion = Motion::rotary;
        asked.rule = TargetRule::pitches1988;
        TargetPlan turns = plan();
        turns.interval.reset();
        turns.randomPart = 120;
        const Report report = composed(asked, turns, program());
        QCOMPARE(value(report, "Nominal interval"), QString());
        QCOMPARE(value(report, "Random part"), QString());
        QCOMPARE(value(report, "Quarter turns"), QString("all multiples of 90° within the travel"));
        QCOMPARE(value(report, "Further targets"), QString("one in each 120.00° of the travel, at random"));
    }

    /// A field for every reading: five runs beside one another, the rest below.
    void thereIsRoomForEveryReading() {
        const Report report = composed(request(), plan(), program());
        std::vector<const Table *> tables;
        for (const Block &block : report.blocks) {
            if (const auto *table = std::get_if<Table>(&block))
                tables.push_back(table);
        }
        qsizetype fields = 0;
        QStringList runs;
        for (const Table *table : tables) {
            QCOMPARE(table->rows.size(), std::size_t(3));
            QCOMPARE(table->columns[1].unit, QString("mm"));
            QCOMPARE(table->rows[1][0].text.plain(), QString("2"));
            QCOMPARE(table->rows[1][1].text.plain(), QString("50.50"));
            QCOMPARE(table->rulesAfter, (std::vector<std::size_t>{0, 1, 2}));
            for (const auto &row : table->rows)
                QCOMPARE(row.size(), table->columns.size());
            fields += static_cast<qsizetype>(table->columns.size()) - 2;
            for (std::size_t column = 2; column < table->columns.size(); ++column)
                runs << table->columns[column].title.plain();
        }
        QCOMPARE(fields, 14);
        QCOMPARE(runs.first(), QString("1↑"));
        QCOMPARE(runs[1], QString("1↓"));
        QCOMPARE(runs.last(), QString("7↓"));
        const QString text = plainText(report).replace(QChar(0xA0), ' ');
        QVERIFY2(text.contains("The axis moves from −49.75 mm to 350.25 mm."), qPrintable(text));
    }

    void theListIsForPrograms() {
        QCOMPARE(targetList(plan(), 3), QString("1\t-49.250\n2\t50.500\n3\t349.750\n"));
    }
};

QTEST_APPLESS_MAIN(PlanReportTest)
#include "planreport.moc"
