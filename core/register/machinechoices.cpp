// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/machinechoices.h"

#include "document/savedocument.h"
#include "register/jsonline.h"
#include "register/register.h"
#include "register/storedsentence.h"
#include "register/walk.h"
#include "register/writer.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace palmer {

namespace {

const QString rowName = QStringLiteral("machines in ");

constexpr std::array machineKeys{
    std::pair("name", &MachineFields::name), std::pair("manufacturer", &MachineFields::manufacturer),
    std::pair("model", &MachineFields::model), std::pair("serialNumber", &MachineFields::serialNumber)};

Json withFields(const MachineFields &machine) {
    Json result = Json::object();
    for (const auto &[key, field] : machineKeys)
        result[key] = (machine.*field).toStdString();
    return result;
}

QString identityOf(const Json &machine) {
    MachineFields fields;
    for (const auto &[key, field] : machineKeys)
        fields.*field = QString::fromStdString(machine.value(key, std::string()));
    return machineIdentity(fields);
}

[[noreturn]] void refuseFile() {
    throw Error(Error::Kind::format,
                {REPORT_TEXT("report", "this is no list of machines of a register, or a newer one"), {}});
}

int intervalFrom(const Json &months) {
    const auto number = months.get<double>();
    if (number != std::floor(number))
        refuseFile();
    return static_cast<int>(std::clamp(number, 0.0, static_cast<double>(longestInterval)));
}

QString ownFolder() {
    return QFileInfo(Register::standardPath()).absolutePath();
}

QString machineFileIn(const QString &folder) {
    return folder + u'/' + machineFileName;
}

/// Empty without a file. Throws Error, also where MachineChoices does.
QByteArray machineFile(const QString &folder) {
    const QString file = machineFileIn(folder);
    QByteArray bytes = QFileInfo::exists(file) ? readBytes(file) : QByteArray();
    MachineChoices().add(bytes);
    return bytes;
}

QString sentenceOf(const QString &folder, const Error &error, const Language &language) {
    return machineFileIn(folder) + QStringLiteral(": ") + sentenceFrom(storedSentence(error), language);
}

/// Returns the scanned folders with files of a machine.
QStringList foldersOf(Database &database, const ListedMachine &machine) {
    const MachineFiles files = keptMachineFiles(database);
    QStringList folders;
    QSqlQuery &query =
        database.run(QStringLiteral("select distinct source.path from source, place, test where source.id = "
                                    "place.source and place.test = test.id and test.machine = ?"),
                     {machine.id});
    while (query.next()) {
        for (const auto &[folder, text] : files) {
            if (isBelow(query.value(0).toString(), {folder}) && QFileInfo(folder).isDir())
                folders << folder;
        }
    }
    return folders;
}

} // namespace

void MachineChoices::add(const QByteArray &json) {
    if (json.isEmpty())
        return;
    const Json file = parseJson(json.toStdString());
    try {
        if (file.at("format") != "palmer machines" || file.at("version") != 1)
            refuseFile();
        for (const Json &one : file.at("machines")) {
            const QString identity = identityOf(one);
            if (one.contains("interval"))
                months[identity] = intervalFrom(one.at("interval"));
            for (const Json &other : one.value("joined", Json::array()))
                joined[identityOf(other)] = identity;
        }
    } catch (const Json::exception &) { // a key is missing or of another type
        refuseFile();
    }
}

QString MachineChoices::machineOf(const QString &identity) const {
    QString result = identity;
    std::set<QString> seen;
    for (auto next = joined.find(result); next != joined.end(); next = joined.find(result)) {
        if (!seen.insert(result).second) { // files join each to the other: the first of them
            QString first = result;
            for (QString one = joined.at(result); one != result; one = joined.at(one))
                first = std::min(first, one);
            return first;
        }
        result = next->second;
    }
    return result;
}

std::optional<int> MachineChoices::interval(const QString &identity) const {
    int result = 0;
    for (const auto &[machine, said] : months) {
        if (machine == identity || (result == 0 && machineOf(machine) == identity))
            result = said;
    }
    return result == 0 ? std::nullopt : std::optional(result);
}

QByteArray withChoice(const QByteArray &json, const MachineFields &machine, const MachineFields *other,
                      std::optional<int> months) {
    Json file = json.isEmpty()
                    ? Json{{"format", "palmer machines"}, {"version", 1}, {"machines", Json::array()}}
                    : Json(parseJson(json.toStdString()));
    Json &all = file["machines"];
    auto entry = std::ranges::find(all, machineIdentity(machine), identityOf);
    if (entry == all.end())
        entry = all.insert(all.end(), withFields(machine));
    if (months)
        (*entry)["interval"] = *months;
    if (other)
        (*entry)["joined"].push_back(withFields(*other));
    return QByteArray::fromStdString(printJson(file));
}

QByteArray withoutJoin(const QByteArray &json, const QString &machine, const QString &part) {
    if (json.isEmpty())
        return json;
    Json file(parseJson(json.toStdString()));
    bool isNew = false;
    for (Json &entry : file["machines"]) {
        const bool isOfPart = identityOf(entry) == part;
        Json rest = Json::array();
        for (const Json &other : entry.value("joined", Json::array())) {
            const QString identity = identityOf(other);
            if (identity == part || (isOfPart && identity == machine)) // files may join each to the other
                isNew = true;
            else
                rest.push_back(other);
        }
        if (rest.empty())
            entry.erase("joined");
        else
            entry["joined"] = rest;
    }
    return isNew ? QByteArray::fromStdString(printJson(file)) : json;
}

