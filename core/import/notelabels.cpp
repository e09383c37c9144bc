// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/notelabels.h"

#include "kernel/words/characters.h"
#include "tables/folded.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace palmer {

namespace {

/// Words, folded, with a blank around each.
using WordList = std::string_view;

/// A label names a fact if it is one of `names` (parted by commas) once the words of `others` are left out.
struct LabelRow {
    NoteFact fact;
    std::string_view names;
    WordList others;
};

constexpr WordList dayOthers =
    " test on am vom le du de del della d l of the essai mesure measurement der prufung messung prova misura "
    "ensayo medicion and time et heure und uhrzeit e ora y hora ";

constexpr std::array labelRows{
    LabelRow{NoteFact::machine,
             "machine,maschine,macchina,maquina,werkzeugmaschine,maschinenname,maschinenbezeichnung,"
             "stroj,maszyna,obrabiarka,станок,机床,设备,机器,機械,工作機械",
             " name nom nome nombre bezeichnung tool outil utensile herramienta of la de der della under "
             "test tested essayee testee verifiee controlee mesuree in prova collaudata misurata ensayada "
             "gepruft gepruefte geprufte "},
    LabelRow{
        NoteFact::serialNumber,
        "serial,serial no,serial number,serial nr,serial num,sn,seriennummer,seriennr,serien nr,serien "
        "nummer,"
        "matricola,n de serie,no de serie,nº de serie,numero de serie,numero di serie,num de serie,n serie,"
        "n di serie,maschinen seriennummer,maschinenseriennummer,ser nr,ser no,maschinennummer,maschinennr,"
        "maschinen nr,maschinen nummer,masch nr,serienummer,vyrobni cislo,numer seryjny,nr seryjny,"
        "серииныи номер,заводскои номер,序列号,机床编号,出厂编号,製造番号,シリアル番号,機番",
        " the of machine maschine macchina maquina la der della "},
    LabelRow{
        NoteFact::operatorName,
        "operator,operateur,operatrice,bediener,bedienerin,prufer,pruefer,operatore,operador,operario,"
        "inspector,inspecteur,technician,technicien,by,par,measured by,tested by,performed by,mesure par,"
        "essai par,realise par,effectue par,gemessen von,gepruft von,geprueft von,durchgefuhrt von,misurato "
        "da,"
        "eseguito da,medido por,realizado por,collaudatore,tecnico,bearbeiter,ausgefuhrt von,verifie par,"
        "controle par,verificato da,collaudato da,uitgevoerd door,gemeten door,оператор,исполнитель,操作员,"
        "操作者,检测员,检验员,检测人,測定者,担当者,作業者",
        " name nom nome nombre the of de l "},
    LabelRow{NoteFact::axis,
             "axis,axe,achse,asse,eje,messachse,prufachse,pruefachse,as,eixo,osa,os,ось,轴,軸",
             " name nom nome nombre measured tested test mesure essai essaye under the of de mesuree essayee "
             "misurato in prova medido ensayado gemessene geprufte gepruefte "},
    LabelRow{NoteFact::plane, "plane,plan,ebene,piano,plano,messebene",
             " test measurement mesure essai the of de "},
    LabelRow{NoteFact::date,
             "date,datum,data,fecha,day,tag,jour,giorno,dia,messdatum,messtag,prufdatum,pruefdatum,prufung "
             "vom,messung vom,дата,日期,测量日期,检测日期,测试日期,日付,測定日",
             dayOthers},
    LabelRow{NoteFact::day,
             "measured,tested,gemessen,gepruft,geprueft,mesure,misurato,medido,started,start,begin,debut",
             dayOthers},
    LabelRow{NoteFact::time, "time,heure,uhrzeit,zeit,ora,hora,start,beginn,startzeit,inizio,ora inizio",
             " of the test start de d l essai mesure measurement der messung prufung debut "},
    LabelRow{
        NoteFact::radius,
        "r,radius,nominal radius,test radius,circle radius,programmed radius,path radius,bar length,ballbar "
        "length,ball bar length,ballbar radius,rayon,rayon nominal,longueur ballbar,nennradius,sollradius,"
        "kreisradius,testradius,prufradius,messradius,bahnradius,raggio,raggio nominale,radio,radio nominal",
        " of the nominal circle test path du de cercle programme kreis des del della cerchio circulo "},
    LabelRow{NoteFact::diameter,
             "diameter,diametre,durchmesser,nenndurchmesser,solldurchmesser,kreisdurchmesser,diametro,ø",
             " nominal nominale of the circle test path du de cercle programme kreis des del della cerchio "
             "circulo "},
    LabelRow{
        NoteFact::feed,
        "f,feed,feedrate,feed rate,avance,vitesse d avance,vorschub,vorschubgeschwindigkeit,avanzamento,"
        "velocidad de avance,speed,traverse speed,traverse rate,feed speed,vitesse,vitesse de deplacement,"
        "verfahrgeschwindigkeit,velocita,velocita di avanzamento,velocita avanzamento",
        " programmed programmee axis "},
    LabelRow{
        NoteFact::airPressure,
        "pressure,air pressure,air press,atmospheric pressure,barometric pressure,pression,pression de air,"
        "pression atmospherique,pression air,pression barometrique,luftdruck,umgebungsdruck,pressione,"
        "pressione atmosferica,pressione aria,pressione barometrica,presion,presion atmosferica,ambient "
        "pressure,pressure of air",
        " the l d de dell "},
    LabelRow{
        NoteFact::airHumidity,
        "humidity,air humidity,air humid,relative humidity,rh,humidite,humidite relative,humidite de air,"
        "luftfeuchte,luftfeuchtigkeit,relative luftfeuchte,relative luftfeuchtigkeit,rel luftfeuchte,feuchte,"
        "umidita,umidita relativa,humedad,humedad relativa,rel humidity,rel feuchte,relative feuchte,"
        "hygrometrie,umidita aria",
        " the l d of "},
    LabelRow{NoteFact::correctionTo20,
             "corrected to 20,correction to 20,compensated to 20,normalised to 20,normalized to "
             "20,korrigiert auf 20,"
             "korrektur auf 20,corrige a 20,corrigee a 20,correction a 20,corretto a 20,correzione a "
             "20,corregido a 20,"
             "correccion a 20",
             " c degc deg "},
    LabelRow{NoteFact::calibration,
             "calibrated,length calibrated,ballbar calibrated,kalibriert,etalonne,calibrato,calibrado", " "},
};

constexpr WordList temperatureWords = " temp temperature temperatures temperatur temperatura t° "
                                      "temperatuur teplota температура 温度 气温 気温 室温 ";
constexpr std::array<std::string_view, 3> temperatureCompounds{"temperatur", "temperatuur",
                                                               "温度"}; // "Lufttemperatur"

/// Returns the part before the end of a compound; the whole word if it is none.
std::string_view beforeTemperature(std::string_view word) {
    for (const std::string_view compound : temperatureCompounds) {
        if (word.ends_with(compound))
            return word.substr(0, word.size() - compound.size());
    }
    return word;
}

/// A temperature is the reading of a sensor only if all its words are here: "rise", "limit", "before" are
/// not.
constexpr WordList sensorPlaces = " air luft aria aire ambient ambiant ambiante ambiance ambiente umgebung "
                                  "umgebungs room raum local salle atelier "
                                  "sala hall halle shop workshop werkstatt lab labor environment "
                                  "environnement laser interferometer instrument "
                                  "ballbar scale massstab massstabs regle riga material materials mat "
                                  "matiere materiau materiaux materiale pezzo "
                                  "workpiece werkstuck werkstucks werkstoff piece part table tisch tavola "
                                  "mesa bed bett banc bancale bancada "
                                  "spindle spindel broche mandrino husillo ballscrew screw ball nut mutter "
                                  "kugelgewindetrieb gewindespindel vis "
                                  "ecrou vite column saule stander colonne colonna columna head kopf tete "
                                  "testa cabezal frame rahmen bati guide "
                                  "rail coolant kuhlmittel kuhlschmierstoff oil ol huile olio aceite water "
                                  "wasser eau acqua motor moteur motore "
                                  "bearing lager palier front rear back left right top bottom upper lower "
                                  "vorn vorne hinten links rechts oben "
                                  "unten haut bas gauche droite avant arriere surface floor boden sol "
                                  "measured gemessen gemessene mesuree actual "
                                  "current axis axe achse achsen asse eje x y z u v w a b c no nr "
                                  "of the in on at de d del dell della di du des la le l les der die das dem "
                                  "von am an im il lo el test essai "
                                  "messung c deg degc f degf k lucht omgevings ar do da "
                                  "vzduchu powietrza otoczenia воздуха 空气 环境 空気 環境 室内 ";
constexpr WordList sensorWords = " sensor sensors sonde sondes fuhler capteur capteurs sensore sensori ";
constexpr WordList startWords = " start begin beginning initial debut anfang anfangs beginn inizio inicio ";
constexpr WordList endWords = " end final finish fin ende fine schluss ";

constexpr WordList machineWords =
    " machine maschine maschinen macchina maquina material mat materiale matiere materiau pezzo workpiece "
    "werkstuck "
    "werkstoff piece table tisch tavola mesa bed bett spindle spindel broche mandrino ";
constexpr WordList machineNames = " machine maschine macchina maquina ";
constexpr WordList instrumentWords =
    " laser interferometer interferometre interferometro instrument instrumente instruments instrumento "
    "strumento "
    "messgerat messgeraet ballbar sensor probe capteur encoder controller drehgeber steuerung scale ";

/// Words of a label that do not keep a date from being that of the test.
constexpr WordList dayWords = " date datum data fecha day tag jour test tests essai essais prova prueba "
                              "ensayo prufung pruefung messung "
                              "measurement measurements mesure mesures misura medicion measured tested "
                              "gemessen gepruft geprueft misurato "
                              "medido run runs of on the am vom le du de der del della d l and axis axe "
                              "achse asse eje x y z u v w b c "
                              "дата 日期 测量日期 检测日期 测试日期 日付 測定日 ";

/// Beginnings of words before a date that is not the day of the test.
constexpr std::array<std::string_view, 48> otherDays{
    "calib",    "etalon",  "kalib",    "tarat",     "certif",   "zertif",   "due",      "valid",
    "echeance", "fallig",  "faellig",  "scaden",    "print",    "druck",    "gedruckt", "imprim",
    "install",  "version", "built",    "baujahr",   "mise",     "export",   "purchas",  "achat",
    "achet",    "gekauft", "software", "logiciel",  "firmware", "mainten",  "wartung",  "entretien",
    "report",   "rapport", "bericht",  "issue",     "created",  "cree",     "erstellt", "revision",
    "rev",      "deliver", "livr",     "geliefert", "next",     "prochain", "expir",    "serv"};

std::vector<std::string> wordsOf(std::string_view label) {
    std::string low = folded(label.substr(0, label.find_first_of("([")));
    if (const std::size_t at = low.find("s/n"); at != std::string::npos)
        low.replace(at, 3, "sn");
    constexpr std::string_view apostrophe = "’";
    for (std::size_t at = low.find(apostrophe); at != std::string::npos; at = low.find(apostrophe))
        low.replace(at, apostrophe.size(), " ");
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < low.size(); ++i) {
        const char c = low[i];
        const bool isDegree = low.compare(i, 2, "°") == 0; // "n° de série"
        if (isDegree)
            ++i;
        const bool isPart = !isDegree && (isDigit(c) || (c >= 'a' && c <= 'z') || (c & '\x80') != 0);
        if (isPart)
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty())
        words.pop_back();
    return words;
}

