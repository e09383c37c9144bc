// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/place.h"
#include "import/instruments/otherlines.h"
#include "import/layouts/sections.h"
#include "tables/contenterror.h"
#include "tables/dates.h"
#include "tables/decodetext.h"
#include "tables/numbercell.h"
#include "tables/units.h"

#include <QtEndian>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr std::string_view dataMark = "Data:";
constexpr double mostSamples = 1e7;
constexpr std::string_view headerKeys = "|owner|version no|file type|velocity|sample rate|sample no|actual "
                                        "sample rate|flags|machine|serial no|date|by|"
                                        "axis|location|title|";

/// "10", "10.0 Hz", "5 kHz"; null for "1x.0" and another unit.
std::optional<double> rateOf(std::optional<std::string_view> text) {
    if (!text)
        return {};
    const LeadingNumber number = leadingNumber(*text, decimalMarkIn(*text));
    const std::string unit = lowerCase(withoutBlanks(text->substr(number.size)));
    const bool isApart = number.size == text->size() || (*text)[number.size] == ' ' || unit.ends_with("hz");
    constexpr std::string_view perSecond = "||hz|1/s|/s|samples/s|samples per second|";
    if (number.size == 0 || !isApart)
        return {};
    if (unit == "khz")
        return number.value * 1000;
    if (perSecond.find('|' + unit + '|') == std::string_view::npos)
        refuseContent(REPORT_TEXT("report", "the unit of the sample rate “%1” is not known"), excerpt(*text));
    return number.value;
}

/// Number of samples, and samples per second.
struct Sampling {
    std::size_t count = 0;
    double rate = 0;
};

Sampling samplingOf(const Section *header) {
    const auto samples = header ? numberIn(header->value("Sample no").value_or("")) : std::nullopt;
    const auto actual = header ? header->value("Actual sample rate") : std::nullopt;
    auto rate = rateOf(actual);
    if (!actual || (rate && !(*rate > 0)))
        rate = header ? rateOf(header->value("Sample rate")) : std::nullopt;
    const double count = samples.value_or(0);
    if (!(count >= 2) || count != std::floor(count))
        refuseContent(REPORT_TEXT("report", "the number of samples is missing in the head"));
    if (count > mostSamples)
        refuseReadings();
    if (!rate || !(*rate > 0) || !std::isfinite(*rate))
        refuseContent(REPORT_TEXT("report", "the sample rate is missing in the head"));
    return {static_cast<std::size_t>(count), *rate};
}

/// The part after the mark and its line break: at least the announced samples. Throws if there are fewer.
std::string_view samplesBehind(std::string_view all, std::size_t mark, std::size_t count) {
    std::size_t at = mark + 1 + dataMark.size();
    if (all.substr(at, 2) == "\r\n")
        at += 2;
    else
        at += all.substr(at, 1) == "\n" ? 1 : 0;
    const std::size_t there = (all.size() - at) / sizeof(double);
    if (there < count)
        refuseContent(REPORT_TEXT("report", "the file was cut off: samples announced: %1, there: %2"),
                      counted(count), counted(there));
    return all.substr(at);
}

void readSamples(std::string_view samples, const Sampling &sampling, const Unit &unit,
                 DriftMeasurement &drift) {
    drift.times.reserve(sampling.count);
    drift.deviations.reserve(sampling.count);
    for (std::size_t i = 0; i < sampling.count; ++i) {
        const auto value = qFromLittleEndian<double>(samples.data() + i * sizeof(double));
        if (!std::isfinite(value) || std::abs(value) > 1e9)
            refuseContent(REPORT_TEXT("report", "sample %1 is no number: the data are damaged"),
                          counted(i + 1));
        drift.times.push_back(static_cast<double>(i) / sampling.rate);
        drift.deviations.push_back(unit.toBase(value));
    }
}

/// The end mark follows the samples; if it is farther away, more were measured than announced.
void remarkEnd(std::string_view rest, const Sampling &sampling, Remarks &remarks) {
    const std::size_t mark = rest.find("EOF::");
    if (mark == std::string_view::npos)
        remarks.problem({}, REPORT_TEXT("report", "The file has no end mark behind its samples."));
    else if (const std::size_t further = mark / sizeof(double); further > 0)
        remarks.problem("unread",
                        REPORT_TEXT("report", "Samples announced in "
                                              "the head: %1, there: %2; those beyond were not read."),
                        counted(sampling.count), counted(sampling.count + further));
}

