// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/alldialogs.h"

#include <QDialogButtonBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTemporaryFile>
#include <QTest>
#include <algorithm>
#include <array>
#include <vector>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

constexpr std::array pages{Page::identification, Page::machine,      Page::instruments, Page::readings,
                           Page::conditions,     Page::agreedPoints, Page::limits,      Page::uncertainty,
                           Page::comparison,     Page::diagnosis};

/// Those of the desktops: the whole, and what a desktop leaves that enlarges all.
constexpr std::array screens{QSize(1280, 800), QSize(1024, 600), QSize(960, 720),
                             QSize(640, 400),  QSize(512, 300),  QSize(480, 360)};
constexpr int title = 24; ///< of a window manager

/// A desktop that has enlarged its fonts while the window is open: those who start it under such a desktop
/// get all of it enlarged.
class EnlargedFonts {
public:
    explicit EnlargedFonts(double factor)
        : m_before(QApplication::font()) {
        QFont font = m_before;
        font.setPointSizeF(font.pointSizeF() * factor);
        QApplication::setFont(font);
    }
    ~EnlargedFonts() { QApplication::setFont(m_before); }
    EnlargedFonts(const EnlargedFonts &) = delete;
    EnlargedFonts &operator=(const EnlargedFonts &) = delete;

private:
    QFont m_before;
};

QScreen *screenOf(QSize size) {
    for (QScreen *screen : QGuiApplication::screens()) {
        if (screen->size() == size)
            return screen;
    }
    qFatal("no such screen");
}

QString sizes(const QString &name, QSize is, QSize room) {
    return u"%1: %2 x %3 of %4 x %5"_s.arg(name)
        .arg(is.width())
        .arg(is.height())
        .arg(room.width())
        .arg(room.height());
}

/// What a window cannot be made smaller than.
QSize leastOf(const QWidget &window) {
    return window.minimumSize().isEmpty() ? window.minimumSizeHint().expandedTo(window.minimumSize())
                                          : window.minimumSize();
}

} // namespace

/// No window and no dialog is larger than the screen.
class ScreenFitTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }
    void everythingFitsItsScreen_data();
    void everythingFitsItsScreen();
    void aDialogThatFitsIsLeftAlone();
    void allIsReachedInASmallDialog();
    void tabBeginsAtTheHeadOfADialog();
    void sixTargetsAreInSightAtTwiceTheScale();
};

void ScreenFitTest::everythingFitsItsScreen_data() {
    QTest::addColumn<Language::Id>("language");
    QTest::addColumn<double>("fonts");
    QTest::addColumn<QSize>("screen");
    const auto add = [](const char *name, Language::Id language, QSize screen, double fonts) {
        QTest::addRow("%s, %d x %d, fonts %g", name, screen.width(), screen.height(), fonts)
            << language << fonts << screen;
    };
    for (const QSize screen : {QSize(1024, 600), QSize(512, 300), QSize(480, 360)})
        add("English", Language::Id::english, screen, 1);
    add("English", Language::Id::english, QSize(960, 720), 1.5);
    for (const QSize screen : {QSize(1024, 600), QSize(640, 400)})
        add("French", Language::Id::french, screen, 1);
    add("French", Language::Id::french, QSize(1280, 800), 2);
}

void ScreenFitTest::everythingFitsItsScreen() {
    QFETCH(const Language::Id, language);
    QFETCH(const double, fonts);
    QFETCH(const QSize, screen);
    setWindowLanguage(language);
    const EnlargedFonts enlarged(fonts);
    const QRect whole = screenOf(screen)->availableGeometry();
    const QSize room = whole.size() - QSize(0, title);
    const auto fits = [&](const QString &name, const QWidget &window) {
        for (const QSize is : {window.size(), leastOf(window)}) {
            if (is.width() > room.width() || is.height() > room.height())
                return sizes(name, is, room);
        }
        return QString();
    };
    for (const char *example : {"", "iso230-2-1988-example", "iso230-4-full-circles-xy"}) {
        const ShownWindow shown(*example ? examplePath(example) : QString(), room);
        shown.window->setGeometry(QRect(whole.topLeft(), room));
        for (const Page page : pages) {
            if (*example)
                shown.window->workplace().showPage(page);
            QCoreApplication::processEvents();
            const QString wrong =
                fits(u"%1, page %2"_s.arg(QLatin1StringView(example)).arg(int(page)), *shown.window);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
            QCOMPARE(shown.window->size(), room);
        }
    }
    const QTemporaryDir folder;
    RegisterService service(folder.filePath(u"register.sqlite"_s), {});
    const ShownWindow shown(examplePath("rotary-axis"));
    for (const auto &dialog : allDialogs(*shown.window, service)) {
        dialog->setScreen(screenOf(screen));
        dialog->move(whole.topLeft());
        dialog->show();
        QCoreApplication::processEvents();
        if (qobject_cast<QMainWindow *>(dialog.get())) // made on the first screen, moved by its user
            dialog->resize(room);
        const QString wrong = fits(dialog->objectName(), *dialog);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }
}

