// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/blocks/plaintext.h"
#include "validation/validationreport.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QRegularExpression>
#include <QTest>

#include <map>
#include <set>

using namespace palmer;

namespace {

QByteArray bytesOf(const QString &name) {
    QFile file(":/reference/" + name + ".json");
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no reference data %s", qPrintable(name));
    return file.readAll();
}

ReferenceSet embedded(const QString &name) {
    return readReferenceSet(bytesOf(name));
}

QByteArray setWith(const QByteArray &expected, const char *more = "") {
    return QByteArray(R"({"format": "palmer reference data", "name": "Theirs", )") + more +
           R"("test": {"kind": "positioning", "edition": "ISO 230-2:2006", "targets": [0, 10],
               "runs": [{"approach": "positive", "deviations": [0.001, 0.003]}]}, "expected": [)" +
           expected + "]}";
}

/// The set without what is simulated, which takes long.
ReferenceSet withoutSimulations(ReferenceSet set) {
    std::erase_if(set.expected, [](const Expectation &one) { return one.variant == "simulated"; });
    return set;
}

} // namespace

class ValidationTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithAllReferenceData_data();
    void agreesWithAllReferenceData();
    void hasTheSetsOfTheSecondImplementation();
    void seesADifference();
    void findsOneWrongDigit_data();
    void findsOneWrongDigit();
    void takesDataOfOthers();
    void refusesOtherFiles_data();
    void refusesOtherFiles();
    void theQuickSetsAreQuick();
    void theReportSumsUp();
    void theDocumentNamesTheBuild();
};

void ValidationTest::agreesWithAllReferenceData_data() {
    QTest::addColumn<int>("values");
    QTest::newRow("iso230-2-1988-table2") << 73;
    QTest::newRow("constructed") << 52;
    for (const char *name : {"mavro", "michelso", "numacc1", "numacc2", "numacc3", "numacc4"})
        QTest::newRow(qPrintable(QString("nist-strd-") + name)) << 2;
    QTest::newRow("ballbar-pair") << 8;
    QTest::newRow("circular-correction") << 3;
    QTest::newRow("iso230-4-annex-c") << 2;
    QTest::newRow("nist-circles") << 30 * 9 - 5; // one has three points, and no minimum zone
    QTest::newRow("constructed-circles") << 4 * 9;
    QTest::newRow("second/linear-axes") << 3287;
    QTest::newRow("second/rotary-axes") << 519;
    QTest::newRow("second/circles") << 781 - 224;
    QTest::newRow("second/trends") << 90;
    QTest::newRow("second/diagnoses") << 27;
    QTest::newRow("second/drift-tests") << 117;
    QTest::newRow("second/compensation") << 78;
    QTest::newRow("second/comparisons") << 147;
    QTest::newRow("second/sheet") << 72;
    QTest::newRow("second/responses") << 12;
    QTest::newRow("second/types") << 36;
}

void ValidationTest::agreesWithAllReferenceData() {
    QFETCH(int, values);
    const QString name = QTest::currentDataTag();
    ReferenceSet set = embedded(name);
    if (name == "second/circles") // takes as long as all others; `selftest` and the window simulate them
        set = withoutSimulations(std::move(set));
    const SetValidation result = validate(set);
    QCOMPARE(int(result.comparisons.size()), values);
    for (const Comparison &comparison : result.comparisons)
        QVERIFY2(comparison.agrees, qPrintable(QString("%1: %2 %3, not %4")
                                                   .arg(comparison.place)
                                                   .arg(comparison.computed.value_or(0), 0, 'g', 15)
                                                   .arg(QString::fromStdString(comparison.word))
                                                   .arg(comparison.expectation.value, 0, 'g', 15)));
}

