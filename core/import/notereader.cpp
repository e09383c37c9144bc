// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/notereader.h"

#include "import/layouts/sections.h"
#include "import/notelabels.h"
#include "kernel/words/characters.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <span>
#include <utility>

namespace palmer {

const QRegularExpression &pattern(const char *text) {
    thread_local std::map<const char *, QRegularExpression> patterns;
    const auto [found, isNew] = patterns.try_emplace(text, QString::fromUtf8(text),
                                                     QRegularExpression::CaseInsensitiveOption |
                                                         QRegularExpression::UseUnicodePropertiesOption);
    return found->second;
}

std::optional<QString> captured(const char *text, const QString &line) {
    const auto match = pattern(text).match(line);
    return match.hasMatch() ? std::optional(match.captured(1).trimmed()) : std::nullopt;
}

std::optional<double> positiveNumber(const std::optional<QString> &text) {
    const auto value = text ? numberIn(text->toStdString()) : std::nullopt;
    return value && *value > 0 ? value : std::nullopt;
}

namespace {

/// "n/a", "-", "---": the label is there and says nothing.
bool saysNothing(std::string_view value) {
    constexpr std::string_view words =
        "|n/a|na|none|unknown|?|keine|aucun|aucune|unbekannt|inconnu|k. a.|k.a.|s/o|";
    const std::string low = folded(value);
    return low.find_first_not_of("-_. ") == std::string::npos ||
           words.find('|' + low + '|') != std::string_view::npos;
}

std::string joined(std::span<const std::string> values) {
    std::string all;
    for (const std::string &value : values)
        all += (all.empty() ? "" : " ") + value;
    return all;
}

/// A value with one of `units` behind it or in its label.
std::optional<double> valueIn(const LabelledValue &said, const char *units) {
    const QString value = QString::fromStdString(joined(said.values));
    // "1,000" may be one or a thousand.
    const auto match =
        pattern(
            R"(^(\d{1,3}(?:[ \x{A0}\x{202F}]\d{3})+(?![\d.,])|(?![1-9]\d{0,2}[.,]\d{3}(?!\d))\d+(?:[.,]\d+)?)\s*)")
            .match(value);
    const QString rest = value.mid(match.capturedLength());
    const auto unit = pattern(units).match(rest);
    const bool isUnit = unit.hasMatch() && unit.capturedLength() == rest.size();
    const bool isInLabel =
        rest.isEmpty() && pattern(units).match(QString::fromStdString(said.label)).hasMatch();
    return match.hasMatch() && (isUnit || isInLabel) ? positiveNumber(match.captured(1)) : std::nullopt;
}
/// Reads the facts of a test from labels and their values. Of two values of one fact the first is taken.
class NoteReader {
public:
    NoteReader(FileNotes &notes, LabelState &state)
        : m(notes)
        , m_labelled(state.labelled)
        , m_isDateLabelled(state.isDateLabelled) {}

    /// Takes the labelled facts of a line, by its number; returns what is left.
    std::vector<LabelledValue> read(const std::vector<LabelledValue> &whole, std::size_t number) {
        std::vector<LabelledValue> rest;
        for (const LabelledValue &each : whole) {
            for (const LabelledValue &said : parted(each))
                readOne(said, number, rest);
        }
        return rest;
    }

private:
    void readOne(const LabelledValue &said, std::size_t number, std::vector<LabelledValue> &rest) {
        noteInstrument(said);
        m_more.clear();
        const auto fact = said.label.empty() || said.values.empty() ? std::nullopt : factOf(said.label);
        if (fact && said.values.size() == 1 && saysNothing(said.values.front()))
            return;
        if (!fact || !take(*fact, said))
            return rest.push_back(said);
        m.used.add(number, said.text, m.sheet);
        if (!m_more.empty())
            rest.push_back({{}, {m_more}, m_more});
    }

    void noteInstrument(const LabelledValue &said) {
        const std::string &text = said.label.empty() ? said.text : said.label;
        // Once its number is said, the next one is the machine's.
        m.isOfInstrument =
            namesInstrument(text) ? !namesSerialNumber(text) : m.isOfInstrument && !namesMachine(text);
    }

