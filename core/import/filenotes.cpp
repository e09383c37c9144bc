// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/filenotes.h"

#include "import/layouts/sections.h"
#include "kernel/words/characters.h"
#include "tables/dates.h"
#include "tables/folded.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace palmer {

namespace {

constexpr std::size_t mostLines = 300;
constexpr std::size_t longestLine = 500;

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

/// "Air temperature: 20.5 °C": a sensor with its start value.
bool readTemperature(const QString &line, FileNotes &notes) {
    constexpr std::size_t mostSensors = 20;
    const auto match =
        pattern(
            R"(([\p{L} .]*temp[\p{L}]*[\p{L} .\d]*?)\s*(?:[\(\[]?°?\s*C[\)\]]?)?\s*[:=;]\s*(-?\d+(?:[.,]\d+)?)(?:\s*°\s*C)?\s*(?:;|$))")
            .match(line);
    if (!match.hasMatch() || notes.sensors.size() >= mostSensors)
        return false;
    bool isNumber = false;
    const double value = match.captured(2).replace(u',', u'.').toDouble(&isNumber);
    if (!isNumber || value < -20 || value > 60)
        return false;
    Sensor sensor;
    sensor.position = match.captured(1).trimmed().toStdString();
    sensor.measures = measuredBy(sensor.position);
    // "Temperature" alone does not say of what.
    if (sensor.measures == SensorMeasures::machine && readHeading(sensor.position).unknownWords == 0)
        sensor.measures = SensorMeasures::notStated;
    sensor.start = value;
    notes.sensors.push_back(std::move(sensor));
    return true;
}

/// The texts of the cells that are not empty. "0,1 µm", torn by a comma that also separates cells, is one
/// again.
std::vector<std::string> textsIn(const CellTable &table, const TableRow &row) {
    std::vector<std::string> texts;
    std::size_t end = 0;
    for (const TableCell &cell : table.cells(row)) {
        if (cell.size == 0)
            continue;
        const std::string_view text = table.text(cell).substr(0, longestLine);
        const auto isLetter = [](char c) { return !isDigit(c) && c != '.' && c != '-' && c != '+'; };
        const bool isTorn = table.delimiter.value == Delimiter::comma && !texts.empty() &&
                            cell.begin == end + 1 && isDigit(text.front()) && isDigit(texts.back().back()) &&
                            std::ranges::any_of(texts.back(), isLetter);
        if (isTorn)
            texts.back() += ',' + std::string(text);
        else
            texts.emplace_back(text);
        end = cell.begin + cell.size;
    }
    return texts;
}

/// The cells of a row as labels with values: "Machine:" followed by "HAAS", several pairs per row.
std::string lineOf(const CellTable &table, const TableRow &row) {
    std::string line;
    const std::vector<std::string> texts = textsIn(table, row);
    for (std::size_t place = 0; place < texts.size() && line.size() <= longestLine; ++place) {
        std::string_view text = texts[place];
        const bool isLabel = text.ends_with(':') || text.ends_with('=') || (texts.size() == 2 && place == 0);
        while (isLabel && (text.ends_with(':') || text.ends_with('=') || text.ends_with(' ')))
            text.remove_suffix(1);
        line += std::string(text) + (isLabel ? " : " : " ; ");
    }
    return line;
}

bool read(const QString &line, FileNotes &notes) {
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
    take(
        notes.operatorName,
        R"(\b(?:operator|opérateur|operateur|bediener|prüfer|pruefer|operatore|operador|inspector|by|par)\s*[:=;]\s*([^:=;|,][^;|,]{1,60}))");
    take(notes.machine,
         R"(\b(?:machine|maschine|macchina|máquina|maquina)\s*[:=;]\s*([^:=;|,][^;|,]{1,80}))");
    static const QRegularExpression instrument(
        QStringLiteral(
            R"(\b(?:laser|interferom\w*|instrumento?s?|strumento|messger[aä]t|ballbar|sensor|probe|capteur)\b)"),
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression machine(QStringLiteral(R"(\b(?:machine|maschine|macchina|m[aá]quina)\b)"),
                                            QRegularExpression::CaseInsensitiveOption);
    notes.isOfInstrument =
        instrument.match(line).hasMatch() || (notes.isOfInstrument && !machine.match(line).hasMatch());
    if (!notes.isOfInstrument)
        take(
            notes.serialNumber,
            R"((?:\bserial(?: no| number)?|n° de série|numéro de série|\bs/n|\bseriennummer|\bserien-nr|\bmatricola|\bnúmero de serie|\bnº de serie)\.?\s*[:=;]\s*([^:=;|,][^;|,]{0,60}))");
    if (notes.operatorName == "–" || notes.operatorName == "—")
        notes.operatorName.clear();
    understood |= readTemperature(line, notes);
    if (pattern(R"(\b(?:unit|units|unité|unités|unite|einheit|unità|unidad)\b)").match(line).hasMatch() &&
        !notes.unit.isSaid()) {
        notes.unit = unitOfNote(line.toStdString());
        understood |= notes.unit.isSaid();
    }
    // "Calibrated: 2022-01-01" is no day of the test.
    static const QRegularExpression otherDay(
        QStringLiteral(
            R"(^\D*(?:calib|[eé]talon|kalib|tarat|certif|\bdue\b|valid|[eé]ch[eé]ance|f[aä]llig|scaden|print|)"
            R"(druck|imprim|install|version|built|baujahr|mise en service))"),
        QRegularExpression::CaseInsensitiveOption);
    const bool isOtherDay = otherDay.match(line).hasMatch();
    if (const auto date = isoDate(line.toStdString()); date && !notes.date && !isOtherDay) {
        notes.date = date;
        understood = true;
    } else if (const auto text = captured(R"(\b(\d{1,2}[./-]\d{1,2}[./-]\d{2,4})\b)", line);
               text && !date && notes.dateText.empty() && !isOtherDay) {
        notes.dateText = text->toStdString();
        understood = true;
    }
    static const QRegularExpression standard(
        QStringLiteral(
            R"(\b(ISO)\s*(230-[24])\s*[:(–-]?\s*(1988|1996|1997|2005|2006|2014|2022)\b|\b(VDI)\s*/?\s*(?:DGQ)?\s*3441\b)"),
        QRegularExpression::CaseInsensitiveOption);
    if (const auto found = standard.match(line); found.hasMatch() && !notes.edition) {
        notes.edition = findEdition(found.captured(4).isEmpty() ? "ISO " + found.captured(2).toStdString() +
                                                                      ':' + found.captured(3).toStdString()
                                                                : std::string("VDI/DGQ 3441:1977"));
        understood |= notes.edition != nullptr;
    }
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
    return understood;
}

/// The row as written, from its first cell to its last.
std::string textOf(const CellTable &table, const TableRow &row) {
    std::string text;
    for (const TableCell &cell : table.cells(row))
        text += (text.empty() || cell.size == 0 ? "" : " ") + std::string(table.text(cell));
    return text;
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

/// "Forward", "ccw", "As found" above a block.
bool isTitle(std::string_view text) {
    const HeadingWords words = readHeading(text);
    return senseIn(text) || words.direction || words.state != TestRole::notStated;
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
    FileNotes notes;
    return table.text(*label).ends_with(':') || read(QString::fromStdString(lineOf(table, row)), notes);
}

SensorMeasures measuredBy(std::string_view name) {
    constexpr std::array<std::string_view, 12> air{"air",  "ambi",     "luft",  "aria",    "aire",  "room",
                                                   "raum", "umgebung", "salle", "atelier", "local", "sala"};
    constexpr std::array<std::string_view, 6> instrument{"instrument", "ballbar", "scale",
                                                         "laser",      "etalon",  "strument"};
    const std::string low = folded(name);
    const auto names = [&](std::string_view word) { return low.find(word) != std::string::npos; };
    if (std::ranges::any_of(air, names))
        return SensorMeasures::air;
    return std::ranges::any_of(instrument, names) ? SensorMeasures::instrument : SensorMeasures::machine;
}

FileNotes notesOf(const CellTable &table, const TableBody &body) {
    FileNotes notes;
    std::size_t lines = 0;
    for (const std::uint32_t index : body.notes) {
        if (++lines > mostLines)
            break;
        const TableRow &row = table.rows()[index];
        const std::string line = lineOf(table, row);
        const std::string text = textOf(table, row);
        if (notes.days.empty())
            notes.days = daysIn(table, row);
        if (!read(QString::fromStdString(line), notes) && !readForm(text, notes) && !isTitle(text))
            notes.unused.add(row.line, text);
    }
    return notes;
}

} // namespace palmer
