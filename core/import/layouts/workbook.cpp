// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/place.h"
#include "import/layouts/worksheet.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/characters.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <string>
#include <utility>

namespace palmer {

void Sheet::add(int column, std::string_view text, std::optional<double> number, const Unit *unit) {
    if (text.empty() && !number)
        return;
    if (column < m_column)
        column = m_column; // cells without a reference follow one another
    // Numbers may be stored as text.
    const bool isNumber = number || isDigit(text[0]) || text[0] == '-';
    if (isHiddenAt(column)) {
        hiddenNumbers += isNumber ? 1 : 0;
        if (m_leavesHidden)
            return;
    }
    if (column >= mostSheetColumns)
        refuseTableSize(placeOfLine(m_line));
    if (!m_begun)
        m_builder.beginRow(m_line);
    m_begun = true;
    for (; m_column < column; ++m_column)
        m_builder.add("");
    if (number && unit)
        m_builder.add(*number, *unit);
    else if (number)
        m_builder.add(*number, text);
    else
        m_builder.add(text);
    ++m_column;
    m_numbers += isNumber ? 1 : 0;
    countEmptyFormulas();
}

CellTable Sheet::take(const Choices &choices) {
    const std::string_view mark = choices.chosen("decimalMark");
    return m_builder.take(mark.empty()      ? std::nullopt
                          : mark == "comma" ? std::optional(DecimalMark::comma)
                                            : std::optional(DecimalMark::point));
}

std::optional<double> finiteNumber(std::string_view text) {
    const CellValue value = readCell(text, DecimalMark::point);
    return value.kind == CellKind::number ? std::optional(value.value) : std::nullopt;
}

namespace {

/// Index of the chosen sheet, by name or number from 1; −1 if none was chosen.
int chosenSheet(const std::vector<SheetName> &sheets, const Choices &choices) {
    if (!choices.isChosen("sheet"))
        return -1;
    const QString wanted = QString::fromStdString(std::string(choices.chosen("sheet")));
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        if (sheets[i].name == wanted)
            return static_cast<int>(i);
    }
    bool isNumber = false;
    const int number = wanted.toInt(&isNumber);
    if (isNumber && number >= 1 && number <= static_cast<int>(sheets.size()))
        return number - 1;
    QStringList names;
    for (const SheetName &sheet : sheets)
        names << sheet.name;
    refuseContent(REPORT_TEXT("report", "there is no sheet “%1”; there are: %2"), wanted.toStdString(),
                  excerpt(names.join(QStringLiteral(", ")).toStdString()));
}

constexpr std::size_t mostSheetsTried = 20;

std::size_t readingsOf(const Imported &imported) {
    return imported.sensors.size() + (imported.test ? readingsOf(*imported.test) : 0);
}

/// Number of readings in a table; 0 if it is not a measurement.
std::size_t readingsIn(const CellTable &table, const ImportOptions &options) {
    Imported trial;
    trial.table = table;
    Choices choices(options);
    try {
        readMeasurementTable(choices, trial);
    } catch (const Error &) {
        return 0;
    }
    return readingsOf(trial);
}

/// Selects the chosen sheet, otherwise the visible one with most readings, or a hidden one if no visible one
/// has any. Lists all sheets, even if none can be read.
class SheetChooser {
public:
    SheetChooser(const std::vector<SheetName> &sheets, Choices &choices, Imported &imported)
        : m_sheets(sheets)
        , m_choices(choices)
        , m(imported) {}

