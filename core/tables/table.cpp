// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/table.h"

#include "system/memory.h"
#include "tables/cellunits.h"
#include "tables/contenterror.h"
#include "tables/dates.h"
#include "tables/decodetext.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <limits>
#include <map>

namespace palmer {

namespace {

constexpr std::size_t rowLimit = 10'000'000;
constexpr std::size_t cellLimit = 10'000'000; ///< with the empty ones of nearly empty sheets
constexpr std::size_t longestCell = std::numeric_limits<std::uint16_t>::max();
constexpr std::size_t quoteReach = 4096; ///< an unclosed quotation mark is a character beyond this
constexpr std::size_t sampleRows = 300;

/// The shortest decimal that reads back as the same number, without an exponent.
std::string plainDecimals(double value) {
    std::array<char, 400> digits{};
    return {digits.data(),
            std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed).ptr};
}

bool isLineEnd(char c) {
    return c == '\n' || c == '\r';
}

char character(Delimiter delimiter) {
    switch (delimiter) {
    case Delimiter::tab:
        return '\t';
    case Delimiter::semicolon:
        return ';';
    case Delimiter::comma:
        return ',';
    case Delimiter::bar:
        return '|';
    case Delimiter::colon:
        return ':';
    case Delimiter::blanks:
        return ' ';
    }
    return ' ';
}

// "#N/A" in the first cell is a value, not a comment; "#;Target" heads a column of numbers.
std::size_t commentMark(std::string_view line, char delimiter) {
    if (line.starts_with("//"))
        return 2;
    if (line.starts_with('%'))
        return 1;
    if (!line.starts_with('#') || (delimiter != ' ' && line.substr(1).starts_with(delimiter)))
        return 0;
    for (const std::string_view word :
         {"#N/A", "#n/a", "#NV", "#NA", "#REF!", "#DIV/0!", "#VALUE!", "#VALEUR!"}) {
        if (line.starts_with(word))
            return 0;
    }
    return 1;
}

/// Bytes of a cell to keep, without splitting a character.
std::uint16_t keptSize(std::string_view cell) {
    std::size_t size = std::min(cell.size(), longestCell);
    while (size < cell.size() && size > 0 && (static_cast<unsigned char>(cell[size]) & 0xC0U) == 0x80U)
        --size;
    return static_cast<std::uint16_t>(size);
}

/// A single pass over a text.
class Scanner {
public:
    Scanner(std::string_view text, Delimiter delimiter, DecimalMark mark, bool comments)
        : m_text(text)
        , m_delimiter(character(delimiter))
        , m_blanks(delimiter == Delimiter::blanks)
        , m_mark(mark)
        , m_comments(comments) {}

    std::vector<TableRow> rows;
    std::vector<TableCell> cells;
    bool saysUnits = false; ///< "1.234 mm" in a cell

    void scan(std::size_t mostRows) {
        while (m_at < m_text.size() && rows.size() < mostRows)
            scanLine();
    }

    /// Where the next line begins.
    [[nodiscard]] std::size_t at() const { return m_at; }

private:
    [[nodiscard]] bool atLineEnd() const { return m_at == m_text.size() || isLineEnd(m_text[m_at]); }
    [[nodiscard]] bool isBlank(char c) const {
        return c == ' ' || (c == '\t' && m_delimiter != '\t') || c == '\f';
    }

    [[nodiscard]] bool isBlankAt(std::size_t at) const {
        return at >= m_text.size() || isLineEnd(m_text[at]) || isBlank(m_text[at]);
    }
    /// A colon within a cell is a time or belongs to a word.
    [[nodiscard]] bool isDelimiter(std::size_t at) const {
        return m_text[at] == m_delimiter && (m_delimiter != ':' || (isBlankAt(at - 1) && isBlankAt(at + 1)));
    }

    void skipBlanks() {
        while (m_at < m_text.size() && isBlank(m_text[m_at]))
            ++m_at;
    }

    void scanLine() {
        const std::size_t begin = m_at;
        TableRow row{static_cast<std::uint32_t>(cells.size()), 0, m_line, false};
        skipBlanks();
        const std::size_t mark = m_comments ? commentMark(m_text.substr(m_at, 8), m_delimiter) : 0;
        if (mark > 0) {
            row.comment = true;
            m_at += mark;
            const std::size_t end = std::min(m_text.find_first_of("\r\n", m_at), m_text.size());
            addText(m_at, end);
            m_at = end;
        } else if (!atLineEnd()) {
            if (!m_blanks)
                m_at = begin;
            scanCells();
        }
        skipLineEnd();
        row.count = static_cast<std::uint32_t>(cells.size() - row.first);
        const bool empty = std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(row.first), cells.end(),
                                       [](const TableCell &cell) { return cell.kind == CellKind::empty; });
        if (empty) {
            cells.resize(row.first);
            return;
        }
        rows.push_back(row);
        if (rows.size() > rowLimit || cells.size() > cellLimit)
            refuseTableSize(placeOfLine(row.line));
    }

