// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/mainwindow.h"
#include "ui/sizeonscreen.h"

#include "document/filename.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/testfile.h"
#include "editing/newtest.h"
#include "editing/takestatements.h"
#include "ui/circles/circlespage.h"
#include "ui/dialogs/aboutbox.h"
#include "ui/dialogs/comparedialog.h"
#include "ui/dialogs/compensationdialog.h"
#include "ui/dialogs/feeddialog.h"
#include "ui/dialogs/newcircledialog.h"
#include "ui/dialogs/newtestdialog.h"
#include "ui/dialogs/plandialog.h"
#include "ui/dialogs/recoverydialog.h"
#include "ui/dialogs/reportdialog.h"
#include "ui/dialogs/settingsdialog.h"
#include "ui/dialogs/shortcutsdialog.h"
#include "ui/help/helpwindow.h"
#include "ui/import/importassistant.h"
#include "ui/model/editname.h"
#include "ui/proof/reportbar.h"
#include "ui/proof/verifyreport.h"
#include "ui/readings/readingspage.h"
#include "ui/register/openregister.h"
#include "ui/settings.h"
#include "ui/testname.h"
#include "ui/theme.h"
#include "ui/typingguard.h"
#include "ui/welcome/examples.h"
#include "ui/welcome/recentfiles.h"
#include "ui/welcome/welcomepage.h"
#include "ui/window/exports.h"
#include "ui/window/languageswitch.h"
#include "ui/window/noticebar.h"
#include "ui/window/workplace.h"
#include "ui/windowlanguage.h"
#include "ui/workbar.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTime>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>
#include <QVBoxLayout>
#include <span>
#include <variant>

namespace palmer::ui {

namespace {

constexpr int menuHeight = 28;
constexpr int toolBarHeight = 44;
constexpr int statusHeight = 27;
constexpr int iconsOnlyBelow = 1180;
/// Of the height: below it the table needs the room of the tools, which are all in the menus as well.
constexpr int noToolsBelow = 430;
constexpr QSize leastSize(320, 240); ///< below the least of its parts these are scrolled

/// Whether a file is no test file; of what cannot be read opening says why. Large ones are looked into while
/// they are read.
bool isMeasurement(const QString &path) {
    if (isExample(path) || isTestFileName(path) || isLargeFile(QFileInfo(path).size()))
        return false;
    try {
        return !isTestFile(readBytes(path));
    } catch (const Error &) {
        return false;
    }
}

/// The name a file that has none yet is saved under: the number of its report, else machine and axes, else
/// its title; without what no file may be called.
QString proposedName(const Document &document) {
    QStringList parts{QString::fromStdString(document.report.number)};
    if (parts.first().isEmpty()) {
        parts = {QString::fromStdString(document.machine.name)};
        for (const TestPointer &test : document.tests)
            parts << testName(*test);
        parts.removeAll(QString());
        parts.removeDuplicates();
    }
    QString name = parts.join(u' ').left(80);
    static const QRegularExpression forbidden(QStringLiteral("[/\\\\:*?\"<>|\\x00-\\x1f]+"));
    name.replace(forbidden, QStringLiteral("-"));
    name = name.trimmed();
    return name.isEmpty() ? name : name + QStringLiteral(".palmer");
}

/// The tooltip of an action: its name and its shortcut.
QString hint(const QAction &action) {
    QString text = action.text();
    text.remove(u'&');
    text.remove(u'…');
    return action.shortcut().isEmpty()
               ? text
               : QStringLiteral("%1 (%2)").arg(text, action.shortcut().toString(QKeySequence::NativeText));
}

} // namespace

MainWindow::MainWindow(QWidget *parent)
    : QMainWindow(parent)
    , m_centre(new QWidget(this))
    , m_notice(new NoticeBar(m_centre))
    , m_reportBar(new ReportBar(m_centre))
    , m_stack(new QStackedWidget(m_centre))
    , m_welcome(new WelcomePage(m_stack)) {
    setObjectName(QStringLiteral("mainWindow"));
    setAttribute(Qt::WA_DeleteOnClose);
    setAcceptDrops(true);
    setMinimumSize(leastSize);
    setCentralWidget(m_centre);
    m_stack->addWidget(m_welcome);
    auto *column = new QVBoxLayout(m_centre);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_notice);
    column->addWidget(m_reportBar);
    column->addWidget(m_stack, 1);
    makeActions();
    makeToolBar();
    makeStatusBar();
    connectParts();
    resize(sizeOnScreen(*this, {1280, 800}));
    const QByteArray geometry = QSettings().value(QStringLiteral("window/geometry")).toByteArray();
    if (!geometry.isEmpty())
        restoreGeometry(geometry);
    retranslate();
    showState();
}

MainWindow::~MainWindow() {
    m_reader.cancel();
    m_reader.wait();
    m_model.undoStack()->disconnect(this);
    m_model.disconnect(this);
    m_evaluator.disconnect(this);
    m_autosave.disconnect(this);
}

bool MainWindow::hasDocument() const {
    return m_open;
}

QAction *MainWindow::addAction(QMenu *menu, const QString &name, const QString &icon) {
    auto *action = new QAction(this);
    action->setObjectName(name);
    if (!icon.isEmpty())
        action->setIcon(lineIcon(icon));
    menu->addAction(action);
    connect(action, &QAction::triggered, this, [] { commitTyping(); }); // before what the action does
    return action;
}

