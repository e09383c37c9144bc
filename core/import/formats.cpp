// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/formats.h"

#include "import/readers.h"

#include <array>

namespace palmer {

namespace {

// clang-format off
constexpr std::array formats{
    ImportFormat{"palmer", REPORT_TEXT("report", "CSV of Palmer"), "csv", isPalmerCsv, readPalmerCsv},
    ImportFormat{"workbook", REPORT_TEXT("report", "workbook"), "xlsx ods", isWorkbook, readWorkbook},
    ImportFormat{"rtl", REPORT_TEXT("report", "Renishaw laser data"), "rtl", isRtl, readRtl},
    ImportFormat{"rtx", REPORT_TEXT("report", "Renishaw dynamic capture"), "rtx", isRtx, readRtx},
    ImportFormat{"b5r", REPORT_TEXT("report", "Renishaw ballbar"), "b5r", isBallbarXml, readBallbarXml},
    ImportFormat{"indexed", REPORT_TEXT("report", "values with indexes (TGT_DATA)"), "", isIndexedText, readIndexedText},
    ImportFormat{"ren", REPORT_TEXT("report", "compensation text"), "ren", isRenText, readRenText},
    ImportFormat{"compensation", {}, "", isCompensationTable, readCompensationTable},
    ImportFormat{"pos", REPORT_TEXT("report", "API laser data"), "pos", isPosText, readPosText},
    ImportFormat{"table", REPORT_TEXT("report", "table"), "csv tsv txt", isAnything, readTextTable},
};
// clang-format on

} // namespace

std::span<const ImportFormat> importFormats() {
    return formats;
}

QStringList importEndings() {
    QStringList endings;
    for (const ImportFormat &format : formats)
        endings << QString::fromLatin1(format.endings).split(u' ', Qt::SkipEmptyParts);
    endings.removeDuplicates();
    return endings;
}

QString importPatterns() {
    return QStringLiteral("*.") + importEndings().join(QStringLiteral(" *."));
}

} // namespace palmer
