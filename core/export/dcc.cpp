// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/dcc.h"

#include "document/fieldvalue.h"
#include "document/filewords.h"
#include "document/resultwords.h"
#include "document/thermal.h"
#include "document/visibletexts.h"
#include "document/writedocument.h"
#include "kernel/evaluation/conformity.h"
#include "kernel/evaluation/coverage.h"
#include "kernel/evaluation/iso230_2/sentences.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/words/characters.h"
#include "kernel/words/shortest.h"
#include "language/rounding.h"
#include "language/visibletext.h"
#include "report/parts/parts.h"
#include "report/tables/findinglines.h"
#include "report/words/accordancetext.h"
#include "report/words/correctiontext.h"
#include "report/words/wording.h"

#include <QXmlStreamWriter>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr Text limitWord = REPORT_TEXT("report", "Limit");
constexpr Text nameAndText = REPORT_TEXT("report", "%1: %2");
constexpr const char *placeId = "place"; ///< of the statement that names where the tests were made

/// First and last day of the tests: as stated in the head, otherwise of the tests that state theirs.
std::optional<std::string> dayOf(const Document &document, bool last) {
    const ReportHead &head = document.report;
    std::optional<std::string> day = last ? head.performedTo : head.performedFrom;
    if (day)
        return day;
    for (const TestPointer &test : document.tests) {
        if (test->date && (!day || (last ? *day < *test->date : *test->date < *day)))
            day = test->date;
    }
    return day ? day : last ? head.performedFrom : head.performedTo;
}

const std::string &nameOf(const Machine &machine) {
    return machine.name.empty() ? machine.model : machine.name;
}

/// Where nothing is proven, a value within its limit passes under a condition.
const char *conformityOf(Verdict verdict, bool isWithinLimit) {
    if (verdict == Verdict::notProven)
        return isWithinLimit ? "conditionalPass" : "conditionalFail";
    return verdict == Verdict::conforms ? "pass" : "fail";
}

const char *conformityOf(const Parameter &parameter) {
    return conformityOf(*parameter.verdict, judgedValue(*parameter.value, parameter.bound) <=
                                                judgedLimit(*parameter.limit->value, parameter.bound));
}

/// Precondition: the row has a verdict.
const char *conformityOf(const SheetResult &row) {
    if (row.parameter)
        return conformityOf(*row.parameter);
    const auto &[low, high] = row.permitted;
    const double value = low ? *row.value : std::abs(*row.value);
    return conformityOf(static_cast<Verdict>(row.state),
                        (!low || value >= *low) && (!high || value <= *high));
}

/// For verdicts on several values; see dcc.h for tests.
const char *conformityWord(Verdict verdict) {
    return inOrder(verdict, {"pass", "noPass", "fail"});
}

/// "Decision rule: ISO 14253-1, guard band 0.83 U."
QString ruleText(const DecisionRule &rule, const Language &language) {
    const std::string words = ruleWithBand(rule, ruleWords(rule.rule).inReport, language).toStdString();
    return language.sentence(REPORT_TEXT("report", "Decision rule: %1"), {words}) + u'.';
}

/// Units of the acceptance sheet that D-SI has.
constexpr std::array<std::pair<std::string_view, const char *>, 8> typedUnits{
    {{"mm", R"(\milli\metre)"},
     {"µm", R"(\micro\metre)"},
     {"m", R"(\metre)"},
     {"mm/m", R"(\milli\metre\metre\tothe{-1})"},
     {"µm/m", R"(\micro\metre\metre\tothe{-1})"},
     {"deg", R"(\degree)"},
     {"°", R"(\degree)"},
     {"″", R"(\arcsecond)"}}};

/// The same text in French and in English.
struct Both {
    QString french;
    QString english;
};

/// Writes elements by their qualified names: a certificate has two namespaces, both declared at its root.
class DccWriter {
public:
    DccWriter(QByteArray &bytes, const EvaluatedDocument &evaluated)
        : m_xml(&bytes)
        , m_evaluated(evaluated) {
        m_xml.setAutoFormatting(true);
        m_xml.setAutoFormattingIndent(1);
    }

    void write() {
        m_xml.writeStartDocument();
        m_xml.writeStartElement(QStringLiteral("dcc:digitalCalibrationCertificate"));
        m_xml.writeAttribute(QStringLiteral("xmlns:dcc"), QStringLiteral("https://ptb.de/dcc"));
        m_xml.writeAttribute(QStringLiteral("xmlns:si"), QStringLiteral("https://ptb.de/si"));
        m_xml.writeAttribute(QStringLiteral("schemaVersion"), QStringLiteral("3.2.0"));
        within("dcc:administrativeData", [&] { writeAdministration(); });
        within("dcc:measurementResults", [&] {
            for (std::size_t i = 0; i < document().tests.size(); ++i)
                within("dcc:measurementResult", [&] { writeTest(i); });
            if (!head().sheet.empty())
                within("dcc:measurementResult", [&] { writeSheet(); });
        });
        m_xml.writeEndDocument();
    }

private:
    [[nodiscard]] const Document &document() const { return *m_evaluated.document; }
    [[nodiscard]] const ReportHead &head() const { return document().report; }

    // ---- Elements ----

