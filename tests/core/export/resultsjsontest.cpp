// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "export/resultsjson.h"
#include "document/savedocument.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace palmer;

namespace {

// Made on use: catalogues are not there before main.
Language english() {
    return Language(Language::Id::english);
}

QJsonObject resultsOf(const Document &document, const Language &language = english()) {
    const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
    const QByteArray bytes = resultsJson(evaluated, "x.palmer", language, JsonForm::pretty);
    QJsonParseError error{};
    const QJsonObject result = QJsonDocument::fromJson(bytes, &error).object();
    if (error.error != QJsonParseError::NoError)
        qFatal("no JSON: %s", qPrintable(error.errorString()));
    return result;
}

QJsonObject firstTest(const Document &document, const Language &language = english()) {
    return resultsOf(document, language)["tests"][0].toObject();
}

QJsonObject parameter(const QJsonObject &test, const QString &id) {
    for (const QJsonValue value : test["parameters"].toArray()) {
        if (value["id"] == id)
            return value.toObject();
    }
    return {};
}

Document example(const QString &name) {
    return openDocument(EXAMPLES + name + ".palmer");
}

} // namespace

class ResultsJsonTest : public QObject {
    Q_OBJECT

private slots:
    void hasTheKeysOfTheFormat();
    void givesTheValuesOf1988();
    void hasNullForAMissingDirection();
    void hasDegreesForARotaryAxis();
    void saysWhoseLimitARowShows();
    void speaksTheLanguageAskedFor();
    void isOneLineWhenAsked();
};

void ResultsJsonTest::hasTheKeysOfTheFormat() {
    const QJsonObject file = resultsOf(example("iso230-2-1988-example"));
    QCOMPARE(file["format"].toString(), "palmer results");
    QCOMPARE(file["version"].toInt(), 1);
    QCOMPARE(file["file"].toString(), "x.palmer");
    QVERIFY(file["program"].toString().startsWith("Palmer "));
    const QJsonObject test = file["tests"][0].toObject();
    QCOMPARE(
        test.keys(),
        QStringList({"accordance",  "agreedLimits", "axis",    "correctionTo20", "date",    "decisionRule",
                     "edition",     "findings",     "id",      "inAccordance",   "kind",    "limits",
                     "parameters",  "plane",        "purpose", "role",           "targets", "title",
                     "uncertainty", "undeclared",   "unmet",   "verdict",        "view",    "zone"}));
    QCOMPARE(parameter(test, "A").keys(),
             QStringList({"budgetActualUncertainty", "budgetUncertainty", "clause", "coverageFactor",
                          "coverageProbability", "expandedUncertainty", "guardBand", "id", "limit", "limitOf",
                          "monteCarlo", "name", "quantity", "ruling", "symbol", "unit", "value", "verdict"}));
    QCOMPARE(test["targets"][0].toObject().keys(),
             QStringList({"lowerNegative", "lowerPositive", "mean", "meanNegative", "meanPositive",
                          "nNegative", "nPositive", "rangeNegative", "rangePositive", "repeatability",
                          "repeatabilityNegative", "repeatabilityPositive", "reversal", "sNegative",
                          "sPositive", "target", "upperNegative", "upperPositive"}));
    QCOMPARE(test["findings"][0].toObject().keys(),
             QStringList({"clause", "grade", "id", "keys", "source", "state", "text"}));
}

void ResultsJsonTest::givesTheValuesOf1988() {
    const QJsonObject test = firstTest(example("iso230-2-1988-example"));
    const QJsonObject accuracy = parameter(test, "A");
    constexpr double printed = 1e-8; // mm: five decimals of a micrometre were recomputed
    QVERIFY(std::abs(accuracy["value"].toDouble() - 0.01803009) <= printed);
    QCOMPARE(accuracy["clause"].toString(), "2.13");
    QCOMPARE(accuracy["unit"].toString(), "mm");
    QCOMPARE(accuracy["ruling"][0]["target"].toInt(), 2);
    QCOMPARE(accuracy["ruling"][0]["approach"].toString(), "negative");
    QCOMPARE(accuracy["ruling"][1]["target"].toInt(), 9);
    QCOMPARE(accuracy["ruling"][1]["approach"].toString(), "positive");
    QVERIFY(accuracy["verdict"].isNull() && accuracy["limit"].isNull() && accuracy["limitOf"].isNull());
    QVERIFY(parameter(test, "R")["ruling"][0]["approach"].isNull());
    const QJsonObject target = test["targets"][0].toObject();
    constexpr double rounding = 1e-15; // mm
    QVERIFY(std::abs(target["reversal"].toDouble() + 0.00404) < rounding);
    QVERIFY(std::abs(target["rangePositive"].toDouble() - 0.0021) < rounding);
    QVERIFY(std::abs(target["upperPositive"].toDouble() - target["lowerPositive"].toDouble() -
                     target["repeatabilityPositive"].toDouble()) < rounding);
}

