// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStatusBar>
#include <array>

class QFrame;
class QLabel;
class QProgressBar;
class QPushButton;

namespace palmer::ui {

class RegisterService;

/// The status bar of the register: machines and tests, state of the scan, files with problems, tests shown.
class RegisterStatus : public QStatusBar {
    Q_OBJECT

public:
    explicit RegisterStatus(RegisterService &service, QWidget *parent = nullptr);

    /// State and result of the service's scan, with the totals of the register.
    void showState(int machines, int tests);
    void showTests(int shown, int chosen);
    void showHelpKey(); ///< in place of the tests
    void retranslate();

signals:
    void troubledFilesAsked();

protected:
    void changeEvent(QEvent *event) override;

private:
    void showScan();
    void showProgress(int done, int total);
    void showTroubled();

    RegisterService &m_service;
    QLabel *m_total;
    QLabel *m_state;
    std::array<QFrame *, 2> m_rules{}; ///< between total, state and files with problems
    QProgressBar *m_progress;
    QPushButton *m_stop;
    QPushButton *m_unreadable;
    QLabel *m_shown;
};

} // namespace palmer::ui
