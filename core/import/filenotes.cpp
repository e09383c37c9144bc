// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/filenotes.h"

#include "import/labelledvalues.h"
#include "import/layouts/sections.h"
#include "import/noteform.h"
#include "import/notelabels.h"
#include "import/notereader.h"
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
    const QString line = statementOf(said);
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
    // "YZ plane", "G19", and the letters alone in the title of a circle
    for (const char *text : {R"(\b([XYZ]{2})[ -]?(?:plane|ebene)\b)", R"(\b(G1[789])\b)",
                             R"(\b(?:circ|kreis|cerc|cerch|ballbar).*\b((?-i:XY|YX|YZ|ZY|ZX|XZ))\b)"}) {
        const auto found = notes.plane.empty() ? captured(text, line) : std::nullopt;
        if (found && !(notes.plane = planeIn(found->toStdString())).empty())
            understood = true;
    }
    const bool isDayLeft = !takeDay(line, !said.label.empty(), notes, understood);
    takeEdition(line, notes, understood);
    if (SaidSign sign = saidSign(line.toStdString()); !sign.sign.empty() && notes.sign.sign.empty()) {
        notes.sign = std::move(sign);
        understood = true;
    }
    const auto takeNumber = [&](std::optional<double> &field, double part, const char *text) {
        const auto value = positiveNumber(captured(text, line));
        if (!value || *value * part < leastRadius)
            return;
        if (!field)
            field = *value * part;
        understood |= field == *value * part;
    };
    // "Stylus radius 3 mm" is another one.
    takeNumber(
        notes.radius, 1,
        R"((?:\bR|(?:^|[,;:(–-]\s*|\b(?:circle|circular|test|path|ballbar|kreis\w*|cercle|cerchio|circulo)\s)(?:nominal |nenn|soll|kreis)?(?:radius|rayon|raggio|radio)(?: nominale?)?)\s*[:=;]?\s*((?![1-9][.,]\d{3}(?!\d))\d+(?:[.,]\d+)?)\s*mm\b)");
    takeNumber(
        notes.radius, 0.5,
        R"((?:[Ø⌀]|(?:^|[,;:(–-]\s*|\b(?:circle|circular|test|kreis\w*|cercle)\s)(?:diameter|diam[eè]tre|durchmesser|diametro))\s*[:=;]?\s*(\d+(?:[.,]\d+)?)\s*mm\b)");
    takeNumber(
        notes.overshoot, 1,
        R"(\b(?:overshoot|überlauf(?:winkel)?|dépassement(?: angulaire)?)\s*[:=;]?\s*(\d+(?:[.,]\d+)?)\s*(?:°|deg))");
    const auto start = captured(
        R"(\b(?:start(?:ing)? angle|startwinkel|angle de départ|angolo iniziale|ángulo inicial)\s*[:=;]?\s*(-?\d+(?:[.,]\d+)?)(?!\d))",
        line);
    if (const auto value = start ? numberIn(start->toStdString()) : std::nullopt;
        value && !notes.startAngle) {
        notes.startAngle = value;
        understood = true;
    }
    // "Circle centre X 250 Y 180"
    if (pattern(R"(\b(?:cent(?:re|er|ro)|mittelpunkt)\b)").match(line).hasMatch()) {
        auto all =
            pattern(R"(\b([XYZ])\s*(?:\(?mm\)?)?\s*[:=]?\s*(-?\d+(?:[.,]\d+)?)(?!\w))").globalMatch(line);
        while (all.hasNext()) {
            const auto each = all.next();
            const double value = numberIn(each.captured(2).toStdString()).value_or(0);
            understood |=
                notes.centre.try_emplace(each.captured(1).toUpper().toStdString()[0], value).first->second ==
                value;
        }
    }
    takeNumber(
        notes.feed, 1,
        R"((?:\bF|\bfeed|\bavance|\bfeed ?rate|\bvorschub|\bavanzamento)\s*[:=;]?\s*((?![1-9]\d{0,2}[.,]\d{3}(?!\d))\d+(?:[.,]\d+)?)\s*mm/min)");
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

/// "Forward", "ccw", "As found" above a block; a sentence with such a word is none.
bool isTitle(std::string_view text) {
    if (text.starts_with("- ") || text.starts_with("* ")) // of a list, no direction
        text.remove_prefix(2);
    const HeadingWords words = readTitle(text);
    return !numberIn(text) && words.isTitle() &&
           (words.namesSense || words.direction || words.state != TestRole::notStated);
}

/// Takes what a line says; returns the text of what is left.
std::string readLine(const std::vector<LabelledValue> &line, std::size_t number, LabelState &state,
                     FileNotes &notes) {
    std::vector<LabelledValue> rest = readLabels(line, number, notes, state);
    std::erase_if(rest, [&](const LabelledValue &said) {
        const bool isOfWords = readWords(said, notes);
        const bool isRead = readForm(said, notes) || isOfWords;
        if (isRead)
            notes.used.add(number, said.text, notes.sheet);
        return isRead || isTitle(said.text);
    });
    return textOf(rest);
}

/// Lists what is left of a line; words that doubt the readings are asked about.
void leave(const std::string &rest, std::size_t number, FileNotes &notes) {
    if (rest.empty())
        return;
    notes.unused.add(number, rest, notes.sheet);
    if (notes.doubts.size() < mostLines && doubtsReadings(rest))
        notes.doubts.emplace_back(number, rest);
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
    LabelState state;
    const std::vector<LabelledValue> said = labelledValuesIn(table, row);
    const std::vector<LabelledValue> rest = readLabels(said, row.line, notes, state);
    return textOf(rest) != textOf(said) || std::ranges::any_of(rest, [&](const LabelledValue &one) {
               return isUnitWithLabel(one) || readWords(one, notes);
           });
}

