// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "import/layouts/zipfile.h"
#include "kernel/measurement/testfacts.h"

#include <QDate>
#include <QDir>
#include <QMap>
#include <QRegularExpression>
#include <QTime>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>
#include <utility>

namespace palmer {

namespace {

constexpr int deepest = 64;
constexpr int mostColumns = 16'384;
constexpr qsizetype longestCell = 65'535;
constexpr std::size_t mostRepeated = 1'000'000; ///< cells that are written once and repeated

[[noreturn]] void refuseXml(const QXmlStreamReader &xml) {
    throw Error(
        Error::Kind::syntax,
        {REPORT_TEXT("report",
                     "the workbook is damaged or was cut off; save it again, or export the sheet as CSV")},
        std::to_string(xml.lineNumber()) + ':' + std::to_string(xml.columnNumber() + 1));
}

/// Walks through the elements of an XML part; entities are refused. `begin` and `end` get the reader; `text`
/// all characters.
template <class Begin, class End, class Text>
void walk(const QByteArray &bytes, Begin begin, End end, Text text) {
    QXmlStreamReader xml(bytes);
    int depth = 0;
    while (!xml.atEnd()) {
        switch (xml.readNext()) {
        case QXmlStreamReader::DTD:
        case QXmlStreamReader::EntityReference:
            refuseXml(xml);
        case QXmlStreamReader::StartElement:
            if (++depth > deepest)
                refuseXml(xml);
            begin(xml);
            break;
        case QXmlStreamReader::EndElement:
            --depth;
            end(xml);
            break;
        case QXmlStreamReader::Characters:
            text(xml.text());
            break;
        default:
            break;
        }
    }
    if (xml.hasError())
        refuseXml(xml);
}

QString attribute(const QXmlStreamReader &xml, const char *name) {
    for (const QXmlStreamAttribute &each : xml.attributes()) {
        if (each.name() == QLatin1StringView(name))
            return each.value().toString();
    }
    return {};
}

/// Cells of a sheet put into the table with those between them.
class Sheet {
public:
    explicit Sheet(const Choices &choices)
        : m_leavesHidden(choices.chosen("hidden") == "leave") {}

