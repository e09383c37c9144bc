#include "import/readers.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "import/zipfile.h"

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
    CellTable take() { return m_builder.take(); }

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
    QString member; ///< of the archive (xlsx)
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
            QString target = targets.value(
                xml.attributes()
                    .value(
                        QStringLiteral("http://schemas.openxmlformats.org/officeDocument/2006/relationships"),
                        QStringLiteral("id"))
                    .toString());
            if (target.startsWith(u'/'))
                target.remove(0, 1);
            else
                target.prepend(QLatin1StringView("xl/"));
            sheets.push_back({attribute(xml, "name"), target});
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

/// Reads the sheet of that number (from 0); collects the names of all.
void readOdsSheet(const QByteArray &bytes, int wanted, std::vector<SheetName> &names, Sheet &sheet) {
    int index = -1;
    std::size_t line = 0;
    std::size_t rowRepeats = 1;
    struct OdsCell {
        int column = 0;
        QString text;
        std::optional<double> number;
        int repeats = 1;
    };
    std::vector<OdsCell> cells;
    OdsCell cell;
    int column = 0;
    bool inCell = false;
    int paragraphs = 0;
    int annotation = 0;
    walk(
        bytes,
        [&](const QXmlStreamReader &xml) {
            const QStringView name = xml.name();
            if (name == QLatin1StringView("table")) {
                ++index;
                names.push_back({attribute(xml, "name"), {}});
                line = 0;
            } else if (index == wanted && name == QLatin1StringView("table-row")) {
                rowRepeats = std::clamp<std::size_t>(attribute(xml, "number-rows-repeated").toULongLong(), 1,
                                                     100'000'000);
                cells.clear();
                column = 0;
            } else if (index == wanted && (name == QLatin1StringView("table-cell") ||
                                           name == QLatin1StringView("covered-table-cell"))) {
                cell = {column,
                        {},
                        {},
                        std::clamp(attribute(xml, "number-columns-repeated").toInt(), 1, 1'000'000)};
                const QString type = attribute(xml, "value-type");
                if (type == QLatin1StringView("float") || type == QLatin1StringView("percentage") ||
                    type == QLatin1StringView("currency"))
                    cell.number = finiteNumber(attribute(xml, "value"));
                inCell = true;
                paragraphs = 0;
            } else if (name == QLatin1StringView("annotation")) {
                ++annotation;
            } else if (inCell && annotation == 0 && name == QLatin1StringView("p")) {
                if (paragraphs++ > 0)
                    cell.text += u' ';
            }
        },
        [&](const QXmlStreamReader &xml) {
            const QStringView name = xml.name();
            if (name == QLatin1StringView("annotation")) {
                --annotation;
            } else if (index == wanted && inCell &&
                       (name == QLatin1StringView("table-cell") ||
                        name == QLatin1StringView("covered-table-cell"))) {
                inCell = false;
                column = std::min(column + cell.repeats, 10'000'000);
                if (!cell.text.isEmpty() || cell.number)
                    cells.push_back(cell);
            } else if (index == wanted && name == QLatin1StringView("table-row")) {
                if (cells.empty()) {
                    line += rowRepeats;
                    return;
                }
                // What is repeated is counted before it is written out.
                std::size_t repeated = 0;
                for (const OdsCell &each : cells)
                    repeated += static_cast<std::size_t>(each.repeats);
                if (repeated > mostRepeated / rowRepeats)
                    throw Error(
                        Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more rows or cells than a table of readings can have")},
                        std::to_string(line + 1) + ":1");
                for (std::size_t i = 0; i < rowRepeats; ++i) {
                    sheet.beginRow(++line);
                    for (const OdsCell &each : cells) {
                        for (int k = 0; k < each.repeats; ++k)
                            sheet.add(each.column + k, each.text, each.number);
                    }
                }
            }
        },
        [&](QStringView text) {
            if (inCell && annotation == 0 && paragraphs > 0 && cell.text.size() < longestCell)
                cell.text += text;
        });
}

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

constexpr int mostSheetsTried = 20;

/// The sheet chosen, else the first with numbers. `read` fills a Sheet from the sheet of a number.
template <class Read>
int firstWithNumbers(const std::vector<SheetName> &sheets, const Choices &choices, Read read,
                     CellTable &table) {
    int chosen = chosenSheet(sheets, choices);
    const int first = std::max(chosen, 0);
    const int last =
        chosen >= 0 ? chosen : std::min<int>(static_cast<int>(sheets.size()), mostSheetsTried) - 1;
    for (int i = first; i <= last; ++i) {
        Sheet sheet;
        read(i, sheet);
        if (sheet.hasNumbers || i == last) {
            table = sheet.take();
            return i;
        }
    }
    return -1;
}

} // namespace

bool isWorkbook(QByteArrayView bytes) {
    return bytes.startsWith("PK\x03\x04") || bytes.startsWith("PK\x05\x06");
}

void readWorkbook(const ImportSource &source, Choices &choices, Imported &imported) {
    ZipFile zip(source.bytes);
    std::vector<SheetName> sheets;
    int read = -1;
    if (zip.contains("xl/workbook.xml")) {
        sheets = sheetsOfXlsx(zip);
        const std::vector<QString> strings = sharedStrings(zip);
        read = firstWithNumbers(
            sheets, choices,
            [&](int i, Sheet &sheet) {
                readXlsxSheet(zip.member(sheets[static_cast<std::size_t>(i)].member), strings, sheet);
            },
            imported.table);
    } else if (zip.contains("content.xml")) {
        const QByteArray content = zip.member(QStringLiteral("content.xml"));
        Sheet none;
        readOdsSheet(content, -2, sheets, none);
        read = firstWithNumbers(
            sheets, choices,
            [&](int i, Sheet &sheet) {
                std::vector<SheetName> names;
                readOdsSheet(content, i, names, sheet);
            },
            imported.table);
    } else {
        throw Error(Error::Kind::format,
                    {REPORT_TEXT("report", "this archive is no workbook; expected .xlsx or .ods")});
    }
    if (read < 0)
        throw Error(
            Error::Kind::content,
            {REPORT_TEXT("report", "there is no table of numbers in it; expected target positions and "
                                   "readings, points of a circle, or values over time")});
    choices.settle("sheet", sheets[static_cast<std::size_t>(read)].name.toStdString(), Origin::recognised);
    if (sheets.size() > 1)
        imported.remarks.push_back({RemarkGrade::note,
                                    {REPORT_TEXT("report", "The workbook has %1 sheets; “%2” is read."),
                                     {Number{static_cast<double>(sheets.size()), Quantity::count},
                                      excerpt(sheets[static_cast<std::size_t>(read)].name.toStdString())}},
                                    0,
                                    0,
                                    "sheet"});
    readMeasurementTable(choices, imported);
}

} // namespace palmer
