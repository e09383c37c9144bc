// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "kernel/evaluation/resultsof.h"
#include "language/decimals.h"
#include "report/tables/resulttable.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace palmer {

namespace {

constexpr double testsWidth = 16; ///< mm, for test numbers

/// The width of a column of test numbers in which no range like "11–14," breaks, mm.
double widthOfTests(const Table &table, std::size_t column, double least) {
    constexpr double padding = 2.3;
    constexpr double digit = 1.7; // at 8.5 pt
    qsizetype longest = 0;
    for (const std::vector<Cell> &row : table.rows) {
        for (const QString &range : row[column].text.plain().split(u' '))
            longest = std::max(longest, range.size());
    }
    return std::max(least, padding + digit * static_cast<double>(longest));
}

struct TableOfTest {
    int test = 1;
    Table table;
};

/// Merges tables with the same columns: rows with the same first `keyCells` cells become neighbours, with the
/// numbers of their tests. Statements shared by several tests are printed once.
class MergedTable {
public:
    MergedTable(const Writer &write, int count, std::size_t keyCells)
        : m_write(write)
        , m_count(count)
        , m_keys(keyCells) {}

    void add(const TableOfTest &source) {
        if (m_columns.empty())
            m_columns = source.table.columns;
        const auto &rows = source.table.rows;
        std::vector<std::size_t> known(rows.size() + 1, rows.size()); // next row with a known subject
        for (std::size_t i = rows.size(); i-- > 0;)
            known[i] = find(rows[i]) != m_subjects.end() ? i : known[i + 1];
        for (std::size_t i = 0; i < rows.size(); ++i) {
            auto subject = find(rows[i]);
            if (subject == m_subjects.end()) { // insert before that row
                const auto next = known[i] < rows.size() ? find(rows[known[i]]) : m_subjects.end();
                const auto end = rows[i].begin() + static_cast<std::ptrdiff_t>(m_keys);
                subject = m_subjects.insert(next, {{rows[i].begin(), end}, {}});
            }
            addStatement(*subject, rows[i], source.test);
        }
    }

    /// The merged table; empty if nothing was added.
    [[nodiscard]] Table take() const {
        Table table;
        if (m_subjects.empty())
            return table;
        table.columns = m_columns;
        const auto tests = static_cast<std::ptrdiff_t>(m_keys);
        table.columns.insert(table.columns.begin() + tests,
                             m_write.column(REPORT_TEXT("report", "Tests"), testsWidth));
        for (const Subject &subject : m_subjects) {
            if (!table.rows.empty())
                table.rulesAfter.push_back(table.rows.size() - 1);
            for (const Statement &statement : subject.statements) {
                std::vector<Cell> row(m_keys, blankCell());
                if (&statement == &subject.statements.front()) {
                    row = subject.key;
                    for (Cell &cell : row)
                        cell.extras.edit().rows = subject.statements.size();
                }
                row.emplace_back(testNumbers(m_write, statement.tests, m_count));
                row.insert(row.end(), statement.cells.begin(), statement.cells.end());
                table.rows.push_back(std::move(row));
            }
        }
        const double width = widthOfTests(table, m_keys, testsWidth);
        table.columns[m_keys].width = width;
        std::ranges::find_if(table.columns, &Column::flexible)->width -= width; // exists
        return table;
    }

private:
    struct Statement {
        std::vector<Cell> cells;
        std::vector<int> tests;
    };
    struct Subject {
        std::vector<Cell> key;
        std::vector<Statement> statements;
    };

    [[nodiscard]] std::vector<Subject>::iterator find(const std::vector<Cell> &row) {
        return std::ranges::find_if(m_subjects, [&](const Subject &subject) {
            return std::equal(subject.key.begin(), subject.key.end(), row.begin());
        });
    }

