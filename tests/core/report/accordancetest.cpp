// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/evaluation/positioningdata.h"

#include "report/tables/findinglines.h"
#include "report/words/accordancetext.h"
#include "report/words/findingtext.h"

#include <QRegularExpression>
#include <QTest>

using namespace palmer;
using namespace palmer::testdata;

namespace {

/// An evaluation with so many findings of each kind, whatever the measurement.
TestEvaluation evaluationWith(const char *edition, int unmet, int undeclared, int departures) {
    TestEvaluation result;
    result.edition = findEdition(edition);
    if (result.edition->kind == Kind::circular)
        result.results = CircularResults{};
    const auto add = [&](int count, Finding finding) {
        result.findings.insert(result.findings.end(), static_cast<std::size_t>(count), finding);
    };
    add(unmet, {.grade = Grade::requirement, .source = Source::text, .state = State::unmet});
    add(undeclared, {.grade = Grade::requirement, .source = Source::text, .state = State::undeclared});
    add(departures, {.source = Source::practice, .state = State::unmet});
    return result;
}

QByteArray lines(const TestEvaluation &evaluation, Language::Id language) {
    QStringList result;
    for (const FindingLine &line : findingLines(evaluation, Language(language)).lines) {
        if (!line.heading.isEmpty())
            result << u'[' + line.heading + u']';
        result << line.clause + u'|' + line.sentence.plain();
    }
    return result.join(u'\n').toUtf8();
}

} // namespace

/// What is said of the requirements: the second part of the verdict, and the printed findings.
class AccordanceTest : public QObject {
    Q_OBJECT

private slots:
    void sentences_data();
    void sentences();
    void findingsCountAsTheSentence();
    void severalTests_data();
    void severalTests();
    void oneLinePerClauseAndState();
    void practiceSaysThatItIs();
    void theExampleOf1988TakesFewLines();
};

