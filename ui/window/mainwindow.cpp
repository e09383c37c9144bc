// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/mainwindow.h"
#include "kernel/measurement/testfacts.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/clipboardtext.h"
#include "ui/model/editname.h"
#include "ui/sizeonscreen.h"

#include "document/edits.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/testfile.h"
#include "editing/newtest.h"
#include "editing/takestatements.h"
#include "import/formats.h"
#include "print/proof/verifyreport.h"
#include "register/historyfile.h"
#include "system/filename.h"
#include "ui/circles/circlespage.h"
#include "ui/dialogs/comparedialog.h"
#include "ui/dialogs/compensationdialog.h"
#include "ui/dialogs/feeddialog.h"
#include "ui/dialogs/newcircledialog.h"
#include "ui/dialogs/newtestdialog.h"
#include "ui/dialogs/plandialog.h"
#include "ui/dialogs/recoverydialog.h"
#include "ui/dialogs/reportdialog.h"
#include "ui/dialogs/shortcutsdialog.h"
#include "ui/guards.h"
#include "ui/help/helpwindow.h"
#include "ui/import/importassistant.h"
#include "ui/languageswitch.h"
#include "ui/model/settings.h"
#include "ui/proof/reportbar.h"
#include "ui/readings/readingspage.h"
#include "ui/register/registerqueries.h"
#include "ui/register/registerservice.h"
#include "ui/register/typedialog.h"
#include "ui/saving.h"
#include "ui/testname.h"
#include "ui/theme.h"
#include "ui/welcome/examples.h"
#include "ui/welcome/recentfiles.h"
#include "ui/welcome/welcomepage.h"
#include "ui/window/exports.h"
#include "ui/window/liketest.h"
#include "ui/window/noticebar.h"
#include "ui/window/openregister.h"
#include "ui/window/searchbox.h"
#include "ui/window/settingsdialog.h"
#include "ui/window/workplace.h"
#include "ui/windowlanguage.h"
#include "ui/workbar.h"

#include <QAction>
#include <QApplication>
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
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTime>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>
#include <variant>