void ValidationTest::hasTheSetsOfTheSecondImplementation() {
    std::map<QString, std::size_t> tests;
    std::size_t values = 0;
    std::set<std::string> editions;
    std::set<std::string> of;
    QCOMPARE(allReferenceFiles().size(), quickReferenceFiles().size() + 11);
    for (const QString &name : allReferenceFiles().mid(quickReferenceFiles().size())) {
        const ReferenceSet set = embedded(QString(name).remove(":/reference/").remove(".json"));
        values += set.expected.size();
        tests[name.section('/', -1)] = set.documents.at("")->tests.size() + set.trends.size();
        for (const TestPointer &test : set.documents.at("")->tests)
            editions.insert(test->edition);
        for (const Expectation &expected : set.expected)
            of.insert(expected.of + ' ' + expected.variant);
    }
    QVERIFY2(values >= 2000, qPrintable(QString::number(values)));
    QCOMPARE(tests["linear-axes.json"] + tests["rotary-axes.json"], std::size_t(30));
    QCOMPARE(tests["circles.json"], std::size_t(25));
    QCOMPARE(tests["trends.json"], std::size_t(10));
    QCOMPARE(tests["diagnoses.json"], std::size_t(10));
    QCOMPARE(tests["drift-tests.json"], std::size_t(2 * 8)); // each with an axis or a circle that uses it
    QCOMPARE(tests["compensation.json"], std::size_t(5));
    QCOMPARE(tests["responses.json"], std::size_t(4));
    QCOMPARE(tests["comparisons.json"], std::size_t(2 * 4));
    for (const char *edition : {"ISO 230-2:1988", "ISO 230-2:1997", "ISO 230-2:2006", "ISO 230-2:2014",
                                "VDI/DGQ 3441:1977", "ISO 230-4:1996", "ISO 230-4:2005", "ISO 230-4:2022"})
        QVERIFY2(editions.contains(edition), edition);
    for (const char *kind :
         {"budget ", "budgetActual ", "expandedUncertainty simulated", "low simulated", "high simulated",
          "verdict ", "verdict proven", "verdict rejection", "verdict actual", "verdict direct"})
        QVERIFY2(of.contains(kind), kind);
}

void ValidationTest::seesADifference() {
    ReferenceSet set = embedded("constructed");
    set.expected.resize(1);
    set.expected[0].value += 2 * set.expected[0].tolerance;
    QVERIFY(!validate(set).agrees());
    set.expected[0].edition = "ISO 230-2:2099";
    QVERIFY(!validate(set).agrees());
    for (const char *name : {"ballbar-pair", "circular-correction", "iso230-4-annex-c", "nist-circles",
                             "second/trends", "second/diagnoses", "second/drift-tests", "second/compensation",
                             "second/responses", "second/types"}) {
        ReferenceSet changed = embedded(name);
        Expectation &last = changed.expected.back();
        last.value += (last.relative ? last.value : 1) * 2.5 * last.tolerance;
        QVERIFY2(!validate(changed).agrees(), name);
        changed = embedded(name);
        changed.expected.back().test = 99;
        QVERIFY2(!validate(changed).agrees() || name == QByteArray("iso230-4-annex-c"), name);
        changed = embedded(name);
        changed.expected.back().id = "nothing";
        QVERIFY2(!validate(changed).agrees() || name == QByteArray("iso230-4-annex-c") ||
                     name == QByteArray("circular-correction") || name == QByteArray("second/compensation"),
                 name);
    }
    ReferenceSet words = withoutSimulations(embedded("second/linear-axes"));
    std::erase_if(words.expected, [](const Expectation &one) { return one.word.empty(); });
    QVERIFY(words.expected.size() > 1000 && validate(words).agrees());
    words.expected[7].word = words.expected[7].word == "conforms" ? "notProven" : "conforms";
    QVERIFY(!validate(words).agrees());
}

