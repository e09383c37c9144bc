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
/// are not linked with them: formatsmodule.cpp is a separate library that loadedformats.cpp loads on the
/// first call. Tests are linked directly.
struct Formats {
    const char *version; ///< of the program the library belongs to
    decltype(&palmer::sha256) sha256;
    decltype(&palmer::openZip) openZip;
    decltype(&palmer::pdfParts) pdfParts;
    decltype(&palmer::finishPdf) finishPdf;
    decltype(&palmer::openPages) openPages;
};

} // namespace palmer

/// The only symbol resolved in the library.
extern "C" const palmer::Formats *palmerFormats();
