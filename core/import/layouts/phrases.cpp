// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/phrases.h"

#include "import/layouts/headings.h"
#include "kernel/words/characters.h"
#include "tables/folded.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <deque>
#include <span>
#include <unordered_map>

// Above 500 lines: much of it is the dictionary.

namespace palmer {

namespace {

/// Meaning of a phrase in the dictionary.
enum class Sign {
    none,
    up,
    down,
    hintUp, ///< ↑ only next to its opposite
    hintDown,
    filler, ///< ignored: articles, the words "value", "laser", a unit
    from,   ///< the direction after it is where the axis comes from
    found,  ///< before an adjustment
    left,   ///< after an adjustment
    test,   ///< a run to some, a whole test to others
};

/// A row of the dictionary: whole words, folded; phrases separated by bars, their words by blanks; the first
/// of a language behind its name, which is for readers of this table.
struct Phrases {
    Meaning meaning;
    Sign sign;
    std::string_view list;
};

constexpr std::array phrases{
    Phrases{
        Meaning::unknown, Sign::up,
        "*: +|↑|⇑|↗|→|->|-->|>>|=>|»|en: forward|forwards|fwd|up|upward|upwards|ascending|increasing|en "
        "fr: positive|fr: aller|positif|montee|montant|croissant|croissante|avant|ascendant|fr de: plus|"
        "de: hin|hinfahrt|hinweg|hinlauf|vorw|vorwarts|vorwaerts|vorlauf|vor|positiv|aufwarts|aufwaerts|"
        "steigend|it: andata|avanti|salita|crescente|it es: positivo|positiva|es: ida|adelante|subida|"
        "creciente|es it: ascendente|cs: tam|vpřed|nahoru|kladný|kladná|pl: naprzód|w przód|do przodu|"
        "dodatni|dodatnia|ru: вперёд|вперед|прямо|прямой|прямое|положительный|положительное|туда|вверх|nl: "
        "heen|vooruit|positief|cs: "
        "dopředu|zh ja: 正向|正行程|"
        "正方向|前进|去程|往路|前進"},
    Phrases{
        Meaning::unknown, Sign::down,
        "*: -|↓|⇓|↘|←|<-|<--|<<|<=|«|en: backward|backwards|bwd|back|reverse|down|downward|downwards|"
        "descending|decreasing|en fr: negative|fr: retour|negatif|descente|descendant|decroissant|"
        "decroissante|arriere|moins|de: minus|ruck|rueck|zuruck|zurueck|ruckfahrt|rueckfahrt|ruckweg|"
        "rueckweg|rucklauf|ruecklauf|ruckw|rueckw|ruckwarts|rueckwaerts|her|negativ|abwarts|abwaerts|"
        "fallend|it: "
        "ritorno|indietro|discesa|decrescente|discendente|it es: negativo|negativa|es: vuelta|regreso|"
        "retorno|atras|retroceso|bajada|descendente|decreciente|cs: zpět|vzad|dolů|záporný|záporná|pl: "
        "wstecz|do tyłu|z powrotem|powrót|ujemny|ujemna|ru: назад|обратно|обратный|обратное|"
        "отрицательный|отрицательное|вниз|nl: terug|achteruit|negatief|pt: "
        "descida|recuo|cs: dozadu|zh ja: 反行程|负向|反向|负方向|反方向|后退|回程|返程|復路|負方向|逆方向|"
        "後退"},
    Phrases{Meaning::direction, Sign::up, "en: pos direction|pos dir|de: pos richtung"},
    Phrases{Meaning::direction, Sign::down, "en: neg direction|neg dir|de: neg richtung"},
    Phrases{Meaning::unknown, Sign::hintUp,
            "*: pos|en: inc|asc|forw|out|outward|outbound|es: avance|pt: avanco|de: auf|fr: all"},
    Phrases{Meaning::unknown, Sign::hintDown,
            "*: neg|en: rev|dec|desc|backw|return|inward|inbound|de: ab|fr: ret|pt: volta"},
    Phrases{
        Meaning::statistic, Sign::none,
        "en: mean|average|avg|avg error|std dev|standard deviation|range|reversal|reversal value|"
        "reversal error|backlash|repeatability|accuracy|bidirectional avg error|spread|sum|*: std|stdev|"
        "stddev|sigma|σ|min|max|minimum|maximum|median|x\u0304|ø|Ø|⌀|en de: hysteresis|fr: moyenne|"
        "moyennes|moyen|moy|ecart type|ecart moyen|etendue|reversibilite|jeu|repetabilite|mini|maxi|"
        "somme|de: mittelwert|mittel|mittlere|std abw|standardabweichung|streuung|spannweite|"
        "umkehrspanne|positionsstreubreite|mw|durchschnitt|summe|it es: media|medie|medio|minimo|it: "
        "dev std|scarto tipo|deviazione standard|inversione|gioco|ripetibilita|massimo|somma|es: desv "
        "tipica|desviacion tipica|desviacion estandar|inversion|holgura|rango|repetibilidad|maximo|"
        "promedio|suma|nl: gemiddelde|gemiddeld|spreiding|"
        "standaardafwijking|omkeerspeling|herhaalbaarheid|pt: desvio padrao|folga|repetibilidade|soma|cs: "
        "směrodatná odchylka|rozpětí|pl: odchylenie standardowe|rozstęp|ru: стандартное отклонение|"
        "среднеквадратическое отклонение|ско|размах|zh ja: 标准偏差|标准差|標準偏差|反向差值|"
        "cs pl ru zh ja: průměr|średnia|среднее|平均|平均值|平均値|平均偏差|平均误差"},
    Phrases{Meaning::temperature, Sign::none,
            "*: temp|°c|en fr: temperature|temperatures|de: temperatur|temperaturen|it es: temperatura|cs "
            "ru zh ja: teplota|температура|温度|nl: temperatuur"},
    Phrases{Meaning::other, Sign::none,
            "en fr: tolerance|compensation|correction|de: toleranz|grenzwert|grenze|kompensation|korrektur|"
            "vorschub|messunsicherheit|unsicherheit|bemerkung|druck|feuchte|it: tolleranza|compensazione|"
            "correzione|avanzamento|velocita|incertezza|pressione|umidita|es: tolerancia|compensacion|"
            "correccion|velocidad|incertidumbre|observacion|presion|humedad|*: tol|offset|status|en: limit|"
            "limits|feed|feedrate|speed|velocity|uncertainty|remark|remarks|comment|pressure|humidity|batch|"
            "fr it es: limite|fr: vitesse|incertitude|remarque|pression|humidite|it es: nota|en fr it: note"},
    Phrases{
        Meaning::deviation, Sign::none,
        "en: deviation|deviations|errors|*: dev|err|diff|δ|δr|δx|dr|dx|en es: error|en fr: difference|"
        "fr: ecart|ecarts|erreur|erreurs|defaut|defauts|de: abweichung|abweichungen|abw|fehler|"
        "positionsabweichung|positionsfehler|radialabweichung|differenz|messabweichung|messabweichungen|"
        "positionierabweichung|positionierfehler|wegabweichung|wegfehler|istabweichung|linearabweichung|"
        "winkelabweichung|winkelfehler|drehwinkelabweichung|drehwinkelfehler|it: scostamento|"
        "scostamenti|scost|scarto|scarti|errore|errori|deviazione|deviazioni|differenza|es: desviacion|"
        "desviaciones|desv|diferencia|desvio|desvios|pt: erro|erros|diferenca|nl: afwijking|"
        "afwijkingen|fout|fouten|positieafwijking|positiefout|cs pl: "
        "odchylka|odchylky|chyba|odchyłka|odchyłki|"
        "odchylenie|błąd|błędy|ru: отклонение|отклонения|ошибка|ошибки|погрешность|zh ja: 偏差|误差|誤差"},
    Phrases{
        Meaning::actual, Sign::none,
        "en: actual|act|measured|meas|ref pos|reference position|fr: reel|reelle|mesuree|atteinte|de: ist|"
        "istposition|istwert|istpos|istwinkel|gemessen|gemessene|gemessener|it: misurata|misurato|reale|"
        "effettiva|rilevata|rilevato|es: medida|medido|real|cs pl ru: skutečná|naměřená|rzeczywista|"
        "zmierzona|фактическая|фактическое|измеренная|измеренное|действительная|nl: gemeten|werkelijke|zh "
        "ja: 实际|实际位置|"
        "实测|测量值|実測|実際位置|測定値"},
    Phrases{Meaning::reading, Sign::none,
            "fr: mesure|mesures|releve|lecture|en: reading|readings|measurement|de: messwert|messwerte|nl: "
            "meetwaarde|it: "
            "misura|lettura|es: lectura|medicion"},
    Phrases{Meaning::run, Sign::none,
            "de: messung|lauf|laufe|messlauf|messreihe|zyklus|durchgang|reihe|fahrt|en: run|runs|pass|trial|"
            "series|traverse|rep|repeat|repetition|en fr: cycle|fr: passe|passage|course|fr en: "
            "passes|fr es it: serie|it: corsa|passata|it es: ciclo|es: pasada|recorrido|*: j|"
            "cs pl ru: měření|běh|pomiar|przebieg|измерение|проход|прогон|цикл|cyklus|cykl|nl: meting|cyclus|"
            "doorgang|pt: medicao|passagem|zh ja: 测量|次|次数|循环|測定|回"},
    Phrases{Meaning::run, Sign::test, "en: test|fr: essai|it: prova|es: ensayo|pt: ensaio"},
    Phrases{Meaning::direction, Sign::none,
            "en fr: direction|*: dir|en: approach|sense|fr: sens|approche|de: richtung|anfahrrichtung|"
            "fahrtrichtung|verfahrrichtung|anfahrt|it: direzione|senso|verso|es: sentido|direccion|cs pl ru "
            "zh ja: směr|"
            "kierunek|направление|方向|nl: richting|"
            "pt: direcao"},
    Phrases{Meaning::time, Sign::none,
            "en: time|elapsed|timestamp|fr: temps|heure|duree|horodatage|de: zeit|uhrzeit|zeitstempel|it: "
            "tempo|ora|es: tiempo|hora|cs pl ru zh ja: čas|czas|время|时间|時間|nl: tijd"},
    Phrases{Meaning::angle, Sign::none,
            "en fr: angle|angles|*: ang|de: winkel|it: angolo|es: angulo|*: theta|θ|phi|φ|en fr de: phase"},
    Phrases{Meaning::radius, Sign::none, "en de: radius|fr: rayon|it: raggio|es: radio|*: ρ"},
    Phrases{Meaning::nominal, Sign::none,
            "en: nominal radius|radius nominal|fr: rayon nominal|de: nennradius|sollradius|it: raggio "
            "nominale|es: radio nominal"},
    Phrases{Meaning::target, Sign::none,
            "en it: target|en: targets|commanded|command|programmed|demanded|desired|des pos|set "
            "point|setpoint|en fr es: "
            "nominal|fr it: nominale|fr: cible|visee|vise|consigne|theorique|programmee|commandee|de: soll|"
            "sollposition|sollwert|sollpos|sollwinkel|zielposition|zielpos|zielwinkel|ziel|nennposition|"
            "nennwinkel|it: obiettivo|bersaglio|comandata|programmata|it es: teorica|es: objetivo|consigna|"
            "programada|comandada|cs pl: cíl|cílová|zadaná|zadana|docelowa|nominalna|nominální|ru: цель|"
            "целевая|заданная|заданное|номинал|номинальное|zh ja: 目标|目标位置|指令位置|理论位置|目標|"
            "目標位置|nl: doel|doelpositie|gewenste|pt: alvo|*: tgt|trgt|cmd|pi|p i"},
    Phrases{Meaning::place, Sign::none,
            "en fr de: position|en fr: positions|*: pos|p|it: posizione|quota|es: posicion|cota|fr: cote|"
            "abscisse|en: coordinate|de: messposition|messpunkt|achsposition|prufposition|prufpunkt|"
            "winkelposition|winkelstellung|drehwinkel|cs pl ru: poloha|pozice|poz|pozycja|położenie|позиция|"
            "положение|координата|zh ja: 位置|坐标|座標|nl: positie|pt: posicao"},
    Phrases{Meaning::index, Sign::none,
            "*: index|idx|i|n|no|nr|#|n°|nº|pt|id|de: lfd|nummer|punkt|fr it es: numero|en: number|sample|"
            "row|line|en fr: point|points|it es: punto|pl: lp|l p|ru zh ja: №|序号|番号"},
    Phrases{Meaning::axis, Sign::none,
            "en: axis|fr: axe|de: achse|it: asse|es: eje|pt cs pl ru zh ja: eixo|osa|oś|ось|轴|軸"},
    Phrases{Meaning::process, Sign::none, "*: pv"},
    Phrases{
        Meaning::unknown, Sign::filler,
        "en: value|values|data|positioning|positional|of|the|to|up to|travel|movement|ve|en es: angular|fr: "
        "angulaire|angulaires|valeur|d|du|positionnement|lineaire|it: angolare|angolari|valore|di|"
        "posizionamento|lineare|de: wert|der|die|lineare|es: valor|º|ru: ход|posicionamiento|lineal|*: laser|"
        "linear|radial|radiale|in|fr es: de|en|fr it: l|fr it es: la|it es: del"},
    Phrases{Meaning::unknown, Sign::found,
            "en: as found|before adjustment|before compensation|before correction|fr: etat initial|"
            "tel que trouve|avant reglage|avant compensation|avant correction|de: vorgefunden|wie "
            "vorgefunden|vor justage|vor justierung|vor einstellung|vor kompensation|vor korrektur|it: "
            "prima della regolazione|prima della compensazione|es: antes del ajuste|antes de la "
            "compensacion"},
    Phrases{Meaning::unknown, Sign::left,
            "en: as left|after adjustment|after compensation|after correction|fr: etat final|tel que "
            "laisse|apres reglage|apres compensation|apres correction|de: hinterlassen|wie "
            "hinterlassen|nach justage|nach justierung|nach einstellung|nach kompensation|nach korrektur|it: "
            "dopo la regolazione|dopo la compensazione|es: despues del ajuste|despues de la compensacion"},
    // "Vor" and "avant" alone are directions.
    Phrases{
        Meaning::unknown, Sign::none,
        "de: vor messung|vor lauf|vor test|vor dem|vor der|fr: avant essai|avant mesure|avant passe|avant "
        "l|avant le|avant la"},
    Phrases{Meaning::unknown, Sign::from, "en de fr es it: from|von|depuis|desde|da|dal|dalla"},
};

/// If a heading has words of two meanings, the first one here takes precedence: "standard deviation" is not a
/// deviation, "Measured position" not a target, "Target position" not a place.
constexpr std::array precedence{
    Meaning::statistic, Meaning::temperature, Meaning::other,  Meaning::nominal,   Meaning::deviation,
    Meaning::radius,    Meaning::angle,       Meaning::actual, Meaning::target,    Meaning::time,
    Meaning::place,     Meaning::reading,     Meaning::run,    Meaning::direction, Meaning::process,
    Meaning::index,     Meaning::axis,
};

bool isWordByte(char c) {
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Length of an arrow or similar sign, which is a token of its own next to any character.
std::size_t arrowLength(std::string_view text) {
    constexpr std::array<std::string_view, 18> arrows{"↑",   "↓",  "⇑",  "⇓",  "↗",  "↘",  "→",  "←", "-->",
                                                      "<--", "->", "<-", ">>", "<<", "=>", "<=", "»", "«"};
    constexpr std::string_view beginnings = "-<>=\xC2\xE2"; // most text contains none of them
    if (text.empty() || beginnings.find(text.front()) == std::string_view::npos)
        return 0;
    for (const std::string_view arrow : arrows) {
        if (text.starts_with(arrow))
            return arrow.size();
    }
    return 0;
}

struct Token {
    std::string_view text;
    bool isNumber = false;
    bool isWeak = false; ///< a dash between words, possibly a minus
};

/// A sign at the edge of a word is a token; between letters it is a hyphen.
std::optional<Token> signAt(std::string_view text, std::size_t i) {
    const auto isPart = [](char c) { return isWordByte(c) || isDigit(c); };
    std::size_t before = i;
    while (before > 0 && text[before - 1] == ' ')
        --before;
    std::size_t after = i + 1;
    while (after < text.size() && text[after] == ' ')
        ++after;
    const bool touchesBefore = i > 0 && isPart(text[i - 1]);
    const bool touchesAfter = i + 1 < text.size() && isPart(text[i + 1]);
    if (touchesBefore && touchesAfter)
        return std::nullopt;
    const Token sign{text.substr(i, 1)};
    if (sign.text == "+" || after >= text.size() || before == 0)
        return sign;
    if (text[i] == '-' && !isPart(text[before - 1]) && !isPart(text[after]))
        return sign;
    return Token{sign.text, false, true};
}

struct HeadingPhrase {
    std::string_view words;
    Meaning meaning;
    Sign sign;
};

using Dictionary = std::unordered_map<std::string_view, std::vector<HeadingPhrase>>;

/// By first word, with the longest phrases first.
const Dictionary &dictionary() {
    static const Dictionary rows = [] {
        Dictionary result;
        static std::deque<std::string> lists; // folded like headings
        for (const Phrases &row : phrases) {
            for (std::string_view rest = lists.emplace_back(folded(row.list)); !rest.empty();) {
                const std::size_t end = std::min(rest.find('|'), rest.size());
                const std::size_t colon = rest.substr(0, end).find(": "); // behind the name of a language
                const std::size_t begin = colon == std::string_view::npos ? 0 : colon + 2;
                const std::string_view words = rest.substr(begin, end - begin);
                result[words.substr(0, words.find(' '))].push_back({words, row.meaning, row.sign});
                rest.remove_prefix(std::min(end + 1, rest.size()));
            }
        }
        for (auto &[word, list] : result)
            std::ranges::stable_sort(list, std::ranges::greater(),
                                     [](const HeadingPhrase &phrase) { return phrase.words.size(); });
        return result;
    }();
    return rows;
}

/// Chinese and Japanese have no blanks between words: length of the longest known one, otherwise of one
/// character. 0: no such character.
std::size_t ideographsAt(std::string_view text) {
    constexpr std::size_t sign = 3; // bytes of kana and ideographs
    constexpr std::size_t longest = 8 * sign;
    const auto isSign = [&](std::size_t at) {
        return at + sign <= text.size() && text[at] >= '\xE3' && text[at] <= '\xE9';
    };
    std::size_t size = 0;
    while (size < longest && isSign(size))
        size += sign;
    for (std::size_t known = size; known > sign; known -= sign) {
        if (dictionary().contains(text.substr(0, known)))
            return known;
    }
    return std::min(size, sign);
}

std::vector<Token> tokensOf(std::string_view text) {
    std::vector<Token> tokens;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t arrow = arrowLength(text.substr(i));
        std::size_t end = i + 1;
        if (arrow > 0) {
            end = i + arrow;
            tokens.push_back({text.substr(i, arrow)});
        } else if (isDigit(text[i])) {
            while (end < text.size() && isDigit(text[end]))
                ++end;
            tokens.push_back({text.substr(i, end - i), true});
        } else if (const std::size_t size = ideographsAt(text.substr(i)); size > 0) {
            end = i + size;
            tokens.push_back({text.substr(i, size)});
        } else if (isWordByte(text[i])) {
            while (end < text.size() && isWordByte(text[end]) && arrowLength(text.substr(end)) == 0)
                ++end;
            tokens.push_back({text.substr(i, end - i)});
        } else if (text[i] == '+' || text[i] == '-') {
            if (const auto sign = signAt(text, i))
                tokens.push_back(*sign);
        } else if (text[i] == '#') {
            tokens.push_back({text.substr(i, 1)});
        }
        i = end;
    }
    return tokens;
}

/// Number of tokens that the phrase covers here; 0 if it does not match.
std::size_t covered(const HeadingPhrase &phrase, std::span<const Token> tokens) {
    std::size_t count = 0;
    for (std::string_view rest = phrase.words; !rest.empty(); ++count) {
        const std::size_t blank = std::min(rest.find(' '), rest.size());
        if (count >= tokens.size() || tokens[count].text != rest.substr(0, blank))
            return 0;
        rest.remove_prefix(std::min(blank + 1, rest.size()));
    }
    return count;
}

class HeadingReader {
public:
    explicit HeadingReader(std::vector<Token> tokens)
        : m_tokens(std::move(tokens)) {}

