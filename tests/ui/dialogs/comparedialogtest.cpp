// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/dialogs/comparedialog.h"

#include "document/savedocument.h"
#include "report/comparison.h"
#include "ui/circles.h"
#include "ui/examples.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSet>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;

/// The comparison in the window.
class CompareDialogTest : public QObject {
    Q_OBJECT

private slots:
    void showsTheEditionsWithReasons() {
        const Test test = example1988("ISO 230-2:1988");
        CompareDialog dialog(evaluatedDocument(test), 0);
        auto *table = dialog.findChild<QTableWidget *>("editionTable");
        const int families = static_cast<int>(editionsToCompare(test).size());
        const int notesColumn = 2 + families; // after symbol and name
        QCOMPARE(table->columnCount(), notesColumn + 1);
        QVERIFY(table->rowCount() > 10);
        const QString notes = dialog.findChild<QLabel *>("editionNotes")->text();
        const QStringList lines = notes.split('\n');
        QStringList told = lines;
        told.removeDuplicates();
        QCOMPARE(told, lines); // every reason once
        for (int row = 0; row < table->rowCount(); ++row) {
            const QString numbers = table->item(row, notesColumn)->text();
            QVERIFY2(!numbers.isEmpty(), qPrintable(table->item(row, 0)->text()));
            QVERIFY(!table->item(row, 1)->text().isEmpty());
            int before = 0;
            for (const QString &number : numbers.split(", ")) {
                QVERIFY2(number.toInt() > before, qPrintable(numbers));
                before = number.toInt();
                const QString line = lines.value(number.toInt() - 1);
                QVERIFY2(line.startsWith(number + QChar(0x2002)), qPrintable(line));
                QVERIFY(table->item(row, notesColumn)->toolTip().contains(line.section(QChar(0x2002), 1)));
            }
        }
        // An edition less is a column less.
        dialog.findChild<QListWidget *>("editionList")->item(1)->setCheckState(Qt::Unchecked);
        QCOMPARE(table->columnCount(), notesColumn);
    }

