// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/place.h"
#include "import/layouts/zipfile.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/words/characters.h"
#include "tables/contenterror.h"

#include <QDate>
#include <QDir>
#include <QMap>
#include <QRegularExpression>
#include <QTime>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace palmer {

namespace {

constexpr int mostColumns = 16'384;
constexpr std::size_t longestCell = 65'535;     ///< bytes
constexpr std::size_t mostRepeated = 1'000'000; ///< repeated cells, which are stored once

/// Visits the elements of a part, if it exists.
template <class Begin, class End, class Text>
void walk(ZipFile &zip, const QString &part, Begin begin, End end, Text text) {
    class Handler : public XmlHandler {
    public:
        Handler(Begin &begin, End &end, Text &text)
            : m_begin(begin)
            , m_end(end)
            , m_text(text) {}
        void begin(const XmlElement &element) override { m_begin(element); }
        void end(std::string_view name) override { m_end(name); }
        void text(std::string_view text) override { m_text(text); }

    private:
        Begin &m_begin;
        End &m_end;
        Text &m_text;
    };
    Handler handler(begin, end, text);
    zip.walk(part, handler);
}

constexpr auto noEnd = [](std::string_view) {};
constexpr auto noText = [](std::string_view) {};

/// The integer value of an attribute; 0 for anything else.
template <class Number = int>
Number wholeNumber(std::string_view text) {
    Number number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

QString inQt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Adds cells of a sheet to the table, including the empty ones between them.
class Sheet {
public:
    explicit Sheet(const Choices &choices)
        : m_leavesHidden(choices.chosen("hidden") == "leave") {}

    /// Columns from 0, in ascending order, as described in files.
    void hideColumns(int first, int count) {
        if (first < std::ssize(m_hiddenColumns))
            return;
        m_hiddenColumns.resize(static_cast<std::size_t>(first), false);
        m_hiddenColumns.resize(static_cast<std::size_t>(first) + static_cast<std::size_t>(count), true);
    }
    void beginRow(std::size_t line, bool isHidden = false) {
        m_column = 0;
        m_line = line;
        m_begun = false;
        m_isHidden = isHidden;
        m_numbers = 0;
        m_emptyFormulas = 0;
    }
    /// A formula without a stored value, which may be a number.
    void addEmptyFormula() {
        ++m_emptyFormulas;
        countEmptyFormulas();
    }
    void add(int column, std::string_view text, std::optional<double> number) {
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
        if (column >= mostColumns)
            throw Error(Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more rows or cells than a table of readings can have")},
                        placeOfLine(m_line));
        if (!m_begun)
            m_builder.beginRow(m_line);
        m_begun = true;
        for (; m_column < column; ++m_column)
            m_builder.add("");
        if (number)
            m_builder.add(*number, text);
        else
            m_builder.add(text);
        ++m_column;
        m_numbers += isNumber ? 1 : 0;
        countEmptyFormulas();
    }
    [[nodiscard]] int column() const { return m_column; }
    CellTable take(const Choices &choices) {
        const std::string_view mark = choices.chosen("decimalMark");
        return m_builder.take(mark.empty()      ? std::nullopt
                              : mark == "comma" ? std::optional(DecimalMark::comma)
                                                : std::optional(DecimalMark::point));
    }

    std::size_t hiddenNumbers = 0; ///< in hidden rows or columns
    std::size_t emptyFormulas = 0; ///< in rows with numbers, such as readings
    std::size_t emptyFormulaLine = 0;

private:
    [[nodiscard]] bool isHiddenAt(int column) const {
        return m_isHidden ||
               (column < std::ssize(m_hiddenColumns) && m_hiddenColumns[static_cast<std::size_t>(column)]);
    }
    void countEmptyFormulas() {
        if (m_numbers == 0 || m_emptyFormulas == 0)
            return;
        if (emptyFormulas == 0)
            emptyFormulaLine = m_line;
        emptyFormulas += std::exchange(m_emptyFormulas, 0);
    }

    TableBuilder m_builder;
    std::vector<bool> m_hiddenColumns; ///< up to the last hidden one
    bool m_leavesHidden;
    std::size_t m_line = 1;
    int m_column = 0;
    bool m_begun = false;
    bool m_isHidden = false;
    std::size_t m_numbers = 0;       ///< in the row
    std::size_t m_emptyFormulas = 0; ///< in the row, not yet counted
};

bool isTrue(std::string_view value) {
    return value == "1" || value == "true";
}

std::optional<double> finiteNumber(std::string_view text) {
    const CellValue value = readCell(text, DecimalMark::point);
    return value.kind == CellKind::number ? std::optional(value.value) : std::nullopt;
}

struct SheetName {
    QString name;
    QString member = {}; ///< in the archive (xlsx)
    bool isHidden = false;
};

// ---- .xlsx

/// "BC12" → 54 (from 0); −1 if there is none.
int columnOfReference(std::string_view reference) {
    int column = 0;
    for (const char c : reference) {
        const char letter = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
        if (letter < 'A' || letter > 'Z')
            break;
        column = column * 26 + (letter - 'A' + 1);
        if (column > 100'000)
            break;
    }
    return column - 1;
}

/// Targets that a part of the package refers to, by Id and by the last word of the Type; names from the root.
QMap<QString, QString> relationshipsOf(ZipFile &zip, const QString &part) {
    const qsizetype slash = part.lastIndexOf(u'/') + 1;
    const QString folder = part.first(slash);
    QMap<QString, QString> targets;
    walk(
        zip, folder + QLatin1StringView("_rels/") + part.sliced(slash) + QLatin1StringView(".rels"),
        [&](const XmlElement &xml) {
            if (xml.name != "Relationship")
                return;
            const QString target = inQt(xml.attribute("Target"));
            const QString name =
                QDir::cleanPath(target.startsWith(u'/') ? target.sliced(1) : folder + target);
            targets[inQt(xml.attribute("Id"))] = name;
            targets[inQt(xml.attribute("Type")).section(u'/', -1)] = name;
        },
        noEnd, noText);
    return targets;
}

/// The part of an .xlsx that lists its sheets; empty for other archives.
QString workbookPart(ZipFile &zip) {
    QString usual = QStringLiteral("xl/workbook.xml");
    if (zip.contains(usual))
        return usual;
    if (!zip.contains(QStringLiteral("_rels/.rels")))
        return {};
    const QString stated = relationshipsOf(zip, {}).value(QStringLiteral("officeDocument"));
    const bool isBook = stated.contains(QLatin1StringView("workbook"), Qt::CaseInsensitive) &&
                        stated.endsWith(QLatin1StringView(".xml"), Qt::CaseInsensitive);
    return isBook && zip.contains(stated) ? stated : QString();
}

struct XlsxBook {
    std::vector<SheetName> sheets;
    double firstDay = 0; ///< offset from serial day numbers to days since 1899-12-30
};

XlsxBook bookOf(ZipFile &zip, const QString &part, const QMap<QString, QString> &relationships) {
    constexpr double daysTo1904 = 1462;
    XlsxBook book;
    walk(
        zip, part,
        [&](const XmlElement &xml) {
            if (xml.name == "workbookPr" && isTrue(xml.attribute("date1904")))
                book.firstDay = daysTo1904;
            if (xml.name != "sheet" || book.sheets.size() > 10'000)
                return;
            // By local name, as the namespace differs in the strict format.
            const std::string_view state = xml.attribute("state");
            book.sheets.push_back({inQt(xml.attribute("name")),
                                   relationships.value(inQt(xml.attribute("id"))),
                                   state == "hidden" || state == "veryHidden"});
        },
        noEnd, noText);
    return book;
}

/// How a cell's number is displayed, where relevant.
enum class Shown { number, time, date };

/// Display of a number format, without literal text: "dd/mm/yyyy", "[h]:mm:ss", "0.0 \"s\"".
Shown shownBy(const QString &code) {
    static const QRegularExpression literal(QStringLiteral(R"("[^"]*"|\\.|_.|\*.|\[[^\]]*[^\]hms][^\]]*\])"));
    constexpr qsizetype longestCode = 255;
    const QString bare = code.left(longestCode).remove(literal).toLower();
    if (bare.contains(u'y') || bare.contains(u'd'))
        return Shown::date;
    return bare.contains(u'h') || bare.contains(u's') ? Shown::time : Shown::number;
}

/// Display of the built-in number formats.
Shown shownBy(int builtIn) {
    const auto within = [&](int first, int last) { return builtIn >= first && builtIn <= last; };
    if (within(14, 17) || builtIn == 22 || within(27, 31) || builtIn == 36 || within(50, 54) ||
        within(57, 58))
        return Shown::date;
    return within(18, 21) || within(32, 33) || within(45, 47) ? Shown::time : Shown::number;
}

/// Display of each style referenced by cells.
std::vector<Shown> stylesOf(ZipFile &zip, const QString &part) {
    constexpr std::size_t mostStyles = 100'000;
    std::vector<Shown> styles;
    QMap<int, Shown> own;
    bool ofCells = false;
    walk(
        zip, part,
        [&](const XmlElement &xml) {
            ofCells |= xml.name == "cellXfs";
            const int number = wholeNumber(xml.attribute("numFmtId"));
            if (xml.name == "numFmt")
                own[number] = shownBy(inQt(xml.attribute("formatCode")));
            else if (ofCells && xml.name == "xf" && styles.size() < mostStyles)
                styles.push_back(own.value(number, shownBy(number)));
        },
        [&](std::string_view name) { ofCells = ofCells && name != "cellXfs"; }, noText);
    return styles;
}

/// "2024-03-05", "2024-03-05T10:22:11", "10:22:11.5" for a serial day number; empty if it is not one.
std::string timeText(double days, Shown shown) {
    constexpr double firstSure = 61; // programs disagree on earlier days
    constexpr double afterLast = 2'958'466;
    constexpr qint64 dayLength = 86'400'000; // ms
    if (!(days >= (shown == Shown::date ? firstSure : 0)) || !(days < (shown == Shown::date ? afterLast : 1)))
        return {};
    qint64 time = std::llround(days * static_cast<double>(dayLength));
    if (shown == Shown::time)
        time = std::min(time, dayLength - 1); // not the next day
    const QTime clock = QTime::fromMSecsSinceStartOfDay(static_cast<int>(time % dayLength));
    QString hours =
        clock.toString(clock.msec() == 0 ? QStringLiteral("HH:mm:ss") : QStringLiteral("HH:mm:ss.zzz"));
    if (shown == Shown::time)
        return hours.toStdString();
    const QString day = QDate(1899, 12, 30).addDays(time / dayLength).toString(Qt::ISODate);
    return (time % dayLength == 0 ? day : day + u'T' + hours).toStdString();
}

std::vector<std::string> sharedStrings(ZipFile &zip, const QString &part) {
    std::vector<std::string> strings;
    bool inText = false;
    bool phonetic = false;
    walk(
        zip, part,
        [&](const XmlElement &xml) {
            if (xml.name == "si")
                strings.emplace_back();
            phonetic |= xml.name == "rPh";
            inText = xml.name == "t" && !phonetic;
        },
        [&](std::string_view name) {
            inText = false;
            phonetic = phonetic && name != "rPh";
        },
        [&](std::string_view text) {
            if (inText && !strings.empty() && strings.back().size() < longestCell)
                strings.back() += text;
        });
    return strings;
}

/// Data shared by the cells of all sheets.
struct XlsxCells {
    std::vector<std::string> strings;
    std::vector<Shown> styles;
    double firstDay = 0;

    [[nodiscard]] Shown shown(std::size_t style) const {
        return style < styles.size() ? styles[style] : Shown::number;
    }
};

void hideColumns(const XmlElement &column, Sheet &sheet) {
    const int first = wholeNumber(column.attribute("min"));
    const int last = wholeNumber(column.attribute("max"));
    if (isTrue(column.attribute("hidden")) && first >= 1 && last >= first && last <= mostColumns)
        sheet.hideColumns(first - 1, last - first + 1);
}

void addNumber(std::string_view value, Shown shown, double firstDay, int column, Sheet &sheet) {
    const auto number = finiteNumber(value);
    const std::string time = number && shown != Shown::number
                                 ? timeText(*number + (shown == Shown::date ? firstDay : 0), shown)
                                 : std::string();
    if (time.empty())
        sheet.add(column, value, number);
    else
        sheet.add(column, time, {});
}

/// Reads one sheet of an .xlsx.
class XlsxReader {
public:
    XlsxReader(const XlsxCells &cells, Sheet &sheet)
        : m_cells(cells)
        , m_sheet(sheet) {}

    void read(ZipFile &zip, const QString &part) {
        walk(
            zip, part, [this](const XmlElement &xml) { begin(xml); },
            [this](std::string_view name) {
                m_inValue = false;
                if (name == "c" && m_line > 0)
                    addCell();
            },
            [this](std::string_view text) {
                if (m_inValue && m_value.size() < longestCell)
                    m_value += text;
            });
    }

private:
    void begin(const XmlElement &xml) {
        constexpr std::size_t mostLines = 100'000'000;
        const std::string_view name = xml.name;
        if (name == "c") {
            m_type = xml.attribute("t");
            const std::string_view reference = xml.attribute("r");
            m_column = reference.empty() ? -1 : columnOfReference(reference);
            m_value.clear();
            m_isFormula = false;
            m_shown = m_cells.shown(wholeNumber<std::size_t>(xml.attribute("s")));
        } else if (name == "row") {
            const auto stated = wholeNumber<std::size_t>(xml.attribute("r"));
            m_line = stated > m_line && stated < mostLines ? stated : m_line + 1;
            m_sheet.beginRow(m_line, isTrue(xml.attribute("hidden")));
        } else if (name == "col") {
            hideColumns(xml, m_sheet);
        }
        m_isFormula |= name == "f";
        m_inValue = name == "v" || name == "t";
    }

    void addCell() {
        const int column = m_column < 0 ? m_sheet.column() : m_column;
        if (m_type == "s") {
            std::size_t index = 0;
            const auto [end, error] = std::from_chars(m_value.data(), m_value.data() + m_value.size(), index);
            const bool isIndex = error == std::errc() && end == m_value.data() + m_value.size();
            m_sheet.add(column,
                        isIndex && index < m_cells.strings.size() ? m_cells.strings[index] : std::string(),
                        {});
        } else if (m_type.empty() || m_type == "n") {
            if (m_isFormula && m_value.empty())
                m_sheet.addEmptyFormula();
            addNumber(m_value, m_shown, m_cells.firstDay, column, m_sheet);
        } else {
            m_sheet.add(column, m_value, {}); // strings, errors such as #N/A, booleans
        }
    }

    const XlsxCells &m_cells;
    Sheet &m_sheet;
    std::size_t m_line = 0;
    std::string m_type;
    int m_column = -1; ///< below 0: not stated
    std::string m_value;
    bool m_inValue = false;
    bool m_isFormula = false;
    Shown m_shown = Shown::number;
};

// ---- .ods

/// Reads one sheet of content.xml by its index from 0; collects the names of all.
class OdsReader {
public:
    OdsReader(int wanted, std::vector<SheetName> &names, Sheet &sheet)
        : m_wanted(wanted)
        , m_names(names)
        , m_sheet(sheet) {}

    void read(ZipFile &zip, const QString &part) {
        walk(
            zip, part, [this](const XmlElement &xml) { begin(xml); },
            [this](std::string_view name) { end(name); }, [this](std::string_view text) { add(text); });
    }

private:
    struct OdsCell {
        int column = 0;
        std::string text;
        std::optional<double> number;
        int repeats = 1;
        std::string time = {}; ///< in ISO format, whatever the cell displays
        bool isEmptyFormula = false;
    };

    [[nodiscard]] bool isWanted() const { return m_index == m_wanted; }
    [[nodiscard]] static bool isCollapsed(const XmlElement &xml) {
        const std::string_view visibility = xml.attribute("visibility");
        return visibility == "collapse" || visibility == "filter";
    }
    [[nodiscard]] static bool isCell(std::string_view name) {
        return name == "table-cell" || name == "covered-table-cell";
    }

    void begin(const XmlElement &xml) {
        const std::string_view name = xml.name;
        if (name == "style") {
            m_style = xml.attribute("name");
        } else if (name == "table-properties") {
            if (xml.attribute("display") == "false")
                m_hidden.insert(m_style);
        } else if (name == "table") {
            ++m_index;
            m_names.push_back({inQt(xml.attribute("name")),
                               {},
                               m_hidden.contains(std::string(xml.attribute("style-name")))});
            m_line = 0;
            m_columns = 0;
        } else if (isWanted() && name == "table-column") {
            const int count =
                std::clamp(wholeNumber(xml.attribute("number-columns-repeated")), 1, mostColumns);
            if (isCollapsed(xml))
                m_sheet.hideColumns(m_columns, count);
            m_columns = std::min(m_columns + count, mostColumns);
        } else if (isWanted() && name == "table-row") {
            m_rowRepeats = std::clamp(wholeNumber<std::size_t>(xml.attribute("number-rows-repeated")),
                                      std::size_t(1), std::size_t(100'000'000));
            m_rowHidden = isCollapsed(xml);
            m_cells.clear();
            m_column = 0;
        } else if (isWanted() && isCell(name)) {
            beginCell(xml);
        } else if (name == "annotation") {
            ++m_annotation;
        } else if (m_inCell && m_annotation == 0 && name == "p") {
            if (m_paragraphs++ > 0)
                m_cell.text += ' ';
        } else if (m_inCell && (name == "s" || name == "tab" || name == "line-break")) {
            add(" ");
        }
    }

    void beginCell(const XmlElement &xml) {
        m_cell = {m_column,
                  {},
                  {},
                  std::clamp(wholeNumber(xml.attribute("number-columns-repeated")), 1, 1'000'000)};
        const std::string_view type = xml.attribute("value-type");
        if (type == "float" || type == "percentage" || type == "currency")
            m_cell.number = finiteNumber(xml.attribute("value"));
        if (type == "date")
            m_cell.time = xml.attribute("date-value");
        m_cell.isEmptyFormula = type.empty() && !xml.attribute("formula").empty();
        m_inCell = true;
        m_paragraphs = 0;
    }

    void end(std::string_view name) {
        if (name == "annotation") {
            --m_annotation;
        } else if (isWanted() && m_inCell && isCell(name)) {
            m_inCell = false;
            m_column = std::min(m_column + m_cell.repeats, 10'000'000);
            if (!m_cell.time.empty())
                m_cell.text = m_cell.time;
            m_cell.isEmptyFormula &= m_cell.text.empty();
            if (!m_cell.text.empty() || m_cell.number || m_cell.isEmptyFormula)
                m_cells.push_back(m_cell);
        } else if (isWanted() && name == "table-row") {
            if (m_cells.empty())
                m_line += m_rowRepeats;
            else
                addRows();
        }
    }

    void addRows() {
        // Repeated cells are counted before they are expanded.
        std::size_t repeated = 0;
        for (const OdsCell &each : m_cells)
            repeated += static_cast<std::size_t>(each.repeats);
        if (repeated > mostRepeated / m_rowRepeats)
            throw Error(Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more rows or cells than a table of readings can have")},
                        placeOfLine(m_line + 1));
        for (std::size_t i = 0; i < m_rowRepeats; ++i) {
            m_sheet.beginRow(++m_line, m_rowHidden);
            for (const OdsCell &each : m_cells) {
                for (int k = 0; k < each.repeats; ++k) {
                    if (each.isEmptyFormula)
                        m_sheet.addEmptyFormula();
                    m_sheet.add(each.column + k, each.text, each.number);
                }
            }
        }
    }

    void add(std::string_view text) {
        if (m_inCell && m_annotation == 0 && m_paragraphs > 0 && m_cell.text.size() < longestCell)
            m_cell.text += text;
    }

    int m_wanted;
    std::vector<SheetName> &m_names;
    Sheet &m_sheet;
    int m_index = -1;
    std::size_t m_line = 0;
    std::size_t m_rowRepeats = 1;
    std::string m_style;
    std::set<std::string> m_hidden;
    std::vector<OdsCell> m_cells;
    OdsCell m_cell;
    int m_column = 0;
    int m_columns = 0; ///< described so far
    bool m_rowHidden = false;
    bool m_inCell = false;
    int m_paragraphs = 0;
    int m_annotation = 0;
};

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
    template <class Read>
    void choose(Read read) {
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
                read(static_cast<int>(i), sheet);
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
        if (hasTable() && readings <= m_most)
            return;
        m_best = i;
        m_most = readings;
        m.table = std::move(table);
        m_hiddenNumbers = sheet.hiddenNumbers;
        m_emptyFormulas = sheet.emptyFormulas;
        m_emptyFormulaLine = sheet.emptyFormulaLine;
    }

    /// Remarks on hidden cells and on formulas without values.
    void remarkOnCells() {
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
            choice.origin == Origin::guessed ? RemarkGrade::assumption : RemarkGrade::note,
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
    const std::unique_ptr<ZipFile> opened = openZip(source.bytes);
    ZipFile &zip = *opened;
    std::vector<SheetName> sheets;
    const QString content = QStringLiteral("content.xml");
    XlsxCells cells;
    const QString part = workbookPart(zip);
    const bool isXlsx = !part.isEmpty();
    if (isXlsx) {
        const QMap<QString, QString> relationships = relationshipsOf(zip, part);
        XlsxBook book = bookOf(zip, part, relationships);
        sheets = std::move(book.sheets);
        const QString folder = part.first(part.lastIndexOf(u'/') + 1);
        const auto beside = [&](const QString &word) {
            return relationships.value(word, folder + word + QLatin1StringView(".xml"));
        };
        cells = {sharedStrings(zip, beside(QStringLiteral("sharedStrings"))),
                 stylesOf(zip, beside(QStringLiteral("styles"))), book.firstDay};
    } else if (zip.contains(content)) {
        Sheet none(choices);
        OdsReader(-2, sheets, none).read(zip, content);
    } else {
        throw Error(Error::Kind::format,
                    {REPORT_TEXT("report", "this archive is no workbook; expected .xlsx or .ods")});
    }
    SheetChooser chooser(sheets, choices, imported);
    chooser.choose([&](int i, Sheet &sheet) {
        std::vector<SheetName> names;
        if (isXlsx)
            XlsxReader(cells, sheet).read(zip, sheets[static_cast<std::size_t>(i)].member);
        else
            OdsReader(i, names, sheet).read(zip, content);
    });
    if (!chooser.hasTable())
        refuseContent(REPORT_TEXT("report", "there is no table of numbers in it; expected target positions "
                                            "and readings, points of a circle, or values over time"));
    if (imported.table.decimalMark.origin != Origin::recognised) {
        choices.resolve("decimalMark",
                        imported.table.decimalMark.value == DecimalMark::comma ? "comma" : "point",
                        imported.table.decimalMark.origin);
        if (imported.table.decimalMark.origin == Origin::guessed)
            imported.remarks.assumption(
                "decimalMark", REPORT_TEXT("report", "Decimal mark: numbers that "
                                                     "stand there as text can be read in several ways."));
    }
    readMeasurementTable(choices, imported);
}

} // namespace

const ImportFormat workbookFormat{"workbook", REPORT_TEXT("report", "workbook"), "xlsx ods", isWorkbook,
                                  readWorkbook};

} // namespace palmer
