#pragma once

#include "document/document.h"

#include <QByteArray>
#include <QString>

namespace palmer {

/// The test file that belongs to the report of a document: the whole document without the bytes of the
/// instrument files it was imported from. Throws as writeDocument does.
[[nodiscard]] QByteArray attachedFile(const Document &document);

/// SHA-256 of that file, 64 hex digits: the fingerprint of the report.
[[nodiscard]] QString fingerprint(const QByteArray &attachedFile);

/// The first 16 digits in groups of four, as footers carry it.
[[nodiscard]] QString shortFingerprint(const QString &fingerprint);

} // namespace palmer
