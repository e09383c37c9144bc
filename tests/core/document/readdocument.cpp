// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/readdocument.h"

#include "core/document/completefile.h"
#include "document/bounds.h"
#include "document/writedocument.h"

#include <QTest>

#include <cmath>
#include <cstdlib>
#include <random>

using namespace palmer;

namespace {

const QByteArray head = R"({"format": "palmer test report", "version": 1)";

// A file with one positioning test; `members` go into the test.
QByteArray positioningFile(const QByteArray &members) {
    return head + R"(, "tests": [{"kind": "positioning", "edition": "ISO 230-2:1988", )" + members + "}]}";
}

QByteArray circularFile(const QByteArray &members) {
    return head + R"(, "tests": [{"kind": "circular", "edition": "ISO 230-4:2005", "nominalRadius": 100, )" +
           members + "}]}";
}

const QByteArray noReadings = R"("targets": [], "runs": [])";
const QByteArray twoTargets =
    R"("targets": [0, 1], "runs": [{"approach": "positive", "deviations": [0.001, null]}, {"approach": "positive", "deviations": [0.1, 0.2]}])";

} // namespace

class ReadDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void completeFileIsRead() {
        const Document document = readDocument(completeFile());
        QCOMPARE(document.writtenBy, std::string("Palmer 0.1.0"));
        QCOMPARE(document.report.operatorName, std::string("A. Martin"));
        QCOMPARE(document.report.laboratory.logo.value(), std::string("iVBORw0KGgo="));
        QCOMPARE(document.machine.year.value(), 1998);
        QCOMPARE(document.instruments.size(), std::size_t(2));
        QCOMPARE(document.instruments[0].resolution.value(), 0.00001);
        QCOMPARE(document.tests.size(), std::size_t(6));

        const Test &x = *document.tests[0];
        QCOMPARE(x.edition, std::string("ISO 230-2:1988"));
        QCOMPARE(x.limits.at("A").value.value(), 0.020);
        QVERIFY(x.decisionRule.rule == Rule::iso14253_1);
        QCOMPARE(x.imports[0].results[0].value, 0.018);
        const auto &positioning = std::get<PositioningMeasurement>(x.measurement);
        QCOMPARE(positioning.axis.range->to, 1789.5);
        QCOMPARE(positioning.targets, (std::vector<double>{0.0, 150.71, 301.2}));
        QVERIFY(positioning.runs[1].approach == Direction::negative);
        QVERIFY(!positioning.runs[1].deviations[1]);
        QCOMPARE(positioning.runs[1].deviations[2].value(), 0.0031);
        QCOMPARE(positioning.excluded[0].value, 0.0954);
        QCOMPARE(positioning.conditions.common.sensors[0].series->temperatures[1], 20.7);
        QVERIFY(positioning.conditions.feedMode == FeedMode::rapid);
        QCOMPARE(positioning.conditions.common.toolOffset[2].value(), 150.0);
        QVERIFY(!positioning.conditions.common.workpieceOffset[0]);
        QCOMPARE(positioning.uncertainty.trials.value(), 100000LL);
        QCOMPARE(positioning.uncertainty.expanded.at("Bmean"), 1.25);

        const auto &circular = std::get<CircularMeasurement>(document.tests[1]->measurement);
        QCOMPARE(circular.plane.second, std::string("Y"));
        QVERIFY(circular.arcs[1].sense == Sense::clockwise);
        QCOMPARE(circular.arcs[1].angles[1], -0.2);
        QCOMPARE(circular.uncertainty.displacement.expanded.value(), 0.7);
        QVERIFY(circular.uncertainty.sameSensor);

