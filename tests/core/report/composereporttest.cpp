// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/composereport.h"

#include "document/readdocument.h"
#include "document/writedocument.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "report/attachedfile.h"
#include "report/blocks/pagetext.h"
#include "report/parts/parts.h"
#include "report/tables/summary.h"
#include "report/words/wording.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>
#include <map>

using namespace palmer;

namespace {

const QString digits = "digits"; ///< stands for those of the fingerprint in stored texts
constexpr Language::Id both[]{Language::Id::english, Language::Id::french};

QByteArray content(const QString &path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(path));
    return file.readAll();
}

std::shared_ptr<const Document> document(const QString &name) {
    const QString own = QString(DOCUMENTS) + name + ".palmer";
    const QString path = QFile::exists(own) ? own : QString(EXAMPLES) + name + ".palmer";
    return std::make_shared<const Document>(readDocument(content(path)));
}

/// The simulation beside a budget, drawn once for a document, whatever the language; a fixed number of trials
/// will do.
std::optional<TestSimulation> simulation(const EvaluatedDocument &evaluated, std::size_t test) {
    static std::map<std::pair<QByteArray, std::size_t>, std::optional<TestSimulation>> all;
    const auto [known, isNew] = all.try_emplace({writeDocument(*evaluated.document), test});
    if (isNew) {
        SimulationOptions options = simulationOptions(*evaluated.document->tests[test]);
        options.trials = fewestDecidingTrials;
        known->second = simulateTest(evaluated, test, options);
    }
    return known->second;
}

Report report(const std::shared_ptr<const Document> &document, const Language &language) {
    // As the program prints them.
    EvaluatedDocument evaluated = evaluate(document);
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        if (!evaluated.tests[i]->uncertainty.wantsSimulation())
            continue;
        if (auto drawn = simulation(evaluated, i)) {
            drawn->of = document->tests[i]; // the same test, read again
            evaluated = withSimulation(evaluated, i, std::move(*drawn));
        }
    }
    return composeReport(evaluated, language, {"Palmer " PALMER_VERSION, true});
}

/// The text of a report below what the pages repeat. The fingerprint, which follows every change of the file
/// format, is left to a test of its own.
QString text(const std::shared_ptr<const Document> &document, const Language &language) {
    const Report composed = report(document, language);
    QString all = composed.footerLeft + u'\n' + composed.footerCentre + u'\n' + composed.footerRight +
                  "\n\n" + pageText(composed);
    return all.replace(composed.fingerprint, "(64 " + digits + ')')
        .replace(shortFingerprint(composed.fingerprint), "(16 " + digits + ')');
}

/// Each number that is no whole one as the double beside it, which is what programs write that compute
/// numbers: 0.30000000000000004.
QJsonValue nudged(const QJsonValue &value) { // NOLINT(misc-no-recursion): as deep as the format
    if (value.isDouble() && value.toDouble() != std::round(value.toDouble()))
        return std::nextafter(value.toDouble(), HUGE_VAL);
    if (value.isArray()) {
        QJsonArray result;
        for (const QJsonValue &one : value.toArray())
            result.append(nudged(one));
        return result;
    }
    if (value.isObject()) {
        QJsonObject result;
        const QJsonObject object = value.toObject();
        for (auto each = object.begin(); each != object.end(); ++each)
            result[each.key()] = nudged(each.value());
        return result;
    }
    return value;
}

/// Where two texts begin to differ: the lines of both.
QString difference(const QString &actual, const QString &expected) {
    const QStringList a = actual.split(u'\n');
    const QStringList e = expected.split(u'\n');
    for (qsizetype i = 0; i < std::max(a.size(), e.size()); ++i) {
        if (a.value(i) != e.value(i))
            return QString("line %1 is\n%2\nand should be\n%3").arg(i + 1).arg(a.value(i), e.value(i));
    }
    return {};
}

void addDocuments() {
    QTest::addColumn<QString>("name");
    QTest::newRow("the worked example of 1988") << "iso230-2-1988-example";
    QTest::newRow("2006 with limits, proof of conformity and stated uncertainty") << "limits-2006";
    QTest::newRow("2006 with budget and Monte Carlo, guard factor 0.83") << "budget-2006";
    QTest::newRow("a long axis: whole travel and zone") << "long-axis-with-zone";
    QTest::newRow("a rotary axis in arc seconds") << "rotary-axis";
    QTest::newRow("one direction with missing and excluded readings") << "one-direction-with-gaps";
    QTest::newRow("two tests, step cycle, correction made here, a drift test") << "two-tests";
    QTest::newRow("full circles in both senses") << "iso230-4-full-circles-xy";
    QTest::newRow("a partial arc of commanded angles, separate figures") << "iso230-4-partial-arc-zx";
    QTest::newRow("the feedback signal") << "iso230-4-feedback-yz";
    QTest::newRow("positioning and circle in one report") << "mixed";
}

void neutralise(Conditions &conditions, const std::string &sign) {
    for (std::string *field :
         {&conditions.warmUp.text, &conditions.compensation, &conditions.otherAxes, &conditions.load,
          &conditions.soak, &conditions.thermalGuidelines, &conditions.instrumentPosition})
        *field = sign;
    for (Sensor &sensor : conditions.sensors)
        sensor.position = sign;
}

/// Every free text of the user becomes a sign that is no word of any language.
std::shared_ptr<const Document> withoutUsersWords(Document document) {
    const std::string sign = "§";
    ReportHead &head = document.report;
    for (std::string *field : {&head.title,
                               &head.number,
                               &head.revision,
                               &head.replaces,
                               &head.place,
                               &head.laboratory.name,
                               &head.laboratory.address,
                               &head.laboratory.accreditation,
                               &head.customer.name,
                               &head.customer.address,
                               &head.supplier.name,
                               &head.supplier.address,
                               &head.order,
                               &head.procedure,
                               &head.operatorName,
                               &head.authorisedBy.name,
                               &head.authorisedBy.function,
                               &head.adjustments,
                               &head.remarks,
                               &document.machine.name,
                               &document.machine.manufacturer,
                               &document.machine.model,
                               &document.machine.serialNumber,
                               &document.machine.controller,
                               &document.machine.location,
                               &document.machine.condition})
        *field = sign;
    head.title.clear(); // the title of the catalogue
    head.signatures = {Signer::operatorSigns, Signer::laboratory, Signer::supplier, Signer::customer};
    for (Instrument &instrument : document.instruments) {
        for (std::string *field :
             {&instrument.description, &instrument.manufacturer, &instrument.model, &instrument.serialNumber,
              &instrument.certificate, &instrument.calibratedBy})
            *field = sign;
    }
    for (TestPointer &pointer : document.tests) {
        Test test = *pointer;
        test.title = test.remarks = sign;
        for (AgreedPoint &point : test.agreedPoints)
            point.text = sign;
        for (auto &[id, limit] : test.limits)
            limit.source = sign;
        for (ImportedFile &file : test.imports) {
            file.fileName = sign;
            for (ImportedResult &result : file.results)
                result.name = sign;
        }
        if (auto *m = std::get_if<PositioningMeasurement>(&test.measurement)) {
            m->axis.positionFeedback = sign;
            for (ExcludedReading &reading : m->excluded)
                reading.reason = sign;
            neutralise(m->conditions.common, sign);
        }
        if (auto *m = std::get_if<CircularMeasurement>(&test.measurement)) {
            m->positionFeedback = sign;
            m->conditions.startPoint = m->conditions.stopPoint = m->conditions.smoothing = sign;
            neutralise(m->conditions.common, sign);
        }
        pointer = std::make_shared<const Test>(std::move(test));
    }
    return std::make_shared<const Document>(std::move(document));
}

QSet<QString> wordsOf(const QString &text) {
    static const QRegularExpression word("[\\p{L}]{3,}");
    QSet<QString> words;
    for (auto match = word.globalMatch(text.toLower()); match.hasNext();)
        words += match.next().captured();
    return words;
}

/// All words of the English sources and of the French translations of the catalogue.
std::pair<QSet<QString>, QSet<QString>> catalogueWords() {
    QXmlStreamReader xml(content(QString(PALMER_SOURCE_DIR) + "/translations/report_fr.ts"));
    QSet<QString> english;
    QSet<QString> french;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"source")
            english += wordsOf(xml.readElementText());
        else if (xml.name() == u"translation" || xml.name() == u"numerusform")
            french += wordsOf(xml.readElementText(QXmlStreamReader::IncludeChildElements));
    }
    QXmlStreamReader plurals(content(QString(PALMER_SOURCE_DIR) + "/translations/report_en.ts"));
    while (!plurals.atEnd()) {
        if (plurals.readNext() == QXmlStreamReader::StartElement && plurals.name() == u"numerusform")
            english += wordsOf(plurals.readElementText());
    }
    return {english, french};
}

/// All tables of a report, also those beside something.
std::vector<Table> tablesOf(const Report &report) {
    std::vector<Table> tables;
    for (const Block &block : report.blocks) {
        if (const auto *table = std::get_if<Table>(&block))
            tables.push_back(*table);
        if (const auto *sides = std::get_if<SideBySide>(&block)) {
            for (const auto *side : {&sides->left, &sides->right}) {
                for (const Part &part : *side) {
                    if (const auto *table = std::get_if<Table>(&part))
                        tables.push_back(*table);
                }
            }
        }
    }
    return tables;
}

