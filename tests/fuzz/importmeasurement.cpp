// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/importmeasurement.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

/// One reader (PALMER_FORMAT) on bytes of any kind: an Error, or a measurement that makes a document like any
/// other.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    const QByteArrayView bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    palmer::Imported imported;
    try {
        imported = palmer::importMeasurement(bytes, QStringLiteral("file"), {{"format", PALMER_FORMAT}});
    } catch (const palmer::Error &) {
        return 0;
    }
    if (!imported.test)
        return 0;
    palmer::Document document;
    try {
        palmer::addImported(document, std::move(imported), bytes, QStringLiteral("file"), false);
        if (palmer::readDocument(palmer::writeDocument(document)) == document)
            return 0;
    } catch (const palmer::Error &) {
        // What a reader accepts can be written and read.
    }
    std::abort();
}
