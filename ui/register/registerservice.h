// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/scan.h"
#include "ui/model/background.h"

#include <QDateTime>
#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <stop_token>

namespace palmer::ui {

/// Keeps the register of the user at what his folders hold while the program runs: scans them at the start,
/// when something in them changes, after a pause in any case (a share tells nothing of what others write),
/// and what is saved at once. One for all windows; everything is done beside them.
class RegisterService : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RegisterService)

public:
    /// Made when it is first asked for; scans at once where folders are chosen.
    static RegisterService &instance();
    /// Of a test: with a register and folders of its own.
    RegisterService(QString address, QStringList folders, QObject *parent = nullptr);
    ~RegisterService() override;

    [[nodiscard]] const QString &address() const { return m_address; }
    [[nodiscard]] const QStringList &folders() const { return m_folders; }
    void setFolders(const QStringList &folders);
    /// Keeps the register elsewhere from now on: the path of a file, or a server that was reached. Kept in
    /// the settings without a password.
    void setAddress(const QString &address);

    [[nodiscard]] bool isScanning() const { return m_lane.isBusy(); }
    [[nodiscard]] const ScanResult &result() const { return m_result; } ///< of the last scan of all folders
    [[nodiscard]] const QString &trouble() const { return m_trouble; }  ///< of the register; empty: none
    [[nodiscard]] const QDateTime &scannedAt() const { return m_scannedAt; }
    /// Since the running scan began.
    [[nodiscard]] double secondsOfScan() const;
    /// The last scan was stopped; it goes on when it is asked for.
    [[nodiscard]] bool isStopped() const { return m_isStopped; }

    /// `prune`: takes out files that are not found any more.
    void rescan(bool prune = false);
    /// Ends the running scan; what was read stays. Nothing is read by itself until the next rescan().
    void stop();
    /// Brings one file up to date, wherever it stands below the folders.
    void fileSaved(const QString &path);

signals:
    void changed(); ///< the content of the register
    void stateChanged();
    void progressed(int done, int total);

private:
    void start(const QStringList &places, bool isWhole, bool prune = false);
    void rescanByItself();
    void tellProgress(int done, int total);
    void watch(const QStringList &folders);

    QString m_address;
    QStringList m_folders;
    bool m_keepsFolders = false; ///< and the address
    ScanResult m_result;
    QString m_trouble;
    QDateTime m_scannedAt;
    QElapsedTimer m_begun; ///< the running scan
    QElapsedTimer m_told;  ///< that its content has changed
    std::stop_source m_stopScan;
    bool m_isStopped = false;
    QFileSystemWatcher m_watcher;
    QTimer m_soon;
    QTimer m_later;
    Background m_lane;
};

} // namespace palmer::ui
