// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/completefile.h"
#include "document/edits.h"
#include "document/filewords.h"
#include "document/readdocument.h"
#include "document/readinglists.h"
#include "document/writedocument.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryFile>
#include <QTest>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>

using namespace palmer;

namespace {

/// One schema per version.
QString schemaPath(int version) {
    return QStringLiteral(PALMER_BINARY_DIR "/resources/schema/palmer-%1.schema.json").arg(version);
}

/// The complete file with every field of this version.
QByteArray completeFileOf(int version) {
    Document document = readDocument(completeFile());
    if (version == 1)
        return completeFile();
    const auto common = [](Conditions &conditions) {
        conditions.warmUp.specifiedBy = SpecifiedBy::maker;
        conditions.temperatureControlled = true;
        conditions.stabilised = true;
        conditions.instrumentCompensation = InstrumentCompensation::on;
    };
    for (std::size_t i = 0; i < 2; ++i) {
        editTest(document, i, [&](Test &test) {
            test.purpose = Purpose::acceptance;
            test.role = TestRole::asLeft;
            test.declaredAccordance = {"laboratory", "2026-11-20", "read in full"};
            if (!test.agreedPoints.empty())
                test.agreedPoints[0].value = 0.5;
            if (auto *m = std::get_if<PositioningMeasurement>(&test.measurement)) {
                m->axis.scaleElement = 1020;
                m->targetChoice.faces = 12;
                m->conditions.gradientHoursBefore = 12;
                m->conditions.continuousDevice = true;
                common(m->conditions.common);
            } else if (auto *c = std::get_if<CircularMeasurement>(&test.measurement)) {
                c->specified = {300, 1000};
                c->arcs[0].cutOff = "overshoot";
                common(c->conditions.common);
            }
        });
    }
    if (version == 3) {
        ReportHead &head = document.report;
        head.laboratory.country = "FR";
        head.customer.contact = head.supplier.contact = "A. Martin";
        head.revisionReason = "wrong date";
        head.deviationsFromMethod = "none";
        head.rounding = Rounding::twoDigits;
        head.sheet = {{"G1", "flatness", {{}, 0.02}, 0.01, 0.003, "mm", "level", "table", "-", "", {}},
                      {"G2", "parallelism", {-0.01, 0.02}, -0.002, 0.003, "mm", "", "", "", "", {}},
                      {"P1", "A of X", {}, {}, {}, "", "", "", "", "no X", SheetSource{"x1", "A"}}};
        head.decisionRule = {Rule::iso14253_1, 0.83};
        editTest(document, 0, [&](Test &test) {
            test.comparedWith = ComparedWith{document.tests[1]->id, 0.002, true};
        });
        editTest(document, 1, [](Test &test) { test.duration = 40; });
        editMeasurement<DriftMeasurement>(document, 2, [](DriftMeasurement &drift) {
            const std::size_t count = drift.times.size();
            drift.deviations.clear();
            drift.channels = {
                {"X", ChannelQuantity::deviation, std::vector<std::optional<double>>(count, 0.001)},
                {"C", ChannelQuantity::angularDeviation, std::vector<std::optional<double>>(count)}};
            drift.temperatures = {{"air", 0.1, std::vector<std::optional<double>>(count, 20.0)}};
            drift.settled = true;
        });
        document.instruments[0].traceability = {"Institute", "2-0001", "C-2"};
    }
    return writeDocument(document);
}

// What the reader refuses and a schema cannot express, and where the description of the schema says so.
const std::map<std::string, const char *> beyondSchema{
    {"expected a date that exists, written YYYY-MM-DD", "days that no calendar has"},
    {"number of values found: %1; expected: %2", "lists that must be of equal length"},
    {"expected targets that ascend strictly", "targets that do not ascend strictly"},
    {"expected “from” to be less than “to”", "`from` not less than `to`"},
    {"expected the least value before the largest", "a least value permitted above the largest"},
    {"expected times that ascend", "times of channels that do not ascend"},
    {"expected the number of a run, from 1 to %1", "excluded readings that do not exist"},
    {"expected the number of a target, from 1 to %1", "excluded readings that do not exist"},
    {"expected null, for this reading stands in “excluded”", "are not null in their run"},
    {"this reading is excluded twice; expected it once", "or are excluded twice"},
    {"“%1” stands here twice; expected it once", "a point agreed twice, ids that are not unique"},
    {"expected the id of an instrument of this file; “%1” is none",
     "ids that are not unique or name nothing"},
    {"expected the id of a drift test of this file; “%1” is none", "ids that are not unique or name nothing"},
    {"expected the id of another test of this file, no drift test; “%1” is none",
     "ids that are not unique or name nothing"},
};

const std::set<std::string> inVersion3{"expected the least value before the largest",
                                       "expected times that ascend"};

struct Case {
    QByteArray name;
    QByteArray file; // on one line
};

using Change = std::function<QJsonValue(const QJsonValue &)>;

// The value with the part at `path` changed; an undefined part is removed.
QJsonValue changed(const QJsonValue &value, const QVariantList &path, const Change &change) {
    if (path.isEmpty())
        return change(value);
    if (value.isObject()) {
        QJsonObject object = value.toObject();
        const QString key = path.first().toString();
        const QJsonValue part = changed(object.value(key), path.mid(1), change);
        if (part.isUndefined())
            object.remove(key);
        else
            object.insert(key, part);
        return object;
    }
    QJsonArray array = value.toArray();
    const int index = path.first().toInt();
    const QJsonValue part = changed(array.at(index), path.mid(1), change);
    if (part.isUndefined())
        array.removeAt(index);
    else
        array.replace(index, part);
    return array;
}

// Paths of the parts of a value: of lists the first two elements, nothing inside `extensions`.
void collectPaths(const QJsonValue &value, const QVariantList &path, QList<QVariantList> &paths) {
    paths.append(path);
    if (!path.isEmpty() && path.last() == QStringLiteral("extensions"))
        return;
    const QJsonObject object = value.toObject();
    for (auto member = object.begin(); member != object.end(); ++member)
        collectPaths(member.value(), path + QVariantList{member.key()}, paths);
    const QJsonArray array = value.toArray();
    for (int i = 0; i < std::min<int>(2, static_cast<int>(array.size())); ++i)
        collectPaths(array.at(i), path + QVariantList{i}, paths);
}

// A part of a document that a change can be made to.
struct Part {
    QJsonValue base;
    QVariantList path;
};

// All parts of the complete file, each in a file no larger than needed: the head without tests, and each kind
// of test with the drift test it names.
QList<Part> changeableParts(const QByteArray &complete) {
    QJsonObject head = QJsonDocument::fromJson(complete).object();
    const QString testsKey = QStringLiteral("tests");
    const QJsonArray tests = head.value(testsKey).toArray();
    QList<Part> parts;
    const auto add = [&](const QJsonObject &base, const QVariantList &of) {
        QJsonValue value = base;
        for (const QVariant &step : of)
            value =
                value.isArray() ? value.toArray().at(step.toInt()) : value.toObject().value(step.toString());
        QList<QVariantList> paths;
        collectPaths(value, of, paths);
        for (const QVariantList &path : paths)
            parts.append({base, path});
    };
    head.insert(testsKey, QJsonArray());
    add(head, {});
    for (const QString &key :
         {QStringLiteral("report"), QStringLiteral("machine"), QStringLiteral("extensions")})
        head.remove(key);
    for (int i = 0; i < 2; ++i) {
        head.insert(testsKey, QJsonArray{tests.at(i), tests.at(2)});
        add(head, {testsKey, 0});
    }
    add(head, {testsKey, 1});
    return parts;
}

QByteArray nameOf(const QVariantList &path) {
    QByteArray name;
    for (const QVariant &step : path)
        name += '/' + step.toString().toUtf8();
    return name;
}

// One call of the validator for all of them.
QList<bool> validate(const QList<Case> &cases, int version) {
    QTemporaryFile file;
    if (!file.open())
        return {};
    for (const Case &one : cases)
        file.write(one.file + '\n');
    file.close();
    QProcess validator;
    validator.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    validator.start(QStringLiteral("/usr/bin/python3"),
                    {QStringLiteral(PALMER_SOURCE_DIR "/tests/core/document/validate.py"),
                     schemaPath(version), file.fileName()});
    if (!validator.waitForFinished(patience) || validator.exitCode() != 0)
        return {};
    QList<bool> valid;
    for (const QByteArray &line : validator.readAllStandardOutput().trimmed().split('\n'))
        valid.append(line == "1");
    return valid;
}

std::optional<Error> errorOf(const QByteArray &file) {
    try {
        (void)readDocument(file);
        return {};
    } catch (const Error &error) {
        return error;
    }
}

QByteArray oneLine(const QJsonValue &value) {
    return QJsonDocument(value.toObject()).toJson(QJsonDocument::Compact);
}

// A part of the schema, its references followed; what stands beside a reference wins.
class Schema {
public:
    explicit Schema(int version = 1) {
        QFile file(schemaPath(version));
        if (file.open(QIODevice::ReadOnly))
            m_root = QJsonDocument::fromJson(file.readAll()).object();
    }

