// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/strips.h"

#include "print/pdf/marks.h"
#include "print/pdf/tags.h"

#include <QPainter>
#include <algorithm>
#include <numeric>

namespace palmer {

namespace {

// Dimensions of a table, points.
constexpr double textSize = 8.5;
constexpr double cellPadding = 1.0 * mm; ///< left and right
constexpr double firstPadding = 1.2 * mm;
constexpr double rowPadding = 0.52 * mm; ///< above and below
constexpr double narrowPadding = 0.25 * mm;
constexpr double headAbove = 1.15 * mm;
constexpr double headBelow = 1.05 * mm;
constexpr double spannerGap = 0.95 * mm; ///< between a spanner, its rule and the titles below
constexpr double markWidth = 3.7 * mm;   ///< including the gap before the word
constexpr double tallestRow = 120 * mm;  ///< higher rows are split
constexpr double noteSize = 7.5;         ///< lines below a cell
constexpr double mostFitted = 0.3;       ///< fraction of the table width; wider columns wrap
constexpr std::size_t wholeRows = 15;    ///< tables with up to this many rows stay together
constexpr std::size_t leastRows = 5;     ///< on each side of a break
constexpr QRgb paleGrey = 0xff666666;

constexpr TextStyle cellStyle{textSize, false, black, 1.2};

TextStyle styled(bool bold, QRgb colour = black) {
    TextStyle style = cellStyle;
    style.bold = bold;
    style.colour = colour;
    return style;
}

bool isDecimalMark(QChar c) {
    return c == u'.' || c == u',';
}

qsizetype decimalMark(const QString &number) {
    const auto mark = std::find_if(number.begin(), number.end(), isDecimalMark);
    return mark == number.end() ? -1 : mark - number.begin();
}

/// False for a range like “−0.010 to 0.000”, too.
bool isNumber(const QString &text) {
    return std::any_of(text.begin(), text.end(), [](QChar c) { return c.isDigit(); }) &&
           std::count_if(text.begin(), text.end(), isDecimalMark) <= 1;
}

/// Position of the cells of a column.
struct Place {
    double left = 0; ///< of the text, from the left edge of the table
    double width = 0;
    double fraction = 0; ///< space for decimal mark and decimals