    void addStatement(Subject &subject, const std::vector<Cell> &row, int test) const {
        std::vector<Cell> cells(row.begin() + static_cast<std::ptrdiff_t>(m_keys), row.end());
        const auto same = std::ranges::find(subject.statements, cells, &Statement::cells);
        if (same == subject.statements.end())
            subject.statements.push_back({std::move(cells), {test}});
        else if (same->tests.back() != test)
            same->tests.push_back(test);
    }

    const Writer &m_write;
    int m_count;
    std::size_t m_keys;
    std::vector<Column> m_columns;
    std::vector<Subject> m_subjects;
};

Table conditionTable(const TestPart &part) {
    Table table;
    table.columns = {part.write.column(REPORT_TEXT_FOR("report", "Condition", "of a test"), 42),
                     part.write.flexible(REPORT_TEXT_FOR("report", "Stated", "condition"), 133)};
    KeyValues rows = conditionRows(part);
    const QString missing = takeMissing(rows, part.write);
    for (const KeyValue &row : rows.rows)
        table.rows.push_back({row.key, row.value});
    if (const QString correction = correctionOf(part); !correction.isEmpty())
        table.rows.push_back({part.write.text(REPORT_TEXT("report", "Correction to 20 °C")), correction});
    if (!missing.isEmpty()) // in one row, to avoid a row per dash
        table.rows.push_back(
            {part.write.text(REPORT_TEXT_FOR("report", "Not stated", "conditions")), missing});
    return table;
}

/// Table of temperatures and other statements about the environment, one row per test.
class EnvironmentOfTests {
public:
    explicit EnvironmentOfTests(const Writer &write)
        : m_write(write) {
        const auto column = [&](const Text &title, Quantity unit, double width) {
            return write.column(title, width, Alignment::decimal, write.language().unit(unit));
        };
        m_table.columns = {write.column(REPORT_TEXT("report", "Test"), 9)};
        for (const SensorMeasures what : measured) {
            m_table.spanners.push_back({m_table.columns.size(), 2, write.text(sensorText(what))});
            m_table.columns.push_back(column(REPORT_TEXT("report", "Start"), Quantity::temperature, 12));
            m_table.columns.push_back(column(REPORT_TEXT("report", "End"), Quantity::temperature, 12));
        }
        m_table.columns.push_back(column(REPORT_TEXT("report", "Air pressure"), Quantity::pressure, 17));
        m_table.columns.back().gapBefore = 2;
        m_table.columns.push_back(column(REPORT_TEXT("report", "Relative humidity"), Quantity::percent, 17));
        m_table.columns.push_back(
            column(REPORT_TEXT("report", "Temperature gradient"), Quantity::gradient, 19));
        m_table.columns.push_back(column(REPORT_TEXT("report", "α machine"), Quantity::expansion, 19));
        m_table.columns.push_back(column(REPORT_TEXT("report", "α instrument"), Quantity::expansion, 19));
    }

    void add(const TestPart &part) {
        if (!statesTemperatures(part))
            return;
        const Conditions &conditions = *conditionsOf(part.test);
        std::vector<Cell> row{QString::number(part.number)};
        for (const SensorMeasures what : measured) {
            const Temperatures temperatures = temperaturesOf(conditions, what);
            row.emplace_back(
                m_write.numberAtLeast(temperatures.start, Quantity::temperature, temperatureDecimals));
            row.emplace_back(
                m_write.numberAtLeast(temperatures.end, Quantity::temperature, temperatureDecimals));
        }
        withKind(part, [&](const auto &own) { addAir(row, own.measurement.conditions); });
        const bool expands = motionOf(part.test) == Motion::linear;
        for (const auto &alpha : {conditions.expansion.machine, conditions.expansion.instrument})
            row.push_back(expands || alpha
                              ? Cell(m_write.numberAtLeast(alpha, Quantity::expansion, expansionDecimals))
                              : blankCell());
        m_table.rows.push_back(std::move(row));
    }

