// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/finishpdf.h"
#include "report/blocks/report.h"

#include <QIODevice>
#include <vector>

namespace palmer {

/// Writes the report as a PDF/A-3b: vectors and text, fonts embedded, with title, language, bookmarks and
/// links; its test file and the `results` (of attachedResults; empty: none) as associated files. The same
/// report gives the same bytes at any time, place and locale, provided
/// QHashSeed::setDeterministicGlobalSeed() was called before the QApplication. Throws Error(unwritable) when
/// the device does not take all.
void writePdf(const Report &report, QIODevice &device, const QByteArray &results = {});

/// What a report carries; it is packed from then on.
[[nodiscard]] std::vector<PdfAttachment> attachmentsOf(const QString &testFileName,
                                                       const QByteArray &testFile, const QByteArray &results);

/// The same with files that are packed already: beside other work, and once for the reports of both
/// languages.
void writePdf(const Report &report, QIODevice &device, const std::vector<PdfAttachment> &attachments);

} // namespace palmer