        const auto &drift = std::get<DriftMeasurement>(document.tests[2]->measurement);
        QCOMPARE(drift.deviations[1], 0.0001);
        QVERIFY(std::get<PositioningMeasurement>(document.tests[3]->measurement).axis.motion ==
                Motion::rotary);
    }

    void whatIsMissingHasItsDefault() {
        const Document document = readDocument(
            head +
            R"(, "tests": [{"kind": "positioning", "edition": "ISO 230-2:1988", "targets": [], "runs": []},
            {"kind": "circular", "edition": "ISO 230-4:2005", "nominalRadius": 100, "arcs": []},
            {"kind": "drift", "times": [], "deviations": []}]})");
        Test positioning;
        positioning.edition = "ISO 230-2:1988";
        Test circular;
        circular.edition = "ISO 230-4:2005";
        circular.measurement = CircularMeasurement{};
        std::get<CircularMeasurement>(circular.measurement).nominalRadius = 100;
        Test drift;
        drift.measurement = DriftMeasurement{};
        Document expected;
        for (const Test &test : {positioning, circular, drift})
            expected.tests.push_back(std::make_shared<const Test>(test));
        QVERIFY(document == expected);
        QVERIFY(document.report.languages == std::vector{ReportLanguage::fr});
        QVERIFY(document.report.include == std::vector{ReportExtra::readingMarks});
    }

    void byteOrderMarkIsAccepted() {
        QVERIFY(readDocument("\xEF\xBB\xBF" + completeFile()) == readDocument(completeFile()));
    }

    void numbersAreReadExactly_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("shortest form of a double")
            << QByteArray("0.30000000000000004") << 0.30000000000000004;
        QTest::newRow("capital exponent") << QByteArray("1E-3") << 0.001;
        QTest::newRow("exponent with plus") << QByteArray("12e+2") << 1200.0;
        QTest::newRow("whole number beyond 64 bits")
            << QByteArray("36893488147419103232") << 36893488147419103232.0;
        QTest::newRow("smallest subnormal") << QByteArray("5e-324") << 5e-324;
        QTest::newRow("nearer to zero than a double can be") << QByteArray("1e-999") << 0.0;
        QTest::newRow("a zero with a large exponent") << QByteArray("0e999") << 0.0;
        QTest::newRow("half way between zero and the smallest subnormal")
            << QByteArray("2.4703282292062327208e-324") << 0.0;
        QTest::newRow("a little more than half way") << QByteArray("2.4703282292062327209e-324") << 5e-324;
        QTest::newRow("minus zero") << QByteArray("-0.0") << -0.0;
        QTest::newRow("minus zero with an exponent") << QByteArray("-0e5") << -0.0;
        QTest::newRow("exponent beyond 32 bits") << QByteArray("1e-2147483649") << 0.0;
        QTest::newRow("exponent and decimals beyond 32 bits together")
            << QByteArray("0.0000001234567890123456789e-2147483639") << 0.0;
        QTest::newRow("subnormal with many decimals")
            << QByteArray("0.0000001234567890123456789e-310") << 1.2345678901234568e-317;
        QTest::newRow("exponent beyond 64 bits") << QByteArray("0e99999999999999999999") << 0.0;
        QTest::newRow("digits of 2⁵³") << QByteArray("9007199254.740992") << 9007199254.740992;
        QTest::newRow("digits of 2⁵³ + 1") << QByteArray("9007199254.740993") << 9007199254.740993;
        QTest::newRow("digits that wrap 64 bits") // 2⁶⁴ + 10⁶
            << QByteArray("18446744073710.551616") << 18446744073710.551616;
        QTest::newRow("whole number with a point") << QByteArray("100000000000000000.0") << 1e17;
        QTest::newRow("largest double") << QByteArray("1.7976931348623157e308") << 1.7976931348623157e308;
    }
    void numbersAreReadExactly() {
        QFETCH(QByteArray, text);
        QFETCH(double, value);
        const Document document =
            readDocument(positioningFile(R"("targets": [)" + text + R"(], "runs": [])"));
        const double found = std::get<PositioningMeasurement>(document.tests[0]->measurement).targets[0];
        QVERIFY2(found == value && std::signbit(found) == std::signbit(value),
                 qPrintable(QString::number(found, 'g', 17)));
    }

    // Against the C library: all counts of digits on both sides of the point, with zeros and nines in plenty.
    void numbersOfAllLengthsAreReadExactly() {
        std::mt19937 random(7);
        QByteArrayList numbers;
        for (int round = 0; round < 8; ++round) {
            for (std::size_t whole = 0; whole <= 22; ++whole) {
                for (std::size_t decimals = 0; decimals <= 25; ++decimals) {
                    const auto digit = [&] {
                        const auto drawn = static_cast<char>('0' + random() % 14);
                        return drawn <= '9' ? drawn : drawn % 2 == 0 ? '0' : '9';
                    };
                    QByteArray number = random() % 2 == 0 ? "-" : "";
                    number += whole == 0 ? '0' : std::max('1', digit());
                    for (std::size_t i = 1; i < whole; ++i)
                        number += digit();
                    for (std::size_t i = 0; i < decimals; ++i)
                        number += (i == 0 ? QByteArray(".") : QByteArray()) + digit();
                    if (random() % 4 == 0)
                        number += "e" + QByteArray::number(static_cast<int>(random() % 660) - 340);
                    if (std::isfinite(std::strtod(number, nullptr)))
                        numbers += number;
                }
            }
        }
        const Document document =
            readUnbounded(head + R"(, "tests": [{"kind": "drift", "times": [)" + numbers.join(", ") +
                          R"(], "deviations": [)" + numbers.join(",\n") + "]}]}");
        const auto &drift = std::get<DriftMeasurement>(document.tests[0]->measurement);
        QCOMPARE(drift.times.size(), static_cast<std::size_t>(numbers.size()));
        QVERIFY(drift.times == drift.deviations);
        for (qsizetype i = 0; i < numbers.size(); ++i)
            QVERIFY2(drift.times[static_cast<std::size_t>(i)] == std::strtod(numbers[i], nullptr),
                     numbers[i].constData());
    }

    void escapesAreRead() {
        const Document document = readDocument(
            head + ", \"writtenBy\": \"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\\u20AC\\uD83D\\uDE00é€😀\"}");
        QCOMPARE(document.writtenBy, std::string("\"\\/\b\f\n\r\té€😀é€😀"));
    }

    void bordersOfUnicodeAreRead() {
        const Document document = readDocument(
            head +
            R"(, "writtenBy": "\u0000\u001F\u007f\u0080\u07FF\u0800\uD7FF\uE000\uFFFF\uD800\uDC00\uDBFF\uDFFF")"
            "}");
        QCOMPARE(document.writtenBy,
                 QString::fromUcs4(U"\0\x1F\x7F\x80\x7FF\x800\xD7FF\xE000\xFFFF\x10000\x10FFFF", 11)
                     .toStdString());
        QVERIFY(readDocument(writeDocument(document)) == document);
    }

    void extensionsAreKept() {
        const Document document = readDocument(completeFile());
        QCOMPARE(
            document.tests[0]->extensions,
            std::string(R"({"shop": {"shift": 2, "tags": ["a", null, true, 1.5, 12345678901234567890]}})"));
        QVERIFY(readDocument(writeDocument(document)).extensions == document.extensions);
    }

    void errorsNamePlaceAndExpectation_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<Error::Kind>("kind");
        QTest::addColumn<QByteArray>("place");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char *name, const QByteArray &file, Error::Kind kind,
                            const QByteArray &place, const QByteArray &message) {
            QTest::newRow(name) << file << kind << place << message;
        };
        constexpr auto syntax = Error::Kind::syntax;
        constexpr auto content = Error::Kind::content;

        row("empty file", "", syntax, "1:1", "the file ends here; expected %1");
        row("no JSON", "hello", syntax, "1:1", "found “%1”; expected %2");
        row("trailing comma in an object", "{\n  \"é\": 1,}", syntax, "2:10", "found “%1”; expected %2");
        row("trailing comma in a list", "{\"a\": [1,]}", syntax, "1:10", "found “%1”; expected %2");
        row("missing comma", "{\"a\": [1 2]}", syntax, "1:10", "found “%1”; expected %2");
        row("missing colon", "{\"a\" 1}", syntax, "1:6", "found “%1”; expected %2");
        row("NaN", "{\"a\": [NaN]}", syntax, "1:8", "found “%1”; expected %2");
        row("Infinity", "{\"a\": -Infinity}", syntax, "1:7", "found “%1”; expected %2");
        row("leading zero", "{\"a\": 012}", syntax, "1:8", "found “%1”; expected %2");
        row("leading plus", "{\"a\": +1}", syntax, "1:7", "found “%1”; expected %2");
        row("point without digits", "{\"a\": 1.}", syntax, "1:7", "found “%1”; expected %2");
        row("word cut off", "{\"a\": nul}", syntax, "1:7", "found “%1”; expected %2");
        row("word too long", "{\"a\": nulll}", syntax, "1:7", "found “%1”; expected %2");
        row("comment", "{} // end", syntax, "1:4", "found “%1”; expected %2");
        row("second value", "{} {}", syntax, "1:4", "found “%1”; expected %2");
        row("NUL behind the end", QByteArray("{}\0", 3), syntax, "1:3", "found “%1”; expected %2");
        row("text without end", "{\"a\": \"bc", syntax, "1:7",
            "the file ends inside this text; expected a quotation mark");
        row("line break in a text", "{\"a\": \"b\nc\"}", syntax, "1:9",
            "a text cannot hold this character; expected UTF-8 without line breaks and control characters");
        row("Latin-1 in a text", "{\"a\": \"\xE9\"}", syntax, "1:8",
            "a text cannot hold this character; expected UTF-8 without line breaks and control characters");
        row("overlong UTF-8", "{\"a\": \"\xC0\xAF\"}", syntax, "1:8",
            "a text cannot hold this character; expected UTF-8 without line breaks and control characters");
        row("surrogate in UTF-8", "{\"a\": \"\xED\xA0\x80\"}", syntax, "1:8",
            "a text cannot hold this character; expected UTF-8 without line breaks and control characters");
        row("broken UTF-8 outside a text", "{\xFF}", syntax, "1:2",
            "this is no character of UTF-8; expected a test file in UTF-8");
        row("unknown escape", "{\"a\": \"\\x\"}", syntax, "1:8",
            "unknown escape in a text; expected one that JSON knows");
        row("second half of a surrogate pair", R"({"a": "b\udc00"})", syntax, "1:9",
            "unknown escape in a text; expected one that JSON knows");
        row("first half twice", R"({"a": "\ud83d\ud83d"})", syntax, "1:8",
            "unknown escape in a text; expected one that JSON knows");
        row("first half before a letter", R"({"a": "\ud83dx\ude00"})", syntax, "1:8",
            "unknown escape in a text; expected one that JSON knows");
        row("escape without four digits", R"({"a": "\u12g4"})", syntax, "1:8",
            "unknown escape in a text; expected one that JSON knows");
        row("escape with a sign", R"({"a": "\u-123"})", syntax, "1:8",
            "unknown escape in a text; expected one that JSON knows");
        row("escape in a key", R"({"\q": 1})", syntax, "1:3",
            "unknown escape in a text; expected one that JSON knows");
        row("escaped quotation mark at the end", R"({"a": "\"})", syntax, "1:7",
            "the file ends inside this text; expected a quotation mark");
        row("NUL in a text", QByteArray("{\"a\": \"\0\"}", 10), syntax, "1:8",
            "a text cannot hold this character; expected UTF-8 without line breaks and control characters");
        row("a character beyond Unicode", "{\"a\": \"\xF4\x90\x80\x80\"}", syntax, "1:8",
            "a text cannot hold this character; expected UTF-8 without line breaks and control characters");
        row("character cut off at the end", "{\"a\": \"\xE2\x82", syntax, "1:8",
            "a text cannot hold this character; expected UTF-8 without line breaks and control characters");
        row("byte order mark twice", "\xEF\xBB\xBF\xEF\xBB\xBF{}", syntax, "1:1", "found “%1”; expected %2");
        row("byte order mark alone", "\xEF\xBB\xBF", syntax, "1:1", "the file ends here; expected %1");
        row("byte order mark, and a fault", "\xEF\xBB\xBF{\r\n\t\"é\": 1 1}", syntax, "2:9",
            "found “%1”; expected %2");
        // Where the number begins, or where what is one ends.
        const QList<std::pair<const char *, const char *>> noNumbers{
            {"-", "1:15"},     {"-.5", "1:15"},  {".5", "1:15"},   {"1.e5", "1:15"},  {"1e", "1:15"},
            {"1e+", "1:15"},   {"1E-", "1:15"},  {"--1", "1:15"},  {"inf", "1:15"},   {"-nan", "1:15"},
            {"00", "1:16"},    {"-01", "1:17"},  {"0x10", "1:16"}, {"1.5.2", "1:18"}, {"1e5.5", "1:18"},
            {"1_000", "1:16"}, {"0.10f", "1:19"}};
        for (const auto &[number, place] : noNumbers)
            row((QByteArray("no number: ") + number).constData(),
                QByteArray("{\"a\": [0.001, ") + number + "]}", syntax, place, "found “%1”; expected %2");
        row("number cut off", "{\"a\": 1.", syntax, "1:7", "found “%1”; expected %2");
        row("list cut off behind a number", "{\"a\": [1.5", syntax, "1:11",
            "the file ends here; expected %1");
        row("half a surrogate pair", "{\"a\": \"\\ud83d\"}", syntax, "1:8",
            "unknown escape in a text; expected one that JSON knows");

        row("a list instead of an object", "[]", syntax, "1:1", "found “%1”; expected %2");
        row("another format", R"({"format": "other", "version": 1})", Error::Kind::format, "",
            "this is not a test file of Palmer; expected %1");
        row("no format", R"({"version": 1})", Error::Kind::format, "",
            "this is not a test file of Palmer; expected %1");
        row("no version", R"({"format": "palmer test report"})", content, "", "the key “%1” is missing");
        row("version 0", R"({"format": "palmer test report", "version": 0})", content, "version",
            "expected a whole number from 1 on");
        row("version as text", R"({"format": "palmer test report", "version": "1"})", content, "version",
            "expected a whole number from 1 on");
        row("newer version", R"({"format": "palmer test report", "version": 4, "new": 1})",
            Error::Kind::newerVersion, "version",
            "the file was written by a newer version of Palmer (format %1); this one reads up to format %2: "
            "install "
            "a newer Palmer");

        const QByteArray unknownKey = "this key is unknown; what others want to add goes into “extensions”";
        row("unknown key at the top", head + R"(, "Tests": []})", content, "Tests", unknownKey);
        row("unknown key in the report", head + R"(, "report": {"laboratory": {"nom": ""}}})", content,
            "report.laboratory.nom", unknownKey);
        row("unknown key in a test", positioningFile(noReadings + R"(, "limit": {})"), content,
            "tests[0].limit", unknownKey);
        row("typing error in an obligatory key", positioningFile(R"("targest": [], "runs": [])"), content,
            "tests[0].targest", unknownKey);
        row("unknown key in a run",
            positioningFile(
                R"("targets": [], "runs": [{"approach": "positive", "deviations": [], "deviation": []}])"),
            content, "tests[0].runs[0].deviation", unknownKey);
        row("key of the other kind", circularFile(R"("arcs": [], "cycle": "step")"), content,
            "tests[0].cycle", unknownKey);
        row("edition of a drift test",
            head +
                R"(, "tests": [{"kind": "drift", "times": [], "deviations": [], "edition": "ISO 230-2:1988"}]})",
            content, "tests[0].edition", unknownKey);
        row("unknown key with marks", head + R"(, "a b\n": 1})", content, "[\"a b\\u000a\"]", unknownKey);
        row("duplicate key", positioningFile(R"("targets": [], "targets": [], "runs": [])"), content,
            "tests[0].targets", "this key stands here twice; expected it once");
        row("duplicate key in extensions", head + R"(, "extensions": {"a": [1, {"b": 1, "b": 1}]}})", content,
            "extensions.a[1].b", "this key stands here twice; expected it once");

        row("duplicate key, written in two ways", head + R"(, "extensions": {"a": {"b": 1, "\u0062": 1}}})",
            content, "extensions.a.b", "this key stands here twice; expected it once");
        row("duplicate key of objects in a list",
            head + R"(, "extensions": {"a": [[{"": 0}, {"": 0, "b": {}, "": 0}]]}})", content,
            "extensions.a[0][1][\"\"]", "this key stands here twice; expected it once");
        row("duplicate deviations",
            positioningFile(
                R"("targets": [0], "runs": [{"approach": "positive", "deviations": [0], "deviations": [1]}])"),
            content, "tests[0].runs[0].deviations", "this key stands here twice; expected it once");

        row("missing kind", head + R"(, "tests": [{}]})", content, "tests[0]", "the key “%1” is missing");
        row("missing edition", head + R"(, "tests": [{"kind": "positioning", "targets": [], "runs": []}]})",
            content, "tests[0]", "the key “%1” is missing");
        row("missing targets", positioningFile(R"("runs": [])"), content, "tests[0]",
            "the key “%1” is missing");
        row("missing deviations", positioningFile(R"("targets": [], "runs": [{"approach": "positive"}])"),
            content, "tests[0].runs[0]", "the key “%1” is missing");

        row("unknown word", positioningFile(noReadings + R"(, "cycle": "steps")"), content, "tests[0].cycle",
            "unknown word “%1”; expected one of: %2");
        row("unknown kind", head + R"(, "tests": [{"kind": "laser"}]})", content, "tests[0].kind",
            "unknown word “%1”; expected one of: %2");
        row("unknown word in a list", head + R"(, "report": {"leaveOut": ["readings", "all"]}})", content,
            "report.leaveOut[1]", "unknown word “%1”; expected one of: %2");
        row("a diagnosis that is left out",
            R"({"format": "palmer test report", "version": 2, "report": {"leaveOut": ["findings", "diagnosis"]}})",
            content, "report.leaveOut[1]",
            "the diagnosis is printed only where “include” asks for it; take the word out of this list");
        row("word twice in a list", head + R"(, "report": {"languages": ["fr", "fr"]}})", content,
            "report.languages[1]", "“%1” stands here twice; expected it once");
        row("number instead of a word", positioningFile(noReadings + R"(, "cycle": 1)"), content,
            "tests[0].cycle", "expected null or one of the words: %1");
        row("no language", head + R"(, "report": {"languages": []}})", content, "report.languages",
            "expected at least one language");

        row("text instead of a reading",
            positioningFile(
                R"("targets": [0, 1], "runs": [{"approach": "positive", "deviations": [0, 0]}, {"approach": "positive", "deviations": [0, "0,1"]}])"),
            content, "tests[0].runs[1].deviations[1]", "expected a number or null");
        row("null target", positioningFile(R"("targets": [null], "runs": [])"), content,
            "tests[0].targets[0]", "expected a number");
        row("object instead of a list", positioningFile(R"("targets": {}, "runs": [])"), content,
            "tests[0].targets", "expected a list, in square brackets");
        row("list instead of an object", head + R"(, "machine": []})", content, "machine",
            "expected an object, in braces");
        row("number instead of a text", head + R"(, "machine": {"name": 5}})", content, "machine.name",
            "expected a text, in quotation marks");
        row("null instead of a text", head + R"(, "machine": {"name": null}})", content, "machine.name",
            "expected a text, in quotation marks");
        row("fraction of a year", head + R"(, "machine": {"year": 1998.5}})", content, "machine.year",
            "expected a whole number");
        row("year beyond sense", head + R"(, "machine": {"year": 1e300}})", content, "machine.year",
            "expected a whole number");
        row("text instead of a year", head + R"(, "machine": {"year": "1998"}})", content, "machine.year",
            "expected a whole number or null");
        row("number instead of true", positioningFile(noReadings + R"(, "conditions": {"levelled": 1})"),
            content, "tests[0].conditions.levelled", "expected true, false or null");
        row("two coordinates", positioningFile(noReadings + R"(, "conditions": {"toolOffset": [0, 0]})"),
            content, "tests[0].conditions.toolOffset", "number of values found: %1; expected: %2");
        row("extensions that are a list", head + R"(, "extensions": []})", content, "extensions",
            "expected an object, in braces");
        row("a number that is not finite", positioningFile(R"("targets": [0, 1e999], "runs": [])"), content,
            "tests[0].targets[1]", "this number is too large; expected a finite number");
        row("a reading that is not finite",
            positioningFile(
                R"("targets": [0, 1], "runs": [{"approach": "positive", "deviations": [null, -1E+400]}])"),
            content, "tests[0].runs[0].deviations[1]", "this number is too large; expected a finite number");
        row("an exponent beyond 64 bits", head + R"(, "extensions": {"a": 0.001e99999999999999999999}})",
            content, "extensions.a", "this number is too large; expected a finite number");
        row("the first number that rounds to infinity",
            head + R"(, "extensions": {"a": 1.7976931348623159e308}})", content, "extensions.a",
            "this number is too large; expected a finite number");
        row("a long number that is not finite",
            positioningFile("\"targets\": [-" + QByteArray(400, '9') + "]"), content, "tests[0].targets[0]",
            "this number is too large; expected a finite number");

        row("targets that do not ascend", positioningFile(R"("targets": [0, 2, 2], "runs": [])"), content,
            "tests[0].targets[2]", "expected targets that ascend strictly");
        row("too few deviations",
            positioningFile(R"("targets": [0, 1], "runs": [{"approach": "positive", "deviations": [0]}])"),
            content, "tests[0].runs[0].deviations", "number of values found: %1; expected: %2");
        row("too many deviations",
            positioningFile(R"("targets": [0], "runs": [{"approach": "positive", "deviations": [0, 0]}])"),
            content, "tests[0].runs[0].deviations", "number of values found: %1; expected: %2");
        row("arc of unequal lists",
            circularFile(R"("arcs": [{"sense": "clockwise", "angles": [0, 1], "radialDeviations": [0]}])"),
            content, "tests[0].arcs[0].radialDeviations", "number of values found: %1; expected: %2");
        row("null in an arc",
            circularFile(R"("arcs": [{"sense": "clockwise", "angles": [0], "radialDeviations": [null]}])"),
            content, "tests[0].arcs[0].radialDeviations[0]", "expected a number");
        row("drift of unequal lists",
            head + R"(, "tests": [{"kind": "drift", "times": [0], "deviations": []}]})", content,
            "tests[0].deviations", "number of values found: %1; expected: %2");
        row("series of unequal lists",
            positioningFile(
                noReadings +
                R"(, "conditions": {"sensors": [{"series": {"times": [0], "temperatures": []}}]})"),
            content, "tests[0].conditions.sensors[0].series.temperatures",
            "number of values found: %1; expected: %2");
        row("excluded run that does not exist",
            positioningFile(twoTargets + R"(, "excluded": [{"run": 3, "target": 2, "value": 0}])"), content,
            "tests[0].excluded[0].run", "expected the number of a run, from 1 to %1");
        row("excluded target that does not exist",
            positioningFile(twoTargets + R"(, "excluded": [{"run": 1, "target": 3, "value": 0}])"), content,
            "tests[0].excluded[0].target", "expected the number of a target, from 1 to %1");
        row("excluded run 0",
            positioningFile(twoTargets + R"(, "excluded": [{"run": 0, "target": 3, "value": 0}])"), content,
            "tests[0].excluded[0].run", "expected a number greater than 0");
        row("excluded reading that is still there",
            positioningFile(twoTargets + R"(, "excluded": [{"run": 2, "target": 1, "value": 0}])"), content,
            "tests[0].runs[1].deviations[0]", "expected null, for this reading stands in “excluded”");
        row("reading excluded twice",
            positioningFile(
                twoTargets +
                R"(, "excluded": [{"run": 1, "target": 2, "value": 0}, {"run": 1, "target": 2, "value": 1}])"),
            content, "tests[0].excluded[1]", "this reading is excluded twice; expected it once");
        row("zone of no width", positioningFile(noReadings + R"(, "zone": {"from": 1, "to": 1})"), content,
            "tests[0].zone", "expected “from” to be less than “to”");
        row("travel 0", positioningFile(noReadings + R"(, "axis": {"travel": 0})"), content,
            "tests[0].axis.travel", "expected a number greater than 0");
        row("negative radius",
            head +
                R"(, "tests": [{"kind": "circular", "edition": "ISO 230-4:2005", "nominalRadius": -1, "arcs": []}]})",
            content, "tests[0].nominalRadius", "expected a number greater than 0");
        for (const char *trials : {"0", "-1", "1000000001", "9223372036854775807"})
            row((QByteArray("trials: ") + trials).constData(),
                positioningFile(noReadings + R"(, "uncertainty": {"trials": )" + trials + "}"), content,
                "tests[0].uncertainty.trials", "expected a whole number from 1 to 1 000 000 000");
        row("the actual targets of a circle",
            head + R"(, "tests": [{"kind": "circular", "edition": "ISO 230-4:2005", "nominalRadius": 1,
                "arcs": [], "uncertainty": {"method": "budgetActual"}}]})",
            content, "tests[0].uncertainty.method",
            "the budget with the actual targets is for positioning tests");
        row("negative guard factor",
            positioningFile(noReadings + R"(, "decisionRule": {"guardFactor": -0.5})"), content,
            "tests[0].decisionRule.guardFactor", "expected a number that is not negative");
        row("negative expanded uncertainty",
            positioningFile(noReadings + R"(, "uncertainty": {"expanded": {"A": -1}})"), content,
            "tests[0].uncertainty.expanded.A", "expected a number that is not negative");
        const char *temperature = "expected a temperature of %2 or more";
        row("colder than can be",
            positioningFile(noReadings + R"(, "conditions": {"sensors": [{"start": -300}]})"), content,
            "tests[0].conditions.sensors[0].start", temperature);
        row("colder than can be at the end",
            positioningFile(noReadings + R"(, "conditions": {"sensors": [{"end": -273.16}]})"), content,
            "tests[0].conditions.sensors[0].end", temperature);
        row("colder than can be in a series",
            positioningFile(noReadings + R"(, "conditions": {"sensors": [{"series": {"times": [0, 1],
                "temperatures": [20, -9999]}}]})"),
            content, "tests[0].conditions.sensors[0].series.temperatures[1]", temperature);
        row("expansion beyond any material",
            positioningFile(noReadings + R"(, "conditions": {"expansion": {"machine": 100.1}})"), content,
            "tests[0].conditions.expansion.machine",
            "expected a coefficient of expansion between −%1 and %1 µm/(m·°C)");
        row("missing approach", positioningFile(R"("targets": [], "runs": [{"deviations": []}])"), content,
            "tests[0].runs[0]", "the key “%1” is missing");
        row("a day that does not exist", positioningFile(noReadings + R"(, "date": "2023-02-29")"), content,
            "tests[0].date", "expected a date that exists, written YYYY-MM-DD");
        row("a date in French", positioningFile(noReadings + R"(, "date": "28/02/2023")"), content,
            "tests[0].date", "expected a date that exists, written YYYY-MM-DD");
        row("hour 24", positioningFile(noReadings + R"(, "time": "24:00")"), content, "tests[0].time",
            "expected a time of day, written HH:MM");
        row("no base64", head + R"(, "report": {"laboratory": {"logo": "Zm9v*"}}})", content,
            "report.laboratory.logo", "expected bytes in base64");
        row("base64 without its padding", head + R"(, "report": {"laboratory": {"mark": "Zm8"}}})", content,
            "report.laboratory.mark", "expected bytes in base64");

        row("unknown edition",
            head +
                R"(, "tests": [{"kind": "positioning", "edition": "ISO 230-2:2030", "targets": [], "runs": []}]})",
            content, "tests[0].edition",
            "unknown edition “%1”; expected a designation such as ISO 230-2:1988");
        row("edition of the other kind",
            head +
                R"(, "tests": [{"kind": "positioning", "edition": "ISO 230-4:2005", "targets": [], "runs": []}]})",
            content, "tests[0].edition", "“%1” is not for this kind of test");
        row("unknown edition of a limit",
            positioningFile(noReadings + R"(, "limits": {"A": {"edition": "1988"}})"), content,
            "tests[0].limits.A.edition",
            "unknown edition “%1”; expected a designation such as ISO 230-2:1988");
        row("unknown edition of the report", head + R"(, "report": {"editions": ["1988"]}})", content,
            "report.editions[0]", "unknown edition “%1”; expected a designation such as ISO 230-2:1988");
        row("limit of the other kind", positioningFile(noReadings + ", \"limits\": {\"G(b)\": {}}"), content,
            "tests[0].limits[\"G(b)\"]",
            "unknown parameter “%1”; expected one of this kind of test, such as %2");
        row("unknown required result", circularFile(R"("arcs": [], "requiredResults": ["G", "A"])"), content,
            "tests[0].requiredResults[1]",
            "unknown parameter “%1”; expected one of this kind of test, such as %2");
        row("point of the other kind", circularFile(R"("arcs": [], "agreedPoints": [{"point": "zone"}])"),
            content, "tests[0].agreedPoints[0].point",
            "unknown point “%1”; expected one that this kind of test agrees on");
        row("point agreed twice",
            circularFile(R"("arcs": [], "agreedPoints": [{"point": "warmUp"}, {"point": "warmUp"}])"),
            content, "tests[0].agreedPoints[1].point", "“%1” stands here twice; expected it once");
        row("two instruments of one id", head + R"(, "instruments": [{"id": "a"}, {"id": "a"}]})", content,
            "instruments[1].id", "“%1” stands here twice; expected it once");
        row("two tests of one id",
            head + R"(, "tests": [{"kind": "drift", "id": "a", "times": [], "deviations": []},
                                   {"kind": "drift", "id": "a", "times": [], "deviations": []}]})",
            content, "tests[1].id", "“%1” stands here twice; expected it once");
        row("instrument that is absent", positioningFile(noReadings + R"(, "instruments": ["laser"])"),
            content, "tests[0].instruments[0]",
            "expected the id of an instrument of this file; “%1” is none");
        row("drift test that is a positioning test",
            positioningFile(noReadings + R"(, "id": "x", "uncertainty": {"driftTest": "x"})"), content,
            "tests[0].uncertainty.driftTest", "expected the id of a drift test of this file; “%1” is none");
        row("compared with itself",
            positioningFile(noReadings + R"(, "id": "x", "comparedWith": {"test": "x"})"), content,
            "tests[0].comparedWith.test",
            "expected the id of another test of this file, no drift test; “%1” is none");
    }
    /// A word that the sentence names can be written.
    void wordsThatAreNamedAreTaken() {
        const QByteArray two =
            R"({"format": "palmer test report", "version": 2, "report": {"leaveOut": ["%"]}})";
        std::string named;
        try {
            (void)readDocument(QByteArray(two).replace("%", "all"));
        } catch (const Error &error) {
            named = std::get<std::string>(error.message.arguments.at(1));
        }
        const QStringList words = QString::fromStdString(named).split(" · ");
        QCOMPARE(words.size(), 7);
        for (const QString &word : words)
            QCOMPARE(readDocument(QByteArray(two).replace("%", word.toUtf8())).report.leaveOut.size(),
                     std::size_t(1));
    }

    void aDiagnosisLeftOutOfAnOlderFileMeantNothing() {
        const Document document =
            readDocument(head + R"(, "report": {"leaveOut": ["diagnosis", "findings", "readings"]}})");
        QCOMPARE(document.report.leaveOut, (std::vector{ReportPart::findings, ReportPart::readings}));
    }

    void errorsNamePlaceAndExpectation() {
        QFETCH(QByteArray, file);
        QFETCH(Error::Kind, kind);
        QFETCH(QByteArray, place);
        QFETCH(QByteArray, message);
        try {
            (void)readDocument(file);
        } catch (const Error &error) {
            QCOMPARE(QByteArray::fromStdString(error.place), place);
            QCOMPARE(QByteArray(error.message.text.source), message);
            QVERIFY(error.kind == kind);
            return;
        }
        QFAIL("the file was accepted");
    }

    void syntaxErrorsSayWhatWasFoundAndExpected() {
        try {
            (void)readDocument("{\"format\": \"palmer test report\",}");
            QFAIL("the file was accepted");
        } catch (const Error &error) {
            QCOMPARE(std::get<std::string>(error.message.arguments.at(0)), std::string("}"));
            QCOMPARE(std::get<Text>(error.message.arguments.at(1)).source, "a key in quotation marks");
        }
    }
};

QTEST_APPLESS_MAIN(ReadDocumentTest)
#include "readdocument.moc"