void MainWindow::makeActions() {
    menuBar()->setFixedHeight(menuHeight);
    m_fileMenu = menuBar()->addMenu(QString());
    m_editMenu = menuBar()->addMenu(QString());
    m_testMenu = menuBar()->addMenu(QString());
    m_viewMenu = menuBar()->addMenu(QString());
    m_toolsMenu = menuBar()->addMenu(QString());
    m_helpMenu = menuBar()->addMenu(QString());

    m_newAction = addAction(m_fileMenu, QStringLiteral("new"), QStringLiteral("new"));
    m_newAction->setShortcut(QKeySequence::New);
    m_newCircleAction = addAction(m_fileMenu, QStringLiteral("newCircle"));
    m_newCircleAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_N));
    m_openAction = addAction(m_fileMenu, QStringLiteral("open"), QStringLiteral("open"));
    m_openAction->setShortcut(QKeySequence::Open);
    m_importAction = addAction(m_fileMenu, QStringLiteral("import"), QStringLiteral("imp"));
    m_importAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_I));
    m_importClipboardAction = addAction(m_fileMenu, QStringLiteral("importClipboard"));
    m_importClipboardAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    m_recentMenu = m_fileMenu->addMenu(QString());
    m_examplesMenu = m_fileMenu->addMenu(QString());
    m_fileMenu->addSeparator();
    m_saveAction = addAction(m_fileMenu, QStringLiteral("save"), QStringLiteral("save"));
    m_saveAction->setShortcut(QKeySequence::Save);
    m_saveAsAction = addAction(m_fileMenu, QStringLiteral("saveAs"));
    m_saveAsAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    m_fileMenu->addSeparator();
    m_reportAction = addAction(m_fileMenu, QStringLiteral("report"), QStringLiteral("report"));
    m_reportAction->setShortcut(QKeySequence::Print);
    m_exportMenu = m_fileMenu->addMenu(QString());
    m_exportReadingsAction = addAction(m_exportMenu, QStringLiteral("exportReadings"));
    m_exportFigureAction = addAction(m_exportMenu, QStringLiteral("exportFigure"));
    m_compensationAction = addAction(m_exportMenu, QStringLiteral("compensation"));
    m_fileMenu->addSeparator();
    m_newWindowAction = addAction(m_fileMenu, QStringLiteral("newWindow"));
    m_newWindowAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_W));
    m_closeAction = addAction(m_fileMenu, QStringLiteral("close"));
    m_closeAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_W));
    m_quitAction = addAction(m_fileMenu, QStringLiteral("quit"));
    m_quitAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));

    m_undoAction = addAction(m_editMenu, QStringLiteral("undo"), QStringLiteral("undo"));
    m_undoAction->setShortcut(QKeySequence::Undo);
    m_redoAction = addAction(m_editMenu, QStringLiteral("redo"), QStringLiteral("redo"));
    m_redoAction->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});

    m_editMenu->addSeparator(); // what is done to readings comes with the workplace

    m_addTestAction = addAction(m_testMenu, QStringLiteral("addTest"), QStringLiteral("plus"));
    m_addTestAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_T));
    m_addCircleAction = addAction(m_testMenu, QStringLiteral("addCircle"));
    m_addCircleAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_T));
    m_addDriftAction = addAction(m_testMenu, QStringLiteral("addDrift"));
    m_renameTestAction = addAction(m_testMenu, QStringLiteral("renameTest"));
    m_duplicateTestAction = addAction(m_testMenu, QStringLiteral("duplicateTest"));
    m_repeatTestAction = addAction(m_testMenu, QStringLiteral("repeatTest"));
    m_deleteTestAction = addAction(m_testMenu, QStringLiteral("deleteTest"));
    m_testMenu->addSeparator();
    m_afterReadings = m_testMenu->addSeparator();
    m_afterCircles = m_testMenu->addSeparator();
    m_previousTestAction = addAction(m_testMenu, QStringLiteral("previousTest"));
    m_previousTestAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageUp));
    m_nextTestAction = addAction(m_testMenu, QStringLiteral("nextTest"));
    m_nextTestAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageDown));
    m_testMenu->addSeparator();
    m_planAction = addAction(m_toolsMenu, QStringLiteral("plan"), QStringLiteral("plan"));
    m_planAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_L));
    m_compareAction = addAction(m_toolsMenu, QStringLiteral("compare"), QStringLiteral("bars"));
    m_compareAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_K));
    m_setEditionAction = addAction(m_testMenu, QStringLiteral("setEditionAction"));
    m_ownEditionAction = addAction(m_testMenu, QStringLiteral("ownEdition"));
    m_feedAction = addAction(m_toolsMenu, QStringLiteral("contouringFeed"));
    m_registerAction = addAction(m_toolsMenu, QStringLiteral("register"), QStringLiteral("trend"));
    m_registerAction->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G));
    m_toolsMenu->addSeparator();
    m_settingsAction = addAction(m_toolsMenu, QStringLiteral("settings"), QStringLiteral("gear"));
    m_settingsAction->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Comma));
    m_settingsAction->setMenuRole(QAction::PreferencesRole);

    for (std::size_t i = 0; i < m_pageActions.size(); ++i) {
        m_pageActions[i] = addAction(m_viewMenu, QStringLiteral("page%1").arg(i + 1));
        m_pageActions[i]->setShortcut(
            QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(i))));
    }
    m_viewMenu->addSeparator();
    m_nextMissingAction = addAction(m_viewMenu, QStringLiteral("nextMissing"));
    m_nextMissingAction->setShortcut(QKeySequence(Qt::Key_F8));
    m_previousMissingAction = addAction(m_viewMenu, QStringLiteral("previousMissing"));
    m_previousMissingAction->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_F8));
    m_viewMenu->addSeparator();
    m_nextPaneAction = addAction(m_viewMenu, QStringLiteral("nextPane"));
    m_nextPaneAction->setShortcuts({QKeySequence(Qt::Key_F6), QKeySequence(Qt::CTRL | Qt::Key_Tab)});
    m_previousPaneAction = addAction(m_viewMenu, QStringLiteral("previousPane"));
    m_previousPaneAction->setShortcuts(
        {QKeySequence(Qt::SHIFT | Qt::Key_F6), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Tab)});
    m_viewMenu->addSeparator();
    m_maximiseAction = addAction(m_viewMenu, QStringLiteral("maximiseFigure"), QStringLiteral("maxi"));
    m_maximiseAction->setShortcut(QKeySequence(Qt::Key_F11));
    m_viewMenu->addSeparator();
    m_unitsMenu = m_viewMenu->addMenu(QString());
    for (std::size_t i = 0; i < m_lengthActions.size(); ++i)
        m_lengthActions.at(i) = addAction(m_unitsMenu, QStringLiteral("lengths%1").arg(i + 1));
    m_unitsMenu->addSeparator();
    for (std::size_t i = 0; i < m_angleActions.size(); ++i)
        m_angleActions.at(i) = addAction(m_unitsMenu, QStringLiteral("angles%1").arg(i + 1));
    for (const auto &actions :
         {std::span<QAction *>(m_lengthActions), std::span<QAction *>(m_angleActions)}) {
        auto *group = new QActionGroup(this);
        for (QAction *action : actions) {
            action->setCheckable(true);
            group->addAction(action);
        }
    }
    m_frenchAction = addAction(m_viewMenu, QStringLiteral("speakFrench"));
    m_englishAction = addAction(m_viewMenu, QStringLiteral("speakEnglish"));
    for (QAction *action : {m_frenchAction, m_englishAction})
        action->setCheckable(true);

    m_helpAction = addAction(m_helpMenu, QStringLiteral("help"), QStringLiteral("ques"));
    m_helpAction->setShortcut(QKeySequence(Qt::Key_F1));
    m_shortcutsAction = addAction(m_helpMenu, QStringLiteral("shortcuts"));
    m_validationAction = addAction(m_helpMenu, QStringLiteral("validation"));
    m_helpMenu->addSeparator();
    m_aboutAction = addAction(m_helpMenu, QStringLiteral("about"));
    m_aboutQtAction = addAction(m_helpMenu, QStringLiteral("aboutQt"));
    m_quitAction->setMenuRole(QAction::QuitRole);
    m_aboutAction->setMenuRole(QAction::AboutRole);
    m_aboutQtAction->setMenuRole(QAction::AboutQtRole);
}

