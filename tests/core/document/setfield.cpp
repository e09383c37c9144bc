// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/setfield.h"

#include "document/documenterror.h"
#include "document/fieldpath.h"
#include "document/fields.h"
#include "document/writedocument.h"

#include <QTest>
#include <set>

using namespace palmer;

namespace {

Document ofEachKind() {
    Document document;
    const auto add = [&](auto measurement, const char *edition) {
        Test test;
        test.id = "t" + std::to_string(document.tests.size());
        test.edition = edition;
        test.measurement = std::move(measurement);
        document.tests.push_back(std::make_shared<const Test>(std::move(test)));
    };
    PositioningMeasurement axis;
    axis.axis.name = "X";
    axis.targets = {0, 100};
    add(axis, "ISO 230-2:2014");
    CircularMeasurement circle;
    circle.plane = {"X", "Y"};
    circle.nominalRadius = 100;
    add(circle, "ISO 230-4:2005");
    return document;
}

/// Collects the keys of numbers that have no unit in the file.
class NumbersWithoutUnit {
public:
    template <class T>
    void operator()(const char *key, const T &member, unsigned demands = nothing) {
        const unsigned before = m_inherited;
        m_inherited = demandsIn(m_inherited, demands);
        visit(key, member);
        m_inherited = before;
    }
    void object(const char * /*key*/, const auto &members) { members(*this); }
    void extensions(const char * /*key*/, const std::string & /*text*/) {}

    [[nodiscard]] const std::set<std::string> &keys() const { return m_keys; }

private:
    template <class T>
    void visit(const char *key, const T &member) {
        if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Point3>) {
            if (fileUnitOf(m_inherited) == FileUnit::none)
                m_keys.insert(key);
        } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string> &&
                             !std::is_same_v<T, Permitted>) {
            fields(*this, member);
        }
    }
    template <class T>
    void visit(const char *key, const std::optional<T> & /*member*/) {
        visit(key, T());
    }
    template <class T>
    void visit(const char *key, const std::vector<T> &members) {
        if constexpr (std::is_same_v<T, TestPointer>) {
            for (const TestPointer &test : members)
                fields(*this, *test);
        } else {
            visit(key, T());
        }
    }
    template <class T>
    void visit(const char *key, const std::map<std::string, T> & /*members*/) {
        visit(key, T());
    }

    unsigned m_inherited = nothing;
    std::set<std::string> m_keys;
};

} // namespace

/// Fields by their paths.
class SetFieldTest : public QObject {
    Q_OBJECT

private slots:
    void keysOfEveryKindAreKnown() {
        for (const char *path : {"machine.name", "tests[0].title", "report", "limits.A.value", "targets[0]",
                                 "nominalRadius", "plane", "axis.name", "role", "instruments[1].id", "times"})
            QVERIFY2(beginsAsField(path), path);
        for (const char *path : {"", "A", "machin", "machines.name", "[0]", ".name", "delimiter"})
            QVERIFY2(!beginsAsField(path), path);
    }

    void aPathOfTheFileIsThatOfOne() {
        const Document changed = withField(ofEachKind(), "machine.serialNumber", "0815");
        QCOMPARE(changed.machine.serialNumber, std::string("0815")); // no number
        QCOMPARE(changed.tests.size(), std::size_t(2));
        const Document second = withField(ofEachKind(), "tests[1].title", "b");
        QCOMPARE(second.tests[0]->title, std::string());
        QCOMPARE(second.tests[1]->title, std::string("b"));
    }

    void anyOtherIsThatOfEveryTest() {
        const Document changed = withField(ofEachKind(), "date", "2026-01-02");
        for (const TestPointer &test : changed.tests)
            QCOMPARE(test->date, std::optional<std::string>("2026-01-02"));
    }

    void aLimitSaysItsUnit_data() {
        QTest::addColumn<bool>("rotary");
        QTest::addColumn<double>("limit"); // mm, degrees
        const auto row = [](const char *value, bool rotary, double limit) {
            QTest::newRow(value) << rotary << limit;
        };
        row("20 um", false, 0.02);
        row("20um", false, 0.02);
        row("20 µm", false, 0.02);
        row("20 μm", false, 0.02); // the Greek letter
        row("2,1 um", false, 0.0021);
        row("0.02 mm", false, 0.02);
        row("0,02mm", false, 0.02);
        row("2e-2 mm", false, 0.02);
        row("0", false, 0);
        row("5 arcsec", true, 5.0 / 3600);
        row("5″", true, 5.0 / 3600);
        row("0.001 deg", true, 0.001);
    }
    void aLimitSaysItsUnit() {
        QFETCH(const bool, rotary);
        QFETCH(const double, limit);
        const Document document =
            rotary ? withField(ofEachKind(), "tests[0].axis.motion", "rotary") : ofEachKind();
        const Document changed = withField(document, "tests[0].limits.A.value", QTest::currentDataTag());
        QCOMPARE(changed.tests[0]->limits.at("A").value.value(), limit);
    }