bool isIn(WordList list, const std::string &word) {
    return list.find(' ' + word + ' ') != std::string_view::npos;
}

bool isNumber(const std::string &word) {
    return std::ranges::all_of(word, isDigit);
}

bool anyIn(WordList list, const std::vector<std::string> &words) {
    return std::ranges::any_of(words, [&](const std::string &word) { return isIn(list, word); });
}

bool isTemperatureWord(const std::string &word) {
    return isIn(temperatureWords, word) || beforeTemperature(word).size() < word.size() ||
           word.ends_with("temperaturen");
}

bool isSensorWord(std::string word) {
    if (word.ends_with("temperaturen"))
        word.resize(word.size() - 2);
    word = beforeTemperature(word);
    const auto isKnown = [](const std::string &each) {
        return each.empty() || isNumber(each) || isIn(temperatureWords, each) || isIn(sensorPlaces, each) ||
               isIn(sensorWords, each) || isIn(startWords, each) || isIn(endWords, each) ||
               isIn(machineWords, each);
    };
    const bool isGenitive = word.size() > 4 && word.ends_with('s'); // "Umgebungstemperatur"
    return isKnown(word) || (isGenitive && isKnown(word.substr(0, word.size() - 1)));
}

bool isTemperature(const std::vector<std::string> &words) {
    // "Temperature sensor: 2" counts or numbers them; "Temperature sensor 2: 20.5" is a reading.
    return std::ranges::any_of(words, isTemperatureWord) && std::ranges::all_of(words, isSensorWord) &&
           (!anyIn(sensorWords, words) || std::ranges::any_of(words, isNumber));
}