    void skipLineEnd() {
        if (m_at == m_text.size())
            return;
        if (m_text[m_at] == '\r' && m_at + 1 < m_text.size() && m_text[m_at + 1] == '\n')
            ++m_at;
        ++m_at;
        ++m_line;
    }

    void scanCells() {
        for (;;) {
            scanCell();
            if (atLineEnd())
                return;
            if (m_blanks) {
                skipBlanks();
                if (atLineEnd())
                    return;
                continue;
            }
            ++m_at; // the delimiter
        }
    }

    /// Stops at a delimiter or the end of the line.
    void scanCell() {
        skipBlanks();
        // Numbers, the bulk of tables, in one pass.
        const LeadingNumber number = leadingNumber(m_text.substr(m_at, 64), m_mark);
        if (number.size > 0) {
            const std::size_t begin = m_at;
            const std::size_t end = begin + number.size;
            std::size_t next = end;
            while (!m_blanks && next < m_text.size() && isBlank(m_text[next]))
                ++next;
            if (next == m_text.size() || isLineEnd(m_text[next]) || isDelimiter(next) ||
                (m_blanks && isBlank(m_text[next]))) {
                if (m_blanks && addWithUnit(begin, next))
                    return;
                cells.push_back({number.value, static_cast<std::uint32_t>(begin),
                                 static_cast<std::uint16_t>(end - begin), CellKind::number});
                m_at = next;
                return;
            }
        }
        if (m_at < m_text.size() && m_text[m_at] == '"' && scanQuoted())
            return;
        const std::size_t begin = m_at;
        while (!atLineEnd() && !isDelimiter(m_at) && !(m_blanks && isBlank(m_text[m_at])))
            ++m_at;
        addText(begin, m_at);
    }

    /// "1.234 mm" in a blank-separated line is one cell.
    bool addWithUnit(std::size_t begin, std::size_t end) {
        if (end == m_text.size() || m_text[end] != ' ')
            return false;
        const std::size_t last = std::min(m_text.find_first_of(" \t\f\r\n", end + 1), m_text.size());
        if (!isUnitSign(m_text.substr(end + 1, last - end - 1)))
            return false;
        addText(begin, last);
        m_at = last;
        return true;
    }

    /// True between signs of seconds in a row of units: "°;";"".
    [[nodiscard]] bool isMadeOfDelimiters(std::string_view text) const {
        return !m_blanks && text.find(m_delimiter) != std::string_view::npos &&
               std::ranges::all_of(text, [&](char c) { return c == m_delimiter || c == '"' || isBlank(c); });
    }

    bool scanQuoted() {
        const std::size_t begin = m_at + 1;
        const std::size_t last = std::min(m_text.size(), begin + quoteReach);
        for (std::size_t i = begin; i < last; ++i) {
            if (m_text[i] != '"')
                continue;
            if (i + 1 < m_text.size() && m_text[i + 1] == '"') {
                ++i;
                continue;
            }
            std::size_t next = i + 1;
            while (next < m_text.size() && isBlank(m_text[next]))
                ++next;
            const bool closes = next == m_text.size() || isLineEnd(m_text[next]) || isDelimiter(next) ||
                                (m_blanks && next > i + 1);
            if (!closes || isMadeOfDelimiters(m_text.substr(begin, i - begin)))
                return false;
            addText(begin, i);
            for (std::size_t j = begin; j < i; ++j)
                m_line += m_text[j] == '\n' || (m_text[j] == '\r' && m_text[j + 1] != '\n') ? 1 : 0;
            m_at = m_blanks ? i + 1 : next;
            return true;
        }
        return false;
    }

