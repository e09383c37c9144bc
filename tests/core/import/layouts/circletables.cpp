// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "import/importmeasurement.h"
#include "kernel/numerics/angles.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace palmer;

namespace {

using Random = std::mt19937;

const QString &oneOf(const QStringList &words, Random &random) {
    return words[static_cast<qsizetype>(random() % static_cast<unsigned>(words.size()))];
}

struct Vocabulary {
    QStringList angle;
    QStringList deviation;
    QStringList radius;
    QList<std::pair<QString, QString>> senses; ///< counterclockwise, clockwise
    QStringList sense;                         ///< heading of a column of them
    QString nominal;                           ///< radius, above the table
};

const std::array vocabularies{
    Vocabulary{
        {"Angle", "Angular position", "Polar angle", "Theta"},
        {"Radial deviation", "Deviation", "Radius error"},
        {"Radius", "Measured radius", "R"},
        {{"CCW", "CW"}, {"counterclockwise", "clockwise"}, {"Counter-clockwise", "Clockwise"}, {"G3", "G2"}},
        {"Direction", "Sense"},
        "Nominal radius"},
    Vocabulary{{"Angle", "Position angulaire", "Angle polaire"},
               {"Écart radial", "Écart de rayon", "Écart"},
               {"Rayon", "Rayon mesuré"},
               {{"antihoraire", "horaire"},
                {"sens antihoraire", "sens horaire"},
                {"sens trigonométrique", "sens horaire"},
                {"sens trigonométrique", "sens trigonométrique inverse"},
                {"G03", "G02"}},
               {"Sens"},
               "Rayon nominal"},
    Vocabulary{{"Winkel", "Winkelposition"},
               {"Radiale Abweichung", "Radialabweichung", "Abweichung"},
               {"Radius", "Gemessener Radius"},
               {{"gegen Uhrzeigersinn", "im Uhrzeigersinn"},
                {"linksdrehend", "rechtsdrehend"},
                {"Linkslauf", "Rechtslauf"},
                {"ccw", "cw"}},
               {"Richtung", "Drehrichtung"},
               "Nennradius"},
};

enum class Form { beside, list, blocks, coordinates, timed };

struct Path {
    Sense sense = Sense::counterclockwise;
    std::vector<double> angles;     ///< degrees, as they are driven
    std::vector<double> deviations; ///< µm, hundredths
};

/// A table of a circular test and what it says.
struct CircleTable {
    QByteArray bytes;
    double radius = 0;
    bool showsRadius = false;
    bool showsCentre = true;
    std::vector<Path> paths;
};

class Writer {
public:
    explicit Writer(Random &random)
        : m_random(random)
        , m_words(vocabularies[random() % vocabularies.size()]) {}

    CircleTable write() {
        m_form = static_cast<Form>(m_random() % 5);
        m_comma = m_random() % 2 == 0;
        m_delimiter =
            oneOf(m_comma ? QStringList{";", "\t", "|"} : QStringList{";", "\t", "|", ","}, m_random);
        m_names =
            m_words.senses[static_cast<qsizetype>(m_random() % static_cast<unsigned>(m_words.senses.size()))];
        m_table.radius = std::array{50.0, 100.0, 150.0, 150.0, 300.0}[m_random() % 5];
        m_isXy = m_form == Form::coordinates || m_form == Form::timed;
        m_radii = m_isXy || m_random() % 3 == 0;
        m_unit = m_radii ? "mm" : oneOf({"µm", "mm", "um"}, m_random);
        drive();
        writeTitle();
        switch (m_form) {
        case Form::beside:
            writeBeside();
            break;
        case Form::list:
            writeList();
            break;
        case Form::blocks:
            writeBlocks();
            break;
        case Form::coordinates:
        case Form::timed:
            writeCoordinates();
            break;
        }
        m_table.bytes = (m_lines.join('\n') + '\n').toUtf8();
        return m_table;
    }

private:
    void drive() {
        const int points = std::array{36, 72, 120, 360}[m_random() % 4];
        const int all = points + static_cast<int>(m_random() % 2); // the first one again at the end
        const double first = std::array{0.0, 0.0, 90.0, 180.0, -45.0}[m_random() % 5];
        const bool both = m_form != Form::timed && m_form != Form::coordinates && m_random() % 3 > 0;
        const int only = m_random() % 2 == 0 ? 1 : -1;
        for (const int sign : both ? std::vector{1, -1} : std::vector{only}) {
            Path path;
            path.sense = sign > 0 ? Sense::counterclockwise : Sense::clockwise;
            const double size = std::uniform_real_distribution(-8.0, 8.0)(m_random);
            for (int i = 0; i < all; ++i) {
                const int step = both && m_form == Form::beside && sign < 0 ? all - 1 - i : sign * i;
                path.angles.push_back(first + 360.0 * step / points);
                path.deviations.push_back(
                    std::round(100 * (size * std::cos(2 * path.angles.back() * degree) + 1.5)) / 100 +
                    static_cast<int>(m_random() % 7) / 100.0);
            }
            m_table.paths.push_back(path);
        }
    }