    /// `read` fills a Sheet from the sheet of that index.
    void choose(const std::function<void(std::size_t, Sheet &)> &read) {
        for (const SheetName &sheet : m_sheets)
            m.sheets.push_back({sheet.name.toStdString(), sheet.isHidden, false});
        const int chosen = chosenSheet(m_sheets, m_choices);
        for (const bool hidden : {false, true}) {
            if (hidden && m_most > 0)
                break;
            std::size_t tried = 0;
            for (std::size_t i = 0; i < m_sheets.size(); ++i) {
                const bool wanted = chosen >= 0 ? static_cast<int>(i) == chosen : tried < mostSheetsTried;
                if (m_sheets[i].isHidden != hidden || !wanted)
                    continue;
                ++tried;
                Sheet sheet(m_choices);
                read(i, sheet);
                take(i, sheet);
            }
        }
        std::ranges::stable_sort(m.sheets, {}, &ImportSheet::isHidden);
        if (hasTable()) {
            resolve();
            remarkOnCells();
        }
    }

    [[nodiscard]] bool hasTable() const { return m_best != none; }
    /// True if there are formulas without stored values among its numbers.
    [[nodiscard]] bool lacksValues() const { return m_emptyFormulas > 0; }

    /// The visible sheets without a table.
    [[nodiscard]] std::vector<CoverSheet> covers() const {
        std::vector<CoverSheet> others = m_covers;
        std::erase_if(others, [&](const CoverSheet &cover) {
            return hasTable() && cover.name == m_sheets[m_best].name.toStdString();
        });
        return others;
    }

private:
    static constexpr std::size_t none = -1;

    /// True for more than the few numbers of a cover sheet.
    static bool isTable(const CellTable &table) {
        constexpr std::ptrdiff_t fewRows = 3;
        return std::ranges::count_if(table.rows(), [&](const TableRow &row) {
                   return std::ranges::count_if(table.cells(row), &TableCell::isNumber) > 1;
               }) >= fewRows;
    }

    void take(std::size_t i, Sheet &sheet) {
        CellTable table = sheet.take(m_choices);
        if (table.rows().empty())
            return;
        // A single sheet needs no trial, as it is read later.
        const std::size_t readings = m_sheets.size() == 1 ? 1 : readingsIn(table, m_choices.options());
        m.sheets[i].hasMeasurement = readings > 0;
        m_measurements += readings > 0 ? 1 : 0;
        m_tables += isTable(table) ? 1 : 0;
        if (readings == 0 && !m_sheets[i].isHidden && !isTable(table))
            m_covers.push_back({m_sheets[i].name.toStdString(), table});
        if (hasTable() && readings <= m_most)
            return;
        m_best = i;
        m_most = readings;
        m.table = std::move(table);
        m_hiddenNumbers = sheet.hiddenNumbers;
        m_comments = std::move(sheet.comments);
        m_emptyFormulas = sheet.emptyFormulas;
        m_emptyFormulaLine = sheet.emptyFormulaLine;
    }

    /// Remarks on hidden cells and on formulas without values.
    void remarkOnCells() {
        m_comments.remarkUnused(m.remarks);
        if (m_hiddenNumbers > 0) {
            const auto choice = m_choices.resolve("hidden", "read", Origin::guessed);
            m.remarks.add(
                choice.origin == Origin::guessed ? RemarkGrade::assumption : RemarkGrade::note, "hidden",
                {choice.value == "leave"
                     ? REPORT_TEXT_COUNTED("report", "Rows or columns of the sheet are hidden; what stands "
                                                     "there is left out (%n number(s)).")
                     : REPORT_TEXT_COUNTED("report", "Rows or columns of the sheet are hidden; what stands "
                                                     "there is read like the rest (%n number(s))."),
                 {},
                 static_cast<int>(m_hiddenNumbers)});
        }
        if (m_emptyFormulas > 0)
            m.remarks.add(RemarkGrade::problem, {"unread", m_emptyFormulaLine},
                          {REPORT_TEXT_COUNTED(
                               "report", "The value(s) of %n formula(s) are not in the file and were not "
                                         "read; open the workbook in a spreadsheet program and save it."),
                           {},
                           static_cast<int>(m_emptyFormulas)});
    }