void ValidationTest::findsOneWrongDigit_data() {
    QTest::addColumn<QString>("pattern"); // of what is printed with a digit too many wrong
    const QString value(R"re("value": (-?[0-9.]+), "tolerance")re");
    const QString readings(R"("deviations": \[([^\]]+)\])");
    for (const char *name : {"second/linear-axes", "second/rotary-axes", "second/circles", "second/trends",
                             "second/drift-tests", "second/compensation", "constructed"})
        QTest::addRow("%s", name) << value;
    QTest::newRow("second/linear-axes, a reading") << readings;
    QTest::newRow("second/rotary-axes, a reading") << readings;
    QTest::newRow("second/compensation, a reading") << readings;
    QTest::newRow("constructed, a reading") << readings;
}

void ValidationTest::findsOneWrongDigit() {
    QFETCH(QString, pattern);
    const QString name = QString(QTest::currentDataTag()).section(',', 0, 0);
    const QString text = QString::fromUtf8(bytesOf(name));
    struct Place {
        qsizetype from;
        qsizetype to;
    };
    std::vector<Place> numbers;
    for (auto match = QRegularExpression(pattern).globalMatch(text); match.hasNext();) {
        const auto found = match.next();
        const qsizetype begin = text.lastIndexOf('\n', found.capturedStart());
        if (!QStringView(text).mid(begin, found.capturedStart() - begin).contains(u"simulated"))
            numbers.push_back({found.capturedStart(1), found.capturedEnd(1)});
    }
    QVERIFY(numbers.size() >= 10);
    QRandomGenerator dice(51);
    for (int round = 0; round < 5; ++round) {
        QString changed = text;
        qsizetype at = 0;
        const Place place = numbers[dice.bounded(quint32(numbers.size()))];
        do
            at = dice.bounded(int(place.from), int(place.to));
        while (!changed[at].isDigit());
        // Rounding hides one unit of the last digit: five are not hidden.
        changed[at] = QChar('0' + (changed[at].digitValue() + 5) % 10);
        bool found = false;
        try {
            found = !validate(withoutSimulations(readReferenceSet(changed.toUtf8()))).agrees();
        } catch (const Error &) {
            found = true; // the number is none any more
        }
        QVERIFY2(found, qPrintable(changed.mid(at - 120, 160)));
    }
}

void ValidationTest::takesDataOfOthers() {
    const QByteArray expected = R"({"parameter": "E+", "value": 0.002, "tolerance": 1e-12, "source": "exact"},
        {"parameter": "E+", "variant": "turned", "value": 0.002, "tolerance": 1e-12, "source": "exact"})";
    const ReferenceSet set =
        readReferenceSet(setWith(expected, R"("variants": {"turned": {"title": "another"}}, )"));
    QCOMPARE(set.documents.at("turned")->tests.front()->title, std::string("another"));
    const SetValidation result = validate(set);
    QVERIFY(result.agrees());
    QCOMPARE(result.name.at("fr"), QString("Theirs"));
    QCOMPARE(result.comparisons[1].place, QString("test 1 E+ turned"));
}

void ValidationTest::refusesOtherFiles_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("place");
    QTest::newRow("another format") << QByteArray("{}") << "format";
    QTest::newRow("no JSON") << QByteArray("not JSON") << "format";
    QTest::newRow("nothing expected") << setWith("") << "expected";
    QTest::newRow("an unknown kind")
        << setWith(R"({"weight": "A", "value": 1, "tolerance": 1, "source": "exact"})") << "expected[0]";
    QTest::newRow("an unknown variant")
        << setWith(R"({"parameter": "A", "variant": "x", "value": 1, "tolerance": 1, "source": "exact"})")
        << "expected[0].variant";
    QTest::newRow("no tolerance") << setWith(R"({"parameter": "A", "value": 1, "source": "exact"})")
                                  << "expected[0]";
    QTest::newRow("an unknown source")
        << setWith(R"({"parameter": "A", "value": 1, "tolerance": 1, "source": "hearsay"})") << "expected[0]";
    QTest::newRow("test 0")
        << setWith(R"({"parameter": "A", "test": 0, "value": 1, "tolerance": 1, "source": "exact"})")
        << "expected[0]";
}

