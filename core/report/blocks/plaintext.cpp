// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/blocks/plaintext.h"

#include "report/blocks/pagetext.h"

#include <QStringList>
#include <algorithm>
#include <array>
#include <ranges>

namespace palmer {

namespace {

constexpr QChar thinDash(u'–');
constexpr QChar ruleOfTable(u'─');
constexpr QChar headRule(u'━');
constexpr int smallestName = 16; ///< least width of a flexible column, in columns of the terminal

struct Range {
    char32_t first;
    char32_t last;
};

/// Blocks of wide characters (Unicode, East Asian Width W and F), approximate.
constexpr std::array wideRanges{Range{0x1100, 0x115F},  Range{0x2E80, 0x303E}, Range{0x3041, 0xA4CF},
                                Range{0xAC00, 0xD7A3},  Range{0xF900, 0xFAFF}, Range{0xFE30, 0xFE6F},
                                Range{0xFF00, 0xFF60},  Range{0xFFE0, 0xFFE6}, Range{0x1F300, 0x1FAFF},
                                Range{0x20000, 0x3FFFD}};

int widthOf(char32_t character) {
    switch (QChar::category(character)) {
    case QChar::Mark_NonSpacing:
    case QChar::Mark_Enclosing:
    case QChar::Other_Format:
    case QChar::Other_Control:
        return 0;
    default:
        break;
    }
    const bool wide = std::ranges::any_of(
        wideRanges, [character](const Range &r) { return character >= r.first && character <= r.last; });
    return wide ? 2 : 1;
}

QString spaces(int count) {
    return {std::max(count, 0), u' '};
}

QString orDash(const QString &text) {
    return text.isEmpty() ? QString(thinDash) : text;
}

bool isDecimalMark(QChar c) {
    return c == u'.' || c == u',';
}

/// Columns before the decimal mark, or of the whole number if it has none.
int wholeWidth(const QString &text) {
    const auto mark = std::ranges::find_if(text, isDecimalMark);
    return displayWidth(QStringView(text).first(mark - text.begin()));
}

bool isNumber(const QString &text) {
    return std::ranges::any_of(text, [](QChar c) { return c.isDigit(); });
}

/// A column prepared for printing: its cells as text, its width, and the position of the decimal mark.
struct Layout {
    int width = 0;
    int whole = 0; ///< columns before the decimal mark
    QStringList cells;
};

/// Aligns a number at the decimal mark of its column.
QString withMark(const QString &cell, int whole) {
    return isNumber(cell) ? spaces(whole - wholeWidth(cell)) + cell : cell;
}

Layout layout(const Table &table, std::size_t index) {
    const Column &column = table.columns[index];
    Layout result;
    for (const auto &row : table.rows) {
        result.cells << orDash(row[index].text.plain());
        if (column.alignment == Alignment::decimal && isNumber(result.cells.back()))
            result.whole = std::max(result.whole, wholeWidth(result.cells.back()));
    }
    if (column.alignment == Alignment::decimal) {
        int numbers = 0;
        for (QString &cell : result.cells) {
            cell = withMark(cell, result.whole);
            numbers = std::max(numbers, displayWidth(cell));
        }
        for (QString &cell : result.cells) {
            // A dash is aligned with the last integer digit.
            const int before = isNumber(cell) ? 0 : result.whole - displayWidth(cell);
            cell = spaces(before) + cell;
            cell += spaces(numbers - displayWidth(cell));
        }
    }
    for (const QString &cell : result.cells)
        result.width = std::max(result.width, displayWidth(cell));
    result.width = std::max({result.width, displayWidth(column.title.plain()), displayWidth(column.unit)});
    return result;
}

QString padded(const QString &text, int width, Alignment alignment) {
    const QString space = spaces(width - displayWidth(text));
    return alignment == Alignment::left ? text + space : space + text;
}

/// Unpacks the rows, and leaves out columns of pictures, which would be columns of dashes.
Table withoutPictures(Table table) {
    for (std::size_t i = 0; i < table.packed.count(); ++i)
        table.rows.push_back(table.packed.row(i));
    table.packed = {};
    for (std::size_t i = table.columns.size(); i-- > 0;) {
        const auto any = [&](auto has) {
            return std::ranges::any_of(table.rows, [&](const std::vector<Cell> &row) { return has(row[i]); });
        };
        if (any([](const Cell &cell) { return !cell.text.plain().isEmpty(); }) || !any([](const Cell &cell) {
                return cell.extras->guard || cell.extras->whisker || cell.extras->bar;
            }))
            continue;
        eraseColumn(table, i);
    }
    return table;
}

class TablePrinter {
public:
    TablePrinter(const Table &table, int width)
        : m_table(table) {
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            m_columns.push_back(layout(table, i));
        if (total() > width)
            narrow(width);
        if (total() > width)
            m_gap = 1;
    }

