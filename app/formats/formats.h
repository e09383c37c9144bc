// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/sha256.h"
#include "import/layouts/zipfile.h"
#include "print/pdf/finishpdf.h"
#include "print/proof/pdfpages.h"
#include "proof/pdfparts.h"

namespace palmer {

/// Functions that use libqpdf, poppler and libzip. With their dependencies these are thirty libraries, whose
/// loading took a fifth of the window's start time and half of the command line's. Therefore the programs
/// are not linked with them: formatsmodule.cpp and pagesmodule.cpp are libraries of their own, which
/// loadedformats.cpp loads on the first call. Writing a report needs no poppler. Tests are linked directly.
struct Formats {
    const char *version = nullptr; ///< of the program the library belongs to
    decltype(&palmer::sha256) sha256 = nullptr;
    decltype(&palmer::openZip) openZip = nullptr;
    decltype(&palmer::pdfParts) pdfParts = nullptr;
    decltype(&palmer::finishPdf) finishPdf = nullptr;
    decltype(&palmer::openPages) openPages = nullptr; ///< in pagesmodule.cpp, and nothing else there
};

} // namespace palmer

/// The only symbol resolved in each library.
extern "C" const palmer::Formats *palmerFormats();