MachineFiles keptMachineFiles(Database &database) {
    MachineFiles result;
    QSqlQuery &query =
        database.run(QStringLiteral("select name, value from register where name like 'machines in %'"));
    while (query.next())
        result.emplace(query.value(0).toString().mid(rowName.size()), query.value(1).toString());
    return result;
}

void forgetMachineFile(Database &database, const QString &folder) {
    database.run(QStringLiteral("delete from register where name = ?"), {rowName + folder});
}

void keepMachineFile(Database &database, const QString &folder, const QString &text) {
    forgetMachineFile(database, folder);
    database.insert(QStringLiteral("register (name, value)"), {rowName + folder, text});
}

MachineChoices keptChoices(Database &database) {
    MachineChoices result;
    const MachineFiles files = keptMachineFiles(database);
    for (const auto &[folder, text] : files)
        result.add(text.toUtf8());
    if (const auto own = files.find(ownFolder()); own != files.end())
        result.add(own->second.toUtf8()); // once more, for they win
    return result;
}

MachineFiles changedMachineFiles(Database &database, const QStringList &folders,
                                 std::vector<Unreadable> &unreadable) {
    const MachineFiles kept = keptMachineFiles(database);
    MachineFiles all = kept;
    for (const QString &folder : folders + QStringList{ownFolder()})
        all.emplace(folder, QString());
    MachineFiles changed;
    for (const auto &[folder, before] : all) {
        if (folder.isEmpty() || QDir(folder).isEmpty()) // not there, or a share that is not mounted
            continue;
        try {
            const QString text = QString::fromUtf8(machineFile(folder));
            if (text != before || !kept.contains(folder))
                changed.emplace(folder, text);
        } catch (const Error &error) {
            unreadable.push_back({machineFileIn(folder), storedSentence(error)});
            if (!kept.contains(folder)) // a folder of the register all the same
                changed.emplace(folder, QString());
        }
    }
    return changed;
}

QStringList chooseMachine(Register &reg, const ListedMachine &machine, const ListedMachine *other,
                          std::optional<int> months, const Language &language) {
    QStringList folders = foldersOf(reg.database(), machine);
    if (other)
        folders += foldersOf(reg.database(), *other);
    folders.removeDuplicates();
    std::vector<std::pair<QString, Error>> refused;
    const auto write = [&](const QString &folder) {
        try {
            saveBytes(withChoice(machineFile(folder), machine, other, months), machineFileIn(folder));
        } catch (const Error &error) {
            refused.emplace_back(folder, error);
        }
    };
    RegisterWriter writer(reg.database());
    Transaction transaction(reg.database());
    writer.begin(); // of two that say something at once one waits for the other
    std::ranges::for_each(folders, write);
    const std::size_t unwritable = refused.size();
    if (unwritable > 0 || folders.isEmpty()) {
        QDir().mkpath(ownFolder());
        write(ownFolder());
    }
    const auto sentence = [&](const auto &one) { return sentenceOf(one.first, one.second, language); };
    if (refused.size() > unwritable)
        throw Error(refused.back().second.kind,
                    {REPORT_TEXT("report", "%1"), {sentence(refused.back()).toStdString()}});
    std::vector<Unreadable> unreadable;
    writer.takeMachineFiles(changedMachineFiles(reg.database(), {}, unreadable));
    transaction.commit();
    QStringList said;
    const std::string own = machineFileIn(ownFolder()).toStdString();
    for (const auto &one : refused) {
        const bool isDamaged =
            one.second.kind == Error::Kind::syntax || one.second.kind == Error::Kind::format;
        said << (isDamaged
                     ? language.sentence(
                           {REPORT_TEXT("report", "%1; kept in %2"), {sentence(one).toStdString(), own}})
                     : one.first + QStringLiteral(": ") +
                           language.sentence(
                               {REPORT_TEXT("report", "the folder cannot be written; kept in %1"), {own}}));
    }
    return said;
}

void separateMachine(Register &reg, const ListedMachine &machine, const MachineFields &part,
                     const Language &language) {
    const QString identity = machineIdentity(part);
    RegisterWriter writer(reg.database());
    Transaction transaction(reg.database());
    writer.begin(); // of two that say something at once one waits for the other
    for (const auto &[folder, kept] : keptMachineFiles(reg.database())) {
        try {
            const bool isThere = QFileInfo(folder).isDir();
            const QByteArray before = isThere ? machineFile(folder) : kept.toUtf8();
            const QByteArray after = withoutJoin(before, machine.identity, identity);
            if (after == before)
                continue;
            if (!isThere) // a share that is not mounted
                throw Error(Error::Kind::unwritable,
                            {REPORT_TEXT("report", "joins them, and is not there now; connect it"), {}});
            saveBytes(after, machineFileIn(folder));
        } catch (const Error &error) {
            throw Error(error.kind,
                        {REPORT_TEXT("report", "%1"), {sentenceOf(folder, error, language).toStdString()}});
        }
    }
    std::vector<Unreadable> unreadable;
    writer.takeMachineFiles(changedMachineFiles(reg.database(), {}, unreadable));
    transaction.commit();
}

} // namespace palmer