    /// "Machine: VF2, S/N 1088": a label within the value, without its colon.
    static std::vector<LabelledValue> parted(const LabelledValue &said) {
        std::vector<LabelledValue> parts{said};
        if (said.values.empty() || factOf(said.label) != NoteFact::machine)
            return parts;
        std::string name;
        for (const QString &each : QString::fromStdString(said.values.front()).split(QStringLiteral(", "))) {
            const std::string part = each.toStdString();
            std::size_t blank = part.rfind(' ');
            while (blank != std::string::npos && blank > 0 && !factOf(part.substr(0, blank)))
                blank = part.rfind(' ', blank - 1);
            if (name.empty() || blank == std::string::npos || blank == 0)
                name += (name.empty() ? "" : ", ") + part;
            else
                parts.push_back({part.substr(0, blank), {part.substr(blank + 1)}, part});
        }
        if (parts.size() > 1)
            parts.front() = {said.label, said.values, said.label + ": " + name};
        parts.front().values.front() = name;
        return parts;
    }

    bool take(NoteFact fact, const LabelledValue &said) {
        switch (fact) {
        case NoteFact::machine:
            return takeText(m.machine, said);
        case NoteFact::serialNumber:
            return (!m.isOfInstrument || namesMachine(said.label)) && takeText(m.serialNumber, said);
        case NoteFact::operatorName:
            return takeText(m.operatorName, said);
        case NoteFact::axis:
            return takeLetters(m.axis, R"(^([A-Z][0-9]?)\b)", said);
        case NoteFact::plane:
            return takePlane(said);
        case NoteFact::date:
        case NoteFact::day:
        case NoteFact::time:
            return takeDay(said);
        case NoteFact::radius:
            return takeRadius(said, 1);
        case NoteFact::diameter:
            return takeRadius(said, 0.5); // NOLINT(readability-magic-numbers): a half
        case NoteFact::feed:
            return takeFeed(said);
        case NoteFact::airPressure:
            return takePressure(said);
        case NoteFact::airHumidity:
            return takeNumber(m.airHumidity, valueIn(said, R"(%(?:\s*r\.?\s*[FH]\.?)?)"));
        case NoteFact::temperature:
            return takeTemperature(said);
        case NoteFact::correctionTo20:
            return takeAnswer(m.isCorrectedTo20, said);
        case NoteFact::calibration:
            return takeAnswer(m.isCalibrated, said);
        }
        return false;
    }

    bool takeText(std::string &field, const LabelledValue &said) {
        constexpr std::size_t longest = 80; // bytes
        const std::string &value = said.values.front();
        if (value.size() > longest || (!field.empty() && field != value))
            return false;
        field = value;
        m_more = joined(std::span(said.values).subspan(1));
        return true;
    }

    /// A label rules over a title.
    bool takeLetters(std::string &field, const char *letters, const LabelledValue &said) {
        const auto found = captured(letters, QString::fromStdString(joined(said.values)));
        if (!found || (m_labelled.contains(&field) && field != found->toStdString()))
            return false;
        field = found->toStdString();
        m_labelled.insert(&field);
        return true;
    }

    bool takePlane(LabelledValue said) {
        if (std::string plane = planeIn(joined(said.values)); !plane.empty())
            said.values = {std::move(plane)};
        return takeLetters(m.plane, R"(^([XYZ]{2})\b)", said);
    }

