// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/templatefile.h"

#include <QTest>

using namespace palmer;

namespace {

Template machine() {
    Machine machine;
    machine.name = "DMU 50";
    machine.year = 2024;
    return {"ours", machine};
}

Template instrument() {
    Instrument laser;
    laser.id = "laser";
    laser.calibrationDate = "2026-01-31";
    laser.resolution = 0.00001;
    return {"XL-80", laser};
}

Template laboratory() {
    Laboratory laboratory;
    laboratory.name = "Métrologie du Rhône";
    laboratory.logo = "iVBORw0KGgo=";
    return {"société", laboratory};
}

Template limits(Kind kind) {
    LimitSet set;
    set.kind = kind;
    set.limits[kind == Kind::circular ? "G(b)" : "A"] = {
        0.02, kind == Kind::circular ? "ISO 230-4:2005" : "ISO 230-2:2014", "contract"};
    set.decisionRule.rule = Rule::iso14253_1;
    return {"contract 12", set};
}

Template limitsOfARotaryAxis() {
    Template result = limits(Kind::positioning);
    std::get<LimitSet>(result.content).motion = Motion::rotary;
    return result;
}

Template declarations() {
    Declarations declared;
    declared.conditions.complete = true;
    declared.conditions.unloaded = false;
    declared.conditions.stabilised = true;
    declared.conditions.soak = "12 h";
    declared.conditions.warmUp = {WarmUpKind::procedure, "60 min", SpecifiedBy::maker};
    declared.conditions.instrumentCompensation = InstrumentCompensation::on;
    return {"hall 2", declared};
}

} // namespace

Q_DECLARE_METATYPE(Template)

/// Templates as files.
class TemplateFileTest : public QObject {
    Q_OBJECT

private slots:
    void comesBackAsItWas_data() {
        QTest::addColumn<Template>("content");
        QTest::newRow("a machine") << machine();
        QTest::newRow("an instrument") << instrument();
        QTest::newRow("a laboratory with its logo") << laboratory();
        QTest::newRow("limits of positioning") << limits(Kind::positioning);
        QTest::newRow("limits of circles") << limits(Kind::circular);
        QTest::newRow("limits of a rotary axis") << limitsOfARotaryAxis();
        QTest::newRow("declarations") << declarations();
        QTest::newRow("no declaration") << Template{"", Declarations()};
    }
    void comesBackAsItWas() {
        QFETCH(Template, content);
        const QByteArray bytes = writeTemplate(content);
        QVERIFY(readTemplate(bytes) == content);
        QCOMPARE(writeTemplate(readTemplate(bytes)), bytes);
    }

