// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QByteArray>
#include <optional>

namespace palmer {

/// What the XMP packet of a report states: beside what every reader shows, how to make the report again.
struct ReportMetadata {
    QString title;
    QString author;
    QString language; ///< "en", "fr"
    QString date;     ///< YYYY-MM-DD; empty: none
    Making making;

    bool operator==(const ReportMetadata &) const = default;
};

/// The packet, with the declaration of PDF/A-3b and the schema of our own properties. Nothing of the clock.
[[nodiscard]] QByteArray xmpPacket(const ReportMetadata &metadata);

/// Reads a packet of ours: title, author, language and `making`. Null for what is no XML, or was written by
/// another program, or has words that we do not write.
[[nodiscard]] std::optional<ReportMetadata> readXmp(const QByteArray &packet);

} // namespace palmer
