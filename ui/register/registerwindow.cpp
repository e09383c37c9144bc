// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerwindow.h"

#include "kernel/measurement/testfacts.h"
#include "register/reevaluate.h"
#include "register/register.h"
#include "ui/dialogs/aboutbox.h"
#include "ui/dialogs/shortcutsdialog.h"
#include "ui/help/helpwindow.h"
#include "ui/languageswitch.h"
#include "ui/measures.h"
#include "ui/register/curvechart.h"
#include "ui/register/filterbar.h"
#include "ui/register/firstuse.h"
#include "ui/register/foldersdialog.h"
#include "ui/register/machinehead.h"
#include "ui/register/machineside.h"
#include "ui/register/madewidgets.h"
#include "ui/register/registerqueries.h"
#include "ui/register/registerservice.h"
#include "ui/register/registerstatus.h"
#include "ui/register/testsview.h"
#include "ui/register/trendview.h"
#include "ui/register/troubledfiles.h"
#include "ui/sizeonscreen.h"
#include "ui/thinsplitter.h"
#include "ui/windowlanguage.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int menuHeight = 28;
constexpr int toolHeight = 44;
constexpr int listWidth = 248;
constexpr int wideListWidth = 264;

/// True if nothing shown has changed.
bool sameTests(const std::vector<ListedTest> &a, const std::vector<ListedTest> &b) {
    const auto samePlace = [](const TestPlace &one, const TestPlace &other) {
        return one.path == other.path && one.test == other.test && one.state == other.state;
    };
    return std::ranges::equal(a, b, [&](const ListedTest &one, const ListedTest &other) {
        return one.id == other.id && one.machine == other.machine && one.test.digest == other.test.digest &&
               std::ranges::equal(one.places, other.places, samePlace);
    });
}

} // namespace

RegisterWindow::RegisterWindow(RegisterService &service, QWidget *parent)
    : QMainWindow(parent)
    , m_service(service)
    , m_menus(*this)
    , m_history(*this) {
    constexpr QSize usual(1280, 800);
    setObjectName(QStringLiteral("registerWindow"));
    setAcceptDrops(true);
    makeActions();
    auto *firstUse = new RegisterFirstUse;
    connect(firstUse, &RegisterFirstUse::folderWanted, this, &RegisterWindow::addFolder);
    m_stack = new QStackedWidget;
    QScrollArea *firstPlace = scrolledPlace(m_stack);
    firstPlace->setWidget(firstUse);
    m_stack->addWidget(firstPlace);
    m_stack->addWidget(makeRight());
    m_side = new MachineSide;
    connect(m_side, &MachineSide::machineChosen, this, &RegisterWindow::showMachine);
    m_parts = new ThinSplitter(Qt::Horizontal);
    m_parts->addWidget(m_side);
    m_parts->addWidget(m_stack);
    m_parts->setStretchFactor(1, 1);
    m_parts->setSizes({listWidth, usual.width() - listWidth});
    QScrollArea *place = scrolledPlace(this); // for screens that are too small
    place->setWidget(m_parts);
    setCentralWidget(place);
    m_status = new RegisterStatus(service);
    setStatusBar(m_status);
    connect(m_status, &RegisterStatus::troubledFilesAsked, this, &RegisterWindow::showTroubledFiles);
    connect(&m_service, &RegisterService::changed, this, &RegisterWindow::loadMachines);
    connect(&m_service, &RegisterService::stateChanged, this, &RegisterWindow::showState);
    retranslate();
    resize(sizeOnScreen(*this, usual));
    loadMachines();
}

RegisterWindow::~RegisterWindow() = default;

bool RegisterWindow::isQuiet() const {
    return !m_machineLane.isBusy() && !m_testLane.isBusy() && !m_history.isBusy() && !m_filesLane.isBusy() &&
           !m_service.isScanning();
}