void ValidationTest::refusesOtherFiles() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, place);
    try {
        std::ignore = readReferenceSet(bytes);
        QFAIL("was read");
    } catch (const Error &error) {
        QCOMPARE(QString::fromStdString(error.place), place);
    }
}

void ValidationTest::theQuickSetsAreQuick() {
    // Before every report: they are those of published, certified and constructed data, without simulations.
    for (const QString &name : quickReferenceFiles()) {
        const ReferenceSet set = embedded(QString(name).remove(":/reference/").remove(".json"));
        QCOMPARE(set.documents.size(), std::size_t(1));
        for (const Expectation &expected : set.expected)
            QVERIFY(expected.source != ExpectationSource::second && expected.what != Expected::influence);
    }
}

void ValidationTest::theReportSumsUp() {
    ReferenceSet set = embedded("constructed");
    const Language english(Language::Id::english);
    const QString good = plainText(composeValidation({validate(set)}, english));
    QVERIFY2(good.contains("52 of 52 values reproduced.") && good.contains("Constructed set"),
             qPrintable(good));
    QVERIFY(good.contains("agrees") && !good.contains("DOES NOT AGREE"));
    set.expected[3].value = 0.0125;
    const QString bad = plainText(composeValidation({validate(set)}, english));
    QVERIFY2(bad.contains("51 of 52 values reproduced.") && bad.contains("DOES NOT AGREE"), qPrintable(bad));
    QVERIFY2(bad.contains("test 1 E ISO 230-2:1997: 12.5"), qPrintable(bad));
    const QString french = plainText(
        composeValidation({validate(embedded("second/compensation"))}, Language(Language::Id::french)));
    QVERIFY2(french.contains("Tables de compensation") && french.contains("seconde implémentation"),
             qPrintable(french));
    // Two digits in the unit shown, and t has none.
    ReferenceSet rotary = withoutSimulations(embedded("second/rotary-axes"));
    const QString table = plainText(composeValidation({validate(rotary)}, english));
    QVERIFY2(table.contains("2.2·10⁻⁹″") && !table.contains("2.16"), qPrintable(table));
    const qsizetype t = table.indexOf("t of the progression of the runs");
    QVERIFY2(t > 0 && table.mid(t, 120).contains("6·10⁻⁷ "), qPrintable(table));
}

void ValidationTest::theDocumentNamesTheBuild() {
    const std::vector<SetValidation> sets = validateFiles({":/reference/constructed.json"});
    const QString text =
        plainText(composeValidationDocument(sets, Language(Language::Id::english))).simplified();
    const QJsonObject json = QJsonDocument::fromJson(validationJson(sets)).object();
    const QJsonObject build = json["build"].toObject();
    QCOMPARE(build["Program"].toString(), QString("Palmer " PALMER_VERSION));
    for (const char *key : {"Program", "Compiler", "Processor", "SHA-256 of the program", "Made on"}) {
        QVERIFY2(!build[key].toString().isEmpty(), key);
        QVERIFY2(text.contains(build[key].toString().simplified()), qPrintable(text));
    }
    const QString digest =
        QCryptographicHash::hash(bytesOf("constructed"), QCryptographicHash::Sha256).toHex();
    QCOMPARE(json["sets"][0]["sha256"].toString(), digest);
    QVERIFY2(text.contains(digest), qPrintable(text));
    const QJsonArray values = json["sets"][0]["values"].toArray();
    QCOMPARE(values.size(), 52);
    QCOMPARE(values[0]["place"].toString(), QString("test 1 A ISO 230-2:1997"));
    QCOMPARE(values[0]["expected"].toDouble(), 0.018);
    QCOMPARE(values[0]["agrees"].toBool(), true);
}

QTEST_GUILESS_MAIN(ValidationTest)
#include "validationtest.moc"
