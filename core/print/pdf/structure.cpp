// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/structure.h"

#include <algorithm>
#include <string_view>

namespace palmer {

namespace {

bool areAlike(const StructureKind &a, const StructureKind &b) {
    const auto text = [](const char *word) { return std::string_view(word ? word : ""); };
    return a.columns == b.columns && a.rows == b.rows && text(a.type) == text(b.type) &&
           text(a.scope) == text(b.scope);
}

} // namespace

Structure::Index Structure::addElement(Index parent, const StructureKind &kind) {
    // A few dozen, of which the last ones are asked for again.
    const auto known = std::find_if(m_kinds.rbegin(), m_kinds.rend() - 1,
                                    [&](const StructureKind &each) { return areAlike(each, kind); });
    const auto index = static_cast<std::uint16_t>(m_kinds.rend() - 1 - known);
    if (index == content)
        m_kinds.push_back(kind);
    m_entries.push_back({parent, index == content ? static_cast<std::uint16_t>(m_kinds.size() - 1) : index});
    return static_cast<Index>(m_entries.size() - 1);
}

Structure::Index Structure::addFigure(Index parent, const TaggedFigure &figure) {
    const Index index = addElement(parent, {"/Figure"});
    m_figures.emplace(index, figure);
    return index;
}

Structure::Index Structure::addContent(Index parent) {
    m_entries.push_back({parent, content});
    return static_cast<Index>(m_entries.size() - 1);
}

} // namespace palmer
