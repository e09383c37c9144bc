// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/documenterror.h"
#include "import/importmeasurement.h"

#include <QRegularExpression>
#include <QTest>
#include <QtEndian>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace palmer;

namespace {

/// Where a reading belongs, and what it says: of the n-th run of its direction, in mm or degrees.
struct Truth {
    Direction approach;
    std::size_t run;
    double target;
    double deviation;

    auto key() const { return std::tuple(approach == Direction::positive, run, target); }
};

/// A file of an instrument and what it was written from.
struct Written {
    QStringList head;
    QStringList data; ///< each a line with readings
    QStringList tail;
    std::vector<Truth> truth;
    QString lineEnd = "\n";

    [[nodiscard]] QByteArray bytes() const { return ((head + data + tail).join(lineEnd) + lineEnd).toUtf8(); }
};

class Random {
public:
    explicit Random(unsigned seed)
        : m_random(seed) {}

    int below(int n) { return static_cast<int>(m_random() % static_cast<unsigned>(n)); }
    bool chance(int percent) { return below(100) < percent; }
    /// A whole number of tenths of µm.
    int tenths() { return below(400) - 200; }
    /// Rising; in thousandths of a millimetre or degree.
    std::vector<int> targets() {
        std::vector<int> found;
        int at = below(5) * 1000 - 2000;
        for (int i = 2 + below(12); i > 0; --i, at += 500 + below(60'000))
            found.push_back(at);
        return found;
    }
    void shuffle(QStringList &lines) { std::shuffle(lines.begin(), lines.end(), m_random); }

private:
    std::mt19937 m_random;
};

/// 1500 thousandths: "1.5", "1,500"…
QString decimal(double value, int decimals, bool comma) {
    QString text = QString::number(value, 'f', decimals);
    return comma ? text.replace('.', ',') : text;
}

constexpr double thousandth = 1000;
constexpr double perMrad = 180 / 3.14159265358979323846 / 1000;

Written rtl(Random &random) {
    const bool rotary = random.chance(25);
    const bool comma = random.chance(30);
    const bool bothWays = random.chance(75);
    const std::vector<int> targets = random.targets();
    const int runs = (1 + random.below(4)) * (bothWays ? 2 : 1);
    Written file;
    file.lineEnd = random.chance(50) ? "\r\n" : "\n";
    file.head << "HEADER::" << QString("File type : ") + (rotary ? "RTA" : "LIN")
              << QString("Owner : ") + (rotary ? "Rotary" : "Renishaw")
              << "TARGET DATA::" << QString("Filetype : ") + (rotary ? "ANG" : "LINEAR")
              << QString("Target-count : %1").arg(targets.size()) << "Targets : ";
    QString line;
    for (const int target : targets) {
        line += "  " + decimal(target / thousandth, 4, comma);
        if (random.chance(40)) {
            file.head << line;
            line.clear();
        }
    }
    if (!line.isEmpty())
        file.head << line;
    file.head << (bothWays ? "Flags: 0 0 2 0" : "Flags: 0 1 2 0") << "USER-TEXT::"
              << "Axis : Y"
              << "RUNS::" << QString("Run-count : %1").arg(runs) << "DEVIATIONS::"
              << "Run Target Data:";
    for (int run = 1; run <= runs; ++run) {
        const bool back = bothWays && run % 2 == 0;
        for (std::size_t k = 0; k < targets.size(); ++k) {
            const std::size_t i = back ? targets.size() - 1 - k : k;
            const int value = random.tenths();
            file.data << QString("  %1   %2   %3").arg(run).arg(i + 1).arg(decimal(value / 10.0, 3, comma));
            file.truth.push_back({back ? Direction::negative : Direction::positive,
                                  static_cast<std::size_t>(bothWays ? (run - 1) / 2 : run - 1),
                                  targets[i] / thousandth,
                                  rotary ? value / 10.0 * perMrad : value / 10.0 / 1000});
        }
    }
    file.tail << "ENVIRONMENT::"
              << "Air temp : 20.1"
              << "EOF::";
    return file;
}

Written indexed(Random &random) {
    const bool comma = random.chance(30);
    const std::vector<int> targets = random.targets();
    const int cycles = 1 + random.below(5);
    const int first = random.below(2);
    const bool bothWays = random.chance(75);
    Written file;
    file.head << "UNIT=\"mm\""
              << "AXIS=X" << QString("POSITIONS=%1").arg(targets.size()) << QString("CYCLES=%1").arg(cycles);
    for (std::size_t i = 0; i < targets.size(); ++i)
        file.data << QString("TGT_DATA[%1]=%2")
                         .arg(static_cast<int>(i) + first)
                         .arg(decimal(targets[i] / thousandth, 3, comma));
    for (int cycle = 0; cycle < cycles; ++cycle) {
        for (std::size_t i = 0; i < targets.size(); ++i) {
            for (const bool forward : {true, false}) {
                if (!forward && !bothWays)
                    continue;
                const int value = random.tenths();
                const double position = targets[i] / thousandth + value / 10'000.0;
                file.data << QString("REF_DATA_%1[%2,%3]=%4")
                                 .arg(QString(forward ? "FWD" : "BWD"))
                                 .arg(static_cast<int>(i) + first)
                                 .arg(cycle + first)
                                 .arg(decimal(position, 4, comma));
                file.truth.push_back({forward ? Direction::positive : Direction::negative,
                                      static_cast<std::size_t>(cycle), targets[i] / thousandth,
                                      value / 10'000.0});
            }
        }
    }
    if (random.chance(50))
        random.shuffle(file.data);
    return file;
}

Written compensationText(Random &random) {
    const bool comma = random.chance(30);
    const int step = 500 + random.below(60'000);
    const int n = 2 + random.below(12);
    const auto at = [&](int i) { return decimal(i * step / thousandth, 3, comma); };
    Written file;
    file.head << "Compensation table"
              << "Units : um" << QString("Compensation spacing %1 mm").arg(at(1))
              << QString("Compensation start %1 mm").arg(at(0))
              << QString("Compensation end %1 mm").arg(at(n - 1)) << ""
              << "No.  Axis position  Combined";
    for (int i = 0; i < n; ++i) {
        const int value = random.tenths();
        file.data << QString("%1  %2  %3").arg(i + 1).arg(at(i), decimal(value / 10.0, 1, comma));
        file.truth.push_back({Direction::positive, 0, i * step / thousandth, 0 - value / 10'000.0});
    }
    return file;
}

Written means(Random &random) {
    const bool comma = random.chance(30);
    const std::vector<int> targets = random.targets();
    Written file;
    file.head << "HEADER::"
              << "Flags: 0 0 2 0"
              << "Position   \tBidirectional Avg Error";
    for (const int target : targets)
        file.head << decimal(target / thousandth, 3, comma) + "\t" + decimal(0.001, 5, comma);
    for (const bool forward : {true, false}) {
        file.data << (forward ? "Position   \tForward Directional Avg Error"
                              : "Position   \tReverse Directional Avg Error");
        for (const int target : targets) {
            const int value = random.tenths();
            file.data << decimal(target / thousandth, 3, comma) + "\t" + decimal(value / 10'000.0, 5, comma);
            file.truth.push_back({forward ? Direction::positive : Direction::negative, 0, target / thousandth,
                                  value / 10'000.0});
        }
    }
    file.tail << "ENVIRONMENT::"
              << "Air temp : 20.1";
    return file;
}

/// What was read: its readings with their runs counted by direction.
std::vector<Truth> readingsOf(const Imported &imported) {
    std::vector<Truth> found;
    const auto *read =
        imported.test ? std::get_if<PositioningMeasurement>(&imported.test->measurement) : nullptr;
    std::size_t up = 0;
    std::size_t down = 0;
    for (const Run &run : read ? read->runs : std::vector<Run>()) {
        std::size_t &number = run.approach == Direction::positive ? up : down;
        for (std::size_t i = 0; i < run.deviations.size(); ++i) {
            if (run.deviations[i])
                found.push_back({run.approach, number, read->targets[i], *run.deviations[i]});
        }
        ++number;
    }
    return found;
}

/// Whether each reading is one of those that were written (to the last bits of an angle in mrad).
bool areAmong(const std::vector<Truth> &found, const std::vector<Truth> &truth) {
    constexpr double lastBits = 1e-12;
    return std::ranges::all_of(found, [&](const Truth &one) {
        return std::ranges::any_of(truth, [&](const Truth &other) {
            return one.key() == other.key() && std::abs(one.deviation - other.deviation) < lastBits;
        });
    });
}

/// A question about what this file says: those that each file of its kind is asked do not count.
bool isAboutData(const Question &question) {
    return question.id == "unread" || question.id == "directions" || question.id == "unequalRuns" ||
           question.id == "unit" || question.id == "spread" || question.id == "large" ||
           question.id == "targets";
}

using Writer = Written (*)(Random &);

} // namespace

Q_DECLARE_METATYPE(Writer)

/// Files as instruments write them, made at random from known readings: read as they were written, and what
/// is missing, doubled or damaged in them is said.
class RandomFilesTest : public QObject {
    Q_OBJECT

private slots:
    void areReadAsTheyWereWritten_data() {
        QTest::addColumn<Writer>("writer");
        QTest::newRow("rtl") << Writer(rtl);
        QTest::newRow("indexed") << Writer(indexed);
        QTest::newRow("ren") << Writer(compensationText);
        QTest::newRow("pos") << Writer(means);
    }
    void areReadAsTheyWereWritten() {
        QFETCH(Writer, writer);
        Random random(11);
        for (int trial = 0; trial < 300; ++trial) {
            const Written file = writer(random);
            const std::vector<Truth> found = readingsOf(importMeasurement(file.bytes(), "x"));
            QVERIFY2(found.size() == file.truth.size() && areAmong(found, file.truth),
                     file.bytes().constData());
        }
    }

    /// A line doubled, left out, cut, exchanged for one of another place, or a letter in it: what is read was
    /// written, or it is asked; what is not read is said.
    void damageIsSaid_data() { areReadAsTheyWereWritten_data(); }
    void damageIsSaid() {
        QFETCH(Writer, writer);
        Random random(12);
        for (int trial = 0; trial < 600; ++trial) {
            Written file = writer(random);
            const auto at = random.below(static_cast<int>(file.data.size()));
            const auto other = random.below(static_cast<int>(file.data.size()));
            QString &line = file.data[at];
            switch (random.below(5)) {
            case 0:
                file.data.insert(other, QString(line)); // doubled, somewhere
                break;
            case 1:
                file.data.removeAt(at);
                break;
            case 2: { // a letter instead of a character that is none
                const auto place = random.below(static_cast<int>(line.size()));
                if (!line[place].isSpace())
                    line[place] = 'x';
                break;
            }
            case 3: { // two readings of one place
                QString changed = line;
                if (changed.back().isDigit())
                    changed.back() = QChar('0' + (changed.back().digitValue() + 1) % 10);
                file.data.insert(at + 1, changed);
                break;
            }
            default: // cut before its last number
                line.truncate(line.lastIndexOf(QRegularExpression("[\\s=]")));
                break;
            }
            try {
                const Imported imported = importMeasurement(file.bytes(), "x");
                const std::vector<Truth> found = readingsOf(imported);
                const bool asked = std::ranges::any_of(imported.questions, isAboutData);
                const bool said = asked || std::ranges::any_of(imported.remarks, [](const Remark &remark) {
                                      return remark.grade == RemarkGrade::problem ||
                                             QByteArray(remark.message.text.source).contains("missing");
                                  });
                QVERIFY2(asked || areAmong(found, file.truth), file.bytes().constData());
                QVERIFY2(said || found.size() == file.truth.size(), file.bytes().constData());
            } catch (const Error &) { // said
            }
        }
    }

    /// More samples than the head announces are no whole file either.
    void furtherSamplesAreAsked() {
        const auto file = [](int announced, int there) {
            QByteArray bytes = "HEADER::\r\nFile Type : LINEAR\r\nActual sample rate : 4.0\r\nSample no : " +
                               QByteArray::number(announced) + "\r\nData:\r\n";
            for (int i = 0; i < there; ++i) {
                const double value = qToLittleEndian(i / 1000.0);
                bytes.append(reinterpret_cast<const char *>(&value), sizeof(value));
            }
            return bytes + "\r\nEOF::";
        };
        const auto asksForUnread = [&](int announced, int there) {
            const Imported imported = importMeasurement(file(announced, there), "x.rtx");
            return std::ranges::count(imported.questions, "unread", &Question::id) == 1;
        };
        QVERIFY(!asksForUnread(100, 100));
        QVERIFY(asksForUnread(10, 100));
        QVERIFY(asksForUnread(99, 100));
        QVERIFY_THROWS_EXCEPTION(Error, importMeasurement(file(101, 100), "x.rtx"));
    }

    /// A length in a unit that is not known is no length in millimetres.
    void unknownUnitsAreNotTaken() {
        const auto file = [](const QByteArray &unit) {
            return "<?xml version=\"1.0\"?><TEST_DOCUMENT><TEST_SPEC NAME=\"360\"><DYNAMIC_BALLBAR>"
                   "<NOMINAL_LENGTH DT=\"" +
                   unit +
                   "\">100</NOMINAL_LENGTH></DYNAMIC_BALLBAR></TEST_SPEC><RUN_RESULTS><BALLBAR_RUN>"
                   "<RUN_DIRECTION>CCW</RUN_DIRECTION><READINGS>1 2 3 4 5 6 7 8 9</READINGS></BALLBAR_RUN>"
                   "</RUN_RESULTS></TEST_DOCUMENT>";
        };
        const auto radius = [&](const QByteArray &unit, const ImportOptions &options = {}) {
            const Imported imported = importMeasurement(file(unit), "x.b5r", options);
            return std::get<CircularMeasurement>(imported.test->measurement).nominalRadius;
        };
        QCOMPARE(radius(""), 100.0);
        QCOMPARE(radius("UT_LENGTH_MM"), 100.0);
        QCOMPARE(radius("UT_LENGTH_M"), 100'000.0);
        QVERIFY_THROWS_EXCEPTION(Error, radius("UT_LENGTH_INCH"));
        QVERIFY_THROWS_EXCEPTION(Error, radius("UT_ANGLE"));
        ImportOptions stated;
        stated["nominalRadius"] = "150";
        QCOMPARE(radius("UT_LENGTH_INCH", stated), 150.0);
    }
};

QTEST_GUILESS_MAIN(RandomFilesTest)
#include "randomfiles.moc"