bool isNamed(const LabelRow &row, const std::vector<std::string> &words) {
    std::string rest;
    for (const std::string &word : words) {
        if (!isIn(row.others, word))
            rest += (rest.empty() ? "" : " ") + word;
    }
    std::string whole;
    for (const std::string &word : words)
        whole += (whole.empty() ? "" : " ") + word;
    const std::string names = ',' + std::string(row.names) + ',';
    const auto has = [&](const std::string &name) {
        return !name.empty() && names.find(',' + name + ',') != std::string::npos;
    };
    return has(whole) || has(rest);
}

} // namespace

std::optional<NoteFact> factOf(std::string_view label) {
    constexpr std::size_t longest = 80; // bytes
    if (label.size() > longest)
        return {};
    const std::vector<std::string> words = wordsOf(label);
    if (words.empty())
        return {};
    if (isTemperature(words))
        return NoteFact::temperature;
    const std::size_t slash = label.substr(0, label.find_first_of("([")).find('/');
    if (slash != std::string_view::npos && folded(label).find("s/n") == std::string::npos) {
        const auto first = factOf(label.substr(0, slash)); // "Prüfer / Opérateur"
        return first == factOf(label.substr(slash + 1)) ? first : std::nullopt;
    }
    const auto row =
        std::ranges::find_if(labelRows, [&](const LabelRow &each) { return isNamed(each, words); });
    return row == labelRows.end() ? std::nullopt : std::optional(row->fact);
}

