// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "document/edits.h"
#include "document/savedocument.h"
#include "document/testsofverdict.h"
#include "ui/chip.h"
#include "ui/navigation/navigationmodel.h"
#include "ui/verdictmark.h"
#include "ui/welcome/examples.h"
#include "ui/welcome/recentfiles.h"
#include "ui/welcome/startlist.h"

#include <QComboBox>
#include <QListView>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

/// The two statements in English words, from requirements alone.
QString limitsWords(const TestEvaluation &evaluation, const palmer::Test &test) {
    if (!evaluation.verdict) {
        const bool any = std::ranges::any_of(
            test.limits, [](const auto &limit) { return limit.second.value.has_value(); });
        return any ? u"limits that do not hold here"_s : u"no limit agreed"_s;
    }
    switch (*evaluation.verdict) {
    case Verdict::conforms:
        return u"limits met"_s;
    case Verdict::notProven:
        return u"limits not proven"_s;
    case Verdict::doesNotConform:
        break;
    }
    return u"limits exceeded"_s;
}

int countOf(const TestEvaluation &evaluation, State state) {
    return static_cast<int>(std::ranges::count_if(evaluation.findings, [&](const Finding &finding) {
        return finding.source == Source::text && finding.grade == Grade::requirement &&
               finding.state == state;
    }));
}

Document withRole(TestRole first, TestRole second) {
    Document document = openDocument(examplePath("rotary-axis"));
    palmer::Test one = *document.tests[0];
    palmer::Test two = one;
    two.id = "second";
    one.role = first;
    two.role = second;
    for (auto &[id, limit] : one.limits)
        limit.value = 1e-6; // nothing meets that
    document.tests = {std::make_shared<const palmer::Test>(one), std::make_shared<const palmer::Test>(two)};
    return document;
}

} // namespace

/// Wherever the window shows a verdict there are two statements: limits and accordance.
class VerdictTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }
    void theHeadOfTheResultsSaysBoth_data();
    void theHeadOfTheResultsSaysBoth();
    void conformsNeverStandsAboveAnUnmetRequirement();
    void theNavigationSaysBoth();
    void aViewSaysNeither();
    void aTestUnderWayIsProvisional();
    void anOutdatedSimulationIsNoTickInTheNavigation();
    void theWelcomePageSaysBoth_data();
    void theWelcomePageSaysBoth();
    void formerEntriesOfTheSettingsKeepTheirVerdict();
};

void VerdictTest::theHeadOfTheResultsSaysBoth_data() {
    QTest::addColumn<QString>("path");
    for (const Example &example : examples())
        QTest::newRow(qPrintable(example.name)) << example.path;
}

void VerdictTest::theHeadOfTheResultsSaysBoth() {
    QFETCH(QString, path);
    const ShownWindow shown(path);
    const EvaluatedDocument &evaluated = shown.window->evaluator().current();
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
        const TestEvaluation &evaluation = *evaluated.tests[i];
        if (!evaluation.edition)
            continue;
        shown.window->workplace().showTest(i);
        const auto *limits = shown.find<Chip>("limitsChip");
        const auto *accordance = shown.find<LinkChip>("accordanceChip");
        QVERIFY(limits->isVisible() && accordance->isVisible());
        QCOMPARE(limits->text(), limitsWords(evaluation, *evaluated.document->tests[i]));
        // Its name is the sentence of the report; it names the standard, and how many are unmet.
        QVERIFY2(accordance->accessibleName().contains(QString::fromUtf8(evaluation.edition->word)),
                 qPrintable(accordance->accessibleName()));
        QCOMPARE(accordance->toolTip(), accordance->accessibleName());
        QCOMPARE(accordance->text(), accordanceMark(evaluation.accordance()).word);
    }
}

/// The letters "conform" never stand large where a requirement is unmet or undeclared, or was not read.
void VerdictTest::conformsNeverStandsAboveAnUnmetRequirement() {
    int withheld = 0;
    int said = 0;
    for (const Example &example : examples()) {
        Document document = openDocument(example.path);
        auto bare = std::make_shared<palmer::Test>(*document.tests[0]);
        if (Conditions *conditions = conditionsOf(*bare))
            conditions->complete = false; // asked for by every text that was read
        document.tests[0] = std::move(bare);
        for (const bool damaged : {false, true}) {
            const QTemporaryDir folder;
            const QString path = folder.filePath(u"a.palmer"_s);
            if (damaged)
                saveDocument(document, path);
            const ShownWindow shown(damaged ? path : example.path);
            const TestEvaluation &evaluation = *shown.window->evaluator().current().tests[0];
            if (!evaluation.edition)
                continue;
            const bool clean = evaluation.edition->textRead != TextRead::none &&
                               countOf(evaluation, State::unmet) == 0 &&
                               countOf(evaluation, State::undeclared) == 0;
            const QString word = shown.find<Chip>("verdictChip")->text();
            QVERIFY(!word.isEmpty());
            if (!clean) {
                ++withheld;
                QVERIFY2(!word.contains(u"conform"_s), qPrintable(word));
            } else if (evaluation.verdict && *evaluation.verdict != Verdict::notProven) {
                ++said;
                QVERIFY2(word.contains(u"conform"_s), qPrintable(word));
            }
        }
    }
    QVERIFY(withheld > 2 && said > 2);
}