    void addText(std::size_t begin, std::size_t end) {
        const std::string_view whole = m_text.substr(begin, end - begin);
        const std::string_view bare = withoutBlanks(whole);
        CellValue value = readCell(bare, m_mark);
        // Among commas a blank parts numbers as well: "100 150,71 300,85".
        if (m_delimiter == ',' && value.kind == CellKind::number && bare.find(' ') != std::string_view::npos)
            value = {CellKind::broken};
        saysUnits = saysUnits || (value.kind == CellKind::text && cellWithUnit(bare, m_mark));
        const auto at = static_cast<std::size_t>(bare.data() - m_text.data());
        cells.push_back(
            {value.value, static_cast<std::uint32_t>(bare.empty() ? begin : at), keptSize(bare), value.kind});
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::uint32_t m_line = 1;
    char m_delimiter;
    bool m_blanks;
    DecimalMark m_mark;
    bool m_comments;
};

/// A sample of the text read with a delimiter and decimal mark.
struct Reading {
    Delimiter delimiter = Delimiter::tab;
    DecimalMark mark = DecimalMark::point;
    double score = 0;
    double rival = 0;            ///< the score before a penalty
    bool hasMark = false;        ///< a number with decimals
    bool mayBeGrouped = false;   ///< all of them may have thousands separators
    bool isRound = false;        ///< each of them ends with 0, as 1.000 and 1.500 do
    double broken = 0;           ///< cells that are neither a complete number nor a word
    std::size_t columns = 0;     ///< of most rows
    std::vector<double> numbers; ///< of the rows that are alike
    std::vector<double> all;     ///< of all rows, sorted
};

/// True if blanks split the same numbers as another delimiter, and words too.
bool onlyPartsWords(const Reading &blanks, const Reading &best) {
    return blanks.delimiter == Delimiter::blanks && best.delimiter != Delimiter::blanks &&
           best.delimiter != Delimiter::comma && blanks.mark == best.mark &&
           std::ranges::includes(blanks.all, best.all);
}

// Integers written as "05" are decimals of a split number.
bool isTorn(std::string_view number) {
    return number.size() > 1 && number[0] == '0' && number[1] >= '0' && number[1] <= '9';
}

// Several numbers in one cell, with or without units, or with words between them: the delimiter is another
// one.
bool isUncut(std::string_view text) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const bool isSplitLine = text.find_first_of(";|\t") != std::string_view::npos && isDigit(text.front()) &&
                             isDigit(text.back()); // "000;forward;1;3"
    return isSplitLine ||
           (text.find_first_of("0123456789") != std::string_view::npos &&
            text.find_first_of(";|,\t") != std::string_view::npos &&
            text.find_first_not_of("0123456789.,;|\t+-eE mnuµ°′″'\"") == std::string_view::npos);
}

/// A row of a sample with at least one number.
struct SampleRow {
    std::size_t count = 0; ///< number of cells
    std::vector<double> numbers;
};

/// Evidence in the cells of a sample about its form.
struct SampleSigns {
    double broken = 0; ///< cells that are neither a complete number nor a word
    double torn = 0;
    bool words = false; ///< a row of several cells without a number
    bool spaced = false;
    bool hasMark = false; ///< a number with decimals
    bool proven = false;  ///< a number whose mark cannot separate thousands
    bool fine = false;    ///< a number with decimals that does not end with 0
};

/// "1.000", "25,400": thousands, or decimals of a short axis. "0.125", "1.5" and "1200.000" are not
/// thousands, and no axis is 100 m long.
bool mayBeGrouped(std::string_view number, char mark) {
    constexpr std::size_t decimals = 3;
    constexpr std::size_t longest = 2;
    number.remove_prefix(std::min(number.find_first_of("0123456789"), number.size()));
    const std::size_t at = std::min(number.find(mark), number.size());
    const std::string_view rest = number.substr(at);
    return at > 0 && at <= longest && number[0] != '0' && rest.size() == decimals + 1 &&
           rest.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

SampleRow readSampleRow(std::string_view sample, std::span<const TableCell> cells, DecimalMark markUsed,
                        SampleSigns &signs) {
    const char mark = markUsed == DecimalMark::point ? '.' : ',';
    SampleRow row{cells.size(), {}};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const TableCell &cell = cells[i];
        std::string_view text = sample.substr(cell.begin, cell.size);
        const auto withUnit = cell.kind == CellKind::text ? cellWithUnit(text, markUsed) : std::nullopt;
        if (withUnit && withUnit->size > 0)
            text = text.substr(0, withUnit->size);
        if (cell.isNumber() || withUnit) {
            row.numbers.push_back(withUnit ? withUnit->value : cell.value);
            const bool isMarked = text.find(mark) != std::string_view::npos;
            signs.hasMark |= isMarked;
            signs.proven |= isMarked && !mayBeGrouped(text, mark);
            signs.fine |= isMarked && !text.ends_with('0');
            signs.torn += isTorn(text) ? 1 : 0;
            signs.spaced |= i > 0 && cell.begin > 0 && sample[cell.begin - 1] == ' ';
        } else if ((cell.kind == CellKind::grouped || cell.kind == CellKind::broken || isUncut(text)) &&
                   !isDate(text)) {
            ++signs.broken;
        }
    }
    signs.words |= row.numbers.empty() && row.count > 1;
    return row;
}

/// The number of cells in the rows that contain most of the numbers.
std::size_t usualColumns(const std::vector<SampleRow> &rows) {
    std::map<std::size_t, std::size_t> numbersUnder;
    for (const SampleRow &row : rows)
        numbersUnder[row.count] += row.numbers.size();
    std::size_t columns = 0;
    std::size_t most = 0;
    for (const auto &[count, numbers] : numbersUnder) {
        if (numbers > most) {
            most = numbers;
            columns = count;
        }
    }
    return columns;
}

