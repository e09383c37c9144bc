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

/// Keeps the user's register up to date with its folders while the program runs: scans them at the start, on
/// changes and periodically (a network share does not report others' changes), and saved files at once.
/// Shared by all windows; all work is done in the background.
class RegisterService : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RegisterService)

public:
    /// Made on first use; starts scanning if folders are chosen.
    static RegisterService &instance();
    /// For tests: with its own register and folders.
    RegisterService(QString address, QStringList folders, QObject *parent = nullptr);
    ~RegisterService() override;

    [[nodiscard]] const QString &address() const { return m_address; }
    [[nodiscard]] const QStringList &folders() const { return m_folders; }
    void setFolders(const QStringList &folders);
    /// Changes where the register is stored: path of a file, or a server that was reached. The password is
    /// not saved.
    void setAddress(const QString &address);

    [[nodiscard]] bool isScanning() const { return m_lane.isBusy(); }
    [[nodiscard]] const ScanResult &result() const { return m_result; } ///< of the last scan of all folders
    [[nodiscard]] const QString &trouble() const { return m_trouble; }  ///< register error; empty if none
    [[nodiscard]] const QDateTime &scannedAt() const { return m_scannedAt; }
    /// Time since the running scan began.
    [[nodiscard]] double secondsOfScan() const;
    /// The last scan was stopped; only rescan() continues it.
    [[nodiscard]] bool isStopped() const { return m_isStopped; }

    /// Whether files that no longer exist are removed; `force`: even most of a folder.
    enum class Prune { no, yes, force };
    void rescan(Prune prune = Prune::no);
    /// Stops the running scan, keeping what was read. Nothing is scanned until the next rescan().
    void stop();
    /// Updates one file anywhere below the folders.
    void fileSaved(const QString &path);

signals:
    void changed(); ///< the content of the register
    void stateChanged();
    void progressed(int done, int total);
    void pruneRefused(const QStringList &folders); ///< which would lose most of their tests

private:
    void start(const QStringList &places, bool isWhole, Prune prune = Prune::no);
    void rescanByItself();
    void tellProgress(int done, int total);
    void watch(const QStringList &folders);

    QString m_address;
    QStringList m_folders;
    QStringList m_left;          ///< folders whose tests have still to leave the register
    bool m_keepsFolders = false; ///< saves the folders and the address
    ScanResult m_result;
    QString m_trouble;
    QDateTime m_scannedAt;
    QElapsedTimer m_begun; ///< start of the running scan
    QElapsedTimer m_told;  ///< last changed() of the running scan
    std::stop_source m_stopScan;
    bool m_isStopped = false;
    QFileSystemWatcher m_watcher;
    QTimer m_soon;
    QTimer m_later;
    Background m_lane;
};

} // namespace palmer::ui
