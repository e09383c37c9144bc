// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "export/compensation.h"
#include "document/documenterror.h"
#include "document/savedocument.h"
#include "export/resultsjson.h"
#include "import/importmeasurement.h"
#include "kernel/evaluation/evaluatetest.h"
#include "kernel/evaluation/surroundings.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <random>

using namespace palmer;

namespace {

QByteArray csvOf(const Test &test, Language::Id language, char mark) {
    Document document;
    document.tests.push_back(std::make_shared<const Test>(test));
    return readingsCsv(evaluate(std::make_shared<const Document>(std::move(document))), 0, Language(language),
                       mark);
}

Test example(const QString &name) {
    return *openDocument(EXAMPLES + name + ".palmer").tests.front();
}

TestEvaluation evaluated(const Test &test) {
    return evaluateTest(test, Surroundings{});
}

double value(const TestEvaluation &evaluation, const std::string &id) {
    for (const Parameter &parameter : evaluation.parameters) {
        if (parameterId(parameter) == id)
            return parameter.value.value_or(std::nan(""));
    }
    return std::nan("");
}

/// Two runs each way, so that means are what they look like.
Test smallTest() {
    PositioningMeasurement m;
    m.axis.name = "X";
    m.targets = {0, 100, 200};
    m.runs = {{Direction::positive, {-0.003, 0.0002, -0.005}},
              {Direction::negative, {0.0023, 0.0054, -0.0015}},
              {Direction::positive, {-0.003, 0.0002, -0.005}},
              {Direction::negative, {0.0023, 0.0054, -0.0015}}};
    Test test;
    test.edition = "ISO 230-2:2014";
    test.measurement = std::move(m);
    return test;
}

struct Form {
    const char *name;
    CompensationFormat format;
    CompensationOptions options;
};

CompensationOptions options(bool perDirection, bool incremental = false, bool deviations = false,
                            char mark = '.', std::optional<double> interval = {}) {
    CompensationOptions result;
    result.perDirection = perDirection;
    result.incremental = incremental;
    result.deviations = deviations;
    result.decimalMark = mark;
    result.interval = interval;
    return result;
}

CompensationOptions referenced(double reference, std::optional<double> interval = {}) {
    CompensationOptions result;
    result.reference = reference;
    result.interval = interval;
    return result;
}

const std::vector<Form> &rows() {
    using Format = CompensationFormat;
    static const std::vector<Form> table{
        {"LinuxCNC", Format::linuxcnc, options(false)},
        {"LinuxCNC per direction", Format::linuxcnc, options(true)},
        {"LinuxCNC at an interval", Format::linuxcnc, options(true, false, false, '.', 30)},
        {"Siemens", Format::siemens, referenced(0)},
        {"Siemens at an interval", Format::siemens, referenced(20, 22.5)},
        {"CSV", Format::csv, options(false)},
        {"CSV per direction", Format::csv, options(true)},
        {"CSV in steps", Format::csv, options(true, true)},
        {"CSV with comma and the sign of the deviation", Format::csv, options(true, true, true, ',', 7.3)},
    };
    return table;
}

// ---- controls, after their own rules and apart from the writers

/// LinuxCNC: usrmotLoadComp hands on the triplets up to the first line that is none; the controller takes
/// those that ascend, 256 at most, as single precision trims with slopes, and adds them to the position
/// command.
class LinuxcncJoint {
public:
    /// Whether every line was loaded.
    bool load(const QByteArray &file) {
        int lines = 0;
        for (const QByteArray &line : file.split('\n')) {
            double nominal = 0;
            double forward = 0;
            double reverse = 0;
            if (std::sscanf(line.constData(), "%lf %lf %lf", &nominal, &forward, &reverse) != 3)
                break;
            ++lines;
            if (m_points.size() >= 256 || (!m_points.empty() && nominal <= m_points.back().nominal))
                continue;
            m_points.push_back(
                {nominal, static_cast<float>(nominal - forward), static_cast<float>(nominal - reverse)});
        }
        return static_cast<qsizetype>(lines) == file.count('\n') &&
               m_points.size() == static_cast<std::size_t>(lines);
    }