    [[nodiscard]] QJsonObject root() const { return m_root; }
    [[nodiscard]] QJsonObject definition(const char *name) const {
        return m_root.value(QStringLiteral("$defs")).toObject().value(QLatin1String(name)).toObject();
    }
    [[nodiscard]] QJsonArray words(const char *name) const {
        return definition(name).value(QStringLiteral("enum")).toArray();
    }

    [[nodiscard]] QJsonObject resolved(QJsonObject part) const {
        while (part.contains(QStringLiteral("$ref"))) {
            const QString reference = part.take(QStringLiteral("$ref")).toString();
            const QJsonObject target = definition(reference.section(QLatin1Char('/'), -1).toLatin1());
            for (auto member = target.begin(); member != target.end(); ++member)
                if (!part.contains(member.key()))
                    part.insert(member.key(), member.value());
        }
        return part;
    }

private:
    QJsonObject m_root;
};

// Differences between what the schema says an object holds by default and what the writer wrote.
void compareDefaults(const Schema &schema, const QJsonObject &reference, const QJsonObject &written,
                     const QString &place, QStringList &differences) {
    const QJsonObject part = schema.resolved(reference);
    const QJsonObject properties = part.value(QStringLiteral("properties")).toObject();
    const QJsonArray required = part.value(QStringLiteral("required")).toArray();
    for (const QString &key : written.keys()) {
        if (!properties.contains(key))
            differences += place + QStringLiteral(": unknown key ") + key;
    }
    for (auto property = properties.begin(); property != properties.end(); ++property) {
        const QString inner = place + QLatin1Char('.') + property.key();
        const QJsonObject member = schema.resolved(property.value().toObject());
        // What is not stated may be left out, for older programs know no null there.
        const QJsonValue value = written.value(property.key());
        if (value.isUndefined() && member.value(QStringLiteral("default")).isNull())
            continue;
        if (member.contains(QStringLiteral("default"))) {
            if (member.value(QStringLiteral("default")) != value)
                differences += inner + QStringLiteral(": another default");
        } else if (member.contains(QStringLiteral("properties"))) {
            compareDefaults(schema, member, value.toObject(), inner, differences);
        } else if (!required.contains(property.key())) {
            differences += inner + QStringLiteral(": no default");
        }
    }
}

} // namespace