void AccordanceTest::sentences_data() {
    QTest::addColumn<QString>("edition");
    QTest::addColumn<QList<int>>("counts"); // unmet, undeclared, departures
    QTest::addColumn<QString>("declaredBy");
    QTest::addColumn<bool>("byPractice");
    QTest::addColumn<QString>("english");
    QTest::addColumn<QString>("french");
    const auto row = [](const char *name, const char *edition, QList<int> counts, const char *declaredBy,
                        bool byPractice, const char *english, const char *french) {
        QTest::newRow(name) << QString::fromUtf8(edition) << counts << QString::fromUtf8(declaredBy)
                            << byPractice << QString::fromUtf8(english) << QString::fromUtf8(french);
    };
    row("not checked", "ISO 230-2:2014", {0, 0, 3}, "", false,
        "The text of ISO 230-2:2014 was not available: its requirements were not checked; 3 departures from "
        "practice, see page %1.",
        "Le texte de l’ISO 230-2:2014 n’était pas disponible : ses exigences n’ont pas été vérifiées ; 3 "
        "écarts à "
        "l’usage, voir page %1.");
    row("not checked, nothing found", "ISO 230-2:2014", {0, 0, 0}, "", false,
        "The text of ISO 230-2:2014 was not available: its requirements were not checked; no departure from "
        "practice found.",
        "Le texte de l’ISO 230-2:2014 n’était pas disponible : ses exigences n’ont pas été vérifiées ; aucun "
        "écart "
        "à l’usage constaté.");
    row("not checked, declared", "ISO 230-2:2014", {0, 0, 0}, "Metro", false,
        "The text of ISO 230-2:2014 was not available: its requirements were not checked; no departure from "
        "practice found; the laboratory declares the rest met (Metro).",
        "Le texte de l’ISO 230-2:2014 n’était pas disponible : ses exigences n’ont pas été vérifiées ; aucun "
        "écart "
        "à l’usage constaté ; le laboratoire déclare le reste satisfait (Metro).");
    row("no", "ISO 230-2:1988", {2, 3, 0}, "Metro", false,
        "Test NOT in accordance with ISO 230-2:1988: 2 requirements not met, 3 not declared, see page %1.",
        "Essai NON conforme à l’ISO 230-2:1988 : 2 exigences non satisfaites, 3 non déclarées, voir page "
        "%1.");
    row("no, one", "ISO 230-2:1988", {1, 0, 0}, "", false,
        "Test NOT in accordance with ISO 230-2:1988: 1 requirement not met, see page %1.",
        "Essai NON conforme à l’ISO 230-2:1988 : 1 exigence non satisfaite, voir page %1.");
    row("no, in part", "ISO 230-2:2006", {2, 0, 0}, "", false,
        "Test NOT in accordance with ISO 230-2:2006 (clauses 1 to 4.3.2 checked): 2 requirements not met, "
        "see page "
        "%1.",
        "Essai NON conforme à l’ISO 230-2:2006 (articles 1 à 4.3.2 vérifiés) : 2 exigences non satisfaites, "
        "voir "
        "page %1.");
    row("not shown", "ISO 230-2:1988", {0, 3, 0}, "", false,
        "Accordance with ISO 230-2:1988 not shown: 3 requirements not declared, see page %1.",
        "Conformité à l’ISO 230-2:1988 non établie : 3 exigences non déclarées, voir page %1.");
    row("not shown, in part, long axis", "ISO 230-2:2006", {0, 1, 0}, "", true,
        "Accordance with ISO 230-2:2006 (clauses 1 to 4.3.1 checked) not shown: 1 requirement not declared, "
        "see "
        "page %1.",
        "Conformité à l’ISO 230-2:2006 (articles 1 à 4.3.1 vérifiés) non établie : 1 exigence non déclarée, "
        "voir "
        "page %1.");
    row("partly", "ISO 230-2:2006", {0, 0, 2}, "", false,
        "ISO 230-2:2006: the requirements of clauses 1 to 4.3.2 are met; the rest of 4.3 and clauses 5 to 7 "
        "were "
        "not available and not checked.",
        "ISO 230-2:2006 : exigences des articles 1 à 4.3.2 satisfaites ; la suite de 4.3 et les articles 5 à "
        "7, "
        "non disponibles, n’ont pas été vérifiés.");
    row("partly, rotary, declared", "ISO 230-2:2006", {0, 0, 0}, "Metro", true,
        "ISO 230-2:2006: the requirements of clauses 1 to 4.3.1 are met; the rest of 4.3 and clauses 5 to 7 "
        "were "
        "not available and not checked; number of targets and approaches by practice; the laboratory "
        "declares the "
        "rest met (Metro).",
        "ISO 230-2:2006 : exigences des articles 1 à 4.3.1 satisfaites ; la suite de 4.3 et les articles 5 à "
        "7, "
        "non disponibles, n’ont pas été vérifiés ; nombre de points visés et d’approches selon l’usage ; le "
        "laboratoire déclare le reste satisfait (Metro).");
    row("yes", "ISO 230-2:1988", {0, 0, 0}, "Metro", false,
        "Test carried out in accordance with ISO 230-2:1988.",
        "Essai exécuté conformément à l’ISO 230-2:1988.");
    row("yes, circular", "ISO 230-4:2005", {0, 0, 0}, "", false,
        "Test carried out in accordance with ISO 230-4:2005.",
        "Essai exécuté conformément à l’ISO 230-4:2005.");
}

void AccordanceTest::sentences() {
    QFETCH(QString, edition);
    QFETCH(QList<int>, counts);
    QFETCH(QString, declaredBy);
    QFETCH(bool, byPractice);
    QFETCH(QString, english);
    QFETCH(QString, french);
    TestEvaluation evaluation = evaluationWith(edition.toUtf8().constData(), counts[0], counts[1], counts[2]);
    if (auto *results = std::get_if<PositioningResults>(&evaluation.results))
        results->countByPractice = byPractice;
    Test test;
    test.declaredAccordance.by = declaredBy.toStdString();
    french.replace(QLatin1String(" ;"), QStringLiteral("\u202F;"));
    french.replace(QLatin1String(" :"), QStringLiteral("\u00A0:"));
    const auto plain = [](QString text) {
        return text.replace(u'\u00A0' + QStringLiteral("%1"), QStringLiteral(" %1"));
    };
    QCOMPARE(plain(accordanceText(test, evaluation, Language(Language::Id::english), true)), english);
    QCOMPARE(plain(accordanceText(test, evaluation, Language(Language::Id::french), true)), french);
    QVERIFY(!accordanceText(test, evaluation, Language(Language::Id::english), false).contains(u'%'));
}

