// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/measurement/testfacts.h"
#include "ui/dialogs/aboutbox.h"
#include "ui/guards.h"
#include "ui/model/editname.h"
#include "ui/theme.h"
#include "ui/window/mainwindow.h"
#include "ui/window/openregister.h"
#include "ui/window/searchbox.h"
#include "ui/window/workplace.h"
#include "ui/windowlanguage.h"

#include <QActionGroup>
#include <QApplication>
#include <QKeySequence>
#include <QMenu>
#include <QMenuBar>
#include <QUndoStack>
#include <array>
#include <vector>

namespace palmer::ui {

namespace {

constexpr int menuHeight = 28;

bool isOpen(const WindowSituation &now) {
    return now.open;
}
bool hasTest(const WindowSituation &now) {
    return now.test < now.tests;
}
bool hasTests(const WindowSituation &now) {
    return now.tests > 0;
}
bool hasResults(const WindowSituation &now) {
    return now.hasResults;
}
bool isView(const WindowSituation &now) {
    return now.underOtherEdition;
}

template <Page page>
constexpr std::integral_constant<Page, page> shown{};

void showLengths(LengthDisplay lengths) {
    setWindowUnits({lengths, windowLanguage().units().angles});
}

void showAngles(AngleDisplay angles) {
    setWindowUnits({windowLanguage().units().lengths, angles});
}

/// Tooltip of an action: its name and shortcut.
QString hint(const QAction &action) {
    QString text = action.text();
    text.remove(u'&');
    text.remove(u'…');
    return action.shortcut().isEmpty()
               ? text
               : QStringLiteral("%1 (%2)").arg(text, action.shortcut().toString(QKeySequence::NativeText));
}

} // namespace

/// A menu entry: an action, or if unnamed a separator or a submenu.
struct MainWindow::MenuRow {
    struct More {
        const char *icon = nullptr;
        const char *iconText = nullptr; ///< next to the icon on a button; null: the text
        QList<QKeySequence> keys = {};
        bool (*possible)(const WindowSituation &) = nullptr; ///< null: always
        bool checkable = false;                              ///< adjacent ones are exclusive
        QAction::MenuRole role = QAction::TextHeuristicRole;
        WindowMenu opens = WindowMenu::none;
    };

