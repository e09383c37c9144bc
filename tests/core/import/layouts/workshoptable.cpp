// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/layouts/workshoptable.h"

#include <QList>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer::testdata {

namespace {

struct Vocabulary {
    const char *language;
    QStringList target;
    QStringList deviation;
    QStringList actual;
    QStringList run;
    QList<std::pair<QString, QString>> directions; ///< ↑, ↓
    QStringList direction;                         ///< heading of a column of them
    QStringList number;                            ///< heading of a counter
    QStringList further;                           ///< columns that are no readings
    QStringList titles;
};

const std::array vocabularies{
    Vocabulary{"en",
               {"Target", "Target position", "Nominal position", "Position", "Pos.", "P", "Target pos."},
               {"Deviation", "Dev", "Error", "Dev."},
               {"Actual", "Measured", "Actual position", "Meas. pos."},
               {"Run", "Cycle", "Pass"},
               {{"forward", "backward"},
                {"fwd", "bwd"},
                {"up", "down"},
                {"+", "-"},
                {"↑", "↓"},
                {"Forward", "Reverse"},
                {"positive", "negative"},
                {"Positive approach", "Negative approach"}},
               {"Direction", "Dir", "Approach"},
               {"i", "No.", "Index", "#"},
               {"Mean", "Std dev", "B", "s", "Min", "Max", "R", "Remark", "Reversal", "Temp (°C)", "Feed",
                "Tolerance", "Batch"},
               {"Linear positioning of X axis", "X axis rev 2", "Report 12 Dec 2023",
                "Laser test, pos. accuracy", "Positioning test 3; 5 runs",
                "Acceptance test - back side spindle"}},
    Vocabulary{
        "fr",
        {"Cible", "Position cible", "Position visée", "Position nominale", "Pos. cible", "P", "Consigne"},
        {"Écart", "Ecart", "Erreur", "écart de position"},
        {"Mesure", "Position mesurée", "Position réelle"},
        {"Passe", "Cycle", "Série"},
        {{"aller", "retour"},
         {"Aller", "Retour"},
         {"approche positive", "approche négative"},
         {"sens +", "sens -"},
         {"↑", "↓"},
         {"montée", "descente"},
         {"positif", "négatif"}},
        {"Sens", "Direction", "Approche"},
        {"N°", "i", "Point n°"},
        {"Moyenne", "Écart type", "B", "s", "Min", "Max", "Remarque", "Réversibilité", "Température (°C)",
         "Tolérance", "Lot"},
        {"Essai de positionnement axe X", "Rapport du 12/03/2024, rév. 2", "Contrôle laser - pos. initiale",
         "Réception machine ; 5 passes"}},
    Vocabulary{"de",
               {"Sollposition", "Soll-Pos.", "Soll", "Zielposition", "Position", "P", "Sollwert"},
               {"Abweichung", "Abw.", "Fehler", "Positionsabweichung"},
               {"Ist", "Istposition", "Ist-Pos.", "Istwert"},
               {"Lauf", "Messung", "Zyklus"},
               {{"hin", "rück"},
                {"Hinfahrt", "Rückfahrt"},
                {"vorwärts", "rückwärts"},
                {"Vorlauf", "Rücklauf"},
                {"+", "-"},
                {"↑", "↓"},
                {"positiv", "negativ"}},
               {"Richtung", "Anfahrrichtung"},
               {"Nr.", "i", "Lfd. Nr."},
               {"Mittelwert", "Std.abw.", "B", "s", "Min", "Max", "Bemerkung", "Umkehrspanne",
                "Temperatur (°C)", "Toleranz", "Charge"},
               {"Positioniergenauigkeit X-Achse", "Prüfbericht Rev. 2 vom 12.03.2024", "Lasermessung Pos. 3",
                "Abnahme, 5 Läufe"}},
    Vocabulary{"it",
               {"Quota nominale", "Posizione nominale", "Posizione target", "Posizione", "Pos. nominale"},
               {"Scostamento", "Errore", "Deviazione"},
               {"Quota misurata", "Posizione misurata", "Posizione reale"},
               {"Corsa", "Ciclo", "Passata"},
               {{"andata", "ritorno"},
                {"Andata", "Ritorno"},
                {"avanti", "indietro"},
                {"↑", "↓"},
                {"+", "-"},
                {"positivo", "negativo"}},
               {"Direzione", "Senso", "Verso"},
               {"N.", "i", "Numero"},
               {"Media", "Dev. std.", "B", "s", "Min", "Max", "Nota", "Inversione", "Temperatura (°C)",
                "Tolleranza", "Lotto"},
               {"Prova di posizionamento asse X", "Rapporto rev. 2 del 12/03/2024", "Collaudo, pos. 3"}},
    Vocabulary{
        "es",
        {"Posición objetivo", "Posición nominal", "Objetivo", "Posición", "Cota nominal"},
        {"Desviación", "Error", "Desv."},
        {"Posición medida", "Posición real", "Medida"},
        {"Pasada", "Ciclo", "Serie"},
        {{"ida", "vuelta"},
         {"Ida", "Vuelta"},
         {"adelante", "atrás"},
         {"↑", "↓"},
         {"+", "-"},
         {"positivo", "negativo"},
         {"avance", "retroceso"}},
        {"Dirección", "Sentido"},
        {"N.º", "i", "Número"},
        {"Media", "Desv. típica", "B", "s", "Mín", "Máx", "Observación", "Inversión", "Temperatura (°C)",
         "Tolerancia", "Lote"},
        {"Ensayo de posicionamiento eje X", "Informe rev. 2 del 12/03/2024", "Verificación láser, pos. 3"}},
};

class Maker {
public:
    explicit Maker(std::mt19937 &random)
        : m_random(random)
        , m_words(vocabularies[below(vocabularies.size())]) {}

