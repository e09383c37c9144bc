// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/filenotes.h"

#include "import/labelledvalues.h"
#include "import/layouts/sections.h"
#include "import/notelabels.h"
#include "kernel/words/characters.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <QRegularExpression>
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <vector>

namespace palmer {

namespace {

constexpr std::size_t mostLines = 300;

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

/// The unit in "Unit: mm"; letters that are units only in brackets may also follow the colon.
SaidUnit unitOfNote(const std::string &line) {
    SaidUnit said = saidUnit(line);
    const std::size_t colon = line.find_first_of(":=;");
    if (said.isSaid() || colon == std::string::npos)
        return said;
    const std::string_view behind = std::string_view(line).substr(colon + 1);
    const std::string value(withoutBlanks(behind.substr(0, behind.find(';'))));
    return saidUnit('(' + value + ')');
}

/// "Deviations in nm", "All values in 0.1 µm", "Scale factor 0.1", "Signs inverted": what a line without a
/// label says of the numbers. What is not understood is kept in its words, so that it is asked for.
bool readForm(const std::string &line, FileNotes &notes) {
    static const QRegularExpression scale(
        QStringLiteral(
            R"(\b(?:scal(?:e factor|ing)|multipl\w*|fa[ck]t(?:or|eur|eurs|oren)|fattore|tenths?|zehntel|)"
            R"(dixi[eè]mes?|hundredths?|hundertstel|centi[eè]mes?|thousandths?|tausendstel|)"
            R"(milli[eè]mes?)\b|(?<!\w)(?<!\d\s)[x×]\s?10{1,3}\b)"),
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression behindIn(QStringLiteral(R"(\b(?:in|en)\s+\S+(?:\s\S+)?$)"));
    static const QRegularExpression sign(
        QStringLiteral(
            R"(\b(?:signs?(?![-\s]*off)|vorzeichen|signes?|segn[oi]|signos?|inwards?|nach innen|vers l['’]int[eé]rieur|)"
            R"(verso l['’]interno|hacia dentro)\b)"),
        QRegularExpression::CaseInsensitiveOption);
    // "Positions in inches, deviations in microns"
    static const QRegularExpression between(QStringLiteral(R"(\s*[,;]\s+|\s+(?:and|und|et)\s+)"));
    const QString text = QString::fromStdString(line).trimmed();
    const QStringList clauses = text.split(between);
    const auto isOfPlace = [](const QString &clause) {
        return isOneOf(readHeading(clause.toStdString()).meaning, {Meaning::place, Meaning::target});
    };
    if (std::ranges::count_if(clauses, isOfPlace) == 1 && clauses.size() == 2 &&
        std::ranges::all_of(clauses, [](const QString &clause) {
            return behindIn.match(clause).hasMatch() && saidUnit(clause.toStdString()).unit;
        }))
        return std::ranges::count_if(clauses, [&notes](const QString &clause) {
                   return readForm(clause.toStdString(), notes);
               }) == clauses.size();
    const SaidUnit said = saidUnit(line);
    const bool isSize =
        said.unit && (said.unit->kind == UnitKind::length || said.unit->kind == UnitKind::angle);
    const Meaning meaning = readHeading(line).meaning;
    const bool isOfPlaces = isOneOf(meaning, {Meaning::place, Meaning::target});
    SaidUnit &unit = isOfPlaces ? notes.positionUnit : notes.unit;
    if (isSize && behindIn.match(text).hasMatch() && !unit.isSaid()) {
        unit = said;
        return true;
    }
    static const QRegularExpression other(QStringLiteral(
        "resol|auflos|risol|cert|sicher|toler|limit|accura|genau|precis|dead path|travel|distan|cover|expan|"
        "elarg|erweit|copert|cobert|dilat|ausdehn|compens|kompens|correl"));
    const bool isPart = !said.foreign.empty() && said.foreign.front() >= '0' && said.foreign.front() <= '9';
    const bool isOfReadings =
        isOfPlaces || isOneOf(meaning, {Meaning::deviation, Meaning::reading, Meaning::actual});
    const bool isForeign = isOfReadings && !said.foreign.empty() && behindIn.match(text).hasMatch();
    if ((isPart || isForeign || scale.match(text).hasMatch()) && !unit.isSaid() &&
        !other.match(QString::fromStdString(folded(line))).hasMatch())
        unit.foreign = text.toStdString();
    else if (sign.match(text).hasMatch() && notes.sign.words.empty())
        notes.sign.words = text.toStdString();
    return false;
}

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
    const auto match = pattern(R"(^(\d+(?:[.,]\d+)?)\s*)").match(value);
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
    explicit NoteReader(FileNotes &notes)
        : m(notes) {}

    /// Takes the labelled facts of a line, by its number; returns what is left.
    std::vector<LabelledValue> read(const std::vector<LabelledValue> &line, std::size_t number) {
        std::vector<LabelledValue> rest;
        for (const LabelledValue &said : line) {
            noteInstrument(said);
            m_more.clear();
            const auto fact = said.label.empty() || said.values.empty() ? std::nullopt : factOf(said.label);
            if (fact && said.values.size() == 1 && saysNothing(said.values.front()))
                continue;
            if (!fact || !take(*fact, said)) {
                rest.push_back(said);
                continue;
            }
            m.used.add(number, said.text);
            if (!m_more.empty())
                rest.push_back({{}, {m_more}, m_more});
        }
        return rest;
    }

private:
    void noteInstrument(const LabelledValue &said) {
        const std::string &text = said.label.empty() ? said.text : said.label;
        m.isOfInstrument = namesInstrument(text) || (m.isOfInstrument && !namesMachine(text));
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
            return takeLetters(m.plane, R"(^([XYZ]{2})\b)", said);
        case NoteFact::date:
        case NoteFact::day:
        case NoteFact::time:
            return takeDay(said);
        case NoteFact::feed:
            return takeNumber(m.feed, valueIn(said, R"(mm\s*/\s*min)"));
        case NoteFact::airPressure:
            return takeNumber(m.airPressure, valueIn(said, R"(hPa|mbar)"));
        case NoteFact::airHumidity:
            return takeNumber(m.airHumidity, valueIn(said, R"(%(?:\s*r\.?\s*[FH]\.?)?)"));
        case NoteFact::temperature:
            return takeTemperature(said);
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
        const auto date = isoDate(text);
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
        const auto match = pattern(R"(^(-?\d+(?:[.,]\d+)?)\s*(?:°\s*C|deg\.?\s*C|C)?(?=\s|$)\s*(.*)$)")
                               .match(QString::fromStdString(joined(said.values)));
        const auto value = match.hasMatch() ? numberIn(match.captured(1).toStdString()) : std::nullopt;
        if (!value || *value < -20 || *value > 60)
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
        m_more = match.captured(2).toStdString();
        return true;
    }

    FileNotes &m;
    std::set<const std::string *> m_labelled;
    bool m_isDateLabelled = false;
    std::string m_more; ///< values behind the one taken last
};

/// The words of an edition as people write them: "ISO 230-2 (2014)", "VDI 3441".
QRegularExpression patternOf(const Edition &edition) {
    const QString word = QString::fromUtf8(edition.word);
    constexpr qsizetype yearSize = 4;
    QString name = QRegularExpression::escape(word.chopped(yearSize + 1));
    name.replace(QStringLiteral("\\ "), QStringLiteral("\\s*"))
        .replace(QStringLiteral("\\/DGQ"), QStringLiteral("\\s*/?\\s*(?:DGQ)?"));
    // VDI/DGQ 3441 has appeared once.
    const QString year = QStringLiteral("\\s*[:(–-]?\\s*") + word.right(yearSize);
    return QRegularExpression(QStringLiteral("\\b") + name +
                                  (name.startsWith(QLatin1StringView("VDI"))
                                       ? QStringLiteral("(?:%1)?\\b").arg(year)
                                       : year + QStringLiteral("\\b")),
                              QRegularExpression::CaseInsensitiveOption);
}

void takeEdition(const QString &line, FileNotes &notes, bool &understood) {
    static const std::vector<QRegularExpression> patterns = [] {
        std::vector<QRegularExpression> all;
        for (const Edition *edition : editions())
            all.push_back(patternOf(*edition));
        return all;
    }();
    const Edition *named = nullptr;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        if (!patterns[i].match(line).hasMatch())
            continue;
        if (named || notes.edition)
            return; // "replaces …, evaluated after …": nothing says which
        named = editions()[i];
    }
    if (!named)
        return;
    notes.edition = named;
    understood = true;
}

/// A date, unless the words before it name another day. A label has to name the day of the test. False if a
/// date is left.
bool takeDay(const QString &line, bool isLabelled, FileNotes &notes, bool &understood) {
    const auto match =
        pattern(
            R"(\d{4}[-/.]\d{1,2}[-/.]\d{1,2}|\d{1,2}[./-]\d{1,2}[./-]\d{2,4}|\d{1,2}\.?[ -]\p{L}{3,9}\.?[ -]\d{4})")
            .match(line);
    const std::string before = line.left(match.capturedStart()).toStdString();
    if (!match.hasMatch())
        return true;
    if (isLabelled ? !labelsDayOfTest(before) : namesOtherDay(before))
        return false;
    const auto date = isoDate(match.captured().toStdString());
    if (date && !notes.date)
        notes.date = date;
    else if (!date && notes.dateText.empty())
        notes.dateText = match.captured().toStdString();
    const bool isTaken = date ? notes.date == date : notes.dateText == match.captured().toStdString();
    understood |= isTaken;
    return isTaken;
}

/// Reads a text without a label that is known: "Positioning test, X axis, F 1000 mm/min, ISO 230-2:2014".
bool readWords(const LabelledValue &said, FileNotes &notes) {
    const QString line = QString::fromStdString(said.text);
    bool understood = false;
    const auto take = [&](std::string &field, const char *text) {
        if (const auto found = captured(text, line); found && field.empty() && !found->isEmpty()) {
            field = found->toStdString();
            understood = true;
        }
    };
    take(notes.axis, R"(\b(?:axis|axe|achse|asse|eje)\b[\s:=;,|]*([A-Z][0-9]?)\b)");
    take(notes.axis, R"(\b([XYZUVWABC])[ -](?:axis|achse)\b)");
    take(notes.plane, R"(\b(?:plane|plan|ebene|piano|plano)\b[\s:=;,|]*([XYZ]{2})\b)");
    if (pattern(R"(\b(?:unit|units|unité|unités|unite|einheit|unità|unidad)\b)").match(line).hasMatch() &&
        !notes.unit.isSaid()) {
        notes.unit = unitOfNote(line.toStdString());
        understood |= notes.unit.isSaid();
    }
    const bool isDayLeft = !takeDay(line, !said.label.empty(), notes, understood);
    takeEdition(line, notes, understood);
    if (SaidSign sign = saidSign(line.toStdString()); !sign.sign.empty() && notes.sign.sign.empty()) {
        notes.sign = std::move(sign);
        understood = true;
    }
    if (const auto radius = positiveNumber(captured(
            R"((?:\bR|\b(?:nominal |nenn|soll)?radius(?: nominal)?|\brayon(?: nominal)?|\braggio(?: nominale)?|\bradio(?: nominal)?)\s*[:=;]?\s*(\d+(?:[.,]\d+)?)\s*mm\b)",
            line));
        radius && !notes.radius) {
        notes.radius = radius;
        understood = true;
    }
    if (const auto feed = positiveNumber(captured(
            R"((?:\bF|\bfeed|\bavance|\bfeed ?rate|\bvorschub|\bavanzamento)\s*[:=;]?\s*(\d+(?:[.,]\d+)?)\s*mm/min)",
            line));
        feed && !notes.feed) {
        notes.feed = feed;
        understood = true;
    }
    return understood && !isDayLeft;
}

/// "; 2024-01-01;; 2024-06-01": days above columns.
std::string daysIn(const CellTable &table, const TableRow &row) {
    std::set<std::string_view> days;
    for (const TableCell &cell : table.cells(row)) {
        if (isDate(table.text(cell)))
            days.insert(table.text(cell));
    }
    std::string list;
    for (const std::string_view day : days)
        list += (list.empty() ? "" : ", ") + std::string(day);
    return days.size() > 1 ? list : std::string();
}

/// The line as written, without separators.
std::string textOf(std::span<const LabelledValue> line) {
    std::string text;
    for (const LabelledValue &said : line)
        text += (text.empty() ? "" : " ; ") + said.text;
    return text;
}

/// "Forward", "ccw", "As found" above a block.
bool isTitle(std::string_view text) {
    const HeadingWords words = readTitle(text);
    return words.isTitle() && (words.namesSense || words.direction || words.state != TestRole::notStated);
}

/// Takes what a line says; returns the text of what is left.
std::string readLine(const std::vector<LabelledValue> &line, std::size_t number, NoteReader &reader,
                     FileNotes &notes) {
    std::vector<LabelledValue> rest = reader.read(line, number);
    std::erase_if(rest, [&](const LabelledValue &said) {
        if (readWords(said, notes)) {
            notes.used.add(number, said.text);
            return true;
        }
        return readForm(said.text, notes) || isTitle(said.text);
    });
    return textOf(rest);
}

} // namespace