Reading readSample(std::string_view sample, Delimiter delimiter, DecimalMark mark, bool comments) {
    Scanner scanner(sample, delimiter, mark, comments);
    scanner.scan(sampleRows);
    Reading result{delimiter, mark, 0, 0, false, false, false, 0, 0, {}, {}};
    std::vector<SampleRow> rows;
    SampleSigns signs;
    for (const TableRow &row : scanner.rows) {
        if (row.comment)
            continue;
        const auto cells = std::span(scanner.cells).subspan(row.first, row.count);
        SampleRow read = readSampleRow(sample, cells, mark, signs);
        if (!read.numbers.empty())
            rows.push_back(std::move(read));
    }
    result.hasMark = signs.hasMark;
    result.broken = signs.broken;
    result.mayBeGrouped = signs.hasMark && !signs.proven;
    result.isRound = !signs.fine;
    if (rows.empty()) {
        result.score = -std::numeric_limits<double>::infinity();
        return result;
    }
    result.columns = usualColumns(rows);
    std::size_t alike = 0;
    std::size_t all = 0;
    for (const SampleRow &row : rows) {
        all += row.numbers.size();
        result.all.insert(result.all.end(), row.numbers.begin(), row.numbers.end());
        if (row.count != result.columns)
            continue;
        ++alike;
        result.numbers.insert(result.numbers.end(), row.numbers.begin(), row.numbers.end());
    }
    std::ranges::sort(result.all);
    result.score = static_cast<double>(alike) / static_cast<double>(rows.size()) *
                   (static_cast<double>(all) - 2 * signs.broken);
    result.rival = signs.torn > 0 ? 0 : result.score;
    // A comma between integers, and no evidence against a decimal mark.
    const bool decimals = result.columns < 3 && !signs.words && !signs.spaced;
    if (delimiter == Delimiter::comma && !result.hasMark && (decimals || signs.torn > 0))
        result.score = std::min(result.score, 0.0);
    return result;
}

/// The beginning of the text and a piece from its middle, each of whole lines.
std::string sampleOf(std::string_view text) {
    constexpr std::size_t piece = 40'000;
    const auto lineAfter = [&](std::size_t at) {
        const std::size_t end = text.find_first_of("\r\n", at);
        return end == std::string_view::npos ? text.size() : end + 1;
    };
    if (text.size() <= 2 * piece)
        return std::string(text);
    std::size_t line = 0;
    std::size_t rows = 0;
    while (rows < sampleRows / 2 && line < piece) {
        line = lineAfter(line);
        ++rows;
    }
    std::string sample(text.substr(0, std::min(line, 4 * piece)));
    sample += '\n';
    const std::size_t middle = lineAfter(std::max(line, text.size() / 2));
    sample += text.substr(middle,
                          std::min(lineAfter(std::min(middle + piece / 2, text.size())) - middle, 2 * piece));
    return sample;
}

/// Blanks also separate words, so another delimiter that splits nearly as many numbers is preferred. Tabs are
/// rare outside tables: "+ 1" between tabs is not two numbers.
bool isAsGood(const Reading &best, const Reading &blanks) {
    const double nearly = best.delimiter == Delimiter::tab ? 0.3 : 0.6;
    return best.columns > 1 && best.score > nearly * blanks.score;
}

/// False for what was chosen otherwise. Commas do both only if quotes tell them apart, or by choice.
bool canBe(Delimiter delimiter, DecimalMark mark, bool areQuoted, const TableOptions &options) {
    const bool isChosen = options.delimiter == delimiter && options.decimalMark == mark;
    const bool isOneForBoth = delimiter == Delimiter::comma && mark == DecimalMark::comma;
    return options.delimiter.value_or(delimiter) == delimiter && options.decimalMark.value_or(mark) == mark &&
           (!isOneForBoth || areQuoted || isChosen);
}