    [[nodiscard]] Table take() {
        constexpr std::size_t behindTemperatures = 7;
        for (std::size_t i = m_table.columns.size(); i-- > behindTemperatures;) {
            const auto isBlank = [i](const std::vector<Cell> &row) { return row[i].blank; };
            if (std::ranges::all_of(m_table.rows, isBlank)) // required but missing values are dashes
                leaveOutEmptyColumns(m_table, i, i);
        }
        // Takes the remaining width.
        m_table.columns.push_back(flexibleColumn(QString(), 1));
        for (std::vector<Cell> &row : m_table.rows)
            row.push_back(blankCell());
        return std::move(m_table);
    }

private:
    static constexpr std::array measured{SensorMeasures::machine, SensorMeasures::instrument,
                                         SensorMeasures::air};

    void addAir(std::vector<Cell> &row, const auto &conditions) const {
        if constexpr (requires { conditions.airPressure; }) {
            row.emplace_back(m_write.number(conditions.airPressure, Quantity::pressure));
            row.emplace_back(m_write.number(conditions.airHumidity, Quantity::percent));
            row.emplace_back(m_write.number(conditions.gradientPerHour, Quantity::gradient));
        } else {
            row.insert(row.end(), 3, blankCell()); // not required
        }
    }

    const Writer &m_write;
    Table m_table;
};

/// True if the test's row in the environment table contains everything its sensors measured.
bool environmentSaysAll(const TestPart &part) {
    std::array<int, kindsOfSensors> counts{};
    return std::ranges::none_of(conditionsOf(part.test)->sensors, [&](const Sensor &sensor) {
        return sensor.measures == SensorMeasures::notStated ||
               ++counts.at(static_cast<std::size_t>(sensor.measures)) > 1;
    });
}

void leaveOutTemperatures(Table &sensors) {
    constexpr std::size_t kindAndPlace = 2;
    sensors.columns.resize(kindAndPlace);
    for (std::vector<Cell> &row : sensors.rows)
        row.resize(kindAndPlace);
}

/// A statement shared by several tests.
struct TextOfTests {
    QString text;
    std::vector<int> tests;
};
using TextsOfTests = std::vector<TextOfTests>;

void addText(TextsOfTests &texts, const QString &text, int test) {
    const auto same = std::ranges::find(texts, text, &TextOfTests::text);
    if (same == texts.end())
        texts.push_back({text, {test}});
    else
        same->tests.push_back(test);
}

QString ofTests(const Writer &write, const std::vector<int> &numbers, const QString &text) {
    if (numbers.size() == 1)
        return write.say(REPORT_TEXT("report", "Test %1: %2"),
                         {std::to_string(numbers.front()), text.toStdString()});
    return write.say(REPORT_TEXT("report", "Tests %1: %2"),
                     {testNumbers(write, numbers, 0).toStdString(), text.toStdString()});
}

/// Results under several editions, with as many tests side by side as fit.
class EditionsOfTests {
public:
    /// Returns false and adds nothing if there is no room left.
    bool add(const TestPart &part, const Table &editions) {
        const std::size_t count = editions.columns.size() - 1;
        double needed = m_needed + (m_table.spanners.empty() ? symbolWidth + 1 : gap);
        for (std::size_t i = 1; i <= count; ++i)
            needed += neededWidth(editions.columns[i]);
        if (!m_table.spanners.empty() && needed > textWidth)
            return false;
        m_needed = needed;
        if (m_table.columns.empty())
            m_table.columns.push_back(columnOf(QString(), symbolWidth));
        const std::size_t first = m_table.columns.size();
        m_table.spanners.push_back({first, count, title(part, editions.columns.front().unit)});
        for (std::size_t i = 1; i <= count; ++i) {
            m_table.columns.push_back(editions.columns[i]);
            m_table.columns.back().gapBefore = i == 1 && first > 1 ? gap : 0;
        }
        for (std::vector<Cell> &row : m_table.rows)
            row.resize(first + count);
        for (const std::vector<Cell> &row : editions.rows) {
            auto own = std::ranges::find_if(
                m_table.rows, [&](const std::vector<Cell> &known) { return known.front() == row.front(); });
            if (own == m_table.rows.end()) {
                m_table.rows.emplace_back(first + count).front() = row.front();
                own = m_table.rows.end() - 1;
            }
            std::copy(row.begin() + 1, row.end(), own->begin() + static_cast<std::ptrdiff_t>(first));
        }
        return true;
    }