    [[nodiscard]] double correction(double command, bool up) const {
        const auto trim = [up](const Point &point) { return up ? point.forward : point.reverse; };
        std::size_t i = 0;
        while (i < m_points.size() && command >= m_points[i].nominal)
            ++i;
        if (i == 0)
            return static_cast<double>(trim(m_points.front()));
        if (i == m_points.size())
            return static_cast<double>(trim(m_points.back()));
        const float slope = static_cast<float>(
            (static_cast<double>(trim(m_points[i])) - static_cast<double>(trim(m_points[i - 1]))) /
            (m_points[i].nominal - m_points[i - 1].nominal));
        return static_cast<double>(trim(m_points[i - 1])) +
               static_cast<double>(slope) * (command - m_points[i - 1].nominal);
    }

private:
    struct Point {
        double nominal;
        float forward;
        float reverse;
    };
    std::vector<Point> m_points;
};

/// SINUMERIK: assignments in any order, comments after a semicolon. A positive value moves the axis in the
/// negative direction; the first and last hold beyond the ends, a modulo table is repeated.
class SinumerikAxis {
public:
    /// What the control would refuse or not use; empty when there is nothing.
    QString load(const QByteArray &file, const QString &axis) {
        const QRegularExpression value(R"(^\$AA_ENC_COMP\[([01]),(\d+),(\w+)\]=(-?\d+(?:\.\d+)?)$)");
        const QRegularExpression word(R"(^\$AA_ENC_COMP_(\w+)\[([01]),(\w+)\]=(-?\d+(?:\.\d+)?)$)");
        const QStringList lines = QString::fromLatin1(file).split('\n', Qt::SkipEmptyParts);
        for (const QString &full : lines) {
            if (const auto comment = QRegularExpression(R"(^; MD38000 .*>= (\d+)$)").match(full);
                comment.hasMatch())
                m_stated = comment.captured(1).toInt();
            const QString line = full.section(';', 0, 0).trimmed();
            if (line.isEmpty() || line.startsWith("%_N_") || line == "CHANDATA(1)" || line == "M17")
                continue;
            if (const auto point = value.match(line); point.hasMatch()) {
                if (point.captured(3) != axis ||
                    point.captured(2).toInt() != static_cast<int>(m_values.size()))
                    return line;
                m_values.push_back(point.captured(4).toDouble());
            } else if (const auto named = word.match(line); named.hasMatch() && named.captured(3) == axis) {
                m_words[named.captured(1)] = named.captured(4);
            } else {
                return line;
            }
        }
        if (lines.last() != "M17" || m_words.size() != 4)
            return "STEP, MIN, MAX, IS_MODULO and M17";
        if (units("MIN") + units("STEP") * (static_cast<long long>(m_values.size()) - 1) != units("MAX"))
            return "MIN + STEP · n is not MAX";
        if (m_stated != static_cast<int>(m_values.size()))
            return "MD38000";
        return {};
    }

    [[nodiscard]] bool modulo() const { return m_words.at("IS_MODULO") == "1"; }
    [[nodiscard]] double first() const { return m_words.at("MIN").toDouble(); }
    [[nodiscard]] double last() const { return m_words.at("MAX").toDouble(); }
    [[nodiscard]] double step() const { return m_words.at("STEP").toDouble(); }

    [[nodiscard]] double correction(double position) const {
        const double step = m_words.at("STEP").toDouble();
        if (modulo()) {
            while (position >= last())
                position -= last() - first();
            while (position < first())
                position += last() - first();
        }
        const double at =
            std::clamp((position - first()) / step, 0.0, static_cast<double>(m_values.size() - 1));
        const auto i = std::min(static_cast<std::size_t>(at), m_values.size() - 2);
        const double part = at - static_cast<double>(i);
        return -(m_values[i] + part * (m_values[i + 1] - m_values[i]));
    }

private:
    /// As a whole number of 1e-9, from the digits.
    [[nodiscard]] long long units(const char *name) const {
        const QString &text = m_words.at(name);
        const QString decimals = text.contains('.') ? text.section('.', 1) : QString();
        return (text.section('.', 0, 0) + decimals.leftJustified(9, '0')).toLongLong();
    }

    std::vector<double> m_values;
    std::map<QString, QString> m_words;
    int m_stated = 0;
};

/// Weihong: unit, axis, then `nominal, forward error, backward error`, ascending; error = nominal − actual.
class WeihongAxis {
public:
    bool load(const QByteArray &file, const QByteArray &axis) {
        const QList<QByteArray> lines = file.trimmed().split('\n');
        if (lines.size() < 4 || lines[0].simplified() != "unit = mm" || lines[1] != '[' + axis + ']')
            return false;
        for (qsizetype i = 2; i < lines.size(); ++i) {
            const QList<QByteArray> cells = lines[i].split(',');
            if (cells.size() != 3 || (i > 2 && cells[0].toDouble() <= m_points.back()[0]))
                return false;
            m_points.push_back({cells[0].toDouble(), cells[1].toDouble(), cells[2].toDouble()});
        }
        return true;
    }

    /// The error at a point of the table.
    [[nodiscard]] double correction(double position, bool up) const {
        for (const auto &point : m_points) {
            if (point[0] == position)
                return up ? point[1] : point[2];
        }
        return std::nan("");
    }

private:
    std::vector<std::array<double, 3>> m_points;
};

/// An axis with any systematic deviations and a little scatter.
Test randomAxis(std::mt19937 &generator, bool even, Motion motion = Motion::linear) {
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    };
    PositioningMeasurement m;
    m.axis.name = "X";
    m.axis.motion = motion;
    const int targets = 5 + static_cast<int>(generator() % 40);
    const double step = std::round(uniform(1, 60) * 1000) / 1000;
    double at = std::round(uniform(-1500, 500) * 1000) / 1000;
    for (int i = 0; i < targets; ++i) {
        m.targets.push_back(std::round(at * 1000) / 1000);
        at += even ? step : uniform(0.5, 60);
    }
    const int ways = static_cast<int>(generator() % 3); // ↑ only, ↓ only, both
    const double scale = motion == Motion::linear ? 0.02 : 0.01;
    std::vector<double> up;
    std::vector<double> down;
    for (int i = 0; i < targets; ++i) {
        up.push_back(uniform(-scale, scale));
        down.push_back(up.back() + uniform(0, scale));
    }
    for (int run = 0; run < 6; ++run) {
        Run each;
        each.approach = ways == 0 || (ways == 2 && run % 2 == 0) ? Direction::positive : Direction::negative;
        for (int i = 0; i < targets; ++i)
            each.deviations.emplace_back(
                (each.approach == Direction::positive ? up : down)[static_cast<std::size_t>(i)] +
                uniform(-scale / 50, scale / 50));
        m.runs.push_back(std::move(each));
    }
    Test test;
    test.edition = "ISO 230-2:2014";
    test.measurement = std::move(m);
    return test;
}

