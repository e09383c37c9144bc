// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/place.h"
#include "import/instruments/datanumbers.h"
#include "import/instruments/otherlines.h"
#include "import/layouts/passes.h"
#include "import/layouts/sections.h"
#include "kernel/words/characters.h"
#include "tables/contenterror.h"
#include "tables/dates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace palmer {

namespace {

constexpr double mostTargets = 1e6;

constexpr std::string_view knownSections =
    "||header|target data|user-text|runs|deviations|equipment|environment|eof|";
/// Keys that are read, or of the format itself.
constexpr std::string_view knownKeys =
    "|header/file type|header/owner|header/version no|target data/filetype|target data/target-count|"
    "target data/targets|target data/flags|user-text/machine|user-text/serial no|user-text/date|user-text/by|"
    "user-text/axis|user-text/location|user-text/title|runs/run-count|deviations/run target data|"
    "environment/air temp|environment/air press|environment/air humid|environment/mat temp 1|"
    "environment/mat temp 2|environment/mat temp 3|environment/exp coeff|";

bool isAmong(std::string_view words, const std::string &word) {
    return words.find('|' + lowerCase(word) + '|') != std::string_view::npos;
}

std::optional<double> numberOf(std::optional<std::string_view> text) {
    if (!text)
        return {};
    return numberIn(text->substr(0, text->find_first_of(" \t")));
}

class RtlReader {
public:
    RtlReader(Choices &choices, Imported &imported)
        : m_choices(choices)
        , m(imported)
        , m_numbers(imported.text, choices) {}

    void read() {
        takeSections();
        requireEnd();
        readTargets();
        readDeviations();
        collectOthers();
        resolveDirections();
        m_notes = m_others.notes();
        const PassForm form = resolveForms();
        Test test;
        PositioningMeasurement measurement = measurementOf(passesInOrder(), form, m.remarks);
        readUserText(test, measurement);
        readEnvironment(measurement);
        test.edition = m_choices.resolveEdition(Kind::positioning, m_notes.edition);
        test.measurement = std::move(measurement);
        m.test = std::move(test);
        m_numbers.remark(m.remarks);
        takeNotes(m_notes, m);
    }

private:
    /// The sections of one measurement: each ends with EOF::, and some programs write several into a file.
    void takeSections() {
        std::vector<std::vector<Section>> parts(1);
        for (Section &section : sectionsOf(m.text)) {
            if (!parts.back().empty() && sameWord(parts.back().back().name, "EOF"))
                parts.emplace_back();
            parts.back().push_back(std::move(section));
        }
        std::vector<std::string> names;
        std::vector<std::vector<Section>> measurements;
        for (std::vector<Section> &part : parts) {
            if (findSection(part, "DEVIATIONS") || measurements.empty()) {
                const std::string_view axis = valueIn(part, "USER-TEXT", "Axis");
                names.push_back(std::to_string(part.empty() ? 1 : part.front().line) + "–" +
                                std::to_string(part.empty() ? 1 : part.back().line) +
                                (axis.empty() ? std::string() : " (" + excerpt(axis) + ')'));
                measurements.push_back(std::move(part));
            } else {
                for (Section &section : part)
                    measurements.back().push_back(std::move(section));
            }
        }
        m_sections = std::move(measurements[resolveMeasurement(names, m_choices, m.remarks)]);
    }

    /// Lists what is in the sections and has no field here.
    void collectOthers() {
        for (const Section &section : m_sections) {
            const bool isFirst = findSection(m_sections, section.name) == &section;
            const std::string name = lowerCase(section.name);
            const bool isKnown = isAmong(knownSections, name);
            if (isAgainData(section, isFirst))
                continue;
            if (!isKnown)
                m.remarks.note({"", section.line},
                               REPORT_TEXT("report", "The section %1 is not known and was not read."),
                               excerpt(section.name));
            std::set<std::string> seen; // the first value of each is the one read
            for (const SectionLine &line : section.lines) {
                const bool isAgain =
                    !seen.insert(lowerCase(line.key)).second && section.value(line.key) != line.value;
                const bool isUsed =
                    isFirst && !isAgain && isAmong(knownKeys, name + '/' + std::string(line.key));
                if (isUsed || line.value.empty() || (line.key.empty() && isOfData(section)))
                    continue;
                if (isOfData(section) && isDigit(line.key.front())) {
                    m.remarks.unlike(line.line);
                    continue;
                }
                addOther(line, name, isKnown && isFirst && !isAgain);
            }
        }
    }

