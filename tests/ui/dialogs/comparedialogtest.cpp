#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/dialogs/comparedialog.h"

#include "document/savedocument.h"
#include "ui/examples.h"

#include <QApplication>
#include <QClipboard>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;
using namespace palmer::testdata;

/// The comparison in the window.
class CompareDialogTest : public QObject {
    Q_OBJECT

private slots:
    void showsTheEditionsWithReasons() {
        CompareDialog dialog(evaluatedDocument(example1988("ISO 230-2:1988")), 0);
        auto *table = dialog.findChild<QTableWidget *>("editionTable");
        QCOMPARE(table->columnCount(), 7); // symbol, five families, reason
        QVERIFY(table->rowCount() > 10);
        for (int row = 0; row < table->rowCount(); ++row)
            QVERIFY2(!table->item(row, 6)->text().isEmpty(), qPrintable(table->item(row, 0)->text()));
        // An edition less is a column less.
        dialog.findChild<QListWidget *>("editionList")->item(1)->setCheckState(Qt::Unchecked);
        QCOMPARE(table->columnCount(), 6);
    }

    void testsOfAnotherFileAreAdded() {
        CompareDialog dialog(evaluatedDocument(example1988("ISO 230-2:2006")), 0);
        auto *table = dialog.findChild<QTableWidget *>("testTable");
        QCOMPARE(table->columnCount(), 2);
        QTemporaryDir folder;
        Document other;
        Test left = example1988("ISO 230-2:2006");
        left.title = "as left";
        other.tests.push_back(std::make_shared<const Test>(left));
        saveDocument(other, folder.filePath("left.palmer"));
        QVERIFY(dialog.addFile(folder.filePath("left.palmer")));
        QCOMPARE(table->columnCount(), 4); // and the differences
        QVERIFY(table->horizontalHeaderItem(2)->text().contains("left.palmer"));
        QCOMPARE(table->item(0, 3)->text().remove('.').remove('0').remove(','),
                 QString()); // the same readings
        dialog.findChild<QTabWidget *>("compareTabs")->setCurrentIndex(1);
        dialog.findChild<QPushButton *>("copyComparison")->click();
        QVERIFY(QApplication::clipboard()->text().contains("as left"));
    }

    void withoutTestNothingIsCompared() {
        CompareDialog dialog(evaluate(std::make_shared<Document>()), 0);
        QCOMPARE(dialog.findChild<QTableWidget *>("editionTable")->rowCount(), 0);
        QCOMPARE(dialog.findChild<QTableWidget *>("testTable")->rowCount(), 0);
    }
};

QTEST_MAIN(CompareDialogTest)
#include "comparedialogtest.moc"