    [[nodiscard]] QStringList lines() const {
        QStringList result;
        result << QString(total(), headRule);
        result << head([](const Column &column) { return column.title.plain(); });
        const auto hasUnit = [](const Column &column) { return !column.unit.isEmpty(); };
        if (std::ranges::any_of(m_table.columns, hasUnit))
            result << head([](const Column &column) { return column.unit; });
        result << QString(total(), ruleOfTable);
        for (std::size_t row = 0; row < m_table.rows.size(); ++row) {
            result << rowLines(row);
            const bool last = row + 1 == m_table.rows.size();
            if (!last && std::ranges::binary_search(m_table.rulesAfter, row))
                result << QString(total(), ruleOfTable);
        }
        result << QString(total(), headRule);
        return result;
    }

private:
    [[nodiscard]] int total() const {
        int sum = 0;
        for (const Layout &column : m_columns)
            sum += column.width;
        return sum + m_gap * (static_cast<int>(m_columns.size()) - 1);
    }

    /// Reduces the first flexible column until the table fits.
    void narrow(int width) {
        for (std::size_t i = 0; i < m_columns.size(); ++i) {
            if (!m_table.columns[i].flexible)
                continue;
            m_columns[i].width = std::max(m_columns[i].width - (total() - width), smallestName);
            return;
        }
    }

    [[nodiscard]] QString joined(const QStringList &cells) const { return cells.join(spaces(m_gap)); }

    template <typename Part>
    [[nodiscard]] QString head(Part part) const {
        QStringList cells;
        for (std::size_t i = 0; i < m_columns.size(); ++i)
            cells << padded(part(m_table.columns[i]), m_columns[i].width, m_table.columns[i].alignment);
        return joined(cells);
    }

    [[nodiscard]] QStringList rowLines(std::size_t row) const {
        std::vector<QStringList> parts;
        qsizetype height = 1;
        for (std::size_t i = 0; i < m_columns.size(); ++i) {
            const QString &cell = m_columns[i].cells[static_cast<qsizetype>(row)];
            parts.push_back(m_table.columns[i].flexible ? wrapped(cell, m_columns[i].width)
                                                        : QStringList(cell));
            height = std::max(height, parts.back().size());
        }
        QStringList result;
        for (qsizetype line = 0; line < height; ++line) {
            QStringList cells;
            for (std::size_t i = 0; i < parts.size(); ++i)
                cells << padded(parts[i].value(line), m_columns[i].width, m_table.columns[i].alignment);
            result << joined(cells);
        }
        return result;
    }

    const Table &m_table;
    std::vector<Layout> m_columns;
    int m_gap = 2;
};

/// Text next to a label: the continuation lines are below the first line of the text.
QStringList hanging(const QString &label, const QString &text, int indent, int width) {
    QStringList result = wrapped(text, width - indent);
    for (qsizetype i = 0; i < result.size(); ++i)
        result[i] = (i == 0 ? label + spaces(indent - displayWidth(label)) : spaces(indent)) + result[i];
    return result;
}

class Printer {
public:
    explicit Printer(int width)
        : m_width(width) {}