    [[nodiscard]] QString number(double value, int decimals) const {
        QString text = QString::number(value, 'f', decimals);
        return m_comma ? text.replace('.', ',') : text;
    }

    [[nodiscard]] QString reading(double micrometres) const {
        return m_unit != "mm" ? number(micrometres, 2)
                              : number((m_radii ? m_table.radius : 0) + micrometres / 1000, 5);
    }

    [[nodiscard]] QString inBrackets(const QString &unit) const { return " (" + unit + ')'; }

    [[nodiscard]] const QString &nameOf(const Path &path) const {
        return path.sense == Sense::counterclockwise ? m_names.first : m_names.second;
    }

    void writeTitle() {
        m_table.showsRadius = m_radii || m_random() % 2 == 0;
        if (m_table.showsRadius)
            m_lines << QStringLiteral("%1: %2 mm").arg(m_words.nominal).arg(m_table.radius);
    }

    void writeBeside() {
        QStringList head{oneOf(m_words.angle, m_random) + inBrackets(oneOf({"°", "deg"}, m_random))};
        const QString what = oneOf(m_radii ? m_words.radius : m_words.deviation, m_random);
        for (const Path &path : m_table.paths)
            head << what + ' ' + nameOf(path) + inBrackets(m_unit);
        m_lines << head.join(m_delimiter);
        const Path &first = m_table.paths.front();
        const std::size_t count = first.angles.size();
        for (std::size_t i = 0; i < count; ++i) {
            QStringList line{number(first.angles[i], 3), reading(first.deviations[i])};
            if (m_table.paths.size() > 1) // the way back stands at the same angles
                line << reading(m_table.paths.back().deviations[count - 1 - i]);
            m_lines << line.join(m_delimiter);
        }
    }

    void writeList() {
        m_lines << QStringList{oneOf(m_words.angle, m_random) + inBrackets("°"),
                               oneOf(m_radii ? m_words.radius : m_words.deviation, m_random) +
                                   inBrackets(m_unit),
                               oneOf(m_words.sense, m_random)}
                       .join(m_delimiter);
        for (const Path &path : m_table.paths) {
            for (std::size_t i = 0; i < path.angles.size(); ++i)
                m_lines << QStringList{number(path.angles[i], 3), reading(path.deviations[i]), nameOf(path)}
                               .join(m_delimiter);
        }
    }

    void writeBlocks() {
        const QString head =
            QStringList{oneOf(m_words.angle, m_random) + inBrackets("°"),
                        oneOf(m_radii ? m_words.radius : m_words.deviation, m_random) + inBrackets(m_unit)}
                .join(m_delimiter);
        for (const Path &path : m_table.paths) {
            m_lines << nameOf(path) << head;
            for (std::size_t i = 0; i < path.angles.size(); ++i)
                m_lines << number(path.angles[i], 3) + m_delimiter + reading(path.deviations[i]);
            m_lines << QString();
        }
    }

