// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/folded.h"

#include <algorithm>
#include <array>

namespace palmer {

namespace {

struct Folding {
    std::string_view from;
    std::string_view to;
};

constexpr std::array foldings{
    Folding{"à", "a"},      Folding{"â", "a"},      Folding{"ä", "a"},      Folding{"á", "a"},
    Folding{"ã", "a"},      Folding{"À", "a"},      Folding{"Â", "a"},      Folding{"Ä", "a"},
    Folding{"Á", "a"},      Folding{"ç", "c"},      Folding{"Ç", "c"},      Folding{"é", "e"},
    Folding{"è", "e"},      Folding{"ê", "e"},      Folding{"ë", "e"},      Folding{"É", "e"},
    Folding{"È", "e"},      Folding{"Ê", "e"},      Folding{"î", "i"},      Folding{"ï", "i"},
    Folding{"í", "i"},      Folding{"ì", "i"},      Folding{"Í", "i"},      Folding{"ñ", "n"},
    Folding{"Ñ", "n"},      Folding{"ô", "o"},      Folding{"ö", "o"},      Folding{"ó", "o"},
    Folding{"ò", "o"},      Folding{"Ö", "o"},      Folding{"Ó", "o"},      Folding{"ù", "u"},
    Folding{"û", "u"},      Folding{"ü", "u"},      Folding{"ú", "u"},      Folding{"Ü", "u"},
    Folding{"Ú", "u"},      Folding{"ß", "ss"},     Folding{"œ", "oe"},     Folding{"Δ", "δ"},
    Folding{"−", "-"},      Folding{"–", "-"},      Folding{"‐", "-"},      Folding{"‑", "-"},
    Folding{"\u00A0", " "}, Folding{"\u202F", " "}, Folding{"\u2009", " "}, Folding{"µ", "u"},
    Folding{"μ", "u"},      Folding{"Σ", "σ"},
};

} // namespace

std::string folded(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (static_cast<unsigned char>(c) < 0x80) {
            result += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
            ++i;
            continue;
        }
        const auto *const found = std::ranges::find_if(
            foldings, [&](const Folding &folding) { return text.substr(i).starts_with(folding.from); });
        if (found != foldings.end()) {
            result += found->to;
            i += found->from.size();
        } else {
            result += c;
            ++i;
        }
    }
    return result;
}

} // namespace palmer
