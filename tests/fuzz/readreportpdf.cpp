// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/readreportpdf.h"
#include "document/documenterror.h"

#include <cstddef>
#include <cstdint>

/// The door for reports on bytes of any kind: an Error, or a report taken apart.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    (void)palmer::readXmp(bytes);
    try {
        (void)palmer::readReportPdf(bytes);
    } catch (const palmer::Error &) {
        return 0;
    }
    return 0;
}
