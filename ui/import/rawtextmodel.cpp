// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/rawtextmodel.h"

#include "ui/theme.h"

#include <QPainter>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int numberWidth = 44;
constexpr int rawLineHeight = 20;
constexpr std::size_t longestShown = 4000; ///< bytes of a line

QString shown(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min(text.size(), longestShown)));
}

Token colourOf(CellRole role) {
    return role == CellRole::positive ? Token::up : Token::downText;
}

/// Length in bytes, including separators between cells.
int longestRow(const CellTable &table) {
    int longest = 0;
    for (const TableRow &row : table.rows()) {
        std::size_t size = 0;
        for (const TableCell &cell : table.cells(row))
            size += cell.size + 3U;
        longest = std::max(longest, static_cast<int>(std::min(size, longestShown)));
    }
    return longest;
}

/// Lines with a problem or a question.
std::set<std::size_t> problemsOf(const Imported &imported) {
    std::set<std::size_t> lines;
    for (const Remark &remark : imported.remarks) {
        if (remark.grade == RemarkGrade::problem && remark.line > 0)
            lines.insert(remark.line);
    }
    for (const Question &question : imported.questions) {
        if (question.grade == QuestionGrade::doubtful && question.line > 0) {
            lines.insert(question.line);
            lines.insert(question.further.begin(), question.further.end());
        }
    }
    return lines;
}

bool isSheet(const Imported &imported) {
    return imported.format == "workbook";
}

const std::string &textOf(const Imported &imported) {
    return imported.text.empty() ? imported.table.text() : imported.text;
}

} // namespace

/// Finds \n and \r separately, as most texts contain only one of them.
TextLines linesOf(const Imported &imported) {
    TextLines lines;
    if (isSheet(imported)) {
        lines.longest = longestRow(imported.table);
        return lines;
    }
    const std::string &text = textOf(imported);
    std::size_t begin = 0;
    std::size_t feed = text.find('\n');
    std::size_t carriage = text.find('\r');
    while (begin < text.size()) {
        if (feed < begin)
            feed = text.find('\n', begin);
        if (carriage < begin)
            carriage = text.find('\r', begin);
        const std::size_t end = std::min({feed, carriage, text.size()});
        lines.begins.push_back(static_cast<std::uint32_t>(begin));
        lines.longest = std::max(lines.longest, static_cast<int>(std::min(end - begin, longestShown)));
        begin = end + (end == carriage && feed == carriage + 1 ? 2 : 1);
    }
    return lines;
}

void RawTextModel::show(const Imported &imported, const TextLines &lines) {
    beginResetModel();
    m_imported = &imported;
    m_lines = &lines;
    m_sheet = isSheet(imported);
    m_problems = problemsOf(imported);
    endResetModel();
}

void RawTextModel::clear() {
    beginResetModel();
    m_imported = nullptr;
    m_lines = nullptr;
    m_sheet = false;
    m_problems.clear();
    endResetModel();
}

/// A line without its line ending.
RawTextModel::Line RawTextModel::line(int row) const {
    const auto at = static_cast<std::size_t>(row);
    const std::string &all = textOf(*m_imported);
    const auto &begins = m_lines->begins;
    const std::size_t begin = begins[at];
    std::size_t end = at + 1 < begins.size() ? begins[at + 1] : all.size();
    if (end > begin && all[end - 1] == '\n')
        --end;
    if (end > begin && all[end - 1] == '\r')
        --end;
    return {begin, end - begin};
}

int RawTextModel::rowCount(const QModelIndex &parent) const {
    if (parent.isValid() || !m_imported)
        return 0;
    return static_cast<int>(m_sheet ? m_imported->table.rows().size() : m_lines->begins.size());
}

QVariant RawTextModel::data(const QModelIndex &index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::ToolTipRole) {
        const auto table = tableAt(index.row());
        return table && !isRead(*table) ? tr("Click to read this table instead") : QVariant();
    }
    if (role != Qt::DisplayRole)
        return {};
    QString text;
    for (const RawPiece &piece : pieces(index.row()))
        text += piece.text;
    return text;
}

std::size_t RawTextModel::lineNumber(int row) const {
    const auto at = static_cast<std::size_t>(row);
    return m_sheet ? m_imported->table.rows()[at].line : at + 1;
}

bool RawTextModel::isProblem(int row) const {
    return m_problems.contains(lineNumber(row));
}

std::optional<std::size_t> RawTextModel::tableAt(int row) const {
    const std::size_t line = lineNumber(row);
    const auto &tables = m_imported->tables;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const auto size = [&](std::size_t table) { return tables[table].lastLine - tables[table].firstLine; };
        if (line >= tables[i].firstLine && line <= tables[i].lastLine && (!found || size(i) < size(*found)))
            found = i; // a table may lie between parts of another
    }
    return found;
}

