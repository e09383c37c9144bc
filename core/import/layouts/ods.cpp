// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/worksheet.h"
#include "tables/cellunits.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <set>
#include <string>

namespace palmer {

namespace {

constexpr std::size_t mostRepeated = 1'000'000; ///< repeated cells, which are stored once

/// Reads one sheet of content.xml by its index from 0; collects the names of all.
class OdsReader : public XmlHandler {
public:
    OdsReader(int wanted, std::vector<SheetName> &names, Sheet &sheet)
        : m_wanted(wanted)
        , m_names(names)
        , m_sheet(sheet) {}

    void begin(const XmlElement &xml) override {
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
                std::clamp(wholeNumberIn(xml.attribute("number-columns-repeated")), 1, mostSheetColumns);
            if (isCollapsed(xml))
                m_sheet.hideColumns(m_columns, count);
            m_columns = std::min(m_columns + count, mostSheetColumns);
        } else if (isWanted() && name == "table-row") {
            m_rowRepeats = std::clamp(wholeNumberIn<std::size_t>(xml.attribute("number-rows-repeated")),
                                      std::size_t(1), std::size_t(100'000'000));
            m_rowHidden = isCollapsed(xml);
            m_cells.clear();
            m_column = 0;
        } else if (isWanted() && isCell(name)) {
            beginCell(xml);
        } else if (name == "annotation") {
            ++m_annotation;
            m_comment.clear();
        } else if (m_inCell && m_annotation == 0 && name == "p") {
            if (m_paragraphs++ > 0)
                m_cell.text += ' ';
        } else if (m_inCell && (name == "s" || name == "tab" || name == "line-break")) {
            text(" ");
        }
    }

    void end(std::string_view name) override {
        if (name == "annotation") {
            --m_annotation;
            if (isWanted() && !m_comment.empty())
                m_sheet.comments.add(m_line + 1, std::exchange(m_comment, {}));
        } else if (isWanted() && m_inCell && isCell(name)) {
            m_inCell = false;
            m_column = std::min(m_column + m_cell.repeats, 10'000'000);
            if (!m_cell.time.empty())
                m_cell.text = m_cell.time;
            else if (m_cell.number)
                takeShown();
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

    void text(std::string_view text) override {
        if (m_inCell && m_annotation == 0 && m_paragraphs > 0 && m_cell.text.size() < longestSheetCell)
            m_cell.text += text;
        else if (m_annotation > 0 && m_comment.size() < longestSheetCell)
            m_comment += text;
    }

private:
    struct OdsCell {
        int column = 0;
        std::string text;
        std::optional<double> number;
        int repeats = 1;
        std::string time = {}; ///< in ISO format, whatever the cell displays
        bool isEmptyFormula = false;
        const Unit *unit = nullptr; ///< displayed with the number
    };

    [[nodiscard]] bool isWanted() const { return m_index == m_wanted; }
    [[nodiscard]] static bool isCollapsed(const XmlElement &xml) {
        const std::string_view visibility = xml.attribute("visibility");
        return visibility == "collapse" || visibility == "filter";
    }
    [[nodiscard]] static bool isCell(std::string_view name) {
        return name == "table-cell" || name == "covered-table-cell";
    }

    void beginCell(const XmlElement &xml) {
        m_cell = {m_column,
                  {},
                  {},
                  std::clamp(wholeNumberIn(xml.attribute("number-columns-repeated")), 1, 1'000'000)};
        const std::string_view type = xml.attribute("value-type");
        if (type == "float" || type == "percentage" || type == "currency")
            m_cell.number = finiteNumber(xml.attribute("value"));
        if (type == "date")
            m_cell.time = xml.attribute("date-value");
        m_cell.isEmptyFormula = type.empty() && !xml.attribute("formula").empty();
        m_inCell = true;
        m_paragraphs = 0;
    }

    /// The displayed text counts where it is an error, and for its unit.
    void takeShown() {
        const std::string_view shown = withoutBlanks(m_cell.text);
        const bool isError =
            (shown.size() > 1 && shown[0] == '#' && shown[1] != '#') || shown.starts_with("Err:");
        if (isError) {
            m_cell.number.reset();
            return;
        }
        auto said = cellWithUnit(shown, DecimalMark::point);
        if (!said)
            said = cellWithUnit(shown, DecimalMark::comma);
        m_cell.unit = said && said->size > 0 ? said->unit : nullptr;
    }

    void addRows() {
        // Repeated cells are counted before they are expanded.
        std::size_t repeated = 0;
        for (const OdsCell &each : m_cells)
            repeated += static_cast<std::size_t>(each.repeats);
        if (repeated > mostRepeated / m_rowRepeats)
            refuseTableSize(placeOfLine(m_line + 1));
        for (std::size_t i = 0; i < m_rowRepeats; ++i) {
            m_sheet.beginRow(++m_line, m_rowHidden);
            for (const OdsCell &each : m_cells) {
                for (int k = 0; k < each.repeats; ++k) {
                    if (each.isEmptyFormula)
                        m_sheet.addEmptyFormula();
                    m_sheet.add(each.column + k, each.text, each.number, each.unit);
                }
            }
        }
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
    std::string m_comment; ///< of a cell
};

} // namespace

std::optional<Workbook> odsOf(ZipFile &zip) {
    const QString content = QStringLiteral("content.xml");
    if (!zip.contains(content))
        return {};
    const auto read = [&zip, content](int index, std::vector<SheetName> &names, Sheet &sheet) {
        OdsReader reader(index, names, sheet);
        zip.walk(content, reader);
    };
    Workbook book;
    Sheet none{Choices({})};
    read(-2, book.sheets, none);
    book.read = [read](std::size_t index, Sheet &sheet) {
        std::vector<SheetName> names;
        read(static_cast<int>(index), names, sheet);
    };
    return book;
}

} // namespace palmer
