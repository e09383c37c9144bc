// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/historyfile.h"

#include "document/documenterror.h"
#include "document/resultwords.h"
#include "register/jsonline.h"
#include "register/machinechoices.h"

#include <QFileInfo>
#include <algorithm>
#include <concepts>
#include <limits>
#include <string_view>

namespace palmer {

namespace {

template <class T, class Of>
concept Same = std::same_as<std::remove_const_t<T>, Of>;

// Writer and reader have one list of members: each calls `member` with the key and the variable of each
// member.

void eachMember(auto member, Same<SharedPart> auto &part) {
    member("source", part.source);
    member("u", part.u);
}

void eachMember(auto member, Same<RegisteredResult> auto &result) {
    member("id", result.id);
    member("value", result.value);
    member("expandedUncertainty", result.expandedUncertainty);
    member("k", result.k);
    member("limit", result.limit);
    member("bound", result.bound);
    member("guardBand", result.guardBand);
    member("verdict", result.verdict);
    member("decimals", result.decimals);
    member("uncertaintyDecimals", result.uncertaintyDecimals);
    member("own", result.own);
    member("shared", result.shared);
    member("sharedFactor", result.sharedFactor);
    member("withoutParts", result.withoutParts);
}

void eachMember(auto member, Same<TestPlace> auto &place) {
    member("file", place.path);
    member("test", place.test);
}

void eachMember(auto member, Same<RegisteredTest> auto &test) {
    member("digest", test.digest);
    member("fingerprint", test.fingerprint);
    member("kind", test.kind);
    member("edition", test.edition);
    member("axis", test.axis);
    member("angular", test.angular);
    member("date", test.date);
    member("feed", test.feed);
    member("travel", test.travel);
    member("setUp", test.setUp);
    member("correctionTo20", test.correction);
    member("purpose", test.purpose);
    member("role", test.role);
    member("verdict", test.verdict);
    member("decisionRule", test.rule);
    member("accordance", test.accordance);
    member("unmet", test.counts.unmet);
    member("undeclared", test.counts.undeclared);
    member("parts", test.parts);
    member("parameters", test.results);
}

void eachMember(auto member, Same<ListedTest> auto &listed) {
    member("places", listed.places);
    member("entry", listed.test);
}

void eachMember(auto member, Same<MachineFields> auto &machine) {
    member("name", machine.name);
    member("manufacturer", machine.manufacturer);
    member("model", machine.model);
    member("serialNumber", machine.serialNumber);
}

constexpr std::string_view joinedKey = "joined"; // only where there are some

void eachMember(auto member, Same<ListedMachine> auto &machine) {
    member("name", machine.name);
    member("manufacturer", machine.manufacturer);
    member("model", machine.model);
    member("serialNumber", machine.serialNumber);
    member("interval", machine.months);
    member(joinedKey.data(), machine.joined);
}

void eachMember(auto member, Same<Laboratory> auto &laboratory) {
    member("name", laboratory.name);
    member("address", laboratory.address);
    member("accreditation", laboratory.accreditation);
}

void eachMember(auto member, Same<History> auto &history) {
    member("program", history.program);
    member("number", history.number);
    member("today", history.today);
    member("machine", history.machine);
    member("laboratory", history.laboratory);
    member("due", history.due.tests);
    member("tests", history.tests);
}

template <class T>
concept Object = requires(T &value) {
    eachMember([](const char *, auto &) {}, value);
};

template <class T>
concept Word = std::is_enum_v<T>;

Json valueOf(const QString &text) {
    return text.toStdString();
}
Json valueOf(const QDate &day) {
    return day.toString(Qt::ISODate).toStdString();
}
Json valueOf(const Word auto &word) {
    return fileWord(word);
}
Json valueOf(const Object auto &object);
Json valueOf(const auto &plain) {
    return plain;
}
template <class T>
Json valueOf(const std::optional<T> &value) {
    return value ? valueOf(*value) : Json();
}
template <class T>
Json valueOf(const std::vector<T> &list) {
    Json result = Json::array();
    for (const T &one : list)
        result.push_back(valueOf(one));
    return result;
}
Json valueOf(const std::map<QString, QDate> &days) {
    Json result = Json::object();
    for (const auto &[name, day] : days)
        result[name.toStdString()] = valueOf(day);
    return result;
}
Json valueOf(const Object auto &object) {
    Json result = Json::object();
    eachMember(
        [&result](const char *key, const auto &value) {
            Json json = valueOf(value);
            if (joinedKey != key || !json.empty())
                result[key] = std::move(json);
        },
        object);
    return result;
}

[[noreturn]] void refuse() {
    throw Error(
        Error::Kind::format,
        {REPORT_TEXT("report", "these are no data of a printed history, or a newer program wrote them"), {}});
}

using Read = nlohmann::json;

void take(const Read &json, std::string &text) {
    text = json.get<std::string>();
}
void take(const Read &json, QString &text) {
    text = QString::fromStdString(json.get<std::string>());
}
void take(const Read &json, bool &is) {
    is = json.get<bool>();
}
void take(const Read &json, double &number) {
    number = json.get<double>();
}
void take(const Read &json, std::integral auto &number) {
    constexpr double most = std::numeric_limits<std::remove_cvref_t<decltype(number)>>::max();
    if (!json.is_number_integer() || json.get<double>() < 0 || json.get<double>() > most)
        refuse();
    json.get_to(number);
}
void take(const Read &json, QDate &day) {
    day = QDate::fromString(QString::fromStdString(json.get<std::string>()), Qt::ISODate);
    if (!day.isValid())
        refuse();
}
template <Word T>
void take(const Read &json, T &word) {
    const auto known = ofFileWord<T>(json.get<std::string>());
    if (!known)
        refuse();
    word = *known;
}
void take(const Read &json, Object auto &object);
template <class T>
void take(const Read &json, std::optional<T> &value) {
    if (!json.is_null())
        take(json, value.emplace());
}
template <class T>
void take(const Read &json, std::vector<T> &list) {
    for (const Read &one : json.get_ref<const Read::array_t &>())
        take(one, list.emplace_back());
}
void take(const Read &json, std::map<QString, QDate> &days) {
    for (const auto &[name, day] : json.get_ref<const Read::object_t &>())
        take(day, days[QString::fromStdString(name)]);
}
void take(const Read &json, Object auto &object) {
    eachMember(
        [&json](const char *key, auto &value) {
            if (joinedKey != key || json.contains(key))
                take(json.at(key), value);
        },
        object);
}

/// False for what the register never writes and no reader expects.
bool isPossible(const ListedTest &listed) {
    constexpr std::size_t mostParts = 32; // bits of RegisteredResult::shared
    constexpr int mostDecimals = 17;
    const RegisteredTest &test = listed.test;
    const bool dated =
        !test.date || QDate::fromString(QString::fromStdString(*test.date), Qt::ISODate).isValid();
    return dated && !listed.places.empty() && test.parts.size() <= mostParts &&
           std::ranges::all_of(test.results, [](const RegisteredResult &result) {
               return std::max(result.decimals.value_or(0), result.uncertaintyDecimals.value_or(0)) <=
                      mostDecimals;
           });
}

} // namespace

QByteArray historyJson(const History &history) {
    History shown = history;
    for (ListedTest &listed : shown.tests) {
        listed.places.resize(1);
        listed.places.front().path = QFileInfo(listed.places.front().path).fileName();
    }
    Json file = jsonHead("history");
    file.update(valueOf(shown));
    return QByteArray::fromStdString(printJson(file));
}

History historyFrom(const QByteArray &json) {
    const Read file = parseJson(json.toStdString());
    History history;
    try {
        if (file.at("format") != "palmer history" || file.at("version") != 1)
            refuse();
        take(file, history);
    } catch (const Read::exception &) { // a key is missing or of another type
        refuse();
    }
    if (!std::ranges::all_of(history.tests, isPossible) ||
        history.machine.months.value_or(0) > longestInterval)
        refuse();
    return history;
}

Report composeHistoryFile(const QByteArray &json, const Language &language) {
    return composeHistory(historyFrom(json), language);
}

} // namespace palmer