    /// Columns from 0, in the order in which they stand, as files describe them.
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
    /// A formula whose value is not in the file: a number for all that is known of it.
    void addEmptyFormula() {
        ++m_emptyFormulas;
        countEmptyFormulas();
    }
    void add(int column, const QString &text, std::optional<double> number) {
        if (text.isEmpty() && !number)
            return;
        if (column < m_column)
            column = m_column; // cells without place follow one another
        // Numbers are written as text, too.
        const bool isNumber = number || text[0].isDigit() || text[0] == u'-';
        if (isHiddenAt(column)) {
            hiddenNumbers += isNumber ? 1 : 0;
            if (m_leavesHidden)
                return;
        }
        if (column >= mostColumns)
            throw Error(Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more rows or cells than a table of readings can have")},
                        std::to_string(m_line) + ":1");
        if (!m_begun)
            m_builder.beginRow(m_line);
        m_begun = true;
        for (; m_column < column; ++m_column)
            m_builder.add("");
        const std::string utf8 = text.left(longestCell).toStdString();
        if (number)
            m_builder.add(*number, utf8);
        else
            m_builder.add(utf8);
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

    std::size_t hiddenNumbers = 0; ///< in rows or columns that are not shown
    std::size_t emptyFormulas = 0; ///< in rows with numbers, as those of readings
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
    std::vector<bool> m_hiddenColumns; ///< up to the last that is
    bool m_leavesHidden;
    std::size_t m_line = 1;
    int m_column = 0;
    bool m_begun = false;
    bool m_isHidden = false;
    std::size_t m_numbers = 0;       ///< of the row
    std::size_t m_emptyFormulas = 0; ///< of the row, not yet counted
};

bool isTrue(const QString &value) {
    return value == QLatin1StringView("1") || value == QLatin1StringView("true");
}

std::optional<double> finiteNumber(const QString &text) {
    const std::string plain = text.toStdString();
    const CellValue value = readCell(plain, DecimalMark::point);
    return value.kind == CellKind::number ? std::optional(value.value) : std::nullopt;
}

struct SheetName {
    QString name;
    QString member = {}; ///< of the archive (xlsx)
    bool isHidden = false;
};

// ---- .xlsx

/// "BC12" → 54 (from 0); −1 for none.
int columnOf(const QString &reference) {
    int column = 0;
    for (const QChar c : reference) {
        const char16_t letter = c.toUpper().unicode();
        if (letter < u'A' || letter > u'Z')
            break;
        column = column * 26 + (letter - u'A' + 1);
        if (column > 100'000)
            break;
    }
    return column - 1;
}

/// What a part of the package refers to: by Id and by the last word of the Type, names from the root.
QMap<QString, QString> relationshipsOf(ZipFile &zip, const QString &part) {
    const qsizetype slash = part.lastIndexOf(u'/') + 1;
    const QString folder = part.first(slash);
    QMap<QString, QString> targets;
    walk(
        zip.member(folder + QLatin1StringView("_rels/") + part.sliced(slash) + QLatin1StringView(".rels")),
        [&](const QXmlStreamReader &xml) {
            if (xml.name() != QLatin1StringView("Relationship"))
                return;
            const QString target = attribute(xml, "Target");
            const QString name =
                QDir::cleanPath(target.startsWith(u'/') ? target.sliced(1) : folder + target);
            targets[attribute(xml, "Id")] = name;
            targets[attribute(xml, "Type").section(u'/', -1)] = name;
        },
        [](const QXmlStreamReader &) {}, [](QStringView) {});
    return targets;
}

/// The part of an .xlsx that lists its sheets; empty in other archives.
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
    double firstDay = 0; ///< serial number of days to those since 1899-12-30
};

XlsxBook bookOf(ZipFile &zip, const QString &part, const QMap<QString, QString> &relationships) {
    constexpr double daysTo1904 = 1462;
    XlsxBook book;
    walk(
        zip.member(part),
        [&](const QXmlStreamReader &xml) {
            if (xml.name() == QLatin1StringView("workbookPr") && isTrue(attribute(xml, "date1904")))
                book.firstDay = daysTo1904;
            if (xml.name() != QLatin1StringView("sheet") || book.sheets.size() > 10'000)
                return;
            // By its local name: the namespace of the strict form is another.
            const QString state = attribute(xml, "state");
            book.sheets.push_back(
                {attribute(xml, "name"), relationships.value(attribute(xml, "id")),
                 state == QLatin1StringView("hidden") || state == QLatin1StringView("veryHidden")});
        },
        [](const QXmlStreamReader &) {}, [](QStringView) {});
    return book;
}

/// What the number of a cell is shown as, as far as it matters.
enum class Shown { number, time, date };

/// By the code of the format, without what stands there literally: "dd/mm/yyyy", "[h]:mm:ss", "0.0 \"s\"".
Shown shownBy(const QString &code) {
    static const QRegularExpression literal(QStringLiteral(R"("[^"]*"|\\.|_.|\*.|\[[^\]]*[^\]hms][^\]]*\])"));
    constexpr qsizetype longestCode = 255;
    const QString bare = code.left(longestCode).remove(literal).toLower();
    if (bare.contains(u'y') || bare.contains(u'd'))
        return Shown::date;
    return bare.contains(u'h') || bare.contains(u's') ? Shown::time : Shown::number;
}

/// The formats that every program knows by their number.
Shown shownBy(int builtIn) {
    const auto within = [&](int first, int last) { return builtIn >= first && builtIn <= last; };
    if (within(14, 17) || builtIn == 22 || within(27, 31) || builtIn == 36 || within(50, 54) ||
        within(57, 58))
        return Shown::date;
    return within(18, 21) || within(32, 33) || within(45, 47) ? Shown::time : Shown::number;
}

/// Of each style that cells name.
std::vector<Shown> stylesOf(const QByteArray &bytes) {
    constexpr std::size_t mostStyles = 100'000;
    std::vector<Shown> styles;
    if (bytes.isEmpty())
        return styles;
    QMap<int, Shown> own;
    bool ofCells = false;
    walk(
        bytes,
        [&](const QXmlStreamReader &xml) {
            ofCells |= xml.name() == QLatin1StringView("cellXfs");
            const int number = attribute(xml, "numFmtId").toInt();
            if (xml.name() == QLatin1StringView("numFmt"))
                own[number] = shownBy(attribute(xml, "formatCode"));
            else if (ofCells && xml.name() == QLatin1StringView("xf") && styles.size() < mostStyles)
                styles.push_back(own.value(number, shownBy(number)));
        },
        [&](const QXmlStreamReader &xml) { ofCells = ofCells && xml.name() != QLatin1StringView("cellXfs"); },
        [](QStringView) {});
    return styles;
}

/// "2024-03-05", "2024-03-05T10:22:11", "10:22:11.5" of a serial number of days; empty where it is none.
QString timeText(double days, Shown shown) {
    constexpr double firstSure = 61; // before, programs disagree
    constexpr double afterLast = 2'958'466;
    constexpr qint64 dayLength = 86'400'000; // ms
    if (!(days >= (shown == Shown::date ? firstSure : 0)) || !(days < (shown == Shown::date ? afterLast : 1)))
        return {};
    qint64 time = std::llround(days * static_cast<double>(dayLength));
    if (shown == Shown::time)
        time = std::min(time, dayLength - 1); // no next day
    const QTime clock = QTime::fromMSecsSinceStartOfDay(static_cast<int>(time % dayLength));
    QString hours =
        clock.toString(clock.msec() == 0 ? QStringLiteral("HH:mm:ss") : QStringLiteral("HH:mm:ss.zzz"));
    if (shown == Shown::time)
        return hours;
    const QString day = QDate(1899, 12, 30).addDays(time / dayLength).toString(Qt::ISODate);
    return time % dayLength == 0 ? day : day + u'T' + hours;
}

std::vector<QString> sharedStrings(const QByteArray &bytes) {
    std::vector<QString> strings;
    if (bytes.isEmpty())
        return strings;
    bool inText = false;
    bool phonetic = false;
    walk(
        bytes,
        [&](const QXmlStreamReader &xml) {
            if (xml.name() == QLatin1StringView("si"))
                strings.emplace_back();
            phonetic |= xml.name() == QLatin1StringView("rPh");
            inText = xml.name() == QLatin1StringView("t") && !phonetic;
        },
        [&](const QXmlStreamReader &xml) {
            inText = false;
            if (xml.name() == QLatin1StringView("rPh"))
                phonetic = false;
        },
        [&](QStringView text) {
            if (inText && !strings.empty() && strings.back().size() < longestCell)
                strings.back() += text;
        });
    return strings;
}

/// What the cells of all sheets refer to.
struct XlsxCells {
    std::vector<QString> strings;
    std::vector<Shown> styles;
    double firstDay = 0;

