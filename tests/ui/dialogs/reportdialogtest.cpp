// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/dialogs/reportdialog.h"
#include "document/edits.h"
#include "ui/window/shownwindow.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPrinter>
#include <QProcess>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;

namespace {

QString textOf(const QString &pdf) {
    QProcess process;
    process.start(QStringLiteral("pdftotext"), {pdf, QStringLiteral("-")});
    if (!process.waitForFinished())
        return {};
    return QString::fromUtf8(process.readAllStandardOutput()).simplified();
}

int pagesOf(const QString &pdf) {
    QProcess process;
    process.start(QStringLiteral("pdfinfo"), {pdf});
    process.waitForFinished();
    const QString text = QString::fromUtf8(process.readAllStandardOutput());
    return text.section(QStringLiteral("Pages:"), 1).section(u'\n', 0, 0).trimmed().toInt();
}

/// A dialog on the window's document.
struct ShownDialog {
    explicit ShownDialog(const ShownWindow &shown)
        : dialog(shown.window->model(), shown.window->evaluator(), shown.window) {
        dialog.show();
        compose();
    }
    void compose() { QTRY_VERIFY(!dialog.isComposing()); }
    void click(const char *name) {
        auto *button = dialog.findChild<QAbstractButton *>(QLatin1StringView(name));
        QVERIFY2(button, name);
        button->click();
        compose();
    }
    /// Returns the files written.
    QStringList save(const QString &path) {
        QSignalSpy saved(&dialog, &ReportDialog::saved);
        dialog.saveTo(path);
        return saved.count() > 0 || saved.wait(patience) ? saved.front().front().toStringList()
                                                         : QStringList();
    }
    ReportDialog dialog;
};

/// A few trials are enough where files are asked for and not what a simulation says.
void simulateQuickly(const ShownWindow &shown) {
    shown.window->model().edit("trials", [](Document &document) {
        editMeasurement<PositioningMeasurement>(
            document, 0, [](PositioningMeasurement &measurement) { measurement.uncertainty.trials = 500; });
    });
}

} // namespace

class ReportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void beginsWithTheTestThatIsAskedFor();
    void init() { setWindowLanguage(Language::Id::english); }
    void savesWhatItShows();
    void savesAFileForEachLanguage();
    void doesNotSpeakTheLanguageOfTheWindow();
    void choicesAreEditsOfTheDocument();
    void choicesTakenBackGiveTheReportOfBefore();
    void aPageOfDiagnosisOnRequest();
    void printsTheFilesEditionAndNoView();
    void prints();
    void saysWhySavingFailed();
    void twoLanguagesAreOneStep();
    void asksBeforeItReplacesAFile_data();
    void asksBeforeItReplacesAFile();
    void leavesTestFilesAlone();
};

/// And stays there when a simulation brings other results.
void ReportDialogTest::beginsWithTheTestThatIsAskedFor() {
    const ShownWindow window(examplePath("x-axis-as-found-as-left"));
    ReportDialog dialog(window.window->model(), window.window->evaluator(), window.window);
    dialog.beginAt("test-2");
    dialog.show();
    QTRY_VERIFY(!dialog.isSimulating() && dialog.pageCount() > 2);
    const auto *area = dialog.findChild<QScrollArea *>("pages");
    const int page = area->widget()->height() / dialog.pageCount();
    QVERIFY2(area->verticalScrollBar()->value() > page, qPrintable(QString::number(page)));
}

void ReportDialogTest::savesWhatItShows() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    ShownDialog shown(window);
    shown.click("reportEnglish");
    QVERIFY(shown.dialog.pageCount() > 1);
    const QString path = folder.filePath(QStringLiteral("report.pdf"));
    QCOMPARE(shown.save(path), QStringList{path});
    QCOMPARE(pagesOf(path), shown.dialog.pageCount());
    QVERIFY(textOf(path).contains(QStringLiteral("RE-2026-001")));
    QVERIFY(textOf(path).contains(QStringLiteral("self-test against reference data passed")));
}

void ReportDialogTest::savesAFileForEachLanguage() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    simulateQuickly(window);
    ShownDialog shown(window);
    shown.click("reportBoth");
    QCOMPARE(shown.save(folder.filePath(QStringLiteral("report.pdf"))),
             QStringList({folder.filePath(QStringLiteral("report.fr.pdf")),
                          folder.filePath(QStringLiteral("report.en.pdf"))}));
    QVERIFY(textOf(folder.filePath(QStringLiteral("report.fr.pdf"))).contains(QStringLiteral("Exactitude")));
    QVERIFY(textOf(folder.filePath(QStringLiteral("report.en.pdf"))).contains(QStringLiteral("accuracy")));
}