    /// "R = 150" has no unit, but no circle is measured in another one; "R: 0.012 mm" is none.
    bool takeRadius(const LabelledValue &said, double part) {
        constexpr double leastBare = 10;
        auto value = inBaseUnit(
            said,
            {{R"(\bmm\b)", 1}, {R"(\bcm\b)", 10}, {R"(\bm\b)", 1000}, {R"(\bin(?:ch(?:es)?)?\b|")", 25.4}});
        if (!value) { // no radius is 150 m
            value = positiveNumber(
                captured(R"(^(\d+(?:[.,]\d+)?)(?:\s*mm)?$)", QString::fromStdString(joined(said.values))));
            value = value >= leastBare ? value : std::nullopt;
        }
        return value >= leastRadius && takeNumber(m.radius, *value * part);
    }

    struct UnitRow {
        const char *unit;
        double factor; ///< to the base unit
    };

    [[nodiscard]] static std::optional<double> inBaseUnit(const LabelledValue &said,
                                                          std::initializer_list<UnitRow> units) {
        for (const auto &[unit, factor] : units) {
            if (const auto value = valueIn(said, unit))
                return *value * factor;
        }
        return {};
    }

    bool takeFeed(LabelledValue said) {
        std::string &value = said.values.front(); // "F1000 mm/min"
        if (value.size() > 1 && value[0] == 'F' && isDigit(value[1]))
            value.erase(0, 1);
        return takeNumber(m.feed, inBaseUnit(said, {{R"(\bmm\s*/\s*min)", 1},
                                                    {R"(\bm\s*/\s*min)", 1000},
                                                    {R"(\bmm\s*/\s*s(?:ec)?)", 60},
                                                    {R"(\bin(?:ch)?\s*/\s*min|\bipm)", 25.4}}));
    }

    /// The air around: that of a supply is higher.
    bool takePressure(const LabelledValue &said) {
        constexpr double lowest = 500; // hPa
        constexpr double highest = 1100;
        constexpr double ofMercury = 1.33322; // mm
        auto value = inBaseUnit(said, {{R"(hPa|mbar)", 1}, {R"(kPa)", 10}, {R"(mm\s?Hg|torr)", ofMercury}});
        if (value)
            value = std::round(*value * 10) / 10;
        return value >= lowest && value <= highest && takeNumber(m.airPressure, value);
    }

    static bool takeAnswer(std::optional<bool> &field, const LabelledValue &said) {
        constexpr std::string_view yes =
            "|yes|y|true|on|ja|an|oui|si|applied|applied by the instrument|calibrated|done|";
        constexpr std::string_view no = "|no|n|false|off|nein|aus|non|not applied|none|not calibrated|";
        const std::string word = '|' + folded(withoutBlanks(joined(said.values))) + '|';
        const bool isYes = yes.find(word) != std::string_view::npos;
        if ((!isYes && no.find(word) == std::string_view::npos) || (field && field != isYes))
            return false;
        field = isYes;
        return true;
    }

    static bool takeNumber(std::optional<double> &field, std::optional<double> value) {
        if (!value || (field && field != value))
            return false;
        field = value;
        return true;
    }

    /// "13.02.2026", "2026-02-13 14:30", "14:30".
    bool takeDay(const LabelledValue &said) {
        const std::string text = joined(said.values);
        const auto time = timeOfDay(text);
        const auto day = isoDate(text);
        const auto date = day ? day : compactDate(text);
        if (date && m_isDateLabelled && m.date != date)
            return false;
        if (time && !m.time)
            m.time = time;
        if (date) {
            m.date = date;
            m_isDateLabelled = true;
            return true;
        }
        const bool couldBeDay =
            pattern(R"(\d[./ -]+[\p{L}\d]+[./, -]+\d{2})").match(QString::fromStdString(text)).hasMatch();
        if (couldBeDay && m.dateText.empty()) {
            m.dateText = text;
            return true;
        }
        return time == m.time && time;
    }

    /// "Air temperature: 20.5 °C": a sensor with its start value, or its end value.
    bool takeTemperature(const LabelledValue &said) {
        constexpr std::size_t mostSensors = 20;
        const auto match =
            pattern(
                R"(^(-?\d+(?:[.,]\d+)?)\s*((?:[°º]|deg\.?)?\s*(?:[CFK]|celsius|fahrenheit|kelvin))?(?=\s|$)\s*(.*)$)")
                .match(QString::fromStdString(joined(said.values)));
        auto value = match.hasMatch() ? numberIn(match.captured(1).toStdString()) : std::nullopt;
        const Unit *unit = temperatureUnitIn(match.captured(2).toStdString());
        if (!unit)
            unit = temperatureUnitIn(
                said.label.substr(std::min(said.label.find_first_of("(["), said.label.size())));
        if (!unit && m.temperatureUnit.isSaid() && !(unit = m.temperatureUnit.unit))
            return false;
        if (value && unit)
            value = unit->toBase(*value);
        if (!value || !isPlausibleTemperature(*value))
            return false;
        const TemperatureLabel label = temperatureLabel(said.label);
        auto sensor = std::ranges::find(m.sensors, label.position, &Sensor::position);
        if (sensor == m.sensors.end()) {
            if (m.sensors.size() >= mostSensors)
                return false;
            m.sensors.push_back({label.measures, label.position, {}, {}, {}});
            sensor = std::prev(m.sensors.end());
        }
        if (!takeNumber(label.isEnd ? sensor->end : sensor->start, value))
            return false;
        m_more = match.captured(3).toStdString();
        return true;
    }

    FileNotes &m;
    std::set<const std::string *> &m_labelled;
    bool &m_isDateLabelled;
    std::string m_more; ///< values behind the one taken last
};

} // namespace

std::vector<LabelledValue> readLabels(const std::vector<LabelledValue> &line, std::size_t number,
                                      FileNotes &notes, LabelState &state) {
    return NoteReader(notes, state).read(line, number);
}

} // namespace palmer