void resolveForm(CellTable &table, std::string_view text, const TableOptions &options) {
    const std::string sample = sampleOf(text);
    const bool areQuoted = sample.find(R"(",")") != std::string::npos;
    Reading best;
    std::vector<Reading> readings;
    for (const Delimiter delimiter : {Delimiter::tab, Delimiter::semicolon, Delimiter::bar, Delimiter::comma,
                                      Delimiter::colon, Delimiter::blanks}) {
        for (const DecimalMark mark : {DecimalMark::point, DecimalMark::comma}) {
            if (!canBe(delimiter, mark, areQuoted, options))
                continue;
            readings.push_back(readSample(sample, delimiter, mark, options.comments));
            if (delimiter == Delimiter::blanks && isAsGood(best, readings.back()))
                continue;
            if (readings.size() == 1 || readings.back().score > best.score)
                best = readings.back();
        }
    }
    const auto isRival = [&](const Reading &reading) {
        const bool isPadding = best.delimiter == Delimiter::bar && reading.delimiter == Delimiter::blanks;
        return !isPadding && reading.rival > 0.5 * best.score && reading.broken <= best.broken &&
               reading.numbers != best.numbers && !onlyPartsWords(reading, best);
    };
    // Where tabs part the columns, a blank in a cell as "1 ↑" parts nothing.
    const auto isDoubt = [&](const Reading &reading) {
        return isRival(reading) &&
               !(best.delimiter == Delimiter::tab && reading.delimiter == Delimiter::blanks);
    };
    const bool hasRival = std::ranges::any_of(readings, isRival);
    table.isFormDoubtful = std::ranges::any_of(readings, isDoubt) || (best.mayBeGrouped && best.isRound);
    const Origin origin = hasRival || best.mayBeGrouped ? Origin::guessed : Origin::recognised;
    table.delimiter = {best.delimiter, options.delimiter ? Origin::chosen : origin};
    table.decimalMark = {best.mark, options.decimalMark ? Origin::chosen : origin};
}

/// Checked before reading: a line of that length is not a table row.
void requireLines(std::string_view text) {
    constexpr std::size_t longestLine = std::size_t(1) << 20U;
    std::size_t begin = 0;
    while (text.size() - begin > longestLine) {
        // The last line end within reach; all lines before it are short enough.
        const std::size_t end = text.substr(begin, longestLine + 1).find_last_of("\r\n");
        if (end == std::string_view::npos)
            refuseAsAt(Error::Kind::tooLarge, lineAndColumn(text, begin),
                       REPORT_TEXT("report", "a line is longer than 1 MiB; expected a table of readings"));
        begin += end + 1;
    }
}

void makeRoom(Scanner &scanner, std::size_t rows, std::size_t cells) {
    scanner.rows.reserve(std::min(rowLimit, rows));
    scanner.cells.reserve(std::min(cellLimit, cells));
    useHugePages(scanner.rows.data(), scanner.rows.capacity() * sizeof(TableRow));
    useHugePages(scanner.cells.data(), scanner.cells.capacity() * sizeof(TableCell));
}

/// Takes the next word into a heading.
void extend(TableCell &heading, const TableCell &word) {
    heading.size = static_cast<std::uint16_t>(
        std::min<std::size_t>(word.begin + word.size - heading.begin, longestCell));
    heading.kind = CellKind::text;
}

/// Words above columns of fixed width, parted by single blanks: each heading begins, or each ends, where the
/// number below it does. Empty if they stand otherwise.
std::vector<TableCell> alignedWith(const CellTable &table, std::span<const TableCell> words,
                                   std::span<const TableCell> numbers) {
    for (const bool atEnd : {false, true}) {
        const auto edge = [&](const TableCell &cell) {
            return table.column({0, cell.begin + (atEnd ? cell.size : 0U)});
        };
        std::vector<TableCell> headings;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::size_t at = headings.size();
            const bool begins =
                at < numbers.size() && (!atEnd    ? edge(words[i]) == edge(numbers[at])
                                        : at == 0 ? i == 0
                                                  : edge(words[i - 1]) == edge(numbers[at - 1]));
            if (begins)
                headings.push_back(words[i]);
            else if (headings.empty())
                break;
            else
                extend(headings.back(), words[i]);
        }
        if (headings.size() == numbers.size() && (!atEnd || edge(words.back()) == edge(numbers.back())))
            return headings;
    }
    return {};
}

} // namespace

CellTable readTable(std::string text, const TableOptions &options) {
    requireLines(text);
    CellTable table;
    table.m_text = std::move(text);
    resolveForm(table, table.m_text, options);
    Scanner scanner(table.m_text, table.delimiter.value, table.decimalMark.value, options.comments);
    scanner.scan(sampleRows);
    if (scanner.at() < table.m_text.size()) {
        // Room for all: exact enough for tables, whose lines are alike.
        const std::size_t times = table.m_text.size() / std::max<std::size_t>(scanner.at(), 1) + 1;
        makeRoom(scanner, scanner.rows.size() * times * 9 / 8, scanner.cells.size() * times * 9 / 8);
        scanner.scan(std::numeric_limits<std::size_t>::max());
    }
    table.m_rows = std::move(scanner.rows);
    table.m_cells = std::move(scanner.cells);
    table.m_saysUnits = scanner.saysUnits;
    if (table.delimiter.value == Delimiter::blanks)
        table.joinWords();
    else if (table.delimiter.value == Delimiter::colon)
        table.placeHeads();
    return table;
}

