// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerwindow.h"

#include "register/listing.h"
#include "register/register.h"
#include "ui/dialogs/aboutbox.h"
#include "ui/dialogs/shortcutsdialog.h"
#include "ui/help/helpwindow.h"
#include "ui/languageswitch.h"
#include "ui/register/firstuse.h"
#include "ui/register/foldersdialog.h"
#include "ui/register/machineside.h"
#include "ui/register/registerpage.h"
#include "ui/register/registerqueries.h"
#include "ui/register/registerservice.h"
#include "ui/register/registerstatus.h"
#include "ui/register/troubledfiles.h"
#include "ui/register/typedialog.h"
#include "ui/sizeonscreen.h"
#include "ui/thinsplitter.h"
#include "ui/windowlanguage.h"

#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolBar>

namespace palmer::ui {

namespace {

constexpr int menuHeight = 28;
constexpr int toolHeight = 44;
constexpr int listWidth = 248;
constexpr int wideListWidth = 264;

} // namespace

RegisterWindow::RegisterWindow(RegisterService &service, QWidget *parent)
    : Translated(parent)
    , m_service(service)
    , m_menus(*this)
    , m_history(*this) {
    constexpr QSize usual(1280, 800);
    setObjectName(QStringLiteral("registerWindow"));
    setAcceptDrops(true);
    loadMachines(); // read while the window is made
    makeActions();
    // From the outside in: Qt applies the style sheet again to all that is moved to another parent.
    QScrollArea *place = scrolledPlace(this); // for screens that are too small
    setCentralWidget(place);
    m_parts = new ThinSplitter(Qt::Horizontal);
    place->setWidget(m_parts);
    m_side = new MachineSide;
    m_parts->addWidget(m_side);
    m_stack = new QStackedWidget;
    m_parts->addWidget(m_stack);
    m_parts->setStretchFactor(1, 1);
    m_parts->setSizes({listWidth, usual.width() - listWidth});
    QScrollArea *firstPlace = scrolledPlace(m_stack);
    m_stack->addWidget(firstPlace);
    auto *firstUse = new RegisterFirstUse;
    firstPlace->setWidget(firstUse);
    connect(firstUse, &RegisterFirstUse::folderWanted, this, &RegisterWindow::addFolder);
    m_page = new RegisterPage(m_menus, m_stack);
    m_stack->addWidget(m_page);
    connect(m_side, &MachineSide::machineChosen, this, &RegisterWindow::showMachine);
    connect(m_side, &MachineSide::testsWanted, m_page, &RegisterPage::goToTests);
    m_status = new RegisterStatus(service);
    setStatusBar(m_status);
    connect(m_page, &RegisterPage::intervalChosen, this, &RegisterWindow::setInterval);
    connect(m_page, &RegisterPage::openAsked, this, &RegisterWindow::openAsked);
    connect(m_page, &RegisterPage::chosenChanged, this, &RegisterWindow::showChosen);
    connect(m_status, &RegisterStatus::troubledFilesAsked, this, &RegisterWindow::showTroubledFiles);
    connect(&m_service, &RegisterService::changed, this, &RegisterWindow::loadMachines);
    connect(&m_service, &RegisterService::stateChanged, this, &RegisterWindow::showState);
    connect(&m_service, &RegisterService::pruneRefused, this, &RegisterWindow::askToPrune);
    retranslate();
    resize(sizeOnScreen(*this, usual));
    if (m_stack->currentIndex() == 0)
        firstUse->setFocus();
}

RegisterWindow::~RegisterWindow() = default;

bool RegisterWindow::isQuiet() const {
    return !m_machineLane.isBusy() && !m_testLane.isBusy() && !m_page->isBusy() && !m_history.isBusy() &&
           !m_filesLane.isBusy() && !m_changeLane.isBusy() && !m_service.isScanning();
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
    connect(m_menus.join, &QAction::triggered, this, &RegisterWindow::joinMachine);
    connect(m_menus.separate, &QAction::triggered, this, &RegisterWindow::separateMachine);
    connect(m_menus.history, &QAction::triggered, this, &RegisterWindow::saveHistory);
    connect(m_menus.type, &QAction::triggered, this, &RegisterWindow::showType);
    connect(m_menus.trendAlone, &QAction::toggled, this, [this](bool alone) { m_side->setHidden(alone); });
    auto *restore = new QAction(this);
    restore->setShortcut(Qt::Key_Escape);
    addAction(restore);
    connect(restore, &QAction::triggered, this, &RegisterWindow::goBack);
    connect(m_menus.help, &QAction::triggered, this, &RegisterWindow::showHelp);
    connect(m_menus.shortcuts, &QAction::triggered, this, [this] {
        auto *dialog = new ShortcutsDialog(*menuBar(), this, false);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    });
    connect(m_menus.about, &QAction::triggered, this, [this] { showAbout(this); });
}

/// Ends the trend alone, else the comparison, else the search.
void RegisterWindow::goBack() {
    for (QAction *part : {m_menus.trendAlone, m_menus.compare}) {
        if (part->isChecked()) {
            part->setChecked(false);
            return;
        }
    }
    m_side->endSearch();
}

void RegisterWindow::retranslate() {
    setWindowTitle(tr("Register") + QStringLiteral(" — Palmer"));
    m_menus.retranslate();
    m_side->retranslate();
    m_status->retranslate();
    m_page->retranslate();
    m_page->setMachine(m_side->chosen());
    showState();
}

void RegisterWindow::setFolders(const QStringList &folders) {
    m_service.setFolders(folders);
    showState();
    loadMachines();
}

void RegisterWindow::loadMachines() {
    m_machineLane.cancel();
    m_machineLane.start(
        [address = m_service.address()](const Background::Job &) { return readMachines(address); },
        [this](std::vector<MachineRow> rows) { takeMachines(std::move(rows)); });
}

void RegisterWindow::takeMachines(std::vector<MachineRow> rows) {
    m_side->setMachines(std::move(rows));
    showState();
    loadTests();
}

void RegisterWindow::showMachine() {
    m_page->forgetEdition();
    loadTests();
}

void RegisterWindow::loadTests() {
    m_testLane.cancel();
    const MachineRow *chosen = m_side->chosen();
    if (!chosen) {
        m_page->setMachine(nullptr);
        m_page->setTests({});
        return;
    }
    m_testLane.start([address = m_service.address(), machine = chosen->machine.id](
                         const Background::Job &) { return readTests(address, machine); },
                     [this](std::vector<ListedTest> list) {
                         m_page->setMachine(m_side->chosen());
                         m_page->setTests(std::move(list));
                     });
}

void RegisterWindow::resizeEvent(QResizeEvent *event) {
    constexpr int veryWide = 1600;
    m_page->fit();
    const int usual = event->oldSize().width() >= veryWide ? wideListWidth : listWidth;
    const int wanted = event->size().width() >= veryWide ? wideListWidth : listWidth;
    if (wanted != usual && m_side->width() == usual) // unless the user changed its width
        m_parts->setSizes({wanted, event->size().width() - wanted});
    QMainWindow::resizeEvent(event);
}

void RegisterWindow::showState() {
    const bool hasFolders = !m_service.folders().isEmpty();
    const MachineModel &machines = m_side->machines();
    const bool isEmpty = !hasFolders && machines.machineCount() == 0;
    m_stack->setCurrentIndex(isEmpty ? 0 : 1);
    if (isEmpty)
        m_menus.trendAlone->setChecked(false);
    m_menus.rescan->setEnabled(hasFolders);
    m_menus.intervals->setEnabled(m_side->chosen());
    m_menus.join->setEnabled(m_side->chosen() && machines.machineCount() > 1);
    m_menus.separate->setEnabled(m_side->chosen() && !m_side->chosen()->machine.joined.empty());
    m_side->showState(m_service.isScanning());
    m_status->showState(machines.machineCount(), machines.testCount());
    m_menus.troubled->setEnabled(hasFolders || machines.machineCount() > 0);
    showChosen();
}

void RegisterWindow::showChosen() {
    m_menus.history->setEnabled(m_side->chosen());
    m_menus.type->setEnabled(m_side->chosen() && !m_side->chosen()->machine.model.isEmpty());
    if (m_stack->currentIndex() == 0)
        m_status->showHelpKey();
    else
        m_status->showTests(m_page->shownCount(), m_page->chosenCount());
}

void RegisterWindow::showTroubledFiles() {
    m_filesLane.cancel();
    m_filesLane.start(
        [address = m_service.address()](const Background::Job &) { return readTroubledFiles(address); },
        [this](const std::vector<ListedSource> &files) {
            auto *dialog = new TroubledFiles(files, this);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            connect(dialog, &QDialog::accepted, &m_service,
                    [this] { m_service.rescan(RegisterService::Prune::yes); });
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
    if (const MachineRow *chosen = m_side->chosen())
        choose(chosen->machine, {}, months);
}

void RegisterWindow::choose(const ListedMachine &machine, const std::optional<ListedMachine> &other,
                            std::optional<int> months) {
    change([address = m_service.address(), language = windowLanguage(), machine, other, months] {
        return writeChoice(address, machine, other, months, language);
    });
}

/// Afterwards says in the status bar what there is to say.
void RegisterWindow::change(std::function<QString()> write) {
    m_changeLane.start([write = std::move(write)](const Background::Job &) { return write(); },
                       [this](const QString &said) {
                           constexpr int shown = 15'000; // ms
                           if (!said.isEmpty())
                               m_status->showMessage(said, shown);
                           loadMachines();
                       });
}

/// None of them is chosen beforehand.
void RegisterWindow::askForMachine(const QString &title, const QString &question, const QString &ok,
                                   const QStringList &names, std::function<void(std::size_t)> take) {
    constexpr QSize roomForNames(560, 320);
    auto *dialog = new QInputDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setLabelText(question);
    dialog->setComboBoxItems(names);
    dialog->setOption(QInputDialog::UseListViewForComboBoxItems);
    dialog->setOkButtonText(ok);
    dialog->resize(roomForNames);
    connect(dialog, &QInputDialog::textValueSelected, this,
            [take = std::move(take), names](const QString &name) {
                take(static_cast<std::size_t>(names.indexOf(name)));
            });
    dialog->open();
    const auto *list = dialog->findChild<QListView *>();
    auto *button = dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    list->selectionModel()->clear();
    button->setEnabled(false);
    connect(list->selectionModel(), &QItemSelectionModel::selectionChanged, button,
            [list, button] { button->setEnabled(list->selectionModel()->hasSelection()); });
}

/// Shows what identifies both machines.
void RegisterWindow::joinMachine() {
    const MachineRow *chosen = m_side->chosen();
    if (!chosen)
        return;
    QStringList names;
    std::vector<ListedMachine> others;
    for (const MachineRow &row : m_side->machines().all()) {
        if (row.machine.id == chosen->machine.id)
            continue;
        others.push_back(row.machine);
        names << evidenceOf(row.machine, windowLanguage());
    }
    askForMachine(tr("Join machines"),
                  tr("%1\nis the same machine as:").arg(evidenceOf(chosen->machine, windowLanguage())),
                  tr("&Join"), names, [this, machine = chosen->machine, others](std::size_t i) {
                      choose(machine, others.at(i), {});
                  });
}

void RegisterWindow::separateMachine() {
    const MachineRow *chosen = m_side->chosen();
    if (!chosen)
        return;
    QStringList names;
    for (const MachineFields &joined : chosen->machine.joined)
        names << statedOf(joined).join(QStringLiteral(" · "));
    askForMachine(tr("Separate machines"),
                  tr("%1\nis not the same machine as:").arg(evidenceOf(chosen->machine, windowLanguage())),
                  tr("&Separate"), names, [this, machine = chosen->machine](std::size_t i) {
                      change([address = m_service.address(), language = windowLanguage(), machine,
                              part = machine.joined.at(i)] {
                          return writeSeparation(address, machine, part, language);
                      });
                  });
}

void RegisterWindow::askToPrune(const QStringList &folders) {
    auto *box =
        new QMessageBox(QMessageBox::Warning, tr("Files of the register"),
                        tr("More than half of the tests of these folders are not found. Is a drive not "
                           "connected?") +
                            u'\n' + folders.join(u'\n'),
                        QMessageBox::Cancel, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::PlainText);
    box->addButton(tr("&Remove all the same"), QMessageBox::AcceptRole)
        ->setObjectName(QStringLiteral("removeAllTheSame"));
    box->setDefaultButton(QMessageBox::Cancel);
    connect(box, &QDialog::accepted, &m_service, [this] { m_service.rescan(RegisterService::Prune::force); });
    box->open();
}

void RegisterWindow::showType() {
    const MachineRow *chosen = m_side->chosen();
    if (!chosen)
        return;
    m_filesLane.start([address = m_service.address(), machine = chosen->machine](
                          const Background::Job &) { return readTypeTests(address, machine); },
                      [this](std::vector<TypeTest> tests) { showTypeTests(std::move(tests), this); });
}

void RegisterWindow::saveHistory() {
    if (const MachineRow *chosen = m_side->chosen())
        m_history.save(m_service.address(), chosen->machine);
}

} // namespace palmer::ui