    /// `path`: elements within each other, parted by "/".
    void within(const char *path, const auto &content) {
        const QStringList names = QString::fromLatin1(path).split(u'/');
        for (const QString &name : names)
            m_xml.writeStartElement(name);
        content();
        for (qsizetype i = 0; i < names.size(); ++i)
            m_xml.writeEndElement();
    }
    void leaf(const char *name, const QString &text) {
        m_xml.writeTextElement(QString::fromLatin1(name), visibleText(text.trimmed()));
    }
    void leaf(const char *name, const std::string &text) { leaf(name, QString::fromStdString(text)); }
    void leafIfStated(const char *name, const std::string &text) {
        if (!QString::fromStdString(text).trimmed().isEmpty())
            leaf(name, text);
    }

    void content(const QString &text, const char *language = nullptr) {
        m_xml.writeStartElement(QStringLiteral("dcc:content"));
        if (language)
            m_xml.writeAttribute(QStringLiteral("lang"), QString::fromLatin1(language));
        m_xml.writeCharacters(visibleText(text.trimmed()));
        m_xml.writeEndElement();
    }
    /// A text that the user entered, or one in both languages.
    void said(const char *name, const std::string &text) {
        within(name, [&] { content(QString::fromStdString(text)); });
    }
    void said(const char *name, const Both &text) {
        within(name, [&] {
            content(text.french, "fr");
            content(text.english, "en");
        });
    }
    void said(const char *name, const Text &words) { said(name, both(words)); }

    /// Texts that the user entered; nothing if all are empty.
    void describe(std::initializer_list<std::string> texts) {
        QStringList stated;
        for (const std::string &text : texts) {
            if (const QString trimmed = QString::fromStdString(text).trimmed(); !trimmed.isEmpty())
                stated << trimmed;
        }
        if (!stated.isEmpty())
            within("dcc:description", [&] {
                for (const QString &text : stated)
                    content(text);
            });
    }

    [[nodiscard]] Both both(const auto &textOf) const { return {textOf(m_french), textOf(m_english)}; }
    [[nodiscard]] Both both(const Text &words) const { return {m_french.text(words), m_english.text(words)}; }

    /// A number in its base unit, with its uncertainty if there is one.
    void real(double value, Quantity quantity, const std::string &label = {},
              const Parameter *parameter = nullptr) {
        within("si:real", [&] {
            leafIfStated("si:label", label);
            leaf("si:value", Decimal(value, quantity).shortest());
            leaf("si:unit", std::string(dsiUnit(quantity)));
            if (parameter)
                writeUncertainty(*parameter);
        });
    }
    void quantity(const auto &name, double value, Quantity quantity) {
        within("dcc:quantity", [&] {
            said("dcc:name", name);
            real(value, quantity);
        });
    }

    // ---- Administrative data ----

    void writeAdministration() {
        within("dcc:dccSoftware/dcc:software", [&] {
            said("dcc:name", std::string("Palmer"));
            leaf("dcc:release", QStringLiteral(PALMER_VERSION));
            leaf("dcc:type", QStringLiteral("application"));
        });
        within("dcc:coreData", [&] { writeCore(); });
        within("dcc:items/dcc:item", [&] { writeMachine(); });
        within("dcc:calibrationLaboratory", [&] {
            const Laboratory &laboratory = head().laboratory;
            leafIfStated("dcc:calibrationLaboratoryCode", laboratory.accreditation);
            contact("dcc:contact", laboratory.name, laboratory.country, {laboratory.address});
        });
        within("dcc:respPersons", [&] {
            person(head().authorisedBy.name, head().authorisedBy.function, true);
            if (!head().operatorName.empty())
                person(head().operatorName, m_english.text(REPORT_TEXT("report", "Operator")).toStdString(),
                       false);
        });
        contact("dcc:customer", head().customer.name, {}, {head().customer.address, head().customer.contact});
        within("dcc:statements", [&] { writeStatements(); });
    }

    void writeCore() {
        leaf("dcc:countryCodeISO3166_1", head().laboratory.country);
        for (const char *element : {"dcc:usedLangCodeISO639_1", "dcc:mandatoryLangCodeISO639_1"}) {
            for (const char *language : {"fr", "en"})
                leaf(element, std::string(language));
        }
        leaf("dcc:uniqueIdentifier", head().number + (head().revision.empty() ? "" : "-" + head().revision));
        leaf("dcc:beginPerformanceDate", *dayOf(document(), false));
        leaf("dcc:endPerformanceDate", *dayOf(document(), true));
        m_xml.writeStartElement(QStringLiteral("dcc:performanceLocation"));
        m_xml.writeAttribute(QStringLiteral("refId"), QString::fromLatin1(placeId)); // named there
        m_xml.writeCharacters(QStringLiteral("other"));
        m_xml.writeEndElement();
        if (head().date)
            leaf("dcc:issueDate", *head().date);
    }

    /// For machines and instruments alike.
    void writeMake(const std::string &manufacturer, const std::string &model,
                   const std::string &serialNumber) {
        if (!manufacturer.empty())
            said("dcc:manufacturer/dcc:name", manufacturer);
        leafIfStated("dcc:model", model);
        if (!serialNumber.empty())
            within("dcc:identifications/dcc:identification", [&] {
                leaf("dcc:issuer", QStringLiteral("manufacturer"));
                leaf("dcc:value", serialNumber);
                said("dcc:name", REPORT_TEXT("report", "Serial number"));
            });
    }