    WindowMenu menu = WindowMenu::none;
    WindowAction action = WindowAction::none;
    const char *name = nullptr; ///< of the object
    const char *text = nullptr;
    void (*run)(MainWindow &window) = nullptr;
    More more;
};

/// All menus, in display order.
const std::vector<MainWindow::MenuRow> &MainWindow::menuRows() {
    using W = MainWindow;
    using A = WindowAction;
    using M = WindowMenu;
    using K = QKeySequence;
    constexpr auto ctrl = Qt::CTRL;
    constexpr auto shift = Qt::SHIFT;
    const auto lineIn = [](M menu, A action = A::none) {
        return MenuRow{menu, action, nullptr, nullptr, nullptr, {}};
    };
    const auto menuIn = [](M menu, M opened, const char *text) {
        return MenuRow{menu, A::none, nullptr, text, nullptr, {.opens = opened}};
    };
    const auto row = [](M menu, A action, const char *name, const char *text, void (*run)(W &),
                        const MenuRow::More &more) { return MenuRow{menu, action, name, text, run, more}; };
    const auto pageRow = [row](auto page, A action, const char *name, const char *text, Qt::Key key) {
        constexpr Page target = decltype(page)::value;
        return row(M::view, action, name, text, [](W &w) { w.showPageOf(target); },
                   {.keys = {K(ctrl | key)}, .possible = [](const WindowSituation &now) {
                        return now.kind && hasPage(*now.kind, target);
                    }});
    };
    static const std::vector<MenuRow> rows{
        menuIn(M::bar, M::file, QT_TR_NOOP("&File")),
        menuIn(M::bar, M::edit, QT_TR_NOOP("&Edit")),
        menuIn(M::bar, M::test, QT_TR_NOOP("&Test")),
        menuIn(M::bar, M::view, QT_TR_NOOP("&View")),
        menuIn(M::bar, M::tools, QT_TR_NOOP("&Utilities")),
        menuIn(M::bar, M::help, QT_TR_NOOP("&Help")),
        row(M::file, A::newTest, "new", QT_TR_NOOP("&New positioning test…"),
            [](W &w) { w.newFile(Kind::positioning); },
            {.icon = "new", .iconText = QT_TR_NOOP("New"), .keys = {K::New}}),
        row(M::file, A::newCircle, "newCircle", QT_TR_NOOP("New circular &test…"),
            [](W &w) { w.newFile(Kind::circular); }, {.keys = {K(ctrl | shift | Qt::Key_N)}}),
        row(M::file, A::open, "open", QT_TR_NOOP("&Open…"), [](W &w) { w.chooseFile(); },
            {.icon = "open", .iconText = QT_TR_NOOP("Open"), .keys = {K::Open}}),
        row(M::file, A::import, "import", QT_TR_NOOP("&Import…"), [](W &w) { w.chooseMeasurements(); },
            {.icon = "imp", .keys = {K(ctrl | Qt::Key_I)}}),
        row(M::file, A::importClipboard, "importClipboard", QT_TR_NOOP("Import from the clip&board…"),
            [](W &w) { w.importClipboard(); }, {.keys = {K(ctrl | shift | Qt::Key_I)}}),
        menuIn(M::file, M::recent, QT_TR_NOOP("Open &recent")),
        menuIn(M::file, M::examples, QT_TR_NOOP("E&xamples")),
        lineIn(M::file),
        row(M::file, A::save, "save", QT_TR_NOOP("&Save"), [](W &w) { w.save(); },
            {.icon = "save", .keys = {K::Save}, .possible = isOpen}),
        row(M::file, A::saveAs, "saveAs", QT_TR_NOOP("Save &as…"), [](W &w) { w.saveAs(); },
            {.keys = {K(ctrl | shift | Qt::Key_S)}, .possible = isOpen}),
        lineIn(M::file),
        row(M::file, A::report, "report", QT_TR_NOOP("Re&port…"), [](W &w) { w.showReport(); },
            {.icon = "report", .iconText = QT_TR_NOOP("Report…"), .keys = {K::Print}, .possible = isOpen}),
        menuIn(M::file, M::exports, QT_TR_NOOP("&Export")),
        row(M::exports, A::exportReadings, "exportReadings", QT_TR_NOOP("&Readings and results…"),
            [](W &w) { w.exportReadings(); }, {.possible = hasResults}),
        row(M::exports, A::exportFigure, "exportFigure", QT_TR_NOOP("&Data of the figure…"),
            [](W &w) { w.exportFigure(); }, {.possible = hasResults}),
        row(M::exports, A::compensation, "compensation", QT_TR_NOOP("&Compensation table…"),
            [](W &w) { w.showCompensation(); },
            {.possible = [](const WindowSituation &now) { return now.hasResults && now.hasTargets; }}),
        lineIn(M::file),
        row(M::file, A::newWindow, "newWindow", QT_TR_NOOP("New &window"),
            [](W & /*window*/) { (new MainWindow)->show(); }, {.keys = {K(ctrl | shift | Qt::Key_W)}}),
        row(M::file, A::close, "close", QT_TR_NOOP("&Close"), [](W &w) { w.close(); },
            {.keys = {K(ctrl | Qt::Key_W)}}),
        row(M::file, A::quit, "quit", QT_TR_NOOP("&Quit"), [](W & /*window*/) { quit(); },
            {.keys = {K(ctrl | Qt::Key_Q)}, .role = QAction::QuitRole}),
        row(M::edit, A::undo, "undo", QT_TR_NOOP("&Undo"), [](W &w) { w.step(false); },
            {.icon = "undo",
             .iconText = QT_TR_NOOP("Undo"),
             .keys = {K::Undo},
             .possible = [](const WindowSituation &now) { return now.canUndo; }}),
        row(M::edit, A::redo, "redo", QT_TR_NOOP("&Redo"), [](W &w) { w.step(true); },
            {.icon = "redo",
             .iconText = QT_TR_NOOP("Redo"),
             .keys = {K(ctrl | shift | Qt::Key_Z), K(ctrl | Qt::Key_Y)},
             .possible = [](const WindowSituation &now) { return now.canRedo; }}),
        menuIn(M::edit, M::history, QT_TR_NOOP("Hist&ory")),
        lineIn(M::edit),
        row(M::edit, A::search, "search", QT_TR_NOOP("Searc&h"),
            [](W &w) { w.m_search->setFocus(Qt::ShortcutFocusReason); },
            {.icon = "search", .keys = {K::Find}}),
        lineIn(M::edit),
        row(M::test, A::addTest, "addTest", QT_TR_NOOP("&Add a positioning test…"),
            [](W &w) { w.addTest(Kind::positioning); },
            {.icon = "plus", .keys = {K(ctrl | Qt::Key_T)}, .possible = isOpen}),
        row(M::test, A::addCircle, "addCircle", QT_TR_NOOP("Add a circular &test…"),
            [](W &w) { w.addTest(Kind::circular); },
            {.keys = {K(ctrl | shift | Qt::Key_T)}, .possible = isOpen}),
        row(M::test, A::addDrift, "addDrift", QT_TR_NOOP("Add a dri&ft test"), [](W &w) { w.addDriftTest(); },
            {.possible = isOpen}),
        row(M::test, A::renameTest, "renameTest", QT_TR_NOOP("Rena&me the test…"),
            [](W &w) { w.renameTest(); }, {.possible = hasTest}),
        row(M::test, A::duplicateTest, "duplicateTest", QT_TR_NOOP("Dupli&cate the test…"),
            [](W &w) { w.duplicateTest(); }, {.possible = hasTest}),
        row(M::test, A::repeatTest, "repeatTest", QT_TR_NOOP("Repeat the test, &without readings"),
            [](W &w) { w.repeatTest(); }, {.possible = hasTest}),
        row(M::test, A::fillLikeLast, "fillLikeLast", QT_TR_NOOP("Li&ke the last test of this machine"),
            [](W &w) { w.fillLikeLast(); }, {.keys = {K(ctrl | shift | Qt::Key_L)}, .possible = hasTest}),
        row(M::test, A::deleteTest, "deleteTest", QT_TR_NOOP("Delete the t&est"),
            [](W &w) { w.deleteTest(); }, {.possible = hasTest}),
        row(M::test, A::showInReport, "showInReport", QT_TR_NOOP("&Go to the report…"),
            [](W &w) { w.showReport(w.workplace().anchorInReport()); }, {.possible = hasTest}),
        lineIn(M::test),
        // the workplace inserts the actions on readings and circles here
        lineIn(M::test, A::afterReadings),
        lineIn(M::test, A::afterCircles),
        row(M::test, A::previousTest, "previousTest", QT_TR_NOOP("&Previous test"),
            [](W &w) { w.workplace().showTest(w.testInView() - 1); },
            {.keys = {K(ctrl | Qt::Key_PageUp)},
             .possible = [](const WindowSituation &now) { return now.test > 0 && hasTest(now); }}),
        row(M::test, A::nextTest, "nextTest", QT_TR_NOOP("&Next test"),
            [](W &w) { w.workplace().showTest(w.testInView() + 1); },
            {.keys = {K(ctrl | Qt::Key_PageDown)},
             .possible = [](const WindowSituation &now) { return now.test + 1 < now.tests; }}),
        lineIn(M::test),
        row(M::test, A::setEdition, "setEditionAction", QT_TR_NOOP("&Set as edition of the test"),
            [](W &w) { w.setEdition(w.testInView(), w.editionInView()); }, {.possible = isView}),
        row(M::test, A::ownEdition, "ownEdition", QT_TR_NOOP("&Back to the edition of the test"),
            [](W &w) { w.m_evaluator.setView(w.testInView(), {}); }, {.possible = isView}),
        pageRow(shown<Page::readings>, A::readingsPage, "page1", QT_TR_NOOP("&Readings"), Qt::Key_1),
        pageRow(shown<Page::conditions>, A::conditionsPage, "page2", QT_TR_NOOP("&Conditions"), Qt::Key_2),
        pageRow(shown<Page::agreedPoints>, A::agreedPointsPage, "page3", QT_TR_NOOP("&Agreed points"),
                Qt::Key_3),
        pageRow(shown<Page::limits>, A::limitsPage, "page4", QT_TR_NOOP("&Limits"), Qt::Key_4),
        pageRow(shown<Page::uncertainty>, A::uncertaintyPage, "page5", QT_TR_NOOP("Uncertaint&y"), Qt::Key_5),
        pageRow(shown<Page::diagnosis>, A::diagnosisPage, "page6", QT_TR_NOOP("D&iagnosis"), Qt::Key_6),
        pageRow(shown<Page::comparison>, A::comparisonPage, "page7", QT_TR_NOOP("Comparis&on"), Qt::Key_7),
        pageRow(shown<Page::thermal>, A::thermalPage, "page8", QT_TR_NOOP("T&hermal behaviour"), Qt::Key_8),
        lineIn(M::view),
        row(M::view, A::nextMissing, "nextMissing", QT_TR_NOOP("&Next missing statement"),
            [](W &w) { w.workplace().showNextMissing(true); },
            {.keys = {K(Qt::Key_F8)}, .possible = hasTests}),
        row(M::view, A::previousMissing, "previousMissing", QT_TR_NOOP("&Previous missing statement"),
            [](W &w) { w.workplace().showNextMissing(false); },
            {.keys = {K(shift | Qt::Key_F8)}, .possible = hasTests}),
        lineIn(M::view),
        row(M::view, A::nextPane, "nextPane", QT_TR_NOOP("Ne&xt pane"),
            [](W &w) { w.workplace().focusNextPane(true); },
            {.keys = {K(Qt::Key_F6), K(ctrl | Qt::Key_Tab)}, .possible = isOpen}),
        row(M::view, A::previousPane, "previousPane", QT_TR_NOOP("Pre&vious pane"),
            [](W &w) { w.workplace().focusNextPane(false); },
            {.keys = {K(shift | Qt::Key_F6), K(ctrl | shift | Qt::Key_Tab)}, .possible = isOpen}),
        lineIn(M::view),
        row(M::view, A::maximiseFigure, "maximiseFigure", QT_TR_NOOP("&Maximise the figure"),
            [](W &w) { w.workplace().setFigureMaximised(!w.workplace().isFigureMaximised()); },
            {.icon = "maxi", .keys = {K(Qt::Key_F11)}, .possible = isOpen}),
        lineIn(M::view),
        row(M::view, A::largerText, "largerText", QT_TR_NOOP("Lar&ger text"),
            [](W &) { W::changeTextSize(1); },
            {.keys = {K(ctrl | Qt::ALT | Qt::Key_Plus), K(ctrl | Qt::ALT | Qt::Key_Equal)}}),
        row(M::view, A::smallerText, "smallerText", QT_TR_NOOP("&Smaller text"),
            [](W &) { W::changeTextSize(-1); }, {.keys = {K(ctrl | Qt::ALT | Qt::Key_Minus)}}),
        row(M::view, A::normalText, "normalText", QT_TR_NOOP("&Text of usual size"),
            [](W &) { W::changeTextSize(0); }, {.keys = {K(ctrl | Qt::ALT | Qt::Key_0)}}),
        lineIn(M::view),
        menuIn(M::view, M::units, QT_TR_NOOP("&Units")),
        row(M::units, A::micrometres, "lengths1", QT_TR_NOOP("Lengths: µm and mm"),
            [](W & /*window*/) { showLengths(LengthDisplay::micrometres); }, {.checkable = true}),
        row(M::units, A::millimetres, "lengths2", QT_TR_NOOP("Lengths: mm only"),
            [](W & /*window*/) { showLengths(LengthDisplay::millimetres); }, {.checkable = true}),
        row(M::units, A::inches, "lengths3", QT_TR_NOOP("Lengths: µin and inches"),
            [](W & /*window*/) { showLengths(LengthDisplay::inches); }, {.checkable = true}),
        lineIn(M::units),
        row(M::units, A::arcSeconds, "angles1", QT_TR_NOOP("Angles: arc seconds and degrees"),
            [](W & /*window*/) { showAngles(AngleDisplay::arcSeconds); }, {.checkable = true}),
        row(M::units, A::degrees, "angles2", QT_TR_NOOP("Angles: degrees only"),
            [](W & /*window*/) { showAngles(AngleDisplay::degrees); }, {.checkable = true}),
        row(M::view, A::french, "speakFrench", "&Français",
            [](W & /*window*/) { setWindowLanguage(Language::Id::french); }, {.checkable = true}),
        row(M::view, A::english, "speakEnglish", "&English",
            [](W & /*window*/) { setWindowLanguage(Language::Id::english); }, {.checkable = true}),
        row(M::tools, A::plan, "plan", QT_TR_NOOP("P&lan…"), [](W &w) { w.showPlan(); },
            {.icon = "plan", .iconText = QT_TR_NOOP("Plan…"), .keys = {K(ctrl | Qt::Key_L)}}),
        row(M::tools, A::compare, "compare", QT_TR_NOOP("Co&mpare…"), [](W &w) { w.showComparison(); },
            {.icon = "bars",
             .keys = {K(ctrl | Qt::Key_K)},
             .possible = [](const WindowSituation &now) { return now.hasResults && now.hasEdition; }}),
        row(M::tools, A::feed, "contouringFeed", QT_TR_NOOP("Contouring &feed…"), [](W &w) { w.showFeed(); },
            {}),
        row(M::tools, A::allTests, "register", QT_TR_NOOP("&Register of all tests…"),
            [](W & /*window*/) { showRegister(); }, {.icon = "trend", .keys = {K(ctrl | shift | Qt::Key_G)}}),
        lineIn(M::tools),
        row(M::tools, A::settings, "settings", QT_TR_NOOP("&Settings…"), [](W &w) { w.showSettings(); },
            {.icon = "gear", .keys = {K(ctrl | Qt::Key_Comma)}, .role = QAction::PreferencesRole}),
        row(M::help, A::help, "help", QT_TR_NOOP("&Help"), [](W &w) { w.showHelp(); },
            {.icon = "ques", .keys = {K(Qt::Key_F1)}}),
        row(M::help, A::shortcuts, "shortcuts", QT_TR_NOOP("&Keyboard shortcuts"),
            [](W &w) { w.showShortcuts(); }, {}),
        row(M::help, A::validation, "validation", QT_TR_NOOP("&Validation"),
            [](W &w) { w.showHelpPage(QStringLiteral("validation")); }, {}),
        lineIn(M::help),
        row(M::help, A::about, "about", QT_TR_NOOP("&About Palmer"), [](W &w) { showAbout(&w); },
            {.role = QAction::AboutRole}),
        row(M::help, A::aboutQt, "aboutQt", QT_TR_NOOP("About &Qt"),
            [](W & /*window*/) { QApplication::aboutQt(); }, {.role = QAction::AboutQtRole}),
    };
    return rows;
}

void MainWindow::makeMenus() {
    menuBar()->setFixedHeight(menuHeight);
    const auto menuOf = [this](WindowMenu menu) -> QMenu *& {
        return m_menus.at(static_cast<std::size_t>(menu));
    };
    QActionGroup *group = nullptr; // adjacent checkable actions are exclusive
    const QMenu *groupedIn = nullptr;
    for (const MenuRow &row : menuRows()) {
        QMenu *menu = menuOf(row.menu);
        QAction *action = nullptr;
        if (row.more.opens != WindowMenu::none)
            menuOf(row.more.opens) = menu ? menu->addMenu(QString()) : menuBar()->addMenu(QString());
        else
            action = row.name ? addAction(*menu, row) : menu->addSeparator();
        if (row.action != WindowAction::none)
            m_actions.at(static_cast<std::size_t>(row.action)) = action;
        if (!row.more.checkable)
            group = nullptr;
        else if (!group || groupedIn != menu)
            group = new QActionGroup(this);
        groupedIn = menu;
        if (group)
            group->addAction(action);
    }
}

QAction *MainWindow::addAction(QMenu &menu, const MenuRow &row) {
    auto *made = new QAction(this);
    made->setObjectName(QLatin1StringView(row.name));
    if (row.more.icon)
        made->setIcon(lineIcon(QLatin1StringView(row.more.icon)));
    made->setShortcuts(row.more.keys);
    made->setCheckable(row.more.checkable);
    made->setMenuRole(row.more.role);
    menu.addAction(made);
    connect(made, &QAction::triggered, this, [this, run = row.run] {
        commitTyping(); // before the action runs
        run(*this);
    });
    return made;
}

QAction *MainWindow::action(WindowAction which) const {
    return m_actions.at(static_cast<std::size_t>(which));
}

QMenu *MainWindow::menu(WindowMenu which) const {
    return m_menus.at(static_cast<std::size_t>(which));
}

void MainWindow::enableActions() {
    WindowSituation now;
    now.open = m_open;
    now.tests = m_open ? m_model.document()->tests.size() : 0;
    now.test = testInView();
    const auto &evaluated = m_evaluator.latest().tests;
    if (m_open && now.test < evaluated.size()) {
        now.kind = kindOf(*m_model.document()->tests[now.test]);
        now.hasResults = !m_evaluator.isBusy() && currentTest();
        now.hasEdition = evaluated[now.test]->edition;
        now.underOtherEdition = evaluated[now.test]->view;
        now.hasTargets = traitsOf(*m_model.document()->tests[now.test]).hasTargets;
    }
    now.canUndo = m_open && m_model.undoStack()->canUndo();
    now.canRedo = m_open && m_model.undoStack()->canRedo();
    for (const MenuRow &row : menuRows()) {
        if (row.more.possible)
            action(row.action)->setEnabled(row.more.possible(now));
    }
}

/// Undo and redo name their step.
void MainWindow::showUndo() {
    const QUndoStack *stack = m_model.undoStack();
    QAction *undo = action(WindowAction::undo);
    QAction *redo = action(WindowAction::redo);
    undo->setText(stack->canUndo() ? tr("&Undo: %1").arg(editName(stack->undoText())) : tr("&Undo"));
    redo->setText(stack->canRedo() ? tr("&Redo: %1").arg(editName(stack->redoText())) : tr("&Redo"));
    for (QAction *step : {undo, redo})
        step->setToolTip(hint(*step));
}

void MainWindow::nameActions() {
    for (const MenuRow &row : menuRows()) {
        if (row.more.opens != WindowMenu::none)
            menu(row.more.opens)->setTitle(tr(row.text));
        if (!row.name)
            continue;
        QAction *named = action(row.action);
        named->setText(tr(row.text));
        if (row.more.iconText)
            named->setIconText(tr(row.more.iconText));
        named->setToolTip(hint(*named));
    }
    using A = WindowAction;
    constexpr std::array lengths{A::micrometres, A::millimetres, A::inches};
    constexpr std::array angles{A::arcSeconds, A::degrees};
    const DisplayUnits units = windowLanguage().units();
    action(lengths.at(static_cast<std::size_t>(units.lengths)))->setChecked(true);
    action(angles.at(static_cast<std::size_t>(units.angles)))->setChecked(true);
    action(windowLanguage().id() == Language::Id::french ? A::french : A::english)->setChecked(true);
}

} // namespace palmer::ui
