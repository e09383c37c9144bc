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

enum class Form { beside, ownAngles, list, blocks, coordinates, timed };

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
        m_form = static_cast<Form>(m_random() % 6);
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
        case Form::ownAngles:
            writeOwnAngles();
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

    void writeOwnAngles() {
        QStringList head;
        const QString angle = oneOf(m_words.angle, m_random);
        const QString what = oneOf(m_radii ? m_words.radius : m_words.deviation, m_random);
        for (const Path &path : m_table.paths)
            head << angle + ' ' + nameOf(path) + inBrackets("°")
                 << what + ' ' + nameOf(path) + inBrackets(m_unit);
        m_lines << head.join(m_delimiter);
        for (std::size_t i = 0; i < m_table.paths.front().angles.size(); ++i) {
            QStringList line;
            for (const Path &path : m_table.paths)
                line << number(path.angles[i], 3) << reading(path.deviations[i]);
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
        const bool isCommanded = m_random() % 2 == 0;
        const QString actual = isCommanded ? " act" : "";
        QStringList head{a + actual + inBrackets("mm"), b + actual + inBrackets("mm")};
        if (isCommanded)
            head << a + " cmd" + inBrackets("mm") << b + " cmd" + inBrackets("mm");
        if (m_form == Form::timed)
            head.prepend("t (s)");
        m_lines << head.join(m_delimiter);
        const Path &path = m_table.paths.front();
        for (std::size_t i = 0; i < path.angles.size(); ++i) {
            const double r = m_table.radius + path.deviations[i] / 1000;
            const double angle = path.angles[i] * degree;
            QStringList line{number(cx + r * std::cos(angle), 6), number(cy + r * std::sin(angle), 6)};
            if (isCommanded)
                line << number(cx + m_table.radius * std::cos(angle), 4)
                     << number(cy + m_table.radius * std::sin(angle), 4);
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

bool hasDoubts(const Imported &imported) {
    return std::ranges::find(imported.questions, QuestionGrade::doubtful, &Question::grade) !=
           imported.questions.end();
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

    /// Paths beside each other and below each other, with the columns and titles that people give them.
    void pathsHaveTheirOwnColumns_data() {
        QTest::addColumn<QString>("head");
        QTest::addColumn<QString>("columns"); // of each line: a angle, p q deviations ↺ ↻, b the angle of q …
        QTest::addRow("own angles") << "Angle CCW (°);Deviation CCW (µm);Angle CW (°);Deviation CW (µm)"
                                    << "apbq";
        QTest::addRow("groups") << "CCW;;CW;\nAngle (°);Deviation (µm);Angle (°);Deviation (µm)"
                                << "apbq";
        QTest::addRow("angles first") << "Angle CW (°);Angle CCW (°);CCW (µm);CW (µm)"
                                      << "bapq";
        QTest::addRow("difference") << "Angle (°);CCW (µm);CW (µm);Difference (µm)"
                                    << "apqd";
        QTest::addRow("difference of runs")
            << "Run 1 direction: CCW\nRun 2 direction: CW\nAngle (°);Run 1 (µm);Run 2 (µm);Diff. (µm)"
            << "apqd";
        QTest::addRow("mean of both") << "Angle (°);CCW (µm);CW (µm);CCW/CW (µm)"
                                      << "apqm";
        QTest::addRow("a word above both") << "Angle;Deviation;\n;CCW;CW\n°;µm;µm"
                                           << "apq";
        QTest::addRow("German") << "Winkel (°);Abweichung gegen UZS (µm);Abweichung im UZS (µm)"
                                << "apq";
        QTest::addRow("Spanish") << "Ángulo (°);Desviación antihoraria (µm);Desviación horaria (µm)"
                                 << "apq";
        QTest::addRow("Chinese") << "角度 (°);逆时针 (µm);顺时针 (µm)"
                                 << "apq";
        QTest::addRow("arrows") << "Angle (°);Dev ↺ (µm);Dev ↻ (µm)"
                                << "apq";
        QTest::addRow("short") << "ang;ccw (µm);cw (µm)"
                               << "apq";
    }
    void pathsHaveTheirOwnColumns() {
        QFETCH(QString, head);
        QFETCH(QString, columns);
        const bool hasOwn = columns.contains('b');
        QString text = "Nominal radius: 100 mm\n" + head + '\n';
        const auto there = [](double angle) { return std::round(60 * std::cos(2 * angle * degree)) / 10; };
        const auto back = [](double angle) { return std::round(50 * std::sin(angle * degree)) / 10; };
        for (int i = 0; i <= 36; ++i) {
            const int angle = 10 * i;
            const int other = hasOwn ? 360 - angle : angle;
            QStringList line;
            for (const QChar c : columns)
                line << QString::number(c == 'a'   ? angle
                                        : c == 'b' ? other
                                        : c == 'p' ? there(angle)
                                        : c == 'q' ? back(other)
                                        : c == 'd' ? there(angle) - back(angle)
                                                   : (there(angle) + back(angle)) / 2);
            text += line.join(';') + '\n';
        }
        const Imported imported = importMeasurement(text.toUtf8(), "x.csv");
        const auto &read = std::get<CircularMeasurement>(imported.test->measurement);
        QVERIFY2(!hasDoubts(imported), qPrintable(testdata::questions(imported)));
        QCOMPARE(read.arcs.size(), std::size_t{2});
        QCOMPARE(read.arcs[0].sense, Sense::counterclockwise);
        QCOMPARE(read.arcs[1].sense, Sense::clockwise);
        for (std::size_t i = 0; i <= 36; ++i) {
            QVERIFY(std::abs(read.arcs[0].radialDeviations[i] * 1000 - there(read.arcs[0].angles[i])) < 1e-6);
            QVERIFY(std::abs(read.arcs[1].radialDeviations[i] * 1000 - back(read.arcs[1].angles[i])) < 1e-6);
        }
    }

    /// No word says which path is which: each offered answer is one of the senses that they could have.
    void answersGiveTheSenses() {
        QByteArray text = "Nominal radius: 100 mm\nAngle (°);first (µm);second (µm)\n";
        for (int i = 0; i < 36; ++i)
            text += QByteArray::number(10 * i) + ';' + QByteArray::number(i % 5) + ';' +
                    QByteArray::number(i % 7) + '\n';
        const Imported asked = importMeasurement(text, "x.csv");
        const auto question = std::ranges::find_if(asked.questions, [](const Question &each) {
            return each.id == "columns" && each.grade == QuestionGrade::doubtful;
        });
        QVERIFY(question != asked.questions.end());
        QStringList senses;
        for (const std::string &answer : question->answers) {
            const Imported imported = importMeasurement(text, "x.csv", {{"columns", answer}});
            QVERIFY(!hasDoubts(imported));
            QString word;
            for (const Arc &arc : std::get<CircularMeasurement>(imported.test->measurement).arcs)
                word += arc.sense == Sense::clockwise ? '-' : '+';
            senses << word;
        }
        QCOMPARE(senses.join(' '), "+- -+ ++");
    }

    /// Paths of several feeds or planes are never one test.
    void severalTestsAreAsked_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("part");
        QTest::addColumn<QString>("read"); // plane, feed, points
        const auto lines = [](const QString &before, const QString &after, int columns = 1) {
            QString all;
            for (int i = 0; i < 36; ++i)
                all += before + QString::number(10 * i) + QString(";%1").arg(i % 5).repeated(columns) +
                       after + '\n';
            return all;
        };
        const QString head = "Nominal radius: 100 mm\nOperator: A\n";
        QTest::addRow("column of feeds")
            << head + "Angle (°);Deviation (µm);Feed (mm/min)\n" + lines({}, ";500") + lines({}, ";2000")
            << "2000"
            << "XY 2000 36";
        QTest::addRow("column of planes")
            << head + "Plane;Angle (°);Deviation (µm)\n" + lines("XY;", {}) + lines("G19;", {}) << "G19"
            << "YZ 0 36";
        QTest::addRow("feeds above") << head + "Feed: 500 mm/min\nAngle (°);Deviation (µm)\n" +
                                            lines({}, {}) +
                                            "\nFeed: 2000 mm/min\nAngle (°);Deviation (µm)\n" + lines({}, {})
                                     << "2000 mm/min"
                                     << "XY 2000 36";
        QTest::addRow("planes in headings")
            << head + "Angle (°);CCW XY (µm);CCW YZ (µm)\n" + lines({}, {}, 2) << "YZ"
            << "YZ 0 36";
        QTest::addRow("feeds in headings")
            << head + "Angle (°);CCW F500 (µm);CW F500 (µm);CCW F2000 (µm);CW F2000 (µm)\n" + lines({}, {}, 4)
            << "2000"
            << "XY 2000 72";
        const QString huge = QString(400, u'9');
        QTest::addRow("a feed that is no number")
            << head + "Angle (°);CCW F500 (µm);CCW F" + huge + " (µm)\n" + lines({}, {}, 2) << huge
            << "XY 0 36";
    }
    void severalTestsAreAsked() {
        QFETCH(QString, text);
        QFETCH(QString, part);
        QFETCH(QString, read);
        const Imported asked = importMeasurement(text.toUtf8(), "x.csv");
        QVERIFY(std::ranges::find(asked.questions, "part", &Question::id) != asked.questions.end());
        const Imported imported = importMeasurement(text.toUtf8(), "x.csv", {{"part", part.toStdString()}});
        QVERIFY2(!hasDoubts(imported), qPrintable(testdata::questions(imported)));
        QCOMPARE(imported.operatorName, "A"); // said above the first test, for all
        const auto &circle = std::get<CircularMeasurement>(imported.test->measurement);
        std::size_t points = 0;
        for (const Arc &arc : circle.arcs)
            points += arc.angles.size();
        QCOMPARE(QString::fromStdString(circle.plane.first + circle.plane.second) +
                     QString(" %1 %2").arg(circle.feed.value_or(0)).arg(points),
                 read);
        QCOMPARE(circle.nominalRadius, 100.0);
    }

    /// Readings as found and as left, beside each other or below each other, are two tests.
    void statesAreAsked_data() {
        QTest::addColumn<bool>("areBeside");
        QTest::addRow("beside") << true;
        QTest::addRow("below") << false;
    }
    void statesAreAsked() {
        QFETCH(bool, areBeside);
        QByteArray text = "Nominal radius: 100 mm\n";
        if (areBeside)
            text += "Angle (°);As found CCW (µm);As left CCW (µm)\n";
        for (const int state : {1, 2}) {
            if (areBeside && state == 2)
                break;
            if (!areBeside)
                text += state == 1 ? "As found\nAngle (°);CCW (µm)\n" : "\nAs left\nAngle (°);CCW (µm)\n";
            for (int i = 0; i < 36; ++i)
                text += QByteArray::number(10 * i) + ';' + QByteArray::number(state * (i % 5 - 2)) +
                        (areBeside ? ';' + QByteArray::number(2 * (i % 5 - 2)) + '\n' : QByteArray("\n"));
        }
        const Imported asked = importMeasurement(text, "x.csv");
        QVERIFY(std::ranges::find(asked.questions, "state", &Question::id) != asked.questions.end());
        for (const bool isLeft : {false, true}) {
            const Imported imported =
                importMeasurement(text, "x.csv", {{"state", isLeft ? "asLeft" : "asFound"}});
            QVERIFY2(!hasDoubts(imported), qPrintable(testdata::questions(imported)));
            QCOMPARE(imported.test->role, isLeft ? TestRole::asLeft : TestRole::asFound);
            const auto &read = std::get<CircularMeasurement>(imported.test->measurement);
            QCOMPARE(read.arcs.size(), std::size_t{1});
            QCOMPARE(read.arcs[0].radialDeviations[0], isLeft ? -0.004 : -0.002);
        }
    }

    /// A title that says otherwise than all columns leaves nothing to read.
    void statesThatContradictAreRefused() {
        QByteArray text = "Nominal radius: 100 mm\nAs left\nAngle CCW (°);As found CCW (µm);"
                          "Angle CW (°);As found CW (µm)\n";
        for (int i = 0; i < 36; ++i)
            text += QByteArray::number(10 * i) + ";1;" + QByteArray::number(350 - 10 * i) + ";2\n";
        for (const char *state : {"", "asFound", "asLeft"}) {
            const ImportOptions options = *state ? ImportOptions{{"state", state}} : ImportOptions{};
            QVERIFY_THROWS_EXCEPTION(Error, (void)importMeasurement(text, "x.csv", options));
        }
    }

    /// The angles of a path: those that the file says are cut off, where it starts, what they are angles of.
    void anglesAreAsStated() {
        const QByteArray head = "Nominal radius: 100 mm\n";
        const auto lines = [](int from, int to) {
            QByteArray text = "Angle (°);CCW (µm)\n";
            for (int angle = from; angle <= to; angle += 5)
                text += QByteArray::number(angle) + ';' + QByteArray::number(angle % 7) + '\n';
            return text;
        };
        const auto arcOf = [](const Imported &imported) {
            return std::get<CircularMeasurement>(imported.test->measurement).arcs.front();
        };
        const auto evaluated =
            arcOf(importMeasurement(head + "Overshoot: 45°\n" + lines(-45, 405), "x.csv")).evaluated;
        QCOMPARE(evaluated->from, 0.0);
        QCOMPARE(evaluated->to, 360.0);
        QVERIFY(!arcOf(importMeasurement(head + "Overshoot: 45°\n" + lines(0, 360), "x.csv")).evaluated);
        const Imported longer = importMeasurement(head + lines(-45, 405), "x.csv");
        QVERIFY(std::ranges::find(longer.questions, "overshoot", &Question::id) != longer.questions.end());
        QByteArray inNoOrder = "X (mm);Y (mm)\n";
        for (int i = 0; i < 50; ++i)
            inNoOrder += QByteArray::number(80 * std::cos(17 * i * i * degree), 'f', 4) + ';' +
                         QByteArray::number(80 * std::sin(17 * i * i * degree), 'f', 4) + '\n';
        const Imported points = importMeasurement(inNoOrder, "x.csv");
        QVERIFY(std::ranges::find(points.questions, "overshoot", &Question::id) == points.questions.end());
        QByteArray alone = head + "Start angle: 90°\nDeviation CCW (µm)\n";
        for (int i = 0; i <= 36; ++i)
            alone += QByteArray::number(i % 5) + '\n';
        const Imported deviations = importMeasurement(alone, "x.csv");
        QCOMPARE(arcOf(deviations).angles.front(), 90.0);
        QCOMPARE(arcOf(deviations).angles.back(), 450.0);
        const Imported commanded =
            importMeasurement(head + "Commanded angle (°)" + lines(0, 360).mid(10), "x.csv");
        QCOMPARE(arcOf(commanded).angleReference, AngleReference::commanded);
        QVERIFY(std::ranges::find(commanded.questions, "angleReference", &Question::id) ==
                commanded.questions.end());
    }

    /// A column of marks beside the points is asked for.
    void marksAreAsked() {
        QByteArray text = "Nominal radius: 100 mm\nAngle (°);CCW (µm);Valid\n";
        for (int i = 0; i < 36; ++i)
            text += QByteArray::number(10 * i) + ';' + QByteArray::number(i % 5) + (i == 7 ? ";0\n" : ";1\n");
        QVERIFY(hasDoubts(importMeasurement(text, "x.csv")));
    }

    /// Traces of controls and lists of coordinates: which columns are the circle, and about which centre.
    void coordinatesAreFound_data() {
        QTest::addColumn<QString>("head");
        QTest::addColumn<QString>("columns"); // x y actual, u v commanded, t time, c constant, i index
        QTest::addColumn<QString>("plane");
        QTest::addRow("row of units") << "Y;X\nmm;mm"
                                      << "yx"
                                      << "XY";
        QTest::addRow("desired and actual")
            << "t [s];Des_pos X1 [mm];Des_pos Y1 [mm];Act_pos X1 [mm];Act_pos Y1 [mm]"
            << "tuvxy"
            << "XY";
        QTest::addRow("command and feedback") << "Time (ms);POSF(X);POSF(Y);POS CMD(X);POS CMD(Y)"
                                              << "txyuv"
                                              << "XY";
        QTest::addRow("cmd and act") << "X_cmd (mm);Y_cmd (mm);X_act (mm);Y_act (mm)"
                                     << "uvxy"
                                     << "XY";
        QTest::addRow("Soll und Ist") << "Z soll;Z ist;X soll;X ist"
                                      << "uxvy"
                                      << "ZX";
        QTest::addRow("a third axis") << "Nr;X (mm);Y (mm);Z (mm)"
                                      << "ixcy"
                                      << "XZ";
        QTest::addRow("of two words") << "Position de l’axe X (mm);Position de l’axe Y (mm)"
                                      << "xy"
                                      << "XY";
        QTest::addRow("no words") << "Time;XPOS;YPOS"
                                  << "txy"
                                  << "XY";
        QTest::addRow("unknown word") << "X trace (mm);Y trace (mm)"
                                      << "xy"
                                      << "XY";
    }
    void coordinatesAreFound() {
        QFETCH(QString, head);
        QFETCH(QString, columns);
        QFETCH(QString, plane);
        const bool isCommanded = columns.contains('u');
        QString text = head + '\n';
        const auto deviation = [](double angle) { return 0.004 * std::cos(2 * angle * degree); };
        for (int i = 0; i <= 72; ++i) {
            const double angle = 5.0 * i;
            const double radius = 80 + deviation(angle);
            QStringList line;
            for (const QChar c : columns)
                line << (c == 't'   ? QString::number(0.01 * i)
                         : c == 'i' ? QString::number(i + 1)
                         : c == 'c' ? QString("-55.0%1").arg(i % 3)
                                    : QString::number(c == 'x'   ? 210.5 + radius * std::cos(angle * degree)
                                                      : c == 'y' ? radius * std::sin(angle * degree) - 40
                                                      : c == 'u' ? 210.5 + 80 * std::cos(angle * degree)
                                                                 : 80 * std::sin(angle * degree) - 40,
                                                      'f', 6));
            text += line.join(';') + '\n';
        }
        const Imported imported = importMeasurement(text.toUtf8(), "x.csv");
        QVERIFY2(!hasDoubts(imported), qPrintable(testdata::questions(imported)));
        QVERIFY(std::holds_alternative<CircularMeasurement>(imported.test->measurement));
        const auto &read = std::get<CircularMeasurement>(imported.test->measurement);
        QCOMPARE(QString::fromStdString(read.plane.first + read.plane.second), plane);
        QCOMPARE(read.nominalRadius, 80.0);
        QCOMPARE(read.arcs.size(), std::size_t{1});
        for (std::size_t i = 0; i < read.arcs[0].angles.size(); ++i)
            QVERIFY(std::abs(read.arcs[0].radialDeviations[i] - deviation(read.arcs[0].angles[i])) < 2e-6);
        QCOMPARE(std::ranges::find(imported.questions, "nominalRadius", &Question::id) ==
                     imported.questions.end(),
                 isCommanded);
    }

    /// Columns of one sense whose headings differ are asked about, those of several runs are not.
    void unlikePathsAreAsked_data() {
        QTest::addColumn<QString>("head");
        QTest::addColumn<bool>("isAsked");
        QTest::addRow("machines") << "CCW Machine A (µm);CCW Machine B (µm)" << true;
        QTest::addRow("radii") << "CCW R100 (µm);CCW R150 (µm)" << true;
        QTest::addRow("runs") << "CCW 1 (µm);CCW 2 (µm)" << false;
        QTest::addRow("both senses") << "Deviation CCW (µm);CW (µm)" << false;
    }
    void unlikePathsAreAsked() {
        QFETCH(QString, head);
        QFETCH(bool, isAsked);
        QByteArray text = "Nominal radius: 100 mm\nAngle (°);" + head.toUtf8() + '\n';
        for (int i = 0; i < 36; ++i)
            text += QByteArray::number(10 * i) + ';' + QByteArray::number(i % 5) + ';' +
                    QByteArray::number(i % 3) + '\n';
        QCOMPARE(hasDoubts(importMeasurement(text, "x.csv")), isAsked);
    }

    /// Two pairs of the same axes, and no word that says which was commanded: asked.
    void twoPairsOfAxesAreAsked() {
        QByteArray text = "X encoder (mm);Y encoder (mm);X scale (mm);Y scale (mm)\n";
        for (int i = 0; i < 72; ++i) {
            const QByteArray x = QByteArray::number(80 * std::cos(5 * i * degree), 'f', 5);
            const QByteArray y = QByteArray::number(80.003 * std::sin(5 * i * degree), 'f', 5);
            text += x + ';' + y + ';' + x + ';' + y + '\n';
        }
        const Imported imported = importMeasurement(text, "x.csv");
        QVERIFY(std::holds_alternative<CircularMeasurement>(imported.test->measurement));
        QVERIFY(testdata::questions(imported).contains("X scale (mm), Y scale (mm)"));
    }

    /// The radius is read in every form, and that of something else is not.
    void radiusIsRead_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<double>("radius"); // 0: asked
        const auto row = [](const char *line, double radius) {
            QTest::newRow(line) << QString(line) << radius;
        };
        row("Nominal radius (mm);120", 120);
        row("Radius;120.000;mm", 120);
        row("R = 120", 120);
        row("# Radius;120.0;mm", 120);
        row("Nominal diameter: 240 mm", 120);
        row("Durchmesser: 240,0 mm", 120);
        row("Ø240 mm, XY", 120);
        row("Ballbar length: 5 in", 127);
        row("Kreisradius: 12 cm", 120);
        row("Stylus radius: 3 mm", 0);
        row("Tool radius 5 mm, R 120 mm", 120);
        row("Radius: 1,000 mm", 0); // one, or a thousand
        row("R: 0.012 mm", 0);
    }
    void radiusIsRead() {
        QFETCH(QString, line);
        QFETCH(double, radius);
        QByteArray text = line.toUtf8() + "\nAngle (°);CCW (µm)\n";
        for (int i = 0; i < 36; ++i)
            text += QByteArray::number(10 * i) + ';' + QByteArray::number(i % 5) + '\n';
        const Imported imported = importMeasurement(text, "x.csv");
        const bool isAsked =
            std::ranges::find(imported.questions, "nominalRadius", &Question::id) != imported.questions.end();
        QCOMPARE(isAsked, radius == 0);
        if (radius > 0)
            QCOMPARE(std::get<CircularMeasurement>(imported.test->measurement).nominalRadius, radius);
    }

    /// The plane stands in a title as often as behind a label.
    void planeIsRead_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<QString>("plane");
        const auto row = [](const char *line, const char *plane) {
            QTest::newRow(line) << QString(line) << QString(plane);
        };
        row("Ballbar test YZ plane, R 150 mm, F 1000 mm/min", "YZ");
        row("Kreisformtest ZX-Ebene R 150 mm", "ZX");
        row("Circular test G19 R 150 mm", "YZ");
        row("Circle YZ R150 mm", "YZ");
        row("Plane: X1-Y1", "XY");
        row("R 150 mm", "");
    }
    void planeIsRead() {
        QFETCH(QString, line);
        QFETCH(QString, plane);
        QByteArray text = line.toUtf8() + "\nAngle (°);CCW (µm)\n";
        for (int i = 0; i < 36; ++i)
            text += QByteArray::number(10 * i) + ';' + QByteArray::number(i % 5) + '\n';
        const Imported imported = importMeasurement(text, "x.csv");
        const auto choice = std::ranges::find(imported.choices, "plane", &ImportChoice::key);
        QCOMPARE(choice->origin == Origin::guessed, plane.isEmpty());
        QCOMPARE(QString::fromStdString(choice->value), plane.isEmpty() ? QString("XY") : plane);
    }

    /// Lines of a head that each say a part, remarks behind the sign that parts the columns.
    void headsAreRead() {
        QString text = "; Trace export\n; Date: 2026-03-12 10:25\nCentre X: 30 mm\nCentre Z;-300;mm\n"
                       "X [mm];Z [mm];t [s]\n";
        for (int i = 0; i < 36; ++i)
            text += QString("%1;%2;%3\n")
                        .arg(30.1 + 80 * std::cos(10 * i * degree), 0, 'f', 5)
                        .arg(80 * std::sin(10 * i * degree) - 300, 0, 'f', 5)
                        .arg(i);
        const Imported imported = importMeasurement(text.toUtf8(), "x.csv");
        const auto &read = std::get<CircularMeasurement>(imported.test->measurement);
        QCOMPARE(imported.test->date.value_or(""), "2026-03-12");
        QVERIFY(std::abs(read.arcs[0].radialDeviations[0] - 0.1) < 1e-5);
        QVERIFY(std::abs(read.arcs[0].radialDeviations[18] + 0.1) < 1e-5);
    }

    /// "#" above the columns, with headings of several words.
    void commentsHeadColumns() {
        QString text = "#  Nom X    Nom Y    Act X    Act Y    Dev R\n";
        for (int i = 0; i < 40; ++i) {
            const double r = 80 + 0.001 * (i % 5);
            const double a = 9 * i * degree;
            text += QString("%1 %2 %3 %4 %5 %6\n")
                        .arg(i + 1)
                        .arg(80 * std::cos(a), 0, 'f', 4)
                        .arg(80 * std::sin(a), 0, 'f', 4)
                        .arg(r * std::cos(a), 0, 'f', 4)
                        .arg(r * std::sin(a), 0, 'f', 4)
                        .arg(r - 80, 0, 'f', 4);
        }
        const Imported imported = importMeasurement(text.toUtf8(), "x.txt");
        QVERIFY(std::holds_alternative<CircularMeasurement>(imported.test->measurement));
        const auto &read = std::get<CircularMeasurement>(imported.test->measurement);
        QCOMPARE(read.nominalRadius, 80.0);
        QVERIFY(std::abs(read.arcs[0].radialDeviations[4] - 0.004) < 2e-4);
        QVERIFY2(!hasDoubts(imported), qPrintable(testdata::questions(imported)));
    }

    /// A title that says more than the sense is no doubt where the angles run so.
    void titlesAgreeWithTheAngles() {
        for (const bool isRight : {true, false}) {
            QByteArray text = "Nominal radius: 100 mm\n";
            for (const int sign : {1, -1}) {
                text += (sign > 0) == isRight ? "Run 1: CCW, feed 1000 mm/min\n"
                                              : "Run 2: CW, feed 1000 mm/min\n";
                text += "Angle (°);Deviation (µm)\n";
                for (int i = 0; i < 36; ++i)
                    text += QByteArray::number(sign * i * 10) + ';' + QByteArray::number(i % 5) + '\n';
                text += '\n';
            }
            const Imported imported = importMeasurement(text, "x.csv");
            QCOMPARE(hasDoubts(imported), !isRight);
            QCOMPARE(std::get<CircularMeasurement>(imported.test->measurement).feed.value_or(0), 1000.0);
        }
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