namespace palmer::ui {

namespace {

constexpr int statusHeight = 27;
constexpr int iconsOnlyBelow = 1180;
/// Height below which the table needs the space of the toolbar, whose tools are all in the menus as well.
constexpr int noToolsBelow = 430;
constexpr QSize leastSize(320, 240); ///< below the minimum size of its parts, they scroll

/// In the toolbar; `none` is a separator.
constexpr std::array tools{WindowAction::newTest, WindowAction::open,   WindowAction::save,
                           WindowAction::none,    WindowAction::undo,   WindowAction::redo,
                           WindowAction::none,    WindowAction::import, WindowAction::plan,
                           WindowAction::report};

/// True if a file is not a test file. Opening reports unreadable files; large ones are checked while read.
bool isMeasurement(const QString &path) {
    if (isExample(path) || isTestFileName(path) || isLargeFile(QFileInfo(path).size()))
        return false;
    try {
        return !isTestFile(readBytes(path));
    } catch (const Error &) {
        return false;
    }
}

/// Proposed file name for an unsaved document: its report number, otherwise machine and axes, otherwise its
/// title, without characters forbidden in file names.
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

/// A report simulates again.
bool mayTakeLong(const QString &path) {
    return path.endsWith(QLatin1StringView(".pdf"), Qt::CaseInsensitive) ||
           (isLargeFile(QFileInfo(path).size()) && !isExample(path));
}

} // namespace

MainWindow::MainWindow(QWidget *parent)
    : Translated(parent)
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
    inColumn(m_centre, noMargins, 0, {m_notice, m_reportBar, {m_stack, 1}});
    makeMenus();
    makeToolBar();
    makeStatusBar();
    connectParts();
    resize(sizeOnScreen(*this, {1280, 800}));
    const QByteArray geometry = QSettings().value(QStringLiteral("window/geometry")).toByteArray();
    if (!geometry.isEmpty())
        restoreGeometry(geometry);
    retranslate();
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

void MainWindow::makeToolBar() {
    m_toolBar = made<QToolBar>("toolBar", this);
    m_toolBar->setMovable(false);
    m_toolBar->setContextMenuPolicy(Qt::PreventContextMenu);
    m_toolBar->setFixedHeight(pageBarHeight);
    m_toolBar->setIconSize(QSize(16, 16));
    setContextMenuPolicy(Qt::PreventContextMenu); // no context menu, which could hide the toolbar by accident
    for (const WindowAction tool : tools) {
        if (tool == WindowAction::none) {
            m_toolBar->addSeparator();
            continue;
        }
        m_toolBar->addAction(action(tool));
        toolButton(tool).setObjectName(action(tool)->objectName() + QStringLiteral("Button"));
        toolButton(tool).setFocusPolicy(Qt::TabFocus);
    }
    QToolButton &newButton = toolButton(WindowAction::newTest);
    auto *kinds = new QMenu(&newButton);
    kinds->addActions({action(WindowAction::newTest), action(WindowAction::newCircle)});
    newButton.setMenu(kinds);
    newButton.setPopupMode(QToolButton::MenuButtonPopup);
    auto *space = new QWidget(m_toolBar);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_toolBar->addWidget(space);
    m_search = new SearchBox(m_toolBar);
    m_search->setSource([this] { return searchEntries(); });
    connect(m_search, &SearchBox::said, m_toolBar, [this](const QString &text) { m_hint->setText(text); });
    m_toolBar->addWidget(m_search);
    auto *gap = new QWidget(m_toolBar);
    gap->setFixedWidth(8);
    m_toolBar->addWidget(gap);
    m_toolBar->addWidget(new LanguageSwitch(LanguageSwitch::Names::codes, m_toolBar));
    addToolBar(m_toolBar);
}

/// Fields, results and findings of the test, and all commands of the menus with the settings.
std::vector<SearchEntry> MainWindow::searchEntries() {
    std::vector<SearchEntry> entries = m_open ? workplace().searchEntries() : std::vector<SearchEntry>();
    const auto plain = [](QString text) { return text.remove(u'&').remove(u'…'); };
    const std::function<void(const QMenu &)> add = [&](const QMenu &menu) {
        for (QAction *action : menu.actions()) {
            if (const QMenu *inner = action->menu()) {
                if (inner != this->menu(WindowMenu::history)) // its steps are of the time when it was open
                    add(*inner);
            } else if (action->isEnabled() && !action->isSeparator())
                entries.push_back({SearchGroup::settings, plain(action->text()),
                                   action->shortcut().toString(QKeySequence::NativeText), plain(menu.title()),
                                   [chosen = QPointer<QAction>(action)] {
                                       if (chosen)
                                           chosen->trigger();
                                   }});
        }
    };
    for (const QAction *action : menuBar()->actions()) {
        if (const QMenu *menu = action->menu())
            add(*menu);
    }
    for (const QString &name : SettingsDialog::names())
        entries.push_back({SearchGroup::settings, name, {}, SettingsDialog::tr("Settings"), [this] {
                               action(WindowAction::settings)->trigger();
                           }});
    return entries;
}

QToolButton &MainWindow::toolButton(WindowAction tool) const {
    return *qobject_cast<QToolButton *>(m_toolBar->widgetForAction(action(tool)));
}

void MainWindow::makeStatusBar() {
    statusBar()->setFixedHeight(statusHeight);
    statusBar()->setSizeGripEnabled(false);
    m_content = made<QLabel>("statusContent", TextSize::small, this);
    m_hint = made<QLabel>("statusHint", TextSize::small, trait::secondary, this);
    m_state = made<QLabel>("statusState", TextSize::small, trait::secondary, this);
    m_content->setContentsMargins(14, 0, 8, 0);
    m_state->setContentsMargins(8, 0, 14, 0);
    m_lack = made<ElidedButton>("statusLack", trait::link, trait::notDefault, this);
    m_lack->setFont(themeFont(TextSize::small));
    m_lack->hide();
    connect(m_lack, &QPushButton::clicked, this, [this] { workplace().showFindings(); });
    statusBar()->addWidget(m_content);
    statusBar()->addWidget(m_lack);
    statusBar()->addWidget(m_hint, 1);
    m_work = new WorkBar(this);
    statusBar()->addPermanentWidget(m_state);
    statusBar()->addPermanentWidget(m_work);
    m_work->hide(); // adding it to the status bar has shown it
}

void MainWindow::connectParts() {
    connect(&m_autosave, &Autosave::saved, this, [this] {
        m_autosavedAt = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
        showState();
    });
    connect(&m_autosave, &Autosave::failed, this, [this](const Error &error) {
        m_notice->show([this, message = error.message] {
            return NoticeBar::Notice{
                tr("Changes cannot be kept safe automatically: %1.").arg(windowLanguage().sentence(message)),
                {{QStringLiteral("saveElsewhere"), tr("Save &as…"), [this] { saveAs(); }},
                 {QStringLiteral("closeNotice"), tr("&Close"), {}}}};
        });
    });
    connect(&m_watch, &FileWatch::changed, this, &MainWindow::fileChangedOutside);
    connect(m_work, &WorkBar::cancelled, this, &MainWindow::cancelReading);
    connect(m_model.undoStack(), &QUndoStack::indexChanged, this, &MainWindow::showState);
    connect(menu(WindowMenu::recent), &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    connect(menu(WindowMenu::examples), &QMenu::aboutToShow, this, &MainWindow::fillExamplesMenu);
    connect(menu(WindowMenu::history), &QMenu::aboutToShow, this, &MainWindow::fillHistoryMenu);
    connect(m_welcome, &WelcomePage::newAsked, action(WindowAction::newTest), &QAction::trigger);
    connect(m_welcome, &WelcomePage::newCircleAsked, action(WindowAction::newCircle), &QAction::trigger);
    connect(m_welcome, &WelcomePage::openAsked, this, &MainWindow::chooseFile);
    connect(m_welcome, &WelcomePage::importAsked, this, &MainWindow::chooseMeasurements);
    connect(m_welcome, &WelcomePage::planAsked, action(WindowAction::plan), &QAction::trigger);
    connect(m_welcome, &WelcomePage::fileChosen, this, [this](const QString &path) { openFile(path); });
    connect(&m_model, &DocumentModel::changed, this, [this] {
        m_evaluator.setDocument(m_model.document());
        if (m_verified)
            m_reportBar->setEdited(*m_model.document() != *m_verified);
    });
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
    for (const WindowMenu filled : {WindowMenu::edit, WindowMenu::test}) // the workplace enables the actions
        connect(menu(filled), &QMenu::aboutToShow, this, [this] { workplace(); });
}

/// Made on first use, so that the start does not wait for pages out of view.
Workplace &MainWindow::workplace() {
    if (m_workplace)
        return *m_workplace;
    m_place = scrolledPlace(m_stack);
    m_workplace = new Workplace(m_model, m_evaluator, m_place->viewport());
    m_place->setWidget(m_workplace);
    m_stack->addWidget(m_place);
    menu(WindowMenu::edit)->addActions(m_workplace->readings().editActions());
    menu(WindowMenu::test)
        ->insertActions(action(WindowAction::afterReadings), m_workplace->readings().testActions());
    menu(WindowMenu::test)
        ->insertActions(action(WindowAction::afterCircles), m_workplace->circles().testActions());
    m_workplace->setTestActions(
        {action(WindowAction::addTest), action(WindowAction::addCircle), action(WindowAction::addDrift)},
        {action(WindowAction::renameTest), action(WindowAction::duplicateTest),
         action(WindowAction::repeatTest), action(WindowAction::deleteTest)},
        action(WindowAction::showInReport));
    connect(m_workplace, &Workplace::viewChosen, this, [this](std::size_t test, const QString &edition) {
        m_evaluator.setView(test, edition.toStdString());
    });
    connect(&m_workplace->circles(), &CirclesPage::importAsked, action(WindowAction::import),
            &QAction::trigger);
    connect(m_workplace, &Workplace::likeLastWanted, action(WindowAction::fillLikeLast), &QAction::trigger);
    connect(m_workplace, &Workplace::editionSet, this, &MainWindow::setEdition);
    connect(m_workplace, &Workplace::contentChanged, m_content, &QLabel::setText);
    connect(m_workplace, &Workplace::hintChanged, m_hint, &QLabel::setText);
    connect(m_workplace, &Workplace::lackChanged, this, [this](const QString &text) {
        m_lack->setText(text);
        m_lack->setVisible(m_open && !text.isEmpty());
    });
    connect(&m_workplace->selection(), &Selection::testChanged, this, &MainWindow::showState);
    return *m_workplace;
}

/// Makes the pages while a large file is read in the background; taking it over is work enough by itself.
void MainWindow::makePagesMeanwhile() {
    QTimer::singleShot(0, this, [this] { workplace(); });
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
    dialog.setNameFilters({tr("Measurements (%1)").arg(importPatterns()), tr("All files (*)")});
    if (dialog.exec() != QDialog::Accepted)
        return;
    QSettings().setValue(QStringLiteral("window/importFolder"), dialog.directory().absolutePath());
    importFiles(dialog.selectedFiles());
}

void MainWindow::importFiles(const QStringList &paths) {
    m_toImport << paths;
    if (m_assistant)
        m_assistant->setFollowing(m_toImport.size());
    importNext();
}

/// Opens the assistant for one file at a time.
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

/// `size` decides whether to read at once or in the background.
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
    makePagesMeanwhile();
    m_reader.start([read](const Background::Job &job) { return read(job.stop()); },
                   [this, show](Outcome outcome) {
                       m_importing.clear();
                       showReading();
                       show(std::move(outcome));
                       importNext();
                   });
    showReading();
}

/// Shows what is being read, with a progress bar and Cancel if it takes long.
void MainWindow::showReading() {
    showState();
    if (m_reading.isEmpty() && m_importing.isEmpty()) {
        m_work->end();
        m_progress = std::make_shared<ReadProgress>(); // cancelled jobs may still write to the former one
    } else {
        m_work->begin(m_state->text(), m_progress);
    }
}

/// Cancels files that are still being read.
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
    QByteArray bytes = clipboardText().toUtf8();
    readToImport([bytes](const std::stop_token &) { return bytes; }, tr("clipboard"), bytes.size());
}

