// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/settings.h"

#include "system/files.h"

#include <QDir>
#include <QFile>
#include <QFileDevice>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QSettings>

namespace palmer::ui {

namespace {

constexpr QLatin1StringView bytesKey("base64");
constexpr QLatin1StringView copiesKey("files/autosave");
constexpr QLatin1StringView backupsKey("files/backup");

QJsonValue asJson(const QVariant &value) {
    if (value.typeId() == QMetaType::QByteArray)
        return QJsonObject{{bytesKey, QString::fromLatin1(value.toByteArray().toBase64())}};
    return QJsonValue::fromVariant(value);
}

QVariant fromJson(const QJsonValue &value) {
    if (value.isObject() && value.toObject().contains(bytesKey))
        return QByteArray::fromBase64(value.toObject().value(bytesKey).toString().toLatin1());
    return value.toVariant();
}

bool read(QIODevice &device, QSettings::SettingsMap &settings) {
    const QJsonObject all = QJsonDocument::fromJson(device.readAll()).object();
    for (auto entry = all.begin(); entry != all.end(); ++entry)
        settings[entry.key()] = fromJson(entry.value());
    return true; // a damaged file gives the defaults instead of an error
}

bool write(QIODevice &device, const QSettings::SettingsMap &settings) {
    QJsonObject all;
    for (auto entry = settings.begin(); entry != settings.end(); ++entry)
        all[entry.key()] = asJson(entry.value());
    const QByteArray bytes = QJsonDocument(all).toJson();
    // QSettings replaces the file if this returns true, and does not check whether all was written.
    auto *file = qobject_cast<QFileDevice *>(&device);
    return device.write(bytes) == bytes.size() && file && file->flush() && file->size() == bytes.size() &&
           isOnDisk(file->handle());
}

/// Removes what QSettings leaves if the program is killed while it replaces the file: under its lock, as
/// another window may be doing so.
void removeLeftovers(const QString &path) {
    const QFileInfo file(path);
    QLockFile lock(path + QStringLiteral(".lock"));
    if (!file.dir().exists() || !lock.tryLock(0))
        return;
    for (const QString &name :
         file.dir().entryList({file.fileName() + QStringLiteral(".??????")}, QDir::Files))
        QFile::remove(file.dir().filePath(name));
}

} // namespace

void useSafeSettings() {
    const QSettings former;
    QSettings::setDefaultFormat(QSettings::registerFormat(QStringLiteral("json"), read, write));
    QSettings settings;
    removeLeftovers(settings.fileName());
    if (QFile::exists(settings.fileName()))
        return;
    for (const QString &key : former.allKeys())
        settings.setValue(key, former.value(key));
}

bool keepsCopies() {
    return QSettings().value(copiesKey, true).toBool();
}

void setKeepsCopies(bool keeps) {
    QSettings().setValue(copiesKey, keeps);
}

bool keepsBackups() {
    return QSettings().value(backupsKey, false).toBool();
}

void setKeepsBackups(bool keeps) {
    QSettings().setValue(backupsKey, keeps);
}

} // namespace palmer::ui