    WorkshopTable make() {
        measure();
        chooseForm();
        writeTitle();
        static const std::array layouts{&Maker::sideBySide, &Maker::alternating, &Maker::blocks,
                                        &Maker::stacked,    &Maker::list,        &Maker::across};
        static const std::array names{"side by side", "alternating", "blocks", "stacked", "list", "across"};
        const std::size_t layout = below(layouts.size());
        (this->*layouts[layout])();
        m.description = QStringLiteral("%1, %2").arg(m_words.language, names[layout]);
        m.text = m_text;
        encode();
        return m;
    }

private:
    std::size_t below(std::size_t n) { return m_random() % n; }
    bool oneIn(std::size_t n) { return below(n) == 0; }
    QString oneOf(const QStringList &words) { return words[static_cast<qsizetype>(below(words.size()))]; }

    void measure() {
        const std::size_t targets = 4 + below(9);
        const std::size_t runs = 1 + below(5);
        const std::size_t step = std::array<std::size_t, 3>{2500, 5000, 10000}[below(3)];
        for (std::size_t i = 0; i < targets; ++i)
            m.targets.push_back(static_cast<double>(i * step + (i > 0 ? below(1000) : 0)) / 100);
        const double slope = (static_cast<double>(below(200)) - 100) / 4000;
        const double reversal = 2 + static_cast<double>(below(40)) / 10;
        for (auto *side : {&m.positive, &m.negative}) {
            for (std::size_t j = 0; j < runs; ++j) {
                std::vector<double> run;
                for (const double target : m.targets) {
                    const double value = slope * target + (side == &m.positive ? reversal : -reversal) / 2 +
                                         static_cast<double>(below(21)) / 10 - 1;
                    run.push_back(std::round(value * 10) / 10);
                }
                side->push_back(run);
            }
        }
    }