    [[nodiscard]] double right() const { return left + width; }
};

double paddingBefore(const Table &table, std::size_t column) {
    return std::max(table.columns[column].paddingLeft * mm, column == 0 ? firstPadding : 0);
}

/// Space for decimal mark and decimals of each column; 0: it aligns none.
std::vector<double> fractionsOf(const Table &table) {
    std::vector<qsizetype> decimals(table.columns.size(), -1);
    table.eachRow([&](const std::vector<Cell> &row) {
        for (std::size_t i = 0; i < decimals.size(); ++i) {
            if (table.columns[i].alignment != Alignment::decimal)
                continue;
            const QString text = row[i].text.plain();
            const qsizetype mark = isNumber(text) ? decimalMark(text) : -1;
            if (mark >= 0)
                decimals[i] = std::max(decimals[i], text.size() - mark - 1);
        }
    });
    const double ofMark = textWidth(QStringLiteral(","), cellStyle);
    const double ofDigit = textWidth(QStringLiteral("0"), cellStyle);
    std::vector<double> result;
    result.reserve(decimals.size());
    for (const qsizetype count : decimals)
        result.push_back(count < 0 ? 0 : ofMark + static_cast<double>(count) * ofDigit);
    return result;
}

/// Width that the numbers of a column need, with padding: they must not be broken.
double widthOfNumbers(const Table &table, std::size_t column, double fraction) {
    QString longest; // digits are equally wide
    bool bold = false;
    table.eachRow([&](const std::vector<Cell> &row) {
        const QString text = row[column].text.plain();
        if (row[column].extras->columns > 1 || !isNumber(text))
            return;
        bold |= row[column].bold;
        if (const QString whole = text.left(decimalMark(text)); whole.size() > longest.size())
            longest = whole;
    });
    return paddingBefore(table, column) + textWidth(longest, styled(bold)) + fraction + cellPadding;
}

/// Width that the widest text of a column needs on one line, with padding.
double neededWidth(const Table &table, std::size_t column, double fraction) {
    const bool spread = table.columns[column].titleSpan > 1;
    double widest = spread ? 0 : TextBlock(richText(table.columns[column].title, true), cellStyle).width();
    table.eachRow([&](const std::vector<Cell> &row) {
        const Cell &cell = row[column];
        if (cell.extras->columns > 1)
            return;
        const double before = cell.mark == Mark::none ? 0 : markWidth;
        widest = std::max(widest, before + TextBlock(richText(cell.text, cell.bold), cellStyle).width());
        if (const QString text = cell.text.plain(); fraction > 0 && isNumber(text))
            widest = std::max(widest, textWidth(text.left(decimalMark(text)), styled(cell.bold)) + fraction);
    });
    return paddingBefore(table, column) + widest + cellPadding;
}

/// Takes from columns of fitted texts what the flexible ones lack of half their width; returns how much.
double leaveRoom(const Table &table, std::vector<double> &widths, double rest) {
    double lacking = -rest;
    double fitted = 0;
    const auto grown = [&](std::size_t i) {
        const Column &column = table.columns[i];
        const bool isText = column.fitting && column.alignment != Alignment::decimal;
        return isText ? std::max(0.0, widths[i] - column.width * mm) : 0;
    };
    for (std::size_t i = 0; i < widths.size(); ++i) {
        lacking -= table.columns[i].flexible ? widths[i] / 2 : 0;
        fitted += grown(i);
    }
    const double share = fitted > 0 ? std::clamp(lacking / fitted, 0.0, 1.0) : 0;
    for (std::size_t i = 0; i < widths.size(); ++i)
        widths[i] -= share * grown(i);
    return share * fitted;
}

std::vector<double> columnWidths(const Table &table, double width, const std::vector<double> &fractions) {
    std::vector<double> result;
    double more = 0;
    std::size_t sharing = 0;
    std::size_t flexible = 0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Column &column = table.columns[i];
        result.push_back(column.width * mm);
        if (column.fitting)
            result[i] =
                std::max(result[i], std::min(neededWidth(table, i, fractions[i]), width * mostFitted));
        if (column.alignment == Alignment::decimal && column.width > 0)
            result[i] = std::max(result[i], widthOfNumbers(table, i, fractions[i]));
        more += result[i] - column.width * mm;
        sharing += column.width <= 0 ? 1 : 0;
        flexible += column.flexible ? 1 : 0;
    }
    double fixed = 0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const double given = std::min(more, table.columns[i].spare * mm);
        result[i] -= given;
        more -= given;
        fixed += result[i] + table.columns[i].gapBefore * mm;
    }
    double rest = width - fixed;
    if (sharing == 0 && flexible > 0)
        rest += leaveRoom(table, result, rest);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const Column &column = table.columns[i];
        if (sharing > 0)
            result[i] += column.width <= 0 ? rest / static_cast<double>(sharing) : 0;
        else if (flexible > 0)
            result[i] += column.flexible ? rest / static_cast<double>(flexible) : 0;
        else
            result[i] *= (result[i] + rest * result[i] / std::max(fixed, 1.0)) / result[i];
    }
    return result;
}

std::vector<Place> places(const Table &table, double width) {
    std::vector<Place> result;
    const std::vector<double> fractions = fractionsOf(table);
    const std::vector<double> widths = columnWidths(table, width, fractions);
    double x = 0;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Column &column = table.columns[i];
        Place place;
        x += column.gapBefore * mm;
        const double padding = paddingBefore(table, i);
        place.left = x + padding;
        place.width = std::max(widths[i] - padding - cellPadding, 1.0);
        x += widths[i];
        place.fraction = fractions[i];
        result.push_back(place);
    }
    return result;
}

/// A text with its position in a row.
struct PlacedText {
    TextBlock block;
    double x = 0;
    double width = 0; ///< for the alignment
    TextAlignment alignment = TextAlignment::left;
    std::size_t line = 0; ///< first line in the row
    std::size_t cell = 0; ///< index of its column
};

/// Height of a row.
struct RowExtent {
    std::size_t lines = 1;
    std::size_t beside = 1; ///< rows that its tallest cell spans
    std::size_t besideLines = 1;
};

/// A row ready for drawing: texts, marks and pictures in reading order.
struct PrintedRow {
    struct Sign {
        Mark mark = Mark::none;
        std::optional<Guard> guard;
        double x = 0;
        std::optional<double> bar = {}; ///< length of a bar, points
        bool hollow = false;
        QColor ink = Qt::black;
        std::size_t line = 0;
        std::optional<Whisker> whisker = {};
    };
    std::vector<PlacedText> texts; ///< by column
    std::vector<Sign> signs;
    std::shared_ptr<const std::vector<CellTag>> cells = {}; ///< by column; null: no row of a table
    const char *key = nullptr;                              ///< of the row, then those of its cells
    RowExtent extent = {};
};

TextAlignment textAlignment(Alignment alignment) {
    return alignment == Alignment::left ? TextAlignment::left : TextAlignment::right;
}

