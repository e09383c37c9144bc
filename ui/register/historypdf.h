// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"
#include "ui/model/background.h"

#include <QCoreApplication>

namespace palmer::ui {

/// Saves the history of a machine as PDF: asks for its number and file, composes it in the background.
class HistoryPdf {
    Q_DECLARE_TR_FUNCTIONS(palmer::ui::HistoryPdf)

public:
    /// `window`: parent of the dialogs.
    explicit HistoryPdf(QWidget &window)
        : m_window(window) {}

    /// `address`: of the register.
    void save(const QString &address, const ListedMachine &machine);
    /// True while a history is being composed.
    [[nodiscard]] bool isBusy() const { return m_lane.isBusy(); }

private:
    QWidget &m_window;
    Background m_lane;
};

} // namespace palmer::ui
