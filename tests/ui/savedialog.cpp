// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/saving.h"

#include <QDir>
#include <QLineEdit>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer::ui;
using namespace Qt::StringLiterals;

/// What a file is saved as, typed by hand.
class SaveDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void endings_data() {
        QTest::addColumn<int>("chosen");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("saved");
        QTest::addColumn<int>("filter");
        QTest::newRow("none") << 0 << u"figure"_s << u"figure.pdf"_s << 0;
        QTest::newRow("that of the filter") << 0 << u"figure.PDF"_s << u"figure.PDF"_s << 0;
        QTest::newRow("that of another filter") << 0 << u"figure.svg"_s << u"figure.svg"_s << 1;
        QTest::newRow("of another program") << 0 << u"figure.jpg"_s << u"figure.jpg.pdf"_s << 0;
        QTest::newRow("a number") << 1 << u"Report 3.5"_s << u"Report 3.5.svg"_s << 1;
        QTest::newRow("any") << 2 << u"Report 3.5"_s << u"Report 3.5"_s << 2;
    }

    void endings() {
        QFETCH(int, chosen);
        QFETCH(QString, typed);
        const QTemporaryDir folder;
        const QStringList filters{u"PDF (*.pdf)"_s, u"SVG (*.svg)"_s, u"All files (*)"_s};
        SaveDialog dialog(nullptr, u"Save"_s, filters, folder.path());
        dialog.setOption(QFileDialog::DontUseNativeDialog);
        dialog.open();
        dialog.selectNameFilter(filters[chosen]);
        emit dialog.filterSelected(filters[chosen]);
        dialog.findChild<QLineEdit *>(u"fileNameEdit"_s)->setText(typed);
        QTest::keyClick(&dialog, Qt::Key_Return);
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const QString path = dialog.selectedFiles().value(0);
        QTEST(QDir(folder.path()).relativeFilePath(path), "saved");
        QTEST(int(dialog.filterOf(path)), "filter");
    }

    void foldersAreEntered() {
        const QTemporaryDir folder;
        QVERIFY(QDir(folder.path()).mkdir(u"2026.11"_s));
        SaveDialog dialog(nullptr, u"Save"_s, {u"PDF (*.pdf)"_s}, folder.path());
        dialog.setOption(QFileDialog::DontUseNativeDialog);
        dialog.open();
        dialog.findChild<QLineEdit *>(u"fileNameEdit"_s)->setText(u"2026.11"_s);
        QTest::keyClick(&dialog, Qt::Key_Return);
        QVERIFY(dialog.isVisible());
        QCOMPARE(dialog.directory().dirName(), u"2026.11"_s);
    }
};

QTEST_MAIN(SaveDialogTest)
#include "savedialog.moc"