/// Aligns a number at the decimal mark of its column; right-aligns other texts and numbers too wide for that.
PlacedText decimalText(const QString &text, const TextStyle &style, const Place &place) {
    const qsizetype mark = isNumber(text) ? decimalMark(text) : text.size();
    const QString whole = mark < 0 ? text : text.left(mark);
    const double x = place.right() - place.fraction - textWidth(whole, style);
    if (x < place.left - cellPadding || (!isNumber(text) && text != thinDash))
        return {TextBlock(text, style, place.width), place.left, place.width, TextAlignment::right};
    return {TextBlock(text, style), x};
}

/// Left end of a number in a decimal column.
double beginningOf(const Cell &cell, const Place &place) {
    const QString text = cell.isMissing() ? thinDash : cell.text.plain();
    const QString whole = text.left(decimalMark(text)); // the whole text without a mark
    return place.right() - place.fraction - textWidth(whole, styled(cell.bold));
}

/// Short texts that must not break ("10↑ – 12↓") extend into the free part of the next column, and are
/// reduced if that is not enough.
PlacedText narrowText(const Cell &cell, const Place &place, double room) {
    constexpr double smallest = 7;
    const RichText text = richText(cell.text, cell.bold);
    TextStyle style = fitted(cellStyle, smallest, room,
                             [&](const TextStyle &tried) { return TextBlock(text, tried).width(); });
    style.leading *= cellStyle.size / style.size;
    return {TextBlock(text, style, room), place.left, room, TextAlignment::left};
}

/// A text reduced if that keeps its longest word whole.
TextBlock wordText(const RichText &text, TextStyle style, double width) {
    constexpr double smallest = 7;
    TextBlock block(text, style, width);
    for (const double leading = style.size * style.leading; block.splitsWord() && style.size > smallest;) {
        style.size = std::max(smallest, style.size - 0.5);
        style.leading = leading / style.size;
        if (TextBlock smaller(text, style, width); !smaller.splitsWord())
            block = std::move(smaller);
    }
    return block;
}

/// Adds what a cell has in place of a text; returns false if it has a text.
bool addPicture(PrintedRow &row, const Cell &cell, const Place &place, const QColor &ink) {
    if (cell.extras->guard)
        row.signs.push_back({Mark::none, cell.extras->guard, place.left, {}, false, ink});
    else if (cell.extras->whisker)
        row.signs.push_back({Mark::none, {}, place.left, {}, false, ink, 0, cell.extras->whisker});
    else if (cell.extras->bar)
        row.signs.push_back({Mark::none,
                             {},
                             place.left,
                             std::clamp(*cell.extras->bar, 0.0, 1.0) * place.width,
                             cell.extras->hollow});
    else
        return false;
    return true;
}

void addCell(PrintedRow &row, const Cell &cell, const Column &column, const Place &place) {
    if (cell.blank)
        return;
    const QColor ink = QColor::fromRgb(cell.pale ? paleGrey : black);
    if (addPicture(row, cell, place, ink))
        return;
    const bool missing = cell.isMissing();
    const TextStyle style = styled(false, missing ? dashGrey : cell.pale ? paleGrey : black);
    const RichText text = missing ? RichText{{thinDash}} : richText(cell.text, cell.bold);
    PlacedText placed;
    if (column.alignment == Alignment::decimal) {
        placed = decimalText(missing ? thinDash : cell.text.plain(), styled(cell.bold, style.colour), place);
    } else {
        const double before = cell.mark == Mark::none ? 0 : markWidth;
        if (cell.mark != Mark::none)
            row.signs.push_back({cell.mark, {}, place.left, {}, false, ink});
        placed = {wordText(text, style, place.width - before), place.left + before, place.width - before,
                  textAlignment(column.alignment)};
    }
    std::size_t lines = placed.block.lineCount();
    row.texts.push_back(std::move(placed));
    for (const CellNote &note : cell.extras->notes) {
        const TextStyle small{noteSize, false, cell.pale ? paleGrey : noteGrey,
                              textSize * cellStyle.leading / noteSize};
        const double before = note.mark == Mark::none ? 0 : markWidth;
        if (note.mark != Mark::none)
            row.signs.push_back({note.mark, {}, place.left, {}, false, ink, lines});
        PlacedText below{TextBlock(note.text, small, place.width - before), place.left + before,
                         place.width - before, textAlignment(column.alignment)};
        below.line = lines;
        lines += below.block.lineCount();
        row.texts.push_back(std::move(below));
    }
    if (cell.extras->rows > 1) {
        row.extent.beside = std::max(row.extent.beside, cell.extras->rows);
        row.extent.besideLines = std::max(row.extent.besideLines, lines);
    } else {
        row.extent.lines = std::max(row.extent.lines, lines);
    }
}