void ReportDialogTest::doesNotSpeakTheLanguageOfTheWindow() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    simulateQuickly(window);
    ShownDialog shown(window);
    shown.click("reportEnglish");
    const QString first = folder.filePath(QStringLiteral("a.pdf")),
                  second = folder.filePath(QStringLiteral("b.pdf"));
    QTRY_VERIFY(!shown.dialog.isSimulating());
    QVERIFY(!shown.save(first).isEmpty());
    setWindowLanguage(Language::Id::french);
    QTRY_COMPARE(shown.dialog.findChild<QAbstractButton *>(QStringLiteral("savePdf"))->text(),
                 QStringLiteral("&Enregistrer le PDF…"));
    QVERIFY(!shown.save(second).isEmpty());
    QVERIFY(!textOf(first).isEmpty());
    QCOMPARE(textOf(second), textOf(first));
}

void ReportDialogTest::choicesAreEditsOfTheDocument() {
    const ShownWindow window(examplePath("rotary-axis"));
    ShownDialog shown(window);
    const auto before = window.window->model().document();
    const int pages = shown.dialog.pageCount();
    shown.click("partReadings");
    shown.click("partTargetTable");
    shown.click("partAnnex");
    shown.click("signLaboratory");
    const ReportHead &head = window.window->model().document()->report;
    QCOMPARE(head.leaveOut.size(), before->report.leaveOut.size() + 3);
    QVERIFY(head.signatures != before->report.signatures);
    QTRY_VERIFY(!shown.dialog.isComposing());
    QVERIFY(shown.dialog.pageCount() < pages); // only the certificate
    auto *paper = shown.dialog.findChild<QComboBox *>(QStringLiteral("paper"));
    emit paper->activated(1);
    QVERIFY(shown.dialog.isComposing()); // not in the event loop's turn
    QVERIFY(!shown.dialog.findChild<QAbstractButton *>("savePdf")->isEnabled());
    QVERIFY(window.window->model().document()->report.paper == Paper::letter);
    QCOMPARE(window.window->model().undoStack()->count(), 1); // one step, whatever was tried out
    window.window->model().undoStack()->undo();
    QVERIFY(*window.window->model().document() == *before);
    shown.compose();
    QCOMPARE(shown.dialog.pageCount(), pages);
}

/// What was composed before is shown again, and never for another document.
void ReportDialogTest::choicesTakenBackGiveTheReportOfBefore() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("one-direction"));
    ShownDialog shown(window);
    shown.click("reportEnglish");
    const auto saved = [&] {
        const QString path = folder.filePath("report.pdf");
        shown.save(path);
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray whole = saved();
    QVERIFY(!whole.isEmpty());
    shown.click("partReadings");
    const QByteArray without = saved();
    QVERIFY(without != whole);
    shown.click("partReadings");
    QCOMPARE(saved(), whole);
    window.window->model().edit("rename", [](Document &document) { document.machine.name = "Another"; });
    shown.compose();
    const QByteArray renamed = saved();
    QVERIFY(renamed != whole && renamed != without);
    window.window->model().undoStack()->undo();
    shown.compose();
    QCOMPARE(saved(), whole);
}

void ReportDialogTest::aPageOfDiagnosisOnRequest() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("iso230-4-full-circles-xy"));
    ShownDialog shown(window);
    QTRY_VERIFY(!shown.dialog.isSimulating());
    const int pages = shown.dialog.pageCount();
    shown.click("extraDiagnosis");
    QVERIFY(window.window->model().document()->report.include.back() == ReportExtra::diagnosis);
    QTRY_VERIFY(!shown.dialog.isSimulating());
    QVERIFY(shown.dialog.pageCount() > pages);
    const QString file = folder.filePath(QStringLiteral("a.pdf"));
    QVERIFY(!shown.save(file).isEmpty());
    const QString text = textOf(folder.filePath(QStringLiteral("a.fr.pdf"))); // of two languages
    QVERIFY(text.contains("Diagnostic du cercle"));
    QVERIFY(text.contains("pas un résultat de l’ISO 230-4"));
}

void ReportDialogTest::printsTheFilesEditionAndNoView() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("iso230-2-1988-example"));
    const QString own = folder.filePath(QStringLiteral("own.pdf")),
                  view = folder.filePath(QStringLiteral("view.pdf"));
    {
        ShownDialog shown(window);
        shown.click("reportEnglish");
        QVERIFY(!shown.save(own).isEmpty());
    }
    window.window->evaluator().setView(0, "ISO 230-2:2014");
    ShownDialog shown(window);
    QVERIFY(!shown.save(view).isEmpty());
    QVERIFY(!textOf(own).isEmpty());
    QCOMPARE(textOf(view), textOf(own));
}

void ReportDialogTest::prints() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    ShownDialog shown(window);
    QPrinter printer(QPrinter::HighResolution);
    const QString path = folder.filePath(QStringLiteral("printed.pdf"));
    printer.setOutputFileName(path);
    QVERIFY(shown.dialog.printOn(printer));
    QCOMPARE(pagesOf(path), shown.dialog.pageCount());
    printer.setPrintRange(QPrinter::PageRange);
    printer.setFromTo(2, 2);
    QVERIFY(shown.dialog.printOn(printer));
    QCOMPARE(pagesOf(path), 1);
}

