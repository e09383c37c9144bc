// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QByteArray>
#include <optional>

namespace palmer {

/// Content of the XMP packet of a report: what any reader shows, and how to make the report again.
struct ReportMetadata {
    QString title;
    QString author;
    QString language; ///< "en", "fr"
    QString date;     ///< YYYY-MM-DD; may be empty
    Making making;

    bool operator==(const ReportMetadata &) const = default;
};

/// The packet, with the declaration of PDF/A-3a and PDF/UA-1 and the schema of our own properties, without
/// any time.
[[nodiscard]] QByteArray xmpPacket(const ReportMetadata &metadata);

/// Reads our own packet: title, author, language and `making`. Null if it is not XML, was written by another
/// program or contains unknown words.
[[nodiscard]] std::optional<ReportMetadata> readXmp(const QByteArray &packet);

} // namespace palmer