void MainWindow::makeToolBar() {
    m_toolBar = new QToolBar(this);
    m_toolBar->setObjectName(QStringLiteral("toolBar"));
    m_toolBar->setMovable(false);
    m_toolBar->setContextMenuPolicy(Qt::PreventContextMenu);
    m_toolBar->setFixedHeight(toolBarHeight);
    m_toolBar->setIconSize(QSize(16, 16));
    setContextMenuPolicy(Qt::PreventContextMenu); // nobody shall hide the toolbar by chance
    m_toolBar->addAction(m_newAction);
    m_toolBar->addAction(m_openAction);
    m_toolBar->addAction(m_saveAction);
    m_toolBar->addSeparator();
    m_toolBar->addAction(m_undoAction);
    m_toolBar->addAction(m_redoAction);
    m_toolBar->addSeparator();
    m_toolBar->addAction(m_importAction);
    m_toolBar->addAction(m_planAction);
    m_toolBar->addAction(m_reportAction);
    for (QAction *action : {m_newAction, m_openAction, m_saveAction, m_undoAction, m_redoAction,
                            m_importAction, m_planAction, m_reportAction}) {
        auto *button = qobject_cast<QToolButton *>(m_toolBar->widgetForAction(action));
        button->setObjectName(action->objectName() + QStringLiteral("Button"));
        button->setFocusPolicy(Qt::TabFocus);
    }
    auto *newButton = qobject_cast<QToolButton *>(m_toolBar->widgetForAction(m_newAction));
    auto *kinds = new QMenu(newButton);
    kinds->addActions({m_newAction, m_newCircleAction});
    newButton->setMenu(kinds);
    newButton->setPopupMode(QToolButton::MenuButtonPopup);
    auto *space = new QWidget(m_toolBar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_toolBar->addWidget(space);
    m_toolBar->addWidget(new LanguageSwitch(LanguageSwitch::Names::codes, m_toolBar));
    addToolBar(m_toolBar);
}

void MainWindow::makeStatusBar() {
    statusBar()->setFixedHeight(statusHeight);
    statusBar()->setSizeGripEnabled(false);
    m_content = new QLabel(this);
    m_hint = new QLabel(this);
    m_state = new QLabel(this);
    m_content->setObjectName(QStringLiteral("statusContent"));
    m_hint->setObjectName(QStringLiteral("statusHint"));
    m_state->setObjectName(QStringLiteral("statusState"));
    for (QLabel *label : {m_content, m_hint, m_state})
        label->setFont(themeFont(TextSize::small));
    m_hint->setProperty("secondary", true);
    m_state->setProperty("secondary", true);
    m_content->setContentsMargins(14, 0, 8, 0);
    m_state->setContentsMargins(8, 0, 14, 0);
    statusBar()->addWidget(m_content);
    statusBar()->addWidget(m_hint, 1);
    m_work = new WorkBar(this);
    statusBar()->addPermanentWidget(m_state);
    statusBar()->addPermanentWidget(m_work);
    m_work->hide(); // the status bar has shown it
}

void MainWindow::connectParts() {
    connect(m_newAction, &QAction::triggered, this, [this] { newFile(Kind::positioning); });
    connect(m_newCircleAction, &QAction::triggered, this, [this] { newFile(Kind::circular); });
    connect(m_addTestAction, &QAction::triggered, this, [this] { addTest(Kind::positioning); });
    connect(m_addCircleAction, &QAction::triggered, this, [this] { addTest(Kind::circular); });
    connect(m_addDriftAction, &QAction::triggered, this, &MainWindow::addDriftTest);
    connect(m_renameTestAction, &QAction::triggered, this, &MainWindow::renameTest);
    connect(m_duplicateTestAction, &QAction::triggered, this, [this] { duplicateTest(true); });
    connect(m_repeatTestAction, &QAction::triggered, this, [this] { duplicateTest(false); });
    connect(m_deleteTestAction, &QAction::triggered, this, &MainWindow::deleteTest);
    connect(&m_autosave, &Autosave::saved, this, [this] {
        m_autosavedAt = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
        showState();
    });
    connect(&m_autosave, &Autosave::failed, this, [this](const Error &error) {
        m_notice->show(tr("Changes cannot be kept safe automatically: %1.")
                           .arg(windowLanguage().sentence(error.message)),
                       {{QStringLiteral("saveElsewhere"), tr("Save &as…"), [this] { saveAs(); }},
                        {QStringLiteral("closeNotice"), tr("&Close"), {}}});
    });
    connect(&m_watch, &FileWatch::changed, this, &MainWindow::fileChangedOutside);
    connect(m_openAction, &QAction::triggered, this, &MainWindow::chooseFile);
    connect(m_work, &WorkBar::cancelled, this, &MainWindow::cancelReading);
    connect(m_saveAction, &QAction::triggered, this, &MainWindow::save);
    connect(m_saveAsAction, &QAction::triggered, this, &MainWindow::saveAs);
    connect(m_reportAction, &QAction::triggered, this, &MainWindow::showReport);
    connect(m_planAction, &QAction::triggered, this, &MainWindow::showPlan);
    connect(m_exportReadingsAction, &QAction::triggered, this, [this] {
        askExportOfReadings(this, m_evaluator.current(), testInView(), QFileInfo(m_model.path()).fileName());
    });
    connect(m_exportFigureAction, &QAction::triggered, this,
            [this] { askExportOfFigure(this, m_evaluator.current(), testInView()); });
    connect(m_compensationAction, &QAction::triggered, this, &MainWindow::showCompensation);
    connect(m_compareAction, &QAction::triggered, this, &MainWindow::showComparison);
    connect(m_helpAction, &QAction::triggered, this, &MainWindow::showHelp);
    connect(m_newWindowAction, &QAction::triggered, this, [] { (new MainWindow)->show(); });
    connect(m_closeAction, &QAction::triggered, this, &QWidget::close);
    connect(m_quitAction, &QAction::triggered, this, &MainWindow::quit);
    connect(m_undoAction, &QAction::triggered, this, [this] { step(false); });
    connect(m_redoAction, &QAction::triggered, this, [this] { step(true); });
    connect(m_model.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::showState);
    connect(m_recentMenu, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    connect(m_examplesMenu, &QMenu::aboutToShow, this, &MainWindow::fillExamplesMenu);
    connect(m_previousTestAction, &QAction::triggered, this, [this] {
        if (testInView() > 0)
            workplace().showTest(testInView() - 1);
    });
    connect(m_nextTestAction, &QAction::triggered, this, [this] { workplace().showTest(testInView() + 1); });
    connect(m_setEditionAction, &QAction::triggered, this, [this] {
        const std::size_t test = testInView();
        setEdition(test, QString::fromUtf8(m_evaluator.latest().tests[test]->edition->word));
    });
    connect(m_ownEditionAction, &QAction::triggered, this, [this] { m_evaluator.setView(testInView(), {}); });
    connect(m_feedAction, &QAction::triggered, this, &MainWindow::showFeed);
    connect(m_registerAction, &QAction::triggered, this, &showRegister);
    constexpr std::array pages{Page::readings, Page::conditions,  Page::agreedPoints,
                               Page::limits,   Page::uncertainty, Page::diagnosis};
    for (std::size_t i = 0; i < pages.size(); ++i)
        connect(m_pageActions[i], &QAction::triggered, this, [this, page = pages[i]] {
            workplace().showPage(page);
            workplace().focusPage();
        });
    connect(m_nextMissingAction, &QAction::triggered, this, [this] { workplace().showNextMissing(true); });
    connect(m_previousMissingAction, &QAction::triggered, this,
            [this] { workplace().showNextMissing(false); });
    connect(m_nextPaneAction, &QAction::triggered, this, [this] { workplace().focusNextPane(true); });
    connect(m_previousPaneAction, &QAction::triggered, this, [this] { workplace().focusNextPane(false); });
    connect(m_maximiseAction, &QAction::triggered, this,
            [this] { workplace().setFigureMaximised(!workplace().isFigureMaximised()); });
    for (std::size_t i = 0; i < m_lengthActions.size(); ++i)
        connect(m_lengthActions.at(i), &QAction::triggered, this, [i] {
            setWindowUnits({static_cast<LengthDisplay>(i), windowLanguage().units().angles});
        });
    for (std::size_t i = 0; i < m_angleActions.size(); ++i)
        connect(m_angleActions.at(i), &QAction::triggered, this, [i] {
            setWindowUnits({windowLanguage().units().lengths, static_cast<AngleDisplay>(i)});
        });
    connect(m_frenchAction, &QAction::triggered, this, [] { setWindowLanguage(Language::Id::french); });
    connect(m_englishAction, &QAction::triggered, this, [] { setWindowLanguage(Language::Id::english); });
    connect(m_validationAction, &QAction::triggered, this,
            [this] { showHelpPage(QStringLiteral("validation")); });
    connect(m_shortcutsAction, &QAction::triggered, this, &MainWindow::showShortcuts);
    connect(m_settingsAction, &QAction::triggered, this, &MainWindow::showSettings);
    connect(m_aboutAction, &QAction::triggered, this, &MainWindow::about);
    connect(m_aboutQtAction, &QAction::triggered, qApp, &QApplication::aboutQt);

    connect(m_welcome, &WelcomePage::newAsked, m_newAction, &QAction::trigger);
    connect(m_welcome, &WelcomePage::newCircleAsked, m_newCircleAction, &QAction::trigger);
    connect(m_welcome, &WelcomePage::openAsked, this, &MainWindow::chooseFile);
    connect(m_welcome, &WelcomePage::importAsked, this, &MainWindow::chooseMeasurements);
    connect(m_importAction, &QAction::triggered, this, &MainWindow::chooseMeasurements);
    connect(m_importClipboardAction, &QAction::triggered, this, &MainWindow::importClipboard);
    connect(m_welcome, &WelcomePage::fileChosen, this, [this](const QString &path) { openFile(path); });
    connect(&m_model, &DocumentModel::changed, this, [this] { m_evaluator.setDocument(m_model.document()); });
    connect(&m_model, &DocumentModel::fileChanged, this, &MainWindow::showState);
    connect(&m_evaluator, &Evaluator::evaluated, this, [this](const EvaluatedDocument &evaluated) {
        workplace().show(evaluated);
        if (std::exchange(m_rememberNext, false))
            remember();
        showState();
    });
    connect(&m_evaluator, &Evaluator::awaiting, this,
            [this](const EvaluatedDocument &awaiting) { workplace().show(awaiting); });
    connect(&m_evaluator, &Evaluator::busyChanged, this, &MainWindow::showState);
    for (const QMenu *menu : {m_editMenu, m_testMenu}) // to show what can be done
        connect(menu, &QMenu::aboutToShow, this, [this] { workplace(); });
}

/// Made when it is needed first: who starts the program does not wait for pages that are out of view.
Workplace &MainWindow::workplace() {
    if (m_workplace)
        return *m_workplace;
    m_place = scrolledPlace(m_stack);
    m_workplace = new Workplace(m_model, m_evaluator, m_place->viewport());
    m_place->setWidget(m_workplace);
    m_stack->addWidget(m_place);
    m_editMenu->addActions(m_workplace->readings().editActions());
    m_testMenu->insertActions(m_afterReadings, m_workplace->readings().testActions());
    m_testMenu->insertActions(m_afterCircles, m_workplace->circles().testActions());
    m_workplace->setTestActions(
        {m_addTestAction, m_addCircleAction, m_addDriftAction},
        {m_renameTestAction, m_duplicateTestAction, m_repeatTestAction, m_deleteTestAction});
    connect(m_workplace, &Workplace::viewChosen, this, [this](std::size_t test, const QString &edition) {
        m_evaluator.setView(test, edition.toStdString());
    });
    connect(m_workplace, &Workplace::editionSet, this, &MainWindow::setEdition);
    connect(m_workplace, &Workplace::contentChanged, m_content, &QLabel::setText);
    connect(m_workplace, &Workplace::hintChanged, m_hint, &QLabel::setText);
    connect(&m_workplace->selection(), &Selection::testChanged, this, &MainWindow::showState);
    return *m_workplace;
}

std::size_t MainWindow::testInView() const {
    return m_workplace ? m_workplace->selection().test() : 0;
}

void MainWindow::chooseFile() {
    QFileDialog dialog(this, tr("Open a test file"),
                       QSettings().value(QStringLiteral("window/folder")).toString());
    dialog.setObjectName(QStringLiteral("openDialog"));
    dialog.setFileMode(QFileDialog::ExistingFiles);
    dialog.setNameFilters({tr("Test files and reports (*.palmer *.pdf)"), tr("All files (*)")});
    if (dialog.exec() != QDialog::Accepted)
        return;
    QSettings().setValue(QStringLiteral("window/folder"), dialog.directory().absolutePath());
    for (const QString &path : dialog.selectedFiles())
        openFile(path);
}

void MainWindow::chooseMeasurements() {
    QFileDialog dialog(this, tr("Import measurement files"),
                       QSettings().value(QStringLiteral("window/importFolder")).toString());
    dialog.setObjectName(QStringLiteral("importDialog"));
    dialog.setFileMode(QFileDialog::ExistingFiles);
    dialog.setNameFilters(
        {tr("Measurements (*.csv *.txt *.tsv *.xlsx *.ods *.rtl *.b5r *.rtx *.ren)"), tr("All files (*)")});
    if (dialog.exec() != QDialog::Accepted)
        return;
    QSettings().setValue(QStringLiteral("window/importFolder"), dialog.directory().absolutePath());
    importFiles(dialog.selectedFiles());
}

void MainWindow::importFiles(const QStringList &paths) {
    m_toImport << paths;
    importNext();
}

/// The assistant is asked for one file after the other, however they came.
void MainWindow::importNext() {
    while (!m_assistant && m_importing.isEmpty() && !m_toImport.isEmpty()) {
        const QString path = m_toImport.takeFirst();
        const qint64 size = QFileInfo(path).size();
        const auto progress = isLargeFile(size) ? m_progress : std::make_shared<ReadProgress>();
        readToImport(
            [path, progress](const std::stop_token &stop) { return readBytes(path, *progress, stop); }, path,
            size);
    }
}

/// `size`: by which it is read at once or beside the window.
void MainWindow::readToImport(const std::function<QByteArray(const std::stop_token &)> &bytes,
                              const QString &name, qint64 size) {
    using Outcome = std::variant<MeasurementFile, Error>;
    const auto read = [bytes, name](const std::stop_token &stop) -> Outcome {
        try {
            return readMeasurementFile(bytes(stop), name);
        } catch (const Error &error) {
            return error;
        }
    };
    const auto show = [this, name](Outcome outcome) {
        if (const auto *error = std::get_if<Error>(&outcome))
            showError(tr("%1 cannot be imported").arg(QFileInfo(name).fileName()), name, *error);
        else
            showAssistant(std::move(std::get<MeasurementFile>(outcome)));
    };
    if (!isLargeFile(size)) {
        show(read({}));
        return;
    }
    m_importing = name;
    m_reader.start([read](const Background::Job &job) { return read(job.stop()); },
                   [this, show](Outcome outcome) {
                       m_importing.clear();
                       showReading();
                       show(std::move(outcome));
                       importNext();
                   });
    showReading();
}

/// Says what is being read, with a bar and Cancel where it takes long.
void MainWindow::showReading() {
    showState();
    if (m_reading.isEmpty() && m_importing.isEmpty()) {
        m_work->end();
        m_progress = std::make_shared<ReadProgress>(); // what was cancelled may still write to the other
    } else {
        m_work->begin(m_state->text(), m_progress);
    }
}

/// Nothing that is being read comes any more.
void MainWindow::cancelReading() {
    m_reader.cancel();
    m_reading.clear();
    m_importing.clear();
    m_toImport.clear();
    showReading();
}

void MainWindow::importClipboard() {
    if (m_assistant || !m_importing.isEmpty())
        return;
    QByteArray bytes = QGuiApplication::clipboard()->text().toUtf8();
    readToImport([bytes](const std::stop_token &) { return bytes; }, tr("clipboard"), bytes.size());
}

void MainWindow::showAssistant(MeasurementFile file) {
    m_assistant = new ImportAssistant(std::move(file), m_open ? m_model.document().get() : nullptr, this);
    m_assistant->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_assistant, &QDialog::finished, this, [this](int result) {
        const ImportAssistant *assistant = m_assistant;
        m_assistant.clear();
        if (result == QDialog::Accepted)
            takeImport(*assistant);
        importNext();
    });
    m_assistant->open();
}

void MainWindow::takeImport(const ImportAssistant &assistant) {
    if (!assistant.wantsNewDocument()) {
        const std::size_t before = m_model.document()->tests.size();
        m_model.edit(QT_TRANSLATE_NOOP("edits", "import a measurement file"),
                     [&](Document &document) { assistant.addTo(document); });
        if (m_model.document()->tests.size() > before) {
            workplace().showTest(before);
            workplace().showPage(Page::readings);
        }
        return;
    }
    Document document;
    assistant.addTo(document);
    document.writtenBy = "Palmer " PALMER_VERSION;
    document.report.languages = {windowLanguage().id() == Language::Id::french ? ReportLanguage::fr
                                                                               : ReportLanguage::en};
    take(std::move(document), {}, true)->workplace().showPage(Page::readings);
}

void MainWindow::openFile(const QString &path, std::optional<std::size_t> test) {
    if (isMeasurement(path)) {
        importFiles({path});
        return;
    }
    const QString whole = isExample(path) ? path : QFileInfo(path).absoluteFilePath();
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        auto *other = qobject_cast<MainWindow *>(widget);
        if (other && !isExample(whole) && other->hasDocument() &&
            (other->m_model.path() == whole || other->m_reportPath == whole)) {
            other->raise();
            other->activateWindow();
            if (test)
                other->workplace().showTest(*test);
            return;
        }
    }
    read(whole, test);
}

