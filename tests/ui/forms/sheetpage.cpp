// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/forms/sheetmodel.h"
#include "ui/window/shownwindow.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QScrollBar>
#include <QTableView>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;

namespace {

/// The page of the sheet in the window, on the example.
struct ShownSheet {
    ShownSheet() {
        shown.window->activateWindow();
        if (!QTest::qWaitForWindowActive(shown.window))
            qFatal("the window does not become active");
        shown.window->workplace().showPage(Page::sheet);
        table = shown.find<QTableView>("sheetTable");
        table->setFocus();
    }
    [[nodiscard]] const std::vector<SheetRow> &rows() const {
        return shown.window->model().document()->report.sheet;
    }
    void choose(int row, SheetColumn column) const {
        table->selectionModel()->setCurrentIndex(table->model()->index(row, static_cast<int>(column)),
                                                 QItemSelectionModel::ClearAndSelect);
    }
    void type(int row, SheetColumn column, const QString &text) const {
        choose(row, column);
        table->setFocus();
        QTest::keyClicks(table, text.first(1));
        QTRY_VERIFY(QApplication::focusWidget() != table); // but its editor
        QTest::keyClicks(QApplication::focusWidget(), text.sliced(1));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_VERIFY(table->hasFocus());
    }
    [[nodiscard]] QString said(int row, int column) const {
        return table->model()->index(row, column).data().toString();
    }

    ShownWindow shown{examplePath("machine-acceptance-sheet")};
    QTableView *table = nullptr; ///< made with its page
};

} // namespace

class SheetPageTest : public QObject {
    Q_OBJECT

private slots:
    /// The columns of short texts give the object the room that it lacks.
    void objectsAreWhole() {
        const ShownSheet sheet;
        constexpr auto object = static_cast<int>(SheetColumn::object);
        const QFontMetrics metrics(sheet.table->font());
        for (const int width : {1024, 1280, 1600}) {
            sheet.shown.window->resize(width, 768);
            QTest::qWait(20); // layouts
            for (int row = 0; row < sheet.table->model()->rowCount(); ++row)
                QVERIFY2(metrics.horizontalAdvance(sheet.said(row, object)) <
                             sheet.table->columnWidth(object),
                         qPrintable(QString("%1 at %2").arg(sheet.said(row, object)).arg(width)));
        }
        QVERIFY(!sheet.table->isColumnHidden(SheetModel::picture)); // where there is room
    }

    /// The numbers of the linked row are within its limit by more than U: the reason is another.
    void sayWhyNothingIsProven() {
        const ShownSheet sheet;
        const int linked = static_cast<int>(sheet.rows().size()) - 1;
        QVERIFY(sheet.rows().back().from);
        QCOMPARE(sheet.said(linked, SheetModel::verdict), QString("not proven"));
        const QModelIndex verdict = sheet.table->model()->index(linked, SheetModel::verdict);
        QCOMPARE(verdict.data(Qt::ToolTipRole).toString(), "nothing is proven: not shown to hold at 20 °C");
    }
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void typing() {
        const ShownSheet sheet;
        const std::vector<SheetRow> before = sheet.rows();
        const int last = static_cast<int>(before.size()); // the empty row
        sheet.type(last, SheetColumn::object, "Flatness of the base");
        QCOMPARE(sheet.rows().size(), before.size() + 1);
        QCOMPARE(sheet.rows().back().object, std::string("Flatness of the base"));
        QCOMPARE(sheet.said(last, SheetModel::verdict), QString("not measured"));
        sheet.type(last, SheetColumn::permitted, "0.02");
        sheet.type(last, SheetColumn::measured, "0.03");
        sheet.type(last, SheetColumn::uncertainty, "0.001");
        QCOMPARE(sheet.rows().back().measured, std::optional(0.03));
        QCOMPARE(sheet.said(last, SheetModel::verdict), QString("exceeded"));
        const std::vector<SheetRow> typed = sheet.rows();
        sheet.type(last, SheetColumn::measured, "much");
        QVERIFY(sheet.rows() == typed);
        QVERIFY(sheet.shown.find<QLabel>("sheetReason")->isVisible());
        QUndoStack &undo = *sheet.shown.window->model().undoStack();
        while (undo.canUndo())
            undo.undo();
        QVERIFY(sheet.rows() == before);
    }

    /// Ctrl+V and Delete mean the table, not the test that the window shows.
    void keysOfPasteAndDelete() {
        const ShownSheet sheet;
        const std::vector<SheetRow> before = sheet.rows();
        sheet.choose(static_cast<int>(before.size()), SheetColumn::number);
        QApplication::clipboard()->setText("No.\tObject\tTolerance\tMeasured\tU\tUnit\n"
                                           "H1\tStraightness\t0.02\t0.019\t0.003\tmm\n"
                                           "H2\tRun-out\t0.01\t0.004\t0.001\tmm\n");
        QTest::keyClick(sheet.table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(sheet.rows().size(), before.size() + 2);
        QCOMPARE(sheet.rows().back().number, std::string("H2"));
        QCOMPARE(sheet.rows().back().uncertainty, std::optional(0.001));
        QCOMPARE(sheet.said(static_cast<int>(before.size()), SheetModel::verdict), QString("not proven"));
        sheet.table->setFocus();
        sheet.choose(0, SheetColumn::object);
        QTest::keyClick(sheet.table, Qt::Key_Delete);
        QCOMPARE(sheet.rows().size(), before.size() + 1);
        QVERIFY(sheet.rows().front() == before.at(1));
        sheet.shown.window->model().undoStack()->undo();
        sheet.shown.window->model().undoStack()->undo();
        QVERIFY(sheet.rows() == before);
    }

    /// No bar below the table, objects whole, also beside the bar of a long sheet.
    void fitsTheWindow() {
        const ShownSheet sheet;
        sheet.shown.window->resize(1366, 768);
        QString rows = "No.\tObject\tTolerance\tMeasured\tU\tUnit\n";
        for (int i = 1; i <= 30; ++i)
            rows += QString("S%1\tStraightness of X, plane XY, table\t0.02\t0.01\t0.003\tmm\n").arg(i);
        sheet.choose(static_cast<int>(sheet.rows().size()), SheetColumn::number);
        QApplication::clipboard()->setText(rows);
        QTest::keyClick(sheet.table, Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(sheet.rows().back().number, std::string("S30"));
        QTRY_COMPARE(sheet.table->horizontalScrollBar()->maximum(), 0);
        constexpr int object = static_cast<int>(SheetColumn::object);
        const QAbstractItemView &view = *sheet.table; // where the hint is public
        QTRY_VERIFY(view.sizeHintForColumn(object) <= sheet.table->columnWidth(object));
        QVERIFY(sheet.table->viewport()->width() > 1000);
    }

    /// What a test does not prove, its row does not either.
    void aRowOfATestHasItsVerdict() {
        for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
            setWindowLanguage(language);
            const ShownSheet sheet;
            const auto row = static_cast<int>(sheet.rows().size()) - 1;
            QVERIFY(sheet.rows().back().from);
            QCOMPARE(sheet.said(row, SheetModel::verdict),
                     language == Language::Id::english ? QString("not proven") : QString("non prouvé"));
        }
    }
};

QTEST_MAIN(SheetPageTest)
#include "sheetpage.moc"
