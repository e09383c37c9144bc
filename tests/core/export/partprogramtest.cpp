// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "export/partprogram.h"

#include "document/documenterror.h"
#include "kernel/planning/targetplan.h"

#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <map>
#include <random>

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

/// What a control does with a program, by its own rules and apart from the writer: where the axis goes, where
/// it rests and for how long. `error` says what the control would not understand.
struct Walk {
    struct Rest {
        std::size_t move = 0; ///< after which move
        double seconds = 0;
    };
    std::vector<double> positions;
    std::vector<double> feeds; ///< of each move; 0: rapid
    std::vector<Rest> rests;
    QString error;
};

/// A number as controls of this kind take it: without a point in units of 0.001, or as it stands.
double number(const QString &text, bool countsIncrements) {
    return text.toDouble() / (countsIncrements && !text.contains('.') ? 1000 : 1);
}

/// G-code of every kind: letters with a number, SINUMERIK also with a number in the name and "=".
class Control {
public:
    Control(Dialect dialect, QString axis)
        : m_dialect(dialect)
        , m_axis(std::move(axis)) {}

    Walk run(const QByteArray &program) {
        for (const QString &line : QString::fromLatin1(program).split('\n', Qt::SkipEmptyParts)) {
            if (m_walk.error.isEmpty() && !m_ended)
                block(line);
        }
        if (!m_ended)
            m_walk.error = "no end";
        return m_walk;
    }

private:
    void block(QString line) {
        if (line == "%") {
            if (m_dialect == Dialect::siemens || m_dialect == Dialect::linuxcnc)
                m_walk.error = "%";
            return;
        }
        if (m_dialect == Dialect::siemens)
            line = line.section(';', 0, 0);
        else
            line.remove(QRegularExpression(R"(\([^()]*\))"));
        static const QRegularExpression word(R"(\s*([A-Z])(\d*)(=?)(-?\d*\.?\d*))");
        QStringList codes;
        std::map<QChar, QString> values;
        std::optional<QString> target;
        qsizetype at = 0;
        while (at < line.size() && !line.mid(at).trimmed().isEmpty()) {
            const auto match = word.match(line, at, QRegularExpression::NormalMatch,
                                          QRegularExpression::AnchorAtOffsetMatchOption);
            if (!match.hasMatch()) {
                m_walk.error = line;
                return;
            }
            at = match.capturedEnd();
            const QChar letter = match.captured(1)[0];
            const bool named = !match.captured(3).isEmpty();
            const QString value = named ? match.captured(4) : match.captured(2) + match.captured(4);
            if (letter == 'G' || letter == 'M')
                codes << letter + value;
            else if (named ? m_dialect == Dialect::siemens && match.captured(1) + match.captured(2) == m_axis
                           : QString(letter) == m_axis && !dwells(codes))
                target = value;
            else
                values[letter] = value;
        }
        apply(codes, values, target);
    }

    static bool dwells(const QStringList &codes) { return codes.contains("G4"); }

    void apply(const QStringList &codes, const std::map<QChar, QString> &values,
               const std::optional<QString> &target) {
        m_offset = m_offset || codes.contains("G54");
        m_absolute = m_absolute || codes.contains("G90");
        m_metric = m_metric || codes.contains(m_dialect == Dialect::siemens ? "G710" : "G21");
        m_ended = codes.contains("M30");
        const auto value = [&](QChar letter) {
            return values.contains(letter) ? values.at(letter) : QString();
        };
        if (values.contains('O') && m_dialect != Dialect::iso && m_dialect != Dialect::haas)
            m_walk.error = "O"; // a subroutine at LinuxCNC
        if (dwells(codes)) {
            const QChar letter = m_dialect == Dialect::iso ? 'X' : m_dialect == Dialect::siemens ? 'F' : 'P';
            const bool milliseconds = m_dialect == Dialect::haas || m_dialect == Dialect::iso;
            if (value(letter).isEmpty() || m_walk.positions.empty())
                m_walk.error = "G4";
            m_walk.rests.push_back({m_walk.positions.size() - 1, number(value(letter), milliseconds)});
        } else if (target) {
            const bool increments = m_dialect == Dialect::iso || m_dialect == Dialect::haas;
            if (!m_offset || !m_absolute || !m_metric || !(codes.contains("G0") || codes.contains("G1")))
                m_walk.error = "moves before it is set up";
            m_walk.positions.push_back(number(*target, increments));
            m_walk.feeds.push_back(codes.contains("G0") ? 0 : number(value('F'), m_dialect == Dialect::haas));
        } else if (codes.contains("G0") || codes.contains("G1")) {
            m_walk.error = "moves no axis, or another one";
        }
    }