bool isLabelledValue(const CellTable &table, const TableRow &row) {
    constexpr std::ptrdiff_t mostCells = 3; // "Temperature", "20.5", "°C"
    const auto cells = table.cells(row);
    if (cells.empty() || row.comment)
        return false;
    const auto isFilled = [](const TableCell &cell) { return cell.kind != CellKind::empty; };
    const auto label = std::ranges::find_if(cells, isFilled);
    if (label == cells.end() || label->kind != CellKind::text ||
        std::ranges::count_if(cells, isFilled) > mostCells ||
        std::ranges::count_if(cells, &TableCell::isNumber) > 1)
        return false;
    if (table.text(*label).ends_with(':'))
        return true;
    FileNotes notes;
    const std::vector<LabelledValue> said = labelledValuesIn(table, row);
    const std::vector<LabelledValue> rest = NoteReader(notes).read(said, row.line);
    return textOf(rest) != textOf(said) ||
           std::ranges::any_of(rest, [&](const LabelledValue &one) { return readWords(one, notes); });
}

namespace {

/// The facts that a line above or between tables states, by the block of numbers below it.
struct NoteLine {
    const TableRow *row = nullptr;
    std::size_t block = 0; ///< index of the block that follows it
    std::vector<LabelledValue> said;
    std::string axis; ///< that it names
};

/// "Machine; Operator; Date" above "DMU; Max; 13.02.2026": labels in a row, their values below.
bool joinBelow(std::vector<LabelledValue> &labels, std::vector<std::string> values) {
    const auto isLabel = [](const LabelledValue &one) { return one.values.empty() && factOf(one.label); };
    if (labels.size() < 2 || values.size() != labels.size() || !std::ranges::all_of(labels, isLabel))
        return false;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        labels[i].text += ' ' + values[i];
        labels[i].values = {std::move(values[i])};
    }
    return true;
}

