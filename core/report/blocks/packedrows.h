// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palmer {

struct Cell;

/// Rows of plain cells (text, bold or blank), all with as many of them, for tables of a hundred thousand
/// rows: a cell takes the bytes of its text and four, twenty times less than as a `Cell`.
class PackedRows {
public:
    /// Adds a row; what is not plain of its cells is lost.
    void append(const std::vector<Cell> &row);

    [[nodiscard]] std::size_t count() const { return m_columns == 0 ? 0 : m_cells.size() / m_columns; }
    [[nodiscard]] std::vector<Cell> row(std::size_t index) const;
    /// Gives up memory kept for further rows.
    void squeeze();

    bool operator==(const PackedRows &) const = default;

private:
    /// End of the text of a cell in the text of all.
    struct PackedCell {
        std::uint32_t end : 30;
        std::uint32_t bold : 1;
        std::uint32_t blank : 1;

        bool operator==(const PackedCell &) const = default;
    };

    std::size_t m_columns = 0;
    std::vector<PackedCell> m_cells; ///< row by row
    QString m_text;
};

} // namespace palmer
