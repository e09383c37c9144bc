// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/finishpdf.h"

#include <qpdf/QPDF.hh>
#include <vector>

namespace palmer {

/// Makes a tagged PDF of what Qt wrote: takes the marks of tags.h out of the pages and marks their content
/// instead, adds the structure tree, and gives `annotations` (one per link) their elements. Text that a
/// letter and an accent make is said to be one character. Fonts get the name of their subset, and text that
/// maps to no character or to a tabulator is mapped to what it is.
void tagPdf(QPDF &document, const PdfProperties &properties,
            const std::vector<QPDFObjectHandle> &annotations);

} // namespace palmer
