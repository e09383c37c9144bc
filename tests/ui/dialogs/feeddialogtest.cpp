// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/dialogs/feeddialog.h"
#include "ui/window/shownwindow.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;

namespace {

QLineEdit *box(const QWidget &dialog, const char *name) {
    return dialog.findChild<QLineEdit *>(QLatin1StringView(name));
}

QString feed(const QWidget &dialog) {
    return dialog.findChild<QLabel *>("feed")->text();
}

} // namespace

/// The calculator of annex C of ISO 230-4.
class FeedDialogTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void beginsWithTheExampleOfTheAnnex() {
        const FeedDialog dialog;
        QCOMPARE(box(dialog, "specifiedDiameter")->text(), "100");
        QCOMPARE(feed(dialog), "559\u00A0mm/min");
    }

    void computesWhileTyping() {
        FeedDialog dialog;
        dialog.show();
        QLineEdit *diameter = box(dialog, "diameter");
        diameter->setFocus();
        diameter->selectAll();
        QTest::keyClicks(diameter, "400");
        QCOMPARE(feed(dialog), "1\u202F000\u00A0mm/min");
        box(dialog, "specifiedFeed")->selectAll();
        QTest::keyClicks(box(dialog, "specifiedFeed"), "40");
        QCOMPARE(feed(dialog), "80.0\u00A0mm/min");
        dialog.setNumbers({50, -1, 0}); // what is not above 0 changes nothing
        QCOMPARE(box(dialog, "specifiedFeed")->text(), "40");
        QCOMPARE(box(dialog, "diameter")->text(), "400");
    }

    void speaksTheLanguageOfTheWindow() {
        FeedDialog dialog;
        dialog.setNumbers({62.5, 500, 125});
        QCOMPARE(box(dialog, "specifiedDiameter")->text(), "62.5");
        setWindowLanguage(Language::Id::french);
        QCoreApplication::sendPostedEvents();
        QCOMPARE(dialog.windowTitle(), "Vitesse d’avance de contournage");
        QCOMPARE(box(dialog, "specifiedDiameter")->text(), "62,5");
        QCOMPARE(feed(dialog), "707\u00A0mm/min");
    }

    void takesTheNumbersOfTheTestAtHand() {
        const ShownWindow shown(examplePath("iso230-4-full-circles-xy"));
        QTRY_VERIFY(shown.window->hasDocument());
        shown.window->findChild<QAction *>("contouringFeed")->trigger();
        const auto *dialog = shown.window->findChild<FeedDialog *>();
        QVERIFY(dialog);
        QCOMPARE(box(*dialog, "diameter")->text(), "300");
        QCOMPARE(box(*dialog, "specifiedDiameter")->text(), "300");
        QCOMPARE(feed(*dialog), "1\u202F000\u00A0mm/min");
    }
};

QTEST_MAIN(FeedDialogTest)
#include "feeddialogtest.moc"
