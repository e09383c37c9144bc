// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerservice.h"

#include "register/register.h"
#include "register/walk.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QSettings>

namespace palmer::ui {

namespace {

const QString foldersKey = QStringLiteral("register/folders");
const QString serverKey = QStringLiteral("register/server"); ///< address without password
constexpr int soon = 1500;                                   ///< ms: changes come in bursts
constexpr int later = 120'000;                               ///< ms between scans without a sign of change
constexpr int mostWatched = 400;                             ///< folders; others rely on the periodic scan

struct Scanned {
    ScanResult result;
    QString trouble;
    QStringList folders; ///< to watch
};

QStringList watchable(const QStringList &folders, const std::stop_token &stop) {
    QStringList result = folders;
    for (const QString &folder : folders) {
        QDirIterator walk(folder, QDir::Dirs | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
        while (walk.hasNext() && result.size() < mostWatched && !stop.stop_requested())
            result << walk.next();
    }
    return result;
}

} // namespace

RegisterService &RegisterService::instance() {
    // NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): one for all windows
    static RegisterService *const service = [] {
        const QSettings settings;
        const QString server = settings.value(serverKey).toString();
        auto *made = new RegisterService(isServerAddress(server) ? server : Register::standardPath(),
                                         settings.value(foldersKey).toStringList(), qApp);
        made->m_keepsFolders = true;
        return made;
    }();
    return *service;
}

RegisterService::RegisterService(QString address, QStringList folders, QObject *parent)
    : QObject(parent)
    , m_address(std::move(address))
    , m_folders(std::move(folders)) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(soon);
    m_later.setInterval(later);
    connect(&m_soon, &QTimer::timeout, this, &RegisterService::rescanByItself);
    connect(&m_later, &QTimer::timeout, this, &RegisterService::rescanByItself);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] { m_soon.start(); });
    if (!m_folders.isEmpty()) {
        m_later.start();
        m_soon.start(0);
    }
}

RegisterService::~RegisterService() = default;

void RegisterService::setFolders(const QStringList &folders) {
    if (!isServerAddress(m_address)) // others may look at the folder
        m_left << m_folders;
    m_folders.clear();
    for (const QString &folder : folders)
        m_folders << cleanPath(folder);
    m_folders.removeDuplicates();
    m_left.removeIf([this](const QString &folder) { return m_folders.contains(folder); });
    if (m_keepsFolders)
        QSettings().setValue(foldersKey, m_folders);
    m_lane.cancel();
    m_stopScan = {}; // a scan that is just beginning learns of its end only later
    if (m_folders.isEmpty())
        m_later.stop();
    else
        m_later.start();
    rescan();
}

void RegisterService::setAddress(const QString &address) {
    if (m_keepsFolders) {
        if (isServerAddress(address))
            QSettings().setValue(serverKey, withoutPassword(address));
        else
            QSettings().remove(serverKey);
    }
    m_lane.cancel();
    m_stopScan = {};
    m_address = address;
    m_left.clear();
    m_result = {};
    m_trouble.clear();
    m_scannedAt = {};
    emit changed();
    rescan();
}

void RegisterService::rescan(Prune prune) {
    m_isStopped = false;
    if (!m_folders.isEmpty() || !m_left.isEmpty()) {
        if (prune != Prune::no)
            m_stopScan.request_stop(); // the new scan continues from there
        if (m_lane.isBusy() && prune == Prune::no)
            m_soon.start();
        else
            start(m_folders, true, prune);
    }
    emit stateChanged();
}

void RegisterService::rescanByItself() {
    if (!m_isStopped)
        rescan();
}

void RegisterService::stop() {
    m_isStopped = true;
    m_stopScan.request_stop();
    emit stateChanged();
}

double RegisterService::secondsOfScan() const {
    constexpr double perSecond = 1000;
    return m_begun.isValid() ? static_cast<double>(m_begun.elapsed()) / perSecond : 0;
}

/// Shows what has been read so far.
void RegisterService::tellProgress(int done, int total) {
    constexpr int pause = 2000; // ms
    emit progressed(done, total);
    if (m_told.isValid() && m_told.elapsed() < pause)
        return;
    if (m_told.isValid())
        emit changed();
    m_told.start();
}

void RegisterService::fileSaved(const QString &path) {
    if (isBelow(cleanPath(path), m_folders))
        start({path}, false);
}

void RegisterService::start(const QStringList &places, bool isWhole, Prune prune) {
    const QStringList left = isWhole ? m_left : QStringList();
    if (m_stopScan.stop_requested())
        m_stopScan = {}; // scans waiting in the queue are stopped together
    m_begun.start();
    m_told.invalidate();
    m_lane.start(
        [this, address = m_address, places, isWhole, prune, left, asked = m_stopScan,
         language = windowLanguage()](const Background::Job &job) mutable {
            const std::stop_callback ended(job.stop(), [&asked] { asked.request_stop(); });
            Scanned done;
            try {
                Register reg(address);
                ScanOptions options;
                options.stop = asked.get_token();
                options.prune = prune != Prune::no;
                options.force = prune == Prune::force;
                options.left = left;
                options.progress = [&](const ScanProgress &progress) {
                    job.post([this, progress] { tellProgress(progress.done, progress.total); });
                };
                done.result = scan(reg, places, options);
            } catch (const Error &error) {
                done.trouble = language.sentence(error.message);
            }
            if (isWhole)
                done.folders = watchable(places, job.stop());
            return done;
        },
        [this, isWhole, left](Scanned done) {
            m_trouble = done.trouble;
            if (m_trouble.isEmpty() && !done.result.stopped)
                m_left.removeIf([&left](const QString &folder) { return left.contains(folder); });
            const bool wasStopped = done.result.stopped;
            const bool hasChanged = done.result.read > 0 || done.result.notFound != m_result.notFound ||
                                    done.result.unreadable.size() != m_result.unreadable.size() ||
                                    done.result.tests != m_result.tests;
            if (isWhole && done.trouble.isEmpty()) {
                m_result = std::move(done.result);
                m_isStopped = wasStopped && m_isStopped;
                m_scannedAt = wasStopped ? QDateTime() : QDateTime::currentDateTime();
                watch(done.folders);
            }
            const QStringList notPruned = m_result.notPruned;
            if (hasChanged)
                emit changed();
            if (isWhole && !notPruned.isEmpty())
                emit pruneRefused(notPruned);
            emit stateChanged();
        });
    emit stateChanged();
}

void RegisterService::watch(const QStringList &folders) {
    const QStringList before = m_watcher.directories();
    QStringList fresh;
    for (const QString &folder : folders) {
        if (!before.contains(folder))
            fresh << folder;
    }
    if (!fresh.isEmpty())
        m_watcher.addPaths(fresh);
}

} // namespace palmer::ui
