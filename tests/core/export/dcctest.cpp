// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "export/dcc.h"

#include "core/document/completefile.h"
#include "document/documenterror.h"
#include "document/edits.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/writedocument.h"
#include "kernel/evaluation/testevaluation.h"
#include "language/rounding.h"
#include "language/visibletext.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <array>
#include <set>

using namespace palmer;

namespace {

/// States what a certificate is obliged to and an example lacks.
Document stated(Document document) {
    ReportHead &head = document.report;
    const auto state = [](std::string &text, const char *value) {
        if (text.empty())
            text = value;
    };
    state(head.number, "R-1");
    state(head.laboratory.name, "Laboratory");
    state(head.laboratory.country, "FR");
    state(head.authorisedBy.name, "B. Durand");
    state(head.customer.name, "Customer");
    state(head.customer.address, "Street 1\nTown");
    state(head.place, "Hall 2");
    if (!head.performedFrom)
        head.performedFrom = "2026-11-20";
    state(document.machine.name, "M1");
    state(document.machine.manufacturer, "Maker");
    state(document.machine.serialNumber, "123");
    return document;
}

QStringList files() {
    QStringList result{PALMER_SOURCE_DIR "/tests/data/complete.palmer"};
    const QDir examples(EXAMPLES);
    for (const QString &name : examples.entryList({"*.palmer"}))
        result << examples.filePath(name);
    return result;
}

EvaluatedDocument evaluatedFile(const QString &path) {
    return evaluate(std::make_shared<const Document>(stated(openDocument(path))));
}

/// A number of the certificate: element, text; in order.
using Numbers = QList<std::pair<QString, QString>>;

/// For each measurement result the numbers of its first result, which has the parameters.
QList<Numbers> numbersOf(const QByteArray &certificate) {
    QList<Numbers> tests;
    QXmlStreamReader xml(certificate);
    int result = 0;
    QStringList path;
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        if (token == QXmlStreamReader::StartElement) {
            const QString name = xml.name().toString();
            if (name == "measurementResult") {
                tests.append(Numbers());
                result = 0;
            } else if (name == "result") {
                ++result;
            }
            path << name;
            if (result == 1 && path.contains("results") &&
                QStringList{"value", "unit", "uncertainty", "label", "coverageFactor", "coverageProbability",
                            "conformity"}
                    .contains(name)) {
                const bool limit = path.contains("measurementMetaData");
                tests.last().append({(limit ? "limit " : "") + name, xml.readElementText()});
                path.removeLast();
            }
        } else if (token == QXmlStreamReader::EndElement) {
            path.removeLast();
        }
    }
    if (xml.hasError())
        qFatal("no XML: %s", qPrintable(xml.errorString()));
    return tests;
}

double inBase(const QString &number, const QString &unit) {
    const double value = number.toDouble();
    return unit == "\\micro\\metre" ? value / 1000 : unit == "\\arcsecond" ? value / 3600 : value;
}

bool equal(double a, double b) {
    return std::abs(a - b) <= 4e-15 * std::max(std::abs(a), std::abs(b));
}

/// Returns the texts of a certificate, a line for each element.
QString saidIn(const QByteArray &certificate) {
    QString said;
    for (QXmlStreamReader xml(certificate); !xml.atEnd(); xml.readNext())
        said += xml.isCharacters() ? xml.text().toString() : "\n";
    return said;
}

void collectNumbers(const QJsonValue &value, const QString &key,
                    std::vector<std::pair<QString, double>> &numbers) {
    static const QSet<QString> otherwise{"version",      "extensions", "runs",       "arcs",    "series",
                                         "excluded",     "times",      "deviations", "imports", "channels",
                                         "temperatures", "trials",     "range",      "seed"};
    const QJsonObject object = value.toObject();
    for (auto item = object.begin(); item != object.end(); ++item) {
        if (!otherwise.contains(item.key()))
            collectNumbers(item.value(), item.key(), numbers);
    }
    for (const QJsonValue item : value.toArray())
        collectNumbers(item, key, numbers);
    if (value.isDouble())
        numbers.push_back({key, value.toDouble()});
}