/// "Position mm   Run 1 fwd   Run 1 rev" above three numbers: if single blanks split a line of words into
/// more pieces than columns and wider gaps into as many, the words between two gaps are one cell.
void CellTable::joinWords() {
    const auto beginsWithNumber = [this](const TableRow &row) {
        return row.count > 0 && m_cells[row.first].isNumber();
    };
    // "        Laser          Encoder": nothing stands over the first column.
    const auto isIndented = [this](const TableRow &row) {
        const std::size_t begin = row.count > 0 ? m_cells[row.first].begin : 0;
        return begin > 1 && m_text[begin - 1] == ' ' && m_text[begin - 2] == ' ';
    };
    const TableRow *labelled = joinLabels();
    const TableRow *usual = labelled ? labelled : usualRow();
    if (!usual)
        return;
    const TableRow numbers = *usual;
    const std::size_t width = numbers.count;
    for (TableRow &row : m_rows) {
        if (row.comment || beginsWithNumber(row) || (row.count <= width && !isIndented(row)))
            continue;
        std::vector<TableCell> joined = joinedWords(row, false);
        if (joined.size() < width)
            joined = joinedWords(row, true); // "t (ms) x (mm)" has only single blanks
        if (joined.size() != width)
            joined = alignedWith(*this, cells(row), cells(numbers));
        if (joined.size() != width)
            joined = joinedWords(row, false);
        if (joined.size() != width)
            joined = joined.size() < width ? placedOver(joined, numbers) : std::vector<TableCell>();
        setCells(row, joined);
    }
}

namespace {

/// "Run 2 forward": a label that counts lines at most, with no number of its own.
bool isLabel(const CellTable &table, std::span<const TableCell> parts, std::size_t lines) {
    bool hasWord = false;
    for (const TableCell &part : parts) {
        const bool isCount = part.isNumber() && part.value >= 1 && part.value <= static_cast<double>(lines) &&
                             table.text(part).find_first_not_of("0123456789") == std::string_view::npos;
        if (part.isNumber() && !isCount)
            return false;
        hasWord |= part.kind == CellKind::text;
    }
    return hasWord;
}

/// True if a joined cell is one of the cells of its line, or a label of several.
bool isOneOrLabel(const CellTable &table, std::span<const TableCell> cells, const TableCell &joined,
                  std::size_t lines) {
    std::vector<TableCell> parts;
    std::ranges::copy_if(cells, std::back_inserter(parts), [&](const TableCell &part) {
        return part.begin >= joined.begin && part.begin < joined.begin + joined.size;
    });
    return parts.size() < 2 || isLabel(table, parts, lines);
}

} // namespace

/// "direction + 1    0.1    0.2" among lines of numbers: where wider gaps part the columns of most of them,
/// single blanks part the words of a cell. Returns one of these rows; null: there are none.
const TableRow *CellTable::joinLabels() {
    constexpr std::size_t fewest = 2; // numbers of a line
    struct Line {
        std::size_t row;
        std::vector<TableCell> joined;
    };
    std::map<std::size_t, std::vector<Line>> lines; // by width
    std::map<std::size_t, std::size_t> numbers;
    std::size_t all = 0;
    std::size_t allNumbers = 0;
    const auto count = [](std::span<const TableCell> cells) {
        return static_cast<std::size_t>(std::ranges::count_if(cells, &TableCell::isNumber));
    };
    for (std::size_t i = 0; i < std::min(m_rows.size(), sampleRows); ++i) {
        const std::size_t own = m_rows[i].comment ? 0 : count(cells(m_rows[i]));
        if (own < fewest)
            continue;
        std::vector<TableCell> joined = joinedWords(m_rows[i], false);
        ++all;
        allNumbers += own;
        numbers[joined.size()] += own;
        lines[joined.size()].push_back({i, std::move(joined)});
    }
    const auto usual =
        std::ranges::max_element(lines, {}, [&](const auto &each) { return numbers[each.first]; });
    if (usual == lines.end() || 5 * numbers[usual->first] < 4 * allNumbers)
        return nullptr;
    const auto isReadable = [&](const Line &line) {
        return count(line.joined) >= fewest && std::ranges::all_of(line.joined, [&](const TableCell &cell) {
                   return isOneOrLabel(*this, cells(m_rows[line.row]), cell, all);
               });
    };
    const auto isJoined = [&](const Line &line) { return line.joined.size() != m_rows[line.row].count; };
    if (!std::ranges::all_of(usual->second, isReadable) || std::ranges::none_of(usual->second, isJoined))
        return nullptr;
    const std::size_t width = usual->first;
    const TableRow *found = nullptr;
    for (TableRow &row : m_rows) {
        const bool isOfNumbers = !row.comment && count(cells(row)) >= fewest;
        std::vector<TableCell> joined = row.comment ? std::vector<TableCell>() : joinedWords(row, false);
        if (joined.size() == width && joined.size() != row.count)
            setCells(row, joined);
        found = !found && isOfNumbers && row.count == width ? &row : found;
    }
    return found;
}