void drawRow(QPainter &painter, QPointF at, const PrintedRow &row) {
    const double lineHeight = textSize * cellStyle.leading;
    for (const PrintedRow::Sign &sign : row.signs) {
        const double middle = at.y() + (static_cast<double>(sign.line) + 0.5) * lineHeight;
        if (sign.bar)
            drawBar(painter, {at.x() + sign.x, middle}, *sign.bar, sign.hollow);
        else if (sign.whisker)
            drawWhisker(painter, {at.x() + sign.x, middle - guardPictureHeight * mm / 2}, *sign.whisker,
                        sign.ink);
        else if (sign.guard)
            drawGuardPicture(painter, {at.x() + sign.x, middle - guardPictureHeight * mm / 2}, *sign.guard,
                             sign.ink);
        else
            drawMark(painter, sign.mark, {at.x() + sign.x + markBox * mm / 2, middle}, markBox * mm,
                     sign.ink);
    }
    TextUnits units(painter);
    auto text = row.texts.begin();
    const auto drawTexts = [&](std::size_t cell) {
        for (; text != row.texts.end() && text->cell <= cell; ++text)
            text->block.draw(units, at + QPointF(text->x, static_cast<double>(text->line) * lineHeight),
                             text->alignment, text->width);
    };
    const Tag tag(row.cells ? "/TR" : "/LI", row.key);
    if (!row.cells) {
        const Tag body("/LBody");
        drawTexts(0);
        return;
    }
    for (std::size_t i = 0; i < row.cells->size(); ++i) {
        if ((*row.cells)[i].columns == 0)
            continue;
        const Tag cell((*row.cells)[i], row.key + 1 + i);
        drawTexts(i);
    }
}

PrintedRow lineOf(const PrintedRow &row, std::size_t index) {
    PrintedRow result;
    if (index == 0)
        result.signs = row.signs;
    result.cells = row.cells;
    result.key = row.key;
    for (const PlacedText &text : row.texts) {
        if (index >= text.line && index - text.line < text.block.lineCount())
            result.texts.push_back(
                {text.block.line(index - text.line), text.x, text.width, text.alignment, 0, text.cell});
    }
    return result;
}

struct RowEdges {
    double above = 0;
    double below = 0;
    bool groupEnds = false;
    bool tableEnds = false;
    QString link = {};
    bool strong = false; ///< black rule at the end of a group
};

/// `make` returns the row when it is drawn.
template <class Make>
void addRow(Strips &strips, const RowExtent &row, const Make &make, double lineHeight, double width,
            const RowEdges &edges, const std::shared_ptr<Strip> &head) {
    const bool split = static_cast<double>(row.lines) * lineHeight > tallestRow;
    const std::size_t parts = split ? row.lines : 1;
    for (std::size_t i = 0; i < parts; ++i) {
        const double above = i == 0 ? edges.above : 0;
        const bool last = i + 1 == parts;
        Strip strip;
        strip.height =
            above + static_cast<double>(split ? 1 : row.lines) * lineHeight + (last ? edges.below : 0);
        strip.head = head;
        strip.closingRule = width;
        strip.link = edges.link;
        strip.draw = [make, split, i, above, width, height = strip.height, group = last && edges.groupEnds,
                      strong = edges.strong, end = last && edges.tableEnds](QPainter &painter, QPointF at) {
            const std::shared_ptr<const PrintedRow> made = make();
            drawRow(painter, at + QPointF(0, above), split ? lineOf(*made, i) : *made);
            if (end)
                drawRule(painter, at + QPointF(0, height), width, outerRule);
            else if (group && strong)
                drawRule(painter, at + QPointF(0, height), width, headRule);
            else if (group)
                drawRule(painter, at + QPointF(0, height), width, groupRule, groupGrey);
        };
        strips.push_back(std::move(strip));
    }
}

/// The same for a row that is kept.
void addKeptRow(Strips &strips, PrintedRow row, double lineHeight, double width, const RowEdges &edges,
                const std::shared_ptr<Strip> &head) {
    const RowExtent extent = row.extent;
    addRow(
        strips, extent, [kept = std::make_shared<const PrintedRow>(std::move(row))] { return kept; },
        lineHeight, width, edges, head);
}

/// Short tables stay together; longer ones have at least `least` rows on each side of a break.
void keepTogether(Strips &strips, bool all, bool headed, std::size_t least) {
    const std::size_t first = headed ? 1 : 0; // index of the first row
    for (std::size_t i = 0; i + 1 < strips.size(); ++i) {
        const bool top = i < first + least - 1;
        const bool end = i + least >= strips.size();
        strips[i].withNext = strips[i].withNext || all || top || end;
    }
}