    [[nodiscard]] Shown shown(qsizetype style) const {
        return style >= 0 && style < std::ssize(styles) ? styles[static_cast<std::size_t>(style)]
                                                        : Shown::number;
    }
};

void hideColumns(const QXmlStreamReader &column, Sheet &sheet) {
    const int first = attribute(column, "min").toInt();
    const int last = attribute(column, "max").toInt();
    if (isTrue(attribute(column, "hidden")) && first >= 1 && last >= first && last <= mostColumns)
        sheet.hideColumns(first - 1, last - first + 1);
}

void addNumber(const QString &value, Shown shown, double firstDay, int column, Sheet &sheet) {
    const auto number = finiteNumber(value);
    const QString time = number && shown != Shown::number
                             ? timeText(*number + (shown == Shown::date ? firstDay : 0), shown)
                             : QString();
    if (time.isEmpty())
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

    void read(const QByteArray &bytes) {
        walk(
            bytes, [this](const QXmlStreamReader &xml) { begin(xml); },
            [this](const QXmlStreamReader &xml) {
                m_inValue = false;
                if (xml.name() == QLatin1StringView("c") && m_line > 0)
                    addCell();
            },
            [this](QStringView text) {
                if (m_inValue && m_value.size() < longestCell)
                    m_value += text;
            });
    }

private:
    void begin(const QXmlStreamReader &xml) {
        constexpr qulonglong mostLines = 100'000'000;
        const QStringView name = xml.name();
        if (name == QLatin1StringView("row")) {
            const qulonglong stated = attribute(xml, "r").toULongLong();
            m_line = stated > m_line && stated < mostLines ? static_cast<std::size_t>(stated) : m_line + 1;
            m_sheet.beginRow(m_line, isTrue(attribute(xml, "hidden")));
        } else if (name == QLatin1StringView("col")) {
            hideColumns(xml, m_sheet);
        } else if (name == QLatin1StringView("c")) {
            m_type = attribute(xml, "t");
            m_reference = attribute(xml, "r");
            m_value.clear();
            m_isFormula = false;
            m_shown = m_cells.shown(attribute(xml, "s").toInt());
        }
        m_isFormula |= name == QLatin1StringView("f");
        m_inValue = name == QLatin1StringView("v") || name == QLatin1StringView("t");
    }

    void addCell() {
        const int column = m_reference.isEmpty() ? m_sheet.column() : columnOf(m_reference);
        if (m_type == QLatin1StringView("s")) {
            const std::vector<QString> &strings = m_cells.strings;
            bool isNumber = false;
            const uint index = m_value.toUInt(&isNumber);
            m_sheet.add(column, isNumber && index < strings.size() ? strings[index] : QString(), {});
        } else if (m_type.isEmpty() || m_type == QLatin1StringView("n")) {
            if (m_isFormula && m_value.isEmpty())
                m_sheet.addEmptyFormula();
            addNumber(m_value, m_shown, m_cells.firstDay, column, m_sheet);
        } else {
            m_sheet.add(column, m_value, {}); // strings, errors as #N/A, truth values
        }
    }

    const XlsxCells &m_cells;
    Sheet &m_sheet;
    std::size_t m_line = 0;
    QString m_type;
    QString m_reference;
    QString m_value;
    bool m_inValue = false;
    bool m_isFormula = false;
    Shown m_shown = Shown::number;
};

// ---- .ods

/// Reads the sheet of that number (from 0) out of content.xml; collects the names of all.
class OdsReader {
public:
    OdsReader(int wanted, std::vector<SheetName> &names, Sheet &sheet)
        : m_wanted(wanted)
        , m_names(names)
        , m_sheet(sheet) {}

