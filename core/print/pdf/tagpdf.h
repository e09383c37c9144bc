// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/structure.h"

#include <map>
#include <qpdf/QPDFObjGen.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <string>
#include <vector>

namespace palmer {

/// Makes tagged pages of what Qt wrote: takes the marks of tags.h out of their contents and marks what they
/// told instead. Text that a letter and an accent make is said to be one character.
class PageTagger {
public:
    /// `structure` has to outlive it.
    explicit PageTagger(const Structure &structure)
        : m_structure(structure) {}

    /// Returns the content of a page, and adds the entries of what is marked on it, by their identifiers. The
    /// fonts of the page get the name of their subset, and text that maps to no character or to a tabulator
    /// is mapped to what it is.
    [[nodiscard]] std::string taggedContent(QPDFObjectHandle page, std::vector<Structure::Index> &contents);

    /// UTF-16 of each glyph of a font, in hexadecimal.
    using Characters = std::vector<std::string>;

private:
    const Structure &m_structure;
    std::map<QPDFObjGen, Characters> m_characters; ///< of the fonts that were corrected, each once
};

} // namespace palmer