template <typename T>
std::vector<T> blocksOf(const Report &report) {
    std::vector<T> blocks;
    for (const Block &block : report.blocks) {
        if (const auto *found = std::get_if<T>(&block))
            blocks.push_back(*found);
    }
    return blocks;
}

QStringList headingsOf(const Report &report) {
    QStringList headings;
    for (const Heading &heading : blocksOf<Heading>(report))
        headings << heading.text;
    return headings;
}

} // namespace

class ComposeReportTest : public QObject {
    Q_OBJECT

private slots:
    void printsTheStoredText_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("language");
        for (const char *language : {"fr", "en"}) {
            for (const char *name :
                 {"iso230-2-1988-example", "limits-2006", "budget-2006", "long-axis-with-zone", "rotary-axis",
                  "one-direction-with-gaps", "two-tests", "iso230-4-full-circles-xy",
                  "iso230-4-partial-arc-zx", "iso230-4-feedback-yz", "mixed"})
                QTest::addRow("%s in %s", name, language) << name << language;
        }
    }
    void printsTheStoredText() {
        QFETCH(QString, name);
        QFETCH(QString, language);
        const QString actual = text(document(name), *Language::fromName(language));
        const QString fileName = name + u'.' + language + ".txt";
        QFile written(QString(PALMER_BINARY_DIR) + "/tests/" + fileName);
        QVERIFY(written.open(QIODevice::WriteOnly));
        written.write(actual.toUtf8());
        const QString stored = QString(DOCUMENTS) + fileName;
        QVERIFY2(QFile::exists(stored), qPrintable(written.fileName() + " is not stored"));
        const QString expected = QString::fromUtf8(content(stored));
        QVERIFY2(actual == expected, qPrintable(written.fileName() + ": " + difference(actual, expected)));
    }

    void theFirstPageIsKnownBeforeTheOthers_data() { addDocuments(); }
    void theFirstPageIsKnownBeforeTheOthers() {
        QFETCH(QString, name);
        const EvaluatedDocument evaluated = evaluate(document(name));
        std::vector<Report> begun;
        ReportOptions options;
        options.onFirstPage = [&begun](const Report &report) { begun.push_back(report); };
        const Report whole = composeReport(evaluated, Language(Language::Id::french), options);
        QCOMPARE(begun.size(), std::size_t(1));
        const std::vector<Block> &first = begun[0].blocks;
        QVERIFY(first.size() > 3 && first.size() < whole.blocks.size());
        QVERIFY(std::equal(first.begin(), first.end(), whole.blocks.begin()));
        QCOMPARE(begun[0].footerCentre, whole.footerCentre);
        QCOMPARE(begun[0].title, whole.title);
    }

    void printsNoDigitsOfFloatingPoint_data() { addDocuments(); }
    void printsNoDigitsOfFloatingPoint() {
        QFETCH(QString, name);
        QJsonObject root = QJsonDocument::fromJson(writeDocument(*document(name))).object();
        root["tests"] = nudged(root["tests"]);
        root["instruments"] = nudged(root["instruments"]);
        const auto read = std::make_shared<const Document>(readDocument(QJsonDocument(root).toJson()));
        static const QRegularExpression endless("[.,]\\d{9}");
        for (const Language::Id id : both) {
            for (const QString &line : text(read, Language(id)).split(u'\n'))
                QVERIFY2(!endless.match(line).hasMatch(), qPrintable(line));
        }
    }

    void namesTestsOfTheSameAxisByNumber_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("expected");
        QTest::newRow("one") << 1 << "R (X axis), R (Y axis). Not proven: B (X axis), B (Y axis). ";
        QTest::newRow("three") << 3
                               << "R (X axis, tests 1, 3, 4), R (Y axis). "
                                  "Not proven: B (X axis, tests 1, 3, 4), B (Y axis). ";
        QTest::newRow("seven") << 7
                               << "R (X axis, 7 tests), R (Y axis). "
                                  "Not proven: B (X axis, 7 tests), B (Y axis). ";
    }
    void namesTestsOfTheSameAxisByNumber() {
        QFETCH(int, count);
        QFETCH(QString, expected);
        Document several = *document("limits-2006");
        Test other = *several.tests.front();
        several.tests.assign(static_cast<std::size_t>(count), several.tests.front());
        std::get<PositioningMeasurement>(other.measurement).axis.name = "Y";
        several.tests.insert(several.tests.begin() + 1, std::make_shared<const Test>(other));
        const QString all = text(std::make_shared<const Document>(several), Language(Language::Id::english));
        const QString line = all.mid(all.indexOf("Limits  exceeded")).section(u'\n', 0, 0);
        QVERIFY2(line.startsWith("Limits  exceeded  " + expected), qPrintable(line));
    }

    /// More than are named end with dots, and without a period after them.
    void namesTheFirstOfManyAxes() {
        Document several = *document("limits-2006");
        const Test first = *several.tests.front();
        several.tests.clear();
        for (const char *axis : {"X", "Y", "Z", "U", "V", "W", "A"}) {
            Test test = first;
            std::get<PositioningMeasurement>(test.measurement).axis.name = axis;
            several.tests.push_back(std::make_shared<const Test>(test));
        }
        const QString all = text(std::make_shared<const Document>(several), Language(Language::Id::english));
        QVERIFY(all.contains("R (W axis), … Not proven: B (X axis),"));
        QVERIFY(all.contains("B (W axis), … Met: 7 of 21 limits."));
    }

    void countsLimitsInTheSingular() {
        const auto summary = [](double first, double second, Language::Id id) {
            QJsonObject root = QJsonDocument::fromJson(writeDocument(*document("two-tests"))).object();
            QJsonArray tests = root["tests"].toArray();
            for (qsizetype i = 0; i < tests.size(); ++i) {
                QJsonObject test = tests[i].toObject();
                const double limit = i == 0 ? first : i == 1 ? second : 0;
                test.remove("limits");
                if (limit > 0)
                    test["limits"] = QJsonObject{{"R", QJsonObject{{"value", limit}}}};
                tests[i] = test;
            }
            root["tests"] = tests;
            return text(std::make_shared<const Document>(readDocument(QJsonDocument(root).toJson())),
                        Language(id));
        };
        constexpr double wide = 1;
        constexpr double narrow = 1e-6;
        using enum Language::Id;
        QVERIFY(summary(wide, 0, english).contains("met  1 limit;"));
        QVERIFY(summary(wide, 0, french).contains("respectées  1 limite\u202F;"));
        QVERIFY(!summary(narrow, 0, english).contains("of 1 limit"));
        QVERIFY(summary(wide, narrow, french).contains("Respectée\u00A0: 1 limite sur 2."));
        QVERIFY(summary(narrow, narrow, french).contains("Respectée\u00A0: 0 limite sur 2."));
        QVERIFY(summary(wide, wide, french).contains("2 limites sur 2"));
    }

    void hasNoWordOfTheOtherLanguage_data() { addDocuments(); }
    void hasNoWordOfTheOtherLanguage() {
        QFETCH(QString, name);
        const auto neutral = withoutUsersWords(*document(name));
        static const auto catalogue = catalogueWords();
        const auto &[english, french] = catalogue;
        QVERIFY(english.size() > 200);
        // Without what stands for the digits of the fingerprint.
        const QSet<QString> inFrench = wordsOf(text(neutral, Language(Language::Id::french)).remove(digits));
        const QSet<QString> inEnglish =
            wordsOf(text(neutral, Language(Language::Id::english)).remove(digits));
        QCOMPARE(QStringList((inFrench & (english - french)).values()).join(' '), QString());
        QCOMPARE(QStringList((inEnglish & (french - english)).values()).join(' '), QString());
    }

    void hasNoPlaceLeftOpen_data() { addDocuments(); }
    void hasNoPlaceLeftOpen() {
        QFETCH(QString, name);
        static const QRegularExpression open("%[0-9n]|\\(s\\)|\\bnull\\b|\\bnan\\b|−0(?![,.0-9])");
        for (const Language::Id id : both) {
            const QString all = pageText(report(document(name), Language(id)));
            const auto found = open.match(all);
            QVERIFY2(!found.hasMatch(), qPrintable(found.captured()));
        }
    }

    void isTheSameUnderAnyLocale_data() { addDocuments(); }
    void isTheSameUnderAnyLocale() {
        QFETCH(QString, name);
        const QLocale before;
        for (const Language::Id id : both) {
            QLocale::setDefault(QLocale(QLocale::French, QLocale::France));
            const QString inFrance = text(document(name), Language(id));
            QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
            const QString inAmerica = text(document(name), Language(id));
            QLocale::setDefault(QLocale(QLocale::Arabic, QLocale::Egypt));
            const QString inEgypt = text(document(name), Language(id));
            QLocale::setDefault(before);
            QCOMPARE(inAmerica, inFrance);
            QCOMPARE(inEgypt, inFrance);
        }
    }

    /// Tables beyond 2 000 rows are left out with a sentence, and printed on request.
    void longTablesAreLeftOut_data() {
        QTest::addColumn<int>("targets");
        QTest::addColumn<int>("runs");      // a direction
        QTest::addColumn<int>("ofTargets"); // rows printed
        QTest::addColumn<int>("ofReadings");
        QTest::newRow("2 000 targets") << 2000 << 2 << 2000 << 2000;
        QTest::newRow("2 001 targets") << 2001 << 2 << 0 << 0;
        QTest::newRow("many runs, few targets") << 11 << 100 << 11 << 2 * 11 * 9;
        QTest::newRow("more rows of runs than 2 000") << 200 << 100 << 200 << 0;
    }
    void longTablesAreLeftOut() {
        QFETCH(const int, targets);
        QFETCH(const int, runs);
        QFETCH(const int, ofTargets);
        QFETCH(const int, ofReadings);
        PositioningMeasurement measurement;
        for (int i = 0; i < targets; ++i)
            measurement.targets.push_back(i);
        for (int j = 0; j < 2 * runs; ++j) {
            measurement.runs.push_back({j % 2 == 0 ? Direction::positive : Direction::negative, {}});
            for (int i = 0; i < targets; ++i)
                measurement.runs.back().deviations.emplace_back((i * 7 + j * 3) % 11 * 1e-4);
        }
        Test test;
        test.edition = "ISO 230-2:2014";
        test.measurement = measurement;
        Document whole;
        whole.tests.push_back(std::make_shared<const Test>(test));
        for (const bool all : {false, true}) {
            if (all)
                whole = readDocument(
                    writeDocument(whole).replace("\"readingMarks\"", "\"readingMarks\", \"allReadings\""));
            for (const Language::Id id : both) {
                const Language language(id);
                const Report made =
                    composeReport(evaluate(std::make_shared<const Document>(whole)), language, {});
                const QString sentence =
                    language
                        .sentence(
                            {REPORT_TEXT_COUNTED(
                                 "report", "Left out: %n row(s), for a report prints no more than %1 of them "
                                           "unasked. The test file holds all readings. To print the rows as "
                                           "well, choose “All readings” for the report, or write "
                                           "“allReadings” under “include” in the test file."),
                             {},
                             2})
                        .section(u'2', 0, 0);
                int leftOut = 0;
                int rowsOfTargets = 0;
                int rowsOfReadings = 0;
                for (const Block &block : made.blocks) {
                    if (const auto *paragraph = std::get_if<Paragraph>(&block))
                        leftOut += paragraph->text.startsWith(sentence) ? 1 : 0;
                    const auto *table = std::get_if<Table>(&block);
                    if (!table || table->columns[0].title.plain() != "i")
                        continue;
                    (table->spanners.empty() ? rowsOfTargets : rowsOfReadings) += int(table->rowCount());
                }
                if (all) {
                    QCOMPARE(leftOut, 0);
                    QCOMPARE(rowsOfTargets, targets);
                    QVERIFY(rowsOfReadings >= targets);
                } else {
                    QCOMPARE(leftOut, (ofTargets == 0 ? 1 : 0) + (ofReadings == 0 ? 1 : 0));
                    QCOMPARE(rowsOfTargets, ofTargets);
                    QCOMPARE(rowsOfReadings, ofReadings);
                }
            }
        }
    }

    /// Of readings set aside the first 2 000 are listed, the rest are counted.
    void manyReadingsSetAsideAreCounted() {
        for (const int count : {1, 2000, 2001, 5000}) {
            PositioningMeasurement measurement;
            for (int i = 0; i < 2500; ++i)
                measurement.targets.push_back(i);
            for (int j = 0; j < 4; ++j)
                measurement.runs.push_back({j % 2 == 0 ? Direction::positive : Direction::negative,
                                            std::vector<std::optional<double>>(2500, 1e-4 * j)});
            for (int k = 0; k < count; ++k) {
                measurement.runs[k % 4].deviations[k / 4].reset();
                measurement.excluded.push_back({k % 4 + 1, k / 4 + 1, 0.01, "dust"});
            }
            Test test;
            test.edition = "ISO 230-2:2014";
            test.measurement = measurement;
            for (const bool all : {false, true}) {
                Document whole;
                whole.tests.push_back(std::make_shared<const Test>(test));
                if (all)
                    whole.report.include.push_back(ReportExtra::allReadings);
                const Report made = composeReport(evaluate(std::make_shared<const Document>(whole)),
                                                  Language(Language::Id::english), {});
                int rows = 0;
                int counted = 0;
                for (std::size_t k = 0; k < made.blocks.size(); ++k) {
                    const auto *table = std::get_if<Table>(&made.blocks[k]);
                    if (!table || table->columns.back().title.plain() != "Reason")
                        continue;
                    rows = int(table->rows.size());
                    if (const auto *next = std::get_if<Paragraph>(&made.blocks.at(k + 1)))
                        counted =
                            next->text.section("Left out: ", 1).section(u' ', 0, 0).remove(u'\u202f').toInt();
                }
                QCOMPARE(rows, all ? count : std::min(count, 2000));
                QCOMPARE(counted, count - rows);
            }
        }
    }

    /// In the block that is never split names are bounded; whole they stand elsewhere.
    void namesOfSignersAreBounded() {
        for (const int size : {159, 160, 161, 4096}) {
            for (const QString &letter :
                 {QString("W"), QString("é "), QString::fromUtf8("\xF0\x9D\x94\x9C")}) {
                const QString name = letter.repeated(size / letter.size()).trimmed();
                Document named = *document("limits-2006");
                named.report.operatorName = name.toStdString();
                named.report.authorisedBy = {name.toStdString(), name.toStdString()};
                named.report.signatures = {Signer::operatorSigns, Signer::laboratory};
                const Report made = composeReport(evaluate(std::make_shared<const Document>(named)),
                                                  Language(Language::Id::french), {});
                QCOMPARE(pageText(made).count(name) >= 2, true);
                for (const Block &block : made.blocks) {
                    const auto *signatures = std::get_if<Signatures>(&block);
                    for (std::size_t c = 0; signatures && c < signatures->columns.size(); ++c) {
                        const QString shown = signatures->columns[c].lines[0].value;
                        QVERIFY(shown.size() <= 161 && shown.size() > 150);
                        QVERIFY(shown.isValidUtf16());
                        QCOMPARE(shown.endsWith(u'…'), name.size() > 160 || c == 1);
                    }
                }
            }
        }
    }

    /// A report of many readings holds figures of few points: it is copied, and paper shows no more.
    void figuresOfManyReadingsAreThin() {
        PositioningMeasurement measurement;
        for (int i = 0; i < 20000; ++i)
            measurement.targets.push_back(i);
        for (int j = 0; j < 4; ++j) {
            measurement.runs.push_back({j % 2 == 0 ? Direction::positive : Direction::negative, {}});
            for (int i = 0; i < 20000; ++i)
                measurement.runs.back().deviations.emplace_back((i * 7 + j * 3) % 11 * 1e-4);
        }
        Test test;
        test.edition = "ISO 230-2:2006";
        test.measurement = measurement;
        Document whole;
        whole.tests.push_back(std::make_shared<const Test>(test));
        const Report made = composeReport(evaluate(std::make_shared<const Document>(whole)),
                                          Language(Language::Id::english), {});
        int figures = 0;
        for (const Block &block : made.blocks) {
            const auto *figure = std::get_if<FigureBlock>(&block);
            if (!figure)
                continue;
            ++figures;
            const auto &curves = std::get<CurveFigure>(*figure->figure);
            QVERIFY(curves.readings.size() <= 4000);
            for (const Curve &curve : curves.curves)
                QVERIFY(curve.points.size() <= 8000);
        }
        QCOMPARE(figures, 1);
    }

    void everyTermOfTheEditionsIsTranslated() {
        for (const Language::Id id : both) {
            const Language language(id);
            for (const Edition *edition : editions()) {
                for (const Text &words : {edition->title, edition->standardCycle, edition->stepCycle})
                    QVERIFY2(words.empty() || language.hasTranslation(words), words.source);
                for (const Row &row : edition->rows)
                    QVERIFY2(language.hasTranslation(row.term.name), row.term.name.source);
                if (edition->circles) {
                    for (const CircularRow &row : edition->circles->rows)
                        QVERIFY2(language.hasTranslation(row.term.name), row.term.name.source);
                    for (const CircularRequirement &row : edition->circles->requirements)
                        QVERIFY2(row.name.empty() || language.hasTranslation(row.name), row.id);
                }
                for (const Requirement &row : edition->requirements)
                    QVERIFY2(row.name.empty() || language.hasTranslation(row.name), row.id);
                for (const TargetTerm &term : edition->targetTerms)
                    QVERIFY2(language.hasTranslation(term.name), term.name.source);
                for (const AgreementPoint &point : edition->points)
                    QVERIFY2(language.hasTranslation(point.name), point.name.source);
            }
        }
    }

    void tablesAreComplete_data() { addDocuments(); }
    void tablesAreComplete() {
        QFETCH(QString, name);
        const double textWidth = 175; // mm, A4
        for (const Table &table : tablesOf(report(document(name), Language(Language::Id::french)))) {
            double width = 0;
            std::size_t titles = 0;
            for (const Column &column : table.columns) {
                width += column.width + column.gapBefore;
                titles += column.title.plain().isEmpty() && column.unit.isEmpty() ? 0 : 1;
            }
            QVERIFY2(width <= textWidth + 1e-9, qPrintable(QString::number(width)));
            QVERIFY(titles > 0 || table.headless);
            QVERIFY(table.rowCount() > 0);
            table.eachRow([&](const std::vector<Cell> &row) { QCOMPARE(row.size(), table.columns.size()); });
            QVERIFY(std::ranges::is_sorted(table.rulesAfter));
            table.eachRow([&](const std::vector<Cell> &row) {
                for (std::size_t i = 0; i < row.size(); ++i)
                    QVERIFY(i + row[i].extras->columns <= table.columns.size());
            });
            for (const std::size_t row : table.rulesAfter)
                QVERIFY(row + 1 < table.rowCount());
        }
    }

    void twoTestsBeginWithASummary() {
        const Report composed = report(document("two-tests"), Language(Language::Id::english));
        const auto heads = blocksOf<TestHead>(composed);
        QCOMPARE(heads.size(), std::size_t(4)); // the drift test has no page; the last is that of the annex
        QCOMPARE(heads[0].subtitle, "Summary of 2 tests · ISO 230-2:2006 and ISO 230-2:2014");
        QVERIFY(heads[1].numberNotes.contains("Test 1 of 2"));
        const auto lines = blocksOf<VerdictLine>(composed);
        QCOMPARE(lines.size(), std::size_t(3));
        QVERIFY(lines[0].large && lines[0].mark == markOf(*evaluate(document("two-tests")).verdict()));
        QVERIFY(composed.paper == Paper::letter);
        QVERIFY(headingsOf(composed).contains("Drift tests"));
    }

    /// "CONFORM" never stands large above a requirement that is unmet or was not declared.
    void theLargeWordKnowsTheRequirements_data() {
        QTest::addColumn<int>("shielded"); // −1: not declared
        QTest::addColumn<double>("limit"); // of A, mm
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("inFrench");
        QTest::newRow("all met") << 1 << 1.0 << "CONFORMS"
                                 << "CONFORME";
        QTest::newRow("limit exceeded") << 1 << 0.001 << "DOES NOT CONFORM"
                                        << "NON CONFORME";
        QTest::newRow("not declared") << -1 << 1.0 << "LIMITS MET"
                                      << "LIMITES RESPECTÉES";
        QTest::newRow("not declared, limit exceeded") << -1 << 0.001 << "LIMITS EXCEEDED"
                                                      << "LIMITES DÉPASSÉES";
        QTest::newRow("unmet") << 0 << 1.0 << "NO VERDICT"
                               << "SANS VERDICT";
        QTest::newRow("unmet, limit exceeded") << 0 << 0.001 << "LIMITS EXCEEDED"
                                               << "LIMITES DÉPASSÉES";
    }
    void theLargeWordKnowsTheRequirements() {
        QFETCH(int, shielded);
        QFETCH(double, limit);
        QFETCH(QString, word);
        QFETCH(QString, inFrench);
        Document changed = *document("long-axis-with-zone");
        Test test = *changed.tests[1];
        auto &declared = std::get<PositioningMeasurement>(test.measurement).conditions.common.shielded;
        declared = shielded < 0 ? std::nullopt : std::optional(shielded > 0);
        test.limits = {{"A", {limit, {}, ""}}};
        Test whole = *changed.tests[0];
        changed.tests = {std::make_shared<const Test>(test), std::make_shared<const Test>(whole)};
        const auto shared = std::make_shared<const Document>(changed);
        QCOMPARE(blocksOf<VerdictLine>(report(shared, Language(Language::Id::english)))[1].word, word);
        const auto lines = blocksOf<VerdictLine>(report(shared, Language(Language::Id::french)));
        QCOMPARE(lines[1].word, inFrench);
        QCOMPARE(lines[0].word, inFrench); // the other test is all right
        QCOMPARE(lines[1].mark == Mark::check, shielded == 1 && limit == 1.0);
        const Mark expected = limit == 1.0 ? shielded == 1 ? Mark::check : Mark::warning : Mark::cross;
        QVERIFY(lines[1].mark == expected);
    }

    /// Tests as found are printed for information where there are others.
    void theVerdictRestsOnTestsAsLeft() {
        Document changed = *document("long-axis-with-zone");
        const auto evaluated = [&](TestRole first, TestRole second) {
            std::vector<Test> tests{*changed.tests[0], *changed.tests[1]};
            tests[0].role = first;
            tests[0].limits = {{"E", {0.001, {}, ""}}}; // exceeded
            tests[1].role = second;
            Document document = changed;
            document.tests = {std::make_shared<const Test>(tests[0]), std::make_shared<const Test>(tests[1])};
            return std::make_shared<const Document>(document);
        };
        using enum TestRole;
        QCOMPARE(evaluate(evaluated(notStated, asLeft)).verdict(), Verdict::doesNotConform);
        QCOMPARE(evaluate(evaluated(asFound, asLeft)).verdict(), Verdict::conforms);
        QCOMPARE(evaluate(evaluated(asFound, notStated)).verdict(), Verdict::conforms);
        QCOMPARE(evaluate(evaluated(asFound, asFound)).verdict(), Verdict::doesNotConform);
        const Report composed = report(evaluated(asFound, asLeft), Language(Language::Id::english));
        QCOMPARE(blocksOf<VerdictLine>(composed)[0].word, "CONFORMS");
        QCOMPARE(blocksOf<VerdictLine>(composed)[1].word, "DOES NOT CONFORM");
        const Cell information = blocksOf<Table>(composed)[0].rows[0][1];
        QVERIFY(information.pale);
        QCOMPARE(information.extras->notes.back().text, "for information, not part of the verdict");
        // They count where all tests are spoken of.
        auto found = std::make_shared<Document>(*evaluated(asFound, asLeft));
        Test incomplete = *found->tests[0];
        std::get<PositioningMeasurement>(incomplete.measurement).conditions.common.complete = false;
        found->tests[0] = std::make_shared<const Test>(incomplete);
        const VerdictLine line = blocksOf<VerdictLine>(report(found, Language(Language::Id::english)))[0];
        QVERIFY2(line.accordance.text.plain().contains("; not: 1"), qPrintable(line.accordance.text.plain()));
    }

    /// Quantity by quantity: symbol, value, U, limit and verdict as on the page of the test.
    void theSummaryListsEveryLimitedQuantity() {
        Document changed = *document("limits-2006");
        Test found = *changed.tests[0];
        Test left = found;
        found.role = TestRole::asFound;
        left.role = TestRole::asLeft;
        changed.report.adjustments = "pitch table renewed";
        changed.tests = {std::make_shared<const Test>(found), std::make_shared<const Test>(left)};
        for (const Language::Id id : both) {
            const Report composed = report(std::make_shared<const Document>(changed), Language(id));
            const auto tables = blocksOf<Table>(composed);
            const Table &summary = tables[0];
            QStringList limited;
            for (const auto &row : tables[1].rows) { // the results of the first test
                if (row.back().mark != Mark::none)
                    limited << row[0].text.plain() + row[3].text.plain() + row[4].text.plain() +
                                   row[5].text.plain() + row.back().text.plain();
            }
            QCOMPARE(limited.size(), qsizetype(3));        // A, R, B
            QCOMPARE(summary.rows.size(), std::size_t(7)); // twice these, and the adjustment between
            QVERIFY(summary.rows[3][1].text.plain().endsWith("pitch table renewed"));
            for (std::size_t i = 0; i < summary.rows.size(); ++i) {
                const auto &row = summary.rows[i];
                const bool adjustment = i == 3;
                QCOMPARE(row.size(), summary.columns.size());
                if (adjustment)
                    continue;
                QCOMPARE(row[2].text.plain() + row[4].text.plain() + row[5].text.plain() +
                             row[6].text.plain() + row[8].text.plain(),
                         limited[static_cast<qsizetype>(i % 4)]);
                QVERIFY(row[7].extras->guard.has_value());
                QCOMPARE(row[4].pale, i < 3);
                QCOMPARE(row[4].bold, i > 3);
                QCOMPARE(summary.links[i], QString(i < 3 ? "test-1" : "test-2"));
            }
            QCOMPARE(summary.rows[0][1].extras->rows, std::size_t(3));
            QVERIFY(summary.columns[9].pages);
        }
    }

    /// Columns without content are left out, and the line of a test without a limit ends before its page.
    void theSummaryNamesThePageOfEveryTest() {
        Document changed = *document("limits-2006");
        Test second = *changed.tests[0];
        second.limits = {};
        second.role = TestRole::asLeft;
        changed.tests.push_back(std::make_shared<const Test>(second));
        for (const Language::Id id : both) {
            const Report composed = report(std::make_shared<const Document>(changed), Language(id));
            const Table summary = blocksOf<Table>(composed)[0];
            const auto &row = summary.rows.back();
            QVERIFY(summary.columns.back().pages && !row.back().blank);
            QVERIFY(row[2].extras->columns > 1);
            QCOMPARE(2 + row[2].extras->columns + 1, summary.columns.size());
        }
    }

    /// How U was evaluated is said only where this program evaluated one.
    void onlyAnEvaluatedUncertaintyIsSaidToBeOne() {
        const QString words = "Expanded uncertainties are evaluated according to the GUM";
        const Language english(Language::Id::english);
        QVERIFY(text(document("budget-2006"), english).contains(words));
        QVERIFY(!text(document("limits-2006"), english).contains(words)); // stated by the laboratory
        Document changed = *document("budget-2006");
        Test test = *changed.tests[0];
        std::get<PositioningMeasurement>(test.measurement).uncertainty.misalignmentRange.reset();
        changed.tests = {std::make_shared<const Test>(test)};
        QVERIFY(!text(std::make_shared<const Document>(changed), english).contains(words)); // no U
    }

    /// An upper bound that is rounded down is none.
    void theSpreadOfSimulatedUncertaintiesIsRoundedUp() {
        EvaluatedDocument evaluated = evaluate(document("budget-2006"));
        auto drawn = simulation(evaluated, 0);
        drawn->of = evaluated.document->tests[0];
        evaluated = withSimulation(evaluated, 0, std::move(*drawn));
        const Language english(Language::Id::english);
        const Writer write(english);
        for (const auto &[error, words] :
             {std::pair{1e-9, "at most 0.01 µm."}, {2.1e-5, "at most 0.05 µm."}}) {
            TestEvaluation evaluation = *evaluated.tests[0];
            for (Parameter &parameter : evaluation.parameters) {
                if (parameter.simulated)
                    parameter.simulated->expandedError = error;
            }
            const TestPart part{write, evaluated, *evaluated.document->tests[0], evaluation, 0, 1, 1};
            QString said = methodText(part);
            QVERIFY2(said.replace(QChar(u'\u00A0'), ' ').contains(words), qPrintable(said));
        }
    }

    /// A row without a tolerance is named, whether its number is its own or that of a test.
    void everyRowWithoutAToleranceIsNamed() {
        Document changed = *document("machine-acceptance-sheet");
        SheetRow own;
        own.number = "G8";
        own.measured = 0.003;
        SheetRow ofTest;
        ofTest.number = "P2";
        ofTest.from = SheetSource{"x1", "M"};
        changed.report.sheet.push_back(own);
        changed.report.sheet.push_back(ofTest);
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(changed));
        const Language english(Language::Id::english);
        const VerdictStatement said = sheetStatement(evaluated, Writer(english));
        QVERIFY2(said.text.plain().contains("G8, P2: no tolerance"), qPrintable(said.text.plain()));
    }

    /// A row beyond its tolerance is named with the band by which it was judged, which is a part of U.
    void aSheetStatesTheBandOfItsRule() {
        Document changed = *document("machine-acceptance-sheet");
        SheetRow own;
        own.number = "G8";
        own.permitted.high = 0.03;
        own.measured = 0.0323;
        own.uncertainty = 0.004;
        changed.report.sheet = {own};
        changed.report.decisionRule = {Rule::iso14253_1, 0.5};
        const Language english(Language::Id::english);
        const auto said = [&] {
            return text(std::make_shared<const Document>(changed), english).simplified();
        };
        QVERIFY(said().contains("for 0.0300 ± 0.0020"));
        QVERIFY(said().contains("Limit ± g") && said().contains("guard band 0.5 U"));
        changed.report.decisionRule.rule = Rule::simpleAcceptance;
        QVERIFY(!said().contains("guard band 0.5 U"));
    }

    /// A limit that cannot be evaluated has its row on the summary page and in the tables of the command
    /// line.
    void limitsThatCannotBeEvaluatedAreListed() {
        Document changed = *document("two-tests");
        Test test = *changed.tests[0];
        test.edition = "ISO 230-2:2006";
        test.limits = {{"UPR", {0.011, {}, ""}}, {"E", {0.013, "ISO 230-2:1988", ""}}};
        changed.tests[0] = std::make_shared<const Test>(test);
        const auto shared = std::make_shared<const Document>(changed);
        const Language english(Language::Id::english);
        const QString page = text(shared, english).simplified().replace(QChar(u'\u00A0'), ' ');
        QVERIFY(page.contains("limit 11 µm not evaluable: not a parameter of this test"));
        QVERIFY(page.contains("limit 13 µm not evaluable: agreed for another edition"));
        for (const SummaryForm form : {SummaryForm::csv, SummaryForm::text}) {
            const bool csv = form == SummaryForm::csv;
            QStringList open;
            for (const QStringList &row : summaryRows(evaluate(shared), "file", form, english)) {
                if (row[row.size() - 2] == (csv ? "notEvaluable" : "not evaluable"))
                    open << row[row.size() - 7] + ' ' + row[row.size() - 4];
            }
            QCOMPARE(open, (csv ? QStringList{"E 0.013", "UPR 0.011"} : QStringList{"E 13", "UPR 11"}));
        }
    }

    /// The row of a limit that is not the one of its result says its state.
    void aSecondLimitHasItsState() {
        Document changed = *document("iso230-4-full-circles-xy");
        Test test = *changed.tests[0];
        std::get<CircularMeasurement>(test.measurement).referenceLength.calibrated = true;
        test.limits = {{"F", {0.013, {}, ""}}, {"Fmax", {0.012, {}, ""}}, {"Fmin", {-0.012, {}, ""}}};
        test.decisionRule = {};
        changed.tests = {std::make_shared<const Test>(test), std::make_shared<const Test>(test)};
        const QString page =
            text(std::make_shared<const Document>(changed), Language(Language::Id::english)).simplified();
        QVERIFY2(QString(page).replace(QChar(u'\u00A0'), ' ').contains("limit 13 µm: exceeded"),
                 qPrintable(page));
    }

    /// A statement on a rotary axis is printed, in a joint table as in that of one test.
    void theCorrectionOfARotaryAxisIsPrinted() {
        Document changed = *document("rotary-axis");
        const Language english(Language::Id::english);
        const auto joint = [&] {
            return text(std::make_shared<const Document>(changed), english).simplified();
        };
        QVERIFY(joint().contains("Correction to 20 °C: not applied."));
        changed.tests.push_back(changed.tests.front());
        QVERIFY(joint().contains("Correction to 20 °C all not applied"));
        Test test = *changed.tests[0];
        std::get<PositioningMeasurement>(test.measurement).conditions.common.correctionTo20 =
            CorrectionTo20::notStated;
        changed.tests = {std::make_shared<const Test>(test)};
        QVERIFY(!joint().contains("Correction to 20 °C:"));
    }

    /// A range like "11–14," is a word that no line breaks: its column is as wide.
    void rangesOfTestNumbersFitTheirColumn() {
        constexpr double digit = 1.667; // mm, of Liberation Sans at 8.5 pt; a dash is as wide
        Document changed = *document("limits-2006");
        Test test = *changed.tests[0];
        changed.tests.clear();
        for (int i = 0; i < 124; ++i) {
            const bool other = i % 10 == 4 || i % 7 == 0;
            std::get<PositioningMeasurement>(test.measurement).conditions.feed = other ? 1000 : 3000;
            changed.tests.push_back(std::make_shared<const Test>(test));
        }
        int ranges = 0;
        double widest = 0;
        const Language english(Language::Id::english);
        for (const Table &table : tablesOf(report(std::make_shared<const Document>(changed), english))) {
            for (std::size_t i = 0; i < table.columns.size(); ++i) {
                if (table.columns[i].title.plain() != "Tests")
                    continue;
                for (const std::vector<Cell> &row : table.rows) {
                    for (const QString &range : row[i].text.plain().split(' ')) {
                        const double least = 2 + digit * static_cast<double>(range.size());
                        QVERIFY2(table.columns[i].width >= least, qPrintable(range));
                        ranges += range.contains(QChar(u'\u2013')) ? 1 : 0;
                        widest = std::max(widest, least);
                    }
                }
            }
        }
        QVERIFY(ranges > 10 && widest > 15);
    }

    /// What both tests say word for word stands once.
    void whatTestsHaveInCommonIsPrintedOnce() {
        Document changed = *document("limits-2006");
        Test second = *changed.tests[0];
        std::get<PositioningMeasurement>(second.measurement).axis.name = "Y";
        changed.tests.push_back(std::make_shared<const Test>(second));
        const Report composed =
            report(std::make_shared<const Document>(changed), Language(Language::Id::english));
        const QString all = pageText(composed);
        QCOMPARE(all.count("Warm-up  "), qsizetype(2)); // a condition, and a point to be agreed
        QCOMPARE(headingsOf(composed).count("Points to be agreed"), qsizetype(1));
        QCOMPARE(headingsOf(composed).count("Test conditions"), qsizetype(1));
        QCOMPARE(headingsOf(composed).count("Limits and decision rule"), qsizetype(1));
        QVERIFY(all.contains("As for test 1: "));
        QCOMPARE(headingsOf(composed).count("Readings"), qsizetype(1));      // the same readings
        for (const char *one : {"Findings of test 1", "Findings of test 2"}) // each verdict points to its own
            QCOMPARE(headingsOf(composed).count(one), qsizetype(1));
    }

    void noNameOfAFieldStandsForASymbol_data() { addDocuments(); }
    void noNameOfAFieldStandsForASymbol() {
        QFETCH(QString, name);
        static const QRegularExpression raw("[A-Za-z)]_[A-Z]{2}");
        for (const Language::Id id : both) {
            const auto found = raw.match(pageText(report(document(name), Language(id))));
            QVERIFY2(!found.hasMatch(), qPrintable(found.captured()));
        }
    }

    /// VDI/DGQ 3441 has U_i and Ps_i in the place of B_i and R_i.
    void vdiHasItsOwnQuantitiesPerTarget() {
        Document changed = *document("limits-2006");
        Test test = *changed.tests[0];
        test.edition = "VDI/DGQ 3441:1977";
        test.limits.clear();
        changed.report.editions.clear();
        changed.tests[0] = std::make_shared<const Test>(test);
        const Report composed =
            report(std::make_shared<const Document>(changed), Language(Language::Id::english));
        for (const Table &table : blocksOf<Table>(composed)) {
            QStringList titles;
            for (const Column &column : table.columns)
                titles << column.title.plain();
            if (!titles.contains("si↑"))
                continue;
            QVERIFY2(titles.contains("Ui") && titles.contains("Psi"), qPrintable(titles.join(' ')));
            QVERIFY2(!titles.contains("Ri") && !titles.contains("Bi"), qPrintable(titles.join(' ')));
            const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(changed));
            const auto &results = std::get<PositioningResults>(evaluated.tests[0]->results);
            const qsizetype scatter = titles.indexOf("Psi");
            const TargetStatistics &first = results.targets[0];
            QCOMPARE(table.rows[0][static_cast<std::size_t>(scatter)].text.plain().toDouble(),
                     std::round(3 * (first.positive.s + first.negative.s) * 1e5) / 100);
            return;
        }
        QFAIL("no table per target");
    }

    void oneTestHasNoSummary() {
        QCOMPARE(blocksOf<TestHead>(report(document("rotary-axis"), Language(Language::Id::english))).size(),
                 std::size_t(2)); // and that of the annex
    }

    void aStepCycleWithoutAgreementIsNoAcceptance() {
        const auto heads = blocksOf<TestHead>(report(document("two-tests"), Language(Language::Id::french)));
        QCOMPARE(heads[1].notice, "cycle en pas – résultat non utilisable en référence à l’ISO 230-2");
        QCOMPARE(heads[2].notice, QString());
    }

    /// No report calls itself one of an acceptance unless its file says so.
    void theTitleKnowsThePurpose() {
        const auto titleFor = [](Purpose purpose) {
            Document changed = *document("long-axis-with-zone");
            changed.report.title.clear();
            for (auto &test : changed.tests) {
                Test stated = *test;
                stated.purpose = purpose;
                test = std::make_shared<const Test>(stated);
            }
            return report(std::make_shared<const Document>(changed), Language(Language::Id::english)).title;
        };
        QVERIFY(titleFor(Purpose::acceptance).startsWith("Acceptance test report"));
        for (const Purpose purpose :
             {Purpose::notStated, Purpose::periodic, Purpose::afterCollision, Purpose::comparison})
            QVERIFY(titleFor(purpose).startsWith("Test report"));
    }

    void theTitleOfTheFileReplacesOurs() {
        Document changed = *document("limits-2006");
        const auto titleOf = [](const Document &document) {
            return blocksOf<TestHead>(
                       report(std::make_shared<const Document>(document), Language(Language::Id::french)))[0]
                .title;
        };
        QCOMPARE(titleOf(changed), "Rapport d’essai");
        changed.report.title = "Titre du client";
        QCOMPARE(titleOf(changed), "Titre du client");
    }

    void leavesOutWhatIsNotWanted_data() {
        QTest::addColumn<int>("part");
        QTest::addColumn<QString>("heading");
        QTest::newRow("readings") << int(ReportPart::readings) << "Readings";
        QTest::newRow("table per target") << int(ReportPart::targetTable) << "Results per target position";
        QTest::newRow("findings") << int(ReportPart::findings) << "Findings";
        QTest::newRow("signatures") << int(ReportPart::signatures) << "Responsibility and signatures";
        QTest::newRow("annex") << int(ReportPart::annex) << "Results per target position";
    }
    void leavesOutWhatIsNotWanted() {
        QFETCH(int, part);
        QFETCH(QString, heading);
        Document changed = *document("limits-2006");
        const Language english(Language::Id::english);
        QVERIFY(headingsOf(report(std::make_shared<const Document>(changed), english)).contains(heading));
        changed.report.leaveOut = {ReportPart(part)};
        const Report composed = report(std::make_shared<const Document>(changed), english);
        QVERIFY(!headingsOf(composed).contains(heading));
        // No line points to a page that is not there.
        for (const VerdictLine &line : blocksOf<VerdictLine>(composed))
            QVERIFY(line.anchor.isEmpty() || headingsOf(composed).contains("Findings"));
    }

    /// Alone it says all that a report has to say: who signs, the program, the whole fingerprint.
    void theCertificateStandsAlone() {
        for (const char *name : {"limits-2006", "two-tests"}) {
            Document changed = *document(name);
            const Language english(Language::Id::english);
            const auto annexes = [](const Report &report) {
                return std::ranges::count_if(blocksOf<TestHead>(report), &TestHead::annex);
            };
            const Report whole = report(std::make_shared<const Document>(changed), english);
            QCOMPARE(annexes(whole), 1);
            QVERIFY(whole.making.annex);
            QCOMPARE(blocksOf<EndMark>(whole).front().anchor, "annex");
            changed.report.leaveOut = {ReportPart::annex};
            const auto alone = std::make_shared<const Document>(changed);
            const Report certificate = report(alone, english);
            QCOMPARE(annexes(certificate), 0);
            QVERIFY(!certificate.making.annex);
            const QString text = pageText(certificate);
            for (const QString &needed :
                 {QString("Responsibility and signatures"), QString("Limits and decision rule"),
                  certificate.fingerprint, QString("self-test against reference data passed")})
                QVERIFY2(text.contains(needed), qPrintable(needed));
            for (const char *ofTheAnnex : {"Readings", "Uncertainty budget", "Annex"})
                QVERIFY2(!headingsOf(certificate).contains(ofTheAnnex), ofTheAnnex);
            // Whatever the file says, an option has the same effect.
            changed.report.leaveOut = {};
            const auto file = std::make_shared<const Document>(changed);
            QVERIFY(
                !composeReport(evaluate(file), english, {"Palmer " PALMER_VERSION, true, {}, {}, {}, false})
                     .making.annex);
        }
    }

    void everyInstrumentSaysWhatItIsTraceableTo() {
        Document changed = *document("two-tests");
        changed.instruments.assign(3, {});
        Instrument &laser = changed.instruments[0];
        laser.description = "laser";
        laser.serialNumber = "55";
        laser.certificate = "C-1";
        laser.calibratedBy = "Institute";
        laser.traceability = {"Cofrac", "2-0042", "T-9"};
        changed.instruments[1].traceability.laboratory = "PTB";
        for (std::size_t i = 0; i < 3; ++i)
            changed.instruments[i].id = std::to_string(i);
        for (const auto &[language, first, second] :
             {std::tuple(Language::Id::english, "traceable to Cofrac, accreditation 2-0042, certificate T-9",
                         "traceable to PTB"),
              std::tuple(Language::Id::french, "raccordé à Cofrac, accréditation 2-0042, certificat T-9",
                         "raccordé à PTB")}) {
            const Report composed = report(std::make_shared<const Document>(changed), Language(language));
            const std::vector<Table> tables = blocksOf<Table>(composed);
            const auto instruments = std::ranges::find_if(tables, [](const Table &table) {
                return !table.rows.empty() && table.rows[0].front().text.plain().startsWith("laser");
            });
            QVERIFY(instruments != tables.end());
            QStringList row;
            for (const Cell &cell : instruments->rows[0])
                row << cell.text.plain();
            for (const char *stated : {"55", "C-1", "Institute"})
                QVERIFY2(row.contains(stated), qPrintable(row.join("; ")));
            QCOMPARE(instruments->rows[0].front().extras->notes.front().text, first);
            QCOMPARE(instruments->rows[1].front().extras->notes.front().text, second);
            QVERIFY(instruments->rows[2].front().extras->notes.empty());
        }
    }

    void theDriftCurveStandsBesideTheBudgetThatTakesIt() {
        Document changed = *document("budget-2006");
        Test test = *changed.tests[0];
        auto &inputs = std::get<PositioningMeasurement>(test.measurement).uncertainty;
        Test drift;
        drift.id = "d1";
        DriftMeasurement readings;
        readings.axis.name = "X";
        readings.times = {0, 600, 1200};
        readings.deviations = {0, 0.0016, 0.0004};
        drift.measurement = readings;
        const auto driftCurves = [&] {
            changed.tests = {std::make_shared<const Test>(test), std::make_shared<const Test>(drift)};
            const Report composed =
                report(std::make_shared<const Document>(changed), Language(Language::Id::english));
            int count = 0;
            for (const FigureBlock &block : blocksOf<FigureBlock>(composed)) {
                const auto *figure = std::get_if<CurveFigure>(&*block.figure);
                count += figure && !figure->curves.empty() && figure->curves[0].role == CurveRole::drift;
            }
            return count;
        };
        inputs.driftTest = "d1";
        QCOMPARE(driftCurves(), 0); // what is typed in wins
        inputs.environmentalVariation.reset();
        QCOMPARE(driftCurves(), 1);
        changed.report.leaveOut = {ReportPart::uncertainty};
        QCOMPARE(driftCurves(), 0);
    }

    void readingMarksAndMeanRepeatabilityOnRequest() {
        Document changed = *document("iso230-2-1988-example");
        const Language english(Language::Id::english);
        const auto figureOf = [&](const Document &document) {
            return std::get<CurveFigure>(
                *blocksOf<FigureBlock>(report(std::make_shared<const Document>(document), english))[0]
                     .figure);
        };
        changed.report.include = {};
        QVERIFY(figureOf(changed).readings.empty());
        QVERIFY(!text(std::make_shared<const Document>(changed), english).contains("Mean repeatability"));
        changed.report.include = {ReportExtra::readingMarks, ReportExtra::meanRepeatability};
        QCOMPARE(figureOf(changed).readings.size(), std::size_t(110));
        QVERIFY(text(std::make_shared<const Document>(changed), english).contains("Mean repeatability"));
    }

    void manyRunsStandUpAboveDown() {
        Document changed = *document("limits-2006");
        Test test = *changed.tests[0];
        auto &m = std::get<PositioningMeasurement>(test.measurement);
        const std::vector<Run> runs = m.runs;
        m.runs.insert(m.runs.end(), runs.begin(), runs.end()); // ten each way
        changed.tests[0] = std::make_shared<const Test>(test);
        std::vector<Table> readings;
        for (const Table &table :
             tablesOf(report(std::make_shared<const Document>(changed), Language(Language::Id::english)))) {
            if (!table.spanners.empty())
                readings.push_back(table);
        }
        QCOMPARE(readings.size(), std::size_t(2));
        QCOMPARE(readings[0].spanners[0].title.plain(), "xij↑, µm");
        QCOMPARE(readings[1].spanners[0].title.plain(), "xij↓, µm");
        QCOMPARE(readings[0].spanners[0].count, std::size_t(10));
    }

    void aVerdictAgainstALimitHasItsPicture() {
        for (const Table &table :
             tablesOf(report(document("limits-2006"), Language(Language::Id::english)))) {
            for (const auto &row : table.rows) {
                if (row.size() != 8 || row[0].text.plain() != "R")
                    continue;
                QVERIFY(row[6].extras->guard.has_value());
                QCOMPARE(row[6].extras->guard->limit, 0.007);
                QCOMPARE(*row[6].extras->guard->guardBand, 0.00279);
                QVERIFY(row[7].mark == Mark::cross && row[7].bold);
                QVERIFY(row[3].bold);
                return;
            }
        }
        QFAIL("R does not stand in the results");
    }

    void theFingerprintIsThatOfTheFileWithoutInstrumentFiles() {
        Document changed = *document("limits-2006");
        const Language english(Language::Id::english);
        const QString before = report(std::make_shared<const Document>(changed), english).fingerprint;
        QCOMPARE(before.size(), 64);
        QCOMPARE(before, fingerprint(attachedFile(changed)));
        Test test = *changed.tests[0];
        test.imports[0].data = "AAAA";
        changed.tests[0] = std::make_shared<const Test>(test);
        QCOMPARE(report(std::make_shared<const Document>(changed), english).fingerprint, before);
        test.remarks += ".";
        changed.tests[0] = std::make_shared<const Test>(test);
        QVERIFY(report(std::make_shared<const Document>(changed), english).fingerprint != before);
    }

    void deviationsAwayFrom20AreMarkedAtEachResultTheyFalsify() {
        Document changed = *document("limits-2006");
        Test test = *changed.tests[0];
        std::get<PositioningMeasurement>(test.measurement).conditions.common.correctionTo20 =
            CorrectionTo20::notApplied;
        changed.tests[0] = std::make_shared<const Test>(test);
        const Report composed =
            report(std::make_shared<const Document>(changed), Language(Language::Id::english));
        QStringList marked;
        for (const Table &table : tablesOf(composed)) {
            for (const auto &row : table.rows) {
                if (row.size() == 8 && row[1].text.plain().endsWith("*"))
                    marked << row[0].text.plain();
            }
        }
        QCOMPARE(marked.join(' '), "A A↑ A↓ E E↑ E↓ M");
        const auto legends = blocksOf<ResultsLegend>(composed);
        QCOMPARE(legends.front().items.front().text, "*\u00A0not corrected to 20 °C");
        const VerdictLine line = blocksOf<VerdictLine>(composed).front();
        QVERIFY(line.limits.text.plain().contains("Not corrected to 20 °C") || line.mark == Mark::cross);
    }

    void theReasonOfAVerdictFitsOnTwoLines() {
        Document changed = *document("limits-2006");
        Test test = *changed.tests[0];
        for (const char *id : {"A", "A+", "A-", "E", "E+", "E-", "M", "R", "R+", "R-", "B", "Bmean"})
            test.limits[id] = {0.0001, {}, {}};
        test.decisionRule.rule = Rule::simpleAcceptance;
        changed.tests[0] = std::make_shared<const Test>(test);
        for (const Language::Id id : both) {
            const auto line =
                blocksOf<VerdictLine>(report(std::make_shared<const Document>(changed), Language(id)))[0];
            const QString reason = line.limits.text.plain();
            QVERIFY2(reason.size() <= 190, qPrintable(reason));
            for (const char *symbol : {"A↓", "R↑", "B̄"})
                QVERIFY2(reason.contains(symbol), qPrintable(reason));
        }
    }

    void theExampleSaysWhatIsStandInEvenWithoutFindings() {
        Document changed = *document("iso230-2-1988-example");
        changed.report.leaveOut = {ReportPart::findings};
        QVERIFY(text(std::make_shared<const Document>(changed), Language(Language::Id::english))
                    .contains("ten readings are substitutes with the published mean and s"));
    }

    void limitsThatDoNotHoldAreNoMissingLimits() {
        Document changed = *document("limits-2006");
        Test test = *changed.tests[0];
        const auto lineOf = [&] {
            changed.tests[0] = std::make_shared<const Test>(test);
            return blocksOf<VerdictLine>(
                report(std::make_shared<const Document>(changed), Language(Language::Id::english)))[0];
        };
        for (auto &[id, limit] : test.limits)
            limit.edition = "ISO 230-2:1988";
        QCOMPARE(lineOf().word, "LIMITS NOT PROVEN"); // agreed, and nothing is known of them
        QVERIFY(lineOf().limits.text.plain().contains("(agreed for another edition)"));
        test.limits.clear();
        QCOMPARE(lineOf().word, "NO LIMIT");
        QCOMPARE(lineOf().limits.state, "none agreed");
    }

    void aCircleHasEverythingTheStandardAsksFor() {
        const Language english(Language::Id::english);
        const auto full = document("iso230-4-full-circles-xy");
        const Report composed = report(full, english);
        const QString all = pageText(composed);
        // 4.4 and 6 of ISO 230-4:2005, in the order of the standard.
        for (const char *stated : {"Date of test  20\u00A0November 2026, 10:15",
                                   "Machine  Machining centre, MX, VMC 500",
                                   "Instrument  ballbar, No. 000-150",
                                   "Nominal diameter  300\u00A0mm",
                                   "Feed  1\u202F000\u00A0mm/min",
                                   "Contouring  anticlockwise, clockwise",
                                   "Axes moved  X and Y",
                                   "Centre  X\u00A0250",
                                   "Tool offset  X\u00A00",
                                   "Workpiece offset  X\u00A0250",
                                   "Air  20.6\u00A0°C",
                                   "Instrument  20.5\u00A0°C; α\u00A0=\u00A01.2",
                                   "Machine  20.7\u00A0°C; α\u00A0=\u00A011.5",
                                   "Correction C  −1.1\u00A0µm",
                                   "Captured range  360° per sense",
                                   "Points  1\u202F800 per sense",
                                   "Start, stop  X+; X+",
                                   "Smoothing  none",
                                   "Compensation  pitch table active",
                                   "Other axes  Z 100",
                                   "magnification 1\u202F000:1",
                                   "Circle, G, G(b)  minimum zone",
                                   "Centre, F  least squares",
                                   "proven narrowest"})
            QVERIFY2(all.contains(QString::fromUtf8(stated)), stated);
        QCOMPARE(headingsOf(composed).filter("Repetitions").size(), qsizetype(0));
        const auto headings = headingsOf(report(document("iso230-4-partial-arc-zx"), english));
        QCOMPARE(headings.filter("Repetitions").size(), qsizetype(1));
    }

    void onlyTheResultsAskedForArePrinted() {
        const Language english(Language::Id::english);
        Document changed = *document("iso230-4-full-circles-xy");
        Test test = *changed.tests[0];
        const auto symbols = [&](std::vector<std::string> required) {
            std::get<CircularMeasurement>(test.measurement).requiredResults = std::move(required);
            changed.tests[0] = std::make_shared<const Test>(test);
            QStringList result;
            for (const Table &table : tablesOf(report(std::make_shared<const Document>(changed), english))) {
                if (table.columns.empty() || table.columns[0].title.plain() != "Quantity")
                    continue;
                for (const auto &row : table.rows) {
                    if (row[0].bold)
                        result << row[0].text.plain();
                }
                break; // that of the limits comes later
            }
            return result.join(' ');
        };
        QCOMPARE(symbols({}), "G(b)XY GXY GYX DXY Fmax,XY Fmin,XY Fmax,YX Fmin,YX");
        QCOMPARE(symbols({"D"}), "G(b)XY GXY GYX DXY"); // and what a limit was agreed on
        test.limits = {};
        QCOMPARE(symbols({"G(b)", "D"}), "G(b)XY DXY");
        QCOMPARE(symbols({"F"}), "Fmax,XY Fmin,XY Fmax,YX Fmin,YX");
        // What needs no length needs no temperatures either.
        std::get<CircularMeasurement>(test.measurement).conditions.common.sensors.clear();
        std::get<CircularMeasurement>(test.measurement).conditions.common.expansion = {};
        std::get<CircularMeasurement>(test.measurement).conditions.common.correctionTo20 =
            CorrectionTo20::notStated;
        symbols({"G"});
        const QString all = pageText(report(std::make_shared<const Document>(changed), english));
        QVERIFY(!all.contains("°C"));
        QVERIFY(!all.contains("Reference length"));
    }

    void separateFiguresAreThoseOfTheStandard() {
        const auto figures = [](const Report &report) {
            int count = 0;
            for (const SideBySide &both : blocksOf<SideBySide>(report))
                count += static_cast<int>(std::ranges::count_if(
                    both.left, [](const Part &part) { return std::holds_alternative<FigureBlock>(part); }));
            return count;
        };
        const Language english(Language::Id::english);
        Document changed = *document("iso230-4-full-circles-xy");
        QCOMPARE(figures(report(std::make_shared<const Document>(changed), english)), 1);
        changed.report.figures = CircleFigures::separate;
        QCOMPARE(figures(report(std::make_shared<const Document>(changed), english)), 5); // G(b), G, G, F, F
    }

    void emptyCirclesAreComposed() {
        Document empty;
        Test test;
        test.edition = "ISO 230-4:2005";
        CircularMeasurement m;
        test.measurement = m;
        empty.tests.push_back(std::make_shared<const Test>(test));
        m.arcs.push_back({Sense::clockwise, AngleReference::commanded, {0, -1, -2}, {0, 0, 0}, {}, {}});
        test.measurement = m;
        empty.tests.push_back(std::make_shared<const Test>(test));
        empty.report.figures = CircleFigures::separate;
        empty.report.include = {ReportExtra::repetitions};
        for (const Language::Id id : both) {
            const QString all = pageText(report(std::make_shared<const Document>(empty), Language(id)));
            QVERIFY(all.contains("ISO 230-4:2005"));
            QVERIFY(!all.contains("nan") && !all.contains("inf "));
        }
    }

    void everyKindOfTestHasItsPlace() {
        const auto complete = std::make_shared<const Document>(
            readDocument(content(QString(DOCUMENTS) + "../complete.palmer")));
        const QString text = pageText(report(complete, Language(Language::Id::english)));
        QVERIFY(text.contains("Circular test in the "));
        QVERIFY(text.contains("Drift test of the "));
    }

    void extremeTestsAreComposed_data() {
        QTest::addColumn<int>("targets");
        QTest::addColumn<int>("runs");
        QTest::newRow("no target") << 0 << 0;
        QTest::newRow("targets without runs") << 5 << 0;
        QTest::newRow("one target, one run each way") << 1 << 1;
        QTest::newRow("three targets, thirty runs each way") << 3 << 30;
        QTest::newRow("four hundred targets, ten runs each way") << 400 << 10;
    }
    void extremeTestsAreComposed() {
        QFETCH(int, targets);
        QFETCH(int, runs);
        Document extreme;
        extreme.machine.name = std::string(200, 'M');
        Test test;
        test.edition = "ISO 230-2:2006";
        PositioningMeasurement m; // no conditions at all
        for (int i = 0; i < targets; ++i)
            m.targets.push_back(12.5 * i);
        for (int run = 0; run < 2 * runs; ++run) {
            m.runs.push_back({run % 2 == 0 ? Direction::positive : Direction::negative, {}});
            for (int i = 0; i < targets; ++i)
                m.runs.back().deviations.emplace_back(1e-4 * ((7 * i + 3 * run) % 101 - 50));
        }
        test.measurement = m;
        extreme.tests.push_back(std::make_shared<const Test>(test));
        const auto shared = std::make_shared<const Document>(extreme);
        for (const Language::Id id : both) {
            const Report composed = report(shared, Language(id));
            QVERIFY(pageText(composed).contains(QString(200, 'M')));
            std::size_t readings = 0;
            for (const Table &table : tablesOf(composed)) {
                double width = 0;
                std::size_t sharing = 0;
                for (const Column &column : table.columns) {
                    width += column.width + column.gapBefore;
                    sharing += column.width > 0 || column.flexible ? 0 : 1;
                }
                QVERIFY(width <= 175 + 1e-9);
                for (const Spanner &spanner : table.spanners) {
                    readings += spanner.count * table.rows.size();
                    // Enough room for "−10.25" in each column.
                    const double own = table.columns[spanner.first].width;
                    QVERIFY((own > 0 ? own : (175 - width) / static_cast<double>(sharing)) > 9);
                }
            }
            // One run each way is what the table of targets prints: not twice.
            QCOMPARE(readings, static_cast<std::size_t>(runs > 1 ? 2 * targets * runs : 0));
        }
    }

    void anEmptyDocumentHasAReport() {
        const Report composed = report(std::make_shared<const Document>(), Language(Language::Id::french));
        QVERIFY(pageText(composed).contains("Fin du rapport"));
    }

    /// A figure is drawn about a circle that the edition has, under the name of the results.
    void theCentreOfAFigureIsNamed_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("edition");
        QTest::addColumn<QString>("said");
        QTest::newRow("2005") << "iso230-4-full-circles-xy"
                              << "ISO 230-4:2005"
                              << "minimum zone of G(b).";
        QTest::newRow("1996 has no G(b)") << "iso230-4-full-circles-xy"
                                          << "ISO 230-4:1996"
                                          << "minimum zone of both paths.";
        QTest::newRow("feedback") << "iso230-4-feedback-yz"
                                  << "ISO 230-4:2005"
                                  << "minimum zone of G(b)f.";
    }
    void theCentreOfAFigureIsNamed() {
        QFETCH(QString, name);
        QFETCH(QString, edition);
        QFETCH(QString, said);
        Document changed = *document(name);
        Test test = *changed.tests[0];
        test.edition = edition.toStdString();
        test.limits.clear();
        changed.tests = {std::make_shared<const Test>(test)};
        const QString all = text(std::make_shared<const Document>(changed), Language(Language::Id::english));
        QVERIFY2(all.contains("Figure drawn about the centre of the " + said), qPrintable(all));
        QVERIFY(edition != "ISO 230-4:1996" || !all.contains("G(b)XY"));
    }

    void whatTheInstrumentCorrectedIsCorrected() {
        const auto says = [](CorrectionTo20 correction) {
            Document changed = *document("iso230-4-full-circles-xy");
            Test test = *changed.tests[0];
            std::get<CircularMeasurement>(test.measurement).conditions.common.correctionTo20 = correction;
            changed.tests[0] = std::make_shared<const Test>(test);
            return pageText(
                       report(std::make_shared<const Document>(changed), Language(Language::Id::english)))
                .replace(QChar::Nbsp, ' ')
                .contains("without correction to 20 °C");
        };
        QVERIFY(says(CorrectionTo20::notApplied));
        QVERIFY(!says(CorrectionTo20::appliedByInstrument));
    }

    void symbolsOfSentencesHaveSubscripts() {
        for (const auto &[sentence, subscript] :
             {std::pair("gives no E_VE for", "VE"), std::pair("The limit of G(b)f cannot", "f"),
              std::pair("Gf, H", "f"), std::pair("the range of Gfx", "")}) {
            const Phrase phrase = withSymbols(sentence, {});
            QString lower;
            for (const Span &span : phrase.spans)
                lower += span.subscript ? span.text : QString();
            QCOMPARE(lower, subscript);
        }
    }

    /// Ū and P are other definitions, not other factors.
    void counterpartsDifferByDefinition() {
        Document changed = *document("limits-2006");
        Test test = *changed.tests[0];
        auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        for (Run &run : measurement.runs) {
            if (run.approach == Direction::positive && run.deviations[0])
                *run.deviations[0] -= 0.05; // B changes its sign, so that B̄ is not Ū
        }
        changed.tests = {std::make_shared<const Test>(test)};
        changed.report.editions = {"VDI/DGQ 3441:1977"};
        const QString all =
            pageText(report(std::make_shared<const Document>(changed), Language(Language::Id::english)));
        QVERIFY(!all.contains("Differences by the factor of s"));
        const qsizetype at = all.indexOf("Differences by the definitions of the editions: ");
        QVERIFY(at >= 0);
        QVERIFY(all.mid(at).section('\n', 0, 0).contains("B̄"));
    }

    /// One further edition already makes a table.
    void editionsStandSideBySide() {
        Document both = *document("iso230-2-1988-example");
        const auto columns = [&] {
            const Report composed =
                report(std::make_shared<const Document>(both), Language(Language::Id::english));
            for (std::size_t i = 0; i + 1 < composed.blocks.size(); ++i) {
                const auto *heading = std::get_if<Heading>(&composed.blocks[i]);
                if (heading && heading->text.contains("editions"))
                    return int(std::get<Table>(composed.blocks[i + 1]).columns.size());
            }
            return 0;
        };
        both.report.editions = {};
        QCOMPARE(columns(), 0);
        both.report.editions = {"ISO 230-2:1988"}; // its own alone
        QCOMPARE(columns(), 0);
        both.report.editions = {"ISO 230-2:2006"};
        const int two = columns();
        QVERIFY(two > 2);
        both.report.editions = {"ISO 230-2:2006", "ISO 230-2:2014"};
        QCOMPARE(columns(), two + 1);
    }

    /// The methods of an uncertainty are explained once: later tests say for which.
    void methodsAreExplainedOnce() {
        Document many = *document("budget-2006");
        Test direct = *many.tests[0];
        std::get<PositioningMeasurement>(direct.measurement).uncertainty.method = UncertaintyMethod::direct;
        direct.id.clear();
        Test budget = *many.tests[0];
        budget.id.clear();
        many.tests.clear();
        for (const Test &test : {direct, budget, budget, budget})
            many.tests.push_back(std::make_shared<const Test>(test));
        const QString all =
            pageText(report(std::make_shared<const Document>(many), Language(Language::Id::english)));
        QCOMPARE(all.count("otherwise as for test 2."), 2);
        QVERIFY(!all.contains("otherwise as for test 1."));
        QVERIFY(all.contains("reason: see the findings."));
        many.report.leaveOut = {ReportPart::findings};
        QVERIFY(!pageText(report(std::make_shared<const Document>(many), Language(Language::Id::english)))
                     .contains("see the findings"));
    }
};

QTEST_GUILESS_MAIN(ComposeReportTest)
#include "composereporttest.moc"