    void read(const QByteArray &bytes) {
        walk(
            bytes, [this](const QXmlStreamReader &xml) { begin(xml); },
            [this](const QXmlStreamReader &xml) { end(xml.name()); },
            [this](QStringView text) { add(text); });
    }

private:
    struct OdsCell {
        int column = 0;
        QString text;
        std::optional<double> number;
        int repeats = 1;
        QString time = {}; ///< in ISO order, whatever the cell shows
        bool isEmptyFormula = false;
    };

    [[nodiscard]] bool isWanted() const { return m_index == m_wanted; }
    [[nodiscard]] static bool isCollapsed(const QXmlStreamReader &xml) {
        const QString visibility = attribute(xml, "visibility");
        return visibility == QLatin1StringView("collapse") || visibility == QLatin1StringView("filter");
    }
    [[nodiscard]] static bool isCell(QStringView name) {
        return name == QLatin1StringView("table-cell") || name == QLatin1StringView("covered-table-cell");
    }

    void begin(const QXmlStreamReader &xml) {
        const QStringView name = xml.name();
        if (name == QLatin1StringView("style")) {
            m_style = attribute(xml, "name");
        } else if (name == QLatin1StringView("table-properties")) {
            if (attribute(xml, "display") == QLatin1StringView("false"))
                m_hidden << m_style;
        } else if (name == QLatin1StringView("table")) {
            ++m_index;
            m_names.push_back({attribute(xml, "name"), {}, m_hidden.contains(attribute(xml, "style-name"))});
            m_line = 0;
            m_columns = 0;
        } else if (isWanted() && name == QLatin1StringView("table-column")) {
            const int count = std::clamp(attribute(xml, "number-columns-repeated").toInt(), 1, mostColumns);
            if (isCollapsed(xml))
                m_sheet.hideColumns(m_columns, count);
            m_columns = std::min(m_columns + count, mostColumns);
        } else if (isWanted() && name == QLatin1StringView("table-row")) {
            m_rowRepeats =
                std::clamp<std::size_t>(attribute(xml, "number-rows-repeated").toULongLong(), 1, 100'000'000);
            m_rowHidden = isCollapsed(xml);
            m_cells.clear();
            m_column = 0;
        } else if (isWanted() && isCell(name)) {
            beginCell(xml);
        } else if (name == QLatin1StringView("annotation")) {
            ++m_annotation;
        } else if (m_inCell && m_annotation == 0 && name == QLatin1StringView("p")) {
            if (m_paragraphs++ > 0)
                m_cell.text += u' ';
        } else if (m_inCell && (name == QLatin1StringView("s") || name == QLatin1StringView("tab") ||
                                name == QLatin1StringView("line-break"))) {
            add(u" ");
        }
    }