    HeadingWords read() {
        m.words = m_tokens.size();
        for (std::size_t i = 0; i < m_tokens.size();)
            i += take(i);
        m.isHintWord = m_hintUp != m_hintDown && !m.comesFrom && !m_dash;
        if (!m_hintUp && !m_hintDown) {
            m_hintUp = m_letterUp;
            m_hintDown = m_letterDown;
        }
        m.namesBoth = m_up && m_down;
        if (m_up != m_down)
            m.direction = m_up ? Direction::positive : Direction::negative;
        if (m_dash && !m_up && !m_down)   // otherwise it separates words: "Run 2 - forward"
            m.hint = Direction::negative; // "Meas. pos. - 1" next to "Meas. pos. + 1"
        else if (m_hintUp != m_hintDown)
            m.hint = m_hintUp ? Direction::positive : Direction::negative;
        const auto *const first =
            std::ranges::find_if(precedence, [this](Meaning meaning) { return has(meaning); });
        m.meaning = first == precedence.end() ? Meaning::unknown : *first;
        if (m_symbol && (m.direction || m.isHintWord) && m_meanings.empty() && m.unknownWords < 2)
            m.meaning = Meaning::statistic;
        m.isTarget = has(Meaning::target);
        m.isActual = has(Meaning::actual) || has(Meaning::reading);
        m.saysDirection = has(Meaning::direction);
        if (m_isRadius && m.words == 2 && (m.meaning == Meaning::target || m.meaning == Meaning::actual))
            m_meanings.push_back(m.meaning = Meaning::radius); // "R-Soll", "R act"
        if (has(Meaning::target) && has(Meaning::radius))
            m.meaning = Meaning::nominal;
        if (m_found != m_left)
            m.state = m_found ? TestRole::asFound : TestRole::asLeft;
        return m;
    }

private:
    [[nodiscard]] bool has(Meaning meaning) const {
        return std::ranges::find(m_meanings, meaning) != m_meanings.end();
    }