class DocumentSchemaTest : public QObject {
    Q_OBJECT

private slots:
    /// Each counts towards the limit on readings while the file is parsed.
    void namesTheListsOfReadings() {
        for (const char *key : {"deviations", "radialDeviations", "values"})
            QVERIFY2(palmer::isListOfReadings(key), key);
        for (const char *key : {"times", "temperatures", "targets", "value", "runs"})
            QVERIFY2(!palmer::isListOfReadings(key), key);
    }
    void saysWhatItCannotExpress() {
        for (const int version : {1, 2, 3}) {
            const QString said = Schema(version).root().value(QStringLiteral("description")).toString();
            for (const auto &[message, words] : beyondSchema)
                QVERIFY2((version < 3 && inVersion3.contains(message)) ||
                             said.contains(QString::fromUtf8(words)),
                         message.c_str());
        }
    }

    // A kind that is forgotten here would be tested by nothing below.
    void everyKindHasWordBranchDefinitionAndTest() {
        const Schema schema(static_cast<int>(fileVersion));
        const QJsonObject items = schema.root()[u"properties"][u"tests"][u"items"].toObject();
        const QJsonArray words = items[u"properties"][u"kind"][u"enum"].toArray();
        const Document complete = readDocument(completeFileOf(static_cast<int>(fileVersion)));
        QCOMPARE(std::size_t(words.size()), allKinds.size());
        for (const Kind kind : allKinds) {
            const QString word = QString::fromUtf8(fileWord(kind));
            const QString name = word + QStringLiteral("Test");
            QVERIFY2(words.contains(word), qPrintable(word));
            QVERIFY2(!schema.definition(name.toLatin1()).isEmpty(), qPrintable(name));
            QVERIFY2(std::ranges::any_of(items[u"allOf"].toArray(),
                                         [&](const QJsonValue &branch) {
                                             return branch[u"if"][u"properties"][u"kind"][u"const"] == word &&
                                                    branch[u"then"][u"$ref"].toString().endsWith(name);
                                         }),
                     qPrintable(word));
            QVERIFY2(std::ranges::any_of(complete.tests,
                                         [&](const TestPointer &test) { return kindOf(*test) == kind; }),
                     qPrintable(word));
        }
    }

