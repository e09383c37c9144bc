// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/referenceset.h"

#include "document/bounds.h"
#include "document/documenterror.h"
#include "document/filewords.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <optional>

namespace palmer {

template <>
inline constexpr auto fileWords<ExpectationSource> = wordsInOrder<ExpectationSource>("published",
                                                                                     "recomputed", "exact",
                                                                                     "certified");
template <>
inline constexpr auto fileWords<Quantity> = std::to_array<FileWord<Quantity>>(
    {{Quantity::deviation, "deviation"}, {Quantity::number, "number"}, {Quantity::feed, "feed"}});

namespace {

[[noreturn]] void refuse(const std::string &place) {
    throw Error(Error::Kind::format, {REPORT_TEXT("report", "expected reference data of this program")},
                place);
}

template <class Enumeration>
Enumeration found(const QJsonValue &word, const std::string &place) {
    const auto value = ofFileWord<Enumeration>(word.toString().toStdString());
    if (!value)
        refuse(place);
    return *value;
}

iso230_4::ContouringFeed contouringFeed(const QJsonObject &object) {
    const auto number = [&](QLatin1StringView key) { return object.value(key).toDouble(); };
    return {number(QLatin1StringView("specifiedDiameter")), number(QLatin1StringView("specifiedFeed")),
            number(QLatin1StringView("diameter"))};
}

/// Reads what is expected of a test, by its key.
void readWhat(Expectation &result, const QJsonObject &object, const std::string &place) {
    const auto has = [&](QLatin1StringView key) { return object.contains(key); };
    const auto text = [&](QLatin1StringView key) { return object.value(key).toString().toStdString(); };
    if (has(QLatin1StringView("contouringFeed"))) {
        result.what = Expected::contouringFeed;
        result.feed = contouringFeed(object.value(QLatin1StringView("contouringFeed")).toObject());
        return;
    }
    const int test = object.value(QLatin1StringView("test")).toInt(1);
    if (test < 1)
        refuse(place);
    result.test = static_cast<std::size_t>(test) - 1;
    result.parameter = text(QLatin1StringView("parameter"));
    result.statistic = text(QLatin1StringView("statistic"));
    result.target = object.value(QLatin1StringView("target")).toInt();
    if (object.value(QLatin1StringView("correction")).toBool())
        result.what = Expected::correction;
    else if (!result.statistic.empty())
        result.what = Expected::statistic;
    else if (result.parameter.empty())
        refuse(place);
}

Expectation expectation(const QJsonObject &object, const std::string &place) {
    Expectation result;
    readWhat(result, object, place);
    result.edition = object.value(QLatin1StringView("edition")).toString().toStdString();
    result.relative = object.contains(QLatin1StringView("relativeTolerance"));
    const QJsonValue tolerance = object.value(result.relative ? QLatin1StringView("relativeTolerance")
                                                              : QLatin1StringView("tolerance"));
    const QJsonValue value = object.value(QLatin1StringView("value"));
    if (!value.isDouble() || !tolerance.isDouble())
        refuse(place);
    result.value = value.toDouble();
    result.tolerance = tolerance.toDouble();
    result.source = found<ExpectationSource>(object.value(QLatin1StringView("source")), place);
    return result;
}

} // namespace

ReferenceSet readReferenceSet(const QByteArray &bytes) {
    const QJsonObject file = QJsonDocument::fromJson(bytes).object();
    if (file.value(QLatin1StringView("format")) != QLatin1StringView("palmer reference data"))
        refuse("format");
    ReferenceSet set;
    set.name = file.value(QLatin1StringView("name")).toString();
    set.origin = file.value(QLatin1StringView("origin")).toString();
    if (file.contains(QLatin1StringView("quantity")))
        set.quantity = found<Quantity>(file.value(QLatin1StringView("quantity")), "quantity");
    QJsonArray tests = file.value(QLatin1StringView("tests")).toArray();
    if (file.contains(QLatin1StringView("test")))
        tests.append(file.value(QLatin1StringView("test")));
    const QJsonObject document{{QStringLiteral("format"), QStringLiteral("palmer test report")},
                               {QStringLiteral("version"), 1},
                               {QStringLiteral("tests"), tests}};
    set.document = std::make_shared<const Document>(
        readUnbounded(QJsonDocument(document).toJson(QJsonDocument::Compact)));
    const QJsonArray expected = file.value(QLatin1StringView("expected")).toArray();
    for (qsizetype i = 0; i < expected.size(); ++i)
        set.expected.push_back(expectation(expected[i].toObject(), "expected[" + std::to_string(i) + "]"));
    if (set.expected.empty())
        refuse("expected");
    return set;
}

std::vector<QString> embeddedReferenceFiles() {
    const QDir folder(QStringLiteral(":/reference"));
    std::vector<QString> result;
    for (const QString &name : folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        result.push_back(folder.filePath(name));
    return result;
}

} // namespace palmer
