// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/profiles.h"

#include "document/savedocument.h"
#include "import/question.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

namespace palmer {

namespace {

constexpr qint64 mostOfProfile = 1 << 20;
constexpr auto profilesKey = QLatin1StringView("profiles");
constexpr auto versionKey = QLatin1StringView("version");
constexpr int version = 1;

[[noreturn]] void refuse() {
    refuseAs(Error::Kind::format,
             REPORT_TEXT("report", "this is no file of import profiles; expected names with their choices"));
}

} // namespace

QString importProfilesPath() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
           QStringLiteral("/palmer/import-profiles.json");
}

ImportProfiles readImportProfiles(const QString &path) {
    if (!QFileInfo::exists(path))
        return {};
    const QJsonDocument json = QJsonDocument::fromJson(readBytes(path, mostOfProfile));
    if (!json.isObject())
        refuse();
    ImportProfiles profiles;
    QJsonObject all = json.object();
    // Files without a version also contain guesses that no user confirmed.
    const bool hasGuesses = !all.value(versionKey).isDouble();
    if (!hasGuesses && !all.value(profilesKey).isObject())
        refuse();
    if (!hasGuesses)
        all = all.value(profilesKey).toObject();
    for (auto profile = all.begin(); profile != all.end(); ++profile) {
        if (!profile.value().isObject())
            refuse();
        ImportOptions &options = profiles[profile.key().toStdString()];
        const QJsonObject words = profile.value().toObject();
        for (auto word = words.begin(); word != words.end(); ++word) {
            if (!word.value().isString())
                refuse();
            options[word.key().toStdString()] = word.value().toString().toStdString();
        }
        requireKnown(options);
        if (hasGuesses)
            std::erase_if(options, [](const auto &option) { return isAsked(option.first); });
    }
    return profiles;
}

void saveImportProfiles(const ImportProfiles &profiles, const QString &path) {
    QJsonObject all;
    for (const auto &[name, options] : profiles) {
        QJsonObject words;
        for (const auto &[key, word] : options)
            words[QString::fromStdString(key)] = QString::fromStdString(word);
        all[QString::fromStdString(name)] = words;
    }
    QDir().mkpath(QFileInfo(path).path());
    saveBytes(QJsonDocument(QJsonObject{{versionKey, version}, {profilesKey, all}}).toJson(), path);
}

} // namespace palmer
