#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "export/partprogram.h"

#include "kernel/planning/targetplan.h"

#include <QRegularExpression>
#include <QTest>

using namespace palmer;

Q_DECLARE_METATYPE(Dialect)

namespace {

CycleProgram small() {
    CycleProgram program;
    program.targets = {-5, 0.25};
    program.runs = 1;
    program.feed = 2000;
    program.dwell = 4;
    program.approach = 2;
    return program;
}

/// Catalogues are there from main() on.
Language english() {
    return Language(Language::Id::english);
}

/// The positions a program moves to and the rests it makes (as NaN), whatever the dialect.
struct Walk {
    std::vector<double> positions;
    std::vector<double> rests; ///< positions of the dwells
};

Walk walk(const QByteArray &program, Dialect dialect) {
    const QRegularExpression move(dialect == Dialect::heidenhain
                                      ? R"(^\d+ L X([+-][\d.]+) R0 (?:F[\d.]+|FMAX)$)"
                                      : R"(^G[01] X=?(-?[\d.]+)(?: F[\d.]+)?$)");
    const QRegularExpression dwell(dialect == Dialect::heidenhain ? R"(^\d+ CYCL DEF 9\.1 DWELL [\d.]+$)"
                                   : dialect == Dialect::siemens  ? R"(^G4 F[\d.]+$)"
                                                                  : R"(^G4 X[\d.]+$)");
    Walk result;
    for (const QString &line : QString::fromLatin1(program).split('\n')) {
        if (const auto match = move.match(line); match.hasMatch())
            result.positions.push_back(match.captured(1).toDouble());
        else if (dwell.match(line).hasMatch())
            result.rests.push_back(result.positions.back());
    }
    return result;
}

} // namespace

class PartProgramTest : public QObject {
    Q_OBJECT

private slots:
    void isoProgram() {
        QCOMPARE(partProgram(small(), Dialect::iso, english()), QByteArray(R"(%
O2302
(positioning test of axis X; targets: 2; runs each way: 1)
(moves from -7.000 mm to 2.250 mm: check the room before the start)
G90 G21 G94 G61
(run 1)
G1 X-7.000 F2000
G1 X-5.000 F2000
G4 X4.0
G1 X0.250 F2000
G4 X4.0
G1 X2.250 F2000
G1 X0.250 F2000
G4 X4.0
G1 X-5.000 F2000
G4 X4.0
M30
%
)"));
    }

    void siemensProgram() {
        CycleProgram program = small();
        program.axis = "X1";
        program.feed.reset();
        const QByteArray text = partProgram(program, Dialect::siemens, english());
        QVERIFY(text.contains("\nG0 X1=-7.000\n"));
        QVERIFY(text.contains("\nG4 F4.0\n"));
        QVERIFY(text.endsWith("M30\n"));
    }

    void heidenhainProgram() {
        const QByteArray text = partProgram(small(), Dialect::heidenhain, english());
        QVERIFY(text.startsWith("0 BEGIN PGM ISO230_2 MM\n"));
        QVERIFY(text.contains(" L X-7.000 R0 F2000\n"));
        QVERIFY(text.contains(" L X+0.250 R0 F2000\n"));
        int number = 0; // block numbers without a gap
        for (const QByteArray &line : text.trimmed().split('\n'))
            QVERIFY2(line.startsWith(QByteArray::number(number++) + ' '), line.constData());
        QVERIFY(text.trimmed().endsWith("END PGM ISO230_2 MM"));
    }

    /// Read back: every target is reached from its own side, at rest as often as there are readings.
    void everyTargetIsReachedFromItsSide_data() {
        QTest::addColumn<Dialect>("dialect");
        QTest::addColumn<Cycle>("cycle");
        for (const Cycle cycle : {Cycle::standard, Cycle::step}) {
            const char *word = cycle == Cycle::standard ? "standard" : "step";
            QTest::addRow("ISO, %s cycle", word) << Dialect::iso << cycle;
            QTest::addRow("Siemens, %s cycle", word) << Dialect::siemens << cycle;
            QTest::addRow("Heidenhain, %s cycle", word) << Dialect::heidenhain << cycle;
        }
    }
    void everyTargetIsReachedFromItsSide() {
        QFETCH(Dialect, dialect);
        QFETCH(Cycle, cycle);
        CycleProgram program = small();
        program.targets = {1.5, 98.25, 200.125, 305};
        program.runs = 3;
        program.cycle = cycle;
        const QByteArray text = partProgram(program, dialect, english());
        const Walk walked = walk(text, dialect);
        QCOMPARE(walked.rests.size(), std::size_t(24));
        const auto stops = measuringCycle(4, 3, cycle);
        std::size_t rest = 0;
        for (std::size_t i = 1; i < walked.positions.size() && rest < stops.size(); ++i) {
            const Stop &stop = stops[rest];
            if (walked.positions[i] != program.targets[stop.target])
                continue;
            const bool fromBelow = walked.positions[i - 1] < walked.positions[i];
            QCOMPARE(fromBelow, stop.approach == Direction::positive);
            QCOMPARE(walked.rests[rest], walked.positions[i]);
            ++rest;
        }
        QCOMPARE(rest, stops.size());
    }

    void commentsAreAscii() {
        const Language french(Language::Id::french);
        for (const Dialect dialect : {Dialect::iso, Dialect::siemens, Dialect::heidenhain}) {
            const QByteArray text = partProgram(small(), dialect, french);
            for (const char c : text)
                QVERIFY(c == '\n' || (c >= 32 && c < 127));
            QCOMPARE(text.count('('), text.count(')'));
        }
    }

    void whatCannotBeIsEmpty() {
        const auto refused = [](void (*change)(CycleProgram &)) {
            CycleProgram program = small();
            change(program);
            return partProgram(program, Dialect::iso, english()).isEmpty();
        };
        QVERIFY(refused([](CycleProgram &program) { program.targets.clear(); }));
        QVERIFY(refused([](CycleProgram &program) { program.runs = 0; }));
        QVERIFY(refused([](CycleProgram &program) { program.dwell = 0; }));
        QVERIFY(refused([](CycleProgram &program) { program.approach = -1; }));
        QVERIFY(refused([](CycleProgram &program) { program.feed = 0; }));
        QVERIFY(refused([](CycleProgram &program) { program.axis = ""; }));
        QVERIFY(refused([](CycleProgram &program) { program.axis = "X (M3)"; }));
    }
};

QTEST_APPLESS_MAIN(PartProgramTest)
#include "partprogramtest.moc"
