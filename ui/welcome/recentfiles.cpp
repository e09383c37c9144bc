// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/welcome/recentfiles.h"

#include "document/resultwords.h"
#include "document/testsofverdict.h"
#include "kernel/measurement/testfacts.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr std::size_t mostFiles = 12;
constexpr auto arrayKey = "recentFiles";

// Settings values; never change them, or former entries lose their verdict.
template <class Enumeration>
QString word(std::optional<Enumeration> value) {
    return value ? QString::fromLatin1(fileWord(*value)) : QString();
}

template <class Enumeration>
std::optional<Enumeration> ofWord(const QString &text) {
    return ofFileWord<Enumeration>(text.toStdString());
}

std::vector<RecentFile> stored() {
    QSettings settings;
    std::vector<RecentFile> files;
    const int size = settings.beginReadArray(QLatin1StringView(arrayKey));
    for (int i = 0; i < size; ++i) {
        settings.setArrayIndex(i);
        const auto text = [&](const char *key) { return settings.value(QLatin1StringView(key)).toString(); };
        files.push_back({text("path"), text("machine"), text("axes"),
                         QDate::fromString(text("date"), Qt::ISODate),
                         settings.value(QStringLiteral("circular")).toBool(),
                         ofWord<Verdict>(text("verdict")), ofWord<Accordance>(text("accordance"))});
    }
    settings.endArray();
    return files;
}

} // namespace

RecentFile describeFile(const QString &path, const EvaluatedDocument &evaluated) {
    const Document &document = *evaluated.document;
    RecentFile file;
    file.path = path;
    file.machine = QString::fromStdString(document.machine.name);
    file.verdict = evaluated.verdict();
    file.accordance = worstAccordance(evaluated);
    file.circular = !document.tests.empty();
    QStringList axes;
    for (const TestPointer &test : document.tests) {
        const QString axis = QString::fromStdString(axesOf(*test));
        if (!isCircle(*test))
            file.circular = false;
        if (!axis.isEmpty() && !axes.contains(axis))
            axes += axis;
        if (test->date) {
            const QDate date = QDate::fromString(QString::fromStdString(*test->date), Qt::ISODate);
            if (!file.date.isValid() || date > file.date)
                file.date = date;
        }
    }
    file.axes = axes.join(QStringLiteral(", "));
    return file;
}

std::vector<RecentFile> recentFiles() {
    std::vector<RecentFile> files = stored();
    std::erase_if(files, [](const RecentFile &file) { return !QFileInfo::exists(file.path); });
    return files;
}

QString shortName(const RecentFile &file, const std::vector<RecentFile> &others) {
    const auto end = [](const QString &path, qsizetype parts) { return path.section(u'/', -parts); };
    const qsizetype most = file.path.count(u'/') + 1;
    qsizetype parts = 1;
    while (parts < most && std::ranges::any_of(others, [&](const RecentFile &other) {
               return other.path != file.path && end(other.path, parts) == end(file.path, parts);
           }))
        ++parts;
    return end(file.path, parts);
}

void forgetFiles() {
    QSettings().remove(QLatin1StringView(arrayKey));
}

void rememberFile(const RecentFile &file) {
    std::vector<RecentFile> files = stored();
    std::erase_if(files, [&](const RecentFile &other) { return other.path == file.path; });
    files.insert(files.begin(), file);
    if (files.size() > mostFiles)
        files.resize(mostFiles);
    QSettings settings;
    settings.beginWriteArray(QLatin1StringView(arrayKey), static_cast<int>(files.size()));
    for (std::size_t i = 0; i < files.size(); ++i) {
        settings.setArrayIndex(static_cast<int>(i));
        settings.setValue(QStringLiteral("path"), files[i].path);
        settings.setValue(QStringLiteral("machine"), files[i].machine);
        settings.setValue(QStringLiteral("axes"), files[i].axes);
        settings.setValue(QStringLiteral("date"), files[i].date.toString(Qt::ISODate));
        settings.setValue(QStringLiteral("circular"), files[i].circular);
        settings.setValue(QStringLiteral("verdict"), word(files[i].verdict));
        settings.setValue(QStringLiteral("accordance"), word(files[i].accordance));
    }
    settings.endArray();
}

} // namespace palmer::ui
