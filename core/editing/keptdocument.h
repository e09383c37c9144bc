// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace palmer {

/// A document kept by what tells it from another one: of the long columns of readings that both have it says
/// where they stand in the other. A step of undo in a test of 10⁶ readings is no copy of them.
class KeptDocument {
public:
    /// Tests of fewer than `least` readings are kept as they are.
    KeptDocument(const Document &document, const Document &beside, std::size_t least);

    /// The document again, of the one that it was kept beside.
    [[nodiscard]] Document with(const Document &beside) const;

    /// About, of large tests: what is kept alive here.
    [[nodiscard]] std::size_t readings() const { return m_readings; }

private:
    struct Column {
        std::size_t from = 0; ///< the column beside it that holds the rest
        std::vector<std::pair<std::size_t, std::optional<double>>> own;
    };
    struct Part {
        TestPointer test;                           ///< null: the one at `beside`
        std::size_t beside = 0;                     ///< its place in the other document
        std::vector<std::optional<Column>> columns; ///< of `test`; null: it stands there; empty: all do
    };
    Part part(const Document &document, std::size_t index, const Document &beside, std::size_t least);

    Document m_rest; ///< without its tests
    std::vector<Part> m_parts;
    std::size_t m_readings = 0;
};

} // namespace palmer