/// The number at the end of the findings begins as the sentence of page 1 ends.
void AccordanceTest::findingsCountAsTheSentence() {
    for (const char *edition : {"ISO 230-2:1988", "ISO 230-2:2006", "ISO 230-4:2022"}) {
        const bool wasRead = findEdition(edition)->textRead != TextRead::none;
        for (const int unmet : {0, 1, 4}) {
            for (const int undeclared : {0, 1, 12}) {
                TestEvaluation found = wasRead ? evaluationWith(edition, unmet, undeclared, 3)
                                               : evaluationWith(edition, 0, 0, unmet);
                if (!wasRead)
                    found.findings.insert(found.findings.end(), static_cast<std::size_t>(undeclared),
                                          {.source = Source::practice, .state = State::undeclared});
                for (const Language::Id id : {Language::Id::english, Language::Id::french}) {
                    const Language language(id);
                    const QString numbers = requirementsText(found, language);
                    QCOMPARE(numbers.isEmpty(), unmet + undeclared == 0);
                    if (numbers.isEmpty() || (!wasRead && unmet == 0))
                        continue;
                    const QString sentence = accordanceText(Test(), found, language, false);
                    QVERIFY2(sentence.endsWith(numbers + u'.'), qPrintable(sentence));
                    QVERIFY(countedFindings(found, language).all.startsWith(numbers));
                    found.findings.push_back({.source = Source::laboratory, .missing = true});
                    found.findings.push_back({.grade = Grade::recommendation, .missing = true});
                    QVERIFY(findingsByGrade(found, language).startsWith(numbers));
                    QVERIFY(
                        findingsByGrade(found, Language(Language::Id::english)).contains(" recommendation"));
                }
            }
        }
    }
}

void AccordanceTest::severalTests_data() {
    QTest::addColumn<QList<int>>("tests");
    QTest::addColumn<QString>("english");
    const auto row = [](const char *name, std::initializer_list<Accordance> tests, const char *english) {
        QList<int> list;
        for (const Accordance one : tests)
            list << static_cast<int>(one);
        QTest::newRow(name) << list << QString::fromUtf8(english);
    };
    using enum Accordance;
    row("all", {yes, yes}, "All tests carried out in accordance with their editions.");
    row("every value", {yes, yes, partly, notShown, no, notChecked},
        "In accordance: 2; in part: 1; not shown: 1; not: 1; not checked: 1.");
    row("none", {no, no}, "In accordance: none; not: 2.");
}

void AccordanceTest::severalTests() {
    QFETCH(QList<int>, tests);
    QFETCH(QString, english);
    std::vector<Accordance> all;
    for (const int one : tests)
        all.push_back(static_cast<Accordance>(one));
    QCOMPARE(accordanceOfAll(all, Language(Language::Id::english)), english);
}

