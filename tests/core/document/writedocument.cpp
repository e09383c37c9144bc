// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/writedocument.h"

#include "core/document/completefile.h"
#include "document/edits.h"
#include "document/fields.h"
#include "document/filewords.h"
#include "document/json.h"
#include "document/jsonprinter.h"
#include "document/readdocument.h"

#include <QTest>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

using namespace palmer;

namespace {

Document documentWithTargets(std::vector<double> targets) {
    Test test;
    test.edition = "ISO 230-2:1988";
    std::get<PositioningMeasurement>(test.measurement).targets = std::move(targets);
    Document document;
    document.tests.push_back(std::make_shared<const Test>(test));
    return document;
}

/// Fills every field of a document with something, sensible or not.
class RandomFields {
public:
    explicit RandomFields(std::mt19937_64 &random)
        : m_random(random) {}

    template <class T>
    void operator()(const char *, T &member, unsigned = nothing) {
        fill(member);
    }
    void object(const char *, const auto &members) { members(*this); }
    void extensions(const char *, std::string &text) {
        text = std::array{"{}", R"({"a":[1,2.5,"é",null,true,-7],"z":{"k":{},"l":[]}})",
                          R"({"list":[[1,2],{"a":1e-9}],"large":18446744073709551615})"}[below(3)];
    }
    void fill(Document &document) { fields(*this, document); }

private:
    std::size_t below(std::size_t n) { return m_random() % n; }
    std::size_t size() { return std::array<std::size_t, 9>{0, 0, 1, 2, 3, 49, 50, 51, 200}[below(9)]; }

    void fill(bool &value) { value = below(2) == 0; }
    void fill(std::integral auto &value) {
        value = static_cast<std::remove_reference_t<decltype(value)>>(m_random());
    }
    void fill(double &value) {
        const auto whole = static_cast<double>(below(2'000'001)) - 1'000'000;
        const int power = static_cast<int>(below(40)) - 20;
        value = below(3) == 0   ? whole / 1000
                : below(3) == 0 ? whole
                                : std::nextafter(whole * std::pow(10, power), 0);
    }
    void fill(std::string &value) {
        value = std::array{"",
                           "X",
                           "two words",
                           "\"quoted\"\n",
                           "é↑😀",
                           "\x7f",
                           "\xff",
                           "a text that is so long that nothing else has room on its line, and then some "
                           "more of it"}[below(8)];
    }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    void fill(Enumeration &value) {
        value = fileWords<Enumeration>[below(fileWords<Enumeration>.size())].value;
    }
    template <class T>
    void fill(std::optional<T> &value) {
        value.reset();
        if (below(3) > 0)
            fill(value.emplace());
    }
    template <class T>
    void fill(std::vector<T> &values) {
        constexpr bool isStruct = std::is_class_v<T> && !std::is_same_v<T, std::string> &&
                                  !std::is_same_v<T, std::optional<double>>;
        values.resize(isStruct ? below(3) : size());
        for (T &value : values)
            fill(value);
    }
    void fill(Point3 &values) {
        for (auto &value : values)
            fill(value);
    }
    void fill(Permitted &permitted) {
        fill(permitted.high);
        if (permitted.high)
            fill(permitted.low);
    }
    template <class T>
    void fill(std::map<std::string, T> &values) {
        for (const char *key : {"E", "G(b)", "a\"b", "é"}) {
            if (below(2) == 0)
                fill(values[key]);
        }
    }
    void fill(TestPointer &pointer) {
        Test test;
        if (below(3) == 0)
            test.measurement = CircularMeasurement();
        else if (below(3) == 0)
            test.measurement = DriftMeasurement();
        fields(*this, test);
        pointer = std::make_shared<const Test>(std::move(test));
    }
    template <class Struct>
    requires std::is_class_v<Struct>
    void fill(Struct &value) { fields(*this, value); }

    std::mt19937_64 &m_random;
};

} // namespace

class WriteDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void whatWasWrittenIsReadEqually() {
        const Document document = readDocument(completeFile());
        QVERIFY(readDocument(writeDocument(document)) == document);
        QVERIFY(readDocument(writeDocument(Document())) == Document());
    }

    void writingIsAFixedPoint() {
        const QByteArray once = writeDocument(readDocument(completeFile()));
        QCOMPARE(writeDocument(readDocument(once)), once);
    }

    /// Older programs refuse what they do not know: they are told by the version.
    void aPageOfDiagnosisIsAskedForInVersionTwo() {
        Document document;
        QVERIFY(writeDocument(document).contains("\"version\": 1"));
        document.report.include = {ReportExtra::readingMarks, ReportExtra::allReadings};
        QVERIFY(writeDocument(document).contains("\"version\": 1"));
        document.report.include.push_back(ReportExtra::diagnosis);
        const QByteArray written = writeDocument(document);
        QVERIFY(written.contains("\"version\": 2"));
        QVERIFY(written.contains("\"allReadings\", \"diagnosis\""));
        QVERIFY(readDocument(written) == document);
    }

    void whatCertificatesStateIsOfVersionThree_data() {
        QTest::addColumn<std::function<void(Document &)>>("state");
        const auto row = [](const char *name, std::function<void(Document &)> state) {
            QTest::newRow(name) << std::move(state);
        };
        row("annex", [](Document &d) { d.report.leaveOut = {ReportPart::annex}; });
        row("country", [](Document &d) { d.report.laboratory.country = "FR"; });
        row("contact", [](Document &d) { d.report.customer.contact = "A. Martin"; });
        row("reason of the revision", [](Document &d) { d.report.revisionReason = "wrong date"; });
        row("deviations from the method", [](Document &d) { d.report.deviationsFromMethod = "one run"; });
        row("rounding", [](Document &d) { d.report.rounding = Rounding::twoDigits; });
        row("traceability", [](Document &d) {
            d.instruments.resize(1);
            d.instruments[0].traceability.accreditation = "2-0001";
        });
    }
    void whatCertificatesStateIsOfVersionThree() {
        QFETCH(const std::function<void(Document &)>, state);
        Document document;
        state(document);
        const QByteArray written = writeDocument(document);
        QVERIFY(written.contains("\"version\": 3"));
        QVERIFY(readDocument(written) == document);
    }

    void nullIsNotStated() {
        QVERIFY(readDocument(R"({"format": "palmer test report", "version": 3, "instruments": [
            {"traceability": null}, {"traceability": {"laboratory": null}}], "report": {"rounding": null,
            "revisionReason": null, "deviationsFromMethod": null, "laboratory": {"country": null},
            "customer": {"contact": null}}})")
                    .report == ReportHead());
    }

    /// Older programs take no null for a word: the key is left out.
    void aCycleThatIsNotStatedIsLeftOut() {
        Document document = readDocument(completeFile());
        editTest(document, 0,
                 [](Test &test) { std::get<PositioningMeasurement>(test.measurement).cycle.reset(); });
        const QByteArray written = writeDocument(document);
        QVERIFY(!written.contains("\"cycle\":"));
        QVERIFY(readDocument(written) == document);
    }

    /// Two spaces a level; small objects and lists of scalars on their line, longer ones filled below 100.
    void theFormIsThis() {
        const nlohmann::json value = nlohmann::json::parse(
            R"({"a": {}, "b": [], "c": {"x": [1, 2.5], "y": null}, "d": [{"x": {"y": true}}, "é"],
                "e": [1111111111, 2222222222, 3333333333, 4444444444, 5555555555, 6666666666, 7777777777,
                      8888888888, 9999999999, -0.0]})");
        QCOMPARE(QByteArray::fromStdString(printJson(value)), QByteArray(R"({
  "a": {},
  "b": [],
  "c": {"x": [1, 2.5], "y": null},
  "d": [
    {
      "x": {"y": true}
    },
    "é"
  ],
  "e": [
    1111111111, 2222222222, 3333333333, 4444444444, 5555555555, 6666666666, 7777777777, 8888888888,
    9999999999, 0
  ]
}
)"));
    }

    /// Printed from the structs as the values of the JSON library are printed, which know nothing of them.
    void anyDocumentIsPrintedAsItsJson() {
        std::mt19937_64 random(3);
        for (int i = 0; i < 200; ++i) {
            Document document;
            RandomFields(random).fill(document);
            const QByteArray written = writeDocument(document);
            const nlohmann::json read = nlohmann::json::parse(written.toStdString());
            QCOMPARE(written, QByteArray::fromStdString(printJson(read)));
            QVERIFY(read.at("tests").size() == document.tests.size());
        }
    }

    void numbersAreWrittenInTheirShortestForm_data() {
        QTest::addColumn<double>("value");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("whole number without point") << 1800.0 << QByteArray("1800");
        QTest::newRow("large whole number") << 100000.0 << QByteArray("100000");
        QTest::newRow("zero without sign") << -0.0 << QByteArray("0");
        QTest::newRow("small deviation without exponent") << 0.0001 << QByteArray("0.0001");
        QTest::newRow("no digit more than needed") << 0.1 << QByteArray("0.1");
        QTest::newRow("all digits needed") << 0.1 + 0.2 << QByteArray("0.30000000000000004");
        QTest::newRow("exponent where it is shorter") << 2.5e300 << QByteArray("2.5e+300");
        QTest::newRow("smallest subnormal") << 5e-324 << QByteArray("5e-324");
    }
    void numbersAreWrittenInTheirShortestForm() {
        QFETCH(double, value);
        QFETCH(QByteArray, text);
        const QByteArray written = writeDocument(documentWithTargets({value}));
        QVERIFY2(written.contains("\"targets\": [" + text + "]"), written.constData());
    }

    /// Eight digits at a time where there are at most seven decimals below 10⁸, and what is beyond: as the
    /// library prints them.
    void decimalsKeepTheirDigits() {
        std::mt19937_64 random(5);
        const auto check = [](double value) {
            std::array<char, 64> digits{};
            const char *const end =
                std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed)
                    .ptr;
            JsonPrinter printer(JsonPrinter::Form::oneLine);
            printer.number(value, {});
            QCOMPARE(printer.take(), QByteArray(digits.data(), end - digits.data()));
        };
        for (const double value : {99999999.9999999, 99999999.99999999, 1e8, 100000000.5, 0.0000001,
                                   0.00000015, 9.9999999, 10000000.0000001, -0.0021})
            check(value);
        double scale = 1;
        for (int decimals = 0; decimals < 10; ++decimals, scale *= 10) {
            for (int digits = 1; digits <= 15; ++digits) {
                for (int i = 0; i < 100; ++i) {
                    const double whole =
                        std::floor(std::pow(10, digits) * static_cast<double>(random() >> 11) /
                                   static_cast<double>(std::uint64_t(1) << 53U));
                    const double value = (i % 2 == 0 ? 1 : -1) * (whole + 1) / scale;
                    if (std::abs(value) >= 1e-7 && std::abs(value) < 1e15)
                        check(value);
                }
            }
        }
    }

    void everyDoubleRoundTrips() {
        std::mt19937_64 random(17);
        std::vector<double> values;
        while (values.size() < 20'000) {
            const auto bits = random();
            double value = 0;
            static_assert(sizeof bits == sizeof value);
            std::memcpy(&value, &bits, sizeof value);
            if (std::isfinite(value))
                values.push_back(value);
        }
        std::sort(values.begin(), values.end());
        const Document document = documentWithTargets(values);
        QVERIFY(readDocument(writeDocument(document)) == document);
    }

    void linesOfNumbersAreFilled() {
        std::vector<double> targets;
        for (int i = 0; i < 1000; ++i)
            targets.push_back(i + 0.125);
        const QByteArray written = writeDocument(documentWithTargets(targets));
        qsizetype longest = 0;
        for (const QByteArray &line : written.split('\n'))
            longest = std::max(longest, line.size());
        QVERIFY(longest <= 100);
        QVERIFY(longest > 90);
        // Nine characters and more a number: about ten a line.
        QVERIFY(written.count('\n') < 250);
        QVERIFY(written.endsWith("}\n"));
    }

    /// Two threads print a half of a long list each: nothing is lost or doubled between them, on lines as
    /// ever.
    void longListsAreWhole() {
        for (const std::size_t size : {99'999U, 100'000U, 100'001U, 100'002U, 230'457U}) {
            std::vector<double> targets;
            for (std::size_t i = 0; i < size; ++i)
                targets.push_back(static_cast<double>(i) / 8 + (i % 3 == 0 ? 1.0 / 70 : 0));
            const QByteArray written = writeDocument(documentWithTargets(targets));
            QVERIFY(std::get<PositioningMeasurement>(readDocument(written).tests[0]->measurement).targets ==
                    targets);
            const QByteArray inner = written.mid(written.indexOf("\"targets\": ["));
            const QByteArrayList lines = inner.left(inner.indexOf(']')).split('\n');
            int shortLines = 0;
            for (qsizetype i = 1; i + 2 < lines.size(); ++i) {
                QVERIFY2(lines[i].size() <= 100 && lines[i].endsWith(','), lines[i].constData());
                QVERIFY2(lines[i].startsWith("        ") && lines[i][8] != ' ', lines[i].constData());
                shortLines += lines[i].size() < 75 ? 1 : 0;
            }
            QVERIFY(shortLines <= 1); // where the halves meet
            QCOMPARE(writeDocument(readDocument(written)), written);
        }
    }

    void aLongListNamesTheNumberThatIsNotFinite() {
        for (const std::size_t at : {70'000U, 170'000U}) {
            std::vector<double> targets(200'000, 0.5);
            targets[at] = std::numeric_limits<double>::quiet_NaN();
            try {
                (void)writeDocument(documentWithTargets(targets));
                QFAIL("it was written");
            } catch (const Error &error) {
                QCOMPARE(error.place, "tests[0].targets[" + std::to_string(at) + "]");
            }
        }
    }

    void keysAreSorted() {
        const QByteArray written = writeDocument(Document());
        QVERIFY(written.indexOf("\"extensions\"") < written.indexOf("\"format\""));
        QVERIFY(written.indexOf("\"format\"") < written.indexOf("\"version\""));
    }

    void textsAreEscaped() {
        Document document;
        document.writtenBy = "\"\\\n\t\x01é😀\x7f";
        QCOMPARE(readDocument(writeDocument(document)).writtenBy, document.writtenBy);
    }

    void aNumberThatIsNotFiniteIsRefused() {
        for (const double value :
             {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
            try {
                (void)writeDocument(documentWithTargets({0, value}));
                QFAIL("it was written");
            } catch (const Error &error) {
                QVERIFY(error.kind == Error::Kind::unwritable);
                QCOMPARE(error.place, std::string("tests[0].targets[1]"));
            }
    }
};

QTEST_APPLESS_MAIN(WriteDocumentTest)
#include "writedocument.moc"