    Dialect m_dialect;
    QString m_axis;
    Walk m_walk;
    bool m_offset = false;
    bool m_absolute = false;
    bool m_metric = false;
    bool m_ended = false;
};

Walk klartext(const QByteArray &program, const QString &axis) {
    Walk result;
    int block = 0;
    const QRegularExpression move("^L " + axis + R"(([+-]\d+(?:\.\d+)?) R0 (?:F(\d+(?:\.\d+)?)|FMAX)$)");
    const QRegularExpression dwell(R"(^CYCL DEF 9\.1 DWELL (\d+(?:\.\d+)?)$)");
    for (const QString &line : QString::fromLatin1(program).split('\n', Qt::SkipEmptyParts)) {
        if (line.section(' ', 0, 0) != QString::number(block++))
            result.error = "number of the block: " + line;
        const QString words = line.section(' ', 1);
        if (const auto moved = move.match(words); moved.hasMatch()) {
            result.positions.push_back(moved.captured(1).toDouble());
            result.feeds.push_back(moved.captured(2).toDouble());
        } else if (const auto rested = dwell.match(words); rested.hasMatch()) {
            result.rests.push_back({result.positions.size() - 1, rested.captured(1).toDouble()});
        } else if (!words.startsWith(';') && words != "CYCL DEF 9.0 DWELL TIME" && words != "M30" &&
                   !words.startsWith("BEGIN PGM ISO230_2 MM") && !words.startsWith("END PGM ISO230_2 MM")) {
            result.error = line;
        }
    }
    return result;
}

Walk walk(const QByteArray &program, Dialect dialect, const std::string &axis) {
    const QString name = QString::fromStdString(axis);
    return dialect == Dialect::heidenhain ? klartext(program, name) : Control(dialect, name).run(program);
}

/// The stops of a cycle as ISO 230-2 draws them: target and whether it is reached from below.
std::vector<std::pair<std::size_t, bool>> expectedStops(std::size_t targets, int runs, Cycle cycle) {
    std::vector<std::pair<std::size_t, bool>> stops;
    if (cycle == Cycle::step) {
        for (std::size_t i = 0; i < targets; ++i)
            for (int side = 0; side < 2 * runs; ++side)
                stops.emplace_back(i, side % 2 == 0);
        return stops;
    }
    for (int run = 0; run < runs; ++run) {
        for (std::size_t i = 0; i < targets; ++i)
            stops.emplace_back(i, true);
        for (std::size_t i = 0; i < targets; ++i)
            stops.emplace_back(targets - 1 - i, false);
    }
    return stops;
}

/// What the control does against what was asked; empty when it is the same.
QString difference(const Walk &walked, const CycleProgram &program) {
    if (!walked.error.isEmpty())
        return walked.error;
    const auto stops = expectedStops(program.targets.size(), program.runs, program.cycle);
    if (walked.rests.size() != stops.size())
        return "as many rests as stops";
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const auto &rest = walked.rests[i];
        const double target = program.targets[stops[i].first];
        const double half = 0.5001 * std::pow(10, -program.decimals); // what the decimals leave
        if (rest.move == 0 || std::abs(walked.positions[rest.move] - target) > half)
            return QStringLiteral("stop %1: not at its target").arg(i);
        const double way = walked.positions[rest.move] - walked.positions[rest.move - 1];
        if (stops[i].second ? !(way > 0) : !(way < 0))
            return QStringLiteral("stop %1: from the wrong side").arg(i);
        const bool turned = i == 0 || rest.move != walked.rests[i - 1].move + 1;
        if (turned && std::abs(way) < program.approach * (1 - 1e-9))
            return QStringLiteral("stop %1: not the whole approach distance").arg(i);
        if (std::abs(rest.seconds - program.dwell) > 0.00051)
            return QStringLiteral("stop %1: rests %2 s").arg(i).arg(rest.seconds);
        if (std::abs(walked.feeds[rest.move] - program.feed.value_or(0)) > 0.00051)
            return QStringLiteral("stop %1: feed %2").arg(i).arg(walked.feeds[rest.move]);
    }
    return {};
}