/// Additional height below each row for cells that span several rows.
std::vector<double> roomBelow(const std::vector<RowExtent> &rows, double padding) {
    std::vector<double> result(rows.size(), 0);
    const double lineHeight = textSize * cellStyle.leading;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const std::size_t end = std::min(r + rows[r].beside, rows.size());
        double height = -2 * padding;
        for (std::size_t i = r; i < end; ++i)
            height += static_cast<double>(rows[i].lines) * lineHeight + 2 * padding;
        if (rows[r].beside > 1)
            result[end - 1] = std::max(0.0, static_cast<double>(rows[r].besideLines) * lineHeight - height);
    }
    return result;
}

/// A column title, reduced if one of its words is wider than the column.
TextBlock headText(const Phrase &title, double room) {
    constexpr double smallest = 7;
    TextStyle style = cellStyle;
    double widest = 0;
    for (const QString &word : title.plain().split(u' ', Qt::SkipEmptyParts))
        widest = std::max(widest, textWidth(word, styled(true)));
    while (widest * style.size / cellStyle.size > room && style.size > smallest)
        style.size -= 0.1;
    style.leading *= cellStyle.size / style.size;
    return {richText(title, true), style, room};
}

class TableHead {
public:
    TableHead(const Table &table, const std::vector<Place> &places, double width)
        : m_width(width) {
        double below = 0; // height of titles and units
        const bool units =
            std::ranges::any_of(table.columns, [](const Column &column) { return !column.unit.isEmpty(); });
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const Column &column = table.columns[i];
            const Place &place = places[i];
            const auto last =
                std::min(i + static_cast<std::size_t>(std::max(column.titleSpan, 1)), places.size()) - 1;
            // May extend halfway to its neighbour: to the right, above numbers to the left.
            const bool right = column.alignment != Alignment::left;
            const double room = places[last].right() - place.left + cellPadding;
            Title title;
            if (!column.title.plain().isEmpty())
                title.name = headText(column.title, room);
            if (!column.unit.isEmpty())
                title.unit = TextBlock(column.unit, styled(false, noteGrey), room);
            title.alignment = textAlignment(column.alignment);
            title.x = place.left;
            const std::size_t before = i == 0 ? 0 : m_titles.back().owner;
            const bool covered = i > 0 && i < before + static_cast<std::size_t>(m_titles[before].tag.columns);
            title.owner = covered ? before : i;
            title.tag = {static_cast<int>(last - i) + 1, 1, "/Column"};
            title.width = places[last].right() - place.left;
            // Above numbers the line for units is kept free.
            const bool free = units && right && title.unit.empty() && !title.name.empty();
            below = std::max(below, title.name.height() +
                                        (free ? textSize * cellStyle.leading : title.unit.height()));
            m_titles.push_back(std::move(title));
        }
        const bool spanned = !table.spanners.empty();
        double spannersHeight = 0;
        double underSpanners = 0;
        for (const Spanner &spanner : table.spanners) {
            const std::size_t last = std::min(spanner.first + spanner.count, places.size()) - 1;
            const double left = places[spanner.first].left;
            const double length = places[last].right() - left;
            m_spanners.push_back({spanner.first,
                                  {TextBlock(richText(spanner.title, true), cellStyle, length), left, length},
                                  {static_cast<int>(last - spanner.first) + 1, 1, "/Column"}});
            spannersHeight = std::max(spannersHeight, m_spanners.back().title.block.height());
            for (std::size_t i = spanner.first; i <= last; ++i)
                underSpanners =
                    std::max(underSpanners, m_titles[i].name.height() + m_titles[i].unit.height());
        }
        double inner = below;
        if (spanned)
            inner = std::max(below, spannersHeight + 2 * spannerGap + underSpanners);
        m_height = headAbove + inner + headBelow;
        m_spannerRule = headAbove + spannersHeight + spannerGap;
    }

    [[nodiscard]] double height() const { return m_height; }

    void draw(QPainter &painter, QPointF at) const {
        painter.fillRect(QRectF(at, QSizeF(m_width, m_height)), headTint);
        drawRule(painter, at, m_width, outerRule);
        drawRule(painter, at + QPointF(0, m_height), m_width, headRule);
        const bool units = std::any_of(m_titles.begin(), m_titles.end(),
                                       [](const Title &title) { return !title.unit.empty(); });
        std::optional<Tag> repeated;
        if (!Tag::isFirst(this))
            repeated.emplace(nullptr);
        tagCells();
        const double bottom = at.y() + m_height - headBelow;
        const double unitHeight = textSize * cellStyle.leading;
        for (std::size_t i = 0; i < m_titles.size(); ++i) {
            const Title &title = m_titles[i];
            for (const HeadSpanner &spanner : m_spanners) { // precedes its first column in reading order
                if (spanner.first == i)
                    drawSpanner(painter, at, spanner.title);
            }
            if (title.name.empty())
                continue;
            // Aligned at the bottom; above numbers the line for units is kept free.
            const bool free = units && (title.alignment == TextAlignment::right || !title.unit.empty());
            const double top = bottom - title.name.height() - (free ? unitHeight : 0);
            const Title &owner = m_titles[title.owner];
            const Tag tag(owner.tag, &owner);
            title.name.draw(painter, {at.x() + title.x, top}, title.alignment, title.width);
        }
        for (const Title &title : m_titles) {
            if (title.unit.empty())
                continue;
            const Title &owner = m_titles[title.owner];
            const Tag tag(owner.tag, &owner);
            title.unit.draw(painter, {at.x() + title.x, bottom - title.unit.height()}, title.alignment,
                            title.width);
        }
    }

