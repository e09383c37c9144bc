// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "ui/help/helpwindow.h"

#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>

using namespace palmer;
using namespace palmer::ui;

/// Help in the window.
class HelpWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }

    void opensAtTheFieldWithTheFocus() {
        setWindowLanguage(Language::Id::english);
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        shown.window->workplace().showPage(Page::conditions);
        for (QLineEdit *edit : shown.window->findChildren<QLineEdit *>()) {
            if (edit->objectName().startsWith("field.airPressure.") && edit->isVisible())
                edit->setFocus();
        }
        QTRY_VERIFY(QApplication::focusWidget() &&
                    QApplication::focusWidget()->property("helpTopic").toString() == "airPressure");
        shown.find<QAction>("help")->trigger();
        auto *help = shown.find<HelpWindow>("helpWindow");
        QCOMPARE(help->currentPage(), QString("fields"));
        QVERIFY(help->text().contains("wavelength"));
        help->showPage("validation");
        QVERIFY(help->text().contains("NIST"));
        setWindowLanguage(Language::Id::french);
        QTRY_VERIFY(help->text().contains("certifié"));
        QCOMPARE(help->currentPage(), QString("validation"));
        setWindowLanguage(Language::Id::english);
    }

    void opensAtTheEditionOfAResult() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        shown.window->workplace().selection().setParameter("R");
        if (QApplication::focusWidget())
            QApplication::focusWidget()->clearFocus();
        shown.find<QAction>("help")->trigger();
        QCOMPARE(shown.find<HelpWindow>("helpWindow")->currentPage(), QString("editions.ISO 230-2:1988"));
    }

    void thePagesAreGrouped() {
        setWindowLanguage(Language::Id::english);
        HelpWindow help;
        const auto *list = help.findChild<QListWidget *>("helpPages");
        QStringList groups;
        QMap<QString, QString> groupOf;
        for (int row = 0; row < list->count(); ++row) {
            if (!(list->item(row)->flags() & Qt::ItemIsSelectable))
                groups << list->item(row)->text();
            else
                groupOf[list->item(row)->text()] = groups.value(groups.size() - 1);
        }
        QCOMPARE(groups,
                 QStringList({"Working with Palmer", "Positioning of axes", "Circular tests", "Proof"}));
        QCOMPARE(groupOf["ISO 230-2:2014"], QString("Positioning of axes"));
        QCOMPARE(groupOf["ISO 230-4:2005"], QString("Circular tests"));
        QCOMPARE(groupOf["Validation"], QString("Proof"));
        QVERIFY(groupOf.size() > 12);
        // The arrow keys pass over the titles.
        help.showPage("workflow");
        auto *keys = help.findChild<QListWidget *>("helpPages");
        QStringList walked{help.currentPage()};
        for (int step = 0; step < list->count(); ++step) {
            QTest::keyClick(keys, Qt::Key_Down);
            if (help.currentPage() != walked.last())
                walked << help.currentPage();
        }
        QCOMPARE(walked.size(), groupOf.size());
        QVERIFY(!walked.contains(QString()));
    }

    void theValidationBeginsWithItsCount() {
        for (const auto id : {Language::Id::english, Language::Id::french}) {
            setWindowLanguage(id);
            HelpWindow help;
            help.showPage("validation");
            const QString text = help.text();
            const QRegularExpression count(id == Language::Id::french
                                               ? "(\\d+) valeurs reproduites sur (\\d+)"
                                               : "(\\d+) of (\\d+) values reproduced");
            const QString plain = QString(text).remove(QChar(0x202F)).remove(QChar(0xA0));
            const auto match = count.match(plain);
            QVERIFY2(match.hasMatch(), qPrintable(text.left(400)));
            QCOMPARE(match.captured(1), match.captured(2));
            QVERIFY(match.capturedStart() < 200);
        }
        setWindowLanguage(Language::Id::english);
    }

    void itsTablesFit() {
        for (const Language::Id id : {Language::Id::french, Language::Id::english}) {
            setWindowLanguage(id);
            HelpWindow help;
            help.showPage("validation");
            help.grab(); // laid out as large as it wishes to be: the screen of tests is smaller
            const auto *text = help.findChild<QTextBrowser *>("helpText");
            QCOMPARE(text->horizontalScrollBar()->maximum(), 0);
            QVERIFY(text->document()->documentMargin() >= 12);
        }
    }

    void searchesPageAfterPage() {
        setWindowLanguage(Language::Id::english);
        HelpWindow help;
        help.showPage("workflow");
        auto *search = help.findChild<QLineEdit *>("helpSearch");
        QVERIFY(!help.text().contains("wavelength")); // another page says it
        search->setText("wavelength");
        QTest::keyClick(search, Qt::Key_Return);
        QCOMPARE(help.currentPage(), QString("fields"));
        QCOMPARE(help.findChild<QTextBrowser *>("helpText")->textCursor().selectedText(),
                 QString("wavelength"));
        // Round and round: from there it comes back to the one page that has a word.
        QVERIFY(help.find("wavelength"));
        QCOMPARE(help.currentPage(), QString("fields"));
        QVERIFY(!help.find("no such word anywhere"));
        QCOMPARE(help.currentPage(), QString("fields"));
    }

    void findsWhileTheWordIsTyped() {
        setWindowLanguage(Language::Id::english);
        HelpWindow help;
        help.showPage("workflow");
        auto *search = help.findChild<QLineEdit *>("helpSearch");
        const auto *text = help.findChild<QTextBrowser *>("helpText");
        const auto *notFound = help.findChild<QLabel *>("helpNotFound");
        QTest::keyClicks(search, "wavel");
        QCOMPARE(help.currentPage(), QString("fields"));
        const int place = text->textCursor().selectionStart();
        QTest::keyClicks(search, "ength"); // the same place, not the next one
        QCOMPARE(text->textCursor().selectedText(), QString("wavelength"));
        QCOMPARE(text->textCursor().selectionStart(), place);
        QVERIFY(notFound->text().isEmpty());
        QTest::keyClicks(search, "zzz");
        QVERIFY2(notFound->text().contains("wavelengthzzz"), qPrintable(notFound->text()));
        search->selectAll();
        QTest::keyClick(search, Qt::Key_Delete);
        QVERIFY(notFound->text().isEmpty());
    }

    void subscriptsAreLegible() {
        setWindowLanguage(Language::Id::english);
        HelpWindow help;
        help.showPage("editions.ISO 230-4:2005");
        const auto *text = help.findChild<QTextBrowser *>("helpText");
        // Qt draws a subscript with two thirds of its font: that of a table in small print would be half.
        const QTextCursor found = text->document()->find("Fmax");
        QVERIFY(!found.isNull());
        QCOMPARE(found.charFormat().verticalAlignment(), QTextCharFormat::AlignSubScript);
        QCOMPARE(found.charFormat().property(QTextFormat::FontSizeAdjustment).toInt(), 0);
    }

    void savesTheValidationDocument() {
        setWindowLanguage(Language::Id::english);
        const QTemporaryDir folder;
        const QString path = folder.filePath("validation.pdf");
        HelpWindow help;
        auto *save = help.findChild<QPushButton *>("saveValidation");
        help.showPage("workflow");
        QVERIFY(save->isHidden());
        help.showPage("validation");
        QVERIFY(!save->isHidden() && !help.text().contains("Linear axes"));
        QTimer::singleShot(0, &help, [&] {
            auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            dialog->selectFile(path);
            QMetaObject::invokeMethod(dialog, "accept");
        });
        save->click();
        QVERIFY(!save->isEnabled());
        QTRY_VERIFY(save->isEnabled()); // all sets are simulated in the background
        QVERIFY2(help.text().contains("Linear axes"), qPrintable(help.text().left(2000)));
        QVERIFY(!help.text().contains("DOES NOT AGREE"));
        QFile pdf(path);
        QVERIFY(pdf.open(QIODevice::ReadOnly) && pdf.read(5) == "%PDF-");
    }

    void theMenuLeadsToTheValidation() {
        const ShownWindow shown;
        shown.find<QAction>("validation")->trigger();
        QCOMPARE(shown.find<HelpWindow>("helpWindow")->currentPage(), QString("validation"));
    }

    void anUnknownPageIsTheFirst() {
        HelpWindow help;
        help.showPage("nothing");
        QCOMPARE(help.currentPage(), QString("workflow"));
    }
};

QTEST_MAIN(HelpWindowTest)
#include "helpwindowtest.moc"