void VerdictTest::theNavigationSaysBoth() {
    const ShownWindow shown(examplePath("rotary-axis"));
    const auto *model = shown.find<QListView>("navigation")->model();
    const QModelIndex row = model->index(model->rowCount() - 1, 0);
    const QString spoken = row.data(Qt::AccessibleTextRole).toString();
    QVERIFY2(spoken.contains(u"limits met"_s), qPrintable(spoken));
    QVERIFY2(spoken.contains(u"text of the edition not available"_s), qPrintable(spoken));
    QCOMPARE(row.data(Qt::ToolTipRole).toString(), spoken);
    QCOMPARE(row.data(NavigationModel::markRole).toString(), u"check"_s);
    QCOMPARE(row.data(NavigationModel::accordanceRole).toString(), u"info"_s);
    // Narrow, as a rail, all is still said.
    shown.window->resize(1024, 768);
    QVERIFY(!shown.window->grab().isNull());
    QCOMPARE(row.data(Qt::AccessibleTextRole).toString(), spoken);
}

void VerdictTest::aViewSaysNeither() {
    const ShownWindow shown(examplePath("rotary-axis"));
    shown.window->evaluator().setView(0, "ISO 230-2:2006");
    for (const char *chip : {"verdictChip", "limitsChip", "accordanceChip"})
        QTRY_VERIFY2(!shown.find(chip)->isVisible(), chip);
    const auto *model = shown.find<QListView>("navigation")->model();
    const QModelIndex row = model->index(model->rowCount() - 1, 0);
    QVERIFY(row.data(NavigationModel::markRole).toString().isEmpty());
    QVERIFY(row.data(NavigationModel::accordanceRole).toString().isEmpty());
}

void VerdictTest::aTestUnderWayIsProvisional() {
    Document document = openDocument(examplePath("rotary-axis"));
    auto test = std::make_shared<palmer::Test>(*document.tests[0]);
    std::get<PositioningMeasurement>(test->measurement).runs.back().deviations.back().reset();
    document.tests[0] = std::move(test);
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.palmer"_s);
    saveDocument(document, path);
    const ShownWindow shown(path);
    QCOMPARE(shown.find<Chip>("verdictChip")->text(), u"provisional"_s);
    const auto *model = shown.find<QListView>("navigation")->model();
    const QModelIndex row = model->index(model->rowCount() - 1, 0);
    QCOMPARE(row.data(NavigationModel::markRole).toString(), u"dots"_s);
    QVERIFY(row.data(NavigationModel::accordanceRole).toString().isEmpty());
}

void VerdictTest::anOutdatedSimulationIsNoTickInTheNavigation() {
    const auto document = std::make_shared<const Document>(openDocument(examplePath("rotary-axis")));
    EvaluatedDocument evaluated = evaluate(document);
    NavigationModel model;
    model.show(evaluated);
    const auto mark = [&] {
        return model.index(model.rowCount() - 1).data(NavigationModel::markRole).toString();
    };
    QCOMPARE(mark(), u"check"_s);
    TestEvaluation provisional = *evaluated.tests.back();
    provisional.provisional = true;
    evaluated.tests.back() = std::make_shared<const TestEvaluation>(std::move(provisional));
    model.show(evaluated);
    QCOMPARE(mark(), u"dots"_s);
    QVERIFY(
        model.index(model.rowCount() - 1).data(Qt::AccessibleTextRole).toString().contains(u"provisional"_s));
}

void VerdictTest::theWelcomePageSaysBoth_data() {
    QTest::addColumn<TestRole>("first"); // its limits are exceeded, those of the other are met
    QTest::addColumn<TestRole>("second");
    QTest::addColumn<QString>("limits");
    QTest::newRow("both count") << TestRole::notStated << TestRole::notStated << u"limits exceeded"_s;
    QTest::newRow("as found is not part of it") << TestRole::asFound << TestRole::asLeft << u"limits met"_s;
    QTest::newRow("where all are as found they count")
        << TestRole::asFound << TestRole::asFound << u"limits exceeded"_s;
}

void VerdictTest::theWelcomePageSaysBoth() {
    QFETCH(TestRole, first);
    QFETCH(TestRole, second);
    QFETCH(QString, limits);
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"two.palmer"_s);
    saveDocument(withRole(first, second), path);
    { const ShownWindow shown(path); }
    const ShownWindow again;
    const auto *model = again.find<QListView>("recentList")->model();
    QCOMPARE(model->rowCount(), 1);
    const QString spoken = model->index(0, 0).data(Qt::AccessibleTextRole).toString();
    QVERIFY2(spoken.contains(limits), qPrintable(spoken));
    QVERIFY2(spoken.contains(u"text of the edition not available"_s), qPrintable(spoken));
    const QString tip = model->index(0, 0).data(Qt::ToolTipRole).toString();
    QVERIFY(tip.contains(path) && tip.contains(limits));
    QVERIFY(!again.window->grab().isNull());
}

void VerdictTest::formerEntriesOfTheSettingsKeepTheirVerdict() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"one.palmer"_s);
    saveDocument(openDocument(examplePath("rotary-axis")), path);
    QSettings settings;
    settings.beginWriteArray(u"recentFiles"_s, 1);
    settings.setArrayIndex(0);
    settings.setValue(u"path"_s, path);
    settings.setValue(u"verdict"_s, u"notProven"_s);
    settings.endArray();
    QCOMPARE(recentFiles().size(), std::size_t{1});
    QCOMPARE(recentFiles().front().verdict, std::optional(Verdict::notProven));
    QVERIFY(!recentFiles().front().accordance);
    rememberFile(recentFiles().front());
    QCOMPARE(recentFiles().front().verdict, std::optional(Verdict::notProven));
    QVERIFY(!recentFiles().front().accordance);
}

QTEST_MAIN(VerdictTest)
#include "verdicttest.moc"