private:
    /// Titles are drawn before units: the cells of both stand in the structure before.
    void tagCells() const {
        if (!m_spanners.empty()) {
            const Tag row("/TR", &m_spanners);
            for (std::size_t i = 0; i < m_titles.size(); ++i) {
                const auto spanner = std::ranges::find(m_spanners, i, &HeadSpanner::first);
                const Tag cell(spanner == m_spanners.end() ? CellTag() : spanner->tag,
                               spanner == m_spanners.end() ? nullptr : &spanner->title);
                i += spanner == m_spanners.end() ? 0 : static_cast<std::size_t>(spanner->tag.columns) - 1;
            }
        }
        const Tag row("/TR", &m_titles);
        for (std::size_t i = 0; i < m_titles.size(); i += static_cast<std::size_t>(m_titles[i].tag.columns))
            const Tag cell(m_titles[i].tag, &m_titles[i]);
    }

    void drawSpanner(QPainter &painter, QPointF at, const PlacedText &title) const {
        const Tag tag("/TH", &title);
        title.block.draw(painter, at + QPointF(title.x, headAbove), TextAlignment::centre, title.width);
        drawRule(painter, at + QPointF(title.x, m_spannerRule), title.width, groupRule);
    }

    struct HeadSpanner {
        std::size_t first = 0;
        PlacedText title;
        CellTag tag = {};
    };
    struct Title {
        TextBlock name;
        TextBlock unit;
        double x = 0;
        double width = 0;
        TextAlignment alignment = TextAlignment::left;
        CellTag tag = {};
        std::size_t owner = 0; ///< index of the title whose cell it belongs to
    };

    double m_width = 0;
    double m_height = 0;
    double m_spannerRule = 0;
    std::vector<Title> m_titles;
    std::vector<HeadSpanner> m_spanners;
};

/// The cells of the rows of a table, one by one from the first.
class CellTags {
public:
    explicit CellTags(const Table &table)
        : m_headless(table.headless)
        , m_covered(table.columns.size()) {
        if (table.rowCount() > mostRows) {
            std::vector<CellTag> row(m_covered.size(), CellTag{0});
            row.back() = {static_cast<int>(m_covered.size())};
            m_ofRow = std::make_shared<const std::vector<CellTag>>(std::move(row));
        }
    }

    /// Long tables are told row by row: each is one cell.
    std::shared_ptr<const std::vector<CellTag>> of(const std::vector<Cell> &cells) {
        const int count = static_cast<int>(m_covered.size());
        if (m_ofRow)
            return m_ofRow;
        std::vector<CellTag> row;
        int spanned = 0;
        for (std::size_t i = 0; i < m_covered.size(); ++i) {
            if (m_covered[i] > 0 || spanned > 0) {
                m_covered[i] -= m_covered[i] > 0 ? 1 : 0;
                spanned -= spanned > 0 ? 1 : 0;
                row.push_back({0});
                continue;
            }
            const int columns =
                std::min(static_cast<int>(cells[i].extras->columns), count - static_cast<int>(i));
            const int rows = static_cast<int>(cells[i].extras->rows);
            row.push_back({columns, rows, m_headless && i == 0 ? "/Row" : nullptr});
            m_covered[i] = rows - 1;
            spanned = columns - 1;
        }
        return std::make_shared<const std::vector<CellTag>>(std::move(row));
    }

private:
    static constexpr std::size_t mostRows = 2000;

    std::shared_ptr<const std::vector<CellTag>> m_ofRow;
    bool m_headless;
    std::vector<int> m_covered; ///< rows by the cell above, by column
};