/// The test as the compensated machine would give it.
Test corrected(const Test &test, const std::function<double(double, bool)> &correction) {
    Test result = test;
    auto &m = std::get<PositioningMeasurement>(result.measurement);
    for (Run &run : m.runs) {
        for (std::size_t i = 0; i < m.targets.size(); ++i)
            *run.deviations[i] += correction(m.targets[i], run.approach == Direction::positive);
    }
    return result;
}

/// Between the targets straight on, beyond them as at the last: the mean of all readings, from the readings
/// alone.
double meanDeviation(const PositioningMeasurement &m, double position) {
    const auto at = [&m](std::size_t target) {
        double sum = 0;
        for (const Run &run : m.runs)
            sum += *run.deviations[target];
        return sum / static_cast<double>(m.runs.size());
    };
    if (position <= m.targets.front())
        return at(0);
    for (std::size_t i = 1; i < m.targets.size(); ++i) {
        if (position <= m.targets[i])
            return std::lerp(at(i - 1), at(i),
                             (position - m.targets[i - 1]) / (m.targets[i] - m.targets[i - 1]));
    }
    return at(m.targets.size() - 1);
}

QString refusal(const Test &test, CompensationFormat format, const CompensationOptions &form) {
    try {
        (void)writeCompensation(compensationTable(test, evaluated(test), format, form), format, form);
        return {};
    } catch (const Error &error) {
        return Language(Language::Id::english).sentence(error.message);
    }
}

// Tables are rounded to 0.1 µm (1e-5°), and single precision of LinuxCNC adds less: two values each way.
constexpr double leftByRounding = 2.2 * 0.5e-4;

} // namespace

class CompensationTest : public QObject {
    Q_OBJECT

private slots:
    void takesOutTheMeans();
    void writesWhatControlsRead();
    void readsBackWhatItWrote_data();
    void readsBackWhatItWrote();
    void holdsBeyondItsEnds();
    void refusesWhatCannotBe();
    void linuxcncLoadsWhatIsWritten();
    void linuxcncTablesAreNoLongerThanItLoads();
    void sinumerikReadsWhatIsWritten();
    void sinumerikTablesOfAFullTurnClose();
    void weihongReadsWhatIsWritten();
    void namesAreThoseOfTheControl();
    void saysWhereNothingWasMeasured();
    void saysUnderWhichConditionsItHolds_data();
    void saysUnderWhichConditionsItHolds();
    void inventsNoDirection();
    void comparesTables();
    void readingsReadBack_data();
    void readingsReadBack();
    void headingsAreTheSameInEveryLanguage();
    void jsonHasTheReadings();
};

void CompensationTest::takesOutTheMeans() {
    for (const QString name : {"iso230-2-1988-example", "rotary-axis", "long-axis-with-zone"}) {
        Test test = example(name);
        test.edition = "ISO 230-2:2014";
        const TestEvaluation before = evaluated(test);
        const TestEvaluation after = evaluated(
            compensated(test, compensationTable(test, before, CompensationFormat::csv, options(true))));
        // Per direction nothing systematic is left but the rounding of the table: 0.05 µm (or 5e-6°) each
        // way.
        const double rounding =
            2.1 * (std::get<PositioningMeasurement>(test.measurement).axis.motion == Motion::linear ? 0.5e-4
                                                                                                    : 0.5e-5);
        for (const char *id : {"E", "M", "B"})
            QVERIFY2(!(value(after, id) > rounding), id);
        // Combined, the reversal value stays as it is, and M goes.
        const TestEvaluation both = evaluated(
            compensated(test, compensationTable(test, before, CompensationFormat::csv, options(false))));
        QVERIFY(!(value(both, "M") > rounding));
        QVERIFY(std::isnan(value(before, "B")) || std::abs(value(both, "B") - value(before, "B")) < 1e-15);
        // Repeatability is no matter of compensation; differences of means round in the last digits.
        QVERIFY(std::isnan(value(before, "R+")) ||
                std::abs(value(after, "R+") - value(before, "R+")) < 1e-12);
    }
}

