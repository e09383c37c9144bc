#include "validation/referenceset.h"

#include "document/readdocument.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <array>
#include <optional>

namespace palmer {

namespace {

struct SourceWord {
    QLatin1StringView word;
    ExpectationSource source;
};

const std::array sourceWords{
    SourceWord{QLatin1StringView("published"), ExpectationSource::published},
    SourceWord{QLatin1StringView("recomputed"), ExpectationSource::recomputed},
    SourceWord{QLatin1StringView("exact"), ExpectationSource::exact},
    SourceWord{QLatin1StringView("certified"), ExpectationSource::certified},
};

[[noreturn]] void refuse(const std::string &place) {
    throw Error(Error::Kind::format, {REPORT_TEXT("report", "expected reference data of this program")},
                place);
}

Expectation expectation(const QJsonObject &object, const std::string &place) {
    const auto text = [&](QLatin1StringView key) { return object.value(key).toString().toStdString(); };
    Expectation result;
    result.edition = text(QLatin1StringView("edition"));
    result.parameter = text(QLatin1StringView("parameter"));
    result.target = object.value(QLatin1StringView("target")).toInt();
    result.statistic = text(QLatin1StringView("statistic"));
    result.relative = object.contains(QLatin1StringView("relativeTolerance"));
    const QJsonValue tolerance = object.value(result.relative ? QLatin1StringView("relativeTolerance")
                                                              : QLatin1StringView("tolerance"));
    const QJsonValue value = object.value(QLatin1StringView("value"));
    if (!value.isDouble() || !tolerance.isDouble() || result.parameter.empty() == result.statistic.empty())
        refuse(place);
    result.value = value.toDouble();
    result.tolerance = tolerance.toDouble();
    const QString word = object.value(QLatin1StringView("source")).toString();
    for (const SourceWord &row : sourceWords) {
        if (row.word == word) {
            result.source = row.source;
            return result;
        }
    }
    refuse(place);
}

} // namespace

ReferenceSet readReferenceSet(const QByteArray &bytes) {
    const QJsonObject file = QJsonDocument::fromJson(bytes).object();
    if (file.value(QLatin1StringView("format")) != QLatin1StringView("palmer reference data"))
        refuse("format");
    ReferenceSet set;
    set.name = file.value(QLatin1StringView("name")).toString();
    set.origin = file.value(QLatin1StringView("origin")).toString();
    if (file.value(QLatin1StringView("quantity")) == QLatin1StringView("number"))
        set.quantity = Quantity::number;
    const QJsonObject document{{QStringLiteral("format"), QStringLiteral("palmer test report")},
                               {QStringLiteral("version"), 1},
                               {QStringLiteral("tests"), QJsonArray{file.value(QLatin1StringView("test"))}}};
    set.document = std::make_shared<const Document>(
        readDocument(QJsonDocument(document).toJson(QJsonDocument::Compact)));
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
