// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/alldialogs.h"

#include "document/savedocument.h"
#include "editing/newtest.h"

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
#include <QTemporaryDir>
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
        qobject_cast<const QLineEdit *>(widget->parentWidget()) ||
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
                          Page::conditions,     Page::agreedPoints, Page::limits,      Page::uncertainty,
                          Page::comparison,     Page::diagnosis};

} // namespace

class AccessibilityTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void everyControlHasAName_data();
    void everyControlHasAName();
    void everyDialogIsSpoken_data() { everyControlHasAName_data(); }
    void everyDialogIsSpoken();
    void figuresSayWhatTheyShow_data() { everyControlHasAName_data(); }
    void figuresSayWhatTheyShow();
    void mnemonicsDoNotClash_data() { everyControlHasAName_data(); }
    void mnemonicsDoNotClash();
    void tabReachesEveryControl_data() { everyControlHasAName_data(); }
    void tabWalksDialogsInTheOrderOfReading();
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
    const QTemporaryDir folder;
    const QString drift = folder.filePath(QStringLiteral("drift.palmer"));
    Document document = openDocument(examplePath("rotary-axis"));
    insertTest(document, 0, newDriftTest(Axis{}));
    saveDocument(document, drift);
    for (const QString &file : {QString(), examplePath("long-axis-with-zone"), examplePath("one-direction"),
                                examplePath("iso230-4-full-circles-xy"), drift}) {
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

void AccessibilityTest::everyDialogIsSpoken() {
    QFETCH(Language::Id, language);
    setWindowLanguage(language);
    const QTemporaryDir folder;
    RegisterService service(folder.filePath(QStringLiteral("register.sqlite")), {});
    const ShownWindow shown(examplePath("rotary-axis"));
    for (const auto &dialog : allDialogs(*shown.window, service)) {
        dialog->show();
        QCoreApplication::processEvents();
        int seen = 0;
        for (QWidget *widget : dialog->findChildren<QWidget *>()) {
            if (!isControl(widget) || !widget->isVisibleTo(dialog.get()))
                continue;
            ++seen;
            QVERIFY2(!spoken(widget).isEmpty(), qPrintable(path(widget)));
        }
        QVERIFY2(seen > 0, qPrintable(path(dialog.get())));
        QVERIFY2(!dialog->windowTitle().isEmpty(), qPrintable(path(dialog.get())));
        std::map<QChar, QString> taken;
        checkWidgets(*dialog, taken);
    }
}

/// A figure cannot be read aloud: a sentence of what is on it can.
void AccessibilityTest::figuresSayWhatTheyShow() {
    QFETCH(Language::Id, language);
    setWindowLanguage(language);
    QStringList said;
    for (const char *name : {"rotary-axis", "iso230-2-1988-example", "iso230-4-full-circles-xy"}) {
        const ShownWindow shown(examplePath(name));
        auto *canvas = shown.find("figureCanvas");
        if (!canvas->isVisible())
            canvas = shown.find("circleCanvas");
        QVERIFY(canvas->isVisible());
        const QString sentence = canvas->accessibleDescription();
        QVERIFY2(sentence.size() > 20 && !said.contains(sentence), qPrintable(sentence));
        said << sentence;
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

/// Once around, and never else to what stands wholly above, unless that is in a column further right.
void AccessibilityTest::tabWalksDialogsInTheOrderOfReading() {
    const QTemporaryDir folder;
    RegisterService service(folder.filePath(QStringLiteral("register.sqlite")), {});
    const ShownWindow shown(examplePath("rotary-axis"));
    for (const auto &dialog : allDialogs(*shown.window, service)) {
        if (!qobject_cast<QDialog *>(dialog.get()))
            continue;
        dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog.get()));
        std::vector<QWidget *> chain;
        for (QWidget *widget = dialog->nextInFocusChain(); widget != dialog.get();
             widget = widget->nextInFocusChain()) {
            if (widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) &&
                !widget->focusProxy() && widget->window() == dialog.get())
                chain.push_back(widget);
        }
        const auto areaOf = [&](const QWidget *widget) {
            return QRect(widget->mapTo(dialog.get(), QPoint()), widget->size());
        };
        int upwards = 0;
        QString where;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            const QWidget *next = chain[(i + 1) % chain.size()];
            const QRect from = areaOf(chain[i]);
            const QRect to = areaOf(next);
            if (to.bottom() <= from.top() && to.left() < from.right()) {
                ++upwards;
                where += QStringLiteral("%1 to %2\n").arg(path(chain[i]), path(next));
            }
        }
        QVERIFY2(upwards <= 1, qPrintable(where)); // from the end to the beginning
        dialog->hide();
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