    void whatDiffersIsMarked() {
        CompareDialog dialog(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        const auto *table = dialog.findChild<QTableWidget *>("editionTable");
        int marked = 0;
        for (int row = 0; row < table->rowCount(); ++row) {
            const QString none = "–";
            const QString first = table->item(row, 2)->text();
            QVERIFY(!first.isEmpty()); // a dash where an edition has no value
            for (int column = 2; column < table->columnCount() - 1; ++column) {
                const QTableWidgetItem *item = table->item(row, column);
                const bool differs = first != none && item->text() != none && item->text() != first;
                QCOMPARE(item->font().bold(), differs);
                marked += differs;
            }
        }
        QVERIFY(marked > 3);
    }

    /// Names are as wide as they need where there is room.
    void namesTakeTheFreeSpace() {
        CompareDialog dialog(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        const auto *table = dialog.findChild<QTableWidget *>("editionTable");
        dialog.resize(4000, 700);
        dialog.show();
        QCoreApplication::processEvents();
        int widest = 0;
        for (int row = 0; row < table->rowCount(); ++row)
            widest = std::max(widest, table->fontMetrics().horizontalAdvance(table->item(row, 1)->text()));
        QVERIFY2(table->columnWidth(1) >= widest,
                 qPrintable(QString("%1 of %2").arg(table->columnWidth(1)).arg(widest)));
        dialog.resize(700, 700);
        QCoreApplication::processEvents();
        QVERIFY(table->columnWidth(1) < widest);
    }

    void nothingIsClipped_data() {
        QTest::addColumn<Language::Id>("language");
        QTest::newRow("in English") << Language::Id::english;
        QTest::newRow("in French") << Language::Id::french;
    }
    void nothingIsClipped() {
        QFETCH(Language::Id, language);
        setWindowLanguage(language);
        CompareDialog dialog(evaluatedDocument(example1988("ISO 230-2:2014")), 0);
        dialog.resize(960, 640);
        dialog.show();
        const auto *table = dialog.findChild<QTableWidget *>("editionTable");
        for (int row = 0; row < table->rowCount(); ++row) {
            for (int column = 1; column < table->columnCount(); ++column) {
                const QTableWidgetItem *item = table->item(row, column);
                const QFontMetrics metrics(item->data(Qt::FontRole).isValid() ? item->font() : table->font());
                const QRect room(0, 0, table->columnWidth(column) - 12, 1000);
                const QRect text =
                    metrics.boundingRect(room, column == 1 ? int(Qt::TextWordWrap) : 0, item->text());
                QVERIFY2(text.width() <= room.width() && text.height() <= table->rowHeight(row),
                         qPrintable(item->text()));
            }
        }
        for (int column = 1; column < table->columnCount(); ++column)
            QVERIFY(QFontMetrics(themeFont(TextSize::small))
                            .horizontalAdvance(table->horizontalHeaderItem(column)->text()) +
                        12 <=
                    table->columnWidth(column));
        setWindowLanguage(Language::Id::english);
    }

    void testsOfAnotherFileAreAdded() {
        CompareDialog dialog(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        auto *table = dialog.findChild<QTableWidget *>("testTable");
        QCOMPARE(table->columnCount(), 3);
        QTemporaryDir folder;
        Document other;
        Test left = example1988("ISO 230-2:2006");
        left.title = "as left";
        other.tests.push_back(std::make_shared<const Test>(left));
        saveDocument(other, folder.filePath("left.palmer"));
        QVERIFY(dialog.addFile(folder.filePath("left.palmer")));
        QCOMPARE(table->columnCount(), 5); // and the differences
        QVERIFY(table->horizontalHeaderItem(3)->text().contains("left.palmer"));
        QCOMPARE(table->item(0, 4)->text().remove('.').remove('0').remove(','),
                 QString()); // the same readings
        dialog.findChild<QTabWidget *>("compareTabs")->setCurrentIndex(1);
        dialog.findChild<QPushButton *>("copyComparison")->click();
        QVERIFY(QApplication::clipboard()->text().contains("as left"));
    }

    void filesOfMeasurementsAreCompared() {
        CompareDialog dialog(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        QTemporaryDir folder;
        QFile file(folder.filePath("left.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("P mm;1 ↑;1 ↓;2 ↑;2 ↓\n0;1,0;2,0;1,5;2,5\n100;3,0;4,0;3,5;4,5\n");
        file.close();
        QVERIFY(dialog.addFile(file.fileName()));
        auto *table = dialog.findChild<QTableWidget *>("testTable");
        QCOMPARE(table->columnCount(), 5);
        QVERIFY(table->horizontalHeaderItem(3)->text().contains("left.csv"));
        bool told = false; // what was guessed stands below
        for (const QLabel *label : dialog.findChildren<QLabel *>())
            told = told || label->text().contains("left.csv: ");
        QVERIFY(told);
    }

    void circlesLieOverOneAnother() {
        Document document;
        Test first = decidedPair();
        Test second = decidedPair();
        second.id = "c2";
        second.title = "after adjustment";
        for (Arc &arc : circular(second).arcs) {
            for (double &deviation : arc.radialDeviations)
                deviation /= 2;
        }
        document.tests = {std::make_shared<const Test>(first), std::make_shared<const Test>(second)};
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
        const ComparisonFigure figure = comparisonFigure(
            {{evaluated, 0, "as found"}, {evaluated, 1, "as left"}}, Language(Language::Id::english));
        QCOMPARE(figure.curves.size(), std::size_t{4});
        QCOMPARE(figure.curves[0].name, QString("as found (XY)"));
        QCOMPARE(figure.curves[3].name, QString("as left (YX)"));
        QCOMPARE(figure.curves[3].test, std::size_t{1});
        QCOMPARE(figure.curves[3].sense, std::optional(Sense::clockwise));
        // The extremes are those of all points about the least squares centre; few points carry them.
        const auto reach = [&](const ComparisonCurve &curve) {
            double least = 0;
            double most = 0;
            std::size_t points = 0;
            for (const auto &line : curve.lines) {
                points += line.size();
                for (const FigurePoint &point : line) {
                    least = std::min(least, point.y);
                    most = std::max(most, point.y);
                }
            }
            return points <= 6000 ? most - least : std::nan("");
        };
        const TestEvaluation &evaluation = *evaluated.tests[0];
        const CircleResult *circle = std::get<CircularResults>(evaluation.results)
                                         .circle(CircleOf::counterclockwise, ReferenceCircle::leastSquares);
        QVERIFY(std::abs(reach(figure.curves[0]) - circle->width * 1000) < 1e-6); // µm
        // Every evaluated point counts, the first and the last, too.
        const Arc &arc = circular(first).arcs[0];
        QVERIFY(std::abs(figure.curves[0].lines.front().front().x - arc.angles.front()) < 0.01);
        QVERIFY(std::abs(figure.curves[0].lines.back().back().x - arc.angles.back()) < 0.01);
        QVERIFY(std::abs(figure.x.to - figure.x.from - 360) < 30);
        CompareDialog dialog(evaluated, 0);
        QCOMPARE(dialog.findChild<QListWidget *>("testList")->count(), 2);
        dialog.findChild<QListWidget *>("testList")->item(1)->setCheckState(Qt::Checked);
        QCOMPARE(dialog.findChild<QTableWidget *>("testTable")->columnCount(), 5);
    }

    /// As many tests are preselected as a table shows, and tests of one name are told apart.
    void manyTestsOfAnAxis() {
        Document document;
        for (int i = 0; i < 12; ++i)
            document.tests.push_back(std::make_shared<const palmer::Test>(example1988("ISO 230-2:2006")));
        CompareDialog dialog(evaluate(std::make_shared<const Document>(document)), 3);
        const auto *list = dialog.findChild<QListWidget *>("testList");
        QCOMPARE(list->count(), 12);
        QSet<QString> names;
        int chosen = 0;
        for (int row = 0; row < list->count(); ++row) {
            names << list->item(row)->text();
            chosen += list->item(row)->checkState() == Qt::Checked ? 1 : 0;
        }
        QCOMPARE(names.size(), 12);
        QCOMPARE(chosen, 9); // with the one in view
    }

    void withoutTestNothingIsCompared() {
        CompareDialog dialog(evaluate(std::make_shared<Document>()), 0);
        QCOMPARE(dialog.findChild<QTableWidget *>("editionTable")->rowCount(), 0);
        QCOMPARE(dialog.findChild<QTableWidget *>("testTable")->rowCount(), 0);
    }
};

QTEST_MAIN(CompareDialogTest)
#include "comparedialogtest.moc"
