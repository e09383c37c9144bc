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
};

/// A row of the dictionary: whole words, folded; phrases separated by bars, their words by blanks.
/// `languages` is for readers of this table.
struct Phrases {
    Meaning meaning;
    Sign sign;
    std::string_view languages;
    std::string_view list;
};

constexpr std::array phrases{
    Phrases{Meaning::unknown, Sign::up, "*", "+|↑|⇑|↗|→|->|-->|>>|=>|»"},
    Phrases{Meaning::unknown, Sign::up, "en", "forward|forwards|fwd|up|upward|upwards|ascending|increasing"},
    Phrases{Meaning::unknown, Sign::up, "en fr", "positive"},
    Phrases{Meaning::unknown, Sign::up, "fr",
            "aller|positif|montee|montant|croissant|croissante|avant|ascendant"},
    Phrases{Meaning::unknown, Sign::up, "fr de", "plus"},
    Phrases{Meaning::unknown, Sign::up, "de",
            "hin|hinfahrt|hinweg|hinlauf|vorwarts|vorwaerts|vorlauf|vor|positiv|aufwarts|"
            "aufwaerts|steigend"},
    Phrases{Meaning::unknown, Sign::up, "it", "andata|avanti|salita|crescente"},
    Phrases{Meaning::unknown, Sign::up, "it es", "positivo|positiva"},
    Phrases{Meaning::unknown, Sign::up, "es", "ida|adelante|subida|creciente"},
    Phrases{Meaning::unknown, Sign::up, "es it", "ascendente"},
    Phrases{Meaning::unknown, Sign::down, "*", "-|↓|⇓|↘|←|<-|<--|<<|<=|«"},
    Phrases{Meaning::unknown, Sign::down, "en",
            "backward|backwards|bwd|back|reverse|down|downward|downwards|descending|decreasing"},
    Phrases{Meaning::unknown, Sign::down, "en fr", "negative"},
    Phrases{Meaning::unknown, Sign::down, "fr",
            "retour|negatif|descente|descendant|decroissant|decroissante|arriere|moins"},
    Phrases{Meaning::unknown, Sign::down, "de",
            "minus|ruck|rueck|zuruck|zurueck|ruckfahrt|rueckfahrt|ruckweg|rueckweg|rucklauf|"
            "ruecklauf|ruckwarts|rueckwaerts|her|negativ|abwarts|abwaerts|fallend"},
    Phrases{Meaning::unknown, Sign::down, "it", "ritorno|indietro|discesa|decrescente|discendente"},
    Phrases{Meaning::unknown, Sign::down, "it es", "negativo|negativa"},
    Phrases{Meaning::unknown, Sign::down, "es",
            "vuelta|regreso|retorno|atras|retroceso|bajada|descendente|decreciente"},
    // "pos" alone may also be a place.
    Phrases{Meaning::direction, Sign::up, "en", "pos direction|pos dir"},
    Phrases{Meaning::direction, Sign::down, "en", "neg direction|neg dir"},
    Phrases{Meaning::direction, Sign::up, "de", "pos richtung"},
    Phrases{Meaning::direction, Sign::down, "de", "neg richtung"},
    Phrases{Meaning::unknown, Sign::hintUp, "*", "pos"},
    Phrases{Meaning::unknown, Sign::hintDown, "*", "neg"},
    Phrases{Meaning::unknown, Sign::hintDown, "en", "rev|dec|desc|backw|return|inward|inbound"},
    Phrases{Meaning::unknown, Sign::hintUp, "en", "inc|asc|forw|out|outward|outbound"},
    Phrases{Meaning::unknown, Sign::hintUp, "es", "avance"},
    Phrases{Meaning::unknown, Sign::hintUp, "de", "auf"},
    Phrases{Meaning::unknown, Sign::hintDown, "de", "ab"},
    Phrases{Meaning::unknown, Sign::hintDown, "fr", "ret"},
    Phrases{Meaning::unknown, Sign::hintUp, "fr", "all"},
    Phrases{Meaning::statistic, Sign::none, "en",
            "mean|average|avg|avg error|std dev|standard deviation|range|reversal|reversal value|"
            "reversal error|backlash|repeatability|accuracy|bidirectional avg error|spread|sum"},
    Phrases{Meaning::statistic, Sign::none, "*",
            "std|stdev|stddev|sigma|σ|min|max|minimum|maximum|median|x\u0304|ø|Ø|⌀"},
    Phrases{Meaning::statistic, Sign::none, "en de", "hysteresis"},
    Phrases{Meaning::statistic, Sign::none, "fr",
            "moyenne|moyennes|moyen|moy|ecart type|ecart moyen|etendue|reversibilite|jeu|repetabilite|"
            "mini|maxi|somme"},
    Phrases{Meaning::statistic, Sign::none, "de",
            "mittelwert|mittel|mittlere|std abw|standardabweichung|streuung|spannweite|"
            "umkehrspanne|positionsstreubreite|mw|durchschnitt|summe"},
    Phrases{Meaning::statistic, Sign::none, "it es", "media|medie|medio|minimo"},
    Phrases{Meaning::statistic, Sign::none, "it",
            "dev std|scarto tipo|deviazione standard|inversione|gioco|ripetibilita|massimo|somma"},
    Phrases{Meaning::statistic, Sign::none, "es",
            "desv tipica|desviacion tipica|desviacion estandar|inversion|holgura|rango|"
            "repetibilidad|maximo|promedio|suma"},
    Phrases{Meaning::temperature, Sign::none, "*", "temp|°c"},
    Phrases{Meaning::temperature, Sign::none, "en fr", "temperature|temperatures"},
    Phrases{Meaning::temperature, Sign::none, "de", "temperatur|temperaturen"},
    Phrases{Meaning::temperature, Sign::none, "it es", "temperatura"},
    Phrases{Meaning::other, Sign::none, "en fr", "tolerance|compensation|correction"},
    Phrases{Meaning::other, Sign::none, "de",
            "toleranz|grenzwert|grenze|kompensation|korrektur|vorschub|messunsicherheit|"
            "unsicherheit|bemerkung|druck|feuchte"},
    Phrases{Meaning::other, Sign::none, "it",
            "tolleranza|compensazione|correzione|avanzamento|velocita|incertezza|pressione|"
            "umidita"},
    Phrases{Meaning::other, Sign::none, "es",
            "tolerancia|compensacion|correccion|velocidad|incertidumbre|observacion|presion|"
            "humedad"},
    Phrases{Meaning::other, Sign::none, "*", "tol|offset|status"},
    Phrases{Meaning::other, Sign::none, "en",
            "limit|limits|feed|feedrate|speed|velocity|uncertainty|remark|remarks|comment|"
            "pressure|humidity|batch"},
    Phrases{Meaning::other, Sign::none, "fr it es", "limite"},
    Phrases{Meaning::other, Sign::none, "fr", "vitesse|incertitude|remarque|pression|humidite"},
    Phrases{Meaning::other, Sign::none, "it es", "nota"},
    Phrases{Meaning::other, Sign::none, "en fr it", "note"},
    Phrases{Meaning::deviation, Sign::none, "en", "deviation|deviations|errors"},
    Phrases{Meaning::deviation, Sign::none, "*", "dev|err|diff|δ|δr|δx|dr|dx"},
    Phrases{Meaning::deviation, Sign::none, "en es", "error"},
    Phrases{Meaning::deviation, Sign::none, "en fr", "difference"},
    Phrases{Meaning::deviation, Sign::none, "fr", "ecart|ecarts|erreur|erreurs|defaut|defauts"},
    Phrases{Meaning::deviation, Sign::none, "de",
            "abweichung|abweichungen|abw|fehler|positionsabweichung|positionsfehler|"
            "radialabweichung|differenz|messabweichung|messabweichungen|positionierabweichung|"
            "positionierfehler|wegabweichung|wegfehler|istabweichung|linearabweichung|"
            "winkelabweichung|winkelfehler|drehwinkelabweichung|drehwinkelfehler"},
    Phrases{Meaning::deviation, Sign::none, "it",
            "scostamento|scostamenti|scost|scarto|scarti|errore|errori|deviazione|deviazioni|differenza"},
    Phrases{Meaning::deviation, Sign::none, "es", "desviacion|desviaciones|desv|diferencia|desvio|desvios"},
    Phrases{Meaning::actual, Sign::none, "en", "actual|measured|meas"},
    Phrases{Meaning::actual, Sign::none, "fr", "reel|reelle|mesuree|atteinte"},
    Phrases{Meaning::actual, Sign::none, "de",
            "ist|istposition|istwert|istpos|istwinkel|gemessen|gemessene|gemessener"},
    Phrases{Meaning::actual, Sign::none, "it", "misurata|misurato|reale|effettiva|rilevata|rilevato"},
    Phrases{Meaning::actual, Sign::none, "es", "medida|medido|real"},
    Phrases{Meaning::reading, Sign::none, "fr", "mesure|mesures|releve|lecture"},
    Phrases{Meaning::reading, Sign::none, "en", "reading|readings|measurement"},
    Phrases{Meaning::reading, Sign::none, "de", "messwert|messwerte"},
    Phrases{Meaning::run, Sign::none, "de",
            "messung|lauf|laufe|messlauf|messreihe|zyklus|durchgang|reihe|fahrt"},
    Phrases{Meaning::reading, Sign::none, "it", "misura|lettura"},
    Phrases{Meaning::reading, Sign::none, "es", "lectura|medicion"},
    Phrases{Meaning::direction, Sign::none, "en fr", "direction"},
    Phrases{Meaning::direction, Sign::none, "*", "dir"},
    Phrases{Meaning::direction, Sign::none, "en", "approach|sense"},
    Phrases{Meaning::direction, Sign::none, "fr", "sens|approche"},
    Phrases{Meaning::direction, Sign::none, "de", "richtung|anfahrrichtung|fahrtrichtung|anfahrt"},
    Phrases{Meaning::direction, Sign::none, "it", "direzione|senso|verso"},
    Phrases{Meaning::direction, Sign::none, "es", "sentido|direccion"},
    Phrases{Meaning::time, Sign::none, "en", "time|elapsed|timestamp"},
    Phrases{Meaning::time, Sign::none, "fr", "temps|heure|duree|horodatage"},
    Phrases{Meaning::time, Sign::none, "de", "zeit|uhrzeit|zeitstempel"},
    Phrases{Meaning::time, Sign::none, "it", "tempo|ora"},
    Phrases{Meaning::time, Sign::none, "es", "tiempo|hora"},
    Phrases{Meaning::angle, Sign::none, "en fr", "angle|angles"},
    Phrases{Meaning::angle, Sign::none, "de", "winkel"},
    Phrases{Meaning::angle, Sign::none, "it", "angolo"},
    Phrases{Meaning::angle, Sign::none, "es", "angulo"},
    Phrases{Meaning::angle, Sign::none, "*", "theta|θ|phi|φ"},
    Phrases{Meaning::angle, Sign::none, "en fr de", "phase"},
    Phrases{Meaning::radius, Sign::none, "en de", "radius"},
    Phrases{Meaning::radius, Sign::none, "fr", "rayon"},
    Phrases{Meaning::radius, Sign::none, "it", "raggio"},
    Phrases{Meaning::radius, Sign::none, "es", "radio"},
    Phrases{Meaning::radius, Sign::none, "*", "ρ"},
    Phrases{Meaning::nominal, Sign::none, "en", "nominal radius|radius nominal"},
    Phrases{Meaning::nominal, Sign::none, "fr", "rayon nominal"},
    Phrases{Meaning::nominal, Sign::none, "de", "nennradius|sollradius"},
    Phrases{Meaning::nominal, Sign::none, "it", "raggio nominale"},
    Phrases{Meaning::nominal, Sign::none, "es", "radio nominal"},
    Phrases{Meaning::target, Sign::none, "en it", "target"},
    Phrases{Meaning::target, Sign::none, "en",
            "targets|commanded|command|programmed|demanded|set point|setpoint"},
    Phrases{Meaning::target, Sign::none, "en fr es", "nominal"},
    Phrases{Meaning::target, Sign::none, "fr it", "nominale"},
    Phrases{Meaning::target, Sign::none, "fr", "cible|visee|vise|consigne|theorique|programmee|commandee"},
    Phrases{Meaning::target, Sign::none, "de",
            "soll|sollposition|sollwert|sollpos|sollwinkel|zielposition|zielpos|zielwinkel|ziel|"
            "nennposition|nennwinkel"},
    Phrases{Meaning::target, Sign::none, "it", "obiettivo|bersaglio|comandata|programmata"},
    Phrases{Meaning::target, Sign::none, "it es", "teorica"},
    Phrases{Meaning::target, Sign::none, "es", "objetivo|consigna|programada|comandada"},
    Phrases{Meaning::place, Sign::none, "en fr de", "position"},
    Phrases{Meaning::place, Sign::none, "en fr", "positions"},
    Phrases{Meaning::place, Sign::none, "*", "pos|p"},
    Phrases{Meaning::place, Sign::none, "it", "posizione|quota"},
    Phrases{Meaning::place, Sign::none, "es", "posicion|cota"},
    Phrases{Meaning::place, Sign::none, "fr", "cote|abscisse"},
    Phrases{Meaning::place, Sign::none, "en", "coordinate"},
    Phrases{Meaning::place, Sign::none, "de",
            "messposition|messpunkt|achsposition|prufposition|prufpunkt|winkelposition|winkelstellung|"
            "drehwinkel"},
    Phrases{Meaning::run, Sign::none, "en", "run|runs|pass|trial|series|traverse|rep|repeat|repetition|test"},
    Phrases{Meaning::run, Sign::none, "en fr", "cycle"},
    Phrases{Meaning::run, Sign::none, "fr", "passe|passage|essai|course"},
    Phrases{Meaning::run, Sign::none, "fr en", "passes"},
    Phrases{Meaning::run, Sign::none, "fr es it", "serie"},
    Phrases{Meaning::run, Sign::none, "it", "corsa|passata|prova"},
    Phrases{Meaning::run, Sign::none, "it es", "ciclo"},
    Phrases{Meaning::run, Sign::none, "es", "pasada|recorrido|ensayo"},
    Phrases{Meaning::run, Sign::none, "*", "j"},
    Phrases{Meaning::index, Sign::none, "*", "index|idx|i|n|no|nr|#|n°|nº|pt|id"},
    Phrases{Meaning::index, Sign::none, "de", "lfd|nummer|punkt"},
    Phrases{Meaning::index, Sign::none, "fr it es", "numero"},
    Phrases{Meaning::index, Sign::none, "en", "number|sample|row|line"},
    Phrases{Meaning::index, Sign::none, "en fr", "point|points"},
    Phrases{Meaning::index, Sign::none, "it es", "punto"},
    Phrases{Meaning::axis, Sign::none, "en", "axis"},
    Phrases{Meaning::axis, Sign::none, "fr", "axe"},
    Phrases{Meaning::axis, Sign::none, "de", "achse"},
    Phrases{Meaning::axis, Sign::none, "it", "asse"},
    Phrases{Meaning::axis, Sign::none, "es", "eje"},
    Phrases{Meaning::process, Sign::none, "*", "pv"},
    Phrases{Meaning::unknown, Sign::filler, "en",
            "value|values|data|positioning|positional|of|the|to|travel|movement|ve"},
    Phrases{Meaning::unknown, Sign::filler, "en es", "angular"},
    Phrases{Meaning::unknown, Sign::filler, "fr", "angulaire|angulaires"},
    Phrases{Meaning::unknown, Sign::filler, "it", "angolare|angolari"},
    Phrases{Meaning::unknown, Sign::filler, "fr", "valeur|d|du|positionnement|lineaire"},
    Phrases{Meaning::unknown, Sign::filler, "de", "wert|der|die|lineare"},
    Phrases{Meaning::unknown, Sign::filler, "it", "valore|di|posizionamento|lineare"},
    Phrases{Meaning::unknown, Sign::filler, "es", "valor|º|posicionamiento|lineal"},
    Phrases{Meaning::unknown, Sign::filler, "*", "laser|linear|radial|radiale|in"},
    Phrases{Meaning::unknown, Sign::filler, "fr es", "de|en"},
    Phrases{Meaning::unknown, Sign::filler, "fr it", "l"},
    Phrases{Meaning::unknown, Sign::filler, "fr it es", "la"},
    Phrases{Meaning::unknown, Sign::filler, "it es", "del"},
    Phrases{Meaning::unknown, Sign::found, "en",
            "as found|before|before adjustment|before compensation|before correction"},
    Phrases{Meaning::unknown, Sign::left, "en",
            "as left|after|after adjustment|after compensation|after correction"},
    Phrases{Meaning::unknown, Sign::found, "fr",
            "etat initial|tel que trouve|avant reglage|avant compensation|avant correction"},
    Phrases{Meaning::unknown, Sign::left, "fr",
            "etat final|tel que laisse|apres|apres reglage|apres compensation|apres correction"},
    Phrases{Meaning::unknown, Sign::found, "de",
            "vorgefunden|wie vorgefunden|vor justage|vor justierung|vor einstellung|vor kompensation|vor "
            "korrektur"},
    Phrases{Meaning::unknown, Sign::left, "de",
            "hinterlassen|wie hinterlassen|nach justage|nach justierung|nach einstellung|nach "
            "kompensation|nach korrektur"},
    Phrases{Meaning::unknown, Sign::found, "it es", "prima|antes"},
    Phrases{Meaning::unknown, Sign::left, "it es", "dopo|despues"},
    Phrases{Meaning::unknown, Sign::up, "cs", "tam|vpřed|nahoru|kladný|kladná"},
    Phrases{Meaning::unknown, Sign::down, "cs", "zpět|vzad|dolů|záporný|záporná"},
    Phrases{Meaning::unknown, Sign::up, "pl", "naprzód|w przód|do przodu|dodatni|dodatnia"},
    Phrases{Meaning::unknown, Sign::down, "pl", "wstecz|do tyłu|z powrotem|powrót|ujemny|ujemna"},
    Phrases{Meaning::unknown, Sign::up, "ru",
            "вперёд|вперед|прямо|прямой|прямое|положительный|положительное"},
    Phrases{Meaning::unknown, Sign::down, "ru",
            "назад|обратно|обратный|обратное|отрицательный|отрицательное"},
    Phrases{Meaning::unknown, Sign::up, "zh ja", "正向|正方向|前进|去程|往路|前進"},
    Phrases{Meaning::unknown, Sign::down, "zh ja",
            "负向|反向|负方向|反方向|后退|回程|返程|復路|負方向|逆方向|後退"},
    Phrases{Meaning::place, Sign::none, "cs pl ru",
            "poloha|pozice|poz|pozycja|położenie|позиция|положение|координата"},
    Phrases{Meaning::place, Sign::none, "zh ja", "位置|坐标|座標"},
    Phrases{Meaning::target, Sign::none, "cs pl", "cíl|cílová|zadaná|zadana|docelowa|nominalna|nominální"},
    Phrases{Meaning::target, Sign::none, "ru", "цель|целевая|заданная|заданное|номинал|номинальное"},
    Phrases{Meaning::target, Sign::none, "zh ja", "目标|目标位置|指令位置|理论位置|目標|目標位置"},
    Phrases{Meaning::target, Sign::none, "*", "tgt|trgt|pi|p i"},
    Phrases{Meaning::actual, Sign::none, "en", "ref pos|reference position"},
    Phrases{Meaning::deviation, Sign::none, "cs pl",
            "odchylka|odchylky|chyba|odchyłka|odchyłki|odchylenie|błąd|błędy"},
    Phrases{Meaning::deviation, Sign::none, "ru", "отклонение|отклонения|ошибка|ошибки|погрешность"},
    Phrases{Meaning::deviation, Sign::none, "zh ja", "偏差|误差|誤差"},
    Phrases{Meaning::actual, Sign::none, "cs pl ru",
            "skutečná|naměřená|rzeczywista|zmierzona|фактическая|фактическое|измеренная|измеренное|"
            "действительная"},
    Phrases{Meaning::actual, Sign::none, "zh ja", "实际|实际位置|实测|测量值|実測|実際位置|測定値"},
    Phrases{Meaning::run, Sign::none, "cs pl ru", "měření|běh|pomiar|przebieg|измерение|проход|прогон|цикл"},
    Phrases{Meaning::run, Sign::none, "zh ja", "测量|次|循环|測定|回"},
    Phrases{Meaning::direction, Sign::none, "cs pl ru zh ja", "směr|kierunek|направление|方向"},
    Phrases{Meaning::statistic, Sign::none, "cs pl ru zh ja", "průměr|średnia|среднее|平均|平均值|平均値"},
    Phrases{Meaning::temperature, Sign::none, "cs ru zh ja", "teplota|температура|温度"},
    Phrases{Meaning::time, Sign::none, "cs pl ru zh ja", "čas|czas|время|时间|時間"},
    Phrases{Meaning::unknown, Sign::from, "en de fr es it", "from|von|depuis|desde|da|dal|dalla"},
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
                const std::string_view words = rest.substr(0, rest.find('|'));
                result[words.substr(0, words.find(' '))].push_back({words, row.meaning, row.sign});
                rest.remove_prefix(std::min(words.size() + 1, rest.size()));
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
        if (m_up != m_down)
            m.direction = m_up ? Direction::positive : Direction::negative;
        if (m_dash && !m_up && !m_down)   // otherwise it separates words: "Run 2 - forward"
            m.hint = Direction::negative; // "Meas. pos. - 1" next to "Meas. pos. + 1"
        else if (m_hintUp != m_hintDown)
            m.hint = m_hintUp ? Direction::positive : Direction::negative;
        for (const Meaning meaning : precedence) {
            if (has(meaning)) {
                m.meaning = meaning;
                break;
            }
        }
        if (m_symbol && m.direction && m_meanings.empty() && m.unknownWords < 2)
            m.meaning = Meaning::statistic;
        m.isTarget = has(Meaning::target);
        m.isActual = has(Meaning::actual) || has(Meaning::reading);
        m.saysDirection = has(Meaning::direction);
        if (has(Meaning::target) && has(Meaning::radius))
            m.meaning = Meaning::nominal;
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
        if (phrase.sign == Sign::found || phrase.sign == Sign::left)
            m.state = phrase.sign == Sign::found ? TestRole::asFound : TestRole::asLeft;
        if (phrase.meaning != Meaning::unknown)
            m_meanings.push_back(phrase.meaning);
        m_isDirection = phrase.sign != Sign::none && phrase.sign != Sign::filler && phrase.sign != Sign::from;
    }

    void remember(std::size_t i, std::size_t tokens) {
        for (std::size_t k = i; k < i + tokens && !m_isDirection; ++k)
            m.stem += std::string(m_tokens[k].text) + ' ';
        m_isDirection = false;
    }

    void takeUnknown(const Token &token) {
        constexpr std::string_view axes = "xyzuvwabc";
        constexpr std::string_view symbols = "smera"; // in ISO 230-2: "R↑", "2s↓"
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
    bool m_symbol = false; ///< a letter the standard uses for a computed value, without a number after it
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
        "|linksdrehend|linkslauf|linksherum|linkskreis|rechtsdrehend|rechtslauf|rechtsherum|rechtskreis"
        "|im|den|sinn|gegen|entgegen|uhrzeigersinn|gegenuhrzeigersinn|uhrzeigers"
        "|senso|orario|antiorario|inverso|contrario|contro|lancette|trigonometrico|trigonometrica"
        "|sentido|horario|antihorario|contra|agujas|reloj|⟲|⟳|";
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
    if (tokens.size() == 1 && !tokens[0].isNumber && tokens[0].text.size() == 1 &&
        heading.meaning == Meaning::unknown) {
        heading.meaning = meaningOfLetter(tokens[0].text);
        heading.unknownWords = heading.meaning == Meaning::unknown ? heading.unknownWords : 0;
    }
    return heading;
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
