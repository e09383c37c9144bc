// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "import/imported.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// What the bytes of a measurement file say: tables in all layouts, workbooks, files of instruments. The
/// format is known by the content; the name serves the title of errors and formats that cannot be read.
/// `options`: what the user has chosen; everything else is recognised or guessed, each guess with a remark.
/// Throws Error with the place and what to do: unknown words, nothing that can be read, undocumented formats;
/// a test file or a report, whole or damaged, by its content or its name. `usual` holds where neither the
/// user nor the file says it.
[[nodiscard]] Imported importMeasurement(QByteArrayView bytes, const QString &fileName,
                                         const ImportOptions &options = {}, const ImportOptions &usual = {});

/// The same for an assistant: what can be shown of a file that cannot be read (the table, its columns, the
/// choices), with the `refusal` said in it. Throws Error where there is nothing to show.
[[nodiscard]] Imported showMeasurement(QByteArrayView bytes, const QString &fileName,
                                       const ImportOptions &options = {}, const ImportOptions &usual = {});

/// Puts what was imported into a document: the test with the name of the file, its SHA-256 and, if wanted,
/// its bytes; machine, instrument and operator where the document states none; temperatures into the tests
/// of the file, or of all tests if `test` is null there. `hash` is the SHA-256 of the bytes where it is known
/// already. Throws Error for temperatures without a test.
void addImported(Document &document, Imported imported, QByteArrayView bytes, const QString &fileName,
                 bool keepBytes, const std::string &hash = {});

} // namespace palmer