    [[nodiscard]] Table take() {
        constexpr double widest = 20; ///< that a column becomes where there is room
        const double spare =
            (textWidth - std::exchange(m_needed, 0)) / static_cast<double>(m_table.columns.size() - 1);
        for (Column &column : m_table.columns) {
            const double needed = neededWidth(column);
            if (column.width <= 0)
                column.width = std::max(needed, std::min(widest, needed + spare));
        }
        m_table.columns.push_back(flexibleColumn(QString(), 1)); // takes the remaining width
        for (std::vector<Cell> &row : m_table.rows)
            row.push_back(blankCell());
        return std::exchange(m_table, {});
    }

    [[nodiscard]] bool empty() const { return m_table.rows.empty(); }

private:
    static constexpr double symbolWidth = 14; ///< mm
    static constexpr double gap = 2.5;        ///< mm, between tests

    /// For a designation that does not break, mm.
    static double neededWidth(const Column &column) {
        constexpr double least = 10;
        constexpr double letter = 1.85; // of bold text at 8.5 pt
        return std::max(least, 2 + letter * static_cast<double>(column.title.plain().size()));
    }

    static Phrase title(const TestPart &part, const QString &unit) {
        return Phrase({{part.write.say(REPORT_TEXT("report", "Test %1"), QString::number(part.number))},
                       {QStringLiteral(", ") + unit, false, false, true}});
    }

    Table m_table;
    double m_needed = 0; ///< mm
};

/// Approximate number of lines of a text in a column, for balancing; width in mm.
std::size_t linesOf(const QString &text, double width) {
    constexpr double letter = 1.55; // mm, at 8.5 pt
    std::size_t lines = 0;
    for (const QString &line : text.split(u'\n')) {
        double used = width;
        for (const QString &word : line.split(u' ')) {
            const double needed = letter * static_cast<double>(word.size() + 1);
            lines += used + needed > width ? 1 : 0;
            used = used + needed > width ? needed : used + needed;
        }
    }
    return lines;
}

/// Lines of the row; a cell that spans several rows has room in all of them.
std::size_t linesOf(const std::vector<Cell> &row, const std::array<double, 3> &widths) {
    constexpr double padding = 2;
    std::size_t lines = 1;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i].extras->rows == 1)
            lines = std::max(lines, linesOf(row[i].text.plain(), widths.at(i) - padding));
    }
    return lines;
}

