// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/visibletext.h"

#include <algorithm>

namespace palmer {

namespace {

bool isUnseen(char16_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x061C || c == 0x200E || c == 0x200F ||
           (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

bool isAscii(char c) {
    return static_cast<unsigned char>(c) < 0x7F;
}

/// Replaces characters other than line breaks by `shown`.
template <class Shown>
QString replaced(const QString &text, Shown shown) {
    QString result;
    for (const QChar c : text) {
        if (c != u'\n' && isUnseen(c.unicode()))
            result += shown(c);
        else
            result += c;
    }
    return result;
}

QString hexadecimal(QChar c) {
    constexpr int digits = 4;
    constexpr int base = 16;
    return QString::number(c.unicode(), base).rightJustified(digits, u'0');
}

} // namespace

QString visibleText(const QString &text) {
    if (std::ranges::none_of(text, [](QChar c) { return isUnseen(c.unicode()); }))
        return text;
    QString lines = text;
    lines.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
    return replaced(lines, [](QChar c) {
        return c == u'\t' ? QStringLiteral(" ")
                          : u'\u2039' + (QStringLiteral("U+") + hexadecimal(c).toUpper()) + u'\u203A';
    });
}

QByteArray visibleText(const QByteArray &utf8) {
    return visibleText(QString::fromUtf8(utf8)).toUtf8();
}

QString cellText(const QString &text) {
    const QString line = visibleText(text).replace(u'\n', u' ');
    bool isNumber = false;
    line.toDouble(&isNumber);
    const bool isFormula =
        !isNumber && !text.isEmpty() && QStringView(u"=+-\u2212@\t").contains(text.front());
    return isFormula ? u'\'' + line : line;
}

std::string withJsonEscapes(std::string json) {
    if (std::ranges::all_of(json, isAscii))
        return json;
    return replaced(QString::fromStdString(json),
                    [](QChar c) { return QStringLiteral("\\u") + hexadecimal(c); })
        .toStdString();
}

} // namespace palmer
