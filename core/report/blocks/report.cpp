// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/blocks/report.h"

namespace palmer {

QString Phrase::plain() const {
    QString result;
    for (const Span &span : spans)
        result += span.text;
    return result;
}

Phrase &Phrase::operator+=(const Phrase &other) {
    spans.insert(spans.end(), other.spans.begin(), other.spans.end());
    return *this;
}

Mark markOf(Verdict verdict) {
    return inOrder(verdict, {Mark::check, Mark::openCircle, Mark::cross});
}

Mark markOf(Grade grade) {
    return grade == Grade::requirement ? Mark::cross : Mark::openCircle;
}

bool Cell::isMissing() const {
    return !blank && mark == Mark::none && !extras->guard && !extras->whisker && !extras->bar &&
           text.plain().isEmpty() && extras->notes.empty();
}

Cell blankCell() {
    Cell cell;
    cell.blank = true;
    return cell;
}

Cell boldCell(Phrase text) {
    Cell cell(std::move(text));
    cell.bold = true;
    return cell;
}

Column columnOf(Phrase title, double width, Alignment alignment, QString unit) {
    return {std::move(title), std::move(unit), alignment, false, width};
}

Column flexibleColumn(Phrase title, double width) {
    return {std::move(title), {}, Alignment::left, true, width};
}

void eraseColumn(Table &table, std::size_t column) {
    const auto at = static_cast<std::ptrdiff_t>(column);
    table.columns.erase(table.columns.begin() + at);
    for (std::vector<Cell> &row : table.rows) {
        for (std::size_t i = 0; i < column; ++i) {
            if (i + row[i].extras->columns > column)
                --row[i].extras.edit().columns;
        }
        row.erase(row.begin() + at);
    }
}

QString anchorOf(const Block &block) {
    if (const auto *head = std::get_if<TestHead>(&block))
        return head->anchor;
    const auto *heading = std::get_if<Heading>(&block);
    return heading ? heading->anchor : QString();
}

namespace {

void putPagesOf(Table &table, const std::map<QString, int> &pages) {
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        if (!table.columns[column].pages)
            continue;
        for (std::size_t row = 0; row < table.rows.size() && row < table.links.size(); ++row) {
            Cell &cell = table.rows[row][column];
            if (const auto found = pages.find(table.links[row]); !cell.blank && found != pages.end())
                cell.text = QString::number(found->second);
        }
    }
}

} // namespace

bool namesPages(const Block &block) {
    const auto *table = std::get_if<Table>(&block);
    return std::holds_alternative<VerdictLine>(block) || std::holds_alternative<EndMark>(block) ||
           (table && !table->links.empty());
}

bool putPages(Block &block, const std::map<QString, int> &pages) {
    const auto pageOf = [&](const QString &anchor) {
        const auto found = pages.find(anchor);
        return found == pages.end() ? QStringLiteral("–") : QString::number(found->second);
    };
    if (auto *table = std::get_if<Table>(&block))
        putPagesOf(*table, pages);
    if (auto *mark = std::get_if<EndMark>(&block))
        mark->text.replace(QLatin1String("%1"), pageOf(mark->anchor));
    auto *line = std::get_if<VerdictLine>(&block);
    if (line && !line->anchor.isEmpty()) {
        for (Span &span : line->accordance.text.spans)
            span.text.replace(QLatin1String("%1"), pageOf(line->anchor));
    }
    return namesPages(block);
}

} // namespace palmer
