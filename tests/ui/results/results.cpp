// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/resultspanel.h"

#include "ui/chip.h"
#include "ui/examples.h"
#include "ui/results/explanationcard.h"
#include "ui/results/findingsmodel.h"
#include "ui/results/findingspanel.h"
#include "ui/verdictmark.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QListView>
#include <QMimeData>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

/// Results, their explanation and the findings, as widgets.
class ResultsTest : public QObject {
    Q_OBJECT

private slots:
    void modelsAreConsistent() {
        ResultsModel results;
        QAbstractItemModelTester tester(&results, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const EvaluatedDocument evaluated = evaluatedDocument(decidedExample());
        results.setTable(resultTable(evaluated, 0, Language(Language::Id::french)),
                         Language(Language::Id::french));
        results.setTable({}, Language(Language::Id::french));
        FindingsModel findings;
        QAbstractItemModelTester second(&findings, QAbstractItemModelTester::FailureReportingMode::QtTest);
        findings.show(evaluated, 0, Page::conditions, Language(Language::Id::french));
        findings.show(EvaluatedDocument(), 0, Page::readings, Language(Language::Id::french));
        QCOMPARE(findings.rowCount(), 0);
    }

    void aClickExplains() {
        Selection selection;
        ResultsPanel panel(selection);
        panel.show(evaluatedDocument(decidedExample()), 0);
        panel.resize(496, 320);
        panel.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto *table = panel.findChild<QTableView *>(u"results"_s);
        const QModelIndex r = table->model()->index(7, ResultsModel::columnOf("name"));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(r).center());
        QCOMPARE(selection.parameter(), u"R"_s);
    }

    void arrowsMoveAndEnterExplains() {
        Selection selection;
        ResultsPanel panel(selection);
        panel.show(evaluatedDocument(decidedExample()), 0);
        panel.resize(496, 320);
        panel.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.activateWindow();
        auto *table = panel.findChild<QTableView *>(u"results"_s);
        table->setFocus();
        table->setCurrentIndex(table->model()->index(0, 0));
        QTest::keyClick(table, Qt::Key_Down);
        QCOMPARE(selection.parameter(), QString()); // only looked at
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(selection.parameter(), u"A+"_s);
        QTRY_VERIFY(table->hasFocus());
        QTest::keyClick(table, Qt::Key_Down);
        QCOMPARE(selection.parameter(), u"A-"_s); // an open explanation follows
    }

    void headSaysUnitRuleAndVerdict() {
        Selection selection;
        ResultsPanel panel(selection);
        panel.show(evaluatedDocument(decidedExample()), 0);
        QCOMPARE(panel.findChild<QLabel *>(u"resultsRule"_s)->text(), u"µm · ISO 14253-1 · k = 2"_s);
        auto *chip = panel.findChild<Chip *>(u"verdictChip"_s);
        // A requirement is unmet: the large word is of the limits alone.
        QCOMPARE(chip->text(), u"limits not proven"_s);
        QVERIFY(!chip->isVisibleTo(&panel)); // which the first statement says already
        QCOMPARE(panel.findChild<Chip *>(u"limitsChip"_s)->text(), u"limits not proven"_s);
        const auto *rows = panel.findChild<QTableView *>(u"results"_s)->model();
        QCOMPARE(rows->index(0, ResultsModel::columnOf("verdict")).data(Qt::ToolTipRole).toString(),
                 u"nothing is proven: not shown to hold at 20 °C"_s);
        const auto *accordance = panel.findChild<LinkChip *>(u"accordanceChip"_s);
        QCOMPARE(accordance->text(), accordanceMark(Accordance::no).word);
        QVERIFY2(accordance->toolTip().startsWith(u"Test NOT in accordance with ISO 230-2:2006"_s),
                 qPrintable(accordance->toolTip()));
    }