void ResultsJsonTest::hasNullForAMissingDirection() {
    const QJsonObject test = firstTest(example("one-direction"));
    QCOMPARE(parameter(test, "A"), QJsonObject());
    QVERIFY(parameter(test, "A+")["value"].isDouble());
    const QJsonObject target = test["targets"][3].toObject();
    QCOMPARE(target["nNegative"].toInt(-1), 0);
    for (const char *key :
         {"meanNegative", "mean", "reversal", "sNegative", "lowerNegative", "repeatability"})
        QVERIFY2(target[key].isNull(), key);
}

void ResultsJsonTest::hasDegreesForARotaryAxis() {
    const QJsonObject test = firstTest(example("rotary-axis"));
    QCOMPARE(parameter(test, "A")["unit"].toString(), "deg");
    QCOMPARE(parameter(test, "A")["limit"].toDouble(), 0.0025);
    QCOMPARE(parameter(test, "A")["limitOf"].toString(), "A");
    QCOMPARE(parameter(test, "A")["verdict"].toString(), "conforms");
    QCOMPARE(test["verdict"].toString(), "conforms");
}

/// A row may be held to the limit of F: whose it shows stands beside it.
void ResultsJsonTest::saysWhoseLimitARowShows() {
    Document document = example("iso230-4-full-circles-xy");
    Test test = *document.tests.at(0);
    for (const bool tight : {true, false}) {
        test.limits = {{"F", {tight ? 1e-6 : 1, {}, ""}}, {"Fmax", {0.5, {}, ""}}, {"G", {0.02, {}, ""}}};
        document.tests.at(0) = std::make_shared<const Test>(test);
        const QJsonObject results = firstTest(document);
        QStringList shown;
        for (const QJsonValue value : results["parameters"].toArray()) {
            const QJsonObject row = value.toObject();
            QCOMPARE(row["limitOf"].isNull(), row["limit"].isNull());
            if (row["limitOf"].isNull())
                continue;
            const QString of = row["limitOf"].toString();
            QCOMPARE(row["limit"].toDouble(), *test.limits.at(of.toStdString()).value);
            if (row["quantity"].toString() != of)
                shown << row["quantity"].toString() + " of " + of;
        }
        QVERIFY2(tight == !shown.isEmpty(), qPrintable(shown.join(", ")));
    }
}

void ResultsJsonTest::speaksTheLanguageAskedFor() {
    const Document document = example("rotary-axis");
    const QJsonObject inEnglish = parameter(firstTest(document), "B");
    const QJsonObject inFrench = parameter(firstTest(document, Language(Language::Id::french)), "B");
    QCOMPARE(inEnglish["name"].toString(), "reversal error of an axis");
    QVERIFY(inFrench["name"].toString() != inEnglish["name"].toString());
    QCOMPARE(inFrench["value"], inEnglish["value"]);
    QCOMPARE(inFrench["id"], inEnglish["id"]);
}

void ResultsJsonTest::isOneLineWhenAsked() {
    const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(example("rotary-axis")));
    const QByteArray bytes = resultsJson(evaluated, "a\nb", english(), JsonForm::oneLine);
    QCOMPARE(bytes.count('\n'), 1);
    QVERIFY(bytes.endsWith('\n'));
    QCOMPARE(QJsonDocument::fromJson(bytes)["file"].toString(), "a\nb");
}

QTEST_GUILESS_MAIN(ResultsJsonTest)
#include "resultsjsontest.moc"
