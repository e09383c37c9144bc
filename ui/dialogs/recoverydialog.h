// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/recovery.h"
#include "ui/qtforward.h"

#include <QDialog>
#include <vector>

namespace palmer::ui {

/// After a crash: which documents had unsaved changes and what to do with them; which copies cannot be read,
/// and why. Closing it decides nothing; the copies are offered again at the next start.
class RecoveryDialog : public QDialog {
    Q_OBJECT

public:
    explicit RecoveryDialog(std::vector<Recovery> recoveries, QWidget *parent = nullptr);

signals:
    /// Emitted for each copy to open as a window with unsaved changes; the receiver discards the copy.
    void recovered(const palmer::Recovery &recovery);

private:
    void recover();
    void discard();
    [[nodiscard]] std::vector<std::size_t> checked() const;
    void enableButtons();

    std::vector<Recovery> m_recoveries;
    QListWidget *m_list;
    QPushButton *m_recover;
    QPushButton *m_discard;
};

} // namespace palmer::ui
