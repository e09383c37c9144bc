// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "import/layouts/zipfile.h"
#include "kernel/measurement/testfacts.h"

#include <QMap>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>

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
    void beginRow(std::size_t line) {
        m_column = 0;
        m_line = line;
        m_begun = false;
    }
    void add(int column, const QString &text, std::optional<double> number) {
        if (text.isEmpty() && !number)
            return;
        if (column < m_column)
            column = m_column; // cells without place follow one another
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
        hasNumbers |= number.has_value();
        ++m_column;
    }
    [[nodiscard]] int column() const { return m_column; }
    CellTable take(const Choices &choices) {
        const std::string_view mark = choices.chosen("decimalMark");
        return m_builder.take(mark.empty()      ? std::nullopt
                              : mark == "comma" ? std::optional(DecimalMark::comma)
                                                : std::optional(DecimalMark::point));
    }

    bool hasNumbers = false;

private:
    TableBuilder m_builder;
    std::size_t m_line = 1;
    int m_column = 0;
    bool m_begun = false;
};

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

std::vector<SheetName> sheetsOfXlsx(ZipFile &zip) {
    QMap<QString, QString> targets;
    walk(
        zip.member(QStringLiteral("xl/_rels/workbook.xml.rels")),
        [&](const QXmlStreamReader &xml) {
            if (xml.name() == QLatin1StringView("Relationship"))
                targets[attribute(xml, "Id")] = attribute(xml, "Target");
        },
        [](const QXmlStreamReader &) {}, [](QStringView) {});
    std::vector<SheetName> sheets;
    walk(
        zip.member(QStringLiteral("xl/workbook.xml")),
        [&](const QXmlStreamReader &xml) {
            if (xml.name() != QLatin1StringView("sheet") || sheets.size() > 10'000)
                return;
            // By its local name: the namespace of the strict form is another.
            QString target = targets.value(attribute(xml, "id"));
            if (target.startsWith(u'/'))
                target.remove(0, 1);
            else
                target.prepend(QLatin1StringView("xl/"));
            const QString state = attribute(xml, "state");
            sheets.push_back(
                {attribute(xml, "name"), target,
                 state == QLatin1StringView("hidden") || state == QLatin1StringView("veryHidden")});
        },
        [](const QXmlStreamReader &) {}, [](QStringView) {});
    return sheets;
}

std::vector<QString> sharedStrings(ZipFile &zip) {
    std::vector<QString> strings;
    const QByteArray bytes = zip.member(QStringLiteral("xl/sharedStrings.xml"));
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

void readXlsxSheet(const QByteArray &bytes, const std::vector<QString> &strings, Sheet &sheet) {
    std::size_t line = 0;
    QString type;
    QString reference;
    QString value;
    bool inValue = false;
    walk(
        bytes,
        [&](const QXmlStreamReader &xml) {
            const QStringView name = xml.name();
            if (name == QLatin1StringView("row")) {
                const qulonglong stated = attribute(xml, "r").toULongLong();
                line = stated > line && stated < 100'000'000 ? static_cast<std::size_t>(stated) : line + 1;
                sheet.beginRow(line);
            } else if (name == QLatin1StringView("c")) {
                type = attribute(xml, "t");
                reference = attribute(xml, "r");
                value.clear();
            }
            inValue = name == QLatin1StringView("v") || name == QLatin1StringView("t");
        },
        [&](const QXmlStreamReader &xml) {
            inValue = false;
            if (xml.name() != QLatin1StringView("c") || line == 0)
                return;
            const int column = reference.isEmpty() ? sheet.column() : columnOf(reference);
            if (type == QLatin1StringView("s")) {
                bool isNumber = false;
                const uint index = value.toUInt(&isNumber);
                sheet.add(column, isNumber && index < strings.size() ? strings[index] : QString(), {});
            } else if (type.isEmpty() || type == QLatin1StringView("n")) {
                const auto number = finiteNumber(value);
                sheet.add(column, value, number);
            } else {
                sheet.add(column, value, {}); // strings, errors as #N/A, truth values
            }
        },
        [&](QStringView text) {
            if (inValue && value.size() < longestCell)
                value += text;
        });
}

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
    };

    [[nodiscard]] bool isWanted() const { return m_index == m_wanted; }
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
        } else if (isWanted() && name == QLatin1StringView("table-row")) {
            m_rowRepeats =
                std::clamp<std::size_t>(attribute(xml, "number-rows-repeated").toULongLong(), 1, 100'000'000);
            m_cells.clear();
            m_column = 0;
        } else if (isWanted() && isCell(name)) {
            beginCell(xml);
        } else if (name == QLatin1StringView("annotation")) {
            ++m_annotation;
        } else if (m_inCell && m_annotation == 0 && name == QLatin1StringView("p")) {
            if (m_paragraphs++ > 0)
                m_cell.text += u' ';
        }
    }

    void beginCell(const QXmlStreamReader &xml) {
        m_cell = {
            m_column, {}, {}, std::clamp(attribute(xml, "number-columns-repeated").toInt(), 1, 1'000'000)};
        const QString type = attribute(xml, "value-type");
        if (type == QLatin1StringView("float") || type == QLatin1StringView("percentage") ||
            type == QLatin1StringView("currency"))
            m_cell.number = finiteNumber(attribute(xml, "value"));
        m_inCell = true;
        m_paragraphs = 0;
    }

    void end(QStringView name) {
        if (name == QLatin1StringView("annotation")) {
            --m_annotation;
        } else if (isWanted() && m_inCell && isCell(name)) {
            m_inCell = false;
            m_column = std::min(m_column + m_cell.repeats, 10'000'000);
            if (!m_cell.text.isEmpty() || m_cell.number)
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
            m_sheet.beginRow(++m_line);
            for (const OdsCell &each : m_cells) {
                for (int k = 0; k < each.repeats; ++k)
                    m_sheet.add(each.column + k, each.text, each.number);
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
                Sheet sheet;
                read(static_cast<int>(i), sheet);
                take(i, sheet.take(m_choices));
            }
        }
        if (hasTable())
            settle();
        std::ranges::stable_sort(m.sheets, {}, &ImportSheet::isHidden);
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

    void take(std::size_t i, CellTable table) {
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
    }

    const std::vector<SheetName> &m_sheets;
    Choices &m_choices;
    Imported &m;
    std::size_t m_best = none; ///< index of a sheet
    std::size_t m_most = 0;
    std::size_t m_measurements = 0;
    std::size_t m_tables = 0; ///< sheets with rows of numbers
};

} // namespace