    std::size_t take(std::size_t i) {
        const Token &token = m_tokens[i];
        if (token.isNumber) {
            m_symbol = false; // "R1 ↑" is a run
            if (!m.number && token.text.size() < 7)
                m.number = static_cast<unsigned>(std::stoul(std::string(token.text)));
            return 1;
        }
        if (const std::size_t tokens = takePhrases(i); tokens > 0) {
            remember(i, tokens);
            return tokens;
        }
        takeUnknown(token);
        return 1;
    }

    /// Applies the phrases of the dictionary that begin here; returns the number of tokens.
    std::size_t takePhrases(std::size_t i) {
        const auto found = dictionary().find(m_tokens[i].text);
        if (found == dictionary().end())
            return 0;
        std::size_t tokens = 0;
        const bool isOrigin = i == m_origin;
        for (const HeadingPhrase &phrase : found->second) {
            const std::size_t here = covered(phrase, std::span(m_tokens).subspan(i));
            // A phrase may have several rows: "pos" is a place and short for positive.
            if (here == 0 || (tokens > 0 && here != tokens))
                continue;
            tokens = here;
            if (isOrigin && (phrase.sign == Sign::up || phrase.sign == Sign::down))
                comeFrom(phrase.sign);
            else
                apply(phrase, m_tokens[i]);
            if (phrase.sign == Sign::from || (isOrigin && phrase.sign == Sign::filler))
                m_origin = i + here;
        }
        return tokens;
    }

