// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/finishpdf.h"
#include "report/blocks/report.h"

#include <QIODevice>
#include <vector>

namespace palmer {

/// Writes the report as a PDF/A-3a and PDF/UA-1: tagged vectors and text, embedded fonts, with title,
/// language, bookmarks and links; its test file, the `results` (of attachedResults) and the `certificate` (of
/// dcc; both may be empty) as associated files. The same report gives the same bytes at any time, place and
/// locale, provided QHashSeed::setDeterministicGlobalSeed() was called before the QApplication. Throws
/// Error(unwritable) if the device does not accept all bytes or the PDF would have more than 4 GB.
void writePdf(Report report, QIODevice &device, const QByteArray &results = {},
              const QByteArray &certificate = {});

/// Attachments of a report; compression starts here.
[[nodiscard]] std::vector<PdfAttachment> attachmentsOf(const QString &testFileName,
                                                       const QByteArray &testFile, const QByteArray &results,
                                                       const QByteArray &certificate = {});

/// The same with compressed attachments: compressed in the background, and once for the reports of both
/// languages.
void writePdf(Report report, QIODevice &device, const std::vector<PdfAttachment> &attachments);

} // namespace palmer