void RegisterWindow::makeActions() {
    menuBar()->setFixedHeight(menuHeight);
    auto *bar = addToolBar(QString());
    bar->setObjectName(QStringLiteral("registerTools"));
    bar->setMovable(false);
    bar->setFixedHeight(toolHeight);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setIconSize({16, 16});
    m_menus.fill(*bar);
    auto *space = new QWidget;
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(space);
    bar->addWidget(new LanguageSwitch(LanguageSwitch::Names::codes));
    connect(m_menus.folders, &QAction::triggered, this, &RegisterWindow::chooseFolders);
    connect(m_menus.rescan, &QAction::triggered, &m_service, [this] { m_service.rescan(); });
    connect(m_menus.troubled, &QAction::triggered, this, &RegisterWindow::showTroubledFiles);
    connect(m_menus.close, &QAction::triggered, this, &QWidget::close);
    connect(m_menus.find, &QAction::triggered, this, [this] { m_side->startSearch(); });
    connect(m_menus.previous, &QAction::triggered, this, [this] { m_side->moveBy(-1); });
    connect(m_menus.next, &QAction::triggered, this, [this] { m_side->moveBy(1); });
    connect(m_menus.history, &QAction::triggered, this, &RegisterWindow::saveHistory);
    connect(m_menus.intervals, &QMenu::aboutToShow, this,
            [this] { m_head->fillIntervals(*m_menus.intervals); });
    connect(m_menus.open, &QAction::triggered, this, &RegisterWindow::openChosen);
    connect(m_menus.compare, &QAction::toggled, this, &RegisterWindow::compareCurves);
    connect(m_menus.under, &QMenu::aboutToShow, this, &RegisterWindow::fillEditions);
    connect(m_menus.clear, &QAction::triggered, this, [this] { m_filters->clear(); });
    connect(m_menus.help, &QAction::triggered, this, &RegisterWindow::showHelp);
    connect(m_menus.shortcuts, &QAction::triggered, this, [this] {
        auto *dialog = new ShortcutsDialog(*menuBar(), this, false);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    });
    connect(m_menus.about, &QAction::triggered, this, [this] { showAbout(this); });
}

QWidget *RegisterWindow::makeRight() {
    auto *side = new QWidget;
    side->setAutoFillBackground(true);
    side->setBackgroundRole(QPalette::Base);
    m_head = new MachineHead;
    connect(m_head, &MachineHead::intervalChosen, this, &RegisterWindow::setInterval);
    auto *splitter = new ThinSplitter(Qt::Vertical);
    m_stacked = splitter;
    m_testsPart = makeTests();
    splitter->addWidget(m_testsPart);
    splitter->addWidget(makeTrend());
    splitter->setSizes({280, 360});
    auto *layout = tight<QVBoxLayout>(side);
    layout->addWidget(m_head);
    layout->addWidget(splitter, 1);
    return side;
}

QWidget *RegisterWindow::makeTests() {
    auto *part = new QWidget;
    m_filters = new FilterBar;
    connect(m_filters, &FilterBar::chosen, this, [this](bool axis) {
        if (axis)
            forgetEdition();
        showTests();
    });
    m_tests = new TestsView;
    connect(m_tests, &TestsView::openAsked, this, &RegisterWindow::openChosen);
    connect(m_tests, &TestsView::chosenChanged, this, &RegisterWindow::showChosen);
    auto *layout = tight<QVBoxLayout>(part);
    layout->addWidget(m_filters);
    auto *framed = new QHBoxLayout;
    framed->setContentsMargins(pageMargin, 0, pageMargin, 8);
    framed->addWidget(m_tests);
    layout->addLayout(framed, 1);
    return part;
}