/// The first row with as many cells as most rows that begin with a number; null: no row begins with one.
const TableRow *CellTable::usualRow() const {
    std::map<std::size_t, std::pair<std::size_t, const TableRow *>> widths;
    for (const TableRow &row : m_rows) {
        if (row.count == 0 || !m_cells[row.first].isNumber())
            continue;
        auto &[rows, first] = widths[row.count];
        first = first ? first : &row;
        ++rows;
    }
    const auto most =
        std::ranges::max_element(widths, {}, [](const auto &entry) { return entry.second.first; });
    return most == widths.end() ? nullptr : most->second.second;
}

/// "Target : Error averages : 2 Std Devn" above seven columns: each group at the column it begins over.
void CellTable::placeHeads() {
    const TableRow *usual = usualRow();
    if (!usual)
        return;
    const TableRow numbers = *usual;
    for (TableRow &row : m_rows) {
        if (row.comment || row.count < 2 || row.count >= numbers.count || m_cells[row.first].isNumber())
            continue;
        const auto words = cells(row);
        setCells(row, placedOver({words.begin(), words.end()}, numbers));
    }
}

/// Replaces the cells of a row, unless there are none to replace them.
void CellTable::setCells(TableRow &row, const std::vector<TableCell> &cells) {
    if (cells.empty())
        return;
    row.first = static_cast<std::uint32_t>(m_cells.size());
    row.count = static_cast<std::uint32_t>(cells.size());
    m_cells.insert(m_cells.end(), cells.begin(), cells.end());
}

/// The cells between gaps of more than one blank; `brackets`: words with the brackets behind them.
std::vector<TableCell> CellTable::joinedWords(const TableRow &row, bool brackets) const {
    std::vector<TableCell> joined;
    for (const TableCell &cell : cells(row)) {
        const bool isNext =
            !joined.empty() && (brackets ? m_text[cell.begin] == '(' || m_text[cell.begin] == '['
                                         : joined.back().begin + joined.back().size + 1 == cell.begin);
        if (!isNext) {
            joined.push_back(cell);
            continue;
        }
        extend(joined.back(), cell);
    }
    return joined;
}

/// Fixed-width columns below fewer words, the others empty: each word belongs to the column with the nearest
/// number. Empty if two belong to one.
std::vector<TableCell> CellTable::placedOver(const std::vector<TableCell> &words,
                                             const TableRow &numbers) const {
    // Columns are flush left or flush right.
    const auto apart = [this](const TableCell &a, const TableCell &b) {
        const auto placeOf = [this](std::uint32_t at) {
            return static_cast<std::ptrdiff_t>(column({0, at}));
        };
        return std::min(std::abs(placeOf(a.begin) - placeOf(b.begin)),
                        std::abs(placeOf(a.begin + a.size) - placeOf(b.begin + b.size)));
    };
    std::vector<TableCell> placed(numbers.count, TableCell{0, 0, 0, CellKind::empty});
    for (const TableCell &word : words) {
        std::size_t nearest = 0;
        for (std::size_t c = 1; c < numbers.count; ++c) {
            const auto distance = [&](std::size_t column) {
                return apart(m_cells[numbers.first + column], word);
            };
            nearest = distance(c) < distance(nearest) ? c : nearest;
        }
        if (placed[nearest].kind != CellKind::empty)
            return {};
        placed[nearest] = word;
    }
    return placed;
}

void CellTable::keepLines(std::size_t first, std::size_t last) {
    std::erase_if(m_rows, [&](const TableRow &row) { return row.line < first || row.line > last; });
}

void CellTable::setAside(std::span<const std::size_t> rows) {
    for (const std::size_t row : rows)
        m_rows[row].comment = m_rows[row].aside = true;
}

void CellTable::moveBeside(std::size_t first, std::size_t end) {
    std::vector<TableRow> rows;
    rows.reserve(m_rows.size());
    for (TableRow row : m_rows) {
        TableRow beside{static_cast<std::uint32_t>(m_cells.size()), 0, row.line, true, true, true};
        for (std::size_t c = first; c < std::min<std::size_t>(end, row.comment ? 0 : row.count); ++c) {
            TableCell &cell = m_cells[row.first + c];
            const TableCell moved = std::exchange(cell, {0, cell.begin, 0, CellKind::empty});
            if (moved.kind != CellKind::empty)
                m_cells.push_back(moved); // may move the cells: `cell` is not used afterwards
        }
        beside.count = static_cast<std::uint32_t>(m_cells.size()) - beside.first;
        if (!row.comment && row.count > first && row.count <= end)
            row.count = static_cast<std::uint32_t>(first);
        const bool isEmpty = std::ranges::all_of(
            cells(row), [](const TableCell &cell) { return cell.kind == CellKind::empty; });
        if (!isEmpty)
            rows.push_back(row);
        if (beside.count > 0)
            rows.push_back(beside);
    }
    m_rows = std::move(rows);
}

