// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "register/historyfile.h"
#include "core/register/listedtests.h"
#include "document/documenterror.h"
#include "print/pdf/writepdf.h"
#include "print/proof/verifyreport.h"
#include "report/blocks/pagetext.h"

#include <QBuffer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

using namespace palmer;

namespace {

History history() {
    History history;
    history.machine.name = "Lathe";
    history.machine.serialNumber = "17";
    history.machine.months = 12;
    history.tests = testdata::sinceRepair();
    history.tests.front().test.date.reset();
    history.tests.front().test.results.front().value.reset();
    history.tests[2].test.verdict = Verdict::doesNotConform;
    history.tests[3].test.results.front().decimals = 1;
    history.due.tests = {{"X", QDate(2027, 11, 17)}};
    history.laboratory.name = "Laboratory";
    history.today = QDate(2026, 11, 28);
    history.program = "Palmer " PALMER_VERSION;
    history.number = "HI-1";
    return history;
}

QByteArray pdfOf(const Report &report) {
    QBuffer pdf;
    pdf.open(QIODevice::WriteOnly);
    writePdf(report, pdf);
    return pdf.data();
}

Verification verified(const QByteArray &pdf) {
    return verifyReport(openReport(pdf).value(), composeHistoryFile);
}

/// Each value of the data by its path, replaced by `other`.
QByteArrayList changedData(const QJsonValue &value, const QJsonValue &other,
                           const std::function<QByteArray(const QJsonValue &)> &whole) {
    QByteArrayList result;
    if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (const QString &key : object.keys()) {
            const auto around = [&](const QJsonValue &inner) {
                QJsonObject changed = object;
                inner.isUndefined() ? changed.remove(key) : (void)(changed[key] = inner);
                return whole(changed);
            };
            result << changedData(object[key], other, around);
        }
    } else if (value.isArray() && !value.toArray().isEmpty()) {
        QJsonArray array = value.toArray();
        result << changedData(array.first(), other, [&](const QJsonValue &inner) {
            QJsonArray changed = array;
            changed[0] = inner;
            return whole(changed);
        });
    }
    return result << whole(other);
}

} // namespace

/// The data that the PDF of a history carries.
class HistoryFileTest : public QObject {
    Q_OBJECT

private slots:
    void everythingShownIsInIt();
    void otherValuesDoNotFollow();
    void damagedDataAreRefused();
    void theHeadlineSaysWhatThePanelsSay_data();
    void theHeadlineSaysWhatThePanelsSay();
    void everyTestOfADayHasItsRow();
    void aLimitOfAnyParameterIsWatched();
    void testsWithoutADateAreSaid();
};

void HistoryFileTest::theHeadlineSaysWhatThePanelsSay_data() {
    QTest::addColumn<QList<double>>("values"); // limit 16
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("beside");
    QTest::newRow("at the limit, no trend shown")
        << QList{15.6, 15.9, 15.5, 15.8} << "A of X: no trend shown; the bound is at the limit already"
        << "Limit 16 µm";
    QTest::newRow("not before, no trend shown")
        << QList{12.0, 13.6, 12.4, 13.2} << "A of X: no trend shown; not before "
        << "Limit 16 µm";
    QTest::newRow("far below") << QList{1.0, 1.2, 1.1, 1.2} << "no limit within twice the observed time"
                               << "Trend A of X";
    QTest::newRow("too few") << QList{15.6, 15.9} << "too few tests: nothing is said"
                             << "Trend A of X";
    QTest::newRow("no limit") << QList<double>() << "no limit agreed"
                              << " ";
}

/// Too little data must not silence the warning.
void HistoryFileTest::theHeadlineSaysWhatThePanelsSay() {
    QFETCH(QList<double>, values);
    QFETCH(QString, word);
    QFETCH(QString, beside);
    History one = history();
    one.tests.clear();
    for (int i = 0; i < values.size(); ++i)
        one.tests.push_back(testdata::made("202" + std::to_string(i) + "-05-16", values[i]));
    if (values.empty()) {
        one.tests = testdata::sinceRepair();
        for (ListedTest &test : one.tests)
            test.test.results.front().limit.reset();
    }
    const Report report = composeHistory(one, Language(Language::Id::english));
    const auto line = std::ranges::find_if(
        report.blocks, [](const Block &block) { return std::holds_alternative<VerdictLine>(block); });
    const auto &headline = std::get<VerdictLine>(*line);
    QCOMPARE(headline.label, "To watch first");
    QVERIFY2(headline.word.startsWith(word), qPrintable(headline.word));
    const QString right = headline.limits.label + ' ' + headline.limits.state;
    QCOMPARE(right.simplified(), beside.simplified());
    const bool isTooFew = headline.limits.text.plain().contains("fewer than 4 tests");
    QCOMPARE(isTooFew, word.startsWith("too few"));
}