void CompensationTest::writesWhatControlsRead() {
    const Test test = smallTest();
    const TestEvaluation evaluation = evaluated(test);
    const auto text = [&](CompensationFormat format, const CompensationOptions &form) {
        return QString::fromUtf8(
            writeCompensation(compensationTable(test, evaluation, format, form), format, form));
    };
    QCOMPARE(text(CompensationFormat::linuxcnc, options(true)),
             "0 -0.003 0.0023\n100 100.0002 100.0054\n200 199.995 199.9985\n");
    QCOMPARE(text(CompensationFormat::siemens, referenced(100)),
             "%_N_AX_EEC_INI\n; Palmer, unit=mm, value = actual - target, reference=100, measured=0..200\n"
             "; MD38000 $MA_MM_ENC_COMP_MAX_POINTS[0,X] >= 3\nCHANDATA(1)\n"
             "$AA_ENC_COMP[0,0,X]=-0.0032\n$AA_ENC_COMP[0,1,X]=0\n$AA_ENC_COMP[0,2,X]=-0.0061\n"
             "$AA_ENC_COMP_STEP[0,X]=100\n$AA_ENC_COMP_MIN[0,X]=0\n$AA_ENC_COMP_MAX[0,X]=200\n"
             "$AA_ENC_COMP_IS_MODULO[0,X]=0\nM17\n");
    QCOMPARE(text(CompensationFormat::weihong, options(true)),
             "unit = mm\n[X]\n0, 0.003, -0.0023\n100, -0.0002, -0.0054\n200, 0.005, 0.0015\n");
    QCOMPARE(text(CompensationFormat::weihong, options(true, false, true)),
             "unit = mm\n[X]\n0, -0.003, 0.0023\n100, 0.0002, 0.0054\n200, -0.005, -0.0015\n");
    QCOMPARE(text(CompensationFormat::csv, options(true, false, false, ',')),
             "# Palmer compensation axis=X unit=mm values=perDirection form=absolute sign=correction "
             "decimalMark=comma\n"
             "position;forward;reverse\n0;0,003;-0,0023\n100;-0,0002;-0,0054\n200;0,005;0,0015\n");
    QCOMPARE(text(CompensationFormat::csv, options(true, true, true)),
             "# Palmer compensation axis=X unit=mm values=perDirection form=incremental sign=deviation "
             "decimalMark=point\n"
             "position;forward;reverse\n0;-0.003;0.0023\n100;0.0032;0.0031\n200;-0.0052;-0.0069\n");
    // Half way between the targets, and at the end although the interval does not meet it.
    CompensationOptions between = options(true, false, false, '.', 150);
    QCOMPARE(text(CompensationFormat::csv, between).section('\n', 2),
             "0;0.003;-0.0023\n150;0.0024;-0.002\n200;0.005;0.0015\n");
}

void CompensationTest::readsBackWhatItWrote_data() {
    QTest::addColumn<int>("index");
    for (int i = 0; i < static_cast<int>(rows().size()); ++i)
        QTest::newRow(rows()[static_cast<std::size_t>(i)].name) << i;
}

void CompensationTest::readsBackWhatItWrote() {
    QFETCH(int, index);
    const Form &row = rows()[static_cast<std::size_t>(index)];
    for (const QString name : {"iso230-2-1988-example", "rotary-axis"}) {
        const Test test = example(name);
        const TestEvaluation before = evaluated(test);
        const CompensationTable table = compensationTable(test, before, row.format, row.options);
        const CompensationTable read =
            readCompensation(writeCompensation(table, row.format, row.options), row.format, row.options);
        QVERIFY(read.positions == table.positions);
        QVERIFY(read.forward == table.forward);
        QVERIFY(read.reverse == table.reverse);
        QVERIFY(read.period == table.period);
        QVERIFY(read.motion == table.motion ||
                row.format == CompensationFormat::linuxcnc); // which keeps none
        // The same prediction, bit by bit.
        QVERIFY(compensated(test, read) == compensated(test, table));
    }
}

void CompensationTest::holdsBeyondItsEnds() {
    CompensationTable table;
    table.positions = {0, 10, 30};
    table.forward = {1, 2, 4};
    table.reverse = {-1, -2, -4};
    QCOMPARE(table.correction(-5, Direction::positive), 1.0);
    QCOMPARE(table.correction(0, Direction::positive), 1.0);
    QCOMPARE(table.correction(5, Direction::positive), 1.5);
    QCOMPARE(table.correction(20, Direction::negative), -3.0);
    QCOMPARE(table.correction(99, Direction::negative), -4.0);
}

void CompensationTest::refusesWhatCannotBe() {
    const Test test = smallTest();
    const TestEvaluation evaluation = evaluated(test);
    const auto write = [&](CompensationFormat format, const CompensationOptions &form) {
        (void)writeCompensation(compensationTable(test, evaluation, format, form), format, form);
    };
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::siemens, options(false)), Error); // no reference point
    for (const auto change : {&CompensationOptions::perDirection, &CompensationOptions::incremental,
                              &CompensationOptions::deviations}) {
        CompensationOptions form = referenced(0);
        form.*change = true;
        QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::siemens, form), Error);
    }
    for (const int encoder : {-1, 2, 5}) {
        CompensationOptions form = referenced(0);
        form.encoder = encoder;
        QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::siemens, form), Error);
    }
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::weihong, options(false, true)), Error);
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::linuxcnc, options(false, false, true)), Error);
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::csv, options(false, false, false, '.', -1)), Error);
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::csv, options(false, false, false, '.', 1e-9)), Error);
    CompensationOptions backwards;
    backwards.from = 100;
    backwards.to = 0;
    QVERIFY_EXCEPTION_THROWN(write(CompensationFormat::csv, backwards), Error);
    Test gap = test;
    for (Run &run : std::get<PositioningMeasurement>(gap.measurement).runs)
        run.deviations[1].reset();
    QVERIFY_EXCEPTION_THROWN((void)compensationTable(gap, evaluated(gap), CompensationFormat::csv, {}),
                             Error);
    for (const char *text : {"", "hello", "1 2\n", "$AA_ENC_COMP[0,0,X]=1\n",
                             "# Palmer compensation\n1;2;3\n", "# Palmer compensation\n1;2\n1;3\n"})
        QVERIFY_EXCEPTION_THROWN((void)readFoundTable(QByteArrayView(text), QStringLiteral("x.comp")), Error);
}

