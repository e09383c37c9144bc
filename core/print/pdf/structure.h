// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace palmer {

/// The kind of an element: many are alike.
struct StructureKind {
    const char *type = "/Document"; ///< "/P", "/H1", "/Table"
    int columns = 1;                ///< that a cell spans
    int rows = 1;                   ///< likewise
    const char *scope = nullptr;    ///< of a heading cell: "/Column", "/Row"
};

/// The particulars of a figure.
struct TaggedFigure {
    QString alternative; ///< what it shows, in words
    QRectF area;         ///< points from the top left corner of its page
};

/// The structure of a PDF (ISO 32000-1, 14.7): what the parts of its pages are to readers who do not see
/// them. An entry is an element or a content marked on a page; they stand in the order in which they were
/// drawn, which is that of the kids of each element. Entry 0 is the document; parents precede their children.
/// An entry takes eight bytes: a report of 1 000 tests has a million of them.
class Structure {
public:
    using Index = std::uint32_t;

    /// Each returns the index of the new entry.
    Index addElement(Index parent, const StructureKind &kind);
    Index addFigure(Index parent, const TaggedFigure &figure);
    Index addContent(Index parent);

    [[nodiscard]] std::size_t size() const { return m_entries.size(); }
    [[nodiscard]] Index parent(Index entry) const { return m_entries[entry].parent; }
    [[nodiscard]] bool isContent(Index entry) const { return m_entries[entry].kind == content; }
    /// The kind of an element.
    [[nodiscard]] const StructureKind &kind(Index entry) const { return m_kinds[m_entries[entry].kind]; }
    /// Null for what is no figure.
    [[nodiscard]] const TaggedFigure *figure(Index entry) const {
        const auto found = m_figures.find(entry);
        return found == m_figures.end() ? nullptr : &found->second;
    }

private:
    static constexpr std::uint16_t content = 0;

    struct Entry {
        Index parent = 0;
        std::uint16_t kind = 1; ///< of `m_kinds`, or a content
    };
    std::vector<Entry> m_entries = std::vector<Entry>(1);
    std::vector<StructureKind> m_kinds = std::vector<StructureKind>(2); ///< of contents, of the document, …
    std::map<Index, TaggedFigure> m_figures;
};

} // namespace palmer