    void writeMachine() {
        const Machine &machine = document().machine;
        said("dcc:name", nameOf(machine));
        const auto details = [&](const Language &language) {
            return machineDetails(Writer(language), machine);
        };
        const QString condition = QString::fromStdString(machine.condition).trimmed();
        if (!details(m_english).isEmpty() || !condition.isEmpty())
            within("dcc:description", [&] {
                if (!details(m_english).isEmpty()) {
                    content(details(m_french), "fr");
                    content(details(m_english), "en");
                }
                if (!condition.isEmpty())
                    content(condition);
            });
        writeMake(machine.manufacturer, machine.model, machine.serialNumber);
    }

    void contact(const char *element, const std::string &name, const std::string &country,
                 std::initializer_list<std::string> further) {
        within(element, [&] {
            said("dcc:name", name);
            within("dcc:location", [&] {
                leafIfStated("dcc:countryCode", country);
                for (const std::string &text : further) {
                    if (!text.empty())
                        said("dcc:further", text);
                }
            });
        });
    }

    void person(const std::string &name, const std::string &role, bool signs) {
        within("dcc:respPerson", [&] {
            said("dcc:person/dcc:name", name);
            leafIfStated("dcc:role", role);
            leaf("dcc:mainSigner", std::string(signs ? "true" : "false"));
        });
    }

    void statement(const Text &name, const auto &text) {
        within("dcc:statement", [&] {
            said("dcc:name", name);
            said("dcc:declaration", text);
        });
    }

    void writeStatements() {
        statement(REPORT_TEXT("report", "Scope"),
                  both([](const Language &language) { return scopeText(Writer(language)); }));
        if (!coverageText(Writer(m_english), m_evaluated).isEmpty())
            statement(REPORT_TEXT("report", "Expanded uncertainty"), both([&](const Language &language) {
                          return coverageText(Writer(language), m_evaluated);
                      }));
        m_xml.writeStartElement(QStringLiteral("dcc:statement"));
        m_xml.writeAttribute(QStringLiteral("id"), QString::fromLatin1(placeId));
        said("dcc:name", REPORT_TEXT("report", "Place"));
        within("dcc:location", [&] { said("dcc:further", head().place); });
        m_xml.writeEndElement();
        const std::array stated{
            std::pair{REPORT_TEXT("report", "Title of the report"), head().title},
            std::pair{REPORT_TEXT("report", "Supplier"), partyText(head().supplier).toStdString()},
            std::pair{REPORT_TEXT("report", "Order"), head().order},
            std::pair{REPORT_TEXT("report", "Procedure"), head().procedure},
            std::pair{REPORT_TEXT("report", "Deviations from the method"), head().deviationsFromMethod},
            std::pair{REPORT_TEXT("report", "Adjustments made"), head().adjustments},
            std::pair{REPORT_TEXT("report", "Reason of the revision"), head().revisionReason},
            std::pair{REPORT_TEXT("report", "Remarks"), head().remarks},
        };
        for (const auto &[name, text] : stated) {
            if (!QString::fromStdString(text).trimmed().isEmpty())
                statement(name, text);
        }
        if (!head().replaces.empty())
            statement(REPORT_TEXT("report", "Revision"), both([&](const Language &language) {
                          return language.sentence(REPORT_TEXT("report", "replaces %1"), {head().replaces});
                      }));
    }

    // ---- A test ----

    void writeTest(std::size_t index) {
        const Test &test = *document().tests[index];
        const TestEvaluation &evaluation = *m_evaluated.tests[index];
        said("dcc:name", both([&](const Language &language) { return testName(Writer(language), test); }));
        describe({test.title, test.remarks});
        if (evaluation.edition)
            within("dcc:usedMethods/dcc:usedMethod", [&] { writeMethod(test, *evaluation.edition); });
        writeInstruments(test);
        writeConditions(index);
        within("dcc:results", [&] { writeResults(index); });
        if (evaluation.edition)
            within("dcc:measurementMetaData", [&] {
                writeConformity(test, evaluation);
                writeFindings(index);
                writeAgreements(index);
                writeOrigin(test);
            });
    }

    void writeMethod(const Test &test, const Edition &edition) {
        said("dcc:name", both([&](const Language &language) {
                 return language.text(edition.title.empty() ? kindWords(test).listed : edition.title)
                     .replace(QLatin1StringView("%1"), QString::fromStdString(axesOf(test)));
             }));
        leaf("dcc:norm", std::string(edition.word));
        leafIfStated("dcc:reference", head().procedure);
    }

    void writeInstruments(const Test &test) {
        std::vector<const Instrument *> used;
        for (const Instrument &instrument : document().instruments) {
            if (std::ranges::find(test.instruments, instrument.id) != test.instruments.end())
                used.push_back(&instrument);
        }
        if (used.empty())
            return;
        within("dcc:measuringEquipments", [&] {
            for (const Instrument *instrument : used)
                within("dcc:measuringEquipment", [&] { writeInstrument(*instrument, test); });
        });
    }