bool isWorkbook(QByteArrayView bytes) {
    return bytes.startsWith("PK\x03\x04") || bytes.startsWith("PK\x05\x06");
}

void readWorkbook(const ImportSource &source, Choices &choices, Imported &imported) {
    ZipFile zip(source.bytes);
    std::vector<SheetName> sheets;
    QByteArray content;
    std::vector<QString> strings;
    const bool isXlsx = zip.contains("xl/workbook.xml");
    if (isXlsx) {
        sheets = sheetsOfXlsx(zip);
        strings = sharedStrings(zip);
    } else if (zip.contains("content.xml")) {
        content = zip.member(QStringLiteral("content.xml"));
        Sheet none;
        OdsReader(-2, sheets, none).read(content);
    } else {
        throw Error(Error::Kind::format,
                    {REPORT_TEXT("report", "this archive is no workbook; expected .xlsx or .ods")});
    }
    SheetChooser chooser(sheets, choices, imported);
    chooser.choose([&](int i, Sheet &sheet) {
        std::vector<SheetName> names;
        if (isXlsx)
            readXlsxSheet(zip.member(sheets[static_cast<std::size_t>(i)].member), strings, sheet);
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
            imported.remarks.push_back(
                {RemarkGrade::assumption,
                 {REPORT_TEXT("report",
                              "Decimal mark: numbers that stand there as text can be read in several ways.")},
                 0,
                 0,
                 "decimalMark"});
    }
    readMeasurementTable(choices, imported);
}

} // namespace palmer