    void writeCoordinates() {
        const auto [a, b] =
            std::array<std::pair<QString, QString>, 3>{{{"X", "Y"}, {"X", "Z"}, {"Y", "Z"}}}[m_random() % 3];
        m_table.showsCentre = m_random() % 2 == 0;
        const double cx = m_table.showsCentre ? 0 : 250;
        const double cy = m_table.showsCentre ? 0 : -120.5;
        QStringList head{a + inBrackets("mm"), b + inBrackets("mm")};
        if (m_form == Form::timed)
            head.prepend("t (s)");
        m_lines << head.join(m_delimiter);
        const Path &path = m_table.paths.front();
        for (std::size_t i = 0; i < path.angles.size(); ++i) {
            const double r = m_table.radius + path.deviations[i] / 1000;
            const double angle = path.angles[i] * degree;
            QStringList line{number(cx + r * std::cos(angle), 6), number(cy + r * std::sin(angle), 6)};
            if (m_form == Form::timed)
                line.prepend(number(0.02 * static_cast<double>(i), 2));
            m_lines << line.join(m_delimiter);
        }
    }

    Random &m_random;
    const Vocabulary &m_words;
    CircleTable m_table;
    Form m_form = Form::beside;
    bool m_comma = false;
    bool m_radii = false;
    bool m_isXy = false;
    QString m_delimiter;
    QString m_unit;
    std::pair<QString, QString> m_names;
    QStringList m_lines;
};

/// What differs from the truth; empty: nothing.
QString differenceOf(const Imported &imported, const CircleTable &table, double accuracy) {
    const auto *read =
        imported.test ? std::get_if<CircularMeasurement>(&imported.test->measurement) : nullptr;
    if (!read)
        return "no circular test";
    if (read->arcs.size() != table.paths.size())
        return QString("%1 arcs").arg(read->arcs.size());
    if (table.showsRadius && read->nominalRadius != table.radius)
        return QString("R %1").arg(read->nominalRadius);
    for (const Path &path : table.paths) {
        const auto arc = std::ranges::find(read->arcs, path.sense, &Arc::sense);
        if (arc == read->arcs.end())
            return "senses";
        if (arc->angles.size() != path.angles.size())
            return QString("%1 points of %2").arg(arc->angles.size()).arg(path.angles.size());
        for (std::size_t i = 0; i < path.angles.size(); ++i) {
            if (std::abs(std::remainder(arc->angles[i] - path.angles[i], 360)) > 6e-4)
                return QString("angle %1 as %2").arg(path.angles[i]).arg(arc->angles[i]);
            if (std::abs(arc->radialDeviations[i] - path.deviations[i] / 1000) > accuracy)
                return QString("%1 µm as %2 mm").arg(path.deviations[i]).arg(arc->radialDeviations[i]);
        }
    }
    return {};
}

} // namespace