PrintedRow rowOf(const Table &table, const std::vector<Cell> &cells, const std::vector<Place> &columns) {
    PrintedRow row;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const Cell &cell = cells[i];
        const Column &column = table.columns[i];
        const bool beforeNumber = column.alignment == Alignment::left && !column.flexible &&
                                  cell.mark == Mark::none && !cell.text.plain().isEmpty() &&
                                  i + 1 < columns.size() &&
                                  table.columns[i + 1].alignment == Alignment::decimal;
        if (beforeNumber && TextBlock(richText(cell.text, cell.bold), cellStyle).width() > columns[i].width) {
            const double room = beginningOf(cells[i + 1], columns[i + 1]) - 2 * cellPadding - columns[i].left;
            row.texts.push_back(narrowText(cell, columns[i], std::max(room, columns[i].width)));
            row.texts.back().cell = i;
            row.extent.lines = std::max(row.extent.lines, row.texts.back().block.lineCount());
            continue;
        }
        Place place = columns[i];
        if (cell.extras->columns > 1)
            place.width =
                columns[std::min(i + cell.extras->columns, columns.size()) - 1].right() - place.left;
        const std::size_t before = row.texts.size();
        addCell(row, cell, column, place);
        for (std::size_t k = before; k < row.texts.size(); ++k)
            row.texts[k].cell = i;
    }
    return row;
}

/// Makes the rows of a table: those of a short one at once, others when they are drawn.
struct TableContent {
    TableContent(std::shared_ptr<const Table> of, std::vector<Place> places)
        : table(std::move(of))
        , columns(std::move(places)) {}

    std::shared_ptr<const Table> table;
    std::vector<Place> columns;
    std::vector<std::shared_ptr<const std::vector<CellTag>>> cells = {}; ///< by row
    std::vector<char> keys = {}; ///< one address for each row and cell, which tells them apart (Tag)
    std::vector<std::shared_ptr<const PrintedRow>> kept = {}; ///< the rows of a short table

    /// Adds the next row.
    RowExtent add(const std::vector<Cell> &row, std::shared_ptr<const std::vector<CellTag>> tags) {
        const std::size_t index = cells.size();
        cells.push_back(std::move(tags));
        PrintedRow made = printed(row, index);
        const RowExtent extent = made.extent;
        if (table->rowCount() <= mostKept)
            kept.push_back(std::make_shared<const PrintedRow>(std::move(made)));
        return extent;
    }
    [[nodiscard]] std::shared_ptr<const PrintedRow> row(std::size_t index) const {
        if (!kept.empty())
            return kept[index];
        return std::make_shared<const PrintedRow>(
            table->withRow(index, [&](const std::vector<Cell> &row) { return printed(row, index); }));
    }

private:
    static constexpr std::size_t mostKept = 100;

    [[nodiscard]] PrintedRow printed(const std::vector<Cell> &row, std::size_t index) const {
        PrintedRow result = rowOf(*table, row, columns);
        result.cells = cells[index];
        result.key = keys.data() + index * (columns.size() + 1);
        return result;
    }
};

} // namespace

RichText richText(const Phrase &phrase, bool bold) {
    RichText result;
    for (const Span &span : phrase.spans) {
        TextRun run;
        run.text = span.text;
        run.bold = (bold || span.bold) && !span.muted;
        run.italic = span.italic;
        run.script = span.subscript ? TextRun::Script::subscript : TextRun::Script::normal;
        run.grey = span.muted;
        result.push_back(run);
    }
    return result;
}

Strips tableStrips(const std::shared_ptr<const Table> &shared, double width) {
    const Table &table = *shared;
    const auto content = std::make_shared<TableContent>(shared, places(table, width));
    content->keys.resize(table.rowCount() * (table.columns.size() + 1));
    content->cells.reserve(table.rowCount());
    Strips strips;
    strips.reserve(table.rowCount() + 1); // of a long table they take much memory
    std::shared_ptr<Strip> head;
    if (!table.headless) {
        const auto titles = std::make_shared<TableHead>(table, content->columns, width);
        head = std::make_shared<Strip>();
        head->height = titles->height();
        head->draw = [titles](QPainter &painter, QPointF at) { titles->draw(painter, at); };
        strips.push_back(*head);
    }
    std::vector<RowExtent> rows;
    rows.reserve(table.rowCount());
    CellTags tags(table);
    table.eachRow(
        [&](const std::vector<Cell> &cells) { rows.push_back(content->add(cells, tags.of(cells))); });
    const double padding = table.narrow ? narrowPadding : rowPadding;
    const std::vector<double> below = roomBelow(rows, padding);
    std::size_t together = 0; // rows before this one stay with the next
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const auto isIn = [r](const std::vector<std::size_t> &rules) {
            return std::binary_search(rules.begin(), rules.end(), r);
        };
        const bool last = r + 1 == rows.size();
        const bool strong = isIn(table.strongRulesAfter);
        together = std::max(together, r + rows[r].beside);
        const std::size_t before = strips.size();
        addRow(
            strips, rows[r],
            [made = std::shared_ptr<const TableContent>(content), r] { return made->row(r); },
            textSize * cellStyle.leading, width,
            {padding, padding + below[r], strong || isIn(table.rulesAfter), last,
             r < table.links.size() ? table.links[r] : QString(), strong},
            head);
        for (std::size_t i = before; r + 1 < together && i < strips.size(); ++i)
            strips[i].withNext = true;
    }
    if (table.headless && !strips.empty()) {
        strips.front().draw = [draw = strips.front().draw, width](QPainter &painter, QPointF at) {
            drawRule(painter, at, width, outerRule);
            draw(painter, at);
        };
    }
    double height = 0;
    for (const Strip &strip : strips)
        height += strip.height;
    const bool isShort = rows.size() <= wholeRows && height <= tallestRow;
    keepTogether(strips, table.unbroken || isShort, !table.headless, leastRows);
    return strips;
}