void AccordanceTest::oneLinePerClauseAndState() {
    Test test = exactHand("ISO 230-2:1988");
    PositioningMeasurement &m = measurement(test);
    m.axis.travel = 400;
    Conditions &common = m.conditions.common;
    common.shielded = false;
    common.stabilised = false;
    common.complete = common.levelled = true;
    test.agreedPoints = {{"warmUp", AgreementState::notAgreed, "", {}}};
    const QByteArray english = lines(evaluated(test), Language::Id::english);
    const QByteArray french = lines(evaluated(test), Language::Id::french);
    // unmet of 3.1 on one line, undeclared of 3.1 on another, a statement on that of its clause
    QVERIFY2(english.startsWith(
                 "[Asked by the text of ISO 230-2:1988]\n"
                 "3.1|Machine or instruments were not thermally stable. Not protected from draughts "
                 "or radiation.\n"),
             english.constData());
    QVERIFY2(english.contains(
                 "\n3.1|Not declared (3): temperature of the environment, compensation by the instrument, "
                 "temperature gradient over 12 h and its agreed limit.\n"),
             english.constData());
    QVERIFY2(english.contains("\n3.2|Not stated in the report (1): position of the axes not under test.\n"),
             english.constData());
    QVERIFY2(english.contains("\n3.2|Not declared (1): machine unloaded.\n"), english.constData());
    QVERIFY2(english.contains(
                 "\n8|To be agreed (clause 8), not declared (2): b) position of the measuring reference, e) "
                 "measuring cycle.\n8|To be agreed (clause 8), not agreed (1): c) warm-up.\n"),
             english.constData());
    // Every number can be recounted.
    const QRegularExpression listed(QStringLiteral("\\((\\d+)\\): ([^\n]*)\\.\n"));
    int lists = 0;
    for (auto it = listed.globalMatch(QString::fromUtf8(english)); it.hasNext(); ++lists) {
        const QRegularExpressionMatch list = it.next();
        const bool composed = list.captured(2).contains(u';');
        const qsizetype names =
            list.captured(2).split(composed ? QStringLiteral("; ") : QStringLiteral(", ")).size();
        QCOMPARE(composed || list.captured(1) != u"1" ? names : 1, list.captured(1).toLongLong());
    }
    QVERIFY(lists > 8);
    QVERIFY2(english.contains("\n[Laboratory]\n|Laboratory practice, not stated ("), english.constData());
    QVERIFY2(english.contains("\n[Palmer]\n"), english.constData());
    QVERIFY2(french.startsWith(QByteArray(
                 "[Demandé par le texte de l’ISO 230-2:1988]\n3.1|Machine ou instruments non stabilisés "
                 "thermiquement. Pas de protection contre les courants d’air ou les rayonnements.\n")),
             french.constData());
    QVERIFY2(french.contains(QByteArray("\n3.2|Non déclaré (1)\u00A0: machine non chargée.\n")),
             french.constData());
    QVERIFY2(french.contains(QByteArray("[Laboratoire]\n|Usage de laboratoire, non indiqué (")),
             french.constData());
    // Unmet stands before undeclared before recommended; sources in their order, each once.
    QVERIFY(english.indexOf("\n3.2|Not stated") < english.indexOf("\n3.1|Not declared"));
    QVERIFY(english.indexOf("\n4.1|Not declared") < english.indexOf("\n8|"));
    QVERIFY(english.indexOf("\n8|") < english.indexOf("[Laboratory]"));
    QVERIFY(english.indexOf("[Laboratory]") < english.indexOf("[Palmer]"));
    QCOMPARE(english.count('['), 3);
}

void AccordanceTest::practiceSaysThatItIs() {
    Test test = exactHand("ISO 230-2:2014");
    measurement(test).conditions.common.shielded = false;
    const TestEvaluation evaluation = evaluated(test);
    const Finding *found = finding(evaluation, "shielded");
    QVERIFY(found);
    QCOMPARE(findingText(*found, Language(Language::Id::english)),
             QStringLiteral("Not protected from draughts or radiation. (practice; text not available)"));
    QCOMPARE(findingText(*found, Language(Language::Id::french)),
             QStringLiteral(
                 "Pas de protection contre les courants d’air ou les rayonnements. (usage\u202F; texte non "
                 "disponible)"));
    QVERIFY(lines(evaluation, Language::Id::english).startsWith("[Practice (text not available)]\n|"));
}

void AccordanceTest::theExampleOf1988TakesFewLines() {
    const auto block =
        findingLines(evaluated(example1988("ISO 230-2:1988")), Language(Language::Id::english));
    QVERIFY2(block.lines.size() <= 14, qPrintable(QString::number(block.lines.size())));
}

QTEST_GUILESS_MAIN(AccordanceTest)
#include "accordancetest.moc"
