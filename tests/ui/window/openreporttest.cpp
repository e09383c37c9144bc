// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/proof/forgery.h"
#include "ui/window/shownwindow.h"

#include "document/readdocument.h"
#include "document/savedocument.h"
#include "ui/proof/reportbar.h"
#include "ui/welcome/recentfiles.h"

#include <QAction>
#include <QFileDialog>
#include <QHashSeed>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace palmer;
using namespace palmer::testdata;
using namespace palmer::ui;

namespace {

QByteArray examplePdf() {
    const Document document = openDocument(QStringLiteral(EXAMPLES "rotary-axis.palmer"));
    return reportPdf(evaluate(std::make_shared<const Document>(document)), Language::Id::english);
}

QMessageBox *errorBox() {
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (widget->objectName() == "errorBox"_L1 && widget->isVisible())
            return qobject_cast<QMessageBox *>(widget);
    }
    return nullptr;
}

} // namespace

/// A report is opened like a test file, and says whether it follows from what it carries.
class OpenReportTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { setWindowLanguage(Language::Id::english); }
    void aReportOpensAsACopy();
    void aForgeryIsShownWithItsPlace();
    void theResultHoldsForWhatWasVerified();
    void aReportCanBeDropped();
    void aDamagedReportIsRefused();

private:
    QString file(const QString &name, const QByteArray &bytes) const {
        const QString path = m_folder.filePath(name);
        saveBytes(bytes, path);
        return path;
    }

    QTemporaryDir m_folder;
    QByteArray m_pdf;
};

void OpenReportTest::initTestCase() {
    prepareApplication();
    m_pdf = examplePdf();
}

void OpenReportTest::aReportOpensAsACopy() {
    const QString path = file(u"report.pdf"_s, m_pdf);
    const ShownWindow window(path);
    auto *bar = window.find<ReportBar>("reportBar");
    QTRY_VERIFY(bar->isVisible());
    QVERIFY2(bar->sentence().startsWith(u"✓ Report verified. The numbers follow from the attached data."_s),
             qPrintable(bar->sentence()));
    QVERIFY(!window.find("reportDifferences")->isVisible());
    QTest::mouseClick(window.find("reportDetails"), Qt::LeftButton);
    QVERIFY(window.find("reportDifferences")->isVisible());
    QVERIFY2(bar->lines().join(u' ').contains(u"byte for byte"_s), qPrintable(bar->lines().join(u' ')));
    setWindowLanguage(Language::Id::french);
    QTRY_VERIFY2(bar->sentence().contains(u"Rapport vérifié."_s), qPrintable(bar->sentence()));
    QVERIFY(bar->sentence().contains(u"découlent"_s));
    setWindowLanguage(Language::Id::english);

    QTRY_VERIFY2(window.window->windowTitle().contains(u"report.pdf (copy)"_s),
                 qPrintable(window.window->windowTitle()));
    QVERIFY(window.window->model().path().isEmpty());
    QVERIFY(!window.window->isWindowModified());
    QCOMPARE(*window.window->model().document(), readDocument(readReportPdf(m_pdf).testFile));
    QTRY_VERIFY(!recentFiles().empty() && recentFiles().front().path == path);

    // Saving asks for a file, and proposes one beside the report; the report stays as it is.
    QString proposed;
    QTimer::singleShot(0, [&] {
        auto *dialog = window.window->findChild<QFileDialog *>(u"saveDialog"_s);
        if (!dialog)
            return;
        proposed = dialog->selectedFiles().value(0);
        dialog->reject();
    });
    window.find<QAction>("save")->trigger();
    QCOMPARE(proposed, m_folder.filePath(u"report.palmer"_s));
    QCOMPARE(readBytes(path), m_pdf);
    QVERIFY(window.window->saveTo(m_folder.filePath(u"copy.palmer"_s)));
    QVERIFY(window.window->windowTitle().startsWith(u"copy.palmer"_s));

    QTest::mouseClick(window.find("closeReportBar"), Qt::LeftButton);
    QVERIFY(!bar->isVisible());
}

