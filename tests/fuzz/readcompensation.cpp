// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/documenterror.h"
#include "export/compensation.h"

#include <QString>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

/// Compensation tables of any kind: an Error, or a table of numbers that ascends.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    const QByteArrayView bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    for (const char *name : {"x.comp", "x.csv"}) {
        try {
            const palmer::CompensationTable table =
                palmer::readFoundTable(bytes, QString::fromLatin1(name)).table;
            if (table.positions.empty() || table.positions.size() != table.forward.size() ||
                table.positions.size() != table.reverse.size())
                std::abort();
            for (std::size_t i = 1; i < table.positions.size(); ++i) {
                if (!(table.positions[i] > table.positions[i - 1]))
                    std::abort();
            }
            (void)table.correction(table.positions.front(), palmer::Direction::negative);
        } catch (const palmer::Error &) {
        }
    }
    return 0;
}
