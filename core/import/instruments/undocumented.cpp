// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "tables/contenterror.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

/// An undocumented format, recognised by its file ending or content, and advice to the user.
struct Undocumented {
    std::array<const char *, 3> endings{};
    const char *name = nullptr;
    Text advice;
};

const std::array undocumentedFormats{
    Undocumented{
        {".b5r64", "", ""},
        "Renishaw .b5R64",
        REPORT_TEXT("report", "save the test from Ballbar 20 as .b5r (XML), or export its readings as text")},
    Undocumented{{".xcal", ".carto", ".cdb"},
                 "Renishaw CARTO",
                 REPORT_TEXT("report", "export the test from Explore as .rtl, or as CSV")},
    Undocumented{{".run", ".pos", ""},
                 "Keysight / Agilent / HP",
                 REPORT_TEXT("report", "print or export the data table as text or CSV")},
    Undocumented{
        {".lsp", ".lms", ""}, "Lasertex", REPORT_TEXT("report", "export the results as text or CSV")},
    Undocumented{{".api", ".xd", ".wxd"}, "API", REPORT_TEXT("report", "export the data as text or CSV")},
    Undocumented{{".lda", ".ldd", ""}, "Optodyne", REPORT_TEXT("report", "export the data as text or CSV")},
    Undocumented{
        {".sio", ".ifm", ""}, "SIOS", REPORT_TEXT("report", "export the measured values as text or CSV")},
    Undocumented{{".acc", ".accom", ".kgm"},
                 "Heidenhain ACCOM",
                 REPORT_TEXT("report", "export the measured values as text (ASCII)")},
    Undocumented{
        {".mdb", ".accdb", ".sqlite"}, "database", REPORT_TEXT("report", "export the test as text or CSV")},
};

/// True if the bytes are not text, so that the file ending decides. Text is tried as a table under any name.
bool isBinary(QByteArrayView bytes) {
    const QByteArrayView start = bytes.first(std::min<qsizetype>(bytes.size(), 4096));
    if (start.startsWith("\xFF\xFE") || start.startsWith("\xFE\xFF"))
        return false;
    return std::ranges::any_of(start, [](char c) { return static_cast<unsigned char>(c) < 9; });
}

[[noreturn]] void refuseOldWorkbook() {
    refuseAs(Error::Kind::format,
             REPORT_TEXT("report",
                         "workbooks of Excel 97 (.xls) cannot be read; save this one as .xlsx, .ods or CSV"));
}

} // namespace

bool isWebPage(QByteArrayView bytes) {
    const QByteArray start =
        bytes.first(std::min<qsizetype>(bytes.size(), 1024)).trimmed().toByteArray().toLower();
    return start.startsWith("<!doctype html") || start.startsWith("<html") || start.startsWith("<table") ||
           start.startsWith("<body");
}

void refuseUndocumented(QByteArrayView bytes, const QString &fileName) {
    if (isWebPage(bytes))
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report",
                             "this is a web page; open it in a browser, copy its table and paste it, or save "
                             "the table as text"));
    const QString name = fileName.toLower();
    const bool compound = bytes.startsWith("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"); // old office programs
    const bool sqlite = bytes.startsWith("SQLite format 3");
    if (!isBinary(bytes) && !sqlite)
        return;
    // An encrypted workbook uses the old container format.
    constexpr QByteArrayView encrypted("E\0n\0c\0r\0y\0p\0t\0e\0d\0P\0a\0c\0k\0a\0g\0e", 31);
    if (compound && bytes.indexOf(encrypted) >= 0)
        refuseAs(Error::Kind::format,
                 REPORT_TEXT("report", "the workbook is locked with a password; save it without one"));
    if (compound && (name.endsWith(QLatin1StringView(".xls")) || name.endsWith(QLatin1StringView(".xlsx"))))
        refuseOldWorkbook();
    for (const Undocumented &format : undocumentedFormats) {
        const bool named = std::ranges::any_of(format.endings, [&](const char *ending) {
            return *ending != 0 && name.endsWith(QLatin1StringView(ending));
        });
        if (named || (sqlite && std::string_view(format.name) == "Renishaw CARTO" &&
                      !name.endsWith(QLatin1StringView(".sqlite"))))
            refuseAs(Error::Kind::format,
                     REPORT_TEXT("report", "the format %1 is not documented publicly and cannot be read; %2"),
                     std::string(format.name), format.advice);
    }
    if (compound || name.endsWith(QLatin1StringView(".xls")))
        refuseOldWorkbook();
}

} // namespace palmer