/// Collects the texts of the user and the days of a test file: all but the words of the format, which the
/// certificate says in its own, what concerns the paper, and ids.
void collectTexts(const QJsonValue &value, const QString &key, QStringList &texts) {
    static const QSet<QString> otherwise{
        "format", "writtenBy", "extensions", "logo", "mark", "signatures", "languages", "paper", "leaveOut",
        "include", "editions", "figures", "rounding", "id", "instruments[]", "driftTest", "test", "data",
        // words of the format
        "motion", "cycle", "standardDeviation", "kind", "approach", "sense", "angleReference", "source",
        "centring", "referenceCircle", "feedMode", "measures", "correctionTo20", "rule", "method",
        "driftModel", "point", "state", "purpose", "role", "specifiedBy", "instrumentCompensation",
        "quantity", "requiredResults", "unit"};
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto item = object.begin(); item != object.end(); ++item) {
            const bool isInstruments = key == "tests" && item.key() == "instruments";
            if (!otherwise.contains(item.key()) && !isInstruments)
                collectTexts(item.value(), item.key(), texts);
        }
    } else if (value.isArray()) {
        for (const QJsonValue item : value.toArray())
            collectTexts(item, key, texts);
    } else if (value.isString()) {
        texts << value.toString();
    }
}

} // namespace

class DccTest : public QObject {
    Q_OBJECT

private slots:
    void everyValueUncertaintyAndLimitIsInIt_data() { addFiles(); }
    void everyValueUncertaintyAndLimitIsInIt();
    void everyStatedTextIsInIt_data() { addFiles(); }
    void everyStatedTextIsInIt();
    void everyStatedNumberIsInIt_data() { addFiles(); }
    void everyStatedNumberIsInIt();
    void theSchemaTakesIt_data() { addFiles(); }
    void theSchemaTakesIt();
    void unitsAreThoseOfDSi();
    void whatIsMissingIsNamedInOneSentence();
    void conformityOfATestFollowsItsAccordance();
    void textsAreInBothLanguages();
    void aRowNotProvenIsMappedLikeAParameter_data();
    void aRowNotProvenIsMappedLikeAParameter();
    void onlyAnEvaluatedUncertaintyIsSaidToBeOne();
    void aSensorWithoutATemperatureKeepsItsPosition();
    void everyChannelOfADriftHasItsRange();

private:
    static void addFiles() {
        QTest::addColumn<QString>("path");
        for (const QString &path : files())
            QTest::newRow(qPrintable(QFileInfo(path).completeBaseName())) << path;
    }
};

void DccTest::everyValueUncertaintyAndLimitIsInIt() {
    QFETCH(QString, path);
    const EvaluatedDocument evaluated = evaluatedFile(path);
    const QList<Numbers> tests = numbersOf(dcc(evaluated));
    const std::vector<SheetResult> sheet = evaluated.sheet();
    const qsizetype count = qsizetype(evaluated.tests.size());
    QCOMPARE(tests.size(), count + (sheet.empty() ? 0 : 1));
    if (!sheet.empty()) {
        const QString all = QString::fromUtf8(dcc(evaluated));
        for (const SheetResult &row : sheet) {
            if (row.value)
                QVERIFY(all.contains("<si:value>" + QString::number(*row.value, 'g', 15) + "</si:value>") ||
                        row.parameter);
        }
    }
    for (qsizetype i = 0; i < count; ++i) {
        const TestEvaluation &evaluation = *evaluated.tests[static_cast<std::size_t>(i)];
        const Numbers &numbers = tests[i];
        qsizetype at = 0;
        const auto next = [&](const char *element) {
            const bool is = at < numbers.size() && numbers[at].first == element;
            return is ? numbers[at++].second : QString();
        };
        for (const Parameter &parameter : evaluation.parameters) {
            if (!parameter.required && !parameter.limit)
                continue;
            if (parameter.value) {
                QCOMPARE(next("label"), QString::fromStdString(plainSymbol(parameter)));
                const QString value = next("value");
                const QString unit = next("unit");
                QVERIFY2(equal(inBase(value, unit), *parameter.value), qPrintable(value));
                if (parameter.expandedUncertainty) {
                    const QString expanded = next("uncertainty");
                    QVERIFY2(equal(inBase(expanded, unit), *parameter.expandedUncertainty),
                             qPrintable(expanded));
                    QCOMPARE(next("coverageFactor"), "2");
                    QCOMPARE(next("coverageProbability"), "0.95");
                }
            }
            if (parameter.limit && parameter.limit->value) {
                if (parameter.verdict && parameter.value)
                    QCOMPARE(next("limit conformity").isEmpty(), false);
                const QString limit = next("limit value");
                QVERIFY2(equal(inBase(limit, next("limit unit")), *parameter.limit->value),
                         qPrintable(limit));
            }
        }
        if (evaluation.edition)
            QCOMPARE(at, numbers.size());
    }
}