    void defaultsAreThoseOfTheWriter() {
        const Document document = readDocument(
            R"({"format": "palmer test report", "version": 1, "instruments": [{}], "tests": [
            {"kind": "positioning", "edition": "ISO 230-2:1988", "targets": [], "runs": []},
            {"kind": "circular", "edition": "ISO 230-4:2005", "nominalRadius": 100, "arcs": []},
            {"kind": "drift", "times": [], "deviations": []}]})");
        QJsonObject written = QJsonDocument::fromJson(writeDocument(document)).object();
        const Schema schema;
        QStringList differences;
        const QJsonArray tests = written.value(QStringLiteral("tests")).toArray();
        compareDefaults(schema, schema.definition("positioningTest"), tests.at(0).toObject(),
                        QStringLiteral("positioning"), differences);
        compareDefaults(schema, schema.definition("circularTest"), tests.at(1).toObject(),
                        QStringLiteral("circular"), differences);
        compareDefaults(schema, schema.definition("driftTest"), tests.at(2).toObject(),
                        QStringLiteral("drift"), differences);
        compareDefaults(schema, schema.definition("instrument"),
                        written.value(QStringLiteral("instruments")).toArray().at(0).toObject(),
                        QStringLiteral("instrument"), differences);
        written.insert(QStringLiteral("tests"), QJsonArray());
        written.insert(QStringLiteral("instruments"), QJsonArray());
        compareDefaults(schema, schema.root(), written, QStringLiteral("document"), differences);
        QCOMPARE(differences.join(QStringLiteral(", ")), QString());
    }

    void editionsParametersAndPointsAreThoseOfTheKernel() {
        const Schema schema;
        QStringList positioning;
        QStringList circular;
        for (const Edition *const edition : editions()) {
            const bool isCircular = edition->kind == Kind::circular;
            (isCircular ? circular : positioning) += QString::fromUtf8(edition->word);
            const QJsonObject points = schema.resolved(
                schema.definition(isCircular ? "circularAgreedPoints" : "positioningAgreedPoints"));
            const QJsonArray words = points.value(QStringLiteral("items"))
                                         .toObject()
                                         .value(QStringLiteral("properties"))
                                         .toObject()
                                         .value(QStringLiteral("point"))
                                         .toObject()
                                         .value(QStringLiteral("enum"))
                                         .toArray();
            const QJsonArray parameters =
                schema.words(isCircular ? "circularParameter" : "positioningParameter");
            for (const Row &row : edition->rows)
                QVERIFY2(parameters.contains(QString::fromUtf8(row.term.id)), row.term.id);
            for (const AgreementPoint &point : edition->points)
                QVERIFY2(words.contains(QString::fromUtf8(point.point)), point.point);
            for (const QJsonValue &word : words)
                QVERIFY2(isAgreementPoint(edition->kind, word.toString().toStdString()),
                         qPrintable(word.toString()));
        }
        QCOMPARE(schema.words("positioningEdition"), QJsonArray::fromStringList(positioning));
        QCOMPARE(schema.words("circularEdition"), QJsonArray::fromStringList(circular));
        for (const QJsonValue &id : schema.words("positioningParameter"))
            QVERIFY2(isParameter(Kind::positioning, id.toString().toStdString()), qPrintable(id.toString()));
        for (const QJsonValue &id : schema.words("circularParameter"))
            QVERIFY2(isParameter(Kind::circular, id.toString().toStdString()), qPrintable(id.toString()));
    }

    void schemaAndReaderRefuseTheSame_data() {
        QTest::addColumn<int>("version");
        QTest::newRow("version 1") << 1;
        QTest::newRow("version 2") << 2;
        QTest::newRow("version 3") << 3;
    }
    void schemaAndReaderRefuseTheSame() {
        QFETCH(int, version);
        const QByteArray complete = completeFileOf(version);
        QCOMPARE(QJsonDocument::fromJson(complete).object().value(QStringLiteral("version")).toInt(),
                 version);
        QList<Case> cases{{"complete file", oneLine(QJsonDocument::fromJson(complete).object())},
                          {"complete file as written",
                           oneLine(QJsonDocument::fromJson(writeDocument(readDocument(complete))).object())}};
        // Every type, and words that are right in one place and wrong in the others.
        const QJsonArray replacements =
            QJsonDocument::fromJson(R"([null, true, -1, 0, 2.0, 1.5, 1e20, "", "G", "no such", "2024-13-01",
                "2024-06-30", "23:59", "24:00", "Zm9v", "Zm9", "ISO 230-2:1997", "ISO 230-4:2022", [],
                [null, 1.5, "x"], {}])")
                .array();
        for (const Part &part : changeableParts(complete)) {
            const QJsonValue &base = part.base;
            const QVariantList &path = part.path;
            const auto add = [&](const QByteArray &what, const Change &change) {
                if (const QJsonValue after = changed(base, path, change); after != base)
                    cases.append({nameOf(path) + ": " + what, oneLine(after)});
            };
            if (!path.isEmpty()) {
                for (const QJsonValue &replacement : replacements)
                    add("replaced by " +
                            QJsonDocument(QJsonArray{replacement}).toJson(QJsonDocument::Compact),
                        [&](const QJsonValue &) { return replacement; });
                for (const int characters : {4096, 4097, 65536, 65537}) {
                    add(QByteArray::number(characters) + " characters", [&](const QJsonValue &value) {
                        // Of the first two UTF-16 units and four bytes are one character.
                        const QString one = QString::fromUtf8(characters < 5000 ? "😀" : "x");
                        return value.isString() ? QJsonValue(one.repeated(characters)) : value;
                    });
                }
                for (const double size : {100.0, 100.001, 273.15, 273.151, 1e6, 1000000.001, 1e15}) {
                    for (const double number : {size, -size})
                        add("replaced by " + QByteArray::number(number, 'g', 17),
                            [&](const QJsonValue &value) {
                                return value.isDouble() ? QJsonValue(number) : value;
                            });
                }
                add("removed", [](const QJsonValue &) { return QJsonValue(QJsonValue::Undefined); });
                add("negated", [](const QJsonValue &value) {
                    return value.isDouble() ? QJsonValue(-value.toDouble()) : value;
                });
            }
            add("unknown key", [](const QJsonValue &value) -> QJsonValue {
                QJsonObject object = value.toObject();
                object.insert(QStringLiteral("unknown"), 1);
                return value.isObject() ? QJsonValue(object) : value;
            });
            add("first element twice", [](const QJsonValue &value) -> QJsonValue {
                QJsonArray array = value.toArray();
                if (!array.isEmpty())
                    array.append(array.first());
                return value.isArray() ? QJsonValue(array) : value;
            });
            // Every word that the reader offers is one of the schema.
            const auto error = errorOf(oneLine(changed(
                base, path, [](const QJsonValue &) { return QJsonValue(QStringLiteral("no such")); })));
            if (error &&
                std::string_view(error->message.text.source) == "unknown word “%1”; expected one of: %2")
                for (const QString &word :
                     QString::fromStdString(std::get<std::string>(error->message.arguments[1]))
                         .split(QStringLiteral(" · ")))
                    add("the word " + word.toUtf8(), [&](const QJsonValue &) { return QJsonValue(word); });
        }
        QVERIFY(cases.size() > 5000);

        const QList<bool> valid = validate(cases, version);
        QCOMPARE(valid.size(), cases.size());
        int refused = 0;
        QByteArrayList differences;
        for (qsizetype i = 0; i < cases.size(); ++i) {
            const std::optional<Error> error = errorOf(cases[i].file);
            // Each version has its schema; the reader knows both.
            if (!error && cases[i].name.startsWith("/version: replaced by"))
                continue;
            const bool beyond = error && beyondSchema.count(error->message.text.source) > 0;
            if (valid[i] == error.has_value() && !(valid[i] && beyond))
                differences += cases[i].name +
                               (valid[i] ? ": only the reader refuses, " : ": only the schema refuses") +
                               (error ? error->message.text.source : "");
            refused += error ? 1 : 0;
        }
        QVERIFY2(differences.isEmpty(), differences.join('\n').constData());
        QVERIFY(valid[0] && valid[1]);
        QVERIFY(refused > cases.size() / 2);
    }
};

QTEST_GUILESS_MAIN(DocumentSchemaTest)
#include "documentschema.moc"
