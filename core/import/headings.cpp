#include "import/headings.h"

#include "import/numbercell.h"

#include <algorithm>
#include <array>
#include <vector>

namespace palmer {

namespace {

// Lower case, the Latin letters with accents included (two bytes: C3 80 … C3 9E).
std::string lowered(std::string_view text) {
    std::string result(text);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const auto byte = static_cast<unsigned char>(result[i]);
        if (byte >= 'A' && byte <= 'Z')
            result[i] = static_cast<char>(byte + 32);
        else if (byte == 0xC3 && i + 1 < result.size()) {
            const auto next = static_cast<unsigned char>(result[i + 1]);
            if (next >= 0x80 && next <= 0x9E && next != 0x97)
                result[i + 1] = static_cast<char>(next + 0x20);
            ++i;
        }
    }
    return result;
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

/// The words of a lowered text: letters together; arrows and Greek letters count as letters.
std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < text.size();) {
        if (!isLetter(text[i])) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() && isLetter(text[end]))
            ++end;
        words.push_back(text.substr(i, end - i));
        i = end;
    }
    return words;
}

template <std::size_t size>
bool oneOf(std::string_view word, const std::array<std::string_view, size> &words) {
    return std::ranges::find(words, word) != words.end();
}

constexpr std::array<std::string_view, 21> positiveWords{
    "+",      "↑",        "up",      "fwd",       "forward", "forwards", "aller",
    "pos",    "positive", "positif", "positiv",   "vor",     "hin",      "montée",
    "montee", "+1",       "asc",     "ascending", "p+",      "vorwärts", "inc"};
constexpr std::array<std::string_view, 26> negativeWords{
    "-",      "↓",        "down",    "bwd",     "backward", "backwards",  "back",      "rev",  "reverse",
    "retour", "neg",      "négatif", "negatif", "negative", "negativ",    "zurück",    "rück", "rueck",
    "desc",   "descente", "-1",      "−",       "–",        "descending", "rückwärts", "dec"};

struct Words {
    Meaning meaning;
    std::array<std::string_view, 14> words;
};

// The first row with a word of the heading decides.
constexpr std::array meanings{
    Words{Meaning::statistic,
          {"mean", "moyenne", "mittelwert", "average", "avg", "std", "stdev", "sigma", "range", "étendue",
           "reversal", "réversibilité", "x\u0304", "max"}},
    Words{Meaning::temperature,
          {"temp", "temperature", "température", "temperatur", "°c", "temperatures", "températures"}},
    Words{Meaning::deviation,
          {"deviation", "deviations", "écart", "ecart", "écarts", "error", "erreur", "dev", "err",
           "abweichung", "diff", "δ", "δr", "dr"}},
    Words{Meaning::actual,
          {"actual", "réel", "réelle", "reel", "measured", "mesuré", "mesurée", "ist", "istposition",
           "reading", "relevé", "mesure", "measurement"}},
    Words{Meaning::direction, {"direction", "dir", "sens", "sense", "richtung", "approach", "approche"}},
    Words{Meaning::time,
          {"time", "temps", "zeit", "heure", "elapsed", "durée", "uhrzeit", "t", "timestamp", "horodatage"}},
    Words{Meaning::angle, {"angle", "winkel", "theta", "θ", "phi", "φ", "angles"}},
    Words{Meaning::radius, {"radius", "rayon", "r", "ρ"}},
    Words{Meaning::target,
          {"target", "cible", "visé", "nominal", "soll", "sollposition", "consigne", "commanded", "position",
           "positions", "pos", "p", "point", "points"}},
    Words{Meaning::run, {"run", "runs", "passe", "passes", "cycle", "lauf", "pass", "passage", "série", "j"}},
    Words{Meaning::index, {"index", "i", "n", "no", "nr", "n°", "numéro", "number", "sample"}},
    Words{Meaning::x, {"x"}},
    Words{Meaning::y, {"y", "z"}},
};

bool isDirection(std::string_view word, Direction direction) {
    return direction == Direction::positive ? oneOf(word, positiveWords) : oneOf(word, negativeWords);
}

} // namespace

