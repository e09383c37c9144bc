// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/search.h"

#include "ui/window/shownwindow.h"

#include <QAction>
#include <QLineEdit>
#include <QListView>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

/// One search over fields, results, findings and settings.
class SearchTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }

    void accentsAndCaseDoNotMatter() {
        const std::vector<SearchEntry> entries{
            {SearchGroup::settings, u"Réglages"_s, {}, u"Outils"_s, {}},
            {SearchGroup::fields, u"Durée du réglage"_s, u"5 s"_s, u"Conditions"_s, {}},
            {SearchGroup::fields, u"Réglage"_s, {}, u"Conditions"_s, {}},
            {SearchGroup::fields, u"Autre"_s, u"reglage"_s, {}, {}},
        };
        const auto hits = search(entries, u" REGLAGE "_s);
        QCOMPARE(hits.size(), std::size_t(4));
        QCOMPARE(hits[0].entry.name, u"Réglage"_s); // begins with it
        QCOMPARE(hits[1].entry.name, u"Durée du réglage"_s);
        QCOMPARE(hits[1].begin, 9);
        QCOMPARE(hits[2].begin, -1); // only its value says so
        QVERIFY(hits[3].entry.group == SearchGroup::settings);
        QVERIFY(search(entries, u"  "_s).empty() && search(entries, u"xyz"_s).empty());
    }

    /// Ctrl+F, a word, Enter: the field has the keyboard, on its page.
    void enterGoesToTheField() {
        const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        auto *box = shown.find<QLineEdit>("searchBox");
        shown.find<QAction>("search")->trigger();
        QTRY_VERIFY(box->hasFocus());
        QTest::keyClicks(box, "temperature grad");
        auto *list = shown.find<QListView>("searchList");
        QTRY_VERIFY(list->isVisible());
        QVERIFY(list->currentIndex().data().toString().startsWith("Temperature gradient"));
        QVERIFY(list->parentWidget()->geometry().right() <= shown.window->width());
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(!list->isVisible() && box->text().isEmpty());
        QCOMPARE(shown.window->workplace().selection().page(), Page::conditions);
        QTRY_VERIFY(QApplication::focusWidget() && QApplication::focusWidget() != box &&
                    QApplication::focusWidget()->accessibleName().startsWith("Temperature gradient"));
    }

    /// A point that may be agreed is found, whether it is stated or not.
    void agreedPointsAreFound() {
        const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        auto *box = shown.find<QLineEdit>("searchBox");
        shown.find<QAction>("search")->trigger();
        QTRY_VERIFY(box->hasFocus());
        QTest::keyClicks(box, "first and last");
        QTRY_VERIFY(shown.find<QListView>("searchList")->isVisible());
        QCOMPARE(shown.find<QListView>("searchList")->currentIndex().data().toString(),
                 u"First and last target"_s);
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(shown.window->workplace().selection().page(), Page::agreedPoints);
        QTRY_VERIFY(QApplication::focusWidget() &&
                    QApplication::focusWidget()->objectName() == u"field.agreedPoints.firstLastTarget"_s);
    }

    /// Results, findings and commands; arrows pass the heads, Ctrl+Enter stays, Esc ends.
    void allGroupsAreReachedByKeys() {
        const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        auto *box = shown.find<QLineEdit>("searchBox");
        shown.find<QAction>("search")->trigger();
        QTRY_VERIFY(box->hasFocus());
        QTest::keyClicks(box, "repeatability");
        auto *list = shown.find<QListView>("searchList");
        QTRY_VERIFY(list->isVisible());
        QTest::keyClick(box, Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(list->isVisible() && box->hasFocus());
        QVERIFY(!shown.window->workplace().selection().parameter().isEmpty());
        box->selectAll();
        QTest::keyClicks(box, "francais");
        QTRY_COMPARE(list->currentIndex().data().toString(), u"Français"_s);
        QTest::keyClick(box, Qt::Key_Escape);
        QVERIFY(!list->isVisible() && box->text().isEmpty());
    }

    /// Ctrl+Alt+plus and minus change the texts of the window at once; 0 gives the usual size again.
    void theSizeOfTextsIsChosen() {
        const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
        const double usual = QApplication::font().pointSizeF();
        shown.find<QAction>("largerText")->trigger();
        QVERIFY(QApplication::font().pointSizeF() > usual);
        shown.find<QAction>("smallerText")->trigger();
        shown.find<QAction>("smallerText")->trigger();
        QVERIFY(QApplication::font().pointSizeF() < usual);
        for (int i = 0; i < 20; ++i)
            shown.find<QAction>("smallerText")->trigger();
        QVERIFY(QApplication::font().pointSizeF() > usual / 2);
        shown.find<QAction>("normalText")->trigger();
        QCOMPARE(QApplication::font().pointSizeF(), usual);
    }
};

QTEST_MAIN(SearchTest)
#include "searchtest.moc"