    void writeInstrument(const Instrument &instrument, const Test &test) {
        said("dcc:name", !instrument.description.empty() ? instrument.description
                         : !instrument.model.empty()     ? instrument.model
                                                         : instrument.id);
        const Both traced = both([&](const Language &language) {
            const Writer write(language);
            return joined(
                {traceabilityText(write, instrument),
                 labelled(write, REPORT_TEXT("report", "Due"), dateText(write, instrument.calibrationDue))});
        });
        if (!traced.english.isEmpty())
            said("dcc:description", traced);
        writeMake(instrument.manufacturer, instrument.model, instrument.serialNumber);
        if (instrument.resolution)
            within("dcc:measuringEquipmentQuantities/dcc:measuringEquipmentQuantity", [&] {
                said("dcc:name", REPORT_TEXT("report", "Resolution"));
                real(*instrument.resolution, deviationQuantity(test));
            });
    }

    /// "Temperature: machine"; the label alone without a text.
    static QString labelled(const Writer &write, const Text &label, const QString &text) {
        return text.isEmpty() ? text : write.say(nameAndText, {label, text.toStdString()});
    }

    void condition(const Both &name, const auto &data) {
        within("dcc:influenceCondition", [&] {
            said("dcc:name", name);
            within("dcc:data", data);
        });
    }

    /// The mean of several sensors, then each of them with its position.
    void writeTemperatures(const Conditions &conditions, SensorMeasures what) {
        std::vector<const Sensor *> sensors;
        for (const Sensor &sensor : conditions.sensors) {
            if (sensor.measures == what)
                sensors.push_back(&sensor);
        }
        if (sensors.size() > 1)
            writeTemperature(temperaturesOf(conditions, what), what, {});
        for (const Sensor *sensor : sensors)
            writeTemperature({startTemperature(*sensor), endTemperature(*sensor)}, what, sensor->position);
    }

    void writeTemperature(const Temperatures &of, SensorMeasures what, const std::string &position) {
        if (!of.start && !of.end && isBlank(position))
            return;
        const auto name = [&](const Language &language) {
            return joined(
                {language.sentence(nameAndText, {REPORT_TEXT("report", "Temperature"), sensorText(what)}),
                 QString::fromStdString(position)});
        };
        condition(both(name), [&] {
            if (!of.start && !of.end)
                said("dcc:text", REPORT_TEXT("report", "not stated"));
            for (const auto &[words, value] : {std::pair{REPORT_TEXT("report", "Start"), of.start},
                                               std::pair{REPORT_TEXT("report", "End"), of.end}}) {
                if (value) // a mean of decimals may have a rounding error
                    quantity(words, std::round(*value * 1e6) / 1e6, Quantity::temperature);
            }
        });
    }

    void writeDate(const Test &test) {
        if (test.date)
            condition(both(REPORT_TEXT("report", "Date of test")), [&] {
                said("dcc:text", both([&](const Language &language) {
                         return joined(
                             {language.date(*test.date), QString::fromStdString(test.time.value_or(""))});
                     }));
            });
    }

    void writeExpansion(const Text &name, const std::optional<double> &coefficient) {
        if (coefficient)
            condition(both(name), [&] { quantity(name, *coefficient, Quantity::expansion); });
    }

    /// Returns the English names of what it wrote.
    QStringList writeNumbers(const Test &test) {
        QStringList names;
        for (const std::string_view key : conditionKeys(test)) {
            const FieldValue value = fieldValue(test, key);
            const auto *number = std::get_if<std::optional<double>>(&value);
            const StatedThing *thing = statedThing(key);
            if (!number || !*number || !thing || !thing->form.quantity)
                continue;
            names << m_english.text(thing->name);
            condition(both(thing->name),
                      [&] { quantity(thing->name, **number, quantityOf(*thing, motionOf(test))); });
        }
        return names;
    }

    /// The conditions of a test as the report says them, with its path or axis.
    [[nodiscard]] std::vector<KeyValue> rowsIn(const Writer &write, std::size_t index) const {
        const Test &test = *document().tests[index];
        const TestEvaluation &evaluation = *m_evaluated.tests[index];
        const TestPart part{write, m_evaluated, test, evaluation, index};
        std::vector<KeyValue> rows = conditionRows(part).rows;
        KeyValues own;
        if (const auto *circle = std::get_if<CircularMeasurement>(&test.measurement))
            own = parameterRows({part, *circle, resultsOf(*circle, evaluation)});
        if (const auto *axis = std::get_if<PositioningMeasurement>(&test.measurement))
            own = axisRows({part, *axis, resultsOf(*axis, evaluation)});
        rows.insert(rows.begin(), own.rows.begin(), own.rows.end());
        return rows;
    }

    /// The conditions in words, without those that are numbers.
    void writeWords(std::size_t index, const QStringList &numbers) {
        const Writer french(m_french);
        const Writer english(m_english);
        const std::vector<KeyValue> there = rowsIn(french, index);
        const std::vector<KeyValue> here = rowsIn(english, index);
        for (std::size_t i = 0; i < std::min(there.size(), here.size()); ++i) {
            if (!here[i].value.isEmpty() && !numbers.contains(here[i].key))
                condition({there[i].key, here[i].key}, [&] {
                    said("dcc:text", Both{there[i].value, here[i].value});
                });
        }
    }