    /// A line of a section of that name; one of an instrument states nothing of the machine.
    void addOther(const SectionLine &line, const std::string &name, bool isStatement) {
        const std::string text =
            std::string(line.key) + (line.key.empty() ? "" : ": ") + std::string(line.value);
        if (isStatement && name != "equipment" && name != "eof")
            m_others.add(line.line, text, name == "target data");
        else
            m_others.list(line.line, text);
    }

    [[nodiscard]] static bool isOfData(const Section &section) {
        return sameWord(section.name, "TARGET DATA") || sameWord(section.name, "DEVIATIONS");
    }

    /// True for a second list of targets or deviations, which is not read.
    bool isAgainData(const Section &section, bool isFirst) {
        if (isFirst || !isOfData(section))
            return false;
        m.remarks.problem({"unread", section.line},
                          REPORT_TEXT("report", "The section %1 is there once more; it was not read."),
                          excerpt(section.name));
        return true;
    }

    void requireEnd() const {
        if (!findSection(m_sections, "EOF"))
            refuseContent(REPORT_TEXT("report", "the file ends before “%1”: it was cut off"), "EOF::");
    }

    [[nodiscard]] const Section &demand(std::string_view name) const {
        const Section *section = findSection(m_sections, name);
        if (!section)
            refuseContent(REPORT_TEXT("report", "the section %1 is missing"), std::string(name) + "::");
        return *section;
    }

    void readTargets() {
        const Section &section = demand("TARGET DATA");
        bool listing = false;
        for (const SectionLine &line : section.lines) {
            if (sameWord(line.key, "Targets")) {
                listing = true;
                takeTargets(line.value, line.line);
            } else if (listing && line.key.empty()) {
                takeTargets(line.value, line.line);
            } else {
                listing = false;
                if (line.key.empty())
                    m.remarks.unlike(line.line);
            }
        }
        if (m_targets.empty())
            refuseContentAt(placeOfLine(section.line),
                            REPORT_TEXT("report", "there are no target positions in it"));
        const auto stated = numberOf(section.value("Target-count"));
        const bool disagrees = stated && *stated != static_cast<double>(m_targets.size());
        if (disagrees && !isStrictlyMonotone(m_targets)) // a number was split
            refuseContentAt(placeOfLine(section.line),
                            REPORT_TEXT("report", "targets named in the "
                                                  "head: %1, in the list, in no order: %2: it is damaged"),
                            counted(*stated), counted(m_targets.size()));
        if (disagrees)
            m.remarks.problem(
                {"", section.line},
                REPORT_TEXT("report", "Targets named in the head: %1, in the list: %2; the list counts."),
                counted(*stated), counted(m_targets.size()));
        const auto flags = section.value("Flags");
        const auto numbers = flags ? numbersIn(*flags) : std::nullopt;
        m_oneDirection = numbers && numbers->size() > 1 && (*numbers)[1] == 1;
        m_type = section.value("Filetype").value_or("");
    }

    void takeTargets(std::string_view text, std::size_t line) {
        const auto numbers = m_numbers.in(text, line);
        if (!numbers)
            refuseContentAt(placeOfLine(line),
                            REPORT_TEXT("report", "“%1” is not a list of target positions"), excerpt(text));
        m_targets.insert(m_targets.end(), numbers->begin(), numbers->end());
        if (static_cast<double>(m_targets.size()) > mostTargets)
            refuseReadings(placeOfLine(line));
    }

