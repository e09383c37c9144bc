// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "editing/arctable.h"

#include "document/documenterror.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace palmer;

namespace {

constexpr double degree = std::numbers::pi / 180;

CircularMeasurement circle(double radius = 100) {
    CircularMeasurement result;
    result.plane = {"X", "Y"};
    result.nominalRadius = radius;
    return result;
}

/// Micrometres at an angle: two waves round the circle, one decimal as people write it.
double deviationAt(double angle) {
    return std::round(50 * std::cos(2 * angle * degree)) / 10;
}

QString number(double value, int decimals, char mark) {
    return QString::number(value, 'f', decimals).replace('.', mark);
}

enum class Columns { angleDeviation, angleRadius, xy };

/// A table of 72 points of a circle of radius 100 from `from` on, in steps of 5° (clockwise: −5°).
QString table(Columns columns, double step, char mark, const QString &delimiter, const QString &head = {}) {
    QString text = head;
    for (int i = 0; i < 72; ++i) {
        const double angle = step > 0 ? step * i : 360 + step * i;
        const double radius = 100 + deviationAt(angle) / 1000;
        switch (columns) {
        case Columns::angleDeviation:
            text += number(angle, 1, mark) + delimiter + number(deviationAt(angle), 1, mark);
            break;
        case Columns::angleRadius:
            text += number(angle, 1, mark) + delimiter + number(radius, 4, mark);
            break;
        case Columns::xy:
            text += number(radius * std::cos(angle * degree), 6, mark) + delimiter +
                    number(radius * std::sin(angle * degree), 6, mark);
            break;
        }
        text += '\n';
    }
    return text;
}

QString chosen(const ArcTable &table, const char *key) {
    const auto choice = std::ranges::find(table.choices, key, &ImportChoice::key);
    return choice == table.choices.end() ? QString() : QString::fromStdString(choice->value);
}

bool asks(const ArcTable &table, const char *choice) {
    return std::ranges::any_of(table.questions,
                               [&](const Question &question) { return question.id == choice; });
}

bool mentions(const ArcTable &table, const char *choice) {
    return std::ranges::any_of(table.remarks, [&](const Remark &remark) { return remark.choice == choice; });
}

} // namespace

/// Paths typed or copied from a spreadsheet become arcs.
class ArcTableTest : public QObject {
    Q_OBJECT

private slots:
    void readsAllKindsOfColumns_data() {
        QTest::addColumn<Columns>("columns");
        QTest::addColumn<double>("step");
        QTest::addColumn<char>("mark");
        QTest::addColumn<QString>("delimiter");
        QTest::addColumn<QString>("head");
        QTest::addColumn<QString>("content");
        QTest::newRow("angle and deviation, tabs and commas, with heads")
            << Columns::angleDeviation << 5.0 << ',' << "\t"
            << "Angle (°)\tÉcart (µm)\n"
            << "angleDeviation";
        QTest::newRow("angle and deviation, clockwise, semicolons")
            << Columns::angleDeviation << -5.0 << '.' << ";"
            << "angle;deviation µm\n"
            << "angleDeviation";
        QTest::newRow("angle and radius") << Columns::angleRadius << 5.0 << '.' << "\t"
                                          << "angle\tradius mm\n"
                                          << "angleRadius";
        QTest::newRow("angle and radius without a word") << Columns::angleRadius << 5.0 << ',' << "\t"
                                                         << ""
                                                         << "angleRadius";
        QTest::newRow("x and y, clockwise") << Columns::xy << -5.0 << '.' << "\t"
                                            << "x mm\ty mm\n"
                                            << "xy";
    }