    /// "From +" moves towards −; some mean the opposite.
    void comeFrom(Sign sign) {
        m.comesFrom = true;
        m_hintUp |= sign == Sign::down;
        m_hintDown |= sign == Sign::up;
        m_isDirection = true;
    }

    void apply(const HeadingPhrase &phrase, const Token &token) {
        m_up |= phrase.sign == Sign::up;
        m_down |= phrase.sign == Sign::down && !token.isWeak;
        m_hintUp |= phrase.sign == Sign::hintUp;
        m_hintDown |= phrase.sign == Sign::hintDown;
        m_dash |= phrase.sign == Sign::down && token.isWeak;
        m_found |= phrase.sign == Sign::found;
        m_left |= phrase.sign == Sign::left;
        m.isTest |= phrase.sign == Sign::test;
        if (phrase.meaning != Meaning::unknown)
            m_meanings.push_back(phrase.meaning);
        m_isDirection = phrase.sign != Sign::test && phrase.sign != Sign::none &&
                        phrase.sign != Sign::filler && phrase.sign != Sign::from;
    }

    void remember(std::size_t i, std::size_t tokens) {
        for (std::size_t k = i; k < i + tokens && !m_isDirection; ++k)
            m.stem += std::string(m_tokens[k].text) + ' ';
        m_isDirection = false;
    }