/// The trend with its facts, or next to it the curves that are compared.
QWidget *RegisterWindow::makeTrend() {
    m_trend = new TrendView(m_menus);
    m_comparison = new CurveComparison;
    m_comparison->hide();
    connect(m_comparison, &CurveComparison::closed, this, [this] { m_menus.compare->setChecked(false); });
    connect(m_trend, &TrendView::testChosen, m_tests, &TestsView::choose);
    connect(m_menus.trendAlone, &QAction::toggled, this, [this](bool alone) {
        m_side->setVisible(!alone);
        m_testsPart->setVisible(!alone);
    });
    auto *restore = new QAction(this);
    restore->setShortcut(Qt::Key_Escape);
    addAction(restore);
    connect(restore, &QAction::triggered, this, [this] { m_menus.trendAlone->setChecked(false); });
    auto *part = new QWidget;
    auto *layout = tight<QHBoxLayout>(part);
    layout->addWidget(m_trend, 3);
    layout->addWidget(m_comparison, 3);
    return part;
}

void RegisterWindow::changeEvent(QEvent *event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void RegisterWindow::retranslate() {
    setWindowTitle(tr("Register") + QStringLiteral(" — Palmer"));
    m_menus.retranslate();
    m_side->retranslate();
    m_status->retranslate();
    m_trend->retranslate();
    m_head->retranslate();
    m_tests->retranslate();
    m_head->setMachine(m_side->chosen());
    showTests();
    showState();
}

void RegisterWindow::setFolders(const QStringList &folders) {
    m_service.setFolders(folders);
    showState();
    loadMachines();
}

void RegisterWindow::loadMachines() {
    m_machineLane.cancel();
    const QString &address = m_service.address();
    if (!isServerAddress(address) && !QFileInfo::exists(address)) {
        takeMachines({});
        return;
    }
    m_machineLane.start(
        [address, kept = keptIntervals()](const Background::Job &) { return readMachines(address, kept); },
        [this](std::vector<MachineRow> rows) { takeMachines(std::move(rows)); });
}

void RegisterWindow::takeMachines(std::vector<MachineRow> rows) {
    m_side->setMachines(std::move(rows));
    showState();
    loadTests();
}

/// Each test is shown under its own edition again.
void RegisterWindow::forgetEdition() {
    m_edition.clear();
    m_anew.clear();
}

void RegisterWindow::showMachine() {
    forgetEdition();
    loadTests();
}

void RegisterWindow::loadTests() {
    m_testLane.cancel();
    const MachineRow *chosen = m_side->chosen();
    if (!chosen) {
        takeTests({});
        return;
    }
    m_testLane.start([address = m_service.address(), machine = chosen->machine.id](
                         const Background::Job &) { return readTests(address, machine); },
                     [this](std::vector<ListedTest> list) { takeTests(std::move(list)); });
}

void RegisterWindow::takeTests(std::vector<ListedTest> tests) {
    if (sameTests(tests, m_allTests)) { // keep the selection
        m_head->setMachine(m_side->chosen());
        return;
    }
    m_allTests = std::move(tests);
    m_filters->setTests(m_allTests);
    m_head->setMachine(m_side->chosen());
    showTests();
}

void RegisterWindow::fillEditions() {
    m_menus.under->clear();
    m_menus.under->addAction(tr("Each test under its own edition"), this, [this] { evaluateUnder({}); });
    for (const Edition *edition : editions()) {
        const bool fits = std::ranges::any_of(m_allTests, [&](const ListedTest &test) {
            return test.test.kind == edition->kind && QString::fromStdString(test.test.axis) == trendAxis();
        });
        if (fits)
            m_menus.under->addAction(QString::fromUtf8(edition->word), this,
                                     [this, word = std::string(edition->word)] { evaluateUnder(word); });
    }
}

void RegisterWindow::showTests() {
    std::vector<ListedTest> shown;
    for (const ListedTest &test : m_allTests) {
        if (m_filters->filters().passes(test))
            shown.push_back(test);
    }
    m_filters->showChosen(shown.size());
    m_menus.clear->setEnabled(m_filters->anyChosen());
    m_tests->setTests(std::move(shown));
    showTrend();
    showChosen();
}

void RegisterWindow::resizeEvent(QResizeEvent *event) {
    constexpr int veryWide = 1600;
    fitTrend();
    const int usual = event->oldSize().width() >= veryWide ? wideListWidth : listWidth;
    const int wanted = event->size().width() >= veryWide ? wideListWidth : listWidth;
    if (wanted != usual && m_side->width() == usual) // unless the user changed its width
        m_parts->setSizes({wanted, event->size().width() - wanted});
    QMainWindow::resizeEvent(event);
}

/// A narrow window shows curves instead of the trend, and editions only in the menu.
void RegisterWindow::fitTrend() {
    constexpr int wide = 1180;
    const bool isWide = width() >= wide;
    m_trend->showEditions(isWide);
    m_trend->setVisible(isWide || !m_menus.compare->isChecked());
}

QString RegisterWindow::trendAxis() const {
    const QString &chosen = m_filters->filters().chosen[TestFilters::axis];
    if (!chosen.isEmpty())
        return chosen;
    return m_allTests.empty() ? QString() : QString::fromStdString(m_allTests.back().test.axis);
}

void RegisterWindow::showTrend() {
    const QString axis = trendAxis();
    std::vector<ListedTest> list;
    for (const ListedTest &test : m_edition.empty() ? m_allTests : m_anew) {
        if (QString::fromStdString(test.test.axis) == axis &&
            m_filters->filters().passes(TestFilters::since, test))
            list.push_back(test);
    }
    const bool isAxis = !list.empty() && traitsOf(list.front().test.kind).isOfAxis; // else a plane, "XY"
    QString about = isAxis ? tr("%1 axis").arg(axis) : axis;
    if (!m_edition.empty())
        about += QStringLiteral(" · ") + QString::fromStdString(m_edition);
    m_trend->setTests(std::move(list), about);
}

void RegisterWindow::showChosen() {
    const auto chosen = m_tests->chosen();
    std::map<QString, int> digests;
    std::map<int, int> numbers;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        digests.emplace(chosen[i]->test.digest, static_cast<int>(i) + 1);
        if (chosen.size() > 1)
            numbers.emplace(chosen[i]->id, static_cast<int>(i) + 1);
    }
    m_tests->setNumbers(std::move(numbers));
    m_trend->setChosen(digests);
    m_menus.open->setEnabled(chosen.size() == 1);
    const bool comparable =
        chosen.size() > 1 && std::ranges::all_of(chosen, [&](const ListedTest *test) {
            return test->test.axis == chosen.front()->test.axis && !test->test.curve.empty();
        });
    m_menus.compare->setEnabled(comparable || m_menus.compare->isChecked());
    if (m_menus.compare->isChecked() && comparable) {
        std::vector<ListedTest> list;
        list.reserve(static_cast<std::size_t>(chosen.size()));
        for (const ListedTest *test : chosen)
            list.push_back(*test);
        m_comparison->setTests(std::move(list));
    }
    m_menus.history->setEnabled(m_side->chosen());
    if (m_stack->currentIndex() == 0)
        m_status->showHelpKey();
    else
        m_status->showTests(m_tests->count(), static_cast<int>(chosen.size()));
}