std::optional<Direction> directionOf(std::string_view word) {
    const std::string low = lowered(withoutBlanks(word));
    if (low.empty())
        return {};
    if (isDirection(low, Direction::positive))
        return Direction::positive;
    if (isDirection(low, Direction::negative))
        return Direction::negative;
    return {};
}

std::optional<Direction> directionInHeading(std::string_view heading, bool shortSigns) {
    const std::string low = lowered(heading);
    bool positive = low.find("↑") != std::string::npos;
    bool negative = low.find("↓") != std::string::npos;
    for (const std::string_view word : wordsOf(low)) {
        positive |= word.size() > 1 && isDirection(word, Direction::positive);
        negative |= word.size() > 1 && isDirection(word, Direction::negative);
    }
    if (positive && negative)
        return {}; // about both
    if (positive || negative)
        return positive ? Direction::positive : Direction::negative;
    // What is left of "1+", "Run 2 -", "A1" without digits and marks.
    std::string rest;
    for (const char c : low) {
        if (std::string_view("0123456789 ._:#()[]/\t").find(c) == std::string_view::npos)
            rest += c;
    }
    for (const std::string_view word : {"run", "passe", "lauf", "cycle", "pass", "dev"}) {
        if (rest.starts_with(word))
            rest.erase(0, word.size());
    }
    if (rest == "+")
        return Direction::positive;
    if (rest == "-" || rest == "−" || rest == "–")
        return Direction::negative;
    if (!shortSigns)
        return {};
    if (rest == "a" || rest == "f" || rest == "h" || rest == "v")
        return Direction::positive;
    if (rest == "r" || rest == "b")
        return Direction::negative;
    return {};
}

std::optional<Sense> senseIn(std::string_view text) {
    const std::string low = lowered(text);
    const std::vector<std::string_view> words = wordsOf(low);
    const auto has = [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); };
    if (has("ccw") || has("counterclockwise") || has("anticlockwise") || has("antihoraire") || has("acw") ||
        has("trigo") || low.find("counter-clockwise") != std::string::npos ||
        low.find("anti-clockwise") != std::string::npos || low.find("anti-horaire") != std::string::npos ||
        low == "g3" || low == "g03" || low == "⟲" || has("⟲"))
        return Sense::counterclockwise;
    if (has("cw") || has("clockwise") || has("horaire") || low == "g2" || low == "g02" || has("⟳"))
        return Sense::clockwise;
    return {};
}

Meaning meaningOf(std::string_view heading) {
    const std::string low = lowered(withoutUnit(heading));
    const std::vector<std::string_view> words = wordsOf(low);
    const auto names = [&](const Words &row) {
        return std::ranges::any_of(words, [&](std::string_view word) {
            return !word.empty() && std::ranges::find(row.words, word) != row.words.end();
        });
    };
    const auto *const found = std::ranges::find_if(meanings, names);
    return found == meanings.end() ? Meaning::unknown : found->meaning;
}

std::optional<double> clockTime(std::string_view text) {
    // The last blank-separated part, or what stands behind the T of ISO 8601.
    const std::size_t blank = text.find_last_of(" T");
    std::string_view clock = blank == std::string_view::npos ? text : text.substr(blank + 1);
    if (clock.ends_with('Z'))
        clock.remove_suffix(1);
    double seconds = 0;
    int parts = 0;
    while (parts < 3) {
        const std::size_t colon = clock.find(':');
        const std::string_view part = clock.substr(0, colon);
        const DecimalMark mark =
            part.find(',') == std::string_view::npos ? DecimalMark::point : DecimalMark::comma;
        const LeadingNumber number = leadingNumber(part, mark);
        const double most = parts == 0 ? 48 : 60;
        if (part.empty() || part.front() == '-' || part.front() == '+' || number.size != part.size() ||
            number.value >= most)
            return {};
        seconds += number.value * (parts == 0 ? 3600 : parts == 1 ? 60 : 1);
        ++parts;
        if (colon == std::string_view::npos)
            break;
        if (parts == 3)
            return {};
        clock.remove_prefix(colon + 1);
    }
    return parts >= 2 ? std::optional(seconds) : std::nullopt;
}

} // namespace palmer