// Not the source of an element is compared but what it says.
void DccTest::everyStatedTextIsInIt() {
    QFETCH(QString, path);
    const EvaluatedDocument evaluated = evaluatedFile(path);
    const QString said = saidIn(dcc(evaluated));
    QStringList texts;
    collectTexts(QJsonDocument::fromJson(writeDocument(*evaluated.document)).object(), {}, texts);
    QVERIFY(texts.size() > 3);
    const Language english(Language::Id::english);
    static const QRegularExpression day("^\\d{4}-\\d\\d-\\d\\d$");
    for (const QString &text : texts) {
        for (const QString &line : visibleText(text).split('\n')) {
            const bool isDay = day.match(line).hasMatch() && said.contains(english.date(line.toStdString()));
            QVERIFY2(isDay || said.contains(line.trimmed()), qPrintable(line));
        }
    }
}

// In the unit of the file or the one shown, of a radius the diameter; readings, temperatures over time and
// how to simulate are not in it.
void DccTest::everyStatedNumberIsInIt() {
    QFETCH(QString, path);
    const EvaluatedDocument evaluated = evaluatedFile(path);
    std::set<double> numbers;
    static const QRegularExpression number("-?\\d[\\d ]*(?:[.,]\\d+)?");
    for (const QString &piece : saidIn(dcc(evaluated))
                                    .replace(u'−', '-')
                                    .replace(u'\u00A0', ' ')
                                    .replace(u'\u202F', ' ')
                                    .split('\n')) {
        for (auto match = number.globalMatch(piece); match.hasNext();) {
            const QString text = match.next().captured().replace(',', '.');
            numbers.insert(QString(text).remove(' ').toDouble());
            for (const QString &part : text.split(' '))
                numbers.insert(part.toDouble());
        }
    }
    std::vector<std::pair<QString, double>> stated;
    collectNumbers(QJsonDocument::fromJson(writeDocument(*evaluated.document)).object(), {}, stated);
    for (const auto &[key, value] : stated) {
        const bool isIn = std::ranges::any_of(std::array{1.0, 2.0, 1000.0, 3600.0}, [&](double scale) {
            const auto near = numbers.lower_bound(value * scale - 1e-6);
            return near != numbers.end() && *near <= value * scale + 1e-6;
        });
        QVERIFY2(isIn, qPrintable(QString("%1 %2").arg(key).arg(value)));
    }
}

void DccTest::theSchemaTakesIt() {
    if (QByteArray(PALMER_DCC_SCHEMAS).isEmpty())
        QSKIP("without -DPALMER_DCC_SCHEMAS=DIR the certificates are not validated");
    QFETCH(QString, path);
    const QTemporaryDir folder;
    const QString file = folder.filePath("dcc.xml");
    saveBytes(dcc(evaluatedFile(path)), file);
    QProcess xmllint;
    xmllint.start("xmllint", {"--nonet", "--noout", "--schema", PALMER_DCC_SCHEMAS "/dcc_3_2_0.xsd", file});
    QVERIFY(xmllint.waitForFinished(patience));
    QVERIFY2(xmllint.exitCode() == 0, xmllint.readAllStandardError().constData());
}