/// Random tables of circles with known truth.
class CircleTablesTest : public QObject {
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
            const CircleTable table = Writer(random).write();
            ImportOptions options;
            if (!table.showsRadius)
                options["nominalRadius"] = QString::number(table.radius).toStdString();
            // Angles have three decimals, coordinates six: 1 nm where they are written so.
            const Imported imported = importMeasurement(table.bytes, "x.csv", options);
            const QString difference = differenceOf(imported, table, 1.5e-6);
            QVERIFY2(difference.isEmpty(), qPrintable(QString("table %1: %2\n%3\n%4")
                                                          .arg(i)
                                                          .arg(difference, testdata::questions(imported),
                                                               QString::fromUtf8(table.bytes.left(600)))));
        }
    }

    /// The words of one sense, or of both, are such that no dictionary has: no point is lost, and it is
    /// asked.
    void unknownWordsOfSenseLoseNothing_data() {
        QTest::addColumn<QString>("there");
        QTest::addColumn<QString>("back");
        QTest::addRow("both unknown") << "vinstri"
                                      << "hægri";
        QTest::addRow("the first unknown") << "vinstri"
                                           << "CW";
        QTest::addRow("the second unknown") << "CCW"
                                            << "hægri";
    }
    void unknownWordsOfSenseLoseNothing() {
        QFETCH(QString, there);
        QFETCH(QString, back);
        for (const bool closed : {false, true}) {
            QByteArray text = "Nominal radius: 100 mm\nAngle (°);Radius (mm);Sense\n";
            CircleTable table;
            table.radius = 100;
            table.showsRadius = true;
            for (const int sign : {1, -1}) {
                Path path;
                path.sense = sign > 0 ? Sense::counterclockwise : Sense::clockwise;
                for (int i = 0; i < 36 + (closed ? 1 : 0); ++i) {
                    path.angles.push_back(sign * i * 10);
                    path.deviations.push_back(i % 7 - sign);
                    text += QString("%1;%2;%3\n")
                                .arg(sign * i * 10)
                                .arg(100 + path.deviations.back() / 1000, 0, 'f', 3)
                                .arg(sign > 0 ? there : back)
                                .toUtf8();
                }
                table.paths.push_back(path);
            }
            const Imported imported = importMeasurement(text, "x.csv");
            QCOMPARE(differenceOf(imported, table, 1e-9), QString());
            QVERIFY(std::ranges::find(imported.questions, "columns", &Question::id) !=
                    imported.questions.end());
            QCOMPARE(imported.columns.back().role, ColumnRole::direction);
            // Chosen columns may say nothing of the one of senses.
            for (const char *columns : {"angle,radius", "angle,radius,direction"})
                QCOMPARE(differenceOf(importMeasurement(text, "x.csv", {{"columns", columns}}), table, 1e-9),
                         QString());
        }
    }

    /// Each run is an arc of its own, whether or not a column says the sense.
    void runsArePaths_data() {
        QTest::addColumn<QString>("head");
        QTest::addColumn<bool>("radii");
        QTest::addRow("with senses") << "Angle (°);Deviation (µm);Sense;Run" << false;
        QTest::addRow("one sense") << "Angle (°);Radius (mm);Run" << true;
        QTest::addRow("the run first") << "Run;Angle (°);Deviation (µm)" << false;
    }
    void runsArePaths() {
        QFETCH(QString, head);
        QFETCH(bool, radii);
        QString text = "Nominal radius: 100 mm\n" + head + '\n';
        const bool senses = head.contains("Sense");
        for (int run = 1; run <= 4; ++run) {
            const bool clockwise = senses && run % 2 == 0;
            for (int i = 0; i <= 36; ++i) {
                QStringList line{QString::number(clockwise ? -10 * i : 10 * i),
                                 radii ? QString::number(100 + run / 1000.0, 'f', 3) : QString::number(run)};
                if (senses)
                    line << (clockwise ? "CW" : "CCW");
                line.insert(head.startsWith("Run") ? 0 : line.size(), QString::number(run));
                text += line.join(';') + '\n';
            }
        }
        const Imported imported = importMeasurement(text.toUtf8(), "x.csv");
        const auto &read = std::get<CircularMeasurement>(imported.test->measurement);
        QCOMPARE(read.arcs.size(), std::size_t{4});
        for (std::size_t k = 0; k < read.arcs.size(); ++k) {
            QCOMPARE(read.arcs[k].sense, senses && k % 2 == 1 ? Sense::clockwise : Sense::counterclockwise);
            QCOMPARE(read.arcs[k].angles.size(), std::size_t{37});
            QVERIFY(std::abs(read.arcs[k].radialDeviations.front() - static_cast<double>(k + 1) / 1000) <
                    1e-9);
        }
        QVERIFY(std::ranges::find(imported.columns, ColumnRole::number, &ImportColumn::role) !=
                imported.columns.end());
    }

    /// Lengths at angles are no rotary axis: without a word of a circle it is asked.
    void lengthsAtAnglesAreACircle() {
        QByteArray text = "Angular position (°);Deviation (µm)\n";
        for (int i = 0; i < 36; ++i)
            text += QByteArray::number(10 * i) + ';' + QByteArray::number(i % 5) + '\n';
        const Imported imported = importMeasurement(text, "x.csv");
        QVERIFY(std::holds_alternative<CircularMeasurement>(imported.test->measurement));
        QVERIFY(std::ranges::find(imported.questions, "kind", &Question::id) != imported.questions.end());
        // Deviations in angles, or directions of approach, are of a rotary axis.
        for (const char *head : {"Angular position (°);Deviation (\")\n", "Angle (°);Deviation ↑ (µm)\n"}) {
            const QByteArray rotary = head + text.mid(text.indexOf('\n') + 1);
            QVERIFY(std::holds_alternative<PositioningMeasurement>(
                importMeasurement(rotary, "x.csv").test->measurement));
        }
    }
};

QTEST_GUILESS_MAIN(CircleTablesTest)
#include "circletables.moc"
