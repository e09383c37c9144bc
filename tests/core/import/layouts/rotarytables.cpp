// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "import/importmeasurement.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace palmer;

namespace {

using Random = std::mt19937;

template <class List>
const auto &oneOf(const List &list, Random &random) {
    return list[static_cast<typename List::size_type>(random() % static_cast<unsigned>(list.size()))];
}

struct Vocabulary {
    QStringList target;
    QList<std::pair<QString, QString>> directions; ///< ↑, ↓
    QStringList run;
    QStringList deviation;
    QStringList actual;
};

const QList<Vocabulary> vocabularies{
    {{"Target", "Target position", "Angle", "Nominal angle", "Angular position", "C", "Table angle"},
     {{"forward", "backward"}, {"CW", "CCW"}, {"+", "-"}, {"↑", "↓"}, {"clockwise", "counterclockwise"}},
     {"Run", "Cycle"},
     {"Deviation", "Error", "Angular error", "Dev"},
     {"Actual", "Measured", "Measured angle"}},
    {{"Cible", "Position cible", "Angle", "Angle visé", "Position angulaire"},
     {{"aller", "retour"}, {"horaire", "antihoraire"}, {"+", "-"}, {"↑", "↓"}},
     {"Cycle", "Passe"},
     {"Écart", "Erreur", "Écart angulaire"},
     {"Mesuré", "Angle mesuré", "Position réelle"}},
    {{"Sollposition", "Soll", "Sollwinkel", "Winkel", "Winkelposition"},
     {{"vorwärts", "rückwärts"}, {"+", "-"}, {"↑", "↓"}},
     {"Lauf", "Messreihe"},
     {"Abweichung", "Fehler", "Winkelabweichung"},
     {"Ist", "Istwert", "Istwinkel"}},
};

struct UnitOfTable {
    QString sign;
    double ofArcSecond = 1;
};
const QList<UnitOfTable> units{
    {"\"", 1},
    {"″", 1},
    {"arcsec", 1},
    {"arc sec", 1},
    {"°", 1 / 3600.0},
    {"deg", 1 / 3600.0},
    {"mdeg", 1 / 3.6},
    {"arcmin", 1 / 60.0},
    {"µrad", std::numbers::pi / 180 / 3600 * 1e6},
};

enum class Form { down, across, list, blocks };

/// A table of a rotary axis and what it says.
struct RotaryTable {
    QByteArray bytes;
    std::vector<double> targets;               ///< degrees
    std::vector<std::vector<double>> positive; ///< arc seconds
    std::vector<std::vector<double>> negative;
};

class Writer {
public:
    explicit Writer(Random &random)
        : m_random(random)
        , m_words(oneOf(vocabularies, random))
        , m_names(oneOf(m_words.directions, random))
        , m_form(static_cast<Form>(random() % 4)) {}

    RotaryTable write() {
        m_isActual = m_random() % 5 == 0;
        m_unit = m_isActual ? units[m_random() % 2 == 0 ? 4 : 5] : oneOf(units, m_random);
        m_comma = m_random() % 2 == 0;
        m_delimiter =
            oneOf(m_comma ? QStringList{";", "\t", "|"} : QStringList{";", "\t", "|", ","}, m_random);
        m_target = oneOf(m_words.target, m_random) + oneOf(QStringList{" (°)", " [deg]", " (deg)"}, m_random);
        m_reading = oneOf(m_isActual ? m_words.actual : m_words.deviation, m_random);
        m_run = oneOf(m_words.run, m_random);
        m_style = static_cast<int>(m_random() % 3);
        measure();
        if (m_random() % 3 == 0)
            m_lines << "Axis: C";
        switch (m_form) {
        case Form::down:
            writeDown();
            break;
        case Form::across:
            writeAcross();
            break;
        case Form::list:
            writeList();
            break;
        case Form::blocks:
            writeBlock(m_table.positive, m_names.first);
            m_lines << QString();
            writeBlock(m_table.negative, m_names.second);
            break;
        }
        m_table.bytes = (m_lines.join('\n') + '\n').toUtf8();
        return m_table;
    }

private:
    void measure() {
        const int count = std::array{7, 9, 13, 37}[m_random() % 4];
        const double span = std::array{360.0, 360.0, 330.0, 720.0, 90.0}[m_random() % 5];
        const double first = std::array{0.0, 0.0, -90.0, 15.0}[m_random() % 4];
        for (int i = 0; i < count; ++i)
            m_table.targets.push_back(std::round((first + span * i / (count - 1)) * 1000) / 1000);
        const auto runs = 1 + m_random() % 4;
        for (auto *side : {&m_table.positive, &m_table.negative}) {
            for (unsigned run = 0; run < runs; ++run) {
                side->emplace_back();
                for (int i = 0; i < count; ++i)
                    side->back().push_back(static_cast<int>(m_random() % 200) / 100.0 - 1 + 0.02 * i +
                                           (side == &m_table.negative ? 3 : 0));
            }
        }
    }

    [[nodiscard]] QString number(double value, int decimals) const {
        QString text = QString::number(value, 'f', decimals);
        return m_comma ? text.replace('.', ',') : text;
    }
    [[nodiscard]] QString reading(std::size_t i, double arcSeconds) const {
        return m_isActual ? number(m_table.targets[i] + arcSeconds / 3600, 8)
                          : number(arcSeconds * m_unit.ofArcSecond, 8);
    }
    [[nodiscard]] QString inUnit(const QString &words) const { return words + " (" + m_unit.sign + ')'; }
    [[nodiscard]] QString headOf(std::size_t run, const QString &direction) const {
        const QString number = QString::number(run + 1);
        return inUnit(m_style == 0   ? m_run + ' ' + number + ' ' + direction
                      : m_style == 1 ? m_reading + ' ' + number + ' ' + direction
                                     : m_reading + ' ' + direction + ' ' + number);
    }

