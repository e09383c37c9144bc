#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/dialogs/reportdialog.h"
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
    }
    void click(const char *name) {
        auto *button = dialog.findChild<QAbstractButton *>(QLatin1StringView(name));
        QVERIFY2(button, name);
        button->click();
    }
    ReportDialog dialog;
};

} // namespace

class ReportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }
    void savesWhatItShows();
    void savesAFileForEachLanguage();
    void doesNotSpeakTheLanguageOfTheWindow();
    void choicesAreEditsOfTheDocument();
    void printsTheFilesEditionAndNoView();
    void prints();
    void saysWhySavingFailed();
    void asksBeforeItReplacesAFile_data();
    void asksBeforeItReplacesAFile();
    void leavesTestFilesAlone();
};

void ReportDialogTest::savesWhatItShows() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    ShownDialog shown(window);
    shown.click("reportEnglish");
    QVERIFY(shown.dialog.pageCount() > 1);
    const QString path = folder.filePath(QStringLiteral("report.pdf"));
    QCOMPARE(shown.dialog.saveTo(path), QStringList{path});
    QCOMPARE(pagesOf(path), shown.dialog.pageCount());
    QVERIFY(textOf(path).contains(QStringLiteral("RE-2026-001")));
}

void ReportDialogTest::savesAFileForEachLanguage() {
    const QTemporaryDir folder;
    const ShownWindow window(examplePath("rotary-axis"));
    ShownDialog shown(window);
    shown.click("reportBoth");
    QCOMPARE(shown.dialog.saveTo(folder.filePath(QStringLiteral("report.pdf"))),
             QStringList({folder.filePath(QStringLiteral("report.fr.pdf")),
                          folder.filePath(QStringLiteral("report.en.pdf"))}));
    QVERIFY(textOf(folder.filePath(QStringLiteral("report.fr.pdf"))).contains(QStringLiteral("exactitude")));
    QVERIFY(textOf(folder.filePath(QStringLiteral("report.en.pdf"))).contains(QStringLiteral("accuracy")));
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