    void takeUnknown(const Token &token) {
        constexpr std::string_view axes = "xyzuvwabc";
        constexpr std::string_view symbols = "smer"; // in ISO 230-2, per target: "R↑", "2s↓"
        m_isRadius |= token.text == "r";
        m_symbol = token.text.size() == 1 && symbols.find(token.text[0]) != std::string_view::npos;
        if (token.text.size() == 1 && axes.find(token.text[0]) != std::string_view::npos) {
            if (m.axis == 0)
                m.axis = static_cast<char>(token.text[0] - 'a' + 'A');
            m.stem += std::string(token.text) + ' ';
            takeLetter(token.text[0]);
            return;
        }
        if (token.text.size() == 1)
            takeLetter(token.text[0]);
        if (!unitIn("(" + std::string(token.text) + ")") && saidUnit(token.text).foreign.empty()) {
            ++m.unknownWords;
            m.stem += std::string(token.text) + ' ';
        }
    }

    /// "1A", "R 2": letters that are directions only next to their opposite.
    void takeLetter(char letter) {
        if (m_tokens.size() > 1) {
            m_letterUp |= letter == 'a' || letter == 'f' || letter == 'h' || letter == 'v';
            m_letterDown |= letter == 'r' || letter == 'b';
        }
    }

    std::vector<Token> m_tokens;
    std::vector<Meaning> m_meanings;
    std::optional<std::size_t> m_origin; ///< the token after "from"
    HeadingWords m;
    bool m_up = false;
    bool m_down = false;
    bool m_hintUp = false;
    bool m_hintDown = false;
    bool m_letterUp = false; ///< used if no word names a direction: "V neg. 1" belongs to axis V
    bool m_letterDown = false;
    bool m_dash = false;
    bool m_found = false;
    bool m_left = false;
    bool m_symbol = false;   ///< a letter the standard uses for a computed value, without a number after it
    bool m_isRadius = false; ///< "R"
    bool m_isDirection = false;
};

/// A single letter is short for a computed value or an axis.
Meaning meaningOfLetter(std::string_view letter) {
    constexpr std::string_view statistics = "smebau";
    if (letter == "r")
        return Meaning::radius;
    if (letter == "x")
        return Meaning::x;
    if (letter == "y" || letter == "z")
        return Meaning::y;
    if (letter == "t")
        return Meaning::time;
    return statistics.find(letter) != std::string_view::npos ? Meaning::statistic : Meaning::unknown;
}

/// True for words of "gegen den Uhrzeigersinn", "sens inverse des aiguilles d'une montre".
bool isOfSense(const Token &token) {
    constexpr std::string_view words =
        "|cw|ccw|acw|clockwise|counterclockwise|anticlockwise|counter|anti"
        "|sh|sah|sens|trigo|trigonometrique|horaire|antihoraire|des|aiguilles|une|montre|inverse|contraire"
        "|circle|circular|contour|arc|path|ballbar|kreis|kreisform|kreisformtest|kreistest|cercle|circulaire"
        "|cerchio|circolare|circulo|las|alle|delle|al|le"
        "|linksdrehend|linkslauf|linksherum|linkskreis|rechtsdrehend|rechtslauf|rechtsherum|rechtskreis"
        "|im|den|sinn|gegen|entgegen|uhrzeigersinn|gegenuhrzeigersinn|uhrzeigers|uzs|guzs"
        "|senso|orario|oraria|antiorario|antioraria|inverso|contrario|contro|lancette|trigonometrico|"
        "trigonometrica"
        "|sentido|horario|horaria|antihorario|antihoraria|contra|agujas|reloj|⟲|⟳|↺|↻"
        "|по|часовой|стрелке|против|часовая|逆|顺|順|时|時|针|針|反|計|回|り|";
    return words.find('|' + std::string(token.text) + '|') != std::string_view::npos;
}

} // namespace

HeadingWords readHeading(std::string_view text) {
    const std::string low = folded(withoutUnit(text.substr(0, 500)));
    std::vector<Token> tokens = tokensOf(low);
    const std::optional<Sense> sense = senseIn(low);
    if (sense)
        std::erase_if(tokens, isOfSense);
    HeadingWords heading = HeadingReader(tokens).read();
    if (sense) {
        ++heading.words;
        heading.namesSense = true;
        if (!heading.hint)
            heading.hint = sense == Sense::clockwise ? Direction::positive : Direction::negative;
        heading.isHintWord = false;
    }
    // "Y mm": a row of units below.
    const bool isAlone = tokens.size() == 1 ||
                         (tokens.size() == 2 && unitIn('(' + std::string(tokens[1].text) + ')') != nullptr);
    if (isAlone && !tokens[0].isNumber && tokens[0].text.size() == 1 && heading.meaning == Meaning::unknown) {
        heading.meaning = meaningOfLetter(tokens[0].text);
        heading.unknownWords = heading.meaning == Meaning::unknown ? heading.unknownWords : 0;
    }
    return heading;
}

HeadingWords readTitle(std::string_view line) {
    constexpr std::string_view labels = "|state|status|condition|zustand|etat|stato|estado|";
    const std::string text = folded(withoutBlanks(line));
    const std::size_t end = std::min(text.find_first_of(" :"), text.size());
    HeadingWords title = readHeading(text);
    if (!title.isTitle() && labels.find('|' + text.substr(0, end) + '|') != std::string_view::npos)
        title = readHeading(std::string_view(text).substr(end));
    return title;
}

std::optional<Direction> directionOf(std::string_view cell) {
    const std::string low = folded(withoutBlanks(cell.substr(0, 60)));
    if (low.empty() || isDigit(low.back()))
        return low == "+1"   ? std::optional(Direction::positive)
               : low == "-1" ? std::optional(Direction::negative)
                             : std::nullopt;
    const HeadingWords heading = HeadingReader(tokensOf(low)).read();
    if (heading.unknownWords > 0 || heading.number || (heading.comesFrom && !heading.direction))
        return {};
    return heading.direction ? heading.direction : heading.hint;
}

} // namespace palmer