    void beginCell(const QXmlStreamReader &xml) {
        m_cell = {
            m_column, {}, {}, std::clamp(attribute(xml, "number-columns-repeated").toInt(), 1, 1'000'000)};
        const QString type = attribute(xml, "value-type");
        if (type == QLatin1StringView("float") || type == QLatin1StringView("percentage") ||
            type == QLatin1StringView("currency"))
            m_cell.number = finiteNumber(attribute(xml, "value"));
        m_cell.time = type == QLatin1StringView("date") ? attribute(xml, "date-value") : QString();
        m_cell.isEmptyFormula = type.isEmpty() && !attribute(xml, "formula").isEmpty();
        m_inCell = true;
        m_paragraphs = 0;
    }

    void end(QStringView name) {
        if (name == QLatin1StringView("annotation")) {
            --m_annotation;
        } else if (isWanted() && m_inCell && isCell(name)) {
            m_inCell = false;
            m_column = std::min(m_column + m_cell.repeats, 10'000'000);
            if (!m_cell.time.isEmpty())
                m_cell.text = m_cell.time;
            m_cell.isEmptyFormula &= m_cell.text.isEmpty();
            if (!m_cell.text.isEmpty() || m_cell.number || m_cell.isEmptyFormula)
                m_cells.push_back(m_cell);
        } else if (isWanted() && name == QLatin1StringView("table-row")) {
            if (m_cells.empty())
                m_line += m_rowRepeats;
            else
                addRows();
        }
    }

    void addRows() {
        // What is repeated is counted before it is written out.
        std::size_t repeated = 0;
        for (const OdsCell &each : m_cells)
            repeated += static_cast<std::size_t>(each.repeats);
        if (repeated > mostRepeated / m_rowRepeats)
            throw Error(Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more rows or cells than a table of readings can have")},
                        std::to_string(m_line + 1) + ":1");
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

    void add(QStringView text) {
        if (m_inCell && m_annotation == 0 && m_paragraphs > 0 && m_cell.text.size() < longestCell)
            m_cell.text += text;
    }

    int m_wanted;
    std::vector<SheetName> &m_names;
    Sheet &m_sheet;
    int m_index = -1;
    std::size_t m_line = 0;
    std::size_t m_rowRepeats = 1;
    QString m_style;
    QStringList m_hidden;
    std::vector<OdsCell> m_cells;
    OdsCell m_cell;
    int m_column = 0;
    int m_columns = 0; ///< described so far
    bool m_rowHidden = false;
    bool m_inCell = false;
    int m_paragraphs = 0;
    int m_annotation = 0;
};

/// Which sheet: its name, or its number from 1; −1 where nothing is chosen.
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
    throw Error(Error::Kind::content,
                {REPORT_TEXT("report", "there is no sheet “%1”; there are: %2"),
                 {wanted.toStdString(), excerpt(names.join(QStringLiteral(", ")).toStdString())}});
}

constexpr std::size_t mostSheetsTried = 20;

std::size_t readingsOf(const Imported &imported) {
    return imported.sensors.size() + (imported.test ? readingsOf(*imported.test) : 0);
}

/// How many readings a table holds, if it is one of a measurement.
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

/// The sheet chosen, else that with most readings: the visible ones first, hidden ones only where no other
/// has any. All are listed, also where none can be read.
class SheetChooser {
public:
    SheetChooser(const std::vector<SheetName> &sheets, Choices &choices, Imported &imported)
        : m_sheets(sheets)
        , m_choices(choices)
        , m(imported) {}

    /// `read` fills a Sheet from the sheet of a number.
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
            settle();
            remarkOnCells();
        }
    }

    [[nodiscard]] bool hasTable() const { return m_best != none; }

private:
    static constexpr std::size_t none = -1;

    /// More than a number or two on a cover.
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
        const std::size_t readings = readingsIn(table, m_choices.options());
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

