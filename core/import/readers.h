// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"

#include <QByteArrayView>
#include <QString>
#include <span>

namespace palmer {

/// What a reader is given: the bytes of the file, and what the user decided.
struct ImportSource {
    QByteArrayView bytes;
    const ImportOptions &options;
};

// One reader a file.
[[nodiscard]] bool isRtl(QByteArrayView bytes);
void readRtl(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isBallbarXml(QByteArrayView bytes);
void readBallbarXml(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isRtx(QByteArrayView bytes);
void readRtx(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isIndexedText(QByteArrayView bytes);
void readIndexedText(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isRenText(QByteArrayView bytes);
void readRenText(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isCompensationTable(QByteArrayView bytes);
/// Always throws: a compensation table is no measurement; the sentence says how it is compared with one.
void readCompensationTable(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isPosText(QByteArrayView bytes);
void readPosText(const ImportSource &source, Choices &choices, Imported &imported);
/// The CSV of readings that Palmer writes.
[[nodiscard]] bool isPalmerCsv(QByteArrayView bytes);
void readPalmerCsv(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isWorkbook(QByteArrayView bytes);
void readWorkbook(const ImportSource &source, Choices &choices, Imported &imported);
[[nodiscard]] bool isAnything(QByteArrayView bytes);
void readTextTable(const ImportSource &source, Choices &choices, Imported &imported);

/// The text of a file with its encoding settled, and a remark where that is a guess.
[[nodiscard]] std::string decodedText(QByteArrayView bytes, Choices &choices, Imported &imported);

/// The table of a text or sheet → measurement; used by both.
void readMeasurementTable(Choices &choices, Imported &imported);

/// Throws Error with advice for a compensation table of a control, which is known by its ending, too.
void refuseCompensationTable(QByteArrayView bytes, const QString &fileName);

/// Throws Error with advice for a format that is known by name or content, but not described publicly.
void refuseUndocumented(QByteArrayView bytes, const QString &fileName);

} // namespace palmer