std::vector<const SectionLine *> linesWithoutField(const std::vector<Section> &sections) {
    std::vector<const SectionLine *> lines;
    for (const Section &section : sections) {
        for (const SectionLine &line : section.lines) {
            const bool isField = sameWord(section.name, "HEADER") || sameWord(line.key, "TITLE");
            const bool isFirst = section.value(line.key) == line.value;
            const bool isKnown = isField && isFirst &&
                                 headerKeys.find('|' + lowerCase(line.key) + '|') != std::string_view::npos;
            if (!isKnown && !line.value.empty())
                lines.push_back(&line);
        }
    }
    return lines;
}

std::string titleOf(const std::vector<Section> &sections) {
    for (const Section &section : sections) {
        if (const auto title = section.value("TITLE"))
            return std::string(*title);
    }
    return {};
}

bool isRtx(QByteArrayView bytes) {
    const std::string_view start(bytes.data(),
                                 static_cast<std::size_t>(std::min<qsizetype>(bytes.size(), 16'384)));
    return start.find("HEADER::") != std::string_view::npos &&
           start.find("\nData:") != std::string_view::npos &&
           (start.find("Sample no") != std::string_view::npos ||
            start.find("Sample No") != std::string_view::npos);
}

void readRtx(const ImportSource &source, Choices &choices, Imported &imported) {
    const std::string_view all(source.bytes.data(), static_cast<std::size_t>(source.bytes.size()));
    const std::size_t mark = all.find("\nData:");
    if (mark == std::string_view::npos)
        refuseContent(REPORT_TEXT("report", "the section %1 is missing"), std::string(dataMark));
    imported.text = decodedText(source.bytes.first(static_cast<qsizetype>(mark)), choices, imported);
    const std::vector<Section> sections = sectionsOf(imported.text);
    const Section *header = findSection(sections, "HEADER");
    const auto text = [&](std::string_view key) { return std::string(valueIn(sections, "HEADER", key)); };
    const Sampling sampling = samplingOf(header);
    const std::string_view samples = samplesBehind(all, mark, sampling.count);
    const std::string type = text("File Type");
    OtherLines others;
    for (const SectionLine *line : linesWithoutField(sections))
        others.list(line->line,
                    std::string(line->key) + (line->key.empty() ? "" : ": ") + std::string(line->value));
    const FileNotes notes = others.notes();
    const bool angular = isRotaryType(type) || sameWord(std::string_view(type).substr(0, 3), "ang");
    const Unit *unit =
        resolveFixedUnit("unit", notes.unit, *unitOf(angular ? "mrad" : "mm"), choices, imported.remarks);
    const Text question = REPORT_TEXT("report", "Kind: the file speaks of “%1”; read as a drift test.");
    const std::string title = titleOf(sections);
    if (isKnownType(type))
        others.askForKind(title, question, imported.remarks);
    else
        imported.remarks.problem("kind", question, excerpt(type));
    DriftMeasurement drift;
    drift.axis.name = choices.resolve("axis", text("Axis"), Origin::recognised).value;
    drift.axis.motion = unit->kind == UnitKind::angle ? Motion::rotary : Motion::linear;
    readSamples(samples, sampling, *unit, drift);
    remarkEnd(samples.substr(sampling.count * sizeof(double)), sampling, imported.remarks);
    imported.remarks.note({}, REPORT_TEXT("report", "Understood: a drift test; points: %1; duration: %2."),
                          counted(sampling.count), Number{drift.times.back(), Quantity::time});
    Test test;
    test.title = title;
    const std::string date = text("Date");
    takeDate(isoDate(date), date, test, imported.remarks);
    test.measurement = std::move(drift);
    imported.test = std::move(test);
    imported.machine.name = text("Machine");
    imported.machine.serialNumber = text("Serial No");
    imported.machine.location = text("Location");
    imported.operatorName = text("By");
    takeNotes(notes, imported);
    choices.resolve("kind", "drift", Origin::recognised);
}

} // namespace

const ImportFormat rtxFormat{"rtx", REPORT_TEXT("report", "Renishaw dynamic capture"), "rtx", isRtx, readRtx};

} // namespace palmer