void RegisterWindow::compareCurves(bool compare) {
    m_trend->showFacts(!compare);
    m_comparison->setVisible(compare);
    fitTrend();
    showChosen();
    giveRoomToCurves(compare);
}

/// Two charts and a list need more height than the trend, whose height is restored later.
void RegisterWindow::giveRoomToCurves(bool compare) {
    constexpr int leastTests = 150; // filters, header and some rows
    if (!compare) {
        if (!m_heights.isEmpty())
            m_stacked->setSizes(m_heights);
        m_heights.clear();
        return;
    }
    const QList<int> heights = m_stacked->sizes();
    const int all = heights[0] + heights[1];
    const int wanted = std::min(m_comparison->wantedHeight(), all - leastTests);
    if (wanted <= heights[1])
        return;
    m_heights = heights;
    m_stacked->setSizes({all - wanted, wanted});
}

void RegisterWindow::openChosen() {
    const auto chosen = m_tests->chosen();
    if (chosen.size() != 1)
        return;
    const TestPlace &place = chosen.front()->places.front();
    emit openAsked(place.path, static_cast<std::size_t>(std::max(place.test - 1, 0)));
}

void RegisterWindow::evaluateUnder(const std::string &edition) {
    m_edition = edition;
    m_anew.clear();
    if (edition.empty()) {
        showTrend();
        return;
    }
    std::vector<ListedTest> list;
    for (const ListedTest &test : m_allTests) {
        if (QString::fromStdString(test.test.axis) == trendAxis())
            list.push_back(test);
    }
    m_testLane.start(
        [list = std::move(list), edition](const Background::Job &) mutable {
            (void)reevaluate(list, *findEdition(edition));
            return list;
        },
        [this](std::vector<ListedTest> anew) {
            m_anew = std::move(anew);
            showTrend();
        });
}