void CompensationTest::linuxcncLoadsWhatIsWritten() {
    std::mt19937 generator(1);
    for (int i = 0; i < 150; ++i) {
        const Test test = randomAxis(generator, false, i % 4 == 0 ? Motion::rotary : Motion::linear);
        const TestEvaluation before = evaluated(test);
        const bool perDirection = i % 2 == 0 && measuredBothWays(before);
        const CompensationOptions form = options(perDirection);
        const QByteArray file =
            writeCompensation(compensationTable(test, before, CompensationFormat::linuxcnc, form),
                              CompensationFormat::linuxcnc, form);
        LinuxcncJoint joint;
        QVERIFY2(joint.load(file), file.constData());
        const Test after = corrected(test, [&](double at, bool up) { return joint.correction(at, up); });
        const TestEvaluation result = evaluated(after);
        for (const char *id : {"E", "M", "B"}) {
            const bool goes = perDirection || *id == 'M' || std::isnan(value(before, "B"));
            QVERIFY2(!goes || !(value(result, id) > leftByRounding), id);
        }
        if (!perDirection && !std::isnan(value(before, "B")))
            QVERIFY(std::abs(value(result, "B") - value(before, "B")) < 1e-7); // single precision
        // What is predicted is what the control does.
        const TestEvaluation predicted =
            evaluated(compensated(test, readCompensation(file, CompensationFormat::linuxcnc, form)));
        QVERIFY(!(std::abs(value(predicted, "M") - value(result, "M")) > 1e-6));
        QVERIFY(!(std::abs(value(predicted, "A") - value(result, "A")) > 1e-6)); // none of one direction
    }
}

void CompensationTest::linuxcncTablesAreNoLongerThanItLoads() {
    for (const std::size_t targets : {255U, 256U, 257U, 1001U}) {
        Test test = smallTest();
        auto &m = std::get<PositioningMeasurement>(test.measurement);
        m.targets.clear();
        for (std::size_t i = 0; i < targets; ++i)
            m.targets.push_back(static_cast<double>(i) * 1.7);
        for (Run &run : m.runs)
            run.deviations.assign(targets, 0.001);
        const QString refused = refusal(test, CompensationFormat::linuxcnc, options(true));
        QCOMPARE(refused.isEmpty(), targets <= 256);
        if (refused.isEmpty())
            continue;
        QVERIFY2(refused.contains("256") && refused.contains(targets == 257 ? "257" : "001"),
                 qPrintable(refused));
        // The interval that is advised is enough, and whoever asks for a fine one is told the same.
        const double advised =
            QRegularExpression("interval of ([\\d.]+)").match(refused).captured(1).toDouble();
        QVERIFY(advised > 0);
        QCOMPARE(refusal(test, CompensationFormat::linuxcnc, options(true, false, false, '.', advised)),
                 QString());
        QVERIFY(!refusal(test, CompensationFormat::linuxcnc, options(true, false, false, '.', 1)).isEmpty());
    }
}

void CompensationTest::sinumerikReadsWhatIsWritten() {
    std::mt19937 generator(2);
    for (int i = 0; i < 200; ++i) {
        const bool even = i % 2 == 0;
        const Motion motion = i % 5 == 0 ? Motion::rotary : Motion::linear;
        const Test test = randomAxis(generator, even, motion);
        const auto &m = std::get<PositioningMeasurement>(test.measurement);
        const TestEvaluation before = evaluated(test);
        const double low = m.targets.front();
        const double high = m.targets.back();
        CompensationOptions form = referenced(low - 30 + (high - low + 60) * (i % 11) / 10.0);
        form.encoder = i % 2;
        if (!even)
            form.interval = (high - low) / (7 + i % 90);
        if (i % 7 == 3) {
            form.from = low - 11.1;
            form.to = high + 0.7;
        }
        const CompensationTable table = compensationTable(test, before, CompensationFormat::siemens, form);
        const QByteArray file = writeCompensation(table, CompensationFormat::siemens, form);
        SinumerikAxis axis;
        const QString wrong = axis.load(file, "X");
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong + '\n' + file));
        QVERIFY(!axis.modulo());
        QVERIFY(std::abs(axis.correction(*form.reference)) <= 0.5001e-4);  // the rounding of one value
        QVERIFY(std::abs(axis.first() - form.from.value_or(low)) < 1e-6 && // the digits that are written
                axis.last() > form.to.value_or(high) - 1e-6 && // whole, and no step more than that takes
                axis.last() < form.to.value_or(high) + axis.step() - 1e-6);
        // At each point of the table the axis goes against what was measured there, less what the table has
        // at the reference, between two of its points.
        const double inside = std::clamp(*form.reference, axis.first(), axis.last());
        const double below = axis.first() + std::floor((inside - axis.first()) / axis.step()) * axis.step();
        const double atReference = std::lerp(meanDeviation(m, below), meanDeviation(m, below + axis.step()),
                                             (inside - below) / axis.step());
        for (int k = 0; axis.first() + k * axis.step() < axis.last() + axis.step() / 2; ++k) {
            const double at = axis.first() + k * axis.step();
            const double expected = atReference - meanDeviation(m, at);
            QVERIFY2(std::abs(axis.correction(at) - expected) < 0.51e-4, // of one rounded value
                     qPrintable(QString::number(at)));
        }
        const Test after = corrected(test, [&](double at, bool /*up*/) { return axis.correction(at); });
        const TestEvaluation result = evaluated(after);
        if (even && !form.from) { // the points are the targets
            QVERIFY(!(value(result, "M") > leftByRounding));
            QVERIFY(std::isnan(value(before, "B")) ||
                    std::abs(value(result, "B") - value(before, "B")) < 1e-9);
        }
        const TestEvaluation predicted =
            evaluated(compensated(test, readCompensation(file, CompensationFormat::siemens, form)));
        QVERIFY(!(std::abs(value(predicted, "M") - value(result, "M")) > 1e-9));
        QVERIFY(!(std::abs(value(predicted, "A") - value(result, "A")) > 1e-9)); // none of one direction
    }
}