    void aViewCarriesNoVerdict() {
        Selection selection;
        ResultsPanel panel(selection);
        panel.show(evaluatedDocument(decidedExample(), "ISO 230-2:2014"), 0);
        QVERIFY(!panel.findChild<Chip *>(u"verdictChip"_s)->isVisibleTo(&panel));
        auto *note = panel.findChild<QLabel *>(u"viewNote"_s);
        QVERIFY(note->isVisibleTo(&panel));
        QVERIFY2(note->text().contains(u"no verdict"_s), qPrintable(note->text()));
        auto *table = panel.findChild<QTableView *>(u"results"_s);
        for (int row = 0; row < table->model()->rowCount(); ++row)
            QVERIFY(
                table->model()->index(row, ResultsModel::columnOf("verdict")).data().toString().isEmpty());
    }

    void beforeStandsLeftOfAfter() {
        Test found = decidedExample();
        found.role = TestRole::asFound;
        Test left = found;
        left.role = TestRole::asLeft;
        found.date = "2026-03-12";
        for (Run &run : measurement(left).runs) {
            for (auto &deviation : run.deviations)
                *deviation /= 2;
        }
        auto document = std::make_shared<Document>();
        for (const Test &test : {found, left})
            document->tests.push_back(std::make_shared<const Test>(test));
        const EvaluatedDocument evaluated = evaluate(std::shared_ptr<const Document>(document));
        Selection selection;
        ResultsPanel panel(selection);
        panel.resize(496, 400);
        panel.setVisible(true);
        auto *table = panel.findChild<QTableView *>(u"results"_s);
        /// What is read from left to right: heads and the numbers of A.
        const auto read = [&] {
            QStringList heads;
            QStringList numbers;
            for (int place = 0; place < table->model()->columnCount(); ++place) {
                const int column = table->horizontalHeader()->logicalIndex(place);
                if (table->isColumnHidden(column) || !ResultsModel::isNumber(column))
                    continue;
                heads << table->model()->headerData(column, Qt::Horizontal).toString();
                numbers << table->model()->index(0, column).data().toString();
            }
            return std::pair(heads, numbers);
        };
        const QStringList heads{u"before"_s, u"± U"_s, u"after"_s, u"± U"_s, u"change"_s, u"limit"_s};
        for (const std::size_t test : {std::size_t(1), std::size_t(0), std::size_t(1)}) {
            panel.show(evaluated, test);
            QCOMPARE(read().first, heads);
            const auto numbers = read().second;
            const Language english(Language::Id::english);
            QCOMPARE(numbers[0], resultTable(evaluated, 0, english).lines[0].cell("value"));
            QCOMPARE(numbers[2], resultTable(evaluated, 1, english).lines[0].cell("value"));
            QVERIFY(numbers[4].startsWith(u'−'));
            QVERIFY(table->isColumnHidden(ResultsModel::columnOf("picture")));
            QCOMPARE(panel.findChild<QLabel *>(u"viewNote"_s)->text(),
                     u"Before the adjustment: test 1 of 12\u00A0Mar\u00A02026 · after it: test 2"_s);
            // Nothing is cut off but the name of the quantity.
            QVERIFY(table->columnWidth(ResultsModel::columnOf("name")) >= 40);
        }
        panel.show(evaluatedDocument(decidedExample()), 0); // one without another
        QCOMPARE(read().first, (QStringList{u"value"_s, u"± U"_s, u"limit"_s}));
        QVERIFY(!table->isColumnHidden(ResultsModel::columnOf("picture")));
        QVERIFY(!panel.findChild<QLabel *>(u"viewNote"_s)->isVisibleTo(&panel));
    }

    void unfinishedIsProvisional() {
        Selection selection;
        ResultsPanel panel(selection);
        Test test = decidedExample();
        measurement(test).runs.back().deviations.back().reset();
        panel.show(evaluatedDocument(test), 0);
        QCOMPARE(panel.findChild<Chip *>(u"verdictChip"_s)->text(), u"provisional"_s);
    }