    void operator()(const Heading &heading) {
        const QStringList text = wrapped(heading.text, m_width);
        m_lines << text;
        int longest = 0;
        for (const QString &line : text)
            longest = std::max(longest, displayWidth(line));
        if (heading.level == 1)
            m_lines << QString(longest, u'═');
    }
    void operator()(const Paragraph &paragraph) { m_lines << wrapped(paragraph.text, m_width); }
    void operator()(const KeyValues &values) {
        int longest = 0;
        for (const KeyValue &row : values.rows)
            longest = std::max(longest, displayWidth(row.key));
        for (const KeyValue &row : values.rows)
            m_lines << hanging(row.key, orDash(row.value), longest + 2, m_width);
    }
    void operator()(const Table &table) { m_lines << TablePrinter(withoutPictures(table), m_width).lines(); }
    void operator()(const FindingsBlock &findings) {
        int grade = 0;
        int clause = 0;
        for (const FindingLine &line : findings.lines) {
            grade = std::max(grade, displayWidth(line.gradeName));
            clause = std::max(clause, displayWidth(orDash(line.clause)));
        }
        for (const FindingLine &line : findings.lines) {
            if (!line.heading.isEmpty())
                m_lines << wrapped(line.heading, m_width);
            const QString label = padded(line.gradeName, grade + 2, Alignment::left) + orDash(line.clause);
            m_lines << hanging(label, line.sentence.plain(), grade + 2 + clause + 2, m_width);
        }
    }
    void operator()(const VerdictLine &line) {
        const QString first = QStringList{line.label, line.word, line.second}.join(u' ').simplified();
        if (!first.isEmpty())
            m_lines << wrapped(first, m_width);
        int labels = 0;
        for (const VerdictStatement &part : {line.limits, line.accordance})
            labels = std::max(labels, displayWidth(part.label));
        for (const VerdictStatement &part : {line.limits, line.accordance}) {
            const QString text = QString(part.state + u' ' + part.text.plain()).trimmed();
            if (!text.isEmpty())
                m_lines << hanging(part.label, text, labels + 2, m_width);
        }
    }
    /// Blocks that only pages can draw are printed as their words.
    void operator()(const auto &block) {
        for (const QString &line : pageText(Block(block)).split(u'\n', Qt::SkipEmptyParts))
            m_lines << wrapped(line, m_width);
    }

    void newBlock() {
        if (!m_lines.isEmpty())
            m_lines << QString();
    }

    [[nodiscard]] QString text() const {
        QString result;
        for (QString line : m_lines) {
            while (line.endsWith(u' '))
                line.chop(1);
            result += line + u'\n';
        }
        return result;
    }

private:
    int m_width;
    QStringList m_lines;
};

/// True if a blank line precedes the block; a section heading directly precedes its content.
bool separated(const Block *before, const Block &block) {
    const auto *heading = before ? std::get_if<Heading>(before) : nullptr;
    return !heading || heading->level == 1 || std::holds_alternative<Heading>(block);
}

/// The number of blocks from `at` on that only a page can show: a figure, with the heading and the note that
/// have nothing else below them.
std::size_t blocksOfFigure(const std::vector<Block> &blocks, std::size_t at) {
    const auto is = [&]<class Wanted>(std::size_t i, const Wanted *) {
        return i < blocks.size() && std::holds_alternative<Wanted>(blocks[i]);
    };
    constexpr const FigureBlock *figure = nullptr;
    constexpr const Heading *heading = nullptr;
    constexpr const Paragraph *note = nullptr;
    if (is(at, figure))
        return 1;
    if (!is(at, heading))
        return 0;
    std::size_t end = at + 1;
    if (is(end, note) && std::get<Paragraph>(blocks[end]).size == TextSize::small)
        ++end;
    if (!is(end, figure))
        return 0;
    while (is(end, figure))
        ++end;
    return end == blocks.size() || is(end, heading) ? end - at : 0;
}

} // namespace

int displayWidth(QStringView text) {
    int width = 0;
    for (const char32_t character : text.toUcs4())
        width += widthOf(character);
    return width;
}

QStringList wrapped(const QString &text, int width) {
    QStringList lines;
    for (const QString &paragraph : text.split(u'\n')) {
        QString line;
        int used = 0;
        for (const QString &word : paragraph.split(u' ', Qt::SkipEmptyParts)) {
            const int length = displayWidth(word);
            if (!line.isEmpty() && used + 1 + length > width) {
                lines << line;
                line.clear();
                used = 0;
            }
            if (!line.isEmpty()) {
                line += u' ';
                ++used;
            }
            line += word;
            used += length;
        }
        lines << line;
    }
    return lines;
}

QString plainText(const Report &report, int width) {
    Printer printer(width);
    const Block *before = nullptr;
    for (std::size_t i = 0; i < report.blocks.size(); ++i) {
        if (const std::size_t skipped = blocksOfFigure(report.blocks, i); skipped > 0) {
            i += skipped - 1;
            continue;
        }
        const Block &block = report.blocks[i];
        if (separated(before, block))
            printer.newBlock();
        std::visit(printer, block);
        before = &block;
    }
    return printer.text();
}

} // namespace palmer