    void readDeviations() {
        const Section &section = demand("DEVIATIONS");
        double lowest = INFINITY;
        for (const SectionLine &line : section.lines) {
            if (!line.key.empty())
                continue; // "Run Target Data:", or another statement
            const auto numbers = m_numbers.in(line.value, line.line);
            const bool row =
                numbers && numbers->size() == 3 && isWhole((*numbers)[0]) && isWhole((*numbers)[1]);
            if (!row) {
                m.remarks.problem(
                    {"unread", line.line},
                    REPORT_TEXT("report", "“%1” is not run, target and deviation; the line was not read."),
                    excerpt(line.value));
                continue;
            }
            m_rows.push_back({(*numbers)[0], (*numbers)[1], (*numbers)[2], line.line});
            lowest = std::min(lowest, (*numbers)[1]);
        }
        if (m_rows.empty())
            refuseWithoutReadings(placeOfLine(section.line));
        const double first = lowest == 0 ? 0 : 1; // some files count from 0
        const bool descend = targetsDescend();
        for (const Row &row : m_rows) {
            const double index = row.target - first;
            if (index < 0 || index >= static_cast<double>(m_targets.size()))
                refuseContentAt(placeOfLine(row.line),
                                REPORT_TEXT("report", "there is no target %1; the list has %2"),
                                counted(row.target), counted(m_targets.size()));
            RunRows &run = m_runs[row.run];
            const double along = run.readings.empty() ? 0 : index - run.last;
            const double step = descend ? -along : along;
            run.rises |= step > 0;
            run.falls |= step < 0;
            run.last = index;
            run.readings.push_back({m_targets[static_cast<std::size_t>(index)], row.value,
                                    static_cast<std::uint32_t>(row.line)});
        }
        const auto stated = numberOf(valueIn(m_sections, "RUNS", "Run-count"));
        if (stated && *stated != static_cast<double>(m_runs.size()))
            m.remarks.problem(
                {}, REPORT_TEXT("report", "Runs named in the head: %1, in the rows: %2; the rows count."),
                counted(*stated), counted(m_runs.size()));
    }

    /// True if a run in target order moves the axis in the negative direction.
    [[nodiscard]] bool targetsDescend() const {
        return m_targets.size() > 1 && std::ranges::is_sorted(m_targets, std::ranges::greater());
    }

    [[nodiscard]] static bool isWhole(double value) {
        return value >= 0 && value == std::floor(value) && value < 1e9;
    }

    /// Direction of the j-th run (from 0) under one of the choices.
    [[nodiscard]] Direction directionOf(std::string_view choice, const auto &run, std::size_t j) const {
        const bool isNegative = (choice == "stated" && run.falls && !run.rises) ||
                                (choice == "reversed" && run.rises && !run.falls) || choice == "negative" ||
                                (choice == "alternating" && j % 2 == 1) ||
                                (choice == "sideBySide" && 2 * j >= m_runs.size());
        return isNegative ? Direction::negative : Direction::positive;
    }

    void resolveDirections() {
        bool ordered = true;
        bool areMixed = false;
        const bool descend = targetsDescend();
        for (const auto &[number, run] : m_runs) {
            ordered &= !(run.rises && run.falls);
            areMixed |= descend ? run.rises : run.falls; // some runs against target order
        }
        const bool byOrder = ordered && (areMixed || (m_oneDirection && descend));
        std::string found = "stated";
        Origin origin = descend ? Origin::guessed : Origin::recognised;
        if (byOrder && m_oneDirection && areMixed)
            m.remarks.note({},
                           REPORT_TEXT("report", "The head says one direction, the rows run both ways; the "
                                                 "rows are followed."));
        if (!byOrder) {
            found = m_oneDirection ? "positive" : "alternating";
            origin = m_oneDirection ? Origin::recognised : Origin::guessed;
        }
        const std::string &stated = m_others.direction();
        const auto choice = m_choices.resolve("directions", found, stated.empty() ? origin : Origin::guessed);
        std::size_t j = 0;
        for (auto &[number, run] : m_runs)
            run.direction = directionOf(choice.value, run, j++);
        if (choice.origin == Origin::guessed && !stated.empty())
            m.remarks.problem("directions",
                              REPORT_TEXT("report", "Directions: the file says “%1”, which was not used; is "
                                                    "what was read right?"),
                              excerpt(stated));
        else if (choice.origin == Origin::guessed)
            m.remarks.assumption(
                "directions",
                byOrder ? REPORT_TEXT("report", "Directions: the targets descend along the list; a run in "
                                                "its order moves in the negative direction and is read as ↓.")
                        : REPORT_TEXT("report", "Directions: the order of the targets does not say them; odd "
                                                "runs are read as ↑, even ones as ↓."));
    }

    std::vector<Pass> passesInOrder() {
        std::vector<Pass> passes;
        for (auto &[number, run] : m_runs)
            passes.push_back({run.direction, std::move(run.readings)});
        addMissing(passes.front(), m_targets);
        return passes;
    }