void CompensationTest::sinumerikTablesOfAFullTurnClose() {
    for (const bool closing : {true, false}) {
        for (const double begin : {0.0, -180.0, 12.5}) {
            Test test = smallTest();
            auto &m = std::get<PositioningMeasurement>(test.measurement);
            m.axis = {"C1", Motion::rotary, closing ? std::nullopt : std::optional(360.0), {}, {}};
            m.targets.clear();
            for (int i = 0; i < (closing ? 9 : 8); ++i)
                m.targets.push_back(begin + 45 * i);
            const auto deviation = [](double at) { return 0.004 * std::sin(at * 3.14159265358979 / 180); };
            for (Run &run : m.runs) {
                run.deviations.clear();
                for (const double at : m.targets)
                    run.deviations.emplace_back(deviation(at));
            }
            const CompensationOptions form = referenced(begin + 45);
            const QByteArray file =
                writeCompensation(compensationTable(test, evaluated(test), CompensationFormat::siemens, form),
                                  CompensationFormat::siemens, form);
            SinumerikAxis axis;
            const QString wrong = axis.load(file, "C1");
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong + '\n' + file));
            QVERIFY(axis.modulo());
            QCOMPARE(axis.last() - axis.first(), 360.0);
            QVERIFY(std::abs(axis.correction(begin + 45)) <= 0.5e-5 + 1e-12);
            // The last point is the first one again: no jump where the turn closes.
            QVERIFY(std::abs(axis.correction(axis.last() - 1e-9) - axis.correction(axis.first())) < 1e-9);
            QVERIFY(std::abs(axis.correction(begin - 0.001) - axis.correction(begin + 359.999)) < 1e-9);
            if (begin < 10) { // the points are the targets
                const Test after =
                    corrected(test, [&](double at, bool /*up*/) { return axis.correction(at); });
                QVERIFY(value(evaluated(after), "M") <= 2.1e-5);
            }
        }
    }
    // Part of a turn is a table with ends.
    Test part = smallTest();
    std::get<PositioningMeasurement>(part.measurement).axis = {"C", Motion::rotary, {}, {}, {}};
    SinumerikAxis axis;
    QCOMPARE(axis.load(writeCompensation(compensationTable(part, evaluated(part), CompensationFormat::siemens,
                                                           referenced(0)),
                                         CompensationFormat::siemens, referenced(0)),
                       "C"),
             QString());
    QVERIFY(!axis.modulo());
}

void CompensationTest::weihongReadsWhatIsWritten() {
    std::mt19937 generator(3);
    for (int i = 0; i < 60; ++i) {
        Test test = randomAxis(generator, false);
        auto &m = std::get<PositioningMeasurement>(test.measurement);
        m.axis.name = std::string(1, "XYZxyz"[i % 6]);
        const TestEvaluation before = evaluated(test);
        const CompensationOptions form = options(measuredBothWays(before));
        const QByteArray file =
            writeCompensation(compensationTable(test, before, CompensationFormat::weihong, form),
                              CompensationFormat::weihong, form);
        WeihongAxis axis;
        QVERIFY2(axis.load(file, QByteArray(1, "XYZ"[i % 3])), file.constData());
        const TestEvaluation after =
            evaluated(corrected(test, [&](double at, bool up) { return axis.correction(at, up); }));
        for (const char *id : {"E", "M", "B"})
            QVERIFY2(!(value(after, id) > leftByRounding), id);
    }
}

void CompensationTest::namesAreThoseOfTheControl() {
    const auto refused = [](const char *name, CompensationFormat format, Motion motion = Motion::linear) {
        Test test = smallTest();
        auto &axis = std::get<PositioningMeasurement>(test.measurement).axis;
        axis.name = name;
        axis.motion = motion;
        CompensationOptions form;
        if (format == CompensationFormat::siemens)
            form.reference = 0;
        return !refusal(test, format, form).isEmpty();
    };
    for (const char *name : {"X", "X1", "AX12", "c", "Z2"})
        QVERIFY2(!refused(name, CompensationFormat::siemens), name);
    for (const char *name : {"", " ", "X axis; DROP", "X]=0\nM30", "1X", "X-1", "\xC3\x84", "X,Y"})
        QVERIFY2(refused(name, CompensationFormat::siemens), name);
    for (const char *name : {"", "A", "X1", "X]\n[Y", "XY"})
        QVERIFY2(refused(name, CompensationFormat::weihong), name);
    QVERIFY(refused("X", CompensationFormat::weihong, Motion::rotary));
    // In the head of our own CSV a name stays one word of one line, whatever it is.
    Test test = smallTest();
    std::get<PositioningMeasurement>(test.measurement).axis.name = "X axis\n5;5";
    const CompensationTable table = compensationTable(test, evaluated(test), CompensationFormat::csv, {});
    QVERIFY(
        readCompensation(writeCompensation(table, CompensationFormat::csv, {}), CompensationFormat::csv, {})
            .positions == table.positions);
}