    void writeSampleIntervals(const CircularMeasurement &circle) {
        for (const Arc &arc : circle.arcs) {
            const auto name = both([&](const Language &language) {
                return language.sentence(nameAndText, {REPORT_TEXT("report", "Sampling interval"),
                                                       iso230_4::axisIndex(circle.plane, arc.sense)});
            });
            if (arc.sampleInterval)
                condition(name, [&] {
                    quantity(REPORT_TEXT("report", "Sampling interval"), *arc.sampleInterval, Quantity::time);
                });
        }
    }

    void writeExcluded(const Test &test, const Edition &edition) {
        const auto *axis = std::get_if<PositioningMeasurement>(&test.measurement);
        if (axis && !axis->excluded.empty())
            condition(both(REPORT_TEXT("report", "Excluded readings")), [&] {
                said("dcc:text",
                     both([&](const Language &language) { return excludedText(edition, *axis, language); }));
            });
    }

    /// Numbers as such; all other conditions in the words of the report.
    void writeConditions(std::size_t index) {
        const Test &test = *document().tests[index];
        const Conditions *conditions = m_evaluated.tests[index]->edition ? conditionsOf(test) : nullptr;
        if (!conditions && !test.date)
            return;
        within("dcc:influenceConditions", [&] {
            writeDate(test);
            if (!conditions)
                return;
            for (std::size_t what = 0; what < kindsOfSensors; ++what)
                writeTemperatures(*conditions, static_cast<SensorMeasures>(what));
            const auto &[machine, instrument] = conditions->expansion;
            writeExpansion(REPORT_TEXT("report", "α machine"), machine);
            writeExpansion(REPORT_TEXT("report", "α instrument"), instrument);
            const QStringList numbers = writeNumbers(test);
            condition(both(REPORT_TEXT("report", "Correction to 20 °C")),
                      [&] { said("dcc:text", correctionText(test)); });
            if (const auto *circle = std::get_if<CircularMeasurement>(&test.measurement))
                writeSampleIntervals(*circle);
            writeWords(index, numbers);
            writeExcluded(test, *m_evaluated.tests[index]->edition);
        });
    }

    /// "3↓ (j = 1): 95.4 µm; beam interrupted", a line a reading.
    static QString excludedText(const Edition &edition, const PositioningMeasurement &measurement,
                                const Language &language) {
        QStringList lines;
        for (const ExcludedReading &reading : measurement.excluded) {
            const std::string name =
                iso230_2::readingName(edition, measurement, static_cast<std::size_t>(reading.run) - 1,
                                      static_cast<std::size_t>(reading.target) - 1);
            lines << QStringLiteral("%1: %2; %3")
                         .arg(QString::fromStdString(name),
                              language.quantity(reading.value, deviationQuantity(measurement.axis)),
                              QString::fromStdString(reading.reason));
        }
        return lines.join(u'\n');
    }

    // ---- Results ----

    /// E_VE of each channel; false if there is none.
    bool writeDrift(const Test &test) {
        const auto *drift = std::get_if<DriftMeasurement>(&test.measurement);
        bool any = false;
        for (const DriftChannel &channel : drift ? channelsOf(*drift) : std::vector<DriftChannel>()) {
            const auto whole = variationOf(drift->times, channel.values, std::nullopt);
            if (!whole)
                continue;
            any = true;
            const Both name = drift->channels.size() > 1 ? both([&](const Language &language) {
                return language.sentence(REPORT_TEXT("report", "E_VE of %1, whole record"), {channel.name});
            })
                                                         : both(REPORT_TEXT("report",
                                                                            "Environmental variation E_VE"));
            quantity(name, whole->value, deviationQuantity(channel));
        }
        return any;
    }

    void writeResults(std::size_t index) {
        const Test &test = *document().tests[index];
        const TestEvaluation &evaluation = *m_evaluated.tests[index];
        within("dcc:result", [&] {
            said("dcc:name", REPORT_TEXT("report", "Results"));
            within("dcc:data", [&] {
                for (const Parameter &parameter : evaluation.parameters) {
                    if (parameter.required || parameter.limit)
                        within("dcc:quantity", [&] { writeParameter(parameter, test, evaluation); });
                }
                const bool isDrifting = writeDrift(test);
                if (!isDrifting && evaluation.parameters.empty())
                    said("dcc:text", REPORT_TEXT("report", "no results"));
            });
        });
        const auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
        if (measurement && !measurement->targets.empty())
            within("dcc:result", [&] { writeTargets(*measurement, evaluation); });
        if (evaluation.edition && usesBudget(evaluation) &&
            !partOf(index, Writer(m_english)).leavesOut(ReportPart::uncertainty))
            within("dcc:result", [&] {
                said("dcc:name", REPORT_TEXT("report", "Uncertainty budget"));
                if (!kindWords(test).budget.empty())
                    said("dcc:description", kindWords(test).budget);
                within("dcc:data", [&] { writeBudget(test, evaluation); });
            });
        writeImportedResults(test);
    }

    /// Results stated by the programs of the instruments, for comparison.
    void writeImportedResults(const Test &test) {
        const auto any = [](const ImportedFile &file) { return !file.results.empty(); };
        if (std::ranges::none_of(test.imports, any))
            return;
        within("dcc:result", [&] {
            said("dcc:name", REPORT_TEXT("report", "Result stated by the instrument’s program"));
            within("dcc:data", [&] {
                for (const ImportedFile &file : test.imports) {
                    for (const ImportedResult &stated : file.results)
                        within("dcc:quantity", [&] {
                            said("dcc:name", stated.name.empty() ? file.fileName : stated.name);
                            writeSheetNumber(stated.value, {}, stated.unit);
                        });
                }
            });
        });
    }

