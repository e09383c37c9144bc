// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/reporthtml.h"

namespace palmer::ui {

namespace {

QString html(const Phrase &phrase) {
    QString text;
    for (const Span &span : phrase.spans) {
        QString part = span.text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
        if (span.subscript) // medium, to be legible in tables too
            part = QStringLiteral("<sub style=\"font-size:medium\">%1</sub>").arg(part);
        if (span.italic)
            part = QStringLiteral("<i>%1</i>").arg(part);
        if (span.bold)
            part = QStringLiteral("<b>%1</b>").arg(part);
        text += part;
    }
    return text;
}

constexpr std::size_t manyColumns = 7; ///< columns from which a table is set smaller, so that no number wraps

QString html(const Table &table) {
    const bool isWide = table.columns.size() >= manyColumns;
    QString text =
        QStringLiteral("<table width=\"99%\" cellspacing=\"0\" cellpadding=\"%1\" border=\"0\"><tr>")
            .arg(isWide ? 3 : 4);
    const QString style =
        isWide ? QStringLiteral(" style=\"white-space:nowrap; font-size:small\"") : QString();
    const auto side = [](Alignment alignment) {
        return alignment == Alignment::left ? QStringLiteral("left") : QStringLiteral("right");
    };
    for (const Column &column : table.columns) {
        QString head = html(column.title);
        if (!column.unit.isEmpty())
            head += QStringLiteral("<br>") + column.unit.toHtmlEscaped();
        text += QStringLiteral("<th align=\"%1\"%2>%3</th>").arg(side(column.alignment), style, head);
    }
    text += QStringLiteral("</tr>");
    for (const auto &row : table.rows) {
        text += QStringLiteral("<tr>");
        for (std::size_t i = 0; i < row.size() && i < table.columns.size(); ++i) {
            const QString cell = row[i].isMissing() ? QStringLiteral("–") : html(row[i].text);
            text += QStringLiteral("<td align=\"%1\"%2>%3</td>")
                        .arg(side(table.columns[i].alignment), style, cell);
        }
        text += QStringLiteral("</tr>");
    }
    return text + QStringLiteral("</table>");
}

struct Writer {
    QString text;

    void operator()(const Heading &heading) {
        if (!heading.anchor.isEmpty())
            text += QStringLiteral("<a name=\"%1\"></a>").arg(heading.anchor.toHtmlEscaped());
        text += QStringLiteral("<h%1>%2</h%1>").arg(heading.level + 1).arg(heading.text.toHtmlEscaped());
    }
    void operator()(const Paragraph &paragraph) {
        text += QStringLiteral("<p>%1</p>")
                    .arg(paragraph.text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
    }
    void operator()(const KeyValues &pairs) {
        for (const KeyValue &pair : pairs.rows)
            text += QStringLiteral("<p><b>%1</b><br>%2</p>")
                        .arg(pair.key.toHtmlEscaped(), pair.value.toHtmlEscaped());
    }
    void operator()(const Table &table) { text += html(table); }
    void operator()(const auto &) {} // only on paper
};

} // namespace

QString reportHtml(const Report &report) {
    Writer writer;
    for (const Block &block : report.blocks)
        std::visit(writer, block);
    return writer.text;
}

} // namespace palmer::ui
