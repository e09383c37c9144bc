// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/storedworkbook.h"

#include <QString>
#include <initializer_list>
#include <utility>

namespace palmer::testdata {

namespace {

void append(QByteArray &bytes, std::initializer_list<std::pair<quint32, int>> numbers) {
    for (const auto &[number, size] : numbers) {
        for (int i = 0; i < size; ++i)
            bytes += static_cast<char>(number >> (8 * i));
    }
}

quint32 crc32(const QByteArray &bytes) {
    quint32 crc = 0xFFFFFFFF;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int i = 0; i < 8; ++i)
            crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320 : 0);
    }
    return ~crc;
}

/// A zip archive without compression (APPNOTE.TXT 4.3).
QByteArray storedZip(const std::vector<std::pair<QByteArray, QByteArray>> &files) {
    QByteArray zip;
    QByteArray directory;
    for (const auto &[name, content] : files) {
        const auto size = static_cast<quint32>(content.size());
        const auto nameSize = static_cast<quint32>(name.size());
        const auto at = static_cast<quint32>(zip.size());
        const quint32 crc = crc32(content);
        append(zip, {{0x04034B50, 4},
                     {20, 2},
                     {0, 2},
                     {0, 2},
                     {0, 2},
                     {0x5821, 2},
                     {crc, 4},
                     {size, 4},
                     {size, 4},
                     {nameSize, 2},
                     {0, 2}});
        zip += name + content;
        append(directory, {{0x02014B50, 4},
                           {20, 2},
                           {20, 2},
                           {0, 2},
                           {0, 2},
                           {0, 2},
                           {0x5821, 2},
                           {crc, 4},
                           {size, 4},
                           {size, 4},
                           {nameSize, 2},
                           {0, 2},
                           {0, 2},
                           {0, 2},
                           {0, 2},
                           {0, 4},
                           {at, 4}});
        directory += name;
    }
    const auto count = static_cast<quint32>(files.size());
    const auto begin = static_cast<quint32>(zip.size());
    zip += directory;
    append(zip, {{0x06054B50, 4},
                 {0, 2},
                 {0, 2},
                 {count, 2},
                 {count, 2},
                 {static_cast<quint32>(directory.size()), 4},
                 {begin, 4},
                 {0, 2}});
    return zip;
}

QString cellName(int column, int row) {
    QString name;
    for (int rest = column + 1; rest > 0; rest = (rest - 1) / 26)
        name.prepend(QChar(u'A' + static_cast<char16_t>((rest - 1) % 26)));
    return name + QString::number(row + 1);
}

QByteArray sheetOf(const std::vector<QStringList> &rows, const std::vector<MergedCells> &merged,
                   const QStringList &formats) {
    QString sheet = R"(<?xml version="1.0" encoding="UTF-8"?><worksheet><sheetData>)";
    for (int r = 0; r < static_cast<int>(rows.size()); ++r) {
        sheet += QString("<row r=\"%1\">").arg(r + 1);
        const QStringList &cells = rows[static_cast<std::size_t>(r)];
        for (int c = 0; c < static_cast<int>(cells.size()); ++c) {
            bool isNumber = false;
            (void)cells[c].toDouble(&isNumber);
            if (isNumber)
                sheet += QString("<c r=\"%1\" s=\"%2\"><v>%3</v></c>")
                             .arg(cellName(c, r))
                             .arg(c < formats.size() ? c + 1 : 0)
                             .arg(cells[c]);
            else if (cells[c].startsWith('='))
                sheet += QString("<c r=\"%1\"><f>%2</f></c>").arg(cellName(c, r), cells[c].mid(1));
            else if (!cells[c].isEmpty())
                sheet += QString("<c r=\"%1\" t=\"inlineStr\"><is><t>%2</t></is></c>")
                             .arg(cellName(c, r), cells[c].toHtmlEscaped());
        }
        sheet += "</row>";
    }
    sheet += "</sheetData>";
    if (!merged.empty()) {
        sheet += QString("<mergeCells count=\"%1\">").arg(merged.size());
        for (const MergedCells &each : merged)
            sheet +=
                QString("<mergeCell ref=\"%1:%2\"/>")
                    .arg(cellName(each.column, each.row), cellName(each.column + each.span - 1, each.row));
        sheet += "</mergeCells>";
    }
    return (sheet + "</worksheet>").toUtf8();
}

QByteArray stylesOf(const QStringList &formats) {
    QString own;
    QString ofCells = "<xf numFmtId=\"0\"/>";
    for (int i = 0; i < static_cast<int>(formats.size()); ++i) {
        own += QString("<numFmt numFmtId=\"%1\" formatCode=\"%2\"/>")
                   .arg(200 + i)
                   .arg(formats[i].toHtmlEscaped());
        ofCells += QString("<xf numFmtId=\"%1\"/>").arg(200 + i);
    }
    return ("<styleSheet><numFmts>" + own + "</numFmts><cellXfs>" + ofCells + "</cellXfs></styleSheet>")
        .toUtf8();
}

} // namespace

QByteArray storedOds(const std::vector<QStringList> &rows, const std::vector<QStringList> &cover,
                     int hidden) {
    QString content =
        R"(<office:document-content xmlns:office="o" xmlns:table="t" xmlns:text="x"><office:body>)"
        R"(<office:spreadsheet>)";
    for (const auto &[name, sheet] : {std::pair("S", &rows), std::pair("Cover", &cover)}) {
        content += QString(R"(<table:table table:name="%1">)").arg(name);
        int index = sheet == &rows ? 0 : -1 - static_cast<int>(sheet->size());
        for (const QStringList &row : *sheet) {
            content +=
                index++ == hidden ? R"(<table:table-row table:visibility="collapse">)" : "<table:table-row>";
            for (const QString &cell : row) {
                const bool isNumber = cell.contains('|');
                content += isNumber
                               ? QString(R"(<table:table-cell office:value-type="float" office:value="%1">)")
                                     .arg(cell.section('|', 0, 0))
                               : QString(R"(<table:table-cell office:value-type="string">)");
                content += "<text:p>" + cell.section('|', isNumber ? 1 : 0).toHtmlEscaped() +
                           "</text:p></table:table-cell>";
            }
            content += "</table:table-row>";
        }
        content += "</table:table>";
    }
    content += "</office:spreadsheet></office:body></office:document-content>";
    return storedZip(
        {{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"}, {"content.xml", content.toUtf8()}});
}

QByteArray storedWorkbook(const std::vector<QStringList> &rows, const std::vector<MergedCells> &merged,
                          const QStringList &formats) {
    return storedZip(
        {{"[Content_Types].xml", "<Types/>"},
         {"xl/workbook.xml",
          R"(<workbook xmlns:r="r"><sheets><sheet name="S" sheetId="1" r:id="rId1"/></sheets>)"
          R"(</workbook>)"},
         {"xl/_rels/workbook.xml.rels",
          R"(<Relationships><Relationship Id="rId1" Target="worksheets/sheet1.xml"/></Relationships>)"},
         {"xl/styles.xml", stylesOf(formats)},
         {"xl/worksheets/sheet1.xml", sheetOf(rows, merged, formats)}});
}

} // namespace palmer::testdata