    void readsAllKindsOfColumns() {
        QFETCH(Columns, columns);
        QFETCH(double, step);
        QFETCH(char, mark);
        QFETCH(QString, delimiter);
        QFETCH(QString, head);
        QFETCH(QString, content);
        const ArcTable read =
            readArcTable(table(columns, step, mark, delimiter, head).toStdString(), circle(), {});
        QCOMPARE(chosen(read, "layout"), content);
        QCOMPARE(read.arcs.size(), std::size_t{1});
        QCOMPARE(read.points, std::size_t{72});
        const Arc &arc = read.arcs.front();
        QCOMPARE(arc.sense, step > 0 ? Sense::counterclockwise : Sense::clockwise);
        for (std::size_t i = 0; i < arc.angles.size(); ++i) {
            // Six decimals of the coordinates: 1e-6 mm and its angle.
            const double angle =
                step > 0 ? step * static_cast<double>(i) : 360 + step * static_cast<double>(i);
            QVERIFY(std::abs(std::remainder(arc.angles[i] - angle, 360)) < 1e-6);
            QVERIFY(std::abs(arc.radialDeviations[i] * 1000 - deviationAt(angle)) < 2e-3);
            QVERIFY(i == 0 || (arc.angles[i] > arc.angles[i - 1]) == (step > 0));
        }
        // What the test says itself is no question of the table.
        QVERIFY(!mentions(read, "plane") && !mentions(read, "calibrated") &&
                !mentions(read, "nominalRadius"));
    }

    /// Without a word the columns are guessed: not as points of a huge circle, and never in silence.
    void whatIsGuessedIsAsked() {
        const std::string text = table(Columns::angleDeviation, 5, ',', "\t").toStdString() + "365\tn/a\n";
        ImportOptions choices;
        const auto ids = [&] {
            QStringList found;
            for (const Question &question : readArcTable(text, circle(), choices).questions)
                found << QString::fromStdString(question.id);
            found.sort();
            return found.join(' ');
        };
        const ArcTable read = readArcTable(text, circle(), choices);
        QCOMPARE(chosen(read, "layout"), "angleDeviation");
        QCOMPARE(read.arcs.at(0).radialDeviations.at(1), deviationAt(5) / 1000);
        QCOMPARE(ids(), QString("layout positionUnit unit unread"));
        choices = {
            {"layout", "angleDeviation"}, {"unit", "mm"}, {"positionUnit", "deg"}, {"unread", "leave"}};
        QCOMPARE(ids(), QString("large"));
        choices["large"] = "keep";
        QCOMPARE(ids(), QString());
    }