Strips findingStrips(const FindingsBlock &findings, double width) {
    const TextStyle style{findings.narrow ? textSize : 9, false, black, findings.narrow ? 1.2 : 1.28};
    const double padding = findings.narrow ? narrowPadding : 0.5 * mm;
    constexpr double textLeft = firstPadding + 3.2 * mm + cellPadding;
    constexpr double widestClause = 40 * mm;
    double clauseWidth = 12 * mm; // or as wide as two lines of each need
    double gradeWidth = 14 * mm;
    for (const FindingLine &line : findings.lines) {
        TextStyle bold = style;
        bold.bold = line.grade == Grade::requirement;
        gradeWidth = std::max(gradeWidth, textWidth(line.gradeName, bold) + cellPadding);
        const auto isTooNarrow = [&] {
            const TextBlock clause(line.clause, style, clauseWidth);
            return clause.lineCount() > 2 || clause.splitsWord();
        };
        while (clauseWidth < widestClause && isTooNarrow())
            clauseWidth += mm;
    }
    const double sentenceLeft = textLeft + gradeWidth + 2 * cellPadding;
    const double clauseLeft = width - cellPadding - clauseWidth;
    const double sentenceWidth = clauseLeft - cellPadding - sentenceLeft;
    const auto topRule = std::make_shared<Strip>(); // repeated where the findings continue
    topRule->draw = [width](QPainter &painter, QPointF at) { drawRule(painter, at, width, outerRule); };
    topRule->height = 0.6 * mm;

    Strips strips;
    std::vector<std::size_t> headings;
    for (std::size_t i = 0; i < findings.lines.size(); ++i) {
        const FindingLine &line = findings.lines[i];
        if (!line.heading.isEmpty()) {
            TextStyle bold = style;
            bold.bold = true;
            PrintedRow heading;
            heading.texts.push_back({TextBlock(line.heading, bold, width - 2 * firstPadding), firstPadding});
            heading.extent.lines = heading.texts[0].block.lineCount();
            headings.push_back(strips.size());
            addKeptRow(strips, std::move(heading), style.size * style.leading, width,
                       {padding, padding, false, false}, topRule);
        }
        TextStyle grade = style;
        grade.bold = line.grade == Grade::requirement;
        TextStyle clause = style;
        if (line.clause.isEmpty())
            clause.colour = dashGrey;
        PrintedRow row;
        row.signs.push_back({markOf(line.grade), {}, firstPadding});
        row.texts.push_back({TextBlock(line.gradeName, grade), textLeft});
        row.texts.push_back({TextBlock(richText(line.sentence), style, sentenceWidth), sentenceLeft});
        row.texts.push_back({TextBlock(line.clause.isEmpty() ? thinDash : line.clause, clause, clauseWidth),
                             clauseLeft, clauseWidth, TextAlignment::right});
        row.extent.lines = std::max(row.texts[1].block.lineCount(), row.texts[2].block.lineCount());
        const bool last = i + 1 == findings.lines.size();
        addKeptRow(strips, std::move(row), style.size * style.leading, width,
                   {padding, padding + (last ? topRule->height : 0), false, last}, topRule);
    }
    if (!strips.empty())
        strips.insert(strips.begin(), *topRule);
    constexpr std::size_t leastFindings = 2;
    keepTogether(strips, false, true, leastFindings);
    for (const std::size_t heading : headings) // after the rule at the top
        strips[heading + 1].withNext = true;
    return strips;
}

} // namespace palmer
