// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/background.h"
#include "ui/qtforward.h"
#include "ui/register/historypdf.h"
#include "ui/register/machinelist.h"
#include "ui/register/registermenus.h"
#include "ui/translated.h"

#include <QMainWindow>
#include <functional>
#include <vector>

namespace palmer::ui {

class HelpWindow;
class RegisterPage;
class MachineSide;
class RegisterService;
class RegisterStatus;

/// The register: machines on the left, then the tests of one of them, the trend of a parameter and
/// superimposed curves. Shows the register, which is read in the background; computes nothing.
class RegisterWindow : public Translated<QMainWindow> {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RegisterWindow)

public:
    explicit RegisterWindow(RegisterService &service, QWidget *parent = nullptr);
    ~RegisterWindow() override;

    void setFolders(const QStringList &folders);
    /// True while no query is running.
    [[nodiscard]] bool isQuiet() const;

signals:
    void openAsked(const QString &path, std::size_t test); ///< test of a file, index from 0

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void makeActions();
    void goBack();
    void retranslate() final;

    void loadMachines();
    void takeMachines(std::vector<MachineRow> rows);
    void showMachine();
    void loadTests();
    void showChosen();
    void showState();
    void chooseFolders();
    void addFolder();
    void choose(const ListedMachine &machine, const std::optional<ListedMachine> &other,
                std::optional<int> months);
    void change(std::function<QString()> write);
    void askForMachine(const QString &title, const QString &question, const QString &ok,
                       const QStringList &names, std::function<void(std::size_t)> take);
    void setInterval(int months);
    void joinMachine();
    void separateMachine();
    void askToPrune(const QStringList &folders);
    void saveHistory();
    void showType();
    void showTroubledFiles();
    void showHelp();

    RegisterService &m_service;
    QStackedWidget *m_stack = nullptr; ///< first use, or the register's content
    RegisterPage *m_page = nullptr;
    MachineSide *m_side = nullptr;
    QSplitter *m_parts = nullptr;
    RegisterStatus *m_status = nullptr;
    RegisterMenus m_menus;
    HistoryPdf m_history;
    HelpWindow *m_help = nullptr;

    Background m_machineLane;
    Background m_testLane;
    Background m_filesLane;
    Background m_changeLane;
};

} // namespace palmer::ui
