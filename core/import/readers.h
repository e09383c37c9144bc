// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/formats.h"
#include "import/imported.h"

#include <QByteArrayView>
#include <QString>
#include <array>

namespace palmer {

/// What a reader is given: the bytes of the file, and what the user decided.
struct ImportSource {
    QByteArrayView bytes;
    const ImportOptions &options;
};

// One row a format, at the end of its reader's file.
extern const ImportFormat palmerCsvFormat, workbookFormat, rtlFormat, rtxFormat, ballbarFormat, indexedFormat,
    renFormat, compensationFormat, posFormat, tableFormat;

/// In the order they are asked in; the table is last, for it takes what no other recognises.
inline constexpr std::array formatsInOrder{&palmerCsvFormat, &workbookFormat, &rtlFormat, &rtxFormat,
                                           &ballbarFormat,   &indexedFormat,  &renFormat, &compensationFormat,
                                           &posFormat,       &tableFormat};

/// The text of a file with its encoding settled, and a remark where that is a guess.
[[nodiscard]] std::string decodedText(QByteArrayView bytes, Choices &choices, Imported &imported);

/// The table of a text or sheet → measurement; used by both.
void readMeasurementTable(Choices &choices, Imported &imported);

/// Throws Error with advice for a compensation table of a control, which is known by its ending, too.
void refuseCompensationTable(QByteArrayView bytes, const QString &fileName);

/// Throws Error with advice for a format that is known by name or content, but not described publicly.
void refuseUndocumented(QByteArrayView bytes, const QString &fileName);

} // namespace palmer