/// Adds a table as two halves side by side if they fit on a page, otherwise as it is. Rows of a cell that
/// spans several stay together.
void addInHalves(std::vector<Block> &blocks, Table table) {
    constexpr std::size_t mostLines = 44; // in a half
    constexpr double nameWidth = 32;      // mm
    constexpr double leastTestsWidth = 10;
    const double numbers = widthOfTests(table, 1, leastTestsWidth);
    const std::array widths{nameWidth, numbers, SideBySide().leftWidth - nameWidth - numbers};
    std::vector<std::size_t> above{0}; // lines above each row
    for (const std::vector<Cell> &row : table.rows)
        above.push_back(above.back() + linesOf(row, widths));
    std::size_t cut = 0;
    for (const std::size_t end : table.rulesAfter) {
        if (2 * above[end + 1] <= above.back() + 1)
            cut = end + 1;
    }
    if (cut == 0 || above.back() - above[cut] > mostLines) {
        blocks.emplace_back(std::move(table));
        return;
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        table.columns[i].width = widths.at(i);
    Table second = table;
    second.rows.erase(second.rows.begin(), second.rows.begin() + static_cast<std::ptrdiff_t>(cut));
    std::erase_if(second.rulesAfter, [&](std::size_t row) { return row < cut; });
    for (std::size_t &row : second.rulesAfter)
        row -= cut;
    table.rows.resize(cut);
    std::erase_if(table.rulesAfter, [&](std::size_t row) { return row + 1 >= cut; });
    SideBySide both;
    both.left.emplace_back(std::move(table));
    both.right.emplace_back(std::move(second));
    blocks.emplace_back(std::move(both));
}

/// Limits of the same origin and edition, on one line.
struct LimitsOfOrigin {
    Cell limits;
    Cell edition;
    Cell source;
    std::vector<int> tests;
};

class LimitsOfTests {
public:
    explicit LimitsOfTests(const Writer &write)
        : m_write(write) {}

    /// Adds rows of `limitsTable`: quantity, limit, edition, source.
    void add(const Table &table, int test) {
        std::vector<LimitsOfOrigin> own;
        for (const std::vector<Cell> &row : table.rows) {
            auto origin = std::ranges::find_if(own, [&](const LimitsOfOrigin &each) {
                return each.edition == row[2] && each.source == row[3];
            });
            if (origin == own.end())
                origin = own.insert(own.end(), {{}, row[2], row[3], {test}});
            std::vector<Span> &spans = origin->limits.text.spans;
            if (!spans.empty())
                spans.push_back({m_write.semicolon()});
            for (Span span : row[0].text.spans) {
                span.bold = true;
                spans.push_back(std::move(span));
            }
            spans.push_back({u'\u00A0' + row[1].text.plain().replace(u' ', u'\u00A0')});
        }
        for (LimitsOfOrigin &each : own) {
            const auto same = std::ranges::find_if(m_rows, [&](const LimitsOfOrigin &known) {
                return known.limits == each.limits && known.edition == each.edition &&
                       known.source == each.source;
            });
            if (same == m_rows.end())
                m_rows.push_back(std::move(each));
            else
                same->tests.push_back(test);
        }
    }

    [[nodiscard]] Table take(int count) const {
        Table table;
        table.columns = {m_write.column(REPORT_TEXT("report", "Tests"), testsWidth),
                         m_write.flexible(REPORT_TEXT_FOR("report", "Limits", "part of a verdict"), 79),
                         m_write.column(REPORT_TEXT("report", "Agreed for"), 30),
                         m_write.column(REPORT_TEXT_FOR("report", "Source", "of a limit"), 50)};
        for (const LimitsOfOrigin &row : m_rows)
            table.rows.push_back(
                {testNumbers(m_write, row.tests, count), row.limits, row.edition, row.source});
        table.columns[0].width = widthOfTests(table, 0, testsWidth);
        table.columns[1].width -= table.columns[0].width - testsWidth;
        return table;
    }

private:
    const Writer &m_write;
    std::vector<LimitsOfOrigin> m_rows;
};

/// Merges a section of several tests: the heading of the first, each text once, and one table with a column
/// of test numbers.
class SectionOfTests {
public:
    explicit SectionOfTests(const Writer &write)
        : m_write(write) {}

    void add(const std::vector<Block> &section, int test) {
        m_tests += section.empty() ? 0 : 1;
        for (const Block &block : section) {
            if (const auto *heading = std::get_if<Heading>(&block))
                m_heading = m_heading ? m_heading : *heading;
            else if (const auto *paragraph = std::get_if<Paragraph>(&block))
                addText(m_texts, paragraph->text, test);
            else if (const auto *table = std::get_if<Table>(&block))
                addRows(*table, test);
        }
    }

    void addTo(std::vector<Block> &blocks) {
        if (!m_heading)
            return;
        blocks.emplace_back(std::move(*m_heading));
        for (const TextOfTests &text : m_texts) {
            const bool all = text.tests.size() == m_tests;
            blocks.emplace_back(Paragraph{all ? text.text : ofTests(m_write, text.tests, text.text)});
        }
        if (!m_table.rows.empty())
            blocks.emplace_back(std::move(m_table));
    }

private:
    void addRows(const Table &table, int test) {
        constexpr double width = 9; // mm
        if (m_table.columns.empty()) {
            m_table.columns = table.columns;
            std::ranges::find_if(m_table.columns, &Column::flexible)->width -= width; // exists
            m_table.columns.insert(m_table.columns.begin(),
                                   m_write.column(REPORT_TEXT("report", "Test"), width));
        } else {
            m_table.rulesAfter.push_back(m_table.rows.size() - 1);
        }
        const std::size_t first = m_table.rows.size();
        for (const std::vector<Cell> &row : table.rows) {
            m_table.rows.push_back(row);
            m_table.rows.back().insert(m_table.rows.back().begin(), blankCell());
        }
        Cell number(QString::number(test));
        number.extras.edit().rows = table.rows.size();
        m_table.rows[first].front() = std::move(number);
    }

    const Writer &m_write;
    std::size_t m_tests = 0;
    std::optional<Heading> m_heading;
    TextsOfTests m_texts;
    Table m_table;
};

/// Table of two tests of the same subject, quantity by quantity.
class BeforeAndAfter {
public:
    BeforeAndAfter(const TestPart &before, const TestPart &after, const RolesBeside &roles)
        : m_before(before)
        , m_after(after)
        , m_write(after.write) {
        addColumns();
        for (const QuantityOfRoles &quantity : roles.quantities)
            addRow(quantity);
    }

    [[nodiscard]] Table take() { return std::move(m_table); }

private:
    void addColumns() {
        const auto &parameters = m_after.evaluation.parameters;
        const QString unit =
            parameters.empty() ? QString() : m_write.language().unit(parameters.front().term.quantity);
        const auto number = [&](const Text &title, double width) {
            return m_write.column(title, width, Alignment::decimal, unit);
        };
        Column quantity = m_write.column(REPORT_TEXT("report", "Quantity"), 15);
        quantity.titleSpan = 2;
        m_table.columns = {quantity, flexibleColumn(QString(), 44)};
        for (const TestPart *part : {&m_before, &m_after}) {
            const Text role = roleText(part->test.role);
            m_table.spanners.push_back(
                {m_table.columns.size(), 3,
                 m_write.text(role) + QStringLiteral(" (") + QString::number(part->number) + u')'});
            m_table.columns.push_back(number(REPORT_TEXT("report", "Value"), 14));
            m_table.columns.push_back(columnOf(QStringLiteral("U"), 12, Alignment::decimal, unit));
            m_table.columns.push_back(m_write.column(REPORT_TEXT("report", "Verdict"), 22));
        }
        m_table.columns.push_back(number(REPORT_TEXT("report", "Change"), 20));
        m_table.unbroken = true;
    }

    void addSide(std::vector<Cell> &row, const TestPart &part, const Parameter &parameter) const {
        const PrintedNumbers numbers =
            printedNumbers(parameter, part.test, part.document(), m_write.language());
        row.emplace_back(numbers.value);
        row.emplace_back(numbers.uncertainty);
        row.push_back(verdictCell(m_write, parameter));
    }

    void addRow(const QuantityOfRoles &quantity) {
        const Cell symbol = boldCell(symbolPhrase(*quantity.left));
        std::vector<Cell> row{symbol, m_write.text(briefName(*quantity.left, m_after.evaluation))};
        addSide(row, m_before, *quantity.found);
        addSide(row, m_after, *quantity.left);
        row.emplace_back(quantity.change);
        m_table.rows.push_back(std::move(row));
    }

    const TestPart &m_before;
    const TestPart &m_after;
    const Writer &m_write;
    Table m_table;
};

} // namespace

void addRemarksOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    const TestPart &first = parts.front();
    std::vector<Block> remarks;
    if (const std::string &ofReport = first.head().remarks; !ofReport.empty())
        remarks.emplace_back(Paragraph{QString::fromStdString(ofReport)});
    TextsOfTests texts;
    for (const TestPart &part : parts) {
        if (!part.test.remarks.empty())
            addText(texts, QString::fromStdString(part.test.remarks), part.number);
    }
    for (const TextOfTests &text : texts)
        remarks.emplace_back(Paragraph{ofTests(first.write, text.tests, text.text)});
    if (remarks.empty())
        return;
    addHeading(blocks, first.write.text(REPORT_TEXT("report", "Remarks")));
    blocks.insert(blocks.end(), remarks.begin(), remarks.end());
}

QString testNumbers(const Writer &write, const std::vector<int> &numbers, int count) {
    if (static_cast<int>(numbers.size()) == count)
        return write.text(REPORT_TEXT_FOR("report", "all", "tests"));
    QStringList texts;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
            ++end;
        const QString first = QString::number(numbers[i]);
        const QString last = QString::number(numbers[end - 1]);
        if (end - i > 2)
            texts << first + QStringLiteral("–") + last;
        else
            texts << (end - i == 2 ? first + QStringLiteral(", ") + last : first);
        i = end;
    }
    return texts.join(QStringLiteral(", "));
}

void addConditionsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    const Writer &write = parts.front().write;
    const int count = static_cast<int>(parts.size());
    MergedTable conditions(write, count, 1);
    EnvironmentOfTests environment(write);
    const bool placesOnly = std::ranges::all_of(parts, environmentSaysAll);
    MergedTable sensors(write, count, placesOnly ? 1 : 2);
    for (const TestPart &part : parts) {
        conditions.add({part.number, conditionTable(part)});
        environment.add(part);
        if (auto table = sensorTable(part)) {
            if (placesOnly)
                leaveOutTemperatures(*table);
            sensors.add({part.number, std::move(*table)});
        }
    }
    addHeading(blocks, write.text(REPORT_TEXT("report", "Test conditions")));
    addInHalves(blocks, conditions.take());
    if (Table table = environment.take(); !table.rows.empty()) {
        addHeading(blocks, write.text(REPORT_TEXT("report", "Environment")));
        blocks.emplace_back(std::move(table));
    }
    if (Table table = sensors.take(); !table.rows.empty()) {
        addHeading(blocks, write.text(REPORT_TEXT("report", "Temperature sensors")));
        if (placesOnly)
            addInHalves(blocks, std::move(table));
        else
            blocks.emplace_back(std::move(table));
    }
}

void addPathsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    SectionOfTests paths(parts.front().write);
    SectionOfTests corrections(parts.front().write);
    for (const TestPart &part : parts) {
        withKind(part, [&](const auto &own) {
            if constexpr (requires { own.results.paths; }) {
                std::vector<Block> section;
                addPaths(section, own);
                paths.add(section, part.number);
                section.clear();
                addCorrection(section, own);
                corrections.add(section, part.number);
            }
        });
    }
    paths.addTo(blocks);
    corrections.addTo(blocks);
}

void addAgreedPointsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    struct Group {
        AgreedPoints points; ///< of the first test
        std::vector<TableOfTest> tests;
    };
    const auto samePoints = [](const AgreedPoints &a, const AgreedPoints &b) {
        const auto sameKeys = [&](const std::vector<Cell> &x, const std::vector<Cell> &y) {
            return std::equal(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(a.keys), y.begin());
        };
        return a.note == b.note && a.keys == b.keys &&
               std::ranges::equal(a.table.rows, b.table.rows, sameKeys);
    };
    std::vector<Group> groups;
    for (const TestPart &part : parts) {
        auto points = agreedPointsOf(part);
        if (!points)
            continue;
        auto group =
            std::ranges::find_if(groups, [&](const Group &each) { return samePoints(each.points, *points); });
        if (group == groups.end())
            group = groups.insert(group, {*points, {}});
        group->tests.push_back({part.number, std::move(points->table)});
    }
    for (const Group &group : groups) {
        MergedTable table(parts.front().write, static_cast<int>(parts.size()), group.points.keys);
        for (const TableOfTest &test : group.tests)
            table.add(test);
        addHeading(blocks, parts.front().write.text(REPORT_TEXT("report", "Points to be agreed")),
                   group.points.note);
        blocks.emplace_back(table.take());
    }
}

void addLimitsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    const Writer &write = parts.front().write;
    TextsOfTests rules;
    TextsOfTests uncertainties;
    LimitsOfTests limits(write);
    for (const TestPart &part : parts) {
        if (const QString words = uncertaintySentence(part); !words.isEmpty())
            addText(uncertainties, words, part.number);
        const Table table = limitsTable(part);
        if (table.rows.empty())
            continue;
        limits.add(table, part.number);
        addText(rules, decisionText(part), part.number);
    }
    // The anchor lets the layout move this and the following sections after the summary.
    addHeading(blocks, write.text(REPORT_TEXT("report", "Limits and decision rule")), {},
               QStringLiteral("limits"));
    if (rules.empty())
        blocks.emplace_back(Paragraph{
            write.text(REPORT_TEXT("report", "No limit was agreed: the results have no verdict."))});
    else
        blocks.emplace_back(limits.take(static_cast<int>(parts.size())));
    for (const TextsOfTests &texts : {uncertainties, rules}) {
        for (const TextOfTests &each : texts)
            blocks.emplace_back(Paragraph{
                texts.size() == 1 ? each.text : ofTests(write, each.tests, each.text), TextSize::small});
    }
}

void addBeforeAndAfter(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    const Writer &write = parts.front().write;
    bool any = false;
    for (const TestPart &after : parts) {
        const auto roles = rolesBeside(after.evaluated, after.index, write.language());
        if (!roles || roles->left != after.index)
            continue;
        const auto before = std::ranges::find(parts, roles->found, &TestPart::index);
        if (before == parts.end())
            continue;
        Table table = BeforeAndAfter(*before, after, *roles).take();
        if (table.rows.empty())
            continue;
        if (!any) {
            addHeading(blocks, write.text(REPORT_TEXT("report", "Before and after adjustment")));
            if (const std::string &made = after.head().adjustments; !made.empty())
                blocks.emplace_back(Paragraph{QString::fromStdString(made)});
        }
        any = true;
        blocks.emplace_back(Heading{3, testName(write, after.test), QString::fromUtf8(after.edition().word)});
        blocks.emplace_back(std::move(table));
    }
}

void addComparisonsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts) {
    std::vector<Block> tables;
    std::vector<Block> reasons;
    bool factors = false;
    for (const Kind kind : allKinds) {
        EditionsOfTests beside;
        for (const TestPart &part : parts) {
            const auto table = part.edition().kind == kind ? editionsTable(part, true) : std::nullopt;
            if (!table)
                continue;
            if (const QString why = reasonsOfDifferences(part); !why.isEmpty())
                reasons.emplace_back(
                    Paragraph{part.write.say(REPORT_TEXT("report", "Test %1: %2"),
                                             {std::to_string(part.number), why.toStdString()}),
                              TextSize::small});
            factors = factors || std::ranges::any_of(std::span(table->columns).subspan(1),
                                                     [](const Column &c) { return !c.unit.isEmpty(); });
            if (!beside.add(part, *table)) {
                tables.emplace_back(beside.take());
                beside.add(part, *table);
            }
        }
        if (!beside.empty())
            tables.emplace_back(beside.take());
    }
    if (tables.empty())
        return;
    const Writer &write = parts.front().write;
    addHeading(blocks, write.text(REPORT_TEXT("report", "Comparison of editions")),
               factors ? write.text(REPORT_TEXT("report", "c: factor of s")) : QString());
    for (std::vector<Block> *each : {&tables, &reasons})
        std::ranges::move(*each, std::back_inserter(blocks));
}

} // namespace palmer