QString refusedBy(const auto &work) {
    try {
        work();
        return {};
    } catch (const Error &error) {
        return english().sentence(error.message);
    }
}

/// What is refused is known before the program is written.
QString refusal(const CycleProgram &program, Dialect dialect) {
    const QString before = refusedBy([&] { requireProgrammable(program, dialect); });
    const QString written = refusedBy([&] { (void)partProgram(program, dialect, english()); });
    return before == written ? written : QStringLiteral("%1; %2").arg(before, written);
}

} // namespace

class PartProgramTest : public QObject {
    Q_OBJECT

private slots:
    void isoProgram() {
        QCOMPARE(partProgram(small(), Dialect::iso, english()), QByteArray(R"(%
O2302
(positioning test of axis X, targets: 2, runs each way: 1)
(moves from -7.000 mm to 2.250 mm: check the room before the start)
(positions in work offset G54: set it before the start, for a compensation table to the machine zero)
G54 G90 G21 G94 G61
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

    void oneDirectionIsSaid() {
        CycleProgram program = small();
        for (const auto &[only, said] : {std::pair{Direction::positive, "runs, positive only: 1"},
                                         std::pair{Direction::negative, "runs, negative only: 1"}}) {
            program.only = only;
            const QByteArray text = partProgram(program, Dialect::iso, english());
            QVERIFY2(text.contains(said) && !text.contains("each way"), text.constData());
        }
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

    void linuxcncAndHaasPrograms() {
        CycleProgram program = small();
        program.decimals = 0;
        program.targets = {-5, 1};
        program.dwell = 4;
        const QByteArray linuxcnc = partProgram(program, Dialect::linuxcnc, english());
        QVERIFY(linuxcnc.contains("\nG54 G90 G21 G94 G61.1\n"));
        QVERIFY(linuxcnc.contains("\nG4 P4.0\n"));
        QVERIFY(!linuxcnc.contains("\nO"));
        const QByteArray haas = partProgram(program, Dialect::haas, english());
        QVERIFY(haas.startsWith("%\nO02302\n"));
        QVERIFY(haas.contains("\nG1 X-5.0 F2000.0\nG4 P4.0\n")); // without the points 0.005 mm and 4 ms
        QVERIFY(partProgram(program, Dialect::iso, english()).contains("\nG1 X-5.0 F2000\nG4 X4.0\n"));
    }

    void everyProgramNamesItsWorkOffset() {
        for (const DialectName &each : dialects()) {
            const QByteArray text = partProgram(small(), each.dialect, english());
            QVERIFY2(text.contains(each.dialect == Dialect::heidenhain ? "active datum" : "work offset G54"),
                     each.name);
            QCOMPARE(text.contains("\nG54 "), each.dialect != Dialect::heidenhain);
        }
    }

    /// Plans of all kinds, each program run by a control of the test's own.
    void everyTargetIsReachedFromItsSide_data() {
        QTest::addColumn<Dialect>("dialect");
        QTest::addColumn<Cycle>("cycle");
        for (const Cycle cycle : {Cycle::standard, Cycle::step}) {
            for (const DialectName &each : dialects())
                QTest::addRow("%s, %s cycle", each.word, cycle == Cycle::standard ? "standard" : "step")
                    << each.dialect << cycle;
        }
    }
    void everyTargetIsReachedFromItsSide() {
        QFETCH(Dialect, dialect);
        QFETCH(Cycle, cycle);
        std::mt19937 generator(4711);
        const auto uniform = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(generator);
        };
        int programs = 0;
        for (int i = 0; i < 120; ++i) {
            TargetRequest request;
            request.motion = i % 3 == 0 ? Motion::rotary : Motion::linear;
            request.rule = i % 5 == 0 ? TargetRule::pitches1988 : TargetRule::nominalInterval;
            request.from = std::round(uniform(-2000, 500));
            request.travel = request.motion == Motion::rotary ? 45 * (1 + i % 8) : uniform(20, 3000);
            request.decimals = i % 6;
            request.seed = static_cast<std::uint64_t>(i);
            const TargetPlan plan = planTargets(request);
            if (plan.targets.empty())
                continue;
            CycleProgram program;
            const bool numbered = dialect == Dialect::siemens && i % 2 == 0;
            program.axis = std::string(1, "XYZUVWABC"[i % 9]) + (numbered ? std::to_string(i % 12) : "");
            program.motion = request.motion;
            program.targets = plan.targets;
            program.decimals = request.decimals;
            program.runs = 1 + i % 5;
            program.cycle = cycle;
            if (i % 4 != 0)
                program.feed = std::round(uniform(1, 30000) * 1000) / 1000;
            program.dwell = std::round(uniform(0.1, 20) * 1000) / 1000;
            program.approach = i % 2 == 0 ? std::pow(10, uniform(-4, 1)) : std::round(uniform(1, 20)) / 10;
            const QByteArray text = partProgram(program, dialect, english());
            const QString wrong = difference(walk(text, dialect, program.axis), program);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong + QStringLiteral(" in plan %1").arg(i)));
            ++programs;
        }
        QVERIFY(programs > 100);
    }

    /// An overrun below the last decimal is rounded away from the target, never onto it.
    void overrunIsRoundedOutwards() {
        CycleProgram program = small();
        program.decimals = 0;
        program.approach = 0.4;
        program.targets = {0, 250, 500};
        for (const DialectName &each : dialects())
            QCOMPARE(
                difference(walk(partProgram(program, each.dialect, english()), each.dialect, "X"), program),
                QString());
        QCOMPARE(turningPoint(program, 0, Direction::positive), -1.0);
        QCOMPARE(turningPoint(program, 500, Direction::negative), 501.0);
        program.decimals = 1; // already one: neither 0.3 nor 0.5
        QCOMPARE(turningPoint(program, 0.7, Direction::positive), 0.3);
        QCOMPARE(turningPoint(program, 0.7, Direction::negative), 1.1);
    }

    /// X10.000 for target 0 of axis X1 would move axis X to 10.
    void axesWithANumberNeedAFormOfTheirOwn() {
        CycleProgram program = small();
        program.axis = "X1";
        for (const DialectName &each : dialects()) {
            const bool refused =
                refusal(program, each.dialect).contains("X1 before a position would be axis X");
            QCOMPARE(refused, each.dialect != Dialect::siemens);
        }
        for (const char *axis : {"", "G", "M3", "F", "X (M3)", "XY", "1", "X1234", "\xC3\x84", "X\nM3"}) {
            program.axis = axis;
            for (const DialectName &each : dialects())
                QVERIFY2(!refusal(program, each.dialect).isEmpty(), axis);
        }
        program.axis = "x"; // the same axis
        QVERIFY(partProgram(program, Dialect::iso, english()).contains("\nG1 X-5.000 F2000\n"));
    }

    void commentsAreAscii() {
        const Language french(Language::Id::french);
        for (const DialectName &each : dialects()) {
            const QByteArray text = partProgram(small(), each.dialect, french);
            for (const char c : text)
                QVERIFY(c == '\n' || (c >= 32 && c < 127));
            QCOMPARE(text.count('('), text.count(')'));
            QVERIFY(!text.contains(" ,")); // a semicolon of French has a blank before it
            if (text.contains('('))        // it ends a block
                QVERIFY(!text.contains(';'));
        }
    }

    void whatCannotBeIsRefused() {
        const auto refused = [](void (*change)(CycleProgram &), Dialect dialect = Dialect::iso) {
            CycleProgram program = small();
            change(program);
            return !refusal(program, dialect).isEmpty();
        };
        QVERIFY(!refused([](CycleProgram & /*program*/) {}));
        QVERIFY(refused([](CycleProgram &program) { program.targets.clear(); }));
        QVERIFY(refused([](CycleProgram &program) { program.runs = 0; }));
        QVERIFY(refused([](CycleProgram &program) { program.dwell = 0; }));
        QVERIFY(refused([](CycleProgram &program) { program.dwell = 0.0004; }));
        QVERIFY(!refused([](CycleProgram &program) { program.dwell = 4000; }));
        QVERIFY(refused([](CycleProgram &program) { program.dwell = 4000; }, Dialect::heidenhain));
        QVERIFY(refused([](CycleProgram &program) { program.approach = -1; }));
        QVERIFY(refused([](CycleProgram &program) { program.feed = 0; }));
        QVERIFY(refused([](CycleProgram &program) { program.feed = 1e-7; }));
        QVERIFY(refused([](CycleProgram &program) {
            program.decimals = 0;
            program.targets = {0.1, 0.2};
        }));
    }
};

QTEST_APPLESS_MAIN(PartProgramTest)
#include "partprogramtest.moc"