std::size_t CellTable::column(const TableCell &cell) const {
    std::size_t begin = cell.begin;
    while (begin > 0 && !isLineEnd(m_text[begin - 1]))
        --begin;
    return 1 + static_cast<std::size_t>(
                   std::count_if(m_text.begin() + static_cast<std::ptrdiff_t>(begin),
                                 m_text.begin() + static_cast<std::ptrdiff_t>(cell.begin),
                                 [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

void TableBuilder::reserve(std::size_t cells) {
    constexpr std::size_t usualText = 8; // bytes of a cell
    m_table.m_cells.reserve(std::min(cells, cellLimit));
    m_table.m_text.reserve(std::min(cells, cellLimit) * usualText);
}

void TableBuilder::beginRow(std::size_t line) {
    if (m_table.m_rows.size() >= rowLimit)
        refuseTableSize(placeOfLine(line));
    if (!m_table.m_rows.empty())
        m_table.m_text += '\n';
    m_table.m_rows.push_back(
        {static_cast<std::uint32_t>(m_table.m_cells.size()), 0, static_cast<std::uint32_t>(line), false});
}

TableCell &TableBuilder::append(std::string_view cell) {
    TableRow &row = m_table.m_rows.back();
    constexpr std::size_t textLimit = std::size_t(1) << 28U;
    if (m_table.m_cells.size() >= cellLimit || m_table.m_text.size() > textLimit)
        refuseTableSize(placeOfLine(row.line));
    if (row.count++ > 0)
        m_table.m_text += '\t';
    cell = withoutBlanks(cell);
    cell = cell.substr(0, keptSize(cell));
    const auto begin = static_cast<std::uint32_t>(m_table.m_text.size());
    m_table.m_text += cell;
    std::replace_if(
        m_table.m_text.begin() + begin, m_table.m_text.end(),
        [](char c) { return c == '\t' || isLineEnd(c); }, ' ');
    m_table.m_cells.push_back({0, begin, static_cast<std::uint16_t>(cell.size()), CellKind::empty});
    return m_table.m_cells.back();
}

void TableBuilder::add(std::string_view cell) {
    const CellValue value = readCell(cell, DecimalMark::point);
    TableCell &added = append(cell);
    added.kind = value.kind;
    added.value = value.value;
    const bool saysUnit = value.kind == CellKind::text &&
                          (cellWithUnit(cell, DecimalMark::point) || cellWithUnit(cell, DecimalMark::comma));
    m_table.m_saysUnits |= saysUnit;
    if (saysUnit || (value.kind != CellKind::text && value.kind != CellKind::empty))
        m_texts.push_back(m_table.m_cells.size() - 1);
}

void TableBuilder::add(double number, std::string_view shown) {
    TableCell &added = append(shown);
    added.kind = CellKind::number;
    added.value = number;
}

void TableBuilder::add(double number, const Unit &unit) {
    TableCell &added = append(plainDecimals(number) + ' ' + unit.sign);
    added.kind = CellKind::text; // until the units of the columns are known
    m_table.m_formatted.emplace_back(static_cast<std::uint32_t>(m_table.m_cells.size() - 1), number);
    m_table.m_saysUnits = true;
}

CellTable TableBuilder::take(std::optional<DecimalMark> mark) {
    m_table.isPlaced = true;
    std::array<std::size_t, 2> marked{}; // numbers with decimals for each mark
    for (const std::size_t i : m_texts) {
        const std::string_view text = m_table.text(m_table.m_cells[i]);
        for (const DecimalMark each : {DecimalMark::point, DecimalMark::comma}) {
            const char sign = each == DecimalMark::point ? '.' : ',';
            if (text.find(sign) != std::string_view::npos &&
                (readCell(text, each).kind == CellKind::number || cellWithUnit(text, each)))
                ++marked[static_cast<std::size_t>(each)];
        }
    }
    const bool comma = marked[1] > marked[0];
    m_table.decimalMark = {comma ? DecimalMark::comma : DecimalMark::point,
                           marked[0] > 0 && marked[1] > 0 ? Origin::guessed : Origin::recognised};
    if (mark)
        m_table.decimalMark = {*mark, Origin::chosen};
    if (m_table.decimalMark.value == DecimalMark::comma) {
        for (const std::size_t i : m_texts) {
            const CellValue value = readCell(m_table.text(m_table.m_cells[i]), DecimalMark::comma);
            m_table.m_cells[i].kind = value.kind;
            m_table.m_cells[i].value = value.value;
        }
        for (const auto &[i, number] : m_table.m_formatted) {
            const TableCell &cell = m_table.m_cells[i];
            const auto begin = m_table.m_text.begin() + cell.begin;
            std::replace(begin, begin + cell.size, '.', ',');
        }
    }
    return std::move(m_table);
}

} // namespace palmer