/// Whole travel and zone are measured on one day.
void HistoryFileTest::everyTestOfADayHasItsRow() {
    History one = history();
    one.tests = {testdata::made("2025-01-15", 17.1), testdata::made("2025-01-15", 9)};
    one.tests.front().test.verdict = one.tests.front().test.results.front().verdict = Verdict::doesNotConform;
    one.tests.back().test.verdict = Verdict::conforms;
    one.tests.back().test.edition = "JIS B 6190-2:2016";
    const QString text = pageText(composeHistory(one, Language(Language::Id::english)));
    QVERIFY2(text.contains("Tests: 2, campaigns: 1"), qPrintable(text));
    QVERIFY2(text.contains("Results over time, January 2025\n"), qPrintable(text));
    const QString rows = text.mid(text.indexOf("Campaigns")).section("All tests", 0, 0);
    for (const char *cell : {"exceeded", "met", "17.1", "9.0", "2014", "JIS B 6190-2:2016"})
        QVERIFY2(rows.contains(cell), qPrintable(rows));
}

void HistoryFileTest::aLimitOfAnyParameterIsWatched() {
    History one = history();
    one.tests = testdata::sinceRepair();
    for (ListedTest &test : one.tests) {
        auto &results = test.test.results;
        results.push_back(results.front());
        results.back().id = "M";
        results.back().limit = 0.009;
        results.back().verdict = Verdict::doesNotConform;
        results.front().limit.reset();
    }
    const QString text = pageText(composeHistory(one, Language(Language::Id::english)));
    QVERIFY2(!text.contains("no limit agreed"), qPrintable(text));
    QVERIFY2(text.contains("Exceeded at the last test") && text.contains("M of X: 12.9"), qPrintable(text));
}

void HistoryFileTest::testsWithoutADateAreSaid() {
    History one = history();
    one.tests = {testdata::made("2025-01-15", 17), testdata::made("2025-01-15", 9)};
    for (ListedTest &test : one.tests)
        test.test.date.reset();
    const QString text = pageText(composeHistory(one, Language(Language::Id::french))).simplified();
    QVERIFY2(text.contains("2 essais sans date ne sont pas pris en compte."), qPrintable(text));
    QVERIFY2(!text.contains("aucune limite convenue") && !text.contains("essais, Machine"), qPrintable(text));
}

void HistoryFileTest::everythingShownIsInIt() {
    const History one = history();
    const QByteArray json = historyJson(one);
    QCOMPARE(historyJson(historyFrom(json)), json);
    for (const Language::Id id : {Language::Id::english, Language::Id::french}) {
        const Report report = composeHistory(one, Language(id));
        QCOMPARE(report.testFile, json);
        static const QRegularExpression withoutSpace("\\w;");
        QCOMPARE(pageText(report).contains(withoutSpace), id == Language::Id::english);
        QVERIFY(composeHistoryFile(json, Language(id)) == report);
        const Verification verification = verified(pdfOf(report));
        QVERIFY(verification.identical && verification.ofHistory);
        QCOMPARE(verification.fingerprint, report.fingerprint);
    }
    QVERIFY(!json.contains("/files/"));
}

/// The pages of one history with the data of another, whatever number, verdict or date differs.
void HistoryFileTest::otherValuesDoNotFollow() {
    const Language language(Language::Id::english);
    const Report shown = composeHistory(history(), language);
    const QByteArray &json = shown.testFile;
    for (const auto &[from, to] : {std::pair{"0.0129", "0.0139"},
                                   {"0.016", "0.012"},
                                   {"2026-11-17", "2026-10-17"},
                                   {"\"doesNotConform\"", "\"conforms\""},
                                   {"2026-11-28", "2026-11-29"},
                                   {"2027-11-17", "2027-12-17"}}) {
        QByteArray changed = json;
        changed.replace(from, to);
        QVERIFY2(changed != json, from);
        Report forged = shown;
        forged.testFile = changed;
        forged.footerCentre = composeHistoryFile(changed, language).footerCentre;
        const Verification verification = verified(pdfOf(forged));
        QVERIFY2(!verification.follows() && verification.fingerprintPrinted, from);
    }
}

void HistoryFileTest::damagedDataAreRefused() {
    const QJsonObject data = QJsonDocument::fromJson(historyJson(history())).object();
    const auto whole = [](const QJsonValue &value) {
        return value.isObject() ? QJsonDocument(value.toObject()).toJson() : QByteArray("1");
    };
    int refused = 0;
    for (const QJsonValue &other : {QJsonValue(QJsonValue::Undefined), QJsonValue("x"), QJsonValue(-1e300),
                                    QJsonValue(QJsonObject()), QJsonValue(QJsonArray())}) {
        for (const QByteArray &json : changedData(data, other, whole)) {
            try {
                const Report report = composeHistoryFile(json, Language(Language::Id::english));
                QVERIFY(!report.blocks.empty());
            } catch (const Error &) {
                ++refused;
            }
        }
    }
    QVERIFY2(refused > 150, qPrintable(QString::number(refused)));
}

QTEST_MAIN(HistoryFileTest)
#include "historyfile.moc"
