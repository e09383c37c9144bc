// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/papercharacters.h"

#include <QList>
#include <algorithm>
#include <array>

namespace palmer {

namespace {

struct CodeRange {
    char32_t first;
    char32_t last;
};

/// Characters in all four faces of the font, ascending.
// clang-format off
constexpr std::array ranges{
    CodeRange{0x20, 0x7e}, CodeRange{0xa0, 0x36f}, CodeRange{0x374, 0x375}, CodeRange{0x37a, 0x37e}, CodeRange{0x384, 0x38a}, CodeRange{0x38c, 0x38c},
    CodeRange{0x38e, 0x3a1}, CodeRange{0x3a3, 0x3ce}, CodeRange{0x3d0, 0x513}, CodeRange{0x51a, 0x51d}, CodeRange{0x591, 0x5c7}, CodeRange{0x5d0, 0x5ea},
    CodeRange{0x5f0, 0x5f4}, CodeRange{0x1d00, 0x1dca}, CodeRange{0x1dfe, 0x1e9b}, CodeRange{0x1e9e, 0x1e9e}, CodeRange{0x1ea0, 0x1ef9},
    CodeRange{0x1f00, 0x1f15}, CodeRange{0x1f18, 0x1f1d}, CodeRange{0x1f20, 0x1f45}, CodeRange{0x1f48, 0x1f4d}, CodeRange{0x1f50, 0x1f57},
    CodeRange{0x1f59, 0x1f59}, CodeRange{0x1f5b, 0x1f5b}, CodeRange{0x1f5d, 0x1f5d}, CodeRange{0x1f5f, 0x1f7d}, CodeRange{0x1f80, 0x1fb4},
    CodeRange{0x1fb6, 0x1fc4}, CodeRange{0x1fc6, 0x1fd3}, CodeRange{0x1fd6, 0x1fdb}, CodeRange{0x1fdd, 0x1fef}, CodeRange{0x1ff2, 0x1ff4},
    CodeRange{0x1ff6, 0x1ffe}, CodeRange{0x2000, 0x2010}, CodeRange{0x2012, 0x2022}, CodeRange{0x2026, 0x2026}, CodeRange{0x202a, 0x2030},
    CodeRange{0x2032, 0x2034}, CodeRange{0x2039, 0x203a}, CodeRange{0x203c, 0x203c}, CodeRange{0x203e, 0x203e}, CodeRange{0x2044, 0x2044},
    CodeRange{0x205e, 0x205e}, CodeRange{0x206a, 0x206f}, CodeRange{0x2074, 0x2079}, CodeRange{0x207f, 0x2089}, CodeRange{0x2090, 0x2094},
    CodeRange{0x20a0, 0x20b5}, CodeRange{0x20bf, 0x20bf}, CodeRange{0x20f0, 0x20f0}, CodeRange{0x2105, 0x2105}, CodeRange{0x2113, 0x2113},
    CodeRange{0x2116, 0x2117}, CodeRange{0x2122, 0x2122}, CodeRange{0x2126, 0x2126}, CodeRange{0x212e, 0x212e}, CodeRange{0x214d, 0x214e},
    CodeRange{0x2153, 0x2154}, CodeRange{0x215b, 0x215e}, CodeRange{0x2184, 0x2184}, CodeRange{0x2190, 0x2195}, CodeRange{0x21a8, 0x21a8},
    CodeRange{0x21d4, 0x21d4}, CodeRange{0x2202, 0x2202}, CodeRange{0x2206, 0x2206}, CodeRange{0x220f, 0x220f}, CodeRange{0x2211, 0x2212},
    CodeRange{0x2215, 0x2215}, CodeRange{0x2219, 0x221a}, CodeRange{0x221e, 0x221f}, CodeRange{0x2229, 0x2229}, CodeRange{0x222b, 0x222b},
    CodeRange{0x2248, 0x2248}, CodeRange{0x2260, 0x2262}, CodeRange{0x2264, 0x2265}, CodeRange{0x2302, 0x2302}, CodeRange{0x2310, 0x2310},
    CodeRange{0x2320, 0x2321}, CodeRange{0x2500, 0x2500}, CodeRange{0x2502, 0x2502}, CodeRange{0x250c, 0x250c}, CodeRange{0x2510, 0x2510},
    CodeRange{0x2514, 0x2514}, CodeRange{0x2518, 0x2518}, CodeRange{0x251c, 0x251c}, CodeRange{0x2524, 0x2524}, CodeRange{0x252c, 0x252c},
    CodeRange{0x2534, 0x2534}, CodeRange{0x253c, 0x253c}, CodeRange{0x2550, 0x256c}, CodeRange{0x2580, 0x2580}, CodeRange{0x2584, 0x2584},
    CodeRange{0x2588, 0x2588}, CodeRange{0x258c, 0x258c}, CodeRange{0x2590, 0x2593}, CodeRange{0x25a0, 0x25a1}, CodeRange{0x25aa, 0x25ac},
    CodeRange{0x25b2, 0x25b2}, CodeRange{0x25ba, 0x25ba}, CodeRange{0x25bc, 0x25bc}, CodeRange{0x25c4, 0x25c4}, CodeRange{0x25ca, 0x25cc},
    CodeRange{0x25cf, 0x25d9}, CodeRange{0x25e6, 0x25e6}, CodeRange{0x263a, 0x263c}, CodeRange{0x263f, 0x2647}, CodeRange{0x2660, 0x2660},
    CodeRange{0x2663, 0x2663}, CodeRange{0x2665, 0x2666}, CodeRange{0x2669, 0x266c}, CodeRange{0x266f, 0x266f}, CodeRange{0x2c60, 0x2c6d},
    CodeRange{0x2c71, 0x2c77}, CodeRange{0x2e17, 0x2e17}, CodeRange{0xa717, 0xa721}, CodeRange{0xa788, 0xa78c}, CodeRange{0xfb01, 0xfb02},
    CodeRange{0xfb1d, 0xfb36}, CodeRange{0xfb38, 0xfb3c}, CodeRange{0xfb3e, 0xfb3e}, CodeRange{0xfb40, 0xfb41}, CodeRange{0xfb43, 0xfb44},
    CodeRange{0xfb46, 0xfb4f}, CodeRange{0xfe20, 0xfe23}, CodeRange{0xfffc, 0xfffc}};
// clang-format on

/// Blocks of wide characters.
constexpr std::array wideRanges{
    CodeRange{0x1100, 0x115F}, CodeRange{0x2E80, 0xA4CF},   CodeRange{0xAC00, 0xD7A3},
    CodeRange{0xF900, 0xFAFF}, CodeRange{0xFE30, 0xFE6F},   CodeRange{0xFF00, 0xFF60},
    CodeRange{0xFFE0, 0xFFE6}, CodeRange{0x1F300, 0x1FAFF}, CodeRange{0x20000, 0x3FFFD}};

bool isInvisible(char32_t character) {
    const QChar::Category category = QChar::category(character);
    return category == QChar::Other_Control || category == QChar::Other_Format;
}

} // namespace

bool isOnPaper(char32_t character) {
    constexpr char32_t endOfLatin = 0x370;
    if (character < endOfLatin)
        return true;
    const auto after = std::ranges::upper_bound(ranges, character, {}, &CodeRange::first);
    return (after != ranges.begin() && character <= (after - 1)->last) || isInvisible(character);
}

std::vector<char32_t> notOnPaper(const QString &text) {
    std::vector<char32_t> result;
    constexpr char16_t endOfLatin = 0x370;
    if (std::ranges::all_of(text, [](QChar c) { return c.unicode() < endOfLatin; }))
        return result;
    for (const char32_t character : text.toUcs4()) {
        if (!isOnPaper(character))
            result.push_back(character);
    }
    std::ranges::sort(result);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

double foreignWidth(char32_t character) {
    constexpr double narrow = 0.6;
    if (QChar::category(character) == QChar::Mark_NonSpacing)
        return 0;
    const bool wide = std::ranges::any_of(
        wideRanges, [character](const CodeRange &r) { return character >= r.first && character <= r.last; });
    return wide ? 1 : narrow;
}

} // namespace palmer
