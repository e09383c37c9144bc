// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery.h"

#include "document/bounds.h"
#include "document/json.h"
#include "document/savedocument.h"
#include "document/savefiles.h"
#include "document/writedocument.h"
#include "system/files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace palmer {

namespace {

using nlohmann::json;

constexpr auto recoveryFormat = "palmer recovery";
constexpr auto suffix = "recovery";

json stateAsJson(const FileState &state) {
    return {{"exists", state.exists},
            {"size", state.size},
            {"modified", state.modified.toUTC().toString(Qt::ISODateWithMs).toStdString()},
            {"hash", state.hash.toHex().toStdString()}};
}

std::optional<FileState> stateIn(const json &head) {
    const auto found = head.find("file");
    if (found == head.end() || !found->is_object())
        return std::nullopt;
    const auto text = [&](const char *key) {
        const auto value = found->find(key);
        return value != found->end() && value->is_string() ? QString::fromStdString(value->get<std::string>())
                                                           : QString();
    };
    const auto size = found->find("size");
    const auto exists = found->find("exists");
    FileState state;
    state.exists = exists != found->end() && exists->is_boolean() && exists->get<bool>();
    state.size = size != found->end() && size->is_number_integer() ? size->get<qint64>() : 0;
    state.modified = QDateTime::fromString(text("modified"), Qt::ISODateWithMs);
    state.hash = QByteArray::fromHex(text("hash").toLatin1());
    return state;
}

/// True if a running program holds the lock of the copy.
bool isHeld(const QString &copy) {
    QLockFile lock(recoveryLock(copy));
    lock.setStaleLockTime(0); // locks never expire by age
    return !lock.tryLock(0);
}

/// True for a lock whose program was killed before it wrote its number, which takes no time.
bool isUnfinished(const QString &lock) {
    constexpr qint64 seconds = 10;
    const QFileInfo file(lock);
    return file.size() == 0 && file.lastModified().secsTo(QDateTime::currentDateTime()) > seconds;
}

[[noreturn]] void refuseForeignCopy() {
    throw Error(Error::Kind::format,
                {REPORT_TEXT("report", "this is no copy of a test file that was being edited")});
}

/// Parses the line of JSON at the start of a copy.
RecoveryOrigin originIn(const QByteArray &bytes) {
    const auto end = bytes.indexOf('\n');
    const json head = parseJson(bytes.left(std::max<qsizetype>(end, 0)).toStdString());
    const auto text = [&](const char *key) {
        const auto found = head.find(key);
        if (!head.is_object() || found == head.end() || !found->is_string())
            refuseForeignCopy();
        return QString::fromStdString(found->get<std::string>());
    };
    if (text("format") != QLatin1StringView(recoveryFormat))
        refuseForeignCopy();
    return {text("path"), QDateTime::fromString(text("saved"), Qt::ISODateWithMs), stateIn(head)};
}

/// Returns an unreadable copy, with the origin from its first line if possible.
Recovery refused(const QString &path, const Error &error) {
    Recovery recovery;
    try {
        recovery.origin = originIn(readBytes(path));
    } catch (const Error &) {
        recovery.origin.saved = QFileInfo(path).lastModified().toUTC();
    }
    recovery.refusal = error;
    return recovery;
}

} // namespace

FileState knownFile(const RecoveryOrigin &origin) {
    if (origin.file)
        return *origin.file;
    FileState state = stateOfFile(origin.path, true);
    if (state.exists && state.modified > origin.saved)
        return {true, -1, origin.saved, {}}; // matches no file
    return state;
}

QByteArray writeRecovery(const Document &document, const RecoveryOrigin &origin) {
    json head{{"format", recoveryFormat},
              {"path", origin.path.toStdString()},
              {"saved", origin.saved.toUTC().toString(Qt::ISODateWithMs).toStdString()}};
    if (origin.file)
        head["file"] = stateAsJson(*origin.file);
    return QByteArray::fromStdString(compactJson(head)) + '\n' + writeDocument(document);
}

Recovery readRecovery(const QByteArray &bytes) {
    Recovery recovery;
    recovery.origin = originIn(bytes);
    recovery.document = std::make_shared<const Document>(readUnbounded(bytes.mid(bytes.indexOf('\n') + 1)));
    const Document &document = *recovery.document;
    recovery.title =
        QString::fromStdString(document.report.title.empty() ? document.machine.name : document.report.title);
    return recovery;
}

std::vector<Recovery> abandonedRecoveries(const QString &folder) {
    std::vector<Recovery> found;
    const QDir directory(folder);
    const QString copies = QStringLiteral("*.") + QLatin1StringView(suffix);
    for (const QString &name : directory.entryList({copies}, QDir::Files)) {
        const QString path = directory.filePath(name);
        if (isHeld(path))
            continue;
        Recovery recovery;
        try {
            recovery = readRecovery(readBytes(path));
        } catch (const Error &error) {
            recovery = refused(path, error);
        }
        recovery.file = path;
        found.push_back(std::move(recovery));
    }
    // A program killed before or while it replaced its copy leaves a lock, or a file that was to replace it.
    for (const QString &name : directory.entryList({copies + u'*'}, QDir::Files | QDir::Hidden)) {
        const QString path = directory.absoluteFilePath(name);
        const bool hidden = name.startsWith(u'.');
        const QString copy = directory.absoluteFilePath(name.section(u'.', hidden ? 1 : 0, hidden ? 2 : 1));
        const bool replaces = path == nameWhileSaving(copy);
        const bool locks = path == recoveryLock(copy) && !QFile::exists(copy);
        if ((replaces || locks) && (!isHeld(copy) || isUnfinished(path)))
            QFile::remove(path);
    }
    std::ranges::stable_sort(
        found, [](const Recovery &a, const Recovery &b) { return a.origin.saved > b.origin.saved; });
    return found;
}

void discardRecovery(const QString &file) {
    QFile::remove(file);
    QFile::remove(recoveryLock(file));
}

QString recoveryLock(const QString &file) {
    return file + QStringLiteral(".lock");
}

} // namespace palmer
