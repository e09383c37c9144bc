// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/filenotes.h"
#include "import/formats.h"
#include "import/imported.h"

#include <QByteArrayView>
#include <QString>
#include <array>
#include <vector>

namespace palmer {

/// Input of a reader: the bytes of the file and the user's choices.
struct ImportSource {
    QByteArrayView bytes;
    const ImportOptions &options;
};

// One format per row, defined at the end of its reader's file.
extern const ImportFormat palmerCsvFormat, workbookFormat, rtlFormat, rtxFormat, ballbarFormat, indexedFormat,
    renFormat, compensationFormat, posFormat, tableFormat;

/// In the order they are tried; the table is last, as it accepts whatever no other recognises.
inline constexpr std::array formatsInOrder{&palmerCsvFormat, &workbookFormat, &rtlFormat, &rtxFormat,
                                           &ballbarFormat,   &indexedFormat,  &renFormat, &compensationFormat,
                                           &posFormat,       &tableFormat};

/// The decoded text of a file, with a remark if its encoding is a guess.
[[nodiscard]] std::string decodedText(QByteArrayView bytes, Choices &choices, Imported &imported);

/// Sets the date of a test that has none, and the time in its text. A text that is not one date becomes its
/// remarks, with a note.
void takeDate(const std::optional<std::string> &date, const std::string &text, Test &test, Remarks &remarks);

/// Takes what a file states beside its table where nothing is stated yet.
void takeNotes(const FileNotes &notes, Imported &imported);

/// Reads a measurement from the table of a text or sheet, and what the sheets without one say of it.
void readMeasurementTable(Choices &choices, Imported &imported, const std::vector<CoverSheet> &covers = {});

/// Throws Error with advice for a compensation table of a control, recognised also by its suffix.
void refuseCompensationTable(QByteArrayView bytes, const QString &fileName);

/// True for HTML.
[[nodiscard]] bool isWebPage(QByteArrayView bytes);

/// Throws Error with advice for a format recognised by name or content but not publicly described.
void refuseUndocumented(QByteArrayView bytes, const QString &fileName);

} // namespace palmer