    [[nodiscard]] TestPart partOf(std::size_t index, const Writer &write) const {
        return {write, m_evaluated, *document().tests[index], *m_evaluated.tests[index], index};
    }

    /// Expanded, k = 2, with what they are computed from; what is not known is said.
    void writeBudget(const Test &test, const TestEvaluation &evaluation) {
        if (motionOf(test) == Motion::linear && evaluation.uncertainty.length)
            quantity(REPORT_TEXT("report", "Length L"), *evaluation.uncertainty.length, Quantity::position);
        for (const Contribution &contribution : evaluation.uncertainty.contributions)
            within("dcc:quantity", [&] {
                said("dcc:name", contribution.name);
                if (!contribution.expanded) {
                    said("dcc:noQuantity", REPORT_TEXT("report", "not stated"));
                    return;
                }
                said("dcc:description",
                     both([&](const Language &language) { return language.sentence(contribution.inputs); }));
                real(*contribution.expanded, deviationQuantity(test));
            });
    }

    void writeParameter(const Parameter &parameter, const Test &test, const TestEvaluation &evaluation) {
        said("dcc:name", parameter.term.name);
        const std::string symbol = plainSymbol(parameter);
        if (!parameter.value || !std::isfinite(*parameter.value)) {
            said("dcc:noQuantity", both([&](const Language &language) {
                     return language.sentence(
                         nameAndText,
                         {symbol, REPORT_TEXT_FOR("report", "no value", "why a limit cannot be evaluated")});
                 }));
        } else {
            real(*parameter.value, parameter.term.quantity, symbol, &parameter);
        }
        if (parameter.limit && parameter.limit->value)
            within("dcc:measurementMetaData/dcc:metaData", [&] {
                said("dcc:name", limitWord);
                leaf("dcc:convention", std::string(fileWord(test.decisionRule.rule)));
                leaf("dcc:norm", parameter.limit->edition.value_or(evaluation.edition->word));
                leafIfStated("dcc:reference", parameter.limit->source);
                if (parameter.verdict && parameter.value)
                    leaf("dcc:conformity", std::string(conformityOf(parameter)));
                within("dcc:data",
                       [&] { quantity(limitWord, *parameter.limit->value, parameter.term.quantity); });
            });
    }

    void writeUncertainty(const Parameter &parameter) {
        const auto coverage = coverageOfU(parameter);
        if (!coverage || !std::isfinite(*parameter.expandedUncertainty))
            return;
        within("si:expandedUnc", [&] {
            leaf("si:uncertainty",
                 Decimal(*parameter.expandedUncertainty, parameter.term.quantity).shortest());
            leaf("si:coverageFactor", Decimal(coverage->factor).rounded(coverage->factor == 2 ? 0 : 4));
            leaf("si:coverageProbability", Decimal(coverage->probability).shortest());
        });
    }

    void writeTargets(const PositioningMeasurement &measurement, const TestEvaluation &evaluation) {
        const auto &results = std::get<PositioningResults>(evaluation.results);
        const auto list = [&](const Text &name, const QString &label, Quantity quantity,
                              const auto &valueOf) {
            QStringList values;
            for (std::size_t i = 0; i < measurement.targets.size(); ++i) {
                const std::optional<double> value = valueOf(i);
                if (!value || !std::isfinite(*value))
                    return; // lists have no gaps
                values << QString::fromStdString(Decimal(*value, quantity).shortest());
            }
            within("dcc:quantity", [&] {
                said("dcc:name", both([&](const Language &language) {
                         return joined({language.text(name), label}, QStringLiteral(" "));
                     }));
                within("si:realListXMLList", [&] {
                    leaf("si:valueXMLList", values.join(u' '));
                    leaf("si:unitXMLList", std::string(dsiUnit(quantity)));
                });
            });
        };
        said("dcc:name", REPORT_TEXT("report", "Results per target position"));
        within("dcc:data/dcc:list", [&] {
            list(REPORT_TEXT("report", "Target positions"), {}, positionQuantity(measurement.axis),
                 [&](std::size_t i) { return std::optional(measurement.targets[i]); });
            for (const TargetTerm &term : evaluation.edition->targetTerms) {
                if (isShown(term, results))
                    list(term.name, symbolPhrase(term.symbol).plain(), deviationQuantity(measurement.axis),
                         [&](std::size_t i) {
                             return targetValue(term.id, results.targets[i], evaluation.edition->c);
                         });
            }
        });
    }

    // ---- Acceptance sheet ----

    /// A number with a unit that the user typed: as such if it is a length or an angle, else in words.
    void writeSheetNumber(double value, std::optional<double> uncertainty, const std::string &unit) {
        const auto known =
            std::ranges::find(typedUnits, unit, &std::pair<std::string_view, const char *>::first);
        if (known == typedUnits.end()) {
            said("dcc:noQuantity",
                 joined({QString::fromStdString(shortest(value)), QString::fromStdString(unit)},
                        QStringLiteral(" "))
                         .toStdString() +
                     (uncertainty ? ", U = " + shortest(*uncertainty) : std::string()));
            return;
        }
        within("si:real", [&] {
            leaf("si:value", shortest(value));
            leaf("si:unit", std::string(known->second));
            if (uncertainty)
                within("si:expandedUnc", [&] {
                    leaf("si:uncertainty", shortest(*uncertainty));
                    leaf("si:coverageFactor", std::string("2"));
                    leaf("si:coverageProbability", Decimal(Coverage{}.probability).shortest());
                });
        });
    }