    PassForm resolveForms() {
        const std::string type =
            std::string(m_type) + ' ' + std::string(valueIn(m_sections, "HEADER", "File type"));
        const std::string_view owner = valueIn(m_sections, "HEADER", "Owner");
        const bool ofRotaryAxis = isRotaryType(type) || containsWord(owner, "rot");
        const bool angular = containsWord(type, "ang") || ofRotaryAxis;
        const bool rotary = m_choices.isChosen("motion") ? m_choices.chosen("motion") == "rotary" : angular;
        requireRotation(angular, ofRotaryAxis);
        if (rotary && containsWord(type, "lin") && !m_choices.isChosen("unit"))
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 here: the file has its numbers in %3"),
                          nameOfChoice("motion"), nameOfWord("motion", "rotary"), "µm");
        askForType();
        PassForm form;
        m_choices.resolve("content", "deviations", Origin::recognised);
        m_choices.resolve("motion", rotary ? "rotary" : "linear", Origin::recognised);
        form.content =
            m_choices.isChosen("content") ? std::string(m_choices.chosen("content")) : "deviations";
        form.positionUnit = resolveFixedUnit("positionUnit", m_notes.positionUnit,
                                             *unitOf(rotary ? "deg" : "mm"), m_choices, m.remarks);
        form.unit =
            resolveFixedUnit("unit", m_notes.unit, *unitOf(rotary ? "mrad" : "um"), m_choices, m.remarks);
        if (form.unit->kind != form.positionUnit->kind ||
            form.unit->kind != (rotary ? UnitKind::angle : UnitKind::length))
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 here: the axis moves the other way"),
                          nameOfChoice("unit"), nameOfWord("unit", form.unit->word));
        form.sign =
            resolveSaidSign(m_notes.sign, "actualMinusTarget", Origin::recognised, m_choices, m.remarks);
        m.remarks.note(
            {},
            REPORT_TEXT("report", "Units of this format: targets in %1, deviations in %2, actual − target."),
            std::string(form.positionUnit->sign), std::string(form.unit->sign));
        return form;
    }

    /// Throws for pitch and yaw: angles at positions in millimetres.
    void requireRotation(bool angular, bool ofRotaryAxis) {
        const std::string_view owner = valueIn(m_sections, "HEADER", "Owner");
        const bool isOwned = sameWord(owner.substr(0, 3), "ang");
        angular |= isOwned;
        const std::string axis = userText("Axis").substr(0, 1);
        const bool isLinear = axis.find_first_of("XYZUVWxyzuvw") == 0 || isOwned;
        const std::string_view motion = m_choices.chosen("motion");
        const bool isNone = !ofRotaryAxis && (isLinear || isTilt(userText("TITLE")));
        if (angular && (motion == "linear" || (motion.empty() && isNone)))
            refuseContent(REPORT_TEXT("report",
                                      "this is an angular measurement of a linear axis (pitch, yaw), no "
                                      "positioning test; measure the axis with linear optics"));
        if (angular && !ofRotaryAxis && motion.empty() && axis.find_first_of("ABCabc") != 0)
            m.remarks
                .assumption("motion",
                            REPORT_TEXT("report",
                                        "Motion: the file holds angles and "
                                        "does not say of which axis; read as those of a rotary axis. "
                                        "Pitch and yaw of a linear axis are no positioning test."))
                .answers = {"rotary"};
    }

    /// True if the text names a rotation that is no positioning deviation.
    [[nodiscard]] static bool isTilt(std::string_view text) {
        constexpr std::array<std::string_view, 14> words{
            "pitch",   "yaw",    "roll",      "nick",       "gier",    "wank",    "lacet",
            "tangage", "roulis", "imbardata", "beccheggio", "cabeceo", "guinada", "alabeo"};
        return std::ranges::any_of(words, [&](std::string_view word) { return containsWord(text, word); });
    }

    /// Straightness, squareness, flatness are measured along an axis, too.
    void askForType() {
        const Text question =
            REPORT_TEXT("report", "Kind: the file speaks of “%1”; read as a positioning test.");
        const std::array types{m_type, valueIn(m_sections, "HEADER", "File type")};
        const auto *const other = std::ranges::find_if_not(types, isKnownType);
        if (other != types.end())
            m.remarks.problem("kind", question, excerpt(*other));
        else
            m_others.askForKind(userText("TITLE"), question, m.remarks);
    }

    [[nodiscard]] std::string userText(std::string_view key) const {
        return std::string(valueIn(m_sections, "USER-TEXT", key));
    }

    void readUserText(Test &test, PositioningMeasurement &measurement) {
        const auto text = [&](std::string_view key) { return userText(key); };
        m.machine.name = text("Machine");
        m.machine.serialNumber = text("Serial No");
        m.machine.location = text("Location");
        m.operatorName = text("By");
        test.title = text("TITLE");
        measurement.axis.name = m_choices.resolve("axis", text("Axis"), Origin::recognised).value;
        const std::string date = text("Date");
        takeDate(isoDate(date), date, test, m.remarks);
    }

    void readEnvironment(PositioningMeasurement &measurement) {
        const Section *environment = findSection(m_sections, "ENVIRONMENT");
        if (!environment)
            return;
        PositioningConditions &conditions = measurement.conditions;
        // In hPa, %, °C and µm/(m·°C); another unit behind the number is not converted, the line is listed.
        const auto within = [&](std::string_view key, double low, double high) -> std::optional<double> {
            constexpr std::string_view units =
                "||mbar|hpa|%|%rh|% rh|c|°c|degc|deg c|ppm|ppm/c|ppm/°c|um/m/c|µm/m/°c|";
            const auto isOfKey = [&](const SectionLine &each) { return sameWord(each.key, key); };
            const auto line = std::ranges::find_if(environment->lines, isOfKey);
            if (line == environment->lines.end() || line->value.empty())
                return {};
            const std::string_view text = line->value;
            const auto value = numberOf(text);
            const std::string_view unit = text.substr(std::min(text.find_first_of(" \t"), text.size()));
            const bool isUsual = isAmong(units, std::string(withoutBlanks(unit)));
            if (value && isUsual && *value >= low && *value <= high)
                return value;
            m_notes.unused.add(line->line, std::string(key) + ": " + std::string(line->value));
            return {};
        };
        conditions.airPressure = within("Air press", 500, 1200);
        conditions.airHumidity = within("Air humid", 0, 100);
        const auto addSensor = [&](std::string_view key, SensorMeasures what) {
            const auto value = within(key, -20, 60);
            if (value && *value == 0) {
                m.remarks.note({}, REPORT_TEXT("report", "“%1” is 0 °C: taken as not connected."),
                               std::string(key));
            } else if (value) {
                Sensor sensor;
                sensor.measures = what;
                sensor.position = key;
                sensor.start = value;
                conditions.common.sensors.push_back(std::move(sensor));
            }
        };
        addSensor("Air temp", SensorMeasures::air);
        for (const std::string_view key : {"Mat temp 1", "Mat temp 2", "Mat temp 3"})
            addSensor(key, SensorMeasures::machine);
        conditions.common.expansion.machine = within("Exp coeff", 0.01, 40); // no machine has 0
        if (!conditions.common.sensors.empty())
            m.remarks.note({}, REPORT_TEXT("report", "Temperatures of the "
                                                     "file are taken as those at the start of the test."));
    }

    struct Row {
        double run = 0;
        double target = 0;
        double value = 0;
        std::size_t line = 0;
    };
    struct RunRows {
        std::vector<PassReading> readings;
        bool rises = false;
        bool falls = false;
        double last = 0;
        Direction direction = Direction::positive;
    };

    Choices &m_choices;
    Imported &m;
    std::vector<Section> m_sections;
    std::vector<double> m_targets;
    std::vector<Row> m_rows;
    std::map<double, RunRows> m_runs;
    DataNumbers m_numbers;
    OtherLines m_others;
    FileNotes m_notes; ///< what the other lines state
    std::string_view m_type;
    bool m_oneDirection = false;
};

bool isRtl(QByteArrayView bytes) {
    const std::string_view text(bytes.data(), static_cast<std::size_t>(bytes.size()));
    const std::string_view start = text.substr(0, 4096);
    return start.find("HEADER::") != std::string_view::npos &&
           (start.find("TARGET DATA::") != std::string_view::npos ||
            text.find("DEVIATIONS::") != std::string_view::npos);
}

void readRtl(const ImportSource &source, Choices &choices, Imported &imported) {
    imported.text = decodedText(source.bytes, choices, imported);
    RtlReader(choices, imported).read();
    choices.resolve("kind", "positioning", Origin::recognised);
}

} // namespace

const ImportFormat rtlFormat{"rtl", REPORT_TEXT("report", "Renishaw laser data"), "rtl", isRtl, readRtl};

} // namespace palmer