void CompensationTest::saysWhereNothingWasMeasured() {
    const Test test = smallTest(); // from 0 to 200
    const auto said = [&](std::optional<double> from, std::optional<double> to, double reference,
                          CompensationFormat format = CompensationFormat::siemens) {
        CompensationOptions form = referenced(reference);
        form.from = from;
        form.to = to;
        QStringList sentences;
        for (const Message &remark :
             compensationRemarks(test, compensationTable(test, evaluated(test), format, form), format, form))
            sentences << Language(Language::Id::english).sentence(remark);
        return sentences.join('\n');
    };
    QVERIFY(!said({}, {}, 0).contains("Nothing was measured"));
    QVERIFY(said({}, {}, 0).contains("MD38000 has to be 3 at least"));
    for (const auto format : {CompensationFormat::siemens, CompensationFormat::linuxcnc,
                              CompensationFormat::weihong, CompensationFormat::csv}) {
        QVERIFY(said(-1, {}, 0, format).contains("Nothing was measured outside"));
        QVERIFY(said({}, 300, 0, format).contains("Nothing was measured outside"));
        QVERIFY(!said(10, 190, 10, format).contains("Nothing was measured outside"));
    }
    QVERIFY(said({}, {}, -5).contains("The reference point"));
    QVERIFY(!said({}, {}, 200).contains("The reference point"));
    QVERIFY(said({}, {}, 0, CompensationFormat::linuxcnc).contains("COMP_FILE_TYPE = 0"));
    QVERIFY(said({}, {}, 0, CompensationFormat::weihong).contains("nominal \u2212 actual"));
}

/// A table that was made warm, or on top of another one, holds only so.
void CompensationTest::saysUnderWhichConditionsItHolds_data() {
    QTest::addColumn<std::string>("compensation");
    QTest::addColumn<int>("correction");
    QTest::addColumn<double>("temperature");
    QTest::addColumn<bool>("rotary");
    QTest::addColumn<QStringList>("said");
    const QString onTop("on top of what was active then");
    const auto row = [](const char *name, const char *compensation, CorrectionTo20 correction,
                        double temperature, bool rotary, const QStringList &said) {
        QTest::newRow(name) << std::string(compensation) << static_cast<int>(correction) << temperature
                            << rotary << said;
    };
    row("at 20 °C", "", CorrectionTo20::notStated, 20, false, {});
    row("corrected", "", CorrectionTo20::appliedHere, 27, false, {});
    row("was to be corrected", "", CorrectionTo20::appliedHere, 0, false, {"the temperature of the test"});
    row("warm", "", CorrectionTo20::notApplied, 27, false, {"the machine at 27"});
    row("warm, not stated", "", CorrectionTo20::notStated, 27.5, false, {"the machine at 27.5"});
    row("temperature unknown", "", CorrectionTo20::notStated, 0, false, {"the temperature of the test"});
    row("an angle", "", CorrectionTo20::notStated, 27, true, {});
    row("on a table", "pitch table", CorrectionTo20::appliedHere, 20, false, {"pitch table", onTop});
    row("on a table, warm", "pitch table", CorrectionTo20::notApplied, 31, false,
        {onTop, "the machine at 31"});
}

void CompensationTest::saysUnderWhichConditionsItHolds() {
    QFETCH(const std::string, compensation);
    QFETCH(const int, correction);
    QFETCH(const double, temperature);
    QFETCH(const bool, rotary);
    QFETCH(const QStringList, said);
    Test test = smallTest();
    auto &measurement = std::get<PositioningMeasurement>(test.measurement);
    measurement.axis.motion = rotary ? Motion::rotary : Motion::linear;
    Conditions &conditions = measurement.conditions.common;
    conditions.compensation = compensation;
    conditions.correctionTo20 = static_cast<CorrectionTo20>(correction);
    conditions.expansion = {11.5, 0.0};
    conditions.sensors.clear();
    if (temperature > 0) {
        Sensor sensor;
        sensor.measures = SensorMeasures::machine;
        sensor.start = temperature;
        conditions.sensors = {sensor};
    }
    const auto format = CompensationFormat::csv;
    QStringList sentences;
    for (const Message &remark :
         compensationRemarks(test, compensationTable(test, evaluated(test), format, {}), format, {}))
        sentences << Language(Language::Id::english).sentence(remark).replace(QChar::Nbsp, ' ');
    QCOMPARE(sentences.isEmpty(), said.isEmpty());
    for (const QString &words : said)
        QVERIFY2(sentences.join('\n').contains(words), qPrintable(sentences.join('\n')));
}