    void writeSheet() {
        const std::vector<SheetResult> results = m_evaluated.sheet();
        said("dcc:name", REPORT_TEXT("report", "Acceptance sheet"));
        within("dcc:results/dcc:result", [&] {
            said("dcc:name", REPORT_TEXT_FOR("report", "Checks", "of the acceptance sheet"));
            within("dcc:data", [&] {
                for (std::size_t i = 0; i < results.size(); ++i)
                    within("dcc:quantity", [&] { writeSheetRow(head().sheet[i], results[i]); });
            });
        });
        const std::optional<Verdict> verdict = verdictOf(results);
        within("dcc:measurementMetaData/dcc:metaData", [&] {
            said("dcc:name", REPORT_TEXT("report", "Acceptance sheet"));
            leaf("dcc:convention", std::string(fileWord(head().decisionRule.rule)));
            said("dcc:declaration", both([&](const Language &language) {
                     const VerdictStatement said = sheetStatement(m_evaluated, Writer(language));
                     return joined(
                         {said.state + u'.', said.text.plain(), ruleText(head().decisionRule, language)},
                         QStringLiteral(" "));
                 }));
            if (verdict)
                leaf("dcc:conformity", std::string(conformityWord(*verdict)));
        });
    }

    void writeSheetRow(const SheetRow &row, const SheetResult &result) {
        const std::string unit = result.parameter ? resultUnit(result.parameter->term.quantity) : row.unit;
        const std::string name =
            joined({QString::fromStdString(row.number), QString::fromStdString(row.object)},
                   QStringLiteral(" "))
                .toStdString();
        if (name.empty())
            said("dcc:name", REPORT_TEXT_FOR("report", "Object", "of the acceptance sheet"));
        else
            said("dcc:name", name);
        if (result.value)
            writeSheetNumber(*result.value, result.uncertainty, unit);
        else
            said("dcc:noQuantity", sheetStateText(result.state));
        within("dcc:measurementMetaData/dcc:metaData", [&] {
            said("dcc:name", REPORT_TEXT("report", "Tolerance"));
            said("dcc:declaration", both([&](const Language &language) {
                     const SheetWords words =
                         sheetWords(m_evaluated, {}, result,
                                    static_cast<std::size_t>(&row - head().sheet.data()), Writer(language));
                     return joined(
                         {words.permitted.isEmpty() ? QString() : words.permitted + u' ' + words.unit,
                          words.state, words.source, QString::fromStdString(row.notApplicable),
                          QString::fromStdString(row.instrument), QString::fromStdString(row.standard),
                          QString::fromStdString(row.remark)});
                 }));
            if (result.state <= SheetState::doesNotConform)
                leaf("dcc:conformity", std::string(conformityOf(result)));
        });
    }

    // ---- Conformity ----

    void writeConformity(const Test &test, const TestEvaluation &evaluation) {
        const Accordance accordance = evaluation.accordance();
        const bool judged = accordance == Accordance::yes || accordance == Accordance::partly;
        const LargeWord word = largeWord(evaluation.verdict, !evaluation.limits.empty(), accordance);
        within("dcc:metaData", [&] {
            said("dcc:name", REPORT_TEXT("report", "Verdict of the test"));
            leaf("dcc:convention", std::string(fileWord(test.decisionRule.rule)));
            leaf("dcc:norm", std::string(evaluation.edition->word));
            said("dcc:declaration", both([&](const Language &language) {
                     return joined({language.text(word.word) + u'.',
                                    accordanceText(test, evaluation, language, false),
                                    ruleText(test.decisionRule, language)},
                                   QStringLiteral(" "));
                 }));
            if (judged && evaluation.verdict)
                leaf("dcc:conformity", std::string(conformityWord(*evaluation.verdict)));
        });
        for (const AgreedLimit &limit : evaluation.limits) {
            if (limit.state != LimitState::notEvaluable)
                continue; // stands with its result
            within("dcc:metaData", [&] {
                said("dcc:name", both([&](const Language &language) {
                         return language.text(limitWord) + u' ' + QString::fromStdString(limit.symbol);
                     }));
                leaf("dcc:norm", limit.limit.edition.value_or(evaluation.edition->word));
                leafIfStated("dcc:reference", limit.limit.source);
                said("dcc:declaration", both([&](const Language &language) {
                         return notEvaluableSentence(evaluation, language);
                     }));
                within("dcc:data", [&] { quantity(limitWord, *limit.limit.value, deviationQuantity(test)); });
            });
        }
    }

