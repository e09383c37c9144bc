// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/folded.h"

#include "tables/numbercell.h"

#include <QString>
#include <algorithm>

namespace palmer {

namespace {

/// A common character for similar ones; 0: none.
char16_t plainSign(char16_t sign) {
    constexpr char16_t firstWide = 0xFF01; // full-width forms of ASCII
    constexpr char16_t lastWide = 0xFF5E;
    if (sign >= firstWide && sign <= lastWide)
        return static_cast<char16_t>(sign - firstWide + u'!');
    switch (sign) {
    case u'−':
    case u'–':
    case u'‐':
    case u'‑':
        return u'-';
    case u'\u00A0':
    case u'\u202F':
    case u'\u2009':
    case u'\u3000':
        return u' ';
    case u'µ':
    case u'μ':
        return u'u';
    default:
        return 0;
    }
}

std::string foldedBeyondAscii(std::string_view text) {
    constexpr char16_t meanSign = 0x304; // combining macron, the bar of a mean
    constexpr char16_t firstMark = 0x300;
    constexpr char16_t lastMark = 0x36F;
    QString result = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))
                         .normalized(QString::NormalizationForm_D)
                         .toCaseFolded()
                         .replace(QStringLiteral("œ"), QStringLiteral("oe"))
                         .replace(QStringLiteral("ł"), QStringLiteral("l"));
    result.removeIf([](QChar sign) {
        const char16_t code = sign.unicode();
        return code >= firstMark && code <= lastMark && code != meanSign;
    });
    for (QChar &sign : result) {
        if (const char16_t plain = plainSign(sign.unicode()); plain != 0)
            sign = QChar(plain);
    }
    return result.normalized(QString::NormalizationForm_C).toLower().toStdString();
}

} // namespace

std::string folded(std::string_view text) {
    const auto isAscii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    if (!std::ranges::all_of(text, isAscii))
        return foldedBeyondAscii(text);
    return lowerCase(text);
}

} // namespace palmer
