// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/settingsdialog.h"
#include "ui/window/shownwindow.h"

#include "document/savedocument.h"
#include "ui/model/settings.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QListWidget>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

/// The settings hold at once, for all windows, and are there again after a start.
class SettingsDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setThemeChoice(ThemeChoice::system);
        setWindowLanguage(Language::Id::english);
    }
    void cleanup() { setThemeChoice(ThemeChoice::system); }
    void languageAndUnitsHoldAtOnce();
    void theThemeHoldsAtOnce();
    void theVersionBeforeIsKeptOnRequest();
    void noCopiesWhereNoneAreWanted();
};

namespace {

SettingsDialog *opened(const ShownWindow &shown) {
    shown.find<QAction>("settings")->trigger();
    return shown.window->findChild<SettingsDialog *>();
}

void choose(const QDialog &dialog, const char *name, int index) {
    auto *box = dialog.findChild<QComboBox *>(QLatin1StringView(name));
    QVERIFY(box);
    box->setCurrentIndex(index);
    emit box->activated(index);
}

} // namespace

void SettingsDialogTest::languageAndUnitsHoldAtOnce() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    const SettingsDialog *dialog = opened(shown);
    QVERIFY(dialog && dialog->isVisible());
    choose(*dialog, "settingsLanguage", 0);
    QTRY_COMPARE(shown.find<QTabBar>("pageTabs")->tabText(0), u"&Relevés"_s);
    QTRY_COMPARE(dialog->windowTitle(), u"Paramètres"_s);
    QCOMPARE(dialog->findChild<QComboBox *>(u"settingsLanguage"_s)->currentIndex(), 0);
    choose(*dialog, "settingsLengths", 1);
    QCOMPARE(windowLanguage().units().lengths, LengthDisplay::millimetres);
    choose(*dialog, "settingsAngles", 1);
    QCOMPARE(windowLanguage().units().angles, AngleDisplay::degrees);
    QCOMPARE(windowLanguage().units().lengths, LengthDisplay::millimetres);
    setWindowUnits({});
    choose(*dialog, "settingsLanguage", 1);
    QTRY_COMPARE(shown.find<QTabBar>("pageTabs")->tabText(0), u"&Readings"_s);
}

void SettingsDialogTest::theThemeHoldsAtOnce() {
    const ShownWindow shown(examplePath("rotary-axis"));
    const SettingsDialog *dialog = opened(shown);
    choose(*dialog, "settingsTheme", static_cast<int>(ThemeChoice::dark));
    QVERIFY(isDark(QApplication::palette()));
    QTRY_VERIFY(isDark(shown.window->palette()));
    QVERIFY(qApp->styleSheet().contains(u"check-dark"_s));
    QCOMPARE(themeChoice(), ThemeChoice::dark);
    // An unchecked box is to be seen on its ground.
    const auto lightest = [](const QImage &picture, int y) {
        int value = 0;
        for (int x = 0; x < 20; ++x)
            value = std::max(value, qGray(picture.pixel(x, y)));
        return value;
    };
    const int ground = qGray(QApplication::palette().color(QPalette::Window).rgb());
    const QImage box = dialog->findChild<QCheckBox *>(u"settingsBackup"_s)->grab().toImage();
    QVERIFY2(lightest(box, box.height() / 2) > ground + 30, qPrintable(QString::number(ground)));
    QListWidget list;
    list.addItem(u"edition"_s);
    list.item(0)->setCheckState(Qt::Unchecked);
    list.setFrameShape(QFrame::NoFrame);
    list.show();
    const QRect row = list.visualItemRect(list.item(0));
    QVERIFY(lightest(list.viewport()->grab().toImage(), row.center().y()) > ground + 30);
    choose(*dialog, "settingsTheme", static_cast<int>(ThemeChoice::light));
    QVERIFY(!isDark(QApplication::palette()));
    QCOMPARE(QApplication::palette().color(QPalette::Base), QColor(Qt::white));
    choose(*dialog, "settingsTheme", static_cast<int>(ThemeChoice::system));
    QCOMPARE(themeChoice(), ThemeChoice::system);
}

void SettingsDialogTest::theVersionBeforeIsKeptOnRequest() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.palmer"_s);
    saveDocument(openDocument(examplePath("rotary-axis")), path);
    const QByteArray before = readBytes(path);
    const ShownWindow shown(path);
    QVERIFY(shown.window->saveTo(path));
    QVERIFY(!QFile::exists(path + u".bak"_s)); // nobody asked
    const SettingsDialog *dialog = opened(shown);
    dialog->findChild<QCheckBox *>(u"settingsBackup"_s)->click();
    QVERIFY(keepsBackups());
    shown.window->model().edit("set the edition of the test",
                               [](Document &document) { document.report.number = "17"; });
    QVERIFY(shown.window->saveTo(path));
    QCOMPARE(readBytes(path + u".bak"_s), before);
    QVERIFY(readBytes(path) != before);
    // Where that cannot be kept the file stays as it is, and it is said.
    QVERIFY(QFile::remove(path + u".bak"_s));
    QVERIFY(QDir(folder.path()).mkdir(u"a.palmer.bak"_s));
    shown.window->model().edit("set the edition of the test",
                               [](Document &document) { document.report.number = "18"; });
    const QByteArray saved = readBytes(path);
    QVERIFY(!shown.window->saveTo(path));
    QCOMPARE(readBytes(path), saved);
    QVERIFY(shown.window->isWindowModified());
}

void SettingsDialogTest::noCopiesWhereNoneAreWanted() {
    for (const bool wanted : {true, false}) {
        const ShownWindow shown(examplePath("rotary-axis"));
        const SettingsDialog *dialog = opened(shown);
        auto *box = dialog->findChild<QCheckBox *>(u"settingsAutosave"_s);
        QVERIFY(box->isChecked());
        if (!wanted)
            box->click();
        int saved = 0;
        connect(&shown.window->autosave(), &Autosave::saved, this, [&saved] { ++saved; });
        shown.window->autosave().setDelay(1);
        shown.window->model().edit("set the edition of the test",
                                   [](Document &document) { document.report.number = "17"; });
        if (wanted)
            QTRY_COMPARE(saved, 1);
        else
            QTest::qWait(300);
        QCOMPARE(saved, wanted ? 1 : 0);
    }
}

QTEST_MAIN(SettingsDialogTest)
#include "settingsdialogtest.moc"
