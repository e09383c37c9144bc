// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/worksheet.h"
#include "tables/cellunits.h"

#include <QDate>
#include <QDir>
#include <QMap>
#include <QRegularExpression>
#include <QTime>
#include <algorithm>
#include <cmath>
#include <memory>

namespace palmer {

namespace {

constexpr auto noEnd = [](std::string_view) {};
constexpr auto noText = [](std::string_view) {};

/// Visits the elements of a part, if it exists.
template <class Begin, class End = decltype(noEnd), class Text = decltype(noText)>
void walk(ZipFile &zip, const QString &part, Begin begin, End end = noEnd, Text text = noText) {
    struct Handler : XmlHandler {
        Handler(Begin &begin, End &end, Text &text)
            : m_begin(begin)
            , m_end(end)
            , m_text(text) {}
        void begin(const XmlElement &element) override { m_begin(element); }
        void end(std::string_view name) override { m_end(name); }
        void text(std::string_view text) override { m_text(text); }

        Begin &m_begin;
        End &m_end;
        Text &m_text;
    };
    Handler handler(begin, end, text);
    zip.walk(part, handler);
}

bool isTrue(std::string_view value) {
    return value == "1" || value == "true";
}

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
    walk(zip, folder + QLatin1StringView("_rels/") + part.sliced(slash) + QLatin1StringView(".rels"),
         [&](const XmlElement &xml) {
             if (xml.name != "Relationship")
                 return;
             const QString target = inQt(xml.attribute("Target"));
             const QString name =
                 QDir::cleanPath(target.startsWith(u'/') ? target.sliced(1) : folder + target);
             targets[inQt(xml.attribute("Id"))] = name;
             targets[inQt(xml.attribute("Type")).section(u'/', -1)] = name;
         });
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
    walk(zip, part, [&](const XmlElement &xml) {
        if (xml.name == "workbookPr" && isTrue(xml.attribute("date1904")))
            book.firstDay = daysTo1904;
        if (xml.name != "sheet" || book.sheets.size() > 10'000)
            return;
        // By local name, as the namespace differs in the strict format.
        const std::string_view state = xml.attribute("state");
        book.sheets.push_back({inQt(xml.attribute("name")), relationships.value(inQt(xml.attribute("id"))),
                               state == "hidden" || state == "veryHidden"});
    });
    return book;
}

/// How a cell's number is displayed, where relevant.
enum class Shown { number, time, date };

struct CellStyle {
    Shown shown = Shown::number;
    const Unit *unit = nullptr; ///< displayed with the number; may be null
};

/// The unit behind the digits of a number format: "0.000\" in\"", "0.0\\ °", "0.0µm".
const Unit *unitShownBy(const QString &code) {
    // Up to the first semicolon is the format of positive numbers.
    static const QRegularExpression positive(QStringLiteral(R"(^(?:"[^"]*"|\\.|[^;"\\])*)"));
    static const QRegularExpression ignored(QStringLiteral(R"(\[[^\]]*\]|_.|\*.)"));
    static const QRegularExpression behind(
        QStringLiteral(R"((?:[0#?]|General)((?:"[^"]*"|\\.|[^"\\0#?.,])*)$)"));
    constexpr qsizetype longestCode = 255;
    const QString format = positive.match(code.left(longestCode)).captured().remove(ignored);
    QString text;
    bool isQuoted = false;
    const QString literal = behind.match(format).captured(1);
    for (qsizetype i = 0; i < literal.size(); ++i) {
        if (literal[i] == u'"')
            isQuoted = !isQuoted;
        else if (literal[i] == u'\\' && !isQuoted && i + 1 < literal.size())
            text += literal[++i];
        else
            text += literal[i];
    }
    const auto said = cellWithUnit('1' + text.toStdString(), DecimalMark::point);
    return said && said->size > 0 ? said->unit : nullptr;
}

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
std::vector<CellStyle> stylesOf(ZipFile &zip, const QString &part) {
    constexpr std::size_t mostStyles = 100'000;
    std::vector<CellStyle> styles;
    QMap<int, CellStyle> own;
    bool ofCells = false;
    walk(
        zip, part,
        [&](const XmlElement &xml) {
            ofCells |= xml.name == "cellXfs";
            const int number = wholeNumberIn(xml.attribute("numFmtId"));
            if (xml.name == "numFmt") {
                const QString code = inQt(xml.attribute("formatCode"));
                own[number] = {shownBy(code), unitShownBy(code)};
            } else if (ofCells && xml.name == "xf" && styles.size() < mostStyles) {
                styles.push_back(own.value(number, {shownBy(number), nullptr}));
            }
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
            if (inText && !strings.empty() && strings.back().size() < longestSheetCell)
                strings.back() += text;
        });
    return strings;
}

/// Data shared by the cells of all sheets.
struct XlsxCells {
    std::vector<std::string> strings;
    std::vector<CellStyle> styles;
    double firstDay = 0;

    [[nodiscard]] CellStyle shown(std::size_t style) const {
        return style < styles.size() ? styles[style] : CellStyle();
    }
};

void hideColumns(const XmlElement &column, Sheet &sheet) {
    const int first = wholeNumberIn(column.attribute("min"));
    const int last = wholeNumberIn(column.attribute("max"));
    if (isTrue(column.attribute("hidden")) && first >= 1 && last >= first && last <= mostSheetColumns)
        sheet.hideColumns(first - 1, last - first + 1);
}

void addNumber(std::string_view value, const CellStyle &style, double firstDay, int column, Sheet &sheet) {
    const Shown shown = style.shown;
    const auto number = finiteNumber(value);
    const std::string time = number && shown != Shown::number
                                 ? timeText(*number + (shown == Shown::date ? firstDay : 0), shown)
                                 : std::string();
    if (time.empty())
        sheet.add(column, value, number, style.unit);
    else
        sheet.add(column, time, {});
}

/// Reads one sheet of an .xlsx.
class XlsxReader : public XmlHandler {
public:
    XlsxReader(const XlsxCells &cells, Sheet &sheet)
        : m_cells(cells)
        , m_sheet(sheet) {}

    void end(std::string_view name) override {
        m_inValue = false;
        if (name == "c" && m_line > 0)
            addCell();
    }
    void text(std::string_view text) override {
        if (m_inValue && m_value.size() < longestSheetCell)
            m_value += text;
    }
    void begin(const XmlElement &xml) override {
        constexpr std::size_t mostLines = 100'000'000;
        const char letter = xml.name.size() == 1 ? xml.name.front() : '\0'; // of most elements
        if (letter == 'c') {
            beginCell(xml);
        } else if (letter == '\0' && xml.name == "row") {
            const auto stated = wholeNumberIn<std::size_t>(xml.attribute("r"));
            m_line = stated > m_line && stated < mostLines ? stated : m_line + 1;
            m_sheet.beginRow(m_line, isTrue(xml.attribute("hidden")));
            m_next = 0;
        } else if (letter == '\0' && xml.name == "col") {
            hideColumns(xml, m_sheet);
        }
        m_isFormula |= letter == 'f';
        m_inValue = letter == 'v' || letter == 't';
    }

private:
    /// Looks at each attribute once: of most workbooks this is the most frequent element.
    void beginCell(const XmlElement &xml) {
        m_type.clear();
        m_column = -1;
        m_value.clear();
        m_isFormula = false;
        m_shown = m_cells.shown(0);
        for (const XmlElement::Attribute &each : xml.attributes) {
            const std::string_view name = XmlElement::nameOf(each);
            const char letter = name.size() == 1 ? name.front() : '\0';
            if (letter == 'r')
                m_column = columnOfReference(XmlElement::valueOf(each));
            else if (letter == 't')
                m_type = XmlElement::valueOf(each);
            else if (letter == 's')
                m_shown = m_cells.shown(wholeNumberIn<std::size_t>(XmlElement::valueOf(each)));
        }
    }

    void addCell() {
        const int column = m_column < 0 ? m_next : m_column;
        m_next = column + 1;
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
        } else if (m_type == "b") {
            m_sheet.add(column, m_value == "1" ? "TRUE" : "FALSE", {});
        } else {
            m_sheet.add(column, m_value, {}); // strings, errors such as #N/A
        }
    }

    const XlsxCells &m_cells;
    Sheet &m_sheet;
    std::size_t m_line = 0;
    std::string m_type;
    int m_column = -1; ///< below 0: not stated
    int m_next = 0;    ///< of a cell that does not state its column; empty cells count
    std::string m_value;
    bool m_inValue = false;
    bool m_isFormula = false;
    CellStyle m_shown;
};

} // namespace

std::optional<Workbook> xlsxOf(ZipFile &zip) {
    const QString part = workbookPart(zip);
    if (part.isEmpty())
        return {};
    const QMap<QString, QString> relationships = relationshipsOf(zip, part);
    const XlsxBook book = bookOf(zip, part, relationships);
    const QString folder = part.first(part.lastIndexOf(u'/') + 1);
    const auto beside = [&](const QString &word) {
        return relationships.value(word, folder + word + QLatin1StringView(".xml"));
    };
    const auto cells = std::make_shared<const XlsxCells>(
        XlsxCells{sharedStrings(zip, beside(QStringLiteral("sharedStrings"))),
                  stylesOf(zip, beside(QStringLiteral("styles"))), book.firstDay});
    return Workbook{book.sheets, [&zip, cells, sheets = book.sheets](std::size_t index, Sheet &sheet) {
                        XlsxReader reader(*cells, sheet);
                        sheet.expect(zip.statedSize(sheets[index].member));
                        zip.walk(sheets[index].member, reader);
                    }};
}

} // namespace palmer
