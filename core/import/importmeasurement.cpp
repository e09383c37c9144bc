// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/importmeasurement.h"

#include "document/bounds.h"
#include "document/edits.h"
#include "document/filewords.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/sha256.h"
#include "document/testfile.h"
#include "document/windowthread.h"
#include "import/formats.h"
#include "import/layouts/headings.h"
#include "import/question.h"
#include "import/readers.h"
#include "kernel/measurement/testfacts.h"
#include "system/filename.h"
#include "tables/dates.h"
#include "tables/decodetext.h"
#include "tables/folded.h"
#include "tables/numbercell.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace palmer {

namespace {

bool isUtf16(QByteArrayView bytes) {
    return bytes.startsWith("\xFF\xFE") || bytes.startsWith("\xFE\xFF");
}

/// The text for keyword searches; readers decode the bytes themselves. Empty if they are not text.
QByteArray inUtf8(QByteArrayView bytes) {
    try {
        return QByteArray::fromStdString(decodeText(bytes).text);
    } catch (const Error &) {
        return {};
    }
}

const ImportFormat &formatOf(QByteArrayView bytes, const ImportOptions &options) {
    const auto chosen = options.find("format");
    const QByteArray plain = isUtf16(bytes) ? inUtf8(bytes) : QByteArray();
    for (const ImportFormat *format : importFormats()) {
        if (chosen != options.end() ? chosen->second == format->word
                                    : format->recognises(bytes) || format->recognises(plain))
            return *format;
    }
    return *importFormats().back();
}

CorrectionTo20 correctionOf(std::string_view word) {
    if (word == "not applied")
        return CorrectionTo20::notApplied;
    if (word == "applied by the instrument")
        return CorrectionTo20::appliedByInstrument;
    return word == "applied here" ? CorrectionTo20::appliedHere : CorrectionTo20::notStated;
}

/// True if a correction to 20 °C could change the result: long targets, and temperatures are known.
bool couldMatter(const Imported &imported) {
    constexpr double isLong = 100; // mm
    const Conditions &conditions = *conditionsOf(*imported.test);
    const bool isWarm = !imported.sensors.empty() || !conditions.sensors.empty() ||
                        conditions.expansion.machine || conditions.expansion.instrument;
    const auto *axis = std::get_if<PositioningMeasurement>(&imported.test->measurement);
    const auto *circle = std::get_if<CircularMeasurement>(&imported.test->measurement);
    const double length = axis && !axis->targets.empty() ? axis->targets.back() - axis->targets.front()
                          : circle                       ? 2 * circle->nominalRadius
                                                         : 0;
    return isWarm && length > isLong && motionOf(*imported.test) == Motion::linear;
}

/// Asks if the instrument has corrected to 20 °C where that matters; never assumed.
void resolveCorrection(Imported &imported, Choices &choices) {
    Conditions *conditions = imported.test ? conditionsOf(*imported.test) : nullptr;
    if (!conditions)
        return;
    const CorrectionTo20 stated = conditions->correctionTo20; // by a file whose format can state it
    const auto choice =
        choices.resolve("correctionTo20", fileWord(stated),
                        stated == CorrectionTo20::notStated ? Origin::guessed : Origin::recognised);
    if (choice.value == "not stated")
        imported.remarks.add(
            couldMatter(imported) ? RemarkGrade::assumption : RemarkGrade::note, "correctionTo20",
            {REPORT_TEXT("report", "Correction to 20 °C: "
                                   "whether the instrument has applied one is not stated; say it.")});
    conditions->correctionTo20 = correctionOf(choice.value);
}

constexpr double largestNumber = 1e9; ///< mm, degrees, s

bool hasSense(const std::vector<double> &values) {
    return std::ranges::all_of(values, [](double value) { return std::abs(value) <= largestNumber; });
}

/// Targets must also differ in mm.
bool hasSense(const PositioningMeasurement &measurement) {
    const auto sensible = [](const auto &value) { return !value || std::abs(*value) <= largestNumber; };
    return hasSense(measurement.targets) &&
           std::ranges::adjacent_find(measurement.targets, std::ranges::greater_equal()) ==
               measurement.targets.end() &&
           std::ranges::all_of(measurement.runs,
                               [&](const Run &run) { return std::ranges::all_of(run.deviations, sensible); });
}

bool hasSense(const CircularMeasurement &measurement) {
    return measurement.nominalRadius > 0 && measurement.nominalRadius <= largestNumber &&
           measurement.feed.value_or(0) <= largestNumber &&
           std::ranges::all_of(measurement.arcs, [](const Arc &arc) {
               return hasSense(arc.angles) && hasSense(arc.radialDeviations);
           });
}

bool hasSense(const DriftMeasurement &measurement) {
    return hasSense(measurement.times) && hasSense(measurement.deviations);
}

/// Throws Error for numbers beyond any machine, as files may hold any number.
void requireSense(const Test &test) {
    if (!std::visit([](const auto &measurement) { return hasSense(measurement); }, test.measurement))
        refuseContent(REPORT_TEXT(
            "report", "there are numbers in it that no machine has; check units and decimal mark"));
}

/// Hours of the series before the test; null if one of the two is not dated.
std::optional<double> hoursBefore(const Test &test, const Imported &imported) {
    const auto date = test.date ? dayOf(*test.date) : std::nullopt;
    const auto time = test.time ? clockTime(*test.time) : std::nullopt;
    if (!date || !time || !imported.seriesStart)
        return std::nullopt;
    constexpr double hour = 3600;
    const double start = static_cast<double>(*date) * 24 * hour + *time;
    return std::max(0.0, std::floor((start - *imported.seriesStart) / hour * 100 + 1e-6) / 100);
}

void addTemperatures(Test &test, const Imported &imported, const ImportedFile &file) {
    Conditions *conditions = conditionsOf(test);
    if (!conditions)
        return;
    conditions->sensors.insert(conditions->sensors.end(), imported.sensors.begin(), imported.sensors.end());
    const auto takeGradient = [&](auto &measurement) {
        if constexpr (requires { measurement.conditions.gradientPerHour; }) {
            measurement.conditions.gradientPerHour = imported.gradientPerHour;
            measurement.conditions.gradientHoursBefore = hoursBefore(test, imported);
        }
    };
    if (imported.gradientPerHour)
        std::visit(takeGradient, test.measurement);
    test.imports.push_back(file);
}

template <class Named>
std::string freeId(const std::string &wish, const std::vector<Named> &taken) {
    const auto idOf = [](const auto &each) -> const std::string & {
        if constexpr (requires { each.id; })
            return each.id;
        else
            return each->id;
    };
    std::string id = wish;
    for (int n = 2; std::ranges::any_of(taken, [&](const auto &each) { return idOf(each) == id; }); ++n)
        id = wish + std::to_string(n);
    return id;
}

std::string wishedId(const Test &test) {
    std::string name = isJudged(test) ? axesOf(test) : fileWord(kindOf(test));
    if (name.empty() && axisOf(test))
        name = "axis";
    return lowerCase(name);
}

/// Throws Error if a test file cannot store the data: texts and readings have bounds.
void requireStorable(const Imported &imported) {
    Document document;
    document.machine = imported.machine;
    document.report.operatorName = imported.operatorName;
    document.instruments = imported.instruments;
    if (imported.test) // checked, not stored
        document.tests.push_back(std::shared_ptr<const Test>(std::shared_ptr<const Test>(), &*imported.test));
    Test measured = testOf(Kind::positioning);
    conditionsOf(measured)->sensors = imported.sensors;
    document.tests.push_back(std::make_shared<const Test>(std::move(measured)));
    requireBounds(document);
}

/// Throws Error if the user chose another kind than the reader's: most instrument files have only one.
void requireKind(const Imported &imported, const Choices &choices) {
    const char *kind = "temperatures";
    if (imported.test)
        kind = fileWord(kindOf(*imported.test));
    if (choices.isChosen("kind") && choices.chosen("kind") != kind)
        refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("kind"),
                      nameOfWord("kind", choices.chosen("kind")), nameOfWord("kind", kind));
}