// The schema takes any text for a unit: prefixes, units and their powers as D-SI 2 names them.
void DccTest::unitsAreThoseOfDSi() {
    const QRegularExpression unit(
        R"(^((\\(micro|milli|hecto|kilo))?\\(one|metre|second|minute|hour|kelvin|degree|arcsecond|arcminute|degreecelsius|pascal|percent)(\\tothe\{-?[1-9]\})?)+$)");
    for (int quantity = 0; quantity <= static_cast<int>(Quantity::percent); ++quantity) {
        const QString name = dsiUnit(static_cast<Quantity>(quantity));
        QVERIFY2(unit.match(name).hasMatch(), qPrintable(name));
    }
    QCOMPARE(dsiUnit(Quantity::deviation), "\\micro\\metre");
    QCOMPARE(dsiUnit(Quantity::angle), "\\degree");
    QCOMPARE(dsiUnit(Quantity::angularDeviation), "\\arcsecond");
    for (const QString &path : files()) {
        for (const Numbers &numbers : numbersOf(dcc(evaluatedFile(path)))) {
            for (const auto &[element, text] : numbers)
                QVERIFY(!element.endsWith("unit") || unit.match(text).hasMatch());
        }
    }
}

void DccTest::whatIsMissingIsNamedInOneSentence() {
    try {
        requireForDcc({std::make_shared<const Document>(), {}, {}, {}}, Language(Language::Id::english));
        QFAIL("nothing is stated");
    } catch (const Error &error) {
        QCOMPARE(Language(Language::Id::english).sentence(error.message),
                 "a digital calibration certificate must also state: number of the report, name of the "
                 "laboratory, country of the laboratory, who authorises the report, customer with address, "
                 "place of the tests, date of the test, name of the machine, manufacturer of the machine, "
                 "serial number of the machine, a test");
    }
    Document document = readDocument(completeFile());
    const auto missing = [&document] {
        std::vector<Text> texts = missingForDcc(evaluate(std::make_shared<const Document>(document)));
        return texts.size() == 1 ? QString(texts.front().source) : QString::number(texts.size());
    };
    QCOMPARE(missing(), "country of the laboratory");
    document.report.laboratory.country = "FR";
    QCOMPARE(missing(), "0");
    editMeasurement<PositioningMeasurement>(document, 0, [](PositioningMeasurement &measurement) {
        measurement.uncertainty.method = UncertaintyMethod::monteCarlo;
    });
    QCOMPARE(missing(), "U after the simulation");
}

// As on page 1 of a report: above an unmet requirement there is no verdict.
void DccTest::conformityOfATestFollowsItsAccordance() {
    const auto conformities = [](const QString &path) {
        const QByteArray certificate = dcc(evaluatedFile(path));
        const qsizetype results = certificate.lastIndexOf("</dcc:results>");
        return certificate.mid(results).count("<dcc:conformity>");
    };
    const EvaluatedDocument evaluated = evaluatedFile(EXAMPLES "iso230-2-1988-example.palmer");
    const Accordance accordance = evaluated.tests[0]->accordance();
    const bool judged = (accordance == Accordance::yes || accordance == Accordance::partly) &&
                        evaluated.tests[0]->verdict.has_value();
    QCOMPARE(conformities(EXAMPLES "iso230-2-1988-example.palmer"), qsizetype(judged ? 1 : 0));
}

void DccTest::textsAreInBothLanguages() {
    const QByteArray certificate = dcc(evaluatedFile(EXAMPLES "iso230-2-1988-example.palmer"));
    QCOMPARE(certificate.count("lang=\"fr\""), certificate.count("lang=\"en\""));
    QVERIFY(certificate.contains("<dcc:content lang=\"fr\">Essai de positionnement de l’axe"));
    QVERIFY(certificate.contains("<dcc:content lang=\"en\">Positioning test of the"));
}