void MainWindow::read(const QString &path, std::optional<std::size_t> test) {
    struct Measurement {};
    using Outcome = std::variant<std::monostate, Document, OpenedReport, Measurement, Error>;
    const bool mayTakeLong = path.endsWith(QLatin1StringView(".pdf"), Qt::CaseInsensitive); // simulations
    const bool beside = mayTakeLong || isLargeFile(QFileInfo(path).size());
    const auto progress = beside ? m_progress : std::make_shared<ReadProgress>();
    const auto open = [path, progress](const std::stop_token &stop) -> Outcome {
        try {
            const QByteArray bytes = readBytes(path, *progress, stop);
            if (!isTestFile(bytes, path))
                return Measurement();
            if (!isPdf(bytes))
                return readDocument(bytes);
            const auto count = [&progress](const SimulationProgress &simulated) {
                progress->unit = ReadProgress::Unit::trials;
                progress->done = simulated.trials;
                progress->of = simulated.of.value_or(0);
            };
            if (auto report = openReport(bytes, 0, stop, count))
                return std::move(*report);
            return {}; // the window is being closed
        } catch (const Error &error) {
            return error;
        }
    };
    const auto finish = [this, path, test](Outcome outcome) {
        MainWindow *window = nullptr;
        if (auto *error = std::get_if<Error>(&outcome))
            showError(tr("%1 cannot be opened").arg(QFileInfo(path).fileName()), path, *error);
        else if (auto *report = std::get_if<OpenedReport>(&outcome))
            window = takeReport(*report, path);
        else if (std::holds_alternative<Measurement>(outcome))
            importFiles({path});
        else if (auto *document = std::get_if<Document>(&outcome)) // other names: to be saved under another
            window = take(std::move(*document), isUtf8FileName(path) ? path : QString());
        if (window && test)
            window->workplace().showTest(*test);
    };
    if (!beside) {
        finish(open({}));
        return;
    }
    if (m_reading.contains(path))
        return;
    m_reading += path;
    m_reader.start([open](const Background::Job &job) { return open(job.stop()); },
                   [this, path, finish](Outcome outcome) {
                       m_reading.removeAll(path);
                       showReading();
                       finish(std::move(outcome));
                   });
    showReading();
}

