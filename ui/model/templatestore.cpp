// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/templatestore.h"

#include "document/savedocument.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr qint64 largestTemplate = qint64{16} * 1024 * 1024; ///< bytes: two large pictures

QDir folder() {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/templates")};
}

bool isSame(const Template &a, const Template &b) {
    return a.name == b.name && a.content.index() == b.content.index();
}

} // namespace

std::vector<StoredTemplate> storedTemplates(QStringList *unreadable) {
    std::vector<StoredTemplate> result;
    const QDir dir = folder();
    for (const QFileInfo &info : dir.entryInfoList({QStringLiteral("*.palmer-template")}, QDir::Files)) {
        try {
            result.push_back({info.absoluteFilePath(), openTemplate(info.absoluteFilePath())});
        } catch (const Error &) {
            if (unreadable)
                unreadable->push_back(info.absoluteFilePath());
        }
    }
    std::ranges::sort(result, [](const StoredTemplate &a, const StoredTemplate &b) {
        return QString::localeAwareCompare(QString::fromStdString(a.content.name),
                                           QString::fromStdString(b.content.name)) < 0;
    });
    return result;
}

void storeTemplate(const Template &content) {
    const QDir dir = folder();
    dir.mkpath(QStringLiteral("."));
    QString path =
        dir.filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + QStringLiteral(".palmer-template"));
    for (const StoredTemplate &stored : storedTemplates()) {
        if (isSame(stored.content, content))
            path = stored.path;
    }
    saveBytes(writeTemplate(content), path);
}

Template openTemplate(const QString &path) {
    return readTemplate(readBytes(path, largestTemplate));
}

void removeTemplate(const StoredTemplate &stored) {
    QFile::remove(stored.path);
}

} // namespace palmer::ui
