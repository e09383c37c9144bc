// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/formats.h"

const palmer::Formats *palmerFormats() {
    static constexpr palmer::Formats formats{PALMER_VERSION, &palmer::sha256, &palmer::openZip,
                                             &palmer::pdfParts, &palmer::finishPdf};
    return &formats;
}