    void whatWasWrittenIsTakenToTheLastBit() {
        QString text = "angle °\tdeviation µm\n";
        for (int i = 0; i < 3000; ++i)
            text += QString("%1\t%2\n").arg(i * 0.1, 0, 'f', 1).arg(i * 0.01 - 15, 0, 'f', 2);
        const ArcTable read = readArcTable(text.toStdString(), circle(), {});
        for (int i = 0; i < 3000; ++i) {
            QCOMPARE(read.arcs.at(0).radialDeviations.at(std::size_t(i)),
                     QString::number(i - 1500).toDouble() / 100'000); // one division: the nearest double
            QCOMPARE(read.arcs.at(0).angles.at(std::size_t(i)), i / 10.0);
        }
    }

    void deviationsAloneStandAtEqualSteps() {
        QString text = "Δr µm\n";
        for (int i = 0; i <= 36; ++i)
            text += number(deviationAt(10 * i), 1, '.') + '\n';
        ImportOptions choices;
        ArcTable read = readArcTable(text.toStdString(), circle(), choices);
        QCOMPARE(chosen(read, "layout"), "deviations");
        QCOMPARE(read.arcs.at(0).angles.front(), 0.0);
        QCOMPARE(read.arcs.at(0).angles.back(), 360.0);
        QCOMPARE(read.arcs.at(0).angles.at(9), 90.0);
        QCOMPARE(read.arcs.at(0).radialDeviations.at(9), deviationAt(90) / 1000);
        QVERIFY(asks(read, "startAngle") && !asks(read, "unit"));
        choices = {{"startAngle", "0"}};
        QVERIFY(asks(readArcTable(text.toStdString(), circle(), choices), "arc")); // and with it the sense
        choices = {{"startAngle", "180"}, {"arc", "-90"}, {"unit", "mm"}, {"angleReference", "commanded"}};
        read = readArcTable(text.toStdString(), circle(), choices);
        const Arc &arc = read.arcs.at(0);
        QCOMPARE(arc.angles.front(), 180.0);
        QCOMPARE(arc.angles.back(), 90.0);
        QCOMPARE(arc.radialDeviations.at(9), deviationAt(90));
        QCOMPARE(arc.angleReference, AngleReference::commanded);
        QVERIFY(!asks(read, "startAngle") && !asks(read, "arc"));
    }

    void aMissingPointOfDeviationsAloneIsRefused() {
        QVERIFY_THROWS_EXCEPTION(Error, (void)readArcTable("µm\n1.5\nn/a\n2.5\n3\n", circle(), {}));
    }

    /// The sense of the heading is proposed; the extent and the sign that are chosen win.
    void theExtentSaysTheSense() {
        const auto angles = [](const char *text, const ImportOptions &answers,
                               const ImportOptions &usual = {}) {
            return readArcTable(text, circle(), answers, std::nullopt, usual).arcs.at(0).angles;
        };
        const char *plain = "Δr µm\n1\n2\n3\n";
        const char *clockwise = "CW µm\n1\n2\n3\n";
        const ImportOptions start{{"startAngle", "10"}, {"layout", "deviations"}};
        ImportOptions chosen = start;
        QCOMPARE(angles(plain, start, {{"arc", "90.5"}}), (std::vector<double>{10, 55.25, 100.5}));
        QCOMPARE(angles(clockwise, start), (std::vector<double>{10, -170, -350}));
        chosen["arc"] = "180";
        QCOMPARE(angles(clockwise, chosen), (std::vector<double>{10, 100, 190}));
        for (const char *beyond : {"0", "1e9"}) {
            chosen["arc"] = beyond;
            QVERIFY_THROWS_EXCEPTION(Error, (void)readArcTable(plain, circle(), chosen));
        }
    }

    void aRunWithoutReadingsIsRefused() {
        QVERIFY_THROWS_EXCEPTION(Error, (void)readArcTable("Run;Angle (°)\n1;0\n1;10\n1;20\n", circle()));
    }

    void theSenseChosenTurnsTheOrder() {
        const ArcTable read =
            readArcTable(table(Columns::angleDeviation, 5, '.', "\t", "angle\tdeviation µm\n").toStdString(),
                         circle(), {}, Sense::clockwise);
        const Arc &arc = read.arcs.at(0);
        QCOMPARE(arc.sense, Sense::clockwise);
        QCOMPARE(arc.angles.front(), 355.0);
        QCOMPARE(arc.angles.back(), 0.0);
        QCOMPARE(arc.radialDeviations.front(), deviationAt(355) / 1000);
    }

    void twoColumnsOfPathsAreTwoArcs() {
        QString text = "angle\tCW µm\tCCW µm\n";
        for (int i = 0; i < 36; ++i)
            text += QString("%1\t%2\t%3\n").arg(10 * i).arg(i * 0.1).arg(-i * 0.1);
        const ArcTable read = readArcTable(text.toStdString(), circle(), {});
        QCOMPARE(read.arcs.size(), std::size_t{2});
        QCOMPARE(read.arcs[0].sense, Sense::clockwise);
        QCOMPARE(read.arcs[1].sense, Sense::counterclockwise);
        QCOMPARE(read.arcs[1].radialDeviations[10], -0.001);
    }

    void theRadiusOfTheTestIsTheNominalOne() {
        const ArcTable read = readArcTable(
            table(Columns::angleRadius, 5, '.', "\t", "angle\tradius mm\n").toStdString(), circle(99.99), {});
        QVERIFY(std::abs(read.arcs.at(0).radialDeviations[0] - (deviationAt(0) / 1000 + 0.01)) < 1e-9);
    }

    void theCommaIsNeverASeparatorOfThousands() {
        const ImportOptions choices{{"decimalMark", "comma"}};
        const ArcTable read =
            readArcTable(table(Columns::angleDeviation, 5, ',', "\t", "angle\tdeviation µm\n").toStdString(),
                         circle(), choices);
        QCOMPARE(read.arcs.at(0).radialDeviations[1], deviationAt(5) / 1000);
    }

    void textThatIsNoTableIsRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("nothing") << "";
        QTest::newRow("words") << "no numbers here\nnor here\n";
        QTest::newRow("one point") << "x\ty\n1\t2\n";
    }
    void textThatIsNoTableIsRefused() {
        QFETCH(QString, text);
        const ImportOptions choices{{"layout", "xy"}};
        QVERIFY_THROWS_EXCEPTION(Error, (void)readArcTable(text.toStdString(), circle(), choices));
    }
};

QTEST_GUILESS_MAIN(ArcTableTest)
#include "arctable.moc"
