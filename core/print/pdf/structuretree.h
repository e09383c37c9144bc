// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/finishpdf.h"
#include "print/pdf/pdffile.h"
#include "print/pdf/structure.h"

#include <vector>

namespace palmer {

/// A page, as far as the structure needs it.
struct WrittenPage {
    int number = 0;    ///< of its object
    double height = 0; ///< points
};

/// The entries of what is marked on each page, by their identifiers there.
using MarkedContents = std::vector<std::vector<Structure::Index>>;

/// Writes the structure tree and its way back from the contents: `root` is the number of its root object. The
/// contents of page i have the key i, the `annotations` (their numbers, one per link) those that follow.
/// Elements without content are left out, except cells, which keep the columns of their row.
void writeStructure(PdfFile &file, int root, const PdfProperties &properties, MarkedContents contents,
                    const std::vector<WrittenPage> &pages, const std::vector<int> &annotations);

} // namespace palmer
