// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/circles/arcdialog.h"
#include "ui/dialogs/newcircledialog.h"
#include "ui/dialogs/newtestdialog.h"
#include "ui/window/shownwindow.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAccessible>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <map>

using namespace palmer;
using namespace palmer::ui;

namespace {

/// What a screen reader says of a widget.
QString spoken(QWidget *widget) {
    QAccessibleInterface *interface = QAccessible::queryAccessibleInterface(widget);
    return interface ? interface->text(QAccessible::Name) : QString();
}

QString path(const QWidget *widget) {
    QStringList names;
    for (; widget; widget = widget->parentWidget())
        names.prepend(QString::fromLatin1(widget->metaObject()->className()) + u'#' + widget->objectName());
    return names.join(u'/');
}

/// Those a user can do something with; parts of composed widgets are spoken by the whole.
bool isControl(const QWidget *widget) {
    if (widget->objectName().startsWith(QLatin1StringView("qt_")) || qobject_cast<const QScrollBar *>(widget))
        return false;
    if (qobject_cast<const QAbstractItemView *>(widget->parentWidget()) ||
        qobject_cast<const QComboBox *>(widget->parentWidget()) ||
        qobject_cast<const QTabBar *>(widget->parentWidget()))
        return false;
    return qobject_cast<const QAbstractButton *>(widget) || qobject_cast<const QComboBox *>(widget) ||
           qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QAbstractItemView *>(widget) ||
           qobject_cast<const QTabBar *>(widget) || widget->focusPolicy() != Qt::NoFocus;
}

QChar mnemonic(const QString &text) {
    for (qsizetype i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != u'&')
            continue;
        if (text[i + 1] == u'&')
            ++i;
        else
            return text[i + 1].toLower();
    }
    return {};
}

/// Adds a mnemonic; what else has it already is returned.
QString take(std::map<QChar, QString> &taken, const QString &text) {
    const QChar key = mnemonic(text);
    if (key.isNull())
        return {};
    const auto [found, added] = taken.emplace(key, text);
    return added ? QString() : found->second;
}

void checkMenus(const QWidget &window, std::map<QChar, QString> &ofWindow) {
    const auto *bar = window.findChild<QMenuBar *>();
    QVERIFY(bar);
    for (const QAction *title : bar->actions()) {
        QVERIFY2(!mnemonic(title->text()).isNull(), qPrintable(title->text()));
        const QString clash = take(ofWindow, title->text());
        QVERIFY2(clash.isEmpty(), qPrintable(title->text() + " and " + clash));
        std::map<QChar, QString> ofMenu;
        for (const QAction *action : title->menu()->actions()) {
            if (action->isSeparator())
                continue;
            QVERIFY2(!mnemonic(action->text()).isNull(), qPrintable(action->text()));
            const QString other = take(ofMenu, action->text());
            QVERIFY2(other.isEmpty(), qPrintable(action->text() + " and " + other));
        }
    }
}

void checkWidgets(const QWidget &window, std::map<QChar, QString> &taken) {
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (!widget->isVisibleTo(&window))
            continue;
        QStringList texts;
        if (const auto *button = qobject_cast<const QAbstractButton *>(widget);
            button && !qobject_cast<const QToolButton *>(widget))
            texts += button->text();
        else if (const auto *label = qobject_cast<const QLabel *>(widget); label && label->buddy())
            texts += label->text();
        else if (const auto *tabs = qobject_cast<const QTabBar *>(widget))
            for (int i = 0; i < tabs->count(); ++i)
                texts += tabs->tabText(i);
        for (const QString &text : texts) {
            const QString clash = take(taken, text);
            QVERIFY2(clash.isEmpty(), qPrintable(text + " and " + clash));
        }
    }
}

void checkMnemonics(const QWidget &window) {
    std::map<QChar, QString> taken;
    checkMenus(window, taken);
    checkWidgets(window, taken);
}

void checkDialog(const QDialog &dialog) {
    std::map<QChar, QString> taken;
    checkWidgets(dialog, taken);
    QVERIFY(!taken.empty());
    for (QWidget *field : dialog.findChildren<QWidget *>()) {
        if (field->isVisibleTo(&dialog) && isControl(field))
            QVERIFY2(!spoken(field).isEmpty(), qPrintable(path(field)));
    }
}

