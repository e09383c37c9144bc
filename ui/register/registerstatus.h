// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"

#include <QProgressBar>
#include <QPushButton>
#include <QStatusBar>
#include <array>

namespace palmer::ui {

class RegisterService;

/// The status bar of the register: machines and tests, state of the scan, files with problems, tests shown.
class RegisterStatus : public QStatusBar {
    Q_OBJECT

public:
    explicit RegisterStatus(RegisterService &service);

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
    QLabel *m_total = made<QLabel>("total");
    QLabel *m_state = made<ElidedLabel>("scanState");        ///< database messages may be long
    std::array<QFrame *, 2> m_rules{new QFrame, new QFrame}; ///< around the state
    QProgressBar *m_progress = made<QProgressBar>("scanProgress");
    QPushButton *m_stop = made<QPushButton>("stopScan", TextSize::base, trait::link);
    QPushButton *m_unreadable = made<QPushButton>("unreadable", TextSize::base, trait::link);
    QLabel *m_shown = made<QLabel>("shownAndChosen");
};

} // namespace palmer::ui