    /// Requirements and recommendations of the text that the test does not fulfil.
    void writeFindings(std::size_t index) {
        const TestEvaluation &evaluation = *m_evaluated.tests[index];
        if (partOf(index, Writer(m_english)).leavesOut(ReportPart::findings))
            return;
        const FindingsBlock there = findingLines(evaluation, m_french, FindingsOf::text);
        const FindingsBlock here = findingLines(evaluation, m_english, FindingsOf::text);
        for (std::size_t i = 0; i < here.lines.size(); ++i)
            within("dcc:metaData", [&] {
                said("dcc:name", Both{there.lines[i].gradeName, here.lines[i].gradeName});
                leaf("dcc:norm", std::string(evaluation.edition->word));
                leafIfStated("dcc:reference", here.lines[i].clause.toStdString());
                said("dcc:declaration",
                     Both{there.lines[i].sentence.plain(), here.lines[i].sentence.plain()});
            });
    }

    /// The points to be agreed, each with its agreement and its text.
    void writeAgreements(std::size_t index) {
        const auto there = agreedPointsOf(partOf(index, Writer(m_french)));
        const auto here = agreedPointsOf(partOf(index, Writer(m_english)));
        for (std::size_t i = 0; here && i < here->table.rows.size(); ++i) {
            const auto &french = there->table.rows[i];
            const auto &english = here->table.rows[i];
            const std::size_t keys = here->keys;
            const auto cell = [&](std::size_t k) {
                return Both{french[k].text.plain(), english[k].text.plain()};
            };
            within("dcc:metaData", [&] {
                said("dcc:name", cell(keys - 1));
                const Both agreement = cell(keys);
                const Both text = cell(keys + 1);
                said("dcc:declaration", Both{joined({agreement.french, text.french}),
                                             joined({agreement.english, text.english})});
            });
        }
    }

    /// The files that the readings come from.
    void writeOrigin(const Test &test) {
        for (const ImportedFile &file : test.imports)
            within("dcc:metaData", [&] {
                said("dcc:name", REPORT_TEXT("report", "Origin of the data"));
                said("dcc:declaration",
                     joined({QString::fromStdString(file.fileName),
                             QStringLiteral("SHA-256 ") + QString::fromStdString(file.sha256)})
                         .toStdString());
            });
    }

    QXmlStreamWriter m_xml;
    const EvaluatedDocument &m_evaluated;
    Language m_french{Language::Id::french};
    Language m_english{Language::Id::english};
};

} // namespace

std::vector<Text> missingForDcc(const EvaluatedDocument &evaluated) {
    const Document &document = *evaluated.document;
    const ReportHead &head = document.report;
    const Machine &machine = document.machine;
    const std::array obliged{
        std::pair{REPORT_TEXT("report", "number of the report"), head.number},
        std::pair{REPORT_TEXT("report", "name of the laboratory"), head.laboratory.name},
        std::pair{REPORT_TEXT("report", "country of the laboratory"), head.laboratory.country},
        std::pair{REPORT_TEXT("report", "who authorises the report"), head.authorisedBy.name},
        std::pair{REPORT_TEXT("report", "customer with address"),
                  head.customer.name.empty() ? "" : head.customer.address},
        std::pair{REPORT_TEXT("report", "place of the tests"), head.place},
        std::pair{REPORT_TEXT("report", "date of the test"), dayOf(document, false).value_or("")},
        std::pair{REPORT_TEXT("report", "name of the machine"), nameOf(machine)},
        std::pair{REPORT_TEXT("report", "manufacturer of the machine"), machine.manufacturer},
        std::pair{REPORT_TEXT("report", "serial number of the machine"), machine.serialNumber},
        std::pair{REPORT_TEXT("report", "a test"), std::string(document.tests.empty() ? "" : "1")},
    };
    std::vector<Text> result;
    for (const auto &[name, value] : obliged) {
        if (QString::fromStdString(value).trimmed().isEmpty())
            result.push_back(name);
    }
    bool simulationDue = false;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i)
        simulationDue = simulationDue || isSimulationDue(evaluated, i, SimulateWhich::monteCarloOnly);
    if (simulationDue)
        result.push_back(REPORT_TEXT("report", "U after the simulation"));
    return result;
}

void requireForDcc(const EvaluatedDocument &evaluated, const Language &language) {
    QStringList names;
    for (const Text &name : missingForDcc(evaluated))
        names << language.text(name);
    if (!names.isEmpty())
        throw Error(Error::Kind::content,
                    {REPORT_TEXT("report", "a digital calibration certificate must also state: %1"),
                     {names.join(QStringLiteral(", ")).toStdString()},
                     {}});
}

const char *dsiUnit(Quantity quantity) {
    return inOrder(quantity,
                   {R"(\one)", R"(\one)", R"(\milli\metre)", R"(\degree)", R"(\micro\metre)", R"(\arcsecond)",
                    R"(\micro\metre)", R"(\arcsecond)", R"(\degreecelsius)",
                    R"(\degreecelsius\hour\tothe{-1})", R"(\micro\metre\metre\tothe{-1}\kelvin\tothe{-1})",
                    R"(\milli\metre\minute\tothe{-1})", R"(\degree\minute\tothe{-1})", R"(\second)",
                    R"(\hecto\pascal)", R"(\percent)"});
}

QByteArray dcc(const EvaluatedDocument &evaluated) {
    EvaluatedDocument visible = evaluated;
    visible.document = withVisibleTexts(evaluated.document, writeDocument(*evaluated.document));
    QByteArray bytes;
    DccWriter(bytes, visible).write();
    return bytes;
}

} // namespace palmer