void ScreenFitTest::aDialogThatFitsIsLeftAlone() {
    SettingsDialog dialog;
    dialog.show();
    QCoreApplication::processEvents();
    QVERIFY(!dialog.findChild<QScrollArea *>(u"beyondTheScreen"_s));
    for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
        setWindowLanguage(language); // its choices stand in fewer columns there
        ImportAssistant assistant(smallTable(), u"a.csv"_s, nullptr);
        assistant.setScreen(screenOf(QSize(1024, 600)));
        assistant.move(screenOf(QSize(1024, 600))->geometry().topLeft());
        assistant.resize(QSize(1024, 600 - title));
        assistant.show();
        QCoreApplication::processEvents();
        const auto *area = assistant.findChild<QScrollArea *>(u"beyondTheScreen"_s);
        QVERIFY(!area || area->horizontalScrollBar()->maximum() == 0);
        QVERIFY(!area || area->verticalScrollBar()->maximum() < 60);
    }
}

/// Scrolled, each field can be brought into sight, and the buttons are there without it.
void ScreenFitTest::allIsReachedInASmallDialog() {
    SettingsDialog dialog;
    dialog.move(screenOf(QSize(512, 300))->geometry().topLeft());
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    const auto *area = dialog.findChild<QScrollArea *>();
    QVERIFY(area && area->isVisible());
    const auto inSight = [&](const QWidget *widget) {
        return dialog.rect().contains(QRect(widget->mapTo(&dialog, QPoint()), widget->size()));
    };
    const auto *buttons = dialog.findChild<QDialogButtonBox *>();
    QVERIFY(buttons && !area->isAncestorOf(buttons));
    QVERIFY(inSight(buttons));
    int walked = 0;
    const QWidget *first = QApplication::focusWidget();
    QVERIFY(first);
    for (int i = 0; i < 60; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        const QWidget *now = QApplication::focusWidget();
        const bool isHigh = now->height() > area->viewport()->height();
        QVERIFY2(isHigh ? !now->visibleRegion().isEmpty() : inSight(now), qPrintable(now->objectName()));
        ++walked;
        if (now == first)
            break;
    }
    QVERIFY(walked > 5 && QApplication::focusWidget() == first); // all of them, round and round
}

/// Scrolled for want of room, too.
void ScreenFitTest::tabBeginsAtTheHeadOfADialog() {
    const QTemporaryDir folder;
    RegisterService service(folder.filePath(u"register.sqlite"_s), {});
    const ShownWindow shown(examplePath("rotary-axis"));
    QStringList wrong;
    for (const QSize screen : {QSize(1280, 800), QSize(640, 400), QSize(512, 300)}) {
        for (const auto &dialog : allDialogs(*shown.window, service)) {
            if (!qobject_cast<QDialog *>(dialog.get()))
                continue;
            dialog->setScreen(screenOf(screen));
            dialog->move(screenOf(screen)->availableGeometry().topLeft());
            dialog->show();
            QCoreApplication::processEvents();
            std::vector<int> tops;
            for (QWidget *widget = dialog->nextInFocusChain(); widget != dialog.get();
                 widget = widget->nextInFocusChain()) {
                if (widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) &&
                    !widget->focusProxy() && widget->window() == dialog.get())
                    tops.push_back(widget->mapTo(dialog.get(), QPoint()).y());
            }
            constexpr int row = 40;
            if (!tops.empty() && tops.front() > std::ranges::min(tops) + row)
                wrong += u"%1 at %2 x %3"_s.arg(QLatin1StringView(dialog->metaObject()->className()))
                             .arg(screen.width())
                             .arg(screen.height());
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

void ScreenFitTest::sixTargetsAreInSightAtTwiceTheScale() {
    for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
        setWindowLanguage(language);
        for (const char *example : {"iso230-2-1988-example", "rotary-axis"}) {
            const ShownWindow shown(examplePath(example), QSize(640, 400 - title));
            QCoreApplication::processEvents();
            const auto *view = shown.find<QTableView>("readings");
            QVERIFY(view->isVisible());
            const QRect sixth = view->visualRect(view->model()->index(5, 0));
            QVERIFY2(view->viewport()->rect().contains(sixth),
                     qPrintable(u"%1 of %2"_s.arg(sixth.bottom()).arg(view->viewport()->height())));
            for (const char *part : {"readings", "rightTabs", "pageTabs"}) {
                const auto *widget = shown.find(part);
                const QPoint end = widget->mapTo(shown.window, widget->rect().bottomRight());
                QVERIFY2(shown.window->rect().contains(end), part);
            }
            QVERIFY(!shown.find("toolBar")->isVisible()); // all of it is in the menus
            shown.window->resize(640, 600);
            QCoreApplication::processEvents();
            QVERIFY(shown.find("toolBar")->isVisible());
        }
    }
}

PALMER_TEST(runScreenFitTest) {
    QJsonArray all;
    int x = 0;
    for (const QSize screen : screens) {
        all.append(QJsonObject{{u"name"_s, u"at %1"_s.arg(x)},
                               {u"x"_s, x},
                               {u"y"_s, 0},
                               {u"width"_s, screen.width()},
                               {u"height"_s, screen.height()}});
        x += 4000; // far from one another, so that no window stands on two
    }
    QTemporaryFile file;
    if (!file.open())
        return 1;
    file.write(QJsonDocument(QJsonObject{{u"screens"_s, all}}).toJson());
    file.close();
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + file.fileName().toUtf8());
    const QApplication application(argc, argv);
    ScreenFitTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "screenfittest.moc"
