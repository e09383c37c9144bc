// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/referenceset.h"

#include "document/bounds.h"
#include "document/documenterror.h"
#include "document/filewords.h"
#include "document/setfield.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

using namespace Qt::StringLiterals;

namespace palmer {

template <>
inline constexpr auto fileWords<ExpectationSource> =
    wordsInOrder<ExpectationSource>("published", "recomputed", "exact", "certified", "second implementation");
template <>
inline constexpr auto
    fileWords<Quantity> = std::to_array<FileWord<Quantity>>({{Quantity::deviation, "deviation"},
                                                             {Quantity::angularDeviation, "angularDeviation"},
                                                             {Quantity::position, "position"},
                                                             {Quantity::number, "number"},
                                                             {Quantity::feed, "feed"}});
template <>
inline constexpr auto fileWords<Expected> = wordsInOrder<Expected>("parameter", "statistic", "contribution",
                                                                   "drift", "correction", "influence",
                                                                   "comparison", "compensation", "trend",
                                                                   "contouringFeed", "circle", "sheet",
                                                                   "response", "typeTest");
template <>
inline constexpr auto fileWords<CompensationFormat> = wordsInOrder<CompensationFormat>("linuxcnc", "siemens",
                                                                                       "weihong", "csv");

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

std::string text(const QJsonObject &object, QLatin1StringView key) {
    return object[key].toString().toStdString();
}

std::optional<double> numberOrNone(const QJsonObject &object, QLatin1StringView key) {
    const QJsonValue value = object[key];
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

Words words(const QJsonValue &value) {
    Words result;
    for (const QString &code : {u"en"_s, u"fr"_s})
        result[code] = value.isObject() ? value[code].toString() : value.toString();
    return result;
}

iso230_4::ContouringFeed contouringFeed(const QJsonObject &object) {
    return {object["specifiedDiameter"_L1].toDouble(), object["specifiedFeed"_L1].toDouble(),
            object["diameter"_L1].toDouble()};
}

/// Reads what is expected of a test: the one key of a kind.
void readWhat(Expectation &result, const QJsonObject &object, const std::string &place) {
    const auto &kinds = fileWords<Expected>;
    const auto kind = std::ranges::find_if(
        kinds, [&](const auto &row) { return object.contains(QLatin1StringView(row.word)); });
    const int test = object["test"_L1].toInt(1);
    if (kind == kinds.end() || test < 1)
        refuse(place);
    const QLatin1StringView key(kind->word);
    result.what = kind->value;
    result.id = text(object, key);
    result.feed = contouringFeed(object[key].toObject());
    result.test = static_cast<std::size_t>(test) - 1;
    result.of = text(object, "of"_L1);
    result.target = object["target"_L1].toInt();
    result.axis = text(object, "axis"_L1);
    if (object.contains("format"_L1))
        result.format = found<CompensationFormat>(object["format"_L1], place);
    result.table.perDirection = object["perDirection"_L1].toBool();
    result.table.interval = numberOrNone(object, "interval"_L1);
    result.table.reference = numberOrNone(object, "reference"_L1);
}

Expectation expectation(const QJsonObject &object, const ReferenceSet &set, const std::string &place) {
    Expectation result;
    readWhat(result, object, place);
    result.edition = text(object, "edition"_L1);
    result.variant = text(object, "variant"_L1);
    result.relative = object.contains("relativeTolerance"_L1);
    const QJsonValue tolerance = object[result.relative ? "relativeTolerance"_L1 : "tolerance"_L1];
    const QJsonValue value = object["value"_L1];
    if (!(value.isDouble() && tolerance.isDouble()) && !value.isString())
        refuse(place);
    if (!set.documents.contains(result.variant))
        refuse(place + ".variant");
    result.word = value.toString().toStdString();
    result.value = value.toDouble();
    result.tolerance = tolerance.toDouble();
    result.source = found<ExpectationSource>(object["source"_L1], place);
    return result;
}

ReferenceTrend trend(const QJsonObject &object) {
    ReferenceTrend result;
    for (const QJsonValue item : object["points"_L1].toArray()) {
        const auto number = [&](const char *key) { return item[QLatin1StringView(key)].toDouble(); };
        TrendPoint &point =
            result.points.emplace_back(TrendPoint{number("time"), number("value"), number("own")});
        for (const QJsonValue part : item["shared"_L1].toArray())
            point.shared.push_back({text(part.toObject(), "source"_L1), part["u"_L1].toDouble()});
    }
    result.limits.upper = numberOrNone(object, "limit"_L1);
    result.reserve = object["reserve"_L1].toDouble();
    return result;
}

/// Adds the documents with the settings of each variant, by the paths of the test file.
void addVariants(ReferenceSet &set, const QJsonObject &variants) {
    for (auto variant = variants.begin(); variant != variants.end(); ++variant) {
        Document document = *set.documents[""];
        const QJsonObject settings = variant->toObject();
        for (auto setting = settings.begin(); setting != settings.end(); ++setting)
            document = withField(document, setting.key().toStdString(), setting->toString().toStdString());
        set.documents[variant.key().toStdString()] = std::make_shared<const Document>(std::move(document));
    }
}

} // namespace

ReferenceSet readReferenceSet(const QByteArray &bytes) {
    const QJsonObject file = QJsonDocument::fromJson(bytes).object();
    if (file["format"_L1] != "palmer reference data"_L1)
        refuse("format");
    ReferenceSet set;
    set.name = words(file["name"_L1]);
    set.origin = words(file["origin"_L1]);
    if (file.contains("quantity"_L1))
        set.quantity = found<Quantity>(file["quantity"_L1], "quantity");
    QJsonArray tests = file["tests"_L1].toArray();
    if (file.contains("test"_L1))
        tests.append(file["test"_L1]);
    const QJsonObject document{{u"format"_s, u"palmer test report"_s},
                               {u"version"_s, 1},
                               {u"report"_s, file["report"_L1].toObject()},
                               {u"tests"_s, tests}};
    set.documents[""] = std::make_shared<const Document>(
        readUnbounded(QJsonDocument(document).toJson(QJsonDocument::Compact)));
    addVariants(set, file["variants"_L1].toObject());
    for (const QJsonValue item : file["trends"_L1].toArray())
        set.trends.push_back(trend(item.toObject()));
    for (const QJsonValue item : file["points"_L1].toArray()) {
        Points &points = set.points.emplace_back();
        for (const auto &[key, numbers] : {std::pair("x"_L1, &points.x), std::pair("y"_L1, &points.y)})
            std::ranges::transform(item[key].toArray(), std::back_inserter(*numbers),
                                   [](const QJsonValue &number) { return number.toDouble(); });
    }
    for (const QJsonValue item : file["types"_L1].toArray()) {
        ReferenceType &type = set.types.emplace_back();
        for (const QJsonValue value : item["values"_L1].toArray())
            type.values.push_back(value.toDouble());
        type.tolerance = {item["content"_L1].toDouble(), item["confidence"_L1].toDouble()};
    }
    const QJsonArray expected = file["expected"_L1].toArray();
    for (qsizetype i = 0; i < expected.size(); ++i)
        set.expected.push_back(
            expectation(expected[i].toObject(), set, "expected[" + std::to_string(i) + "]"));
    if (set.expected.empty())
        refuse("expected");
    return set;
}

QStringList referenceFilesIn(const QString &folder) {
    QStringList result = QDir(folder).entryList({u"*.json"_s}, QDir::Files, QDir::Name);
    result.replaceInStrings(QRegularExpression(u"^"_s), folder + u'/');
    return result;
}

QStringList quickReferenceFiles() {
    return referenceFilesIn(u":/reference"_s);
}

QStringList allReferenceFiles() {
    return quickReferenceFiles() + referenceFilesIn(u":/reference/second"_s);
}

} // namespace palmer