    void chooseForm() {
        m_delimiter = std::array{';', '\t', ',', '|'}[below(4)];
        m_comma = m_delimiter != ',' && oneIn(2);
        m_actual = oneIn(5);
        m_millimetres = !m_actual && oneIn(4);
        const auto pair = m_words.directions[static_cast<qsizetype>(below(m_words.directions.size()))];
        m_up = pair.first;
        m_down = pair.second;
        m_brackets = below(3);
        m_statesUnits = !oneIn(8);
        m.statesUnits = m_statesUnits;
        m_further = oneIn(2) ? oneOf(m_words.further) : QString();
        m_furtherFirst = oneIn(4);
        m_numbered = oneIn(3);
    }

    void writeTitle() {
        const std::size_t lines = below(3);
        for (std::size_t i = 0; i < lines; ++i)
            m_text += (oneIn(3) ? "# " : "") + oneOf(m_words.titles).replace(QChar(m_delimiter), u'-') + '\n';
        if (lines > 0 && oneIn(2))
            m_text += '\n';
    }

    [[nodiscard]] QString number(double value, int decimals) const {
        QString text = QString::number(value, 'f', decimals);
        return m_comma ? text.replace('.', ',') : text;
    }
    [[nodiscard]] QString target(std::size_t i) const { return number(m.targets[i], 2); }
    [[nodiscard]] QString reading(const std::vector<double> &run, std::size_t i) const {
        if (m_actual)
            return number(m.targets[i] + run[i] / 1000, 4);
        return m_millimetres ? number(run[i] / 1000, 4) : number(run[i], 1);
    }
    [[nodiscard]] QString withUnit(const QString &heading, const QString &unit) const {
        if (!m_statesUnits)
            return heading;
        return m_brackets == 0   ? heading + " (" + unit + ')'
               : m_brackets == 1 ? heading + " [" + unit + ']'
                                 : heading + " " + unit;
    }
    [[nodiscard]] QString valueUnit() const { return m_actual || m_millimetres ? "mm" : "µm"; }

    /// A row with the further columns where they were put.
    void row(QStringList cells, const QString &further, const QString &counter) {
        if (m_numbered)
            cells.prepend(counter);
        if (!m_further.isEmpty())
            m_furtherFirst ? cells.prepend(further) : cells.append(further);
        m_text += cells.join(QChar(m_delimiter)) + '\n';
    }
    QString furtherValue() {
        if (m_further.startsWith("Remark") || m_further == "Bemerkung" || m_further == "Nota")
            return oneIn(2) ? "ok" : "";
        if (m_further.contains("°C"))
            return number(20 + static_cast<double>(below(9)) / 10, 1);
        return number(static_cast<double>(below(80)) / 10 + 0.1, 2);
    }
    QString counterHeading() {
        if (m_counter.isEmpty())
            m_counter = oneOf(m_words.number);
        return m_counter == "#" && m_text.isEmpty() ? "No." : m_counter;
    }

    QString heading(const QString &direction, std::size_t j) {
        const QString number = QString::number(j + 1);
        const QString value = m_valueWord;
        switch (m_headingForm) {
        case 0:
            return withUnit(value + ' ' + direction + ' ' + number, valueUnit());
        case 1:
            return withUnit(m_runWord + ' ' + number + ' ' + direction, valueUnit());
        case 2:
            return withUnit(direction + ' ' + number, valueUnit());
        default:
            return withUnit(number + ' ' + direction, valueUnit());
        }
    }
    void chooseHeadings() {
        m_valueWord = oneOf(m_actual ? m_words.actual : m_words.deviation);
        m_runWord = oneOf(m_words.run);
        // That the values are positions has to stand somewhere.
        m_headingForm = m_actual ? 0 : static_cast<int>(below(4));
    }

    void targetsDown(const std::vector<std::pair<QString, const std::vector<double> *>> &runs, bool falling) {
        QStringList head{withUnit(oneOf(m_words.target), "mm")};
        for (const auto &[name, run] : runs)
            head << name;
        row(head, m_further, counterHeading());
        for (std::size_t k = 0; k < m.targets.size(); ++k) {
            const std::size_t i = falling ? m.targets.size() - 1 - k : k;
            QStringList cells{target(i)};
            for (const auto &[name, run] : runs)
                cells << reading(*run, i);
            row(cells, furtherValue(), QString::number(k + 1));
        }
    }