int RawTextModel::rowOf(std::size_t line) const {
    if (!m_imported || line == 0)
        return -1;
    if (!m_sheet)
        return line <= m_lines->begins.size() ? static_cast<int>(line) - 1 : -1;
    const auto rows = m_imported->table.rows();
    const auto found = std::ranges::lower_bound(rows, line, {}, &TableRow::line);
    return found != rows.end() && found->line == line ? static_cast<int>(found - rows.begin()) : -1;
}

const TableRow *RawTextModel::tableRow(int row) const {
    const auto rows = m_imported->table.rows();
    if (m_sheet)
        return &rows[static_cast<std::size_t>(row)];
    if (!m_imported->text.empty())
        return nullptr;
    const auto line = static_cast<std::size_t>(row) + 1;
    const auto found = std::ranges::lower_bound(rows, line, {}, &TableRow::line);
    return found != rows.end() && found->line == line ? &*found : nullptr;
}

std::vector<RawPiece> RawTextModel::pieces(int row) const {
    std::vector<RawPiece> pieces;
    const TableRow *tableRow = this->tableRow(row);
    const auto roleOf = [&](std::size_t cell) {
        return cell < m_imported->roles.size() ? m_imported->roles[cell] : CellRole::ignored;
    };
    if (m_sheet) {
        std::size_t cell = tableRow->first;
        for (const TableCell &each : m_imported->table.cells(*tableRow)) {
            if (cell != tableRow->first)
                pieces.push_back({QStringLiteral(" │ ")});
            pieces.push_back({shown(m_imported->table.text(each)), roleOf(cell)});
            ++cell;
        }
        return pieces;
    }
    const std::string_view text = textOf(*m_imported);
    const Line line = this->line(row);
    const std::size_t end = line.begin + std::min(line.size, longestShown);
    std::size_t at = line.begin;
    if (tableRow) {
        std::size_t cell = tableRow->first;
        for (const TableCell &each : m_imported->table.cells(*tableRow)) {
            const std::size_t begin = each.begin;
            const std::size_t size = each.size;
            if (begin < at || begin + size > end)
                break;
            if (begin > at)
                pieces.push_back({shown(text.substr(at, begin - at))});
            pieces.push_back({shown(text.substr(begin, size)), roleOf(cell)});
            at = begin + size;
            ++cell;
        }
    }
    if (at < end)
        pieces.push_back({shown(text.substr(at, end - at))});
    return pieces;
}

void RawTextDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                            const QModelIndex &index) const {
    const auto *model = qobject_cast<const RawTextModel *>(index.model());
    painter->save();
    const bool problem = model->isProblem(index.row());
    if (option.state & QStyle::State_Selected)
        painter->fillRect(option.rect, selectedGround(option.palette));
    else if (problem)
        painter->fillRect(option.rect, token(Token::badGround, option.palette));
    QRect number = option.rect;
    number.setWidth(numberWidth);
    const auto drawMark = [&](Token colour) {
        painter->fillRect(QRect(number.left(), number.top(), 3, number.height()),
                          token(colour, option.palette));
    };
    if (const auto table = model->tableAt(index.row()))
        drawMark(model->isRead(*table) ? Token::accent : Token::lineStrong);
    if (problem)
        drawMark(Token::bad);
    painter->setFont(option.font);
    painter->setPen(token(Token::secondaryText, option.palette));
    painter->drawText(number.adjusted(0, 0, -10, 0), Qt::AlignRight | Qt::AlignVCenter,
                      QString::number(model->lineNumber(index.row())));
    const QFontMetrics metrics(option.font);
    QRect rest = option.rect.adjusted(numberWidth, 0, 0, 0);
    const int end = option.widget ? option.widget->width() : option.rect.right();
    for (RawPiece &piece : model->pieces(index.row())) {
        if (rest.left() > end)
            break; // only a few of a thousand cells are visible
        piece.text.replace(u'\t', QStringLiteral(" → "));
        switch (piece.role) {
        case CellRole::positive:
        case CellRole::negative:
            painter->setPen(token(colourOf(piece.role), option.palette));
            break;
        case CellRole::head:
        case CellRole::position:
            painter->setPen(option.palette.color(QPalette::WindowText));
            break;
        case CellRole::ignored:
            painter->setPen(token(Token::secondaryText, option.palette));
            break;
        }
        painter->drawText(rest, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, piece.text);
        rest.setLeft(rest.left() + metrics.horizontalAdvance(piece.text));
    }
    painter->restore();
}

QSize RawTextDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const {
    const auto *model = qobject_cast<const RawTextModel *>(index.model());
    const int letter = QFontMetrics(option.font).horizontalAdvance(u'0');
    return {numberWidth + (model->longestLine() + 2) * letter, rawLineHeight};
}

} // namespace palmer::ui
