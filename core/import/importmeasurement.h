// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "import/imported.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// Reads the bytes of a measurement file: tables in all layouts, workbooks, instrument files. The format is
/// recognised by the content; the name is used for the titles of errors and for unreadable formats.
/// `options`: the user's choices; everything else is recognised, or guessed with a remark each. Throws Error
/// with the place and what to do: for unknown words, unreadable content, undocumented formats, and a test
/// file or report, whole or damaged, recognised by content or name. `usual` applies if neither the user nor
/// the file states a choice.
[[nodiscard]] Imported importMeasurement(QByteArrayView bytes, const QString &fileName,
                                         const ImportOptions &options = {}, const ImportOptions &usual = {});

/// The same for an assistant: of an unreadable file returns what can be shown (the table, its columns, the
/// choices) with its `refusal`. Throws Error if there is nothing to show.
[[nodiscard]] Imported showMeasurement(QByteArrayView bytes, const QString &fileName,
                                       const ImportOptions &options = {}, const ImportOptions &usual = {});

/// True if both name a machine and not the same: their serial numbers differ or, where one is not stated,
/// their names.
[[nodiscard]] bool areOtherMachines(const Machine &a, const Machine &b);

/// Adds imported data to a document: the test with the file's name, SHA-256 and, if wanted, bytes; machine,
/// instrument and operator if the document states none (another machine goes into the remarks of the test);
/// temperatures to the tests of the file, or to all tests if `test` is null there. `hash`: SHA-256 of the
/// bytes if already known. Throws Error for temperatures without a test.
void addImported(Document &document, Imported imported, QByteArrayView bytes, const QString &fileName,
                 bool keepBytes, const std::string &hash = {});

/// The tests of a test file, or the one of a measurement file; its assumptions are appended to `guesses`.
/// Throws Error, also where a question wants an answer of its own.
[[nodiscard]] Document readTests(const QString &path, std::vector<Message> &guesses);

} // namespace palmer
