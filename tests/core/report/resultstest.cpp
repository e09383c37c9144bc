// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/savedocument.h"
#include "report/blocks/plaintext.h"
#include "report/composereport.h"

#include <QDir>
#include <QTest>

using namespace palmer;

namespace {

QString resultsText(Document document, Language::Id language = Language::Id::english) {
    return plainText(
        composeResults(evaluate(std::make_shared<const Document>(std::move(document))), Language(language)));
}

Document example(const QString &name) {
    return openDocument(EXAMPLES + name + ".palmer");
}

/// The example with its first test changed.
template <typename Change>
Document changed(Document document, Change change) {
    auto test = std::make_shared<Test>(*document.tests.front());
    change(*test, std::get<PositioningMeasurement>(test->measurement));
    document.tests.front() = test;
    return document;
}

} // namespace

class ResultsTest : public QObject {
    Q_OBJECT

private slots:
    void fitsATerminal_data();
    void fitsATerminal();
    void saysWhatIsStandInIn1988();
    void lettersAreThoseOfTheEdition();
    void standardsHaveTheirArticleInFrench();
    void titlesATestByItsTitleElseItsKind();
    void titlesAStepCycleNotAgreed();
    void saysNotCorrected();
    void saysTheCorrectionOfARotaryAxis();
    void showsTheSideOfTheLimit();
    void printsADashForWhatIsMissing();
};

void ResultsTest::fitsATerminal_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("language");
    for (const QString &file : QDir(EXAMPLES).entryList({"*.palmer"})) {
        const QString name = file.chopped(7);
        QTest::addRow("%s in English", qPrintable(name)) << name << int(Language::Id::english);
        QTest::addRow("%s in French", qPrintable(name)) << name << int(Language::Id::french);
    }
}

void ResultsTest::fitsATerminal() {
    QFETCH(QString, name);
    QFETCH(int, language);
    const QString text = resultsText(example(name), Language::Id(language));
    QVERIFY(text.size() > 1000);
    for (const QString &line : text.split('\n'))
        QVERIFY2(displayWidth(line) <= terminalWidth, qPrintable(line));
    QVERIFY(!text.contains("nan") && !text.contains("null"));
}

void ResultsTest::saysWhatIsStandInIn1988() {
    QString text = resultsText(example("iso230-2-1988-example"));
    QVERIFY(text.contains(" 18.0 ") && text.contains("2↓ – 9↑"));
    QVERIFY(text.simplified().contains("ten readings are substitutes"));
}

void ResultsTest::lettersAreThoseOfTheEdition() {
    const auto setAside = [](const char *edition) {
        return resultsText(
            changed(example("iso230-2-1988-example"), [edition](Test &test, PositioningMeasurement &m) {
                test.edition = edition;
                m.excluded = {{1, 2, *m.runs[0].deviations[1], "beam"}};
                m.runs[0].deviations[1].reset();
            }));
    };
    const QString of1988 = setAside("ISO 230-2:1988");
    QVERIFY2(of1988.contains("Targets j") && of1988.contains("(i = 1)"), qPrintable(of1988));
    QVERIFY(!of1988.contains("Targets i") && !of1988.contains("(j = "));
    const QString of2006 = setAside("ISO 230-2:2006");
    QVERIFY2(of2006.contains("Targets i") && of2006.contains("(j = 1)"), qPrintable(of2006));
}

void ResultsTest::standardsHaveTheirArticleInFrench() {
    QString text = resultsText(changed(example("iso230-2-1988-example"),
                                       [](Test &test, PositioningMeasurement &) {
                                           test.limits["A"] = {0.02, "ISO 230-2:2006", ""};
                                       }),
                               Language::Id::french);
    text.replace(QRegularExpression("\\s+"), " ");
    QVERIFY2(text.contains("convenue pour l’ISO 230-2:2006, l’essai est évalué selon l’ISO 230-2:1988"),
             qPrintable(text));
}

void ResultsTest::titlesATestByItsTitleElseItsKind() {
    const auto titled = [](const char *title) {
        return resultsText(changed(example("iso230-2-1988-example"),
                                   [&](Test &test, PositioningMeasurement &) { test.title = title; }));
    };
    QVERIFY(titled("Before the repair").contains("Before the repair · ISO 230-2:1988"));
    QVERIFY(!titled("").contains("Before the repair") && !titled("").contains("\n · ISO 230-2:1988"));
    QVERIFY2(titled("").contains("Positioning test of axis X · ISO 230-2:1988"),
             qPrintable(titled("").left(400)));
}

void ResultsTest::titlesAStepCycleNotAgreed() {
    const QString words = "step cycle – not an ISO 230-2 acceptance result";
    const auto step = [](Test &, PositioningMeasurement &m) { m.cycle = Cycle::step; };
    QVERIFY(resultsText(changed(example("one-direction"), step)).contains(words));
    // What the text of 2014 asks for is not known.
    QVERIFY(!resultsText(changed(example("rotary-axis"), step)).contains(words));
    // 1988 knows both cycles: they are to be stated, not agreed.
    const QString text = resultsText(changed(example("iso230-2-1988-example"), step));
    QVERIFY(!text.contains(words) && text.contains("pilgrim step cycle"));
}

void ResultsTest::saysNotCorrected() {
    const QString words = "(not corrected to 20 °C)";
    const Document document = changed(example("long-axis-with-zone"), [](Test &, PositioningMeasurement &m) {
        m.conditions.common.correctionTo20 = CorrectionTo20::notApplied;
    });
    QCOMPARE(resultsText(example("long-axis-with-zone")).simplified().count(words), 0);
    QVERIFY(resultsText(document).simplified().count(words) > 0);
}

void ResultsTest::saysTheCorrectionOfARotaryAxis() {
    QVERIFY(resultsText(example("rotary-axis")).simplified().contains("Correction to 20 °C not applied"));
    const Document document = changed(example("rotary-axis"), [](Test &, PositioningMeasurement &m) {
        m.conditions.common.correctionTo20 = CorrectionTo20::notStated;
    });
    QVERIFY(!resultsText(document).contains("Correction to 20 °C"));
}

void ResultsTest::showsTheSideOfTheLimit() {
    const Document document =
        changed(example("iso230-2-1988-example"), [](Test &test, PositioningMeasurement &) {
            test.limits["A"].value = 0.018; // A is 18.03 µm
        });
    const QString text = resultsText(document);
    QVERIFY2(text.contains("18.03") && text.contains("exceeded"), qPrintable(text.left(2000)));
}

void ResultsTest::printsADashForWhatIsMissing() {
    const Document document =
        changed(example("iso230-2-1988-example"), [](Test &, PositioningMeasurement &m) {
            for (Run &run : m.runs)
                if (run.approach == Direction::negative)
                    run.deviations[4] = std::nullopt;
        });
    const QString text = resultsText(document);
    const auto lines = text.split('\n');
    const auto row =
        std::find_if(lines.begin(), lines.end(), [](const QString &l) { return l.startsWith(" 5 "); });
    QVERIFY(row != lines.end());
    QVERIFY2(row->contains("–") && row->contains("−7.32"), qPrintable(*row));
}

QTEST_GUILESS_MAIN(ResultsTest)
#include "resultstest.moc"