    /// What the sheet does not show, and what stands in it only as a formula.
    void remarkOnCells() {
        if (m_hiddenNumbers > 0) {
            const auto choice = m_choices.settle("hidden", "read", Origin::guessed);
            addRemark(
                m.remarks, choice.origin == Origin::guessed ? RemarkGrade::assumption : RemarkGrade::note,
                {choice.value == "leave"
                     ? REPORT_TEXT_COUNTED("report",
                                           "Rows or columns of the sheet are hidden; what stands there is "
                                           "left out (%n number(s)).")
                     : REPORT_TEXT_COUNTED("report",
                                           "Rows or columns of the sheet are hidden; what stands there is "
                                           "read like the rest (%n number(s))."),
                 {},
                 static_cast<int>(m_hiddenNumbers)},
                0, "hidden");
        }
        if (m_emptyFormulas > 0)
            addRemark(
                m.remarks, RemarkGrade::problem,
                {REPORT_TEXT_COUNTED(
                     "report", "The value(s) of %n formula(s) are not in the file and were not read; open "
                               "the workbook in a spreadsheet program and save it."),
                 {},
                 static_cast<int>(m_emptyFormulas)},
                m_emptyFormulaLine, "unread");
    }

    void settle() {
        const SheetName &sheet = m_sheets[m_best];
        const bool doubtful = m_measurements > 1 || m_tables > 1 || sheet.isHidden;
        const auto choice = m_choices.settle("sheet", sheet.name.toStdString(),
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
             {Number{static_cast<double>(m_sheets.size()), Quantity::count},
              excerpt(sheet.name.toStdString())}},
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
            addRemark(m.remarks, RemarkGrade::note,
                      {REPORT_TEXT("report", "Hidden sheets: %1."), {excerpt(hidden)}});
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
    QByteArray content;
    XlsxCells cells;
    const QString part = workbookPart(zip);
    const bool isXlsx = !part.isEmpty();
    if (isXlsx) {
        const QMap<QString, QString> relationships = relationshipsOf(zip, part);
        XlsxBook book = bookOf(zip, part, relationships);
        sheets = std::move(book.sheets);
        const QString folder = part.first(part.lastIndexOf(u'/') + 1);
        const auto beside = [&](const QString &word) {
            return zip.member(relationships.value(word, folder + word + QLatin1StringView(".xml")));
        };
        cells = {sharedStrings(beside(QStringLiteral("sharedStrings"))),
                 stylesOf(beside(QStringLiteral("styles"))), book.firstDay};
    } else if (zip.contains(QStringLiteral("content.xml"))) {
        content = zip.member(QStringLiteral("content.xml"));
        Sheet none(choices);
        OdsReader(-2, sheets, none).read(content);
    } else {
        throw Error(Error::Kind::format,
                    {REPORT_TEXT("report", "this archive is no workbook; expected .xlsx or .ods")});
    }
    SheetChooser chooser(sheets, choices, imported);
    chooser.choose([&](int i, Sheet &sheet) {
        std::vector<SheetName> names;
        if (isXlsx)
            XlsxReader(cells, sheet).read(zip.member(sheets[static_cast<std::size_t>(i)].member));
        else
            OdsReader(i, names, sheet).read(content);
    });
    if (!chooser.hasTable())
        throw Error(
            Error::Kind::content,
            {REPORT_TEXT("report", "there is no table of numbers in it; expected target positions and "
                                   "readings, points of a circle, or values over time")});
    if (imported.table.decimalMark.origin != Origin::recognised) {
        choices.settle("decimalMark",
                       imported.table.decimalMark.value == DecimalMark::comma ? "comma" : "point",
                       imported.table.decimalMark.origin);
        if (imported.table.decimalMark.origin == Origin::guessed)
            addRemark(
                imported.remarks, RemarkGrade::assumption,
                {REPORT_TEXT("report",
                             "Decimal mark: numbers that stand there as text can be read in several ways.")},
                0, "decimalMark");
    }
    readMeasurementTable(choices, imported);
}

} // namespace

const ImportFormat workbookFormat{"workbook", REPORT_TEXT("report", "workbook"), "xlsx ods", isWorkbook,
                                  readWorkbook};

} // namespace palmer