/// Reads the bytes; on an Error sets `refusal` and keeps what was found before.
void readInto(Imported &imported, QByteArrayView bytes, const ImportFormat &format, Choices &choices) {
    try {
        format.read({bytes, choices.options()}, choices, imported);
        requireKind(imported, choices);
        if (imported.test)
            requireSense(*imported.test);
        resolveCorrection(imported, choices);
        requireStorable(imported);
        if (imported.test)
            questionNumbers(*imported.test, imported.remarks);
    } catch (const Error &error) {
        imported.refusal = error;
        imported.test.reset();
        imported.sensors.clear();
    }
    imported.choices = choices.take();
    joinRemarks(imported.remarks);
    const auto kind = imported.test ? std::optional(kindOf(*imported.test)) : std::nullopt;
    imported.questions = takeQuestions(imported.remarks, choices.options(), imported.choices, kind);
    std::ranges::stable_sort(imported.remarks, {}, &Remark::grade);
}

bool showsAnything(const Imported &imported) {
    return !imported.table.rows().empty() || !imported.text.empty() || !imported.sheets.empty();
}

/// The ID of an instrument, which is added to the document if unknown there.
std::string idAmong(std::vector<Instrument> &known, Instrument instrument) {
    const std::string wish = instrument.id.empty() ? "instrument" : instrument.id;
    instrument.id.clear();
    const auto same = std::ranges::find_if(known, [&](Instrument one) {
        one.id.clear();
        return one == instrument;
    });
    if (same != known.end())
        return same->id;
    instrument.id = freeId(wish, known);
    return known.emplace_back(std::move(instrument)).id;
}

} // namespace