/// Of a test of one direction: no columns of both, and where the control needs them it is said.
void CompensationTest::inventsNoDirection() {
    for (const Direction direction : {Direction::positive, Direction::negative}) {
        Test test = smallTest();
        std::erase_if(std::get<PositioningMeasurement>(test.measurement).runs,
                      [&](const Run &run) { return run.approach != direction; });
        const TestEvaluation evaluation = evaluated(test);
        QVERIFY(!measuredBothWays(evaluation));
        for (const auto format : {CompensationFormat::siemens, CompensationFormat::linuxcnc,
                                  CompensationFormat::weihong, CompensationFormat::csv}) {
            CompensationOptions form = referenced(0);
            const CompensationTable table = compensationTable(test, evaluation, format, form);
            QVERIFY(table.only == direction && table.forward == table.reverse);
            const auto remarks = compensationRemarks(test, table, format, form);
            const auto said = std::ranges::count_if(remarks, [&](const Message &remark) {
                return Language(Language::Id::english)
                    .sentence(remark)
                    .startsWith(direction == Direction::positive
                                    ? "Only the positive direction was measured"
                                    : "Only the negative direction was measured");
            });
            QCOMPARE(said, 1);
            form.perDirection = true;
            QVERIFY_EXCEPTION_THROWN((void)compensationTable(test, evaluation, format, form), Error);
        }
    }
    QVERIFY(measuredBothWays(evaluated(smallTest())));
    QVERIFY(!compensationTable(smallTest(), evaluated(smallTest()), CompensationFormat::csv, {}).only);
}

void CompensationTest::comparesTables() {
    CompensationTable first;
    first.positions = {0, 100};
    first.forward = {0, 0.010};
    first.reverse = {0, 0};
    CompensationTable second = first;
    second.positions = {0, 50, 100};
    second.forward = {0, 0.001, 0.010};
    second.reverse = {0, 0.002, 0};
    const TableDifference difference = largestDifference(first, second);
    QCOMPARE(difference.position, 50.0);
    QCOMPARE(difference.value, -0.004);
    QVERIFY(difference.direction == Direction::positive);
    QCOMPARE(largestDifference(second, second).value, 0.0);
}

void CompensationTest::readingsReadBack_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("comma");
    for (const char *name :
         {"iso230-2-1988-example", "rotary-axis", "one-direction", "long-axis-with-zone"}) {
        for (const bool comma : {false, true})
            QTest::addRow("%s, %s", name, comma ? "comma" : "point") << QString(name) << comma;
    }
}

void CompensationTest::readingsReadBack() {
    QFETCH(QString, name);
    QFETCH(bool, comma);
    const Test test = example(name);
    const QByteArray csv = csvOf(test, Language::Id::english, comma ? ',' : '.');
    const Imported imported = importMeasurement(csv, "x.csv");
    QVERIFY(imported.test);
    const auto &expected = std::get<PositioningMeasurement>(test.measurement);
    const auto &read = std::get<PositioningMeasurement>(imported.test->measurement);
    QVERIFY(read.targets == expected.targets);
    QVERIFY(read.runs == expected.runs);
    QCOMPARE(read.axis.name, expected.axis.name);
    QVERIFY(read.axis.motion == expected.axis.motion);
    for (const Remark &remark : imported.remarks)
        QVERIFY2(remark.grade != RemarkGrade::problem, remark.message.text.source);
}

/// For scripts: headings are keys, in one form of units; names follow the language.
void CompensationTest::headingsAreTheSameInEveryLanguage() {
    Test drift;
    DriftMeasurement measurement;
    measurement.times = {0, 1};
    measurement.deviations = {0, 0.001};
    drift.measurement = measurement;
    for (const Test &test : {example("iso230-2-1988-example"), drift}) {
        const auto written = [&](Language::Id id) { return csvOf(test, id, '.').split('\n'); };
        const QByteArrayList english = written(Language::Id::english);
        const QByteArrayList french = written(Language::Id::french);
        QCOMPARE(english.size(), french.size());
        for (qsizetype i = 0; i < english.size(); ++i) {
            const bool isHeading = english[i].startsWith("i,") || english[i].startsWith("time") ||
                                   english[i].startsWith("parameter,");
            QVERIFY(!isHeading || (english[i] == french[i] && !english[i].contains('[')));
        }
    }
    QVERIFY(csvOf(drift, Language::Id::english, '.').contains("time (s),deviation (mm)"));
}

void CompensationTest::jsonHasTheReadings() {
    const auto document = std::make_shared<const Document>(openDocument(EXAMPLES "one-direction.palmer"));
    const QJsonObject test = QJsonDocument::fromJson(readingsJson(
        evaluate(document), "x", Language(Language::Id::english)))["tests"][0]
                                 .toObject();
    const auto &m = std::get<PositioningMeasurement>(document->tests.front()->measurement);
    const QJsonObject readings = test["readings"].toObject();
    QCOMPARE(readings["targets"].toArray().size(), static_cast<qsizetype>(m.targets.size()));
    QCOMPARE(readings["runs"].toArray().size(), static_cast<qsizetype>(m.runs.size()));
    QCOMPARE(readings["runs"][0]["approach"].toString(), QString("positive"));
    QCOMPARE(readings["runs"][0]["deviations"][0].toDouble(), *m.runs[0].deviations[0]);
    QVERIFY(test["parameters"].toArray().size() > 0);
}

QTEST_GUILESS_MAIN(CompensationTest)
#include "compensationtest.moc"