    void copyGivesATableForSpreadsheetAndText() {
        Selection selection;
        ResultsPanel panel(selection);
        panel.setLanguage(Language(Language::Id::french));
        panel.show(evaluatedDocument(decidedExample()), 0);
        panel.findChild<QToolButton *>(u"copyResults"_s)->click();
        const QMimeData *copied = QGuiApplication::clipboard()->mimeData();
        QVERIFY2(copied->text().contains(u"\t16,2\t3,0\t20\t"_s), qPrintable(copied->text()));
        QVERIFY(copied->text().contains(u"\t-1,53\t0,61\t"_s)); // a minus that a spreadsheet knows
        QVERIFY(copied->html().contains(u"<table"_s) && copied->html().contains(u"16,2"_s));
    }

    void cardExplains() {
        Selection selection;
        ExplanationCard card(selection);
        card.setLanguage(Language(Language::Id::english));
        card.show(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        selection.setParameter(u"R"_s);
        QVERIFY(card.findChild<QLabel *>(u"explanationName"_s)->text().startsWith(u"R "_s));
        const QString text = card.findChild<QWidget *>(u"explanation"_s)->accessibleDescription();
        QVERIFY2(text.contains(u"R11 = max(2·1.85 + 2·1.39 + |−3.78|; 4·1.85; 4·1.39)"_s), qPrintable(text));
        QVERIFY2(text.contains(u"= 10.3\u00a0µm"_s), qPrintable(text));
        QCOMPARE(card.findChild<QLabel *>(u"explanationSource"_s)->text(),
                 u"ISO 230-2:2006, clauses 2.17 and 2.19"_s);
        QVERIFY(card.findChild<QWidget *>(u"targetBars"_s)->isVisibleTo(&card));
        card.copy();
        QVERIFY(QGuiApplication::clipboard()->text().contains(u"= 10.3\u00a0µm"_s));
        card.findChild<QToolButton *>(u"closeExplanation"_s)->click();
        QCOMPARE(selection.parameter(), QString());
    }

    void findingsOfThePageComeFirst() {
        FindingsModel model;
        const EvaluatedDocument evaluated = evaluatedDocument(decidedExample());
        model.show(evaluated, 0, Page::agreedPoints, Language(Language::Id::english));
        int single = 0;
        while (single < model.rowCount() && !model.line(single).id.isEmpty()) {
            QCOMPARE(model.line(single).page, Page::agreedPoints);
            ++single;
        }
        const auto expected =
            std::ranges::count_if(evaluated.tests[0]->findings, [&](const Finding &finding) {
                return pageOf(finding, *evaluated.document) == Page::agreedPoints;
            });
        QCOMPARE(single, static_cast<int>(expected));
        // Then a line per page, each page once.
        QSet<int> pages;
        for (int row = single; row < model.rowCount(); ++row) {
            QVERIFY(model.line(row).id.isEmpty());
            QVERIFY(!pages.contains(static_cast<int>(model.line(row).page)));
            pages.insert(static_cast<int>(model.line(row).page));
        }
        QVERIFY(pages.contains(static_cast<int>(Page::conditions)));
    }

    void aClickOnAFindingGoesThere() {
        Selection selection;
        FindingsPanel panel(selection);
        panel.show(evaluatedDocument(decidedExample()), 0);
        panel.setPage(Page::conditions);
        panel.resize(496, 120);
        panel.setVisible(true);
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QSignalSpy spy(&panel, &FindingsPanel::activated);
        auto *list = panel.findChild<QListView *>(u"findings"_s);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(list->model()->index(0, 0)).center());
        QCOMPARE(spy.size(), 1);
        QCOMPARE(spy.at(0).at(0).value<Page>(), Page::conditions);
        QVERIFY(!spy.at(0).at(1).toString().isEmpty());
    }

    void findingsFold() {
        Selection selection;
        FindingsPanel panel(selection);
        panel.show(evaluatedDocument(decidedExample()), 0);
        auto *list = panel.findChild<QListView *>(u"findings"_s);
        panel.findChild<QToolButton *>(u"foldFindings"_s)->click();
        QVERIFY(panel.isFolded());
        QVERIFY(!list->isVisibleTo(&panel));
        panel.setFolded(false);
        QVERIFY(list->isVisibleTo(&panel));
    }
};

QTEST_MAIN(ResultsTest)
#include "results.moc"