void OpenReportTest::aForgeryIsShownWithItsPlace() {
    QByteArray forged;
    for (unsigned seed = 1; forged.isEmpty() || !verified(forged).fingerprintPrinted;
         ++seed) { // another digit
        Random random(seed);
        forged = changed(m_pdf, [&](QPDF &pdf) { QVERIFY(redraw(pdf, 0, random, isDigit, isDigit)); });
    }
    const ShownWindow window(file(u"forged.pdf"_s, forged));
    auto *bar = window.find<ReportBar>("reportBar");
    QTRY_VERIFY(bar->isVisible());
    QVERIFY2(bar->sentence().contains(u"NOT verified. 1 difference"_s), qPrintable(bar->sentence()));
    auto *list = window.find<QListWidget>("reportDifferences");
    QVERIFY(list->isVisible());
    QVERIFY2(bar->lines().front().startsWith(u"page 1: printed “"_s), qPrintable(bar->lines().front()));
    QVERIFY(window.window->hasDocument());
    setWindowLanguage(Language::Id::french);
    QTRY_VERIFY2(bar->lines().front().startsWith(u"page 1\u00A0: imprimé «\u00A0"_s),
                 qPrintable(bar->lines().front()));
}

/// Over edited numbers "Report verified" would be a lie; undone they are the verified ones again.
void OpenReportTest::theResultHoldsForWhatWasVerified() {
    const ShownWindow window(file(u"verified.pdf"_s, m_pdf));
    auto *bar = window.find<ReportBar>("reportBar");
    QTRY_VERIFY(bar->isVisible());
    const QString verified = bar->sentence();
    QVERIFY2(verified.startsWith(u"✓ Report verified."_s), qPrintable(verified));
    window.window->model().edit("change", [](Document &document) { document.machine.name += " 2"; });
    QVERIFY2(bar->sentence().contains(u"no longer shows what was verified"_s), qPrintable(bar->sentence()));
    QVERIFY(!bar->sentence().contains(u'✓'));
    QCOMPARE(bar->lines().value(0), verified); // of the report it still holds
    setWindowLanguage(Language::Id::french);
    QTRY_VERIFY2(!bar->sentence().contains(u'✓'), qPrintable(bar->sentence()));
    setWindowLanguage(Language::Id::english);
    window.find<QAction>("undo")->trigger();
    QTRY_COMPARE(bar->sentence(), verified);
    window.find<QAction>("redo")->trigger();
    QVERIFY(!bar->sentence().contains(u'✓'));
}

void OpenReportTest::aReportCanBeDropped() {
    const QString path = file(u"dropped.PDF"_s, m_pdf);
    const ShownWindow window;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.window, &enter);
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.window, &drop);
    QTRY_VERIFY(window.find<ReportBar>("reportBar")->isVisible());
    window.window->openFile(path); // it is open already
    QTest::qWait(0);
    int count = 0;
    for (QWidget *widget : QApplication::topLevelWidgets())
        count += qobject_cast<MainWindow *>(widget) ? 1 : 0;
    QCOMPARE(count, 1);
}

void OpenReportTest::aDamagedReportIsRefused() {
    const ShownWindow window(file(u"damaged.pdf"_s, m_pdf.first(m_pdf.size() / 2)));
    QTRY_VERIFY(errorBox());
    QVERIFY2(errorBox()->informativeText().contains(u"damaged"_s), qPrintable(errorBox()->informativeText()));
    errorBox()->close();
    QVERIFY(!window.window->hasDocument());
    QVERIFY(!window.find("reportBar")->isVisible());
}

PALMER_TEST(runOpenReportTest) {
    QHashSeed::setDeterministicGlobalSeed();
    QApplication application(argc, argv);
    OpenReportTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "openreporttest.moc"
