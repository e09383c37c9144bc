// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace palmer {

/// A document stored as its difference from another one: long columns of readings contained in both refer to
/// the other document. An undo step in a test of 10⁶ readings does not copy them.
class KeptDocument {
public:
    /// Tests of fewer than `least` readings are stored whole.
    KeptDocument(const Document &document, const Document &beside, std::size_t least);

    /// Restores the document, given the one it was stored relative to.
    [[nodiscard]] Document with(const Document &beside) const;

    /// Approximate number of readings kept alive here by large tests.
    [[nodiscard]] std::size_t readings() const { return m_readings; }

private:
    struct Column {
        std::size_t from = 0; ///< column of the other document that holds the rest
        std::vector<std::pair<std::size_t, std::optional<double>>> own;
    };
    struct Part {
        TestPointer test;                           ///< null: the one at index `beside`
        std::size_t beside = 0;                     ///< index in the other document
        std::vector<std::optional<Column>> columns; ///< of `test`; null: stored in it; empty: all are
    };
    Part part(const Document &document, std::size_t index, const Document &beside, std::size_t least);

    Document m_rest; ///< without its tests
    std::vector<Part> m_parts;
    std::size_t m_readings = 0;
};

} // namespace palmer