Imported showMeasurement(QByteArrayView bytes, const QString &fileName, const ImportOptions &options,
                         const ImportOptions &usual) {
    requireKnown(options);
    requireReadable(bytes.size());
    if (isTestFile(bytes, fileName))
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report", "this is a test file or a report, not a measurement; "
                                       "open it instead"));
    const ImportFormat &format = formatOf(bytes, options);
    if (std::string_view(format.word) == "table" && !options.contains("format")) {
        refuseUndocumented(bytes, fileName);
        refuseCompensationTable(bytes, fileName);
    }
    Imported imported;
    imported.format = format.word;
    Choices choices(options, usual);
    choices.resolve("format", format.word, Origin::recognised);
    readInto(imported, bytes, format, choices);
    requireBackground(imported.test ? readingsOf(*imported.test) : imported.table.rows().size());
    if (imported.refusal && !showsAnything(imported))
        throw Error(*imported.refusal);
    return imported;
}

Imported importMeasurement(QByteArrayView bytes, const QString &fileName, const ImportOptions &options,
                           const ImportOptions &usual) {
    Imported imported = showMeasurement(bytes, fileName, options, usual);
    if (imported.refusal)
        throw Error(*imported.refusal);
    return imported;
}

namespace {

bool areStatedDifferently(const std::string &a, const std::string &b) {
    return !a.empty() && !b.empty() && folded(withoutBlanks(a)) != folded(withoutBlanks(b));
}

bool haveSameReadings(const Test &a, const Test &b) {
    const auto same = [](const auto &one, const auto &other) {
        using Kind = std::decay_t<decltype(one)>;
        if constexpr (!std::is_same_v<Kind, std::decay_t<decltype(other)>>)
            return false;
        else if constexpr (std::is_same_v<Kind, PositioningMeasurement>)
            return one.targets == other.targets && one.runs == other.runs;
        else if constexpr (std::is_same_v<Kind, CircularMeasurement>)
            return one.arcs == other.arcs;
        else
            return one == other;
    };
    return std::visit(same, a.measurement, b.measurement);
}

/// Throws if the document has the test of these bytes already. Another sheet of the file is another test.
void requireNew(const Document &document, const Test &test, const ImportedFile &file) {
    const auto isSame = [&](const TestPointer &known) {
        return haveSameReadings(*known, test) &&
               (known->imports.empty() ? known->remarks.find(file.sha256) != std::string::npos
                                       : known->imports.front().sha256 == file.sha256);
    };
    if (std::ranges::any_of(document.tests, isSame))
        refuseContent(REPORT_TEXT("report", "the readings of this file are there already; import it once"));
}

} // namespace

bool areOtherMachines(const Machine &a, const Machine &b) {
    const bool areNumbered = !a.serialNumber.empty() && !b.serialNumber.empty();
    return areNumbered ? areStatedDifferently(a.serialNumber, b.serialNumber)
                       : areStatedDifferently(a.name, b.name);
}

