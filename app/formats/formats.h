// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/sha256.h"
#include "import/layouts/zipfile.h"
#include "print/pdf/finishpdf.h"
#include "print/proof/pdfpages.h"
#include "proof/pdfparts.h"

namespace palmer {

/// What libqpdf, poppler and libzip do for the program. With what they need themselves they are thirty
/// libraries, and to load them took a fifth of the start of the window. So the window is not linked with
/// them: formatsmodule.cpp is, a library of its own, which loadedformats.cpp loads when the first of these
/// functions is called. Command line and tests are linked with the functions themselves.
struct Formats {
    const char *version; ///< of the program that the library belongs to
    decltype(&palmer::sha256) sha256;
    decltype(&palmer::openZip) openZip;
    decltype(&palmer::pdfParts) pdfParts;
    decltype(&palmer::finishPdf) finishPdf;
    decltype(&palmer::openPages) openPages;
};

} // namespace palmer

/// The one name that the library is asked for.
extern "C" const palmer::Formats *palmerFormats();
