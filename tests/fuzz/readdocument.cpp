// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

/// Reader and writer on bytes of any kind: an Error, or a document that is written and read as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    const auto bytes =
        QByteArray::fromRawData(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    palmer::Document document;
    try {
        document = palmer::readDocument(bytes);
    } catch (const palmer::Error &) {
        return 0;
    }
    if (!(palmer::readDocument(palmer::writeDocument(document)) == document))
        std::abort();
    return 0;
}