namespace {

/// The facts that a line above or between tables states, by the block of numbers below it.
struct NoteLine {
    const TableRow *row = nullptr;
    std::size_t block = 0; ///< index of the block that it is above or beside
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
        const auto isBefore = [&](std::uint32_t last) { return last < index; };
        const auto block = static_cast<std::size_t>(std::ranges::count_if(body.lastRows, isBefore));
        FileNotes own;
        std::vector<LabelledValue> said = labelledValuesIn(table, row);
        LabelState state;
        readLine(said, row.line, state, own);
        lines.push_back({&row, block, std::move(said), own.axis});
    }
    return lines;
}

using BlockAxes = std::map<std::size_t, std::string>;

/// The axes named above blocks, by the index of the block; each holds until another is named.
BlockAxes axesOf(const std::vector<NoteLine> &lines) {
    BlockAxes axes;
    for (const NoteLine &line : lines) {
        if (!line.axis.empty())
            axes.try_emplace(line.block, line.axis);
    }
    return axes;
}

/// The axis of a block: for those above the first name, the first one.
std::string axisAt(const BlockAxes &axes, std::size_t block) {
    const auto behind = axes.upper_bound(block);
    return behind == axes.begin() ? behind->second : std::prev(behind)->second;
}

/// The index of the first block of the table that is read, among all blocks.
std::size_t firstBlockOf(const TableBody &body) {
    return body.blocks.empty() ? 0
                               : static_cast<std::size_t>(std::ranges::count_if(
                                     body.lastRows, [first = body.blocks.front().rows.front()](
                                                        std::uint32_t last) { return last < first; }));
}

/// Moves the lines of blocks of other axes out: what a file says above one of its tests is not said of
/// another. Lines before the first that names an axis hold for all, unless the wanted block says otherwise.
std::vector<NoteLine> linesOfOtherAxes(std::vector<NoteLine> &lines, std::string_view wanted,
                                       std::size_t block) {
    const BlockAxes axes = axesOf(lines);
    if (axes.size() < 2)
        return {};
    const std::string axis = wanted.empty() ? axisAt(axes, block) : std::string(wanted);
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

namespace {

/// Texts in the rows of numbers that no column is for, or that are remarks: "discard".
void leaveRemarks(const CellTable &table, const TableBody &body, FileNotes &notes) {
    constexpr std::size_t shortest = 4; // "V", "ok", "nm" are codes
    std::set<std::string, std::less<>> known;
    const std::vector<std::size_t> numbers = body.numberColumns();
    const auto isForRemarks = [&](std::size_t c) {
        return c >= body.columns.size() ||
               (body.columns[c].kind == ColumnKind::words &&
                (body.columns[c].meaning == Meaning::other || (!numbers.empty() && c > numbers.back())));
    };
    for (const TableBlock &block : body.blocks) {
        for (const std::uint32_t index : block.rows) {
            const TableRow &row = table.rows()[index];
            const auto cells = table.cells(row);
            for (std::size_t c = 0; c < cells.size() && known.size() < mostLines; ++c) {
                if (cells[c].kind == CellKind::text && cells[c].size >= shortest && isForRemarks(c) &&
                    known.insert(std::string(table.text(cells[c]))).second)
                    leave(std::string(table.text(cells[c])), row.line, notes);
            }
        }
    }
}

} // namespace

std::vector<std::string> axesOfBlocks(const CellTable &table, const TableBody &body) {
    const BlockAxes axes = axesOf(noteLines(table, body));
    std::vector<std::string> all(body.blocks.size());
    for (const auto &[block, axis] : axes)
        std::fill(all.begin() + static_cast<std::ptrdiff_t>(std::min(block, all.size())), all.end(), axis);
    return all;
}

FileNotes notesOf(const CellTable &table, const TableBody &body, std::string_view axis,
                  const std::vector<CoverSheet> &covers) {
    FileNotes notes;
    LabelState state;
    std::vector<NoteLine> lines = noteLines(table, body);
    const std::vector<NoteLine> others = linesOfOtherAxes(lines, axis, firstBlockOf(body));
    if (body.tables.size() > 1) { // what stands above the table read rules over what stands above another
        const std::size_t read = firstBlockOf(body);
        std::ranges::stable_partition(lines, [&](const NoteLine &line) { return line.block == read; });
    }
    for (const NoteLine &line : lines) {
        if (notes.days.empty())
            notes.days = daysIn(table, *line.row);
        leave(readLine(line.said, line.row->line, state, notes), line.row->line, notes);
    }
    for (const NoteLine &line : others)
        notes.unused.add(line.row->line, textOf(line.said));
    leaveRemarks(table, body, notes);
    for (const CoverSheet &cover : covers) {
        notes.sheet = cover.name;
        TableBody all;
        for (std::size_t i = 0; i < std::min(cover.table.rows().size(), mostLines); ++i)
            all.notes.push_back(static_cast<std::uint32_t>(i));
        for (const NoteLine &line : noteLines(cover.table, all))
            leave(readLine(line.said, line.row->line, state, notes), line.row->line, notes);
    }
    settleUnits(notes);
    return notes;
}

} // namespace palmer