std::optional<NoteFact> factOfWholeTest(std::string_view label) {
    constexpr std::array whole{NoteFact::machine, NoteFact::serialNumber, NoteFact::operatorName,
                               NoteFact::date,    NoteFact::plane,        NoteFact::feed};
    const auto fact = factOf(label);
    return fact && std::ranges::find(whole, *fact) != whole.end() ? fact : std::nullopt;
}

std::string planeIn(std::string_view text) {
    std::string letters = upperCase(text);
    for (const auto &[code, plane] :
         {std::pair("G17", "XY"), std::pair("G18", "ZX"), std::pair("G19", "YZ")}) {
        if (letters == code)
            return plane;
    }
    std::erase_if(letters, [](char c) { return c == '-' || c == '/' || c == ' ' || isDigit(c); });
    const bool isPlane = letters.size() == 2 && letters[0] != letters[1] &&
                         letters.find_first_not_of("XYZ") == std::string::npos;
    return isPlane ? letters : std::string();
}

bool namesMachine(std::string_view label) {
    return anyIn(machineNames, wordsOf(label));
}

bool namesSerialNumber(std::string_view label) {
    constexpr WordList serialWords = " serial sn seriennummer seriennr serien serie matricola ";
    return anyIn(serialWords, wordsOf(label));
}