    void sideBySide() {
        chooseHeadings();
        std::vector<std::pair<QString, const std::vector<double> *>> runs;
        for (std::size_t j = 0; j < m.positive.size(); ++j)
            runs.emplace_back(heading(m_up, j), &m.positive[j]);
        for (std::size_t j = 0; j < m.negative.size(); ++j)
            runs.emplace_back(heading(m_down, j), &m.negative[j]);
        targetsDown(runs, false);
    }

    void alternating() {
        chooseHeadings();
        std::vector<std::pair<QString, const std::vector<double> *>> runs;
        for (std::size_t j = 0; j < m.positive.size(); ++j) {
            runs.emplace_back(heading(m_up, j), &m.positive[j]);
            runs.emplace_back(heading(m_down, j), &m.negative[j]);
        }
        targetsDown(runs, false);
    }

    void blocks() {
        chooseHeadings();
        const bool falling = oneIn(2);
        for (const bool up : {true, false}) {
            if (!up)
                m_text += '\n';
            m_text += (up ? m_up : m_down) + '\n';
            std::vector<std::pair<QString, const std::vector<double> *>> runs;
            const auto &side = up ? m.positive : m.negative;
            for (std::size_t j = 0; j < side.size(); ++j)
                runs.emplace_back(
                    withUnit((m_headingForm == 0 ? m_valueWord : m_runWord) + ' ' + QString::number(j + 1),
                             valueUnit()),
                    &side[j]);
            targetsDown(runs, !up && falling);
        }
    }

    /// All targets of ↑, below them those of ↓, with a column that says which.
    void stacked() {
        chooseHeadings();
        QStringList head{withUnit(oneOf(m_words.target), "mm"), oneOf(m_words.direction)};
        for (std::size_t j = 0; j < m.positive.size(); ++j)
            head << withUnit((m_headingForm == 0 ? m_valueWord : m_runWord) + ' ' + QString::number(j + 1),
                             valueUnit());
        row(head, m_further, counterHeading());
        for (const bool up : {true, false}) {
            for (std::size_t i = 0; i < m.targets.size(); ++i) {
                QStringList cells{target(i), up ? m_up : m_down};
                for (const auto &run : up ? m.positive : m.negative)
                    cells << reading(run, i);
                row(cells, furtherValue(), QString::number(i + 1));
            }
        }
    }

    void list() {
        const QString value = oneOf(m_actual ? m_words.actual : m_words.deviation);
        row({withUnit(oneOf(m_words.target), "mm"), oneOf(m_words.direction), oneOf(m_words.run),
             withUnit(value, valueUnit())},
            m_further, counterHeading());
        const bool byTarget = oneIn(3);
        std::size_t counter = 0;
        const auto line = [&](bool up, std::size_t j, std::size_t i) {
            row({target(i), up ? m_up : m_down, QString::number(j + 1),
                 reading((up ? m.positive : m.negative)[j], i)},
                furtherValue(), QString::number(++counter));
        };
        const std::size_t runs = m.positive.size();
        if (byTarget) {
            for (std::size_t i = 0; i < m.targets.size(); ++i) {
                for (std::size_t j = 0; j < runs; ++j) {
                    line(true, j, i);
                    line(false, j, i);
                }
            }
            return;
        }
        for (std::size_t j = 0; j < runs; ++j) {
            for (const bool up : {true, false}) {
                for (std::size_t k = 0; k < m.targets.size(); ++k)
                    line(up, j, up ? k : m.targets.size() - 1 - k);
            }
        }
    }