void RegisterWindow::showState() {
    const bool hasFolders = !m_service.folders().isEmpty();
    const MachineModel &machines = m_side->machines();
    const bool isEmpty = !hasFolders && machines.machineCount() == 0;
    m_stack->setCurrentIndex(isEmpty ? 0 : 1);
    if (isEmpty)
        m_menus.trendAlone->setChecked(false);
    m_menus.rescan->setEnabled(hasFolders);
    m_menus.history->setEnabled(m_side->chosen());
    m_menus.intervals->setEnabled(m_side->chosen());
    m_menus.under->setEnabled(!m_allTests.empty());
    m_side->showState(m_service.isScanning());
    m_status->showState(machines.identifiedCount(), machines.testCount());
    m_menus.troubled->setEnabled(hasFolders || machines.machineCount() > 0);
    showChosen();
}

void RegisterWindow::showTroubledFiles() {
    m_filesLane.cancel();
    m_filesLane.start(
        [address = m_service.address()](const Background::Job &) { return readTroubledFiles(address); },
        [this](const std::vector<ListedSource> &files) {
            auto *dialog = new TroubledFiles(files, this);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            connect(dialog, &QDialog::accepted, &m_service, [this] { m_service.rescan(true); });
            dialog->open();
        });
}

void RegisterWindow::showHelp() {
    if (!m_help)
        m_help = new HelpWindow(this);
    m_help->showPage(QStringLiteral("register"));
    m_help->show();
    m_help->raise();
    m_help->activateWindow();
}

void RegisterWindow::chooseFolders() {
    FoldersDialog dialog(m_service.folders(), this);
    if (dialog.exec() == QDialog::Accepted)
        setFolders(dialog.folders());
}

void RegisterWindow::addFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Choose a folder"));
    if (!folder.isEmpty())
        setFolders(m_service.folders() + QStringList{folder});
}

void RegisterWindow::dragEnterEvent(QDragEnterEvent *event) {
    for (const QUrl &url : event->mimeData()->urls()) {
        if (QFileInfo(url.toLocalFile()).isDir())
            event->acceptProposedAction();
    }
}

void RegisterWindow::dropEvent(QDropEvent *event) {
    QStringList folders = m_service.folders();
    for (const QUrl &url : event->mimeData()->urls()) {
        if (QFileInfo(url.toLocalFile()).isDir())
            folders << url.toLocalFile();
    }
    setFolders(folders);
}

/// 0: none.
void RegisterWindow::setInterval(int months) {
    const MachineRow *chosen = m_side->chosen();
    if (!chosen)
        return;
    keepInterval(chosen->machine.identity, months);
    m_machineLane.start([address = m_service.address(), machine = chosen->machine.id,
                         months](const Background::Job &) { writeInterval(address, machine, months); },
                        [this] { loadMachines(); });
}

void RegisterWindow::saveHistory() {
    if (const MachineRow *chosen = m_side->chosen())
        m_history.save(m_service.address(), chosen->machine);
}

} // namespace palmer::ui