constexpr Page pages[] = {Page::identification, Page::machine,      Page::instruments, Page::readings,
                          Page::conditions,     Page::agreedPoints, Page::limits,      Page::uncertainty};

} // namespace

class AccessibilityTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void everyControlHasAName_data();
    void everyControlHasAName();
    void mnemonicsDoNotClash_data() { everyControlHasAName_data(); }
    void mnemonicsDoNotClash();
    void tabReachesEveryControl_data() { everyControlHasAName_data(); }
    void tabReachesEveryControl();
    void iconButtonsSayWhatTheyDo_data() { everyControlHasAName_data(); }
    void iconButtonsSayWhatTheyDo();
};

void AccessibilityTest::everyControlHasAName_data() {
    QTest::addColumn<Language::Id>("language");
    QTest::newRow("in English") << Language::Id::english;
    QTest::newRow("in French") << Language::Id::french;
}

void AccessibilityTest::everyControlHasAName() {
    QFETCH(Language::Id, language);
    setWindowLanguage(language);
    for (const QString &file : {QString(), examplePath("long-axis-with-zone")}) {
        const ShownWindow shown(file);
        for (const Page page : pages) {
            if (!file.isEmpty())
                shown.window->workplace().showPage(page);
            int seen = 0;
            for (QWidget *widget : shown.window->findChildren<QWidget *>()) {
                if (!isControl(widget) || !widget->isVisibleTo(shown.window))
                    continue;
                ++seen;
                QVERIFY2(!spoken(widget).isEmpty(), qPrintable(path(widget)));
            }
            QVERIFY(seen > 3);
        }
    }
}

void AccessibilityTest::mnemonicsDoNotClash() {
    QFETCH(Language::Id, language);
    setWindowLanguage(language);
    const Language words(language);
    CircularMeasurement circle;
    circle.nominalRadius = 100;
    NewTestDialog newTest(words);
    NewCircleDialog newCircle(words);
    palmer::Test other;
    other.title = "X";
    newTest.offerStatementsOf(other);
    newCircle.offerStatementsOf(other);
    checkDialog(newTest);
    checkDialog(newCircle);
    checkDialog(ArcDialog(circle, words, QStringLiteral("1.5\n2.5\n3.5\n")));
    checkDialog(ArcDialog(circle, words, QString()));
    const ShownWindow welcome;
    checkMnemonics(*welcome.window);
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    auto *edition = shown.find<QComboBox>("edition");
    emit edition->activated(edition->findData(QStringLiteral("ISO 230-2:1988")));
    for (const Page page : pages) {
        shown.window->workplace().showPage(page);
        checkMnemonics(*shown.window);
    }
    shown.window->evaluator().setView(0, "ISO 230-2:2014");
    checkMnemonics(*shown.window);
}

void AccessibilityTest::tabReachesEveryControl() {
    QFETCH(Language::Id, language);
    setWindowLanguage(language);
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    for (const Page page : pages) {
        shown.window->workplace().showPage(page);
        QSet<QWidget *> wanted;
        for (QWidget *widget : shown.window->findChildren<QWidget *>()) {
            if (isControl(widget) && widget->isVisible() && widget->isEnabled() &&
                (widget->focusPolicy() & Qt::TabFocus) && !widget->focusProxy())
                wanted += widget;
        }
        QVERIFY(wanted.size() > 5);
        QWidget *widget = shown.window;
        QSet<QWidget *> chain;
        do {
            chain += widget;
            widget = widget->nextInFocusChain();
        } while (widget && widget != shown.window && !chain.contains(widget));
        for (QWidget *control : wanted)
            QVERIFY2(chain.contains(control), qPrintable(path(control)));
    }
}

void AccessibilityTest::iconButtonsSayWhatTheyDo() {
    QFETCH(Language::Id, language);
    setWindowLanguage(language);
    const ShownWindow shown(examplePath("rotary-axis"), QSize(1024, 768));
    int seen = 0;
    for (const QToolButton *button : shown.window->findChildren<QToolButton *>()) {
        if (!isControl(button) || button->icon().isNull())
            continue;
        ++seen;
        QVERIFY2(!button->toolTip().isEmpty(), qPrintable(path(button)));
    }
    QVERIFY(seen > 5);
}

QTEST_MAIN(AccessibilityTest)
#include "accessibilitytest.moc"