MainWindow *MainWindow::take(Document document, const QString &path, bool modified,
                             const QString &reportPath) {
    if (m_open) {
        auto *other = new MainWindow;
        other->resize(size());
        other->move(pos() + QPoint(24, 24));
        other->show();
        return other->take(std::move(document), path, modified, reportPath);
    }
    m_open = true;
    m_savedAt.clear();
    m_reportPath = reportPath;
    m_rememberNext = !isExample(path);
    const bool wasWelcome = m_stack->currentWidget() == m_welcome;
    workplace();
    m_stack->setCurrentWidget(m_place); // has its size before it is filled
    if (wasWelcome)
        m_workplace->setFocus(); // and not a button that comes next
    m_model.setDocument(std::move(document), isExample(path) ? QString() : path, modified);
    watchFile();
    showState();
    return this;
}

MainWindow *MainWindow::takeReport(const OpenedReport &report, const QString &path) {
    MainWindow *window = take(*report.evaluated.document, {}, false, path);
    const auto verify = [window, report] {
        try {
            window->m_reportBar->showResult(verifyReport(report));
        } catch (const Error &error) {
            window->m_reportBar->showProblem(error.message);
        }
    };
    QMetaObject::invokeMethod(window, verify, Qt::QueuedConnection); // the document is seen before
    return window;
}

std::optional<Test> MainWindow::askForTest(Kind kind, bool ofThisFile) {
    const Test *like = currentTest();
    const auto ask = [&](auto &&dialog) -> std::optional<Test> {
        if (like && ofThisFile && !std::holds_alternative<DriftMeasurement>(like->measurement))
            dialog.offerStatementsOf(*like);
        if (dialog.exec() != QDialog::Accepted)
            return std::nullopt;
        Test test = newTest(dialog.wanted());
        if (dialog.takesStatements())
            takeStatements(test, *like);
        return test;
    };
    if (kind == Kind::circular)
        return ask(NewCircleDialog(windowLanguage(), like, this));
    return ask(NewTestDialog(windowLanguage(), like, this));
}

void MainWindow::newFile(Kind kind) {
    const auto test = askForTest(kind, false);
    if (!test)
        return;
    Document document;
    document.writtenBy = "Palmer " PALMER_VERSION;
    document.report.languages = {windowLanguage().id() == Language::Id::french ? ReportLanguage::fr
                                                                               : ReportLanguage::en};
    insertTest(document, 0, *test);
    take(std::move(document), {}, true)->workplace().beginTyping();
}

const Test *MainWindow::currentTest() const {
    const auto &tests = m_model.document()->tests;
    const std::size_t test = testInView();
    return m_open && test < tests.size() ? tests[test].get() : nullptr;
}

void MainWindow::addTest(Kind kind) {
    const auto test = askForTest(kind, true);
    if (!test)
        return;
    const std::size_t place = m_model.document()->tests.size();
    m_model.edit(QT_TRANSLATE_NOOP("edits", "add a test"),
                 [&](Document &document) { insertTest(document, place, *test); });
    workplace().showTest(place);
    workplace().beginTyping();
}

/// A drift test of the axis in view: what it gives is for the tests of that axis.
void MainWindow::addDriftTest() {
    const Test *like = currentTest();
    Axis axis;
    if (const auto *positioning = like ? std::get_if<PositioningMeasurement>(&like->measurement) : nullptr)
        axis = positioning->axis;
    else if (const auto *drift = like ? std::get_if<DriftMeasurement>(&like->measurement) : nullptr)
        axis = drift->axis;
    const std::size_t place = m_model.document()->tests.size();
    m_model.edit(QT_TRANSLATE_NOOP("edits", "add a drift test"),
                 [&](Document &document) { insertTest(document, place, newDriftTest(axis)); });
    workplace().showTest(place);
    workplace().showPage(Page::readings);
}

void MainWindow::renameTest() {
    const Test *test = currentTest();
    if (!test)
        return;
    auto *dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("renameDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Rename the test"));
    dialog->setLabelText(tr("Name of the test"));
    dialog->setTextValue(QString::fromStdString(test->title));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, index = testInView()](const QString &title) {
                m_model.edit(QT_TRANSLATE_NOOP("edits", "rename the test"), [&](Document &document) {
                    auto renamed = std::make_shared<Test>(*document.tests.at(index));
                    renamed->title = title.trimmed().toStdString();
                    document.tests[index] = std::move(renamed);
                });
            });
    dialog->open();
}

void MainWindow::duplicateTest(bool withReadings) {
    if (!currentTest())
        return;
    const std::size_t test = testInView();
    const char *name = withReadings ? QT_TRANSLATE_NOOP("edits", "duplicate the test")
                                    : QT_TRANSLATE_NOOP("edits", "repeat the test");
    m_model.edit(name, [&](Document &document) { palmer::duplicateTest(document, test, withReadings); });
    workplace().showTest(test + 1);
}

void MainWindow::deleteTest() {
    if (!currentTest())
        return;
    const std::size_t test = testInView();
    m_model.edit(QT_TRANSLATE_NOOP("edits", "delete the test"),
                 [&](Document &document) { removeTest(document, test); });
}

void MainWindow::openRecovery(const Recovery &recovery) {
    // The same file, opened as it was saved, gives way.
    if (m_open && !m_model.isModified() && m_model.path() == recovery.origin.path)
        m_open = false;
    MainWindow *window = take(*recovery.document, recovery.origin.path, true);
    window->watchFile(knownFile(recovery.origin));
    if (window->m_watch.isChanged())
        window->fileChangedOutside();
    if (window->m_autosave.flush()) // a copy of its own before that one goes
        discardRecovery(recovery.file);
}

void MainWindow::watchFile(const std::optional<FileState> &known) {
    if (known)
        m_watch.watch(m_model.path(), *known);
    else
        m_watch.watch(m_model.path());
    m_autosave.setFileState(m_watch.known());
    m_outsideAsked = false;
    m_fileGone = false;
    if (isReadOnly()) // said before anything is typed, not when it is to be saved
        m_notice->show(tr("%1 is read-only: changes can be saved under another name.")
                           .arg(QFileInfo(m_model.path()).fileName()),
                       {{QStringLiteral("saveElsewhere"), tr("Save &as…"), [this] { saveAs(); }},
                        {QStringLiteral("closeNotice"), tr("&Close"), {}}});
    lockFile();
}

bool MainWindow::isReadOnly() const {
    const QFileInfo file(m_model.path());
    constexpr auto anybody = QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther;
    return !m_model.path().isEmpty() && file.exists() &&
           (!file.isWritable() || !(file.permissions() & anybody) ||
            !QFileInfo(file.absolutePath()).isWritable());
}

void MainWindow::lockFile() {
    const QFileInfo file(m_model.path());
    const QString name = m_model.path().isEmpty()
                             ? QString()
                             : file.dir().filePath(QStringLiteral(".~lock.%1#").arg(file.fileName()));
    if (m_lock && m_lock->fileName() == name)
        return;
    m_lock.reset();
    if (name.isEmpty() || !file.exists())
        return;
    auto lock = std::make_unique<QLockFile>(name);
    lock->setStaleLockTime(0); // only what a program that is gone has left behind is taken over
    if (lock->tryLock(0)) {
        m_lock = std::move(lock);
        return;
    }
    qint64 process = 0;
    QString host;
    QString program;
    if (lock->error() != QLockFile::LockFailedError || !lock->getLockInfo(&process, &host, &program))
        return; // a folder that nobody may write to
    m_notice->show(tr("%1 is open already: %2 on %3, process %4. Who saves last overwrites the other.")
                       .arg(file.fileName(), program, host)
                       .arg(process),
                   {{QStringLiteral("saveElsewhere"), tr("Save &as…"), [this] { saveAs(); }},
                    {QStringLiteral("closeNotice"), tr("&Close"), {}}});
}

