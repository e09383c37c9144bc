// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/blocks/packedrows.h"

#include "report/blocks/report.h"

#include <stdexcept>
#include <utility>

namespace palmer {

void PackedRows::append(const std::vector<Cell> &row) {
    constexpr qsizetype most = (qsizetype(1) << 30U) - 1;
    m_columns = row.size();
    for (const Cell &cell : row) {
        m_text += cell.text.plain();
        if (m_text.size() > most)
            throw std::length_error("a table with too much text");
        m_cells.push_back({static_cast<std::uint32_t>(m_text.size()) & static_cast<std::uint32_t>(most),
                           cell.bold, cell.blank});
    }
}

std::vector<Cell> PackedRows::row(std::size_t index) const {
    std::vector<Cell> result;
    result.reserve(m_columns);
    for (std::size_t i = index * m_columns; i < (index + 1) * m_columns; ++i) {
        const qsizetype begin = i == 0 ? 0 : m_cells[i - 1].end;
        if (m_cells[i].blank != 0)
            result.push_back(blankCell());
        else
            result.emplace_back(m_text.mid(begin, m_cells[i].end - begin)).bold = m_cells[i].bold != 0;
    }
    return result;
}

void PackedRows::squeeze() {
    m_text.squeeze();
    m_cells.shrink_to_fit();
}

void packRows(Table &table) {
    PackedRows packed = table.packed;
    for (const std::vector<Cell> &row : table.rows) {
        packed.append(row);
        if (packed.row(packed.count() - 1) != row)
            return;
    }
    packed.squeeze();
    table.packed = std::move(packed);
    table.rows = {};
}

} // namespace palmer