    void refusesWhatTheFormatDoesNotAllow_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("place");
        const auto file = [](const char *rest) {
            return QByteArray(R"({"format": "palmer template", "version": 1, )") + rest + "}";
        };
        QTest::newRow("a test file") << QByteArray(R"({"format": "palmer test report", "version": 1})")
                                     << QByteArray();
        QTest::newRow("no JSON") << QByteArray("machine") << QByteArray("1:1");
        QTest::newRow("nothing") << file(R"("name": "x")") << QByteArray();
        QTest::newRow("two at once") << file(R"("machine": {}, "laboratory": {})") << QByteArray();
        QTest::newRow("an unknown key") << file(R"("machine": {}, "colour": 1)") << QByteArray("colour");
        QTest::newRow("an unknown key inside")
            << file(R"("machine": {"colour": 1})") << QByteArray("machine.colour");
        QTest::newRow("a wrong type")
            << file(R"("instrument": {"resolution": "fine"})") << QByteArray("instrument.resolution");
        QTest::newRow("a day that is none") << file(R"("instrument": {"calibrationDate": "2026-02-31"})")
                                            << QByteArray("instrument.calibrationDate");
        QTest::newRow("a picture that is no base64")
            << file(R"("laboratory": {"logo": "?"})") << QByteArray("laboratory.logo");
        QTest::newRow("an unknown parameter")
            << file(R"("kind": "positioning", "limits": {"none": {"value": 1}})")
            << QByteArray("limits.none");
        QTest::newRow("a parameter of the other kind")
            << file(R"("kind": "positioning", "limits": {"G": {"value": 1}})") << QByteArray("limits.G");
        QTest::newRow("a condition that was measured")
            << file(R"("conditions": {"dwell": 3})") << QByteArray("conditions.dwell");
        QTest::newRow("a condition of a wrong type")
            << file(R"("conditions": {"complete": 1})") << QByteArray("conditions.complete");
        QTest::newRow("conditions that are none") << file(R"("conditions": [1])") << QByteArray("conditions");
        QTest::newRow("a motion that is none")
            << file(R"("kind": "positioning", "motion": "round", "limits": {})") << QByteArray("motion");
        QTest::newRow("a motion of circles")
            << file(R"("kind": "circular", "motion": "rotary", "limits": {})") << QByteArray("motion");
        QTest::newRow("limits of no kind") << file(R"("limits": {})") << QByteArray("kind");
        QTest::newRow("a rule that is none")
            << file(R"("kind": "circular", "limits": {}, "decisionRule": {"rule": "mine"})")
            << QByteArray("decisionRule.rule");
        QTest::newRow("a name that is none") << file(R"("name": 7, "machine": {})") << QByteArray("name");
        QTest::newRow("a newer version")
            << QByteArray(R"({"format": "palmer template", "version": 99, "machine": {}})")
            << QByteArray("version");
    }
    void refusesWhatTheFormatDoesNotAllow() {
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, place);
        try {
            static_cast<void>(readTemplate(file));
            QFAIL("it was read");
        } catch (const Error &error) {
            QCOMPARE(QByteArray::fromStdString(error.place), place);
            QVERIFY(!error.message.text.empty());
        }
    }

    void truncatedFilesAreRefused() {
        const QByteArray bytes = writeTemplate(limits(Kind::circular)).trimmed();
        for (qsizetype length = 0; length < bytes.size(); ++length)
            QVERIFY_EXCEPTION_THROWN(static_cast<void>(readTemplate(bytes.first(length))), Error);
    }

    /// What the template states goes over what stood there; all else stays.
    void declarationsLeaveTheRest() {
        Test test;
        PositioningMeasurement measurement;
        measurement.conditions.dwell = 3;
        Conditions &conditions = measurement.conditions.common;
        conditions.otherAxes = "Y 0";
        conditions.shielded = false;
        conditions.unloaded = true;
        test.measurement = measurement;
        QVERIFY(applyDeclarations(test, std::get<Declarations>(declarations().content)));
        PositioningMeasurement expected = measurement;
        const Conditions stated = std::get<Declarations>(declarations().content).conditions;
        expected.conditions.common = stated;
        expected.conditions.common.otherAxes = "Y 0";
        expected.conditions.common.shielded = false;
        QVERIFY(std::get<PositioningMeasurement>(test.measurement) == expected);
        QVERIFY(declarationsOf(test).conditions.otherAxes.empty()); // where axes stood is of one test
        test.measurement = DriftMeasurement();
        QVERIFY(!applyDeclarations(test, Declarations()));
    }

    void aSetOfLimitsNamesItsEdition() {
        Test test;
        test.edition = "ISO 230-2:2006";
        test.measurement = PositioningMeasurement();
        test.limits["A"].value = 0.02;
        test.limits["R"] = {0.01, "ISO 230-2:1988", ""};
        const LimitSet set = limitSetOf(test);
        QCOMPARE(set.limits.at("A").edition, std::optional<std::string>("ISO 230-2:2006"));
        QCOMPARE(set.limits.at("R").edition, std::optional<std::string>("ISO 230-2:1988"));
        Test other;
        other.edition = "ISO 230-2:2014";
        other.measurement = PositioningMeasurement();
        QVERIFY(applyLimitSet(other, set));
        QCOMPARE(other.limits, set.limits);
        Test circle;
        circle.measurement = CircularMeasurement();
        QVERIFY(!applyLimitSet(circle, set));
        QVERIFY(circle.limits.empty());
        Test rotary = other; // its numbers are angles
        std::get<PositioningMeasurement>(rotary.measurement).axis.motion = Motion::rotary;
        rotary.limits.clear();
        QVERIFY(!applyLimitSet(rotary, set) && rotary.limits.empty());
        QVERIFY(applyLimitSet(rotary, limitSetOf(rotary)) && !applyLimitSet(other, limitSetOf(rotary)));
    }
};

QTEST_APPLESS_MAIN(TemplateFileTest)
#include "templatefile.moc"