    void aBareLengthIsAskedForItsUnit_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<bool>("rotary");
        QTest::addColumn<QStringList>("words");
        const auto row = [](const char *path, const char *value, bool rotary, const QStringList &words) {
            QTest::addRow("%s=%s", path, value) << QString(value) << rotary << words;
        };
        row("tests[0].limits.A.value", "20", false, {"20", "20um", "20mm"});
        row("tests[0].limits.A.value", "0,02", false, {"0,02", "0,02um", "0,02mm"});
        row("tests[0].limits.A.value", "5", true, {"5", "5arcsec", "5deg"});
        row("tests[0].limits.A.value", "5 um", true, {"5 um", "5arcsec", "5deg"});
        row("tests[0].limits.A.value", "5 parsec", false, {"5 parsec", "5um", "5mm"});
        row("tests[1].limits.G.value", "8", false, {"8", "8um", "8mm"});
        row("instruments[0].resolution", "1", false, {"1", "1um", "1mm"});
        row("tests[0].excluded[0].value", "3", false, {"3", "3um", "3mm"});
        row("tests[0].limits", R"({"A": {"value": 20}})", false, {"20", "20um", "20mm"});
        row("tests[0].limits.A", R"({"value": "5 um"})", true, {"5 um", "5arcsec", "5deg"});
        row("limits", R"({"A": {"value": 0.015}})", false, {"0.015", "0.015um", "0.015mm"});
        row("instruments", R"([{"id": "laser", "resolution": 0.1}])", false, {"0.1", "0.1um", "0.1mm"});
        row("tests[0].runs[0].deviations", "[0.5, 0]", false, {"0.5", "0.5um", "0.5mm"});
    }
    void aBareLengthIsAskedForItsUnit() {
        QFETCH(const QString, value);
        QFETCH(const bool, rotary);
        QFETCH(const QStringList, words);
        const std::string path = QString(QTest::currentDataTag()).section('=', 0, 0).toStdString();
        const Document document =
            rotary ? withField(ofEachKind(), "tests[0].axis.motion", "rotary") : ofEachKind();
        try {
            (void)withField(document, path, value.toStdString());
            QFAIL("taken");
        } catch (const Error &error) {
            QStringList said;
            for (const auto &word : error.message.arguments)
                said << QString::fromStdString(std::get<std::string>(word));
            QCOMPARE(said, words);
        }
    }

    void anyNumberMayHaveItsUnit_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("bare"); // the same in the unit of the file
        const auto row = [](const char *path, const char *value, const char *bare) {
            QTest::addRow("%s=%s", path, value) << QString(value) << QString(bare);
        };
        row("tests[0].axis.travel", "500 mm", "500");
        row("tests[0].axis.travel", "0,5 m", "500");
        row("tests[0].axis.travel", "500\u00A0mm", "500");
        row("tests[0].axis.travel", "20in", "508");
        row("tests[0].targets[1]", "12 cm", "120");
        row("tests[0].conditions.feed", "2000 mm/min", "2000");
        row("tests[0].conditions.feed", "2 m/min", "2000");
        row("tests[0].conditions.dwell", "3 s", "3");
        row("tests[0].conditions.dwell", "500 ms", "0.5");
        row("tests[0].conditions.sensors[0].start", "22.5 °C", "22.5");
        row("tests[0].conditions.sensors[0].start", "22,5 C", "22.5");
        row("tests[0].conditions.sensors[0].start", "295.65 K", "22.5");
        row("tests[0].uncertainty.temperatureRange.machine", "2 K", "2"); // a difference
        row("tests[0].conditions.airPressure", "101.3 kPa", "1013");
        row("tests[0].conditions.airPressure", "1013 mbar", "1013");
        row("tests[0].conditions.airHumidity", "45 %", "45");
        row("tests[0].conditions.gradientPerHour", "0.5 K/h", "0.5");
        row("tests[0].conditions.gradientHoursBefore", "12 h", "12");
        row("tests[0].conditions.toolOffset[2]", "15 cm", "150");
        row("tests[0].conditions.expansion.machine", "11.5 µm/(m·°C)", "11.5");
        row("tests[0].conditions.expansion.machine", "11.5 ppm/K", "11.5");
        row("tests[0].duration", "2 h", "120");
        row("tests[0].uncertainty.environmentalVariation", "3 um", "3");
        row("tests[0].uncertainty.environmentalVariation", "0.003 mm", "3");
        row("tests[0].uncertainty.device.perMetre", "1.5 µm/m", "1.5");
        row("tests[0].uncertainty.misalignmentRange", "500 um", "0.5");
        row("tests[0].uncertainty.temperatureRange.machine", "1 °C", "1");
        row("tests[0].uncertainty.expanded.A", "2 µm", "2");
        row("tests[1].nominalRadius", "0.15 m", "150");
        row("tests[1].uncertainty.displacement.expanded", "700 nm", "0.7");
        row("axis.travel", "600 mm", "600");
        row("tests[0].conditions.toolOffset", R"(["1 cm", 2, null])", "[10, 2, null]");
        row("tests[0].limits", R"({"A": {"value": "7,5 um"}, "R": {"value": 0}})",
            R"({"A": {"value": "0.0075 mm"}, "R": {"value": "0 um"}})");
    }
    void anyNumberMayHaveItsUnit() {
        QFETCH(const QString, value);
        QFETCH(const QString, bare);
        const std::string path = QString(QTest::currentDataTag()).section('=', 0, 0).toStdString();
        Document document = ofEachKind();
        if (path.starts_with("axis."))
            document.tests.pop_back();
        QCOMPARE(writeDocument(withField(document, path, value.toStdString())),
                 writeDocument(withField(document, path, bare.toStdString())));
    }

    void everyNumberSaysItsUnit() {
        Document document = ofEachKind();
        Test drift;
        drift.measurement = DriftMeasurement();
        document.tests.push_back(std::make_shared<const Test>(std::move(drift)));
        NumbersWithoutUnit numbers;
        fields(numbers, document);
        // Factors, and what has its unit beside it: rows of the sheet, imported results, agreed points.
        std::string keys;
        for (const std::string &key : numbers.keys())
            keys += key + ' ';
        QCOMPARE(QString::fromStdString(keys),
                 QString("coverageFactor guardFactor measured uncertainty value "));
    }

    void anAngleOfARotaryAxisHasItsUnit() {
        const Document document = withField(ofEachKind(), "tests[0].axis.motion", "rotary");
        const auto measured = [&](const char *path, const char *value) {
            return std::get<PositioningMeasurement>(withField(document, path, value).tests[0]->measurement);
        };
        QCOMPARE(measured("tests[0].axis.travel", "180 °").axis.travel.value(), 180.0);
        QCOMPARE(measured("tests[0].conditions.feed", "2 rpm").conditions.feed.value(), 720.0);
        QCOMPARE(measured("tests[0].uncertainty.environmentalVariation", "2″")
                     .uncertainty.environmentalVariation.value(),
                 2.0);
        QCOMPARE(
            measured("tests[0].conditions.toolOffset[0]", "2 mm").conditions.common.toolOffset[0].value(),
            2.0);
    }

    void aUnitThatDoesNotFitIsRefused_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char *path, const char *value, const char *expected) {
            QTest::addRow("%s=%s", path, value) << QString(value) << QString(expected);
        };
        row("tests[0].axis.travel", "500 s", "mm");
        row("tests[0].axis.travel", "500 parsec", "mm");
        row("tests[0].axis.travel", "180 deg", "mm");
        row("tests[0].conditions.feed", "2000 mm", "mm/min");
        row("tests[0].conditions.dwell", "3 mm", "s");
        row("tests[0].conditions.sensors[0].start", "300 Pa", "°C");
        row("tests[0].conditions.expansion.machine", "11.5 um", "µm/(m·°C)");
        row("tests[0].conditions.airPressure", "1 atm", "hPa");
        row("tests[0].conditions.airHumidity", "45 mm", "%");
        row("tests[0].uncertainty.environmentalVariation", "3 arcsec", "um");
        row("tests[0].uncertainty.device.perMetre", "1.5 mm", "um/m");
        row("tests[0].duration", "2 mm", "min");
        row("tests[0].conditions.sensors", R"([{"start": "20 mm"}])", "°C");
    }
    void aUnitThatDoesNotFitIsRefused() {
        QFETCH(const QString, value);
        QFETCH(const QString, expected);
        const std::string path = QString(QTest::currentDataTag()).section('=', 0, 0).toStdString();
        try {
            (void)withField(ofEachKind(), path, value.toStdString());
            QFAIL("taken");
        } catch (const Error &error) {
            QCOMPARE(error.message.text.source, "the unit of “%1” does not fit here; expected %2");
            const QString typed = value.startsWith('[') ? "20 mm" : value;
            QCOMPARE(error.message.arguments,
                     (std::vector<Argument>{typed.toStdString(), expected.toStdString()}));
        }
    }

    /// "1,000" may be a thousand or one; "0,125" is clear.
    void aCommaBeforeThousandsIsRefused_data() {
        QTest::addColumn<QString>("value");
        for (const auto &[path, value] :
             {std::pair("tests[0].limits.A.value", "1,000um"), std::pair("tests[0].axis.travel", "1,500"),
              std::pair("tests[0].uncertainty.trials", "100,000"), std::pair("tests[1].feed", "-1,000,000"),
              std::pair("tests[0].limits", R"({"A": {"value": "2,000 um"}})")})
            QTest::addRow("%s=%s", path, value) << QString(value);
    }
    void aCommaBeforeThousandsIsRefused() {
        QFETCH(const QString, value);
        const std::string path = QString(QTest::currentDataTag()).section('=', 0, 0).toStdString();
        try {
            (void)withField(ofEachKind(), path, value.toStdString());
            QFAIL("taken");
        } catch (const Error &error) {
            QVERIFY(QByteArray(error.message.text.source).contains("before thousands or before decimals"));
        }
    }
    void otherCommasAreClear() {
        for (const char *number :
             {"0,125", "1,5", "1,0000", "1000,5", ",500", "1,000.5", "1,00a", "01,000", "1,"})
            QVERIFY2(!mayBeGrouped(number), number);
        QCOMPARE(withField(ofEachKind(), "tests[0].title", "1,000").tests[0]->title, std::string("1,000"));
    }

    /// A field without its test is set where it fits: of the kind, in a unit of the motion.
    void aFieldOfEveryTestIsSetWhereItFits() {
        Document document = ofEachKind();
        Test rotary = *document.tests[0];
        rotary.id = "rotary";
        std::get<PositioningMeasurement>(rotary.measurement).axis.motion = Motion::rotary;
        document.tests.push_back(std::make_shared<const Test>(std::move(rotary)));
        Test drift;
        drift.id = "drift";
        drift.measurement = DriftMeasurement();
        document.tests.push_back(std::make_shared<const Test>(std::move(drift)));
        document = withField(document, "limits.A.value", "15 um");
        document = withField(document, "limits.G.value", "9 um");
        QCOMPARE(document.tests[0]->limits.at("A").value.value(), 0.015);
        QVERIFY(document.tests[2]->limits.empty() && document.tests[3]->limits.empty());
        QCOMPARE(document.tests[1]->limits.size(), std::size_t(1));
        document = withField(document, "limits", R"({"A": {"value": "2 arcsec"}})");
        QCOMPARE(document.tests[0]->limits.at("A").value.value(), 0.015);
        QCOMPARE(document.tests[2]->limits.at("A").value.value(), 2.0 / 3600);
        document.tests = {document.tests[3]};
        QVERIFY_THROWS_EXCEPTION(Error, (void)withField(document, "limits.A.value", "15 um"));
    }

    void aTextWithAUnitStaysAText() {
        const Document changed = withField(ofEachKind(), "tests[0].conditions.soak", "12 h");
        QCOMPARE(std::get<PositioningMeasurement>(changed.tests[0]->measurement).conditions.common.soak,
                 std::string("12 h"));
    }

    void otherNumbersNeedNoUnit() {
        const Document changed = withField(ofEachKind(), "tests[1].nominalRadius", "150,5");
        QCOMPARE(std::get<CircularMeasurement>(changed.tests[1]->measurement).nominalRadius, 150.5);
        const Document given = withField(ofEachKind(), "tests[0].limits.A.value", "20um");
        QVERIFY(!withField(given, "tests[0].limits.A.value", "null").tests[0]->limits.at("A").value);
    }

    void anImpossibleValueIsRefused_data() {
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char *path, const char *value, const char *expected) {
            QTest::addRow("%s=%s", path, value) << QString(value) << QString(expected);
        };
        row("tests[0].conditions.airHumidity", "101", "expected a percentage from 0 to 100");
        row("tests[0].conditions.airHumidity", "-1", "expected a percentage from 0 to 100");
        row("tests[0].conditions.airPressure", "-1013", "expected a number greater than 0");
        row("tests[0].conditions.dwell", "-3", "expected a number that is not negative");
        row("tests[0].conditions.feed", "0", "expected a number greater than 0");
        row("tests[0].conditions.approachDistance", "-1", "expected a number that is not negative");
        row("tests[0].uncertainty.device.fixed", "-1", "expected a number that is not negative");
        row("tests[0].conditions.expansion.machine", "11.5e-6",
            "expected 0 or a coefficient in µm/(m·°C), such as 11.5 for steel");
        row("tests[0].uncertainty.temperatureRange.machine", "-1", "expected a number that is not negative");
        row("tests[1].uncertainty.displacement.expanded", "-0,5", "expected a number that is not negative");
        row("tests[1].feed", "-1000", "expected a number greater than 0");
        row("tests[0].conditions.sensors[0].series", R"({"times": [0, 2, 1], "temperatures": [20, 20, 20]})",
            "expected times that ascend");
    }
    void anImpossibleValueIsRefused() {
        QFETCH(const QString, value);
        QFETCH(const QString, expected);
        const std::string path = QString(QTest::currentDataTag()).section('=', 0, 0).toStdString();
        try {
            (void)withField(ofEachKind(), path, value.toStdString());
            QFAIL("taken");
        } catch (const Error &error) {
            QCOMPARE(error.message.text.source, expected);
            QVERIFY2(QString::fromStdString(error.place).startsWith(QString::fromStdString(path)),
                     error.place.c_str());
        }
    }

    void anImpossibleValueOfTheFileStays() {
        Document document = ofEachKind();
        Test test = *document.tests[0];
        std::get<PositioningMeasurement>(test.measurement).conditions.airHumidity = 130;
        document.tests[0] = std::make_shared<const Test>(test);
        QCOMPARE(withField(document, "tests[0].title", "b").tests[0]->title, std::string("b"));
    }

    void anElementBehindTheLastIsAdded() {
        const Document changed = withField(ofEachKind(), "instruments[0].id", "laser");
        QCOMPARE(changed.instruments.size(), std::size_t(1));
        QCOMPARE(changed.instruments[0].id, std::string("laser"));
        QVERIFY(throws("instruments[2].id", "laser"));
    }

    void whatTheFileDoesNotKnowIsRefused() {
        QVERIFY(throws("machine.year", "old"));
        QVERIFY(throws("tests[0].uncertainty.expanded.A", "-1"));
        QVERIFY(throws("tests[0].conditions.sensors[0].start", "-300"));
        QVERIFY(throws("tests[0].conditions.expansion.machine", "-100,5"));
        QVERIFY(throws("tests[0].nominalRadius", "100")); // of a circle alone
        QVERIFY(throws("machine.name.first", "a"));
        QVERIFY(throws("report.paper", "A5"));
        QVERIFY(throws("tests[2]", R"({"kind": "drift", "id": "d", "times": [0], "deviations": [1]})"));
    }

    void aNumberForAWordIsRefusedAsAWord() {
        try {
            (void)withField(ofEachKind(), "tests[0].edition", "2014");
            QFAIL("taken");
        } catch (const Error &error) {
            QVERIFY2(QByteArray(error.what()).contains("unknown edition"), error.what());
        }
    }

    void aChannelOfADriftTestHasItsOwnUnit() {
        DriftMeasurement drift;
        drift.times = {0};
        drift.channels = {{"X", ChannelQuantity::deviation, {0.001}},
                          {"C", ChannelQuantity::angularDeviation, {0.001}}};
        Test test;
        test.id = "d";
        test.measurement = drift;
        Document document;
        document.tests.push_back(std::make_shared<const Test>(std::move(test)));
        document = withField(document, "tests[0].channels[0].values[0]", "5um");
        document = withField(document, "channels[1].values[0]", "3600arcsec");
        const auto &set = std::get<DriftMeasurement>(document.tests[0]->measurement);
        QCOMPARE(set.channels[0].values[0], std::optional(0.005));
        QCOMPARE(set.channels[1].values[0], std::optional(1.0));
        QVERIFY_THROWS_EXCEPTION(Error, (void)withField(document, "channels[0].values[0]", "5"));
    }

private:
    static bool throws(const char *path, const char *value) {
        try {
            (void)withField(ofEachKind(), path, value);
        } catch (const Error &) {
            return true;
        }
        return false;
    }
};

QTEST_GUILESS_MAIN(SetFieldTest)
#include "setfield.moc"
