// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/clipboardtext.h"

#include "tables/richtext.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>
#include <algorithm>

namespace palmer::ui {

namespace {

QString textOfCell(const QTextTableCell &cell) {
    QStringList lines;
    for (auto part = cell.begin(); part != cell.end(); ++part) {
        if (part.currentBlock().isValid())
            lines << part.currentBlock().text();
    }
    return lines.join(u' ').simplified();
}

/// Adds an empty line unless there is one.
void addGap(QStringList &lines) {
    if (!lines.isEmpty() && !lines.last().isEmpty())
        lines << QString();
}

/// A merged cell is written in its first position.
void addTable(QStringList &lines, const QTextTable &table) {
    addGap(lines);
    for (int row = 0; row < table.rows(); ++row) {
        QStringList cells;
        for (int column = 0; column < table.columns(); ++column) {
            const QTextTableCell cell = table.cellAt(row, column);
            cells << (cell.row() == row && cell.column() == column ? textOfCell(cell) : QString());
        }
        lines << cells.join(u'\t');
    }
    addGap(lines);
}

void addFrame(QStringList &lines, const QTextFrame &frame) {
    for (auto part = frame.begin(); part != frame.end(); ++part) {
        if (const auto *table = qobject_cast<const QTextTable *>(part.currentFrame()))
            addTable(lines, *table);
        else if (part.currentFrame())
            addFrame(lines, *part.currentFrame());
        else if (const QString text = part.currentBlock().text(); text.isEmpty())
            addGap(lines);
        else
            lines << QString(text).replace(QChar::LineSeparator, u'\n');
    }
}

QString textOfHtml(const QString &html) {
    QTextDocument document;
    document.setHtml(html);
    QStringList lines;
    addFrame(lines, *document.rootFrame());
    if (!lines.isEmpty() && lines.last().isEmpty())
        lines.removeLast();
    return lines.join(u'\n');
}

bool saysNumbers(const QString &text) {
    return std::ranges::any_of(text, [](QChar c) { return c.isDigit(); });
}

} // namespace

QString copiedText(const QMimeData &copied) {
    QString text = copied.text();
    if (saysNumbers(text))
        return text;
    if (copied.hasHtml()) {
        if (QString html = textOfHtml(copied.html()); saysNumbers(html))
            return html;
    }
    for (const QString &format : copied.formats()) {
        if (!format.contains(QLatin1StringView("rtf")) &&
            !format.contains(QLatin1StringView("Rich Text Format")))
            continue;
        const QByteArray rtf = copied.data(format);
        if (QString rich =
                QString::fromStdString(textOfRtf({rtf.data(), static_cast<std::size_t>(rtf.size())}));
            saysNumbers(rich))
            return rich;
    }
    return text;
}

QString clipboardText() {
    const QMimeData *copied = QGuiApplication::clipboard()->mimeData();
    return copied ? copiedText(*copied) : QString();
}

} // namespace palmer::ui
