#include "document/recovery.h"

#include "document/json.h"
#include "document/bounds.h"
#include "document/writedocument.h"

#include <QDir>
#include <QFile>
#include <QLockFile>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace palmer {

namespace {

using nlohmann::json;

constexpr auto format = "palmer recovery";
constexpr auto suffix = "recovery";

} // namespace

QByteArray writeRecovery(const Document &document, const RecoveryOrigin &origin) {
    const json head{{"format", format},
                    {"path", origin.path.toStdString()},
                    {"saved", origin.saved.toUTC().toString(Qt::ISODateWithMs).toStdString()}};
    return QByteArray::fromStdString(compactJson(head)) + '\n' + writeDocument(document);
}

Recovery readRecovery(const QByteArray &bytes) {
    const auto end = bytes.indexOf('\n');
    const json head = parseJson(bytes.left(std::max<qsizetype>(end, 0)).toStdString());
    const auto text = [&](const char *key) {
        const auto found = head.find(key);
        if (!head.is_object() || found == head.end() || !found->is_string())
            throw Error(Error::Kind::format,
                        {REPORT_TEXT("report", "this is no copy of a test file that was being edited")});
        return QString::fromStdString(found->get<std::string>());
    };
    if (text("format") != QLatin1StringView(format))
        throw Error(Error::Kind::format,
                    {REPORT_TEXT("report", "this is no copy of a test file that was being edited")});
    Recovery recovery;
    recovery.origin = {text("path"), QDateTime::fromString(text("saved"), Qt::ISODateWithMs)};
    recovery.document = std::make_shared<const Document>(readUnbounded(bytes.mid(end + 1)));
    const Document &document = *recovery.document;
    recovery.title =
        QString::fromStdString(document.report.title.empty() ? document.machine.name : document.report.title);
    return recovery;
}

std::vector<Recovery> abandonedRecoveries(const QString &folder) {
    std::vector<Recovery> found;
    const QDir directory(folder);
    for (const QString &name :
         directory.entryList({QStringLiteral("*.") + QLatin1StringView(suffix)}, QDir::Files)) {
        const QString path = directory.filePath(name);
        QLockFile lock(recoveryLock(path));
        lock.setStaleLockTime(0); // a living program keeps it however long
        if (!lock.tryLock(0))
            continue;
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            continue;
        try {
            Recovery recovery = readRecovery(file.readAll());
            recovery.file = path;
            found.push_back(std::move(recovery));
        } catch (const Error &) {
            continue; // left for whoever can read it: nothing is thrown away unseen
        }
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