void MainWindow::keepCopy() {
    commitTyping();
    if (isUnsaved())
        m_autosave.flush();
    m_lock.reset(); // no destructor will; the next saving locks again
}

void MainWindow::offerRecoveries() {
    std::vector<Recovery> found = abandonedRecoveries(Autosave::folder());
    if (found.empty())
        return;
    auto *dialog = new RecoveryDialog(std::move(found), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &RecoveryDialog::recovered, this, &MainWindow::openRecovery);
    dialog->open();
}

void MainWindow::fileChangedOutside() {
    const QString name = QFileInfo(m_model.path()).fileName();
    m_outsideAsked = false;
    m_fileGone = !QFileInfo::exists(m_model.path());
    showState();
    if (m_fileGone) {
        m_notice->show(tr("%1 is no longer where it was. Save to write it anew.").arg(name),
                       {{QStringLiteral("saveAgain"), tr("&Save"), [this] { save(); }},
                        {QStringLiteral("closeNotice"), tr("&Close"), {}}});
        return;
    }
    m_notice->show(
        m_model.isModified()
            ? tr("Another program has changed %1. Loading it gives up the changes made here.").arg(name)
            : tr("Another program has changed %1.").arg(name),
        {{QStringLiteral("reload"), tr("&Load it"), [this] { reload(); }},
         {QStringLiteral("keepMine"), tr("&Keep what is here"), [this] {
              m_outsideAsked = true;
              showState();
          }}});
}

void MainWindow::reload() {
    try {
        Document document = openDocument(m_model.path());
        m_model.setDocument(std::move(document), m_model.path());
        watchFile();
        showState();
    } catch (const Error &error) {
        showError(tr("%1 cannot be opened").arg(QFileInfo(m_model.path()).fileName()), m_model.path(), error);
    }
}

