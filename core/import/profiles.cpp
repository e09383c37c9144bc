#include "import/profiles.h"

#include "document/savedocument.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

namespace palmer {

namespace {

constexpr qint64 sizeLimit = 1 << 20;

[[noreturn]] void refuse() {
    throw Error(
        Error::Kind::format,
        {REPORT_TEXT("report", "this is no file of import profiles; expected names with their choices")});
}

} // namespace

QString importProfilesPath() {
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
           QStringLiteral("/palmer/import-profiles.json");
}

ImportProfiles readImportProfiles(const QString &path) {
    if (!QFileInfo::exists(path))
        return {};
    const QJsonDocument json = QJsonDocument::fromJson(readBytes(path, sizeLimit));
    if (!json.isObject())
        refuse();
    ImportProfiles profiles;
    const QJsonObject all = json.object();
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
        demandKnown(options);
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
    saveBytes(QJsonDocument(all).toJson(), path);
}

} // namespace palmer