void MainWindow::showAssistant(MeasurementFile file) {
    m_assistant = new ImportAssistant(std::move(file), m_open ? m_model.document().get() : nullptr, this);
    m_assistant->setAttribute(Qt::WA_DeleteOnClose);
    m_assistant->setFollowing(m_toImport.size());
    connect(m_assistant, &QDialog::finished, this, [this](int result) {
        const ImportAssistant *assistant = m_assistant;
        m_assistant.clear();
        if (result == QDialog::Accepted)
            adoptImport(*assistant);
        importNext();
    });
    m_assistant->open();
}

void MainWindow::adoptImport(const ImportAssistant &assistant) {
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
    adopt(std::move(document), {}, true)->workplace().showPage(Page::readings);
}

void MainWindow::openFile(const QString &path, std::optional<std::size_t> test) {
    if (path == typeExample().path) {
        m_typeReader.start([path](const Background::Job &) { return readTypeExample(path); },
                           [this](std::vector<TypeTest> tests) { showTypeTests(std::move(tests), this); });
        return;
    }
    if (isMeasurement(path)) {
        importFiles({path});
        return;
    }
    const QString whole = isExample(path) ? path : QFileInfo(path).absoluteFilePath();
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        auto *other = qobject_cast<MainWindow *>(widget);
        if (other && !isExample(whole) && other->isVisible() && other->hasDocument() && // not closed just now
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
    const bool beside = mayTakeLong(path);
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
        else if (auto *report = std::get_if<OpenedReport>(&outcome); report && report->parts.isHistory)
            showVerified(*report, path);
        else if (report)
            window = adoptReport(*report, path);
        else if (std::holds_alternative<Measurement>(outcome))
            importFiles({path});
        else if (auto *document = std::get_if<Document>(&outcome)) // not UTF-8: save under another name
            window = adopt(std::move(*document), isUtf8FileName(path) ? path : QString());
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
    makePagesMeanwhile();
    m_reader.start([open](const Background::Job &job) { return open(job.stop()); },
                   [this, path, finish](Outcome outcome) {
                       m_reading.removeAll(path);
                       showReading();
                       finish(std::move(outcome));
                   });
    showReading();
}

MainWindow *MainWindow::adopt(Document document, const QString &path, bool modified,
                              const QString &reportPath) {
    if (m_open) {
        auto *other = new MainWindow;
        placeBeside(*this, *other);
        other->show();
        return other->adopt(std::move(document), path, modified, reportPath);
    }
    m_open = true;
    m_savedAt.clear();
    m_reportPath = reportPath;
    m_rememberNext = !isExample(path);
    const bool wasWelcome = m_stack->currentWidget() == m_welcome;
    workplace();
    m_stack->setCurrentWidget(m_place); // sized before it is filled
    if (wasWelcome)
        m_workplace->setFocus(); // and not to the next button
    m_model.setDocument(std::move(document), isExample(path) ? QString() : path, modified);
    watchFile();
    showState();
    return this;
}

MainWindow *MainWindow::adoptReport(const OpenedReport &report, const QString &path) {
    MainWindow *window = adopt(*report.evaluated.document, {}, false, path);
    window->m_verified = report.evaluated.document;
    const auto verify = [window, report] {
        try {
            window->m_reportBar->showResult(verifyReport(report));
        } catch (const Error &error) {
            window->m_reportBar->showProblem(error.message);
        }
    };
    QMetaObject::invokeMethod(window, verify, Qt::QueuedConnection); // show the document first
    return window;
}

void MainWindow::showVerified(const OpenedReport &history, const QString &path) {
    try {
        const Verification verification = verifyReport(history, composeHistoryFile);
        auto *box = new QMessageBox(verification.follows() ? QMessageBox::Information : QMessageBox::Warning,
                                    QFileInfo(path).fileName(), conclusion(verification, windowLanguage()),
                                    QMessageBox::Ok, this);
        box->setDetailedText(verificationText(verification, windowLanguage()));
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    } catch (const Error &error) {
        showError(tr("%1 cannot be opened").arg(QFileInfo(path).fileName()), path, error);
    }
}

std::optional<Test> MainWindow::askForTest(Kind kind, bool ofThisFile) {
    const Test *like = currentTest();
    const auto ask = [&](auto &&dialog) -> std::optional<Test> {
        if (like && ofThisFile && isJudged(*like))
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

namespace {

/// A report in the language of the window.
Document newDocument() {
    Document document;
    document.writtenBy = "Palmer " PALMER_VERSION;
    document.report.languages = {windowLanguage().id() == Language::Id::french ? ReportLanguage::fr
                                                                               : ReportLanguage::en};
    return document;
}

} // namespace

void MainWindow::newFile(Kind kind) {
    const auto test = askForTest(kind, false);
    if (!test)
        return;
    Document document = newDocument();
    insertTest(document, 0, *test);
    adopt(std::move(document), {}, true)->workplace().beginTyping();
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

/// A drift test of the axis in view, as its result is used by the tests of that axis.
void MainWindow::addDriftTest() {
    const Test *like = currentTest();
    const Axis *tested = like ? axisOf(*like) : nullptr;
    const Axis axis = tested ? *tested : Axis();
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
    askName(tr("Rename the test"), QString::fromStdString(test->title),
            [this, index = testInView()](const std::string &name) {
                m_model.edit(QT_TRANSLATE_NOOP("edits", "rename the test"), [&](Document &document) {
                    editTest(document, index, [&](Test &renamed) { renamed.title = name; });
                });
            });
}

/// Asks for the name of a test.
void MainWindow::askName(const QString &title, const QString &name,
                         const std::function<void(const std::string &)> &take) {
    auto *dialog = made<QInputDialog>("renameDialog", this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setLabelText(tr("Name of the test"));
    dialog->setTextValue(name);
    connect(dialog, &QInputDialog::textValueSelected, this,
            [take](const QString &typed) { take(typed.trimmed().toStdString()); });
    dialog->open();
}

/// The copy gets a name of its own, as two tests of one name cannot be told apart.
void MainWindow::duplicateTest() {
    const Test *test = currentTest();
    if (!test)
        return;
    askName(tr("Duplicate the test"), tr("%1 (copy)").arg(testName(*test)),
            [this, index = testInView()](const std::string &name) {
                m_model.edit(QT_TRANSLATE_NOOP("edits", "duplicate the test"), [&](Document &document) {
                    const std::size_t copy = palmer::duplicateTest(document, index, true);
                    editTest(document, copy, [&](Test &renamed) { renamed.title = name; });
                });
                workplace().showTest(index + 1);
            });
}

void MainWindow::repeatTest() {
    if (!currentTest())
        return;
    const std::size_t test = testInView();
    m_model.edit(QT_TRANSLATE_NOOP("edits", "repeat the test"),
                 [&](Document &document) { palmer::duplicateTest(document, test, false); });
    workplace().showTest(test + 1);
}

/// One step larger or smaller, 0: the usual size.
void MainWindow::changeTextSize(int steps) {
    setTextSizeStep(steps == 0 ? 0 : textSizeStep() + steps);
}

/// Fills what is open as it was stated for the last test of the machine; asks for the machine if none is
/// named.
void MainWindow::fillLikeLast() {
    if (!currentTest())
        return;
    const std::size_t test = testInView();
    const DocumentPointer document = m_model.document();
    const QString address = RegisterService::instance().address();
    QString machine;
    if (const QStringList all = document->machine == Machine() ? machinesOfRegister(address) : QStringList();
        !all.isEmpty() && document->tests.size() < 2) {
        bool isChosen = false;
        machine = QInputDialog::getItem(this, tr("Like the last test of a machine"), tr("Machine"), all, 0,
                                        false, &isChosen);
        if (!isChosen)
            return;
    }
    std::optional<LikeTest> like;
    try {
        like = awaited(
            [&, path = m_model.path()] { return lastTestOfMachine(document, test, path, address, machine); });
    } catch (const Error &error) {
        ui::showError(this, tr("The last test of the machine cannot be read"), error);
        return;
    }
    if (!like) {
        m_notice->show([] {
            return NoticeBar::Notice{
                tr("Neither the file nor the register has another test of this machine."),
                {{QStringLiteral("noticeRead"), tr("&OK"), [] {}}}};
        });
        return;
    }
    m_model.edit(QT_TRANSLATE_NOOP("edits", "fill like the last test"),
                 [&](Document &changed) { fillLike(changed, test, *like->document, like->test); });
    const Test &from = *like->document->tests[like->test];
    const QString date = from.date ? u' ' + windowLanguage().date(*from.date) : QString();
    const QString file =
        like->file.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(QFileInfo(like->file).fileName());
    m_notice->show([this, from = testName(from), date, file] {
        return NoticeBar::Notice{
            tr("Filled like %1%2%3. What is measured on the day of the test is still open.")
                .arg(from, date, file),
            {{QStringLiteral("undoLike"), tr("&Undo"), [this] { step(false); }},
             {QStringLiteral("noticeRead"), tr("&OK"), [] {}}}};
    });
}

void MainWindow::deleteTest() {
    if (!currentTest())
        return;
    const std::size_t test = testInView();
    m_model.edit(QT_TRANSLATE_NOOP("edits", "delete the test"),
                 [&](Document &document) { removeTest(document, test); });
}

void MainWindow::openRecovery(const Recovery &recovery) {
    // Replace the same file opened as saved.
    if (m_open && !m_model.isModified() && m_model.path() == recovery.origin.path)
        m_open = false;
    MainWindow *window = adopt(*recovery.document, recovery.origin.path, true);
    window->watchFile(knownFile(recovery.origin));
    if (window->m_watch.isChanged())
        window->fileChangedOutside();
    if (window->m_autosave.flush()) // its own copy first, then remove the recovered one
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
    if (isReadOnly()) // warn before anything is typed, not on saving
        m_notice->show([this] {
            return NoticeBar::Notice{
                tr("%1 is read-only: changes can be saved under another name.")
                    .arg(QFileInfo(m_model.path()).fileName()),
                {{QStringLiteral("saveElsewhere"), tr("Save &as…"), [this] { saveAs(); }},
                 {QStringLiteral("closeNotice"), tr("&Close"), {}}}};
        });
    lockFile();
}

bool MainWindow::isReadOnly() const {
    return mayNotBeWritten(m_model.path());
}

void MainWindow::lockFile() {
    const auto holder = m_lock.claim(m_model.path());
    if (!holder)
        return;
    m_notice->show([this, holder = *holder] {
        return NoticeBar::Notice{
            tr("%1 is open already: %2 on %3, process %4. Who saves last overwrites the other.")
                .arg(QFileInfo(m_model.path()).fileName(), holder.program, holder.host)
                .arg(holder.process),
            {{QStringLiteral("saveElsewhere"), tr("Save &as…"), [this] { saveAs(); }},
             {QStringLiteral("closeNotice"), tr("&Close"), {}}}};
    });
}

void MainWindow::keepCopy() {
    commitTyping();
    if (isUnsaved())
        m_autosave.flush();
    m_lock.release(); // destructors will not run; the next save locks again
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
        m_notice->show([this, name] {
            return NoticeBar::Notice{tr("%1 is no longer where it was. Save to write it anew.").arg(name),
                                     {{QStringLiteral("saveAgain"), tr("&Save"), [this] { save(); }},
                                      {QStringLiteral("closeNotice"), tr("&Close"), {}}}};
        });
        return;
    }
    m_notice->show([this, name] {
        return NoticeBar::Notice{
            m_model.isModified()
                ? tr("Another program has changed %1. Loading it gives up the changes made here.").arg(name)
                : tr("Another program has changed %1.").arg(name),
            {{QStringLiteral("reload"), tr("&Load it"), [this] { reload(); }},
             {QStringLiteral("keepMine"), tr("&Keep what is here"), [this] {
                  m_outsideAsked = true;
                  showState();
              }}}};
    });
}

void MainWindow::reload() {
    try {
        Document document = awaited([path = m_model.path()] { return openDocument(path); });
        m_model.setDocument(std::move(document), m_model.path());
        watchFile();
        showState();
    } catch (const Error &error) {
        showError(tr("%1 cannot be opened").arg(QFileInfo(m_model.path()).fileName()), m_model.path(), error);
    }
}

void MainWindow::showError(const QString &title, const QString &fileName, const Error &error) {
    ui::showError(this, title, error, QMessageBox::Critical, title)->setToolTip(fileName);
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
    SaveDialog dialog(this, tr("Save the test file"), {tr("Test files (*.palmer)"), tr("All files (*)")},
                      QSettings().value(QStringLiteral("window/folder")).toString());
    dialog.setObjectName(QStringLiteral("saveDialog"));
    const QFileInfo report(m_reportPath);
    if (!m_reportPath.isEmpty() && m_model.path().isEmpty())
        dialog.selectFile(report.dir().filePath(report.completeBaseName() + QStringLiteral(".palmer")));
    else if (m_model.path().isEmpty())
        dialog.selectFile(proposedName(*m_model.document()));
    else
        dialog.selectFile(m_model.path());
    return dialog.exec() == QDialog::Accepted && saveTo(dialog.selectedFiles().constFirst());
}

bool MainWindow::saveTo(const QString &path) {
    try {
        const QSignalBlocker own(m_watch); // the window is painted meanwhile and would see its file change
        if (keepsBackups() && QFileInfo::exists(path))
            awaited([&] { saveBytes(readBytes(path), path + QStringLiteral(".bak")); });
        m_model.save(path);
    } catch (const Error &error) {
        showError(tr("%1 cannot be saved").arg(QFileInfo(path).fileName()), path, error);
        return false;
    }
    m_savedAt = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
    m_autosavedAt.clear();
    m_notice->hide();
    if (const QStringList refused = workplace().refusedTexts(); !refused.isEmpty())
        m_notice->show([refused] {
            return NoticeBar::Notice{notTaken(refused), {{QStringLiteral("noticeRead"), tr("&OK"), {}}}};
        });
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

/// Asks before closing discards texts that could not be accepted.
bool MainWindow::mayForget(const QStringList &refused) {
    QMessageBox box(QMessageBox::Question, tr("Close"), tr("Close without what could not be taken?"),
                    QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setObjectName(QStringLiteral("closeBox"));
    box.button(QMessageBox::Discard)->setText(tr("Close &anyway"));
    box.setDefaultButton(QMessageBox::Cancel);
    box.setInformativeText(notTaken(refused));
    box.button(QMessageBox::Discard)->setText(tr("Close &anyway")); // nothing could be saved
    box.button(QMessageBox::Discard)->setProperty("named", true);
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
        // A limit without edition was agreed for the test's former edition and must not pass to another.
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
    // Typing that is not yet an undo step, as it was refused, is undone before earlier steps elsewhere.
    if (!forward && workplace().undoTyping())
        return;
    goToStep(m_model.undoStack()->index() + (forward ? 1 : -1));
}

/// Undoes or redoes until so many steps are done.
void MainWindow::goToStep(int index) {
    QUndoStack *stack = m_model.undoStack();
    if (index < 0 || index > stack->count() || index == stack->index())
        return;
    const DocumentPointer before = m_model.document();
    const QString name = stack->text(index > stack->index() ? index - 1 : index);
    stack->setIndex(index);
    workplace().showChange(*before, *m_model.document(), name);
}

/// The last steps, newest first; what is undone can be chosen too.
void MainWindow::fillHistoryMenu() {
    constexpr int most = 30;
    QMenu *list = menu(WindowMenu::history);
    list->clear();
    const QUndoStack *stack = m_model.undoStack();
    const int newest = m_open ? stack->count() : 0;
    for (int index = newest; index >= std::max(0, newest - most); --index) {
        QString name = index == 0 ? tr("As opened") : editName(stack->text(index - 1));
        QAction *action = list->addAction(name.replace(u'&', QStringLiteral("&&")));
        action->setCheckable(true);
        action->setChecked(index == stack->index());
        connect(action, &QAction::triggered, this, [this, index] {
            commitTyping();
            goToStep(index);
        });
    }
}

/// Closes all windows; if several have changes, asks once for all of them.
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
    QMenu *recent = menu(WindowMenu::recent);
    recent->clear();
    int number = 1;
    const std::vector<RecentFile> files = recentFiles();
    for (const RecentFile &file : files) {
        QAction *action = recent->addAction(QStringLiteral("&%1  %2").arg(number++).arg(
            shortName(file, files).replace(u'&', QStringLiteral("&&"))));
        action->setToolTip(file.path);
        connect(action, &QAction::triggered, this, [this, path = file.path] { openFile(path); });
    }
    if (recent->isEmpty()) {
        recent->addAction(tr("No file yet"))->setEnabled(false);
        return;
    }
    recent->addSeparator();
    QAction *clear = recent->addAction(tr("&Clear the list"));
    clear->setObjectName(QStringLiteral("clearRecent"));
    connect(clear, &QAction::triggered, this, [this] {
        forgetFiles();
        m_welcome->refresh();
    });
}

void MainWindow::fillExamplesMenu() {
    QMenu *list = menu(WindowMenu::examples);
    list->clear();
    const auto fill = [this](QMenu *menu, bool teaching) {
        int number = 0;
        for (const Example &example : examples()) {
            if (example.teaching != teaching)
                continue;
            ++number;
            const QString key = number < 10 ? QStringLiteral("&%1  %2") : QStringLiteral("%1  %2");
            menu->addAction(key.arg(number).arg(example.name), this,
                            [this, path = example.path] { openFile(path); });
        }
    };
    fill(list, false);
    const Example ofType = typeExample();
    list->addAction(QStringLiteral("&0  ") + ofType.name, this, [this, ofType] { openFile(ofType.path); });
    fill(list->addMenu(tr("&Diagnosis: one influence each")), true);
}

void MainWindow::showState() {
    showUndo();
    enableActions();
    m_toolBar->setVisible(hasTools());
    m_content->setVisible(m_open);
    m_lack->setVisible(m_open && !m_lack->text().isEmpty());
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

QString MainWindow::editionInView() const {
    return QString::fromUtf8(m_evaluator.latest().tests.at(testInView())->edition->word);
}

void MainWindow::showPageOf(Page page) {
    workplace().showPage(page);
    workplace().focusPage();
}

void MainWindow::exportReadings() {
    askExportOfReadings(this, m_evaluator.current(), testInView(), QFileInfo(m_model.path()).fileName());
}

void MainWindow::exportFigure() {
    askExportOfFigure(this, m_evaluator.current(), testInView());
}

void MainWindow::showReport(const QString &anchor) {
    ReportDialog dialog(m_model, m_evaluator, this);
    dialog.beginAt(anchor);
    if (const QStringList refused = workplace().refusedTexts(); !refused.isEmpty())
        dialog.setNote(notTaken(refused));
    dialog.exec();
}

/// Without an open file, a plan by itself; a test made from it is a new file.
void MainWindow::showPlan() {
    if (!m_open) {
        DocumentModel planned;
        planned.setDocument(newDocument(), {}, true);
        PlanDialog dialog(planned, 0, this);
        bool isMade = false;
        connect(&dialog, &PlanDialog::testMade, this, [&] { isMade = true; });
        dialog.exec();
        if (isMade)
            adopt(*planned.document(), {}, true)->workplace().beginTyping();
        return;
    }
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
    const std::size_t test = testInView();
    auto *dialog = new CompensationDialog(m_evaluator.current(), test, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const auto before = m_model.document()->tests[test]->imports;
    connect(dialog, &CompensationDialog::signConfirmed, this, [this, test, before](bool confirmed) {
        m_model.edit(QT_TRANSLATE_NOOP("edits", "confirm the sign of the deviations"),
                     [&](Document &document) {
                         editTest(document, test, [&](Test &edited) {
                             edited.imports = before;
                             for (ImportedFile &file : edited.imports)
                                 file.signAssumed =
                                     confirmed && file.signAssumed ? std::optional(false) : file.signAssumed;
                         });
                     });
    });
    dialog->open();
}

/// The focus decides where the help opens: at a field, at the edition of a result or at the workflow.
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
    // Prefilled from the current test: its diameter, and its feed, which may be the specified one.
    const auto *measurement =
        m_open ? measured<CircularMeasurement>(*m_model.document(), testInView()) : nullptr;
    if (measurement && measurement->nominalRadius > 0) {
        const double diameter = 2 * measurement->nominalRadius;
        dialog->setNumbers({diameter, measurement->feed.value_or(0), diameter});
    }
    dialog->show();
}

void MainWindow::showShortcuts() {
    workplace(); // its actions have shortcuts too
    auto *dialog = new ShortcutsDialog(*menuBar(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->show();
}

void MainWindow::showSettings() {
    auto *dialog = new SettingsDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
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
    for (const WindowAction tool : tools) {
        const bool isStep = tool == WindowAction::undo || tool == WindowAction::redo;
        if (isStep)
            toolButton(tool).setToolButtonStyle(Qt::ToolButtonIconOnly);
        if (tool != WindowAction::none)
            setStyled(toolButton(tool), "iconOnly", iconsOnly || isStep);
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
    nameActions();
    m_toolBar->setWindowTitle(tr("Tools"));
    m_toolBar->setAccessibleName(tr("Tools"));
    menuBar()->setAccessibleName(tr("Menus"));
    statusBar()->setAccessibleName(tr("State"));
    for (const WindowAction tool : tools) {
        if (tool != WindowAction::none)
            toolButton(tool).setAccessibleName(action(tool)->iconText().remove(u'…'));
    }
    showState();
}

} // namespace palmer::ui