void MainWindow::showError(const QString &title, const QString &fileName, const Error &error) {
    auto *box = new QMessageBox(QMessageBox::Critical, title, title, QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("errorBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QString sentence = windowLanguage().sentence(error.message);
    if (!sentence.isEmpty()) // elsewhere it stands behind a colon
        sentence[0] = sentence[0].toUpper();
    if (!error.place.empty())
        sentence += QStringLiteral("\n\n") + tr("Place: %1").arg(QString::fromStdString(error.place));
    box->setInformativeText(sentence);
    box->setTextFormat(Qt::PlainText);
    box->setToolTip(fileName);
    box->open();
}

bool MainWindow::save() {
    if (m_model.path().isEmpty() || isReadOnly())
        return saveAs();
    if (!m_outsideAsked && QFileInfo::exists(m_model.path()) && m_watch.isChanged()) {
        QMessageBox box(QMessageBox::Warning, tr("Save"),
                        tr("Another program has changed %1 since it was opened here.")
                            .arg(QFileInfo(m_model.path()).fileName()),
                        QMessageBox::Cancel, this);
        box.setObjectName(QStringLiteral("overwriteBox"));
        box.setInformativeText(tr("Saving puts what is here in its place."));
        auto *overwrite = box.addButton(tr("&Overwrite"), QMessageBox::AcceptRole);
        auto *other = box.addButton(tr("Save &as…"), QMessageBox::ActionRole);
        overwrite->setObjectName(QStringLiteral("overwrite"));
        box.setDefaultButton(other);
        box.exec();
        if (box.clickedButton() == other)
            return saveAs();
        if (box.clickedButton() != overwrite)
            return false;
    }
    return saveTo(m_model.path());
}

bool MainWindow::saveAs() {
    QFileDialog dialog(this, tr("Save the test file"));
    dialog.setObjectName(QStringLiteral("saveDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({tr("Test files (*.palmer)"), tr("All files (*)")});
    dialog.setDefaultSuffix(QStringLiteral("palmer"));
    const QFileInfo report(m_reportPath);
    if (!m_reportPath.isEmpty() && m_model.path().isEmpty())
        dialog.selectFile(report.dir().filePath(report.completeBaseName() + QStringLiteral(".palmer")));
    else if (m_model.path().isEmpty()) {
        dialog.setDirectory(QSettings().value(QStringLiteral("window/folder")).toString());
        dialog.selectFile(proposedName(*m_model.document()));
    } else
        dialog.selectFile(m_model.path());
    return dialog.exec() == QDialog::Accepted && saveTo(dialog.selectedFiles().constFirst());
}

bool MainWindow::saveTo(const QString &path) {
    try {
        if (keepsBackups() && QFileInfo::exists(path))
            saveBytes(readBytes(path), path + QStringLiteral(".bak"));
        m_model.save(path);
    } catch (const Error &error) {
        showError(tr("%1 cannot be saved").arg(QFileInfo(path).fileName()), path, error);
        return false;
    }
    m_savedAt = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
    m_autosavedAt.clear();
    m_notice->hide();
    watchFile();
    remember();
    noteSavedFile(path);
    showState();
    return true;
}

void MainWindow::remember() {
    const QString path = m_model.path().isEmpty() ? m_reportPath : m_model.path();
    if (!path.isEmpty())
        rememberFile(describeFile(path, m_evaluator.current()));
}

QString MainWindow::notTaken(const QStringList &refused) {
    QStringList quoted;
    for (const QString &text : refused)
        quoted << tr("“%1”").arg(text);
    return tr("Typed and shown in red, but never taken: %1. It is not saved.")
        .arg(quoted.join(QStringLiteral(", ")));
}

/// Texts that could not be taken go with the window: only when the user says so.
bool MainWindow::mayForget(const QStringList &refused) {
    QMessageBox box(QMessageBox::Question, tr("Close"), tr("Close without what could not be taken?"),
                    QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("closeBox"));
    box.setDefaultButton(QMessageBox::Cancel);
    box.setInformativeText(notTaken(refused));
    return box.exec() == QMessageBox::Discard;
}

bool MainWindow::isUnsaved() const {
    return m_open && (m_model.isModified() || m_outsideAsked || m_fileGone);
}

bool MainWindow::mayClose() {
    if (std::exchange(m_discarded, false))
        return true;
    commitTyping();
    m_fileGone = m_open && !m_model.path().isEmpty() && !QFileInfo::exists(m_model.path());
    if (!m_open)
        return true;
    const QStringList refused = workplace().refusedTexts();
    if (!isUnsaved())
        return refused.isEmpty() || mayForget(refused);
    const QString name = QFileInfo(m_model.path()).fileName();
    const bool onlyHere = m_fileGone || m_outsideAsked;
    QMessageBox box(QMessageBox::Question, tr("Close"),
                    m_fileGone ? tr("%1 is no longer where it was. Save it before closing?").arg(name)
                    : m_outsideAsked
                        ? tr("Another program has changed %1. Save what is here before closing?").arg(name)
                        : tr("Save the changes before closing?"),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("closeBox"));
    box.setTextFormat(Qt::PlainText);
    box.setDefaultButton(QMessageBox::Save);
    box.setInformativeText((onlyHere ? tr("Otherwise what is here is lost.")
                                     : tr("Otherwise the changes since the last saving are lost.")) +
                           (refused.isEmpty() ? QString() : u' ' + notTaken(refused)));
    const int answer = box.exec();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

void MainWindow::setEdition(std::size_t test, const QString &edition) {
    m_model.edit(QT_TRANSLATE_NOOP("edits", "set the edition of the test"), [&](Document &document) {
        auto changed = std::make_shared<Test>(*document.tests[test]);
        // A limit that names no edition was agreed for the one the test had: it must not pass to another.
        for (auto &[id, limit] : changed->limits) {
            if (limit.value && !limit.edition)
                limit.edition = changed->edition;
        }
        changed->edition = edition.toStdString();
        document.tests[test] = std::move(changed);
    });
    m_evaluator.setView(test, {});
}

void MainWindow::step(bool forward) {
    QUndoStack *stack = m_model.undoStack();
    if (forward ? !stack->canRedo() : !stack->canUndo())
        return;
    const DocumentPointer before = m_model.document();
    const QString name = forward ? stack->redoText() : stack->undoText();
    if (forward)
        stack->redo();
    else
        stack->undo();
    workplace().showChange(*before, *m_model.document(), name);
}

/// Closes all windows; where several have changes, one question asks about all of them.
void MainWindow::quit() {
    QList<MainWindow *> unsaved;
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        auto *window = qobject_cast<MainWindow *>(widget);
        if (window && window->isVisible() && window->isUnsaved())
            unsaved << window;
    }
    if (unsaved.size() < 2) {
        QApplication::closeAllWindows();
        return;
    }
    QStringList names;
    for (MainWindow *window : unsaved)
        names << window->windowTitle().remove(QStringLiteral("[*] — Palmer"));
    QMessageBox box(
        QMessageBox::Question, tr("Quit"),
        tr("%n file(s) have changes that are not saved.", nullptr, static_cast<int>(names.size())),
        QMessageBox::NoButton, QApplication::activeWindow());
    box.setObjectName(QStringLiteral("quitBox"));
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(names.join(u'\n'));
    auto *saveAll = box.addButton(tr("&Save all"), QMessageBox::AcceptRole);
    auto *discardAll = box.addButton(tr("&Discard all"), QMessageBox::DestructiveRole);
    auto *oneByOne = box.addButton(tr("&One by one"), QMessageBox::ActionRole);
    box.addButton(tr("&Cancel"), QMessageBox::RejectRole);
    saveAll->setObjectName(QStringLiteral("saveAll"));
    discardAll->setObjectName(QStringLiteral("discardAll"));
    oneByOne->setObjectName(QStringLiteral("oneByOne"));
    box.setDefaultButton(saveAll);
    box.exec();
    const QAbstractButton *answer = box.clickedButton();
    if (answer != saveAll && answer != discardAll && answer != oneByOne)
        return;
    for (MainWindow *window : unsaved) {
        if (answer == saveAll && !window->save())
            return;
        window->m_discarded = answer == discardAll;
    }
    QApplication::closeAllWindows();
}

void MainWindow::fillRecentMenu() {
    m_recentMenu->clear();
    int number = 1;
    for (const RecentFile &file : recentFiles()) {
        QAction *action = m_recentMenu->addAction(QStringLiteral("&%1  %2").arg(number++).arg(
            QFileInfo(file.path).fileName().replace(u'&', QStringLiteral("&&"))));
        action->setToolTip(file.path);
        connect(action, &QAction::triggered, this, [this, path = file.path] { openFile(path); });
    }
    if (m_recentMenu->isEmpty()) {
        m_recentMenu->addAction(tr("No file yet"))->setEnabled(false);
        return;
    }
    m_recentMenu->addSeparator();
    QAction *clear = m_recentMenu->addAction(tr("&Clear the list"));
    clear->setObjectName(QStringLiteral("clearRecent"));
    connect(clear, &QAction::triggered, this, [this] {
        forgetFiles();
        m_welcome->refresh();
    });
}

void MainWindow::fillExamplesMenu() {
    m_examplesMenu->clear();
    int number = 1;
    for (const Example &example : examples()) {
        QAction *action =
            m_examplesMenu->addAction(QStringLiteral("&%1  %2").arg(number++).arg(example.name));
        connect(action, &QAction::triggered, this, [this, path = example.path] { openFile(path); });
    }
}

void MainWindow::showUndo() {
    const QUndoStack *stack = m_model.undoStack();
    m_undoAction->setEnabled(m_open && stack->canUndo());
    m_redoAction->setEnabled(m_open && stack->canRedo());
    m_undoAction->setText(stack->canUndo() ? tr("&Undo: %1").arg(editName(stack->undoText())) : tr("&Undo"));
    m_redoAction->setText(stack->canRedo() ? tr("&Redo: %1").arg(editName(stack->redoText())) : tr("&Redo"));
    m_undoAction->setIconText(tr("Undo"));
    m_redoAction->setIconText(tr("Redo"));
    m_undoAction->setToolTip(hint(*m_undoAction));
    m_redoAction->setToolTip(hint(*m_redoAction));
}

void MainWindow::enableActions() {
    const std::size_t tests = m_open ? m_model.document()->tests.size() : 0;
    const std::size_t test = testInView();
    const auto &evaluated = m_evaluator.latest().tests;
    const bool view = m_open && test < evaluated.size() && evaluated[test]->view;
    m_saveAction->setEnabled(m_open);
    m_saveAsAction->setEnabled(m_open);
    m_reportAction->setEnabled(m_open);
    m_planAction->setEnabled(m_open);
    const Test *current = test < evaluated.size() && !m_evaluator.isBusy() ? currentTest() : nullptr;
    m_exportReadingsAction->setEnabled(current);
    m_exportFigureAction->setEnabled(current);
    m_compensationAction->setEnabled(current &&
                                     std::holds_alternative<PositioningMeasurement>(current->measurement));
    m_compareAction->setEnabled(current && evaluated[test]->edition);
    m_previousTestAction->setEnabled(test > 0 && test < tests);
    m_nextTestAction->setEnabled(test + 1 < tests);
    m_addTestAction->setEnabled(m_open);
    m_addCircleAction->setEnabled(m_open);
    m_addDriftAction->setEnabled(m_open);
    for (QAction *action :
         {m_renameTestAction, m_duplicateTestAction, m_repeatTestAction, m_deleteTestAction})
        action->setEnabled(test < tests);
    m_setEditionAction->setEnabled(view);
    m_ownEditionAction->setEnabled(view);
    for (QAction *action : m_pageActions)
        action->setEnabled(tests > 0);
    m_nextMissingAction->setEnabled(tests > 0);
    m_previousMissingAction->setEnabled(tests > 0);
    m_nextPaneAction->setEnabled(m_open);
    m_previousPaneAction->setEnabled(m_open);
    m_maximiseAction->setEnabled(m_open);
}

void MainWindow::showState() {
    showUndo();
    enableActions();
    m_toolBar->setVisible(hasTools());
    m_content->setVisible(m_open);
    m_hint->setVisible(m_open);

    const QString path = m_reading.isEmpty() ? m_importing : m_reading.constFirst();
    const QString reading = path.isEmpty() ? QString() : tr("Reading %1…").arg(QFileInfo(path).fileName());
    if (!m_open) {
        setWindowTitle(QStringLiteral("Palmer"));
        m_state->setText(reading.isEmpty() ? QStringLiteral("Palmer " PALMER_VERSION) : reading);
        return;
    }
    setWindowFilePath(m_model.path());
    QString name = QFileInfo(m_model.path()).fileName();
    if (m_model.path().isEmpty())
        name = m_reportPath.isEmpty() ? QString::fromStdString(m_model.document()->report.title)
                                      : tr("%1 (copy)").arg(QFileInfo(m_reportPath).fileName());
    if (isReadOnly())
        name = tr("%1 (read-only)").arg(name);
    setWindowTitle(QStringLiteral("%1[*] — Palmer").arg(name.isEmpty() ? tr("Untitled") : name));
    setWindowModified(isUnsaved());
    if (!reading.isEmpty())
        m_state->setText(reading);
    else if (m_evaluator.isBusy())
        m_state->setText(tr("Computing…"));
    else if (isUnsaved())
        m_state->setText(m_autosavedAt.isEmpty() ? tr("Changed")
                                                 : tr("Kept automatically at %1").arg(m_autosavedAt));
    else if (!m_savedAt.isEmpty())
        m_state->setText(tr("Saved at %1").arg(m_savedAt));
    else
        m_state->setText(!m_model.path().isEmpty() ? QString()
                         : m_reportPath.isEmpty()  ? tr("Example")
                                                   : tr("Copy of the test file in a report"));
}

void MainWindow::showReport() {
    ReportDialog dialog(m_model, m_evaluator, this);
    dialog.exec();
}

void MainWindow::showPlan() {
    PlanDialog dialog(m_model, testInView(), this);
    connect(&dialog, &PlanDialog::testMade, this, [this](std::size_t test) {
        workplace().showTest(test);
        workplace().showPage(Page::readings);
    });
    dialog.exec();
}

void MainWindow::showComparison() {
    CompareDialog dialog(m_evaluator.current(), testInView(), this);
    dialog.exec();
}

void MainWindow::showCompensation() {
    auto *dialog = new CompensationDialog(m_evaluator.current(), testInView(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

/// What has the focus decides where the help opens: a field, the edition of a result, else the workflow.
void MainWindow::showHelp() {
    const QWidget *focused = QApplication::focusWidget();
    const QString topic = focused ? focused->property("helpTopic").toString() : QString();
    const std::size_t test = testInView();
    const auto &evaluated = m_evaluator.latest().tests;
    if (!topic.isEmpty())
        showHelpPage(QStringLiteral("fields"), topic);
    else if (m_workplace && !m_workplace->selection().parameter().isEmpty() && test < evaluated.size() &&
             evaluated[test]->edition)
        showHelpPage(QStringLiteral("editions.") + QString::fromUtf8(evaluated[test]->edition->word));
    else
        showHelpPage(QStringLiteral("workflow"));
}

void MainWindow::showHelpPage(const QString &id, const QString &anchor) {
    if (!m_help)
        m_help = new HelpWindow(this);
    m_help->showPage(id, anchor);
    m_help->show();
    m_help->raise();
    m_help->activateWindow();
}

void MainWindow::showFeed() {
    auto *dialog = new FeedDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const std::size_t test = testInView();
    const auto &tests = m_model.document()->tests;
    if (m_open && test < tests.size()) {
        // Of the test at hand the diameter is known; its feed may be the specified one.
        const auto *measurement = std::get_if<CircularMeasurement>(&tests[test]->measurement);
        if (measurement && measurement->nominalRadius > 0) {
            const double diameter = 2 * measurement->nominalRadius;
            dialog->setNumbers({diameter, measurement->feed.value_or(0), diameter});
        }
    }
    dialog->show();
}

void MainWindow::showShortcuts() {
    workplace(); // its actions have some, too
    auto *dialog = new ShortcutsDialog(*menuBar(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void MainWindow::showSettings() {
    auto *dialog = new SettingsDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void MainWindow::about() {
    showAbout(this);
}

void MainWindow::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showState();
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent *event) {
    if (!mayClose()) {
        event->ignore();
        return;
    }
    QSettings().setValue(QStringLiteral("window/geometry"), saveGeometry());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event) {
    for (const QUrl &url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            event->acceptProposedAction();
            return;
        }
    }
}

void MainWindow::dropEvent(QDropEvent *event) {
    event->acceptProposedAction();
    for (const QUrl &url : event->mimeData()->urls()) {
        if (url.isLocalFile())
            openFile(url.toLocalFile());
    }
}

bool MainWindow::hasTools() const {
    return m_open && height() >= noToolsBelow;
}

void MainWindow::resizeEvent(QResizeEvent *event) {
    QMainWindow::resizeEvent(event);
    const bool iconsOnly = width() < iconsOnlyBelow;
    m_toolBar->setVisible(hasTools());
    m_toolBar->setToolButtonStyle(iconsOnly ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
    for (QAction *action : {m_undoAction, m_redoAction}) {
        auto *button = qobject_cast<QToolButton *>(m_toolBar->widgetForAction(action));
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    }
}

void MainWindow::keyPressEvent(QKeyEvent *event) {
    const bool escapes = m_workplace && event->key() == Qt::Key_Escape;
    if (escapes && m_workplace->isFigureMaximised())
        m_workplace->setFigureMaximised(false);
    else if (escapes && !m_workplace->selection().parameter().isEmpty())
        m_workplace->selection().setParameter({});
    else
        QMainWindow::keyPressEvent(event);
}

void MainWindow::retranslate() {
    m_fileMenu->setTitle(tr("&File"));
    m_editMenu->setTitle(tr("&Edit"));
    m_testMenu->setTitle(tr("&Test"));
    m_viewMenu->setTitle(tr("&View"));
    m_toolsMenu->setTitle(tr("&Utilities"));
    m_helpMenu->setTitle(tr("&Help"));
    m_newAction->setText(tr("&New positioning test…"));
    m_newCircleAction->setText(tr("New circular &test…"));
    m_newAction->setIconText(tr("New"));
    m_addTestAction->setText(tr("&Add a positioning test…"));
    m_addCircleAction->setText(tr("Add a circular &test…"));
    m_addDriftAction->setText(tr("Add a dri&ft test"));
    m_renameTestAction->setText(tr("Rena&me the test…"));
    m_duplicateTestAction->setText(tr("Dupli&cate the test"));
    m_repeatTestAction->setText(tr("Repeat the test, &without readings"));
    m_deleteTestAction->setText(tr("Delete the t&est"));
    m_openAction->setText(tr("&Open…"));
    m_openAction->setIconText(tr("Open"));
    m_importAction->setText(tr("&Import…"));
    m_importClipboardAction->setText(tr("Import from the clip&board…"));
    m_recentMenu->setTitle(tr("Open &recent"));
    m_examplesMenu->setTitle(tr("E&xamples"));
    m_saveAction->setText(tr("&Save"));
    m_saveAsAction->setText(tr("Save &as…"));
    m_reportAction->setText(tr("Re&port…"));
    m_reportAction->setIconText(tr("Report…"));
    m_exportMenu->setTitle(tr("&Export"));
    m_exportReadingsAction->setText(tr("&Readings and results…"));
    m_exportFigureAction->setText(tr("&Data of the figure…"));
    m_compensationAction->setText(tr("&Compensation table…"));
    m_newWindowAction->setText(tr("New &window"));
    m_closeAction->setText(tr("&Close"));
    m_quitAction->setText(tr("&Quit"));
    m_planAction->setText(tr("P&lan…"));
    m_planAction->setIconText(tr("Plan…"));
    m_compareAction->setText(tr("Co&mpare…"));
    m_helpAction->setText(tr("&Help"));
    m_shortcutsAction->setText(tr("&Keyboard shortcuts"));
    m_validationAction->setText(tr("&Validation"));
    m_settingsAction->setText(tr("&Settings…"));
    m_previousTestAction->setText(tr("&Previous test"));
    m_nextTestAction->setText(tr("&Next test"));
    m_setEditionAction->setText(tr("&Set as edition of the test"));
    m_ownEditionAction->setText(tr("&Back to the edition of the test"));
    m_feedAction->setText(tr("Contouring &feed…"));
    m_registerAction->setText(tr("&Register of all tests…"));
    m_pageActions[0]->setText(tr("&Readings"));
    m_pageActions[1]->setText(tr("&Conditions"));
    m_pageActions[2]->setText(tr("&Agreed points"));
    m_pageActions[3]->setText(tr("&Limits"));
    m_pageActions[4]->setText(tr("Uncertaint&y"));
    m_pageActions[5]->setText(tr("D&iagnosis"));
    m_nextMissingAction->setText(tr("&Next missing statement"));
    m_previousMissingAction->setText(tr("&Previous missing statement"));
    m_nextPaneAction->setText(tr("Ne&xt pane"));
    m_previousPaneAction->setText(tr("Pre&vious pane"));
    m_maximiseAction->setText(tr("&Maximise the figure"));
    m_unitsMenu->setTitle(tr("&Units"));
    m_lengthActions[0]->setText(tr("Lengths: µm and mm"));
    m_lengthActions[1]->setText(tr("Lengths: mm only"));
    m_lengthActions[2]->setText(tr("Lengths: µin and inches"));
    m_angleActions[0]->setText(tr("Angles: arc seconds and degrees"));
    m_angleActions[1]->setText(tr("Angles: degrees only"));
    const DisplayUnits units = windowLanguage().units();
    m_lengthActions.at(static_cast<std::size_t>(units.lengths))->setChecked(true);
    m_angleActions.at(static_cast<std::size_t>(units.angles))->setChecked(true);
    m_frenchAction->setText(QStringLiteral("&Français"));
    m_englishAction->setText(QStringLiteral("&English"));
    m_frenchAction->setChecked(windowLanguage().id() == Language::Id::french);
    m_englishAction->setChecked(windowLanguage().id() == Language::Id::english);
    m_aboutAction->setText(tr("&About Palmer"));
    m_aboutQtAction->setText(tr("About &Qt"));
    m_toolBar->setWindowTitle(tr("Tools"));
    m_toolBar->setAccessibleName(tr("Tools"));
    menuBar()->setAccessibleName(tr("Menus"));
    statusBar()->setAccessibleName(tr("State"));
    for (QAction *action : {m_newAction, m_openAction, m_saveAction, m_planAction, m_compareAction,
                            m_helpAction, m_reportAction})
        action->setToolTip(hint(*action));
    for (QAction *action : {m_newAction, m_openAction, m_saveAction, m_undoAction, m_redoAction,
                            m_importAction, m_planAction, m_reportAction}) {
        QString name = action->iconText();
        m_toolBar->widgetForAction(action)->setAccessibleName(name.remove(u'…'));
    }
}

} // namespace palmer::ui