namespace {

ImportedFile importedFile(const Imported &imported, QByteArrayView bytes, const QString &fileName,
                          bool keepBytes, const std::string &hash) {
    ImportedFile file;
    if (imported.test && !imported.test->imports.empty())
        file = imported.test->imports.front(); // the instrument's results
    file.fileName = QFileInfo(shownFileName(fileName)).fileName().toStdString();
    file.sha256 = hash.empty() ? sha256(bytes) : hash;
    if (keepBytes)
        file.data = bytes.toByteArray().toBase64().toStdString();
    return file;
}

/// Fills what the document does not state of machine and operator; returns what it states differently.
std::string fillHead(Document &document, const Imported &imported) {
    std::string others;
    const auto keep = [&](const std::string &value) {
        if (!value.empty())
            others += (others.empty() ? "" : ", ") + value;
    };
    const auto fill = [&](std::string &field, const std::string &value) {
        if (field.empty())
            field = value;
        else if (areStatedDifferently(field, value))
            keep(value);
    };
    Machine &machine = document.machine;
    if (areOtherMachines(machine, imported.machine)) { // else two machines would become one
        keep(imported.machine.name);
        keep(imported.machine.serialNumber);
    } else {
        for (std::string Machine::*field :
             {&Machine::name, &Machine::manufacturer, &Machine::model, &Machine::serialNumber,
              &Machine::controller, &Machine::location, &Machine::condition})
            fill(machine.*field, imported.machine.*field);
        if (!machine.year)
            machine.year = imported.machine.year;
    }
    fill(document.report.operatorName, imported.operatorName);
    return others;
}

/// A file without a test: its temperatures join the tests that are there.
void addToTests(Document &document, const Imported &imported, const ImportedFile &file) {
    bool added = false;
    for (TestPointer &pointer : document.tests) {
        Test test = *pointer;
        addTemperatures(test, imported, file);
        added |= !(test == *pointer);
        pointer = std::make_shared<const Test>(std::move(test));
    }
    if (!added)
        refuseContent(REPORT_TEXT("report", "temperatures need a test "
                                            "that they belong to; import the measurement before them"));
}

void addRemark(Test &test, const std::string &remark) {
    test.remarks += (test.remarks.empty() ? "" : "\n") + remark;
}

/// True for a positioning test whose sign is only remarked, not asked, as the file does not state it.
bool hasAssumedSign(const Test &test, const Imported &imported) {
    return std::holds_alternative<PositioningMeasurement>(test.measurement) &&
           std::ranges::any_of(imported.remarks, [](const Remark &remark) {
               return remark.choice == "sign" && remark.grade == RemarkGrade::note;
           });
}

} // namespace

void addImported(Document &document, Imported imported, QByteArrayView bytes, const QString &fileName,
                 bool keepBytes, const std::string &hash) {
    ImportedFile file = importedFile(imported, bytes, fileName, keepBytes, hash);
    if (imported.test)
        requireNew(document, *imported.test, file);
    const std::string others = fillHead(document, imported);
    if (!imported.test) {
        addToTests(document, imported, file);
        return;
    }
    Test test = std::move(*imported.test);
    file.signAssumed = file.signAssumed || hasAssumedSign(test, imported);
    if (!others.empty())
        addRemark(test, file.fileName + ": " + others);
    test.id = freeId(wishedId(test), document.tests);
    test.imports = {file};
    if (!isJudged(test)) {
        test.imports.clear(); // the format stores no imports for drift tests
        addRemark(test, file.fileName + ", SHA-256 " + file.sha256);
    }
    test.instruments.clear();
    for (const Instrument &instrument : imported.instruments)
        test.instruments.push_back(idAmong(document.instruments, instrument));
    if (Conditions *conditions = conditionsOf(test))
        conditions->sensors.insert(conditions->sensors.end(), imported.sensors.begin(),
                                   imported.sensors.end());
    document.tests.push_back(std::make_shared<const Test>(std::move(test)));
}

Document readTests(const QString &path, std::vector<Message> &guesses) {
    const QByteArray bytes = readBytes(path);
    if (isTestFile(bytes, path))
        return readDocument(bytes);
    Imported imported = importMeasurement(bytes, path);
    for (const Remark &remark : imported.remarks) {
        if (remark.grade != RemarkGrade::note)
            guesses.push_back(remark.message);
    }
    for (const Question &question : imported.questions) {
        if (!question.canBeAssumed())
            refuseContent(REPORT_TEXT("report",
                                      "questions about this measurement are open that want an answer "
                                      "each; import it first"));
        guesses.push_back(question.sentence);
    }
    Document document;
    addImported(document, std::move(imported), bytes, path, false);
    return document;
}

} // namespace palmer