    /// Targets across, a run a line.
    void across() {
        m_numbered = false;
        m_furtherFirst = false;
        chooseHeadings();
        QStringList head{withUnit(oneOf(m_words.target), "mm")};
        for (std::size_t i = 0; i < m.targets.size(); ++i)
            head << target(i);
        row(head, m_further, {});
        for (std::size_t j = 0; j < m.positive.size(); ++j) {
            for (const bool up : {true, false}) {
                QStringList cells{heading(up ? m_up : m_down, j)};
                for (std::size_t i = 0; i < m.targets.size(); ++i)
                    cells << reading((up ? m.positive : m.negative)[j], i);
                row(cells, furtherValue(), {});
            }
        }
    }

    void encode() {
        if (oneIn(3))
            m_text.replace('\n', "\r\n");
        static const std::array names{"UTF-8", "UTF-8 with mark", "UTF-16", "Windows-1252"};
        std::size_t encoding = below(4);
        // Arrows are no characters of Windows-1252.
        if (encoding == 3 && m_text.contains(QRegularExpression("[^\\x{0}-\\x{ff}]")))
            encoding = 0;
        m.description += QStringLiteral(", %1").arg(names[encoding]);
        switch (encoding) {
        case 0:
            m.bytes = m_text.toUtf8();
            break;
        case 1:
            m.bytes = "\xEF\xBB\xBF" + m_text.toUtf8();
            break;
        case 2:
            m.bytes = "\xFF\xFE";
            for (const QChar c : m_text) {
                m.bytes += static_cast<char>(c.unicode() & 0xFF);
                m.bytes += static_cast<char>(c.unicode() >> 8);
            }
            break;
        default:
            m.bytes = m_text.toLatin1();
        }
    }

    std::mt19937 &m_random;
    const Vocabulary &m_words;
    WorkshopTable m;
    QString m_text;
    char m_delimiter = ';';
    bool m_comma = false;
    bool m_actual = false;
    bool m_millimetres = false;
    bool m_statesUnits = true;
    bool m_furtherFirst = false;
    bool m_numbered = false;
    std::size_t m_brackets = 0;
    int m_headingForm = 0;
    QString m_up;
    QString m_down;
    QString m_further;
    QString m_counter;
    QString m_valueWord;
    QString m_runWord;
};

} // namespace

WorkshopTable workshopTable(std::mt19937 &random) {
    return Maker(random).make();
}

PlainTable plainTable(std::mt19937 &random) {
    PlainTable table;
    const std::size_t runs = 1 + random() % 4;
    QStringList head{"Target (mm)"};
    for (std::size_t j = 0; j < 2 * runs; ++j)
        head << QString("Run %1 %2 (µm)").arg(j / 2 + 1).arg(j % 2 == 0 ? "forward" : "backward");
    table.rows.push_back(head);
    for (std::size_t i = 0; i < 4 + random() % 8; ++i) {
        QStringList row{
            QString::number(static_cast<double>(i) * 50 + static_cast<double>(random() % 99) / 100, 'f', 2)};
        for (std::size_t j = 0; j < 2 * runs; ++j)
            row << QString::number(static_cast<double>(random() % 200) / 10 - 10, 'f', 1);
        table.rows.push_back(row);
    }
    return table;
}

QByteArray randomText(std::mt19937 &random) {
    static const QStringList words{"the",  "machine", "run",  "up",  "12.03.2024", "4,5", "7", "-3.25",
                                   "Soll", "écart",   "Pos.", "100", "0",          "1e3", "X", "rev",
                                   "µm",   "(mm)",    "--",   "#",   "12:30",      "°C"};
    static const std::array delimiters{" ", ";", "\t", ",", " | "};
    QString text;
    const std::size_t lines = 1 + random() % 12;
    for (std::size_t i = 0; i < lines; ++i) {
        const QString delimiter =
            delimiters[random() % 4 == 0 ? random() % delimiters.size() : lines % delimiters.size()];
        QStringList cells;
        for (std::size_t c = 0; c < 1 + random() % 5; ++c)
            cells << words[static_cast<qsizetype>(random() % static_cast<std::size_t>(words.size()))];
        text += cells.join(delimiter) + '\n';
    }
    return text.toUtf8();
}

} // namespace palmer::testdata
