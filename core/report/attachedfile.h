// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// Whether the bytes of the instrument files that a document was imported from go out with its report.
enum class Originals { leaveOut, include };

/// The test file that belongs to the report of a document and travels inside its PDF: the whole document.
/// Throws as writeDocument does.
[[nodiscard]] QByteArray attachedFile(const Document &document, Originals originals = Originals::leaveOut);

/// Whether the document holds bytes of instrument files at all.
[[nodiscard]] bool holdsOriginals(const Document &document);

/// "<report number>.palmer", without signs that a file name cannot have; "report.palmer" without a number.
[[nodiscard]] QString attachedFileName(const Document &document);

/// SHA-256 of that file, 64 hex digits: the fingerprint of the report, what `sha256sum` prints of the file.
[[nodiscard]] QString fingerprint(const QByteArray &attachedFile);

/// The first 16 digits in groups of four, as footers carry it.
[[nodiscard]] QString shortFingerprint(const QString &fingerprint);

} // namespace palmer