void ReportDialogTest::saysWhySavingFailed() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    simulateQuickly(window);
    ShownDialog shown(window);
    QVERIFY(shown.save(folder.filePath(QStringLiteral("missing/report.pdf"))).isEmpty());
    auto *box = shown.dialog.findChild<QMessageBox *>(QStringLiteral("errorBox"));
    QVERIFY(box && !box->informativeText().isEmpty());
    box->close();
}

/// The second of two files cannot be written: the first has not changed.
void ReportDialogTest::twoLanguagesAreOneStep() {
    for (const bool there : {true, false}) {
        const QTemporaryDir folder;
        const ShownWindow window(examplePath("rotary-axis"));
        simulateQuickly(window);
        ShownDialog shown(window);
        shown.click("reportBoth");
        const QString first = folder.filePath(QStringLiteral("report.fr.pdf"));
        if (there)
            QVERIFY(QFile::copy(examplePath("rotary-axis"), first));
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("report.en.pdf")));
        QVERIFY(shown.save(folder.filePath(QStringLiteral("report.pdf"))).isEmpty());
        QCOMPARE(textOf(first), QString());
        QCOMPARE(QFileInfo(first).size(), there ? QFileInfo(examplePath("rotary-axis")).size() : 0);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), there ? 1 : 0);
        auto *box = shown.dialog.findChild<QMessageBox *>(QStringLiteral("errorBox"));
        QVERIFY(box && box->text().contains(QStringLiteral("report.en.pdf")));
        box->close();
    }
}

void ReportDialogTest::asksBeforeItReplacesAFile_data() {
    QTest::addColumn<QString>("languages");
    QTest::addColumn<QString>("existing");
    QTest::addColumn<bool>("asks");
    QTest::newRow("one language") << "reportEnglish"
                                  << "r.pdf" << true;
    QTest::newRow("one language, another file") << "reportEnglish"
                                                << "r.fr.pdf" << false;
    QTest::newRow("two languages, the first") << "reportBoth"
                                              << "r.fr.pdf" << true;
    QTest::newRow("two languages, the second") << "reportBoth"
                                               << "r.en.pdf" << true;
    QTest::newRow("two languages, a file that is not written") << "reportBoth"
                                                               << "r.pdf" << false;
}

/// Through the dialog of the user, refused first and then allowed.
void ReportDialogTest::asksBeforeItReplacesAFile() {
    QFETCH(QString, languages);
    QFETCH(QString, existing);
    QFETCH(bool, asks);
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    simulateQuickly(window);
    ShownDialog shown(window);
    shown.click(languages.toUtf8().constData());
    const auto put = [&] {
        QFile file(folder.filePath(existing));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("signed") == 6);
    };
    put();
    int asked = 0;
    bool allow = false;
    QTimer user;
    connect(&user, &QTimer::timeout, this, [&] {
        QWidget *modal = QApplication::activeModalWidget();
        if (auto *dialog = qobject_cast<QFileDialog *>(modal);
            dialog && dialog->objectName() == "pdfDialog") {
            if (asked > 0 && !allow) {
                dialog->reject(); // asked for another name
                return;
            }
            dialog->findChild<QLineEdit *>("fileNameEdit")->setText(folder.filePath("r.pdf"));
            dialog->findChild<QDialogButtonBox *>("buttonBox")->button(QDialogButtonBox::Save)->click();
        } else if (auto *box = qobject_cast<QMessageBox *>(modal); box && box->objectName() == "replaceBox") {
            ++asked;
            if (allow)
                box->findChild<QAbstractButton *>("replace")->click();
            else
                box->button(QMessageBox::Cancel)->click();
        }
    });
    user.start(20);
    QTRY_VERIFY(!shown.dialog.isSimulating());
    const auto content = [&] {
        QFile file(folder.filePath(existing));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    shown.click("savePdf");
    QCOMPARE(asked, asks ? 1 : 0);
    QCOMPARE(content(), QByteArray("signed"));
    if (!asks)
        return;
    allow = true;
    shown.click("savePdf");
    QCOMPARE(asked, 2);
    QTRY_VERIFY(content().startsWith("%PDF-"));
}

/// A report never takes the name of a test file.
void ReportDialogTest::leavesTestFilesAlone() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("test.palmer"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("test") == 4);
    file.close();
    const ShownWindow window(examplePath("rotary-axis"));
    ShownDialog shown(window);
    shown.click("reportEnglish");
    QVERIFY(shown.save(path).isEmpty());
    auto *box = shown.dialog.findChild<QMessageBox *>(QStringLiteral("errorBox"));
    QVERIFY(box && !box->informativeText().isEmpty());
    box->close();
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("test"));
}

QTEST_MAIN(ReportDialogTest)
#include "reportdialogtest.moc"
