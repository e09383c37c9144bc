// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// Whether a report includes the bytes of the instrument files that its document was imported from.
enum class Originals { leaveOut, include };

/// The test file in the PDF of a report: the whole document. Throws like writeDocument().
[[nodiscard]] QByteArray attachedFile(const Document &document, Originals originals = Originals::leaveOut);

/// True if the document holds bytes of instrument files.
[[nodiscard]] bool holdsOriginals(const Document &document);

/// "<report number>.palmer", without characters that file names cannot have; "report.palmer" without a
/// number.
[[nodiscard]] QString attachedFileName(const Document &document);

/// Name of the file in the PDF of a printed history, which carries no test file.
inline const QString historyFileName = QStringLiteral("history.json");

/// SHA-256 of that file, 64 hex digits, as `sha256sum` prints it: the fingerprint of the report.
[[nodiscard]] QString fingerprint(const QByteArray &attachedFile);

/// The first 16 digits in groups of four, for footers.
[[nodiscard]] QString shortFingerprint(const QString &fingerprint);

} // namespace palmer