    void resolve() {
        const SheetName &sheet = m_sheets[m_best];
        const bool doubtful = m_measurements > 1 || m_tables > 1 || sheet.isHidden;
        const auto choice = m_choices.resolve("sheet", sheet.name.toStdString(),
                                              doubtful ? Origin::guessed : Origin::recognised);
        if (m_sheets.size() < 2 && !doubtful)
            return;
        Remark remark{
            choice.origin != Origin::guessed     ? RemarkGrade::note
            : m_measurements > 1 || m_tables > 1 ? RemarkGrade::problem
                                                 : RemarkGrade::assumption,
            {sheet.isHidden
                 ? REPORT_TEXT("report", "The workbook has %1 sheets; “%2” is read, which is hidden.")
             : choice.origin == Origin::guessed && m_measurements < 2
                 ? REPORT_TEXT("report", "The workbook has %1 sheets, several with rows of numbers; “%2” is "
                                         "read, the others are not.")
             : choice.origin == Origin::guessed
                 ? REPORT_TEXT("report",
                               "The workbook has %1 sheets, several with a measurement; “%2” is read.")
                 : REPORT_TEXT("report", "The workbook has %1 sheets; “%2” is read."),
             {counted(m_sheets.size()), excerpt(sheet.name.toStdString())}},
            0,
            0,
            "sheet"};
        for (const ImportSheet &each : m.sheets)
            remark.answers.push_back(each.name);
        m.remarks.push_back(std::move(remark));
        std::string hidden;
        for (const ImportSheet &each : m.sheets) {
            if (each.isHidden && each.name != choice.value)
                hidden += (hidden.empty() ? "" : ", ") + each.name;
        }
        if (!hidden.empty())
            m.remarks.note({}, REPORT_TEXT("report", "Hidden sheets: %1."), excerpt(hidden));
    }

    const std::vector<SheetName> &m_sheets;
    Choices &m_choices;
    Imported &m;
    std::vector<CoverSheet> m_covers;
    QuotedLines m_comments;
    std::size_t m_best = none; ///< index of a sheet
    std::size_t m_most = 0;
    std::size_t m_measurements = 0;
    std::size_t m_tables = 0; ///< sheets with rows of numbers
    std::size_t m_hiddenNumbers = 0;
    std::size_t m_emptyFormulas = 0;
    std::size_t m_emptyFormulaLine = 0;
};

bool isWorkbook(QByteArrayView bytes) {
    return bytes.startsWith("PK\x03\x04") || bytes.startsWith("PK\x05\x06");
}

void readWorkbook(const ImportSource &source, Choices &choices, Imported &imported) {
    const std::unique_ptr<ZipFile> zip = openZip(source.bytes);
    std::optional<Workbook> book = xlsxOf(*zip);
    if (!book)
        book = odsOf(*zip);
    if (!book)
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report", "this archive is no workbook; expected .xlsx or .ods"));
    SheetChooser chooser(book->sheets, choices, imported);
    chooser.choose(book->read);
    if (!chooser.hasTable())
        refuseWithoutNumbers();
    if (imported.table.decimalMark.origin != Origin::recognised) {
        choices.resolve("decimalMark",
                        imported.table.decimalMark.value == DecimalMark::comma ? "comma" : "point",
                        imported.table.decimalMark.origin);
        if (imported.table.decimalMark.origin == Origin::guessed)
            imported.remarks.problem(
                "decimalMark", REPORT_TEXT("report", "Decimal mark: numbers that "
                                                     "stand there as text can be read in several ways."));
    }
    try {
        readMeasurementTable(choices, imported, chooser.covers());
    } catch (const Error &) {
        if (!chooser.lacksValues())
            throw;
        refuseContent(REPORT_TEXT("report", "the values of its formulas are not in the file; open the "
                                            "workbook in a spreadsheet program and save it"));
    }
}

} // namespace

const ImportFormat workbookFormat{"workbook", REPORT_TEXT("report", "workbook"), "xlsx ods", isWorkbook,
                                  readWorkbook};

} // namespace palmer
