// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/testpart.h"

#include "report/words/wording.h"

#include <algorithm>

namespace palmer {

bool TestPart::leavesOut(ReportPart part) const {
    return std::ranges::find(head().leaveOut, part) != head().leaveOut.end();
}

bool CircularPart::asksFor(OfCircle quantity) const {
    return std::ranges::any_of(evaluation.parameters, [&](const Parameter &parameter) {
        return parameter.required && parameter.term.circle == quantity;
    });
}

bool CircularPart::needsLength() const {
    return !feedback() && (asksFor(OfCircle::radialDeviation) || asksFor(OfCircle::meanRadialDeviation));
}

QString CircularPart::plane() const {
    const std::string axes = axesOf(test);
    return QString::fromStdString(axes.empty() ? "–" : axes);
}

QString testName(const Writer &write, const Test &test) {
    const std::string axes = axesOf(test);
    return write.say(kindWords(test).name, {axes.empty() ? std::string("–") : axes});
}

QString joined(QStringList texts, const QString &separator) {
    texts.removeIf([](const QString &text) { return text.trimmed().isEmpty(); });
    return texts.join(separator);
}

QString enumerated(const Writer &write, QStringList texts) {
    if (texts.size() < 2)
        return texts.join(QString());
    const QString last = texts.takeLast();
    return write.say(REPORT_TEXT_FOR("report", "%1 and %2", "enumeration"),
                     {texts.join(QStringLiteral(", ")).toStdString(), last.toStdString()});
}

QString dateText(const Writer &write, const std::optional<std::string> &date) {
    return date && !date->empty() ? write.language().date(*date) : QString();
}

QString periodText(const Writer &write, const std::optional<std::string> &from,
                   const std::optional<std::string> &to) {
    QString first = dateText(write, from);
    const QString last = dateText(write, to);
    if (first.isEmpty() || last.isEmpty() || first == last)
        return first.isEmpty() ? last : first;
    // A common year, or month and year, is printed once.
    const qsizetype year = first.lastIndexOf(u' ');
    const qsizetype month = first.indexOf(QChar(u'\u00A0'));
    if (month > 0 && last.endsWith(first.mid(month)))
        first.truncate(month);
    else if (year > 0 && last.endsWith(first.mid(year)))
        first.truncate(year);
    return write.say(REPORT_TEXT_FOR("report", "%1 to %2", "dates"),
                     {first.toStdString(), last.toStdString()});
}

QString partyText(const Party &party) {
    QStringList lines{QString::fromStdString(party.name)};
    lines << QString::fromStdString(party.address).split(u'\n') << QString::fromStdString(party.contact);
    for (QString &line : lines)
        line = line.trimmed();
    return joined(lines);
}

void leaveOutEmptyColumns(Table &table, std::size_t first, std::size_t last) {
    for (std::size_t column = last + 1; column-- > first;) {
        const bool empty = std::ranges::all_of(table.rows, [column](const std::vector<Cell> &row) {
            return row[column].blank || row[column].isMissing();
        });
        if (empty)
            eraseColumn(table, column);
    }
}

void addHeading(std::vector<Block> &blocks, const QString &text, Phrase note, const QString &anchor) {
    blocks.emplace_back(Heading{2, text, std::move(note), anchor});
}

} // namespace palmer