std::vector<NoteLine> noteLines(const CellTable &table, const TableBody &body) {
    std::vector<NoteLine> lines;
    for (const std::uint32_t index : body.notes) {
        if (lines.size() == mostLines)
            break;
        const TableRow &row = table.rows()[index];
        const bool isNext = !lines.empty() && lines.back().row + 1 == &row;
        if (isNext && joinBelow(lines.back().said, textsIn(table, row)))
            continue;
        const auto isAfter = [&](const TableBlock &block) { return block.rows.front() < index; };
        const auto block = static_cast<std::size_t>(std::ranges::count_if(body.blocks, isAfter));
        FileNotes own;
        std::vector<LabelledValue> said = labelledValuesIn(table, row);
        NoteReader reader(own);
        readLine(said, row.line, reader, own);
        lines.push_back({&row, block, std::move(said), own.axis});
    }
    return lines;
}

/// Moves the lines of blocks of other axes out: what a file says above one of its tests is not said of
/// another. Lines before the first that names an axis hold for all, unless the wanted block says otherwise.
std::vector<NoteLine> linesOfOtherAxes(std::vector<NoteLine> &lines, std::string_view wanted) {
    std::map<std::size_t, std::string> axes; // by block
    for (const NoteLine &line : lines) {
        if (!line.axis.empty())
            axes.try_emplace(line.block, line.axis);
    }
    if (axes.size() < 2)
        return {};
    const std::string axis(wanted.empty() ? axes.begin()->second : wanted);
    const auto isOfWanted = [&](const NoteLine &line) {
        auto of = axes.upper_bound(line.block); // a block without its own belongs to the one before
        return of == axes.begin() || (--of)->second == axis;
    };
    const auto named = std::ranges::find_if(lines, [](const NoteLine &line) { return !line.axis.empty(); });
    const TableRow *firstNamed = named->row;
    const auto rest = std::stable_partition(lines.begin(), lines.end(), isOfWanted);
    const auto others = std::stable_partition(
        rest, lines.end(), [&](const NoteLine &line) { return line.row->line < firstNamed->line; });
    std::vector<NoteLine> moved(std::make_move_iterator(others), std::make_move_iterator(lines.end()));
    lines.erase(others, lines.end());
    return moved;
}

} // namespace

FileNotes notesOf(const CellTable &table, const TableBody &body, std::string_view axis) {
    FileNotes notes;
    NoteReader reader(notes);
    std::vector<NoteLine> lines = noteLines(table, body);
    const std::vector<NoteLine> others = linesOfOtherAxes(lines, axis);
    for (const NoteLine &line : lines) {
        if (notes.days.empty())
            notes.days = daysIn(table, *line.row);
        if (const std::string rest = readLine(line.said, line.row->line, reader, notes); !rest.empty())
            notes.unused.add(line.row->line, rest);
    }
    for (const NoteLine &line : others)
        notes.unused.add(line.row->line, textOf(line.said));
    return notes;
}

FileNotes notesOf(const CellTable &sheet) {
    FileNotes notes;
    TableBody body;
    for (std::size_t i = 0; i < std::min(sheet.rows().size(), mostLines); ++i)
        body.notes.push_back(static_cast<std::uint32_t>(i));
    NoteReader reader(notes);
    for (const NoteLine &line : noteLines(sheet, body))
        reader.read(line.said, line.row->line);
    notes.used = {}; // named by their sheet
    return notes;
}

} // namespace palmer