void DccTest::aRowNotProvenIsMappedLikeAParameter_data() {
    QTest::addColumn<double>("measured");
    QTest::addColumn<Permitted>("permitted");
    QTest::addColumn<QByteArray>("conformity");
    QTest::newRow("within") << 0.019 << Permitted{{}, 0.02} << QByteArray("conditionalPass");
    QTest::newRow("beyond") << 0.021 << Permitted{{}, 0.02} << QByteArray("conditionalFail");
    QTest::newRow("within, by magnitude") << -0.019 << Permitted{{}, 0.02} << QByteArray("conditionalPass");
    QTest::newRow("within a range") << -0.009 << Permitted{-0.01, 0.0} << QByteArray("conditionalPass");
    QTest::newRow("below a range") << -0.011 << Permitted{-0.01, 0.0} << QByteArray("conditionalFail");
}

// Whichever rule leaves it unproven.
void DccTest::aRowNotProvenIsMappedLikeAParameter() {
    QFETCH(double, measured);
    QFETCH(Permitted, permitted);
    QFETCH(QByteArray, conformity);
    for (const Rule rule : {Rule::iso14253_1, Rule::rejectionProven}) {
        Document document = stated(openDocument(EXAMPLES "machine-acceptance-sheet.palmer"));
        SheetRow row;
        row.object = "Checked row";
        row.measured = measured;
        row.permitted = permitted;
        row.uncertainty = 0.003;
        row.unit = "mm";
        document.report.sheet = {row};
        document.report.decisionRule.rule = rule;
        const QByteArray certificate = dcc(evaluate(std::make_shared<const Document>(document)));
        const QByteArray row1 = certificate.mid(certificate.indexOf("Checked row"));
        const qsizetype at = row1.indexOf("<dcc:conformity>");
        QCOMPARE(row1.mid(at).left(row1.mid(at).indexOf("</")), "<dcc:conformity>" + conformity);
    }
}

void DccTest::onlyAnEvaluatedUncertaintyIsSaidToBeOne() {
    const auto says = [](const char *path) {
        return dcc(evaluatedFile(path)).contains("Expanded uncertainties are evaluated");
    };
    QVERIFY(says(DOCUMENTS "budget-2006.palmer"));
    QVERIFY(!says(DOCUMENTS "limits-2006.palmer")); // stated by the laboratory
}

void DccTest::aSensorWithoutATemperatureKeepsItsPosition() {
    Document document = stated(openDocument(DOCUMENTS "budget-2006.palmer"));
    editMeasurement<PositioningMeasurement>(document, 0, [](PositioningMeasurement &measurement) {
        measurement.conditions.common.sensors = {{SensorMeasures::machine, "below the table", {}, {}, {}}};
    });
    const QByteArray certificate = dcc(evaluate(std::make_shared<const Document>(document)));
    QVERIFY(certificate.contains("Temperature: Machine, below the table"));
}

void DccTest::everyChannelOfADriftHasItsRange() {
    Document document = stated(openDocument(DOCUMENTS "budget-2006.palmer"));
    DriftMeasurement drift;
    drift.axis.name = "X";
    drift.times = {0, 60};
    drift.channels = {{"X", ChannelQuantity::deviation, {0.0, 0.001}},
                      {"A", ChannelQuantity::angularDeviation, {0.0, 0.5 / 3600}}};
    Test test;
    test.date = "2026-11-20";
    test.measurement = drift;
    document.tests.push_back(std::make_shared<const Test>(test));
    const QString certificate =
        QString::fromUtf8(dcc(evaluate(std::make_shared<const Document>(document)))).simplified();
    const auto valueAfter = [&](const char *name) {
        const QString rest = certificate.mid(certificate.indexOf(name));
        return rest.section("<si:value>", 1, 1).section("</si:unit>", 0, 0);
    };
    QVERIFY(valueAfter("E_VE of X, whole record").startsWith("1<"));
    QVERIFY(valueAfter("E_VE of X, whole record").endsWith("\\micro\\metre"));
    QVERIFY(valueAfter("E_VE of A, whole record").startsWith("0.5<"));
    QVERIFY(valueAfter("E_VE of A, whole record").endsWith("\\arcsecond"));
}

QTEST_GUILESS_MAIN(DccTest)

#include "dcctest.moc"