    /// ↑1 ↓1 ↑2 …
    template <class Visit>
    void eachRun(const Visit &visit) const {
        for (std::size_t run = 0; run < m_table.positive.size(); ++run) {
            visit(run, m_names.first, m_table.positive[run]);
            visit(run, m_names.second, m_table.negative[run]);
        }
    }

    void writeDown() {
        QStringList head{m_target};
        eachRun(
            [&](std::size_t run, const QString &direction, const auto &) { head << headOf(run, direction); });
        m_lines << head.join(m_delimiter);
        for (std::size_t i = 0; i < m_table.targets.size(); ++i) {
            QStringList line{number(m_table.targets[i], 3)};
            eachRun([&](std::size_t, const QString &, const auto &values) { line << reading(i, values[i]); });
            m_lines << line.join(m_delimiter);
        }
    }

    void writeAcross() {
        QStringList head{m_target};
        for (const double target : m_table.targets)
            head << number(target, 3);
        m_lines << head.join(m_delimiter);
        eachRun([&](std::size_t run, const QString &direction, const auto &values) {
            QStringList line{headOf(run, direction)};
            for (std::size_t i = 0; i < values.size(); ++i)
                line << reading(i, values[i]);
            m_lines << line.join(m_delimiter);
        });
    }

    void writeList() {
        m_lines << QStringList{m_target, inUnit(m_reading), "Direction", m_run}.join(m_delimiter);
        eachRun([&](std::size_t run, const QString &direction, const auto &values) {
            const bool back = direction == m_names.second;
            for (std::size_t k = 0; k < values.size(); ++k) {
                const std::size_t i = back ? values.size() - 1 - k : k;
                m_lines << QStringList{number(m_table.targets[i], 3), reading(i, values[i]), direction,
                                       QString::number(run + 1)}
                               .join(m_delimiter);
            }
        });
    }

    void writeBlock(const std::vector<std::vector<double>> &runs, const QString &direction) {
        m_lines << direction;
        QStringList head{m_target};
        for (std::size_t run = 0; run < runs.size(); ++run)
            head << inUnit(m_run + ' ' + QString::number(run + 1));
        m_lines << head.join(m_delimiter);
        for (std::size_t i = 0; i < m_table.targets.size(); ++i) {
            QStringList line{number(m_table.targets[i], 3)};
            for (const auto &values : runs)
                line << reading(i, values[i]);
            m_lines << line.join(m_delimiter);
        }
    }

    Random &m_random;
    const Vocabulary &m_words;
    const std::pair<QString, QString> &m_names;
    Form m_form;
    RotaryTable m_table;
    UnitOfTable m_unit;
    bool m_isActual = false;
    bool m_comma = false;
    int m_style = 0;
    QString m_delimiter;
    QString m_target;
    QString m_reading;
    QString m_run;
    QStringList m_lines;
};

/// What differs from the truth; empty: nothing.
QString differenceOf(const Imported &imported, const RotaryTable &table) {
    const auto *read =
        imported.test ? std::get_if<PositioningMeasurement>(&imported.test->measurement) : nullptr;
    if (!read || read->axis.motion != Motion::rotary)
        return "no test of a rotary axis";
    if (read->targets != table.targets)
        return QString("%1 targets").arg(read->targets.size());
    if (read->runs.size() != table.positive.size() + table.negative.size())
        return QString("%1 runs").arg(read->runs.size());
    std::size_t up = 0;
    std::size_t down = 0;
    for (const Run &run : read->runs) {
        const bool positive = run.approach == Direction::positive;
        const auto &side = positive ? table.positive : table.negative;
        std::size_t &next = positive ? up : down;
        if (next >= side.size())
            return "directions";
        for (std::size_t i = 0; i < table.targets.size(); ++i) {
            // Eight decimals of a degree are written.
            if (!run.deviations[i] || std::abs(*run.deviations[i] - side[next][i] / 3600) > 1e-8)
                return QString("run %1, %2″ as %3°")
                    .arg(next)
                    .arg(side[next][i])
                    .arg(run.deviations[i].value_or(NAN));
        }
        ++next;
    }
    return {};
}

} // namespace

/// Random tables of rotary axes with known truth.
class RotaryTablesTest : public QObject {
    Q_OBJECT

private slots:
    void areReadRight_data() {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1U, 2U, 3U})
            QTest::addRow("seed %u", seed) << seed;
    }
    void areReadRight() {
        QFETCH(unsigned, seed);
        Random random(seed);
        for (int i = 0; i < 300; ++i) {
            const RotaryTable table = Writer(random).write();
            QString outcome;
            try {
                const Imported imported = importMeasurement(table.bytes, "x.csv");
                outcome = differenceOf(imported, table);
                if (!outcome.isEmpty())
                    outcome += '\n' + testdata::questions(imported);
            } catch (const Error &error) {
                outcome = Language(Language::Id::english).sentence(error.message);
            }
            QVERIFY2(outcome.isEmpty(),
                     qPrintable(QString("table %1: %2\n%3")
                                    .arg(i)
                                    .arg(outcome, QString::fromUtf8(table.bytes.left(700)))));
        }
    }
};

QTEST_GUILESS_MAIN(RotaryTablesTest)
#include "rotarytables.moc"