const Unit *temperatureUnitIn(std::string_view text) {
    const std::vector<std::string> words =
        wordsOf(text.substr(std::min(text.find_first_not_of("(["), text.size())));
    if (words.empty())
        return nullptr;
    for (const auto &[list, unit] : {std::pair(" c degc celsius ", "C"),
                                     std::pair(" f degf fahrenheit ", "F"), std::pair(" k kelvin ", "K")}) {
        if (isIn(list, words.back()))
            return unitOf(unit);
    }
    return nullptr;
}

bool isPlausibleTemperature(double celsius) {
    constexpr double lowest = -20;
    constexpr double highest = 60;
    return celsius >= lowest && celsius <= highest;
}

bool namesInstrument(std::string_view label) {
    return anyIn(instrumentWords, wordsOf(label)) && !namesMachine(label);
}

TemperatureLabel temperatureLabel(std::string_view label) {
    TemperatureLabel result;
    const std::vector<std::string> words = wordsOf(label);
    const bool isStart = anyIn(startWords, words);
    result.isEnd = !isStart && anyIn(endWords, words);
    const std::size_t bracket = label.find_first_of("([");
    const bool isUnit = bracket != std::string_view::npos &&
                        folded(label.substr(bracket)).find_first_not_of("([ °degcfk])") == std::string::npos;
    const std::string shown(withoutBlanks(isUnit ? label.substr(0, bracket) : label));
    std::string word;
    const auto take = [&] {
        const std::vector<std::string> plain = wordsOf(word);
        const bool isMark = plain.size() == 1 && (isIn(startWords, plain[0]) || isIn(endWords, plain[0]) ||
                                                  plain[0] == "c" || plain[0] == "degc" || plain[0] == "deg");
        if (!word.empty() && !isMark)
            result.position += (result.position.empty() ? "" : " ") + word;
        word.clear();
    };
    for (const char c : shown) {
        if (c == ' ')
            take();
        else
            word += c;
    }
    take();
    const SensorMeasures measures = measuredBy(label);
    const bool saysMachine =
        anyIn(machineWords, words) || std::ranges::any_of(words, [](const std::string &each) {
            return each.starts_with("material") || each.starts_with("maschinen") ||
                   each.starts_with("werkstuck") || each.starts_with("werkstoff");
        });
    if (measures != SensorMeasures::machine || saysMachine)
        result.measures = measures;
    return result;
}

bool labelsDayOfTest(std::string_view label) {
    return std::ranges::all_of(
        wordsOf(label), [](const std::string &word) { return isIn(dayWords, word) || isNumber(word); });
}

bool namesOtherDay(std::string_view text) {
    return std::ranges::any_of(wordsOf(text), [](const std::string &word) {
        return std::ranges::any_of(otherDays, [&](std::string_view each) { return word.starts_with(each); });
    });
}

SensorMeasures measuredBy(std::string_view name) {
    constexpr std::array<std::string_view, 27> air{
        "lucht", "omgeving", "vzduch", "powietrz", "воздух", "空气", "空気",    "室温",      "气温",
        "気温",  "air",      "ambi",   "do ar",    "luft",   "aria", "aire",    "room",      "hall",
        "raum",  "umgebung", "salle",  "atelier",  "local",  "sala", "environ", "werkstatt", "workshop"};
    constexpr std::array<std::string_view, 6> instrument{"instrument", "ballbar", "scale",
                                                         "laser",      "etalon",  "strument"};
    const std::string low = folded(name);
    const auto names = [&](std::string_view word) { return low.find(word) != std::string::npos; };
    if (std::ranges::any_of(air, names))
        return SensorMeasures::air;
    return std::ranges::any_of(instrument, names) ? SensorMeasures::instrument : SensorMeasures::machine;
}

} // namespace palmer
