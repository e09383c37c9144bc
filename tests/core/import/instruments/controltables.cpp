// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/documenterror.h"
#include "import/importmeasurement.h"
#include "import/instruments/compensationtable.h"

#include <QTest>
#include <algorithm>
#include <functional>

using namespace palmer;

namespace {

constexpr const char *linuxcnc = "-1.000 -1.005 -0.995\n0.000 0.002 -0.003\n1.000 1.003 0.998\n";
constexpr const char *trims = "-1.000 0.005 -0.005\n0.000 0.002 -0.003\n1.000 0.003 -0.004\n";
constexpr const char *encoder = "%_N_AX_EEC_INI\nCHANDATA(1)\n"
                                "$AA_ENC_COMP[0,0,X1]=0.003 ; 1st\n$AA_ENC_COMP[0,1,X1]=0.01\n"
                                "$AA_ENC_COMP[0,2,X1]=0.0\n$AA_ENC_COMP_STEP[0,X1]=400.0\n"
                                "$AA_ENC_COMP_MIN[0,X1]=-200.0\n$AA_ENC_COMP_MAX[0,X1]=600.0\n"
                                "$AA_ENC_COMP_IS_MODULO[0,X1]=0\nM17\n";
constexpr const char *sag =
    "CHANDATA(1)\n$AN_CEC [0.0] =0.001\n$AN_CEC[0,1]=0.002\n$AN_CEC_INPUT_AXIS[0]=(AX1)\n"
    "$AN_CEC_OUTPUT_AXIS[0]=(AX1)\n$AN_CEC_STEP[0]=100\n$AN_CEC_MIN[0]=0\n$AN_CEC_MAX[0]=100\n"
    "$AN_CEC_DIRECTION[0]=1\n$AN_CEC[1,0]=0.005\n$AN_CEC[1,1]=0.007\n$AN_CEC_INPUT_AXIS[1]=(AX1)\n"
    "$AN_CEC_OUTPUT_AXIS[1]=(AX1)\n$AN_CEC_STEP[1]=200\n$AN_CEC_MIN[1]=0\n$AN_CEC_MAX[1]=200\n"
    "$AN_CEC_DIRECTION[1]=-1\nM17\n";
constexpr const char *weihong = "; measured\nunit = mm\n[X]\n-570.025, 0.027, 0.083\n-450.020, 0.025, 0.077\n"
                                "[y]\n0.000, 0.000, 0.030\n";
constexpr const char *heidenhain =
    "BEGIN Y-AXIS.COM MM\nNR   AXISPOS   BACKLASH   Y\n"
    "0    -90       +0.002     +0.001\n1    -85                  -0.003\n[END]\n";
constexpr const char *aerotech =
    "; calibration\n:START 1 SAMPLEDIST=10 POSUNIT=PRIMARY CORUNIT=PRIMARY/1000\n"
    "0\n1.5\n2.5\n:END\n";

FoundTable read(const char *text, const char *name = "x.txt") {
    return readControlTable(QByteArrayView(text), QString::fromLatin1(name));
}

QString refusal(const QByteArray &bytes, const QString &name) {
    try {
        (void)importMeasurement(bytes, name);
        return {};
    } catch (const Error &error) {
        return QString::fromUtf8(error.message.text.source);
    }
}

} // namespace

/// Compensation tables of controls: read by their rules to be compared, never taken for a measurement.
class ControlTablesTest : public QObject {
    Q_OBJECT

private slots:
    void neverAMeasurement_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("name");
        QTest::newRow("LinuxCNC") << QByteArray(linuxcnc) << "x.comp";
        QTest::newRow("LinuxCNC, other ending") << QByteArray(linuxcnc) << "X.COM";
        QTest::newRow("LinuxCNC, type 1") << QByteArray(trims) << "x.cal";
        QTest::newRow("SINUMERIK") << QByteArray(encoder) << "x.mpf";
        QTest::newRow("SINUMERIK, sag") << QByteArray(sag) << "x.csv";
        QTest::newRow("Weihong") << QByteArray(weihong) << "axeserr.dat";
        QTest::newRow("Heidenhain") << QByteArray(heidenhain) << "y.com";
        QTest::newRow("Aerotech") << QByteArray(aerotech) << "x.cal";
        QTest::newRow("ND 287") << QByteArray("COMP.N0.000   =       +0.0000   =       +0.0000\n"
                                              "COMP.N0.001   =      +50.0000   =       +0.0021\n#\n")
                                << "x.txt";
        QTest::newRow("FANUC") << QByteArray("%\nN10000 P0\nN10001 P2\nN11023 P-1\n%\n") << "x.txt";
        QTest::newRow("KMotion") << QByteArray(
                                        "2,3\n50,50\n0,0\n0,0,0.001,-0.002,0\n0,1,50.01,0,0\n0,2,100.02,0,0\n"
                                        "1,0,0,50.003,0\n1,1,50.01,50,0\n1,2,100,50,0\n")
                                 << "geo.txt";
        QTest::newRow("KMotion, without offsets")
            << QByteArray("2,2\n1.0, 1.0\n0,0,0,0\n0,1,1.01,0\n1,0,0,1\n1,1,1,1\n") << "geo.csv";
        QTest::newRow("FANUC, with axes") << QByteArray("N10000Q1A1P10\nN10001Q1A1P-3\n") << "pitch.all";
        // Whatever is left of them.
        QTest::newRow("LinuxCNC, cut off") << QByteArray(linuxcnc).chopped(3) << "x.comp";
        QTest::newRow("LinuxCNC, a line and a half") << QByteArray("0 0 0\n100 0.") << "X.CAL";
        QTest::newRow("Weihong, cut off")
            << QByteArray(weihong).first(QByteArray(weihong).indexOf(']') + 4) << "AXESERR.DAT";
        QTest::newRow("Heidenhain, without its first line")
            << QByteArray("NR DIST BACKLASH\n0 0 0.001\n1 100 0.002\n") << "Y.COM";
        const auto utf16 = [](const QByteArray &text) {
            QByteArray bytes("\xFF\xFE");
            for (const char c : text)
                (bytes += c) += '\0';
            return bytes;
        };
        QTest::newRow("SINUMERIK in UTF-16") << utf16(encoder) << "x.txt";
        QTest::newRow("Weihong in UTF-16") << utf16(weihong) << "x.csv";
        QTest::newRow("Heidenhain in UTF-16") << utf16(heidenhain) << "x.txt";
        QTest::newRow("LinuxCNC in UTF-16") << utf16(linuxcnc) << "x.comp";
        QTest::newRow("with a byte order mark") << "\xEF\xBB\xBF" + QByteArray(encoder) << "x.txt";
        QTest::newRow("our own CSV") << QByteArray("# Palmer compensation axis=X unit=mm values=combined "
                                                   "form=absolute sign=correction decimalMark=point\n"
                                                   "position;value\n0;0.001\n100;0.002\n200;0.004\n")
                                     << "x.csv";
    }
    void neverAMeasurement() {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, name);
        for (QByteArray each :
             {bytes, QByteArray(bytes).replace("\n", "\r\n"), QByteArray(bytes).replace("\n", "\r")}) {
            const QString refused = refusal(each, name);
            QVERIFY2(refused.contains("is a compensation table"), qPrintable(refused));
            if (bytes.startsWith("\xFF\xFE"))
                break; // line ends of two bytes
        }
    }

    /// Three columns of numbers under another name may be one run each way.
    void threeColumnsMayBeAMeasurement() {
        QVERIFY(!refusal("0 0.002 -0.003\n100 0.003 -0.002\n200 0.004 -0.001\n", "x.txt")
                     .startsWith("this is a compensation table"));
        QVERIFY(controlOfTable("0 0.002 -0.003\n", u"x.txt") == nullptr);
        // Who compares it says that it is a table.
        QCOMPARE(read("0 0.002 -0.003\n100 0.003 -0.002\n").control, "LinuxCNC");
        QVERIFY_EXCEPTION_THROWN((void)read("0 0.002\n100 0.003\n"), Error);
        QVERIFY(controlOfTable("Target;1;2\n0;1;2\n", u"x.comp") == nullptr);
    }

    /// Other parameters and programs are none.
    void otherNumberedBlocksAreNoTable() {
        for (const char *text :
             {"N11024 P1\nN11025 P2\n", "N10 G1 X0\nN20 G1 X100\n", "N3620 P50\nN3621 P0\n"})
            QVERIFY2(controlOfTable(text, u"x.txt") == nullptr, text);
        QVERIFY_EXCEPTION_THROWN((void)read("N10000 P0\nN10001 P2\n"), Error);
    }

    /// The signs: what is added to the command.
    void readsByTheRulesOfTheControl() {
        using Values = std::vector<double>;
        const CompensationTable positions = read(linuxcnc, "x.comp").table;
        QVERIFY(positions.forward == (Values{0.005, -0.002, -0.003}));
        QVERIFY(positions.reverse == (Values{-0.005, 0.003, 0.002}));
        QVERIFY(read(trims, "x.comp").table.forward == (Values{0.005, 0.002, 0.003}));
        const CompensationTable siemens = read(encoder).table;
        QCOMPARE(siemens.axis, std::string("X1"));
        QVERIFY(siemens.positions == (Values{-200, 200, 600}));
        QVERIFY(siemens.forward == (Values{-0.003, -0.01, 0}) && siemens.reverse == siemens.forward);
        const CompensationTable both = read(sag).table;
        QCOMPARE(both.axis, std::string("AX1"));
        QVERIFY(both.positions == (Values{0, 100, 200}));
        QVERIFY(both.forward == (Values{-0.001, -0.002, -0.002}));
        QVERIFY(both.reverse == (Values{-0.005, -0.006, -0.007}));
        const FoundTable router = read(weihong);
        QCOMPARE(router.table.axis, std::string("X"));
        QVERIFY(router.table.reverse == (Values{0.083, 0.077}));
        QCOMPARE(router.remarks.size(), std::size_t(2)); // the sign, the other axis
        QVERIFY(readWeihongTable(weihong, true).table.reverse == (Values{-0.083, -0.077}));
        const CompensationTable klartext = read(heidenhain).table;
        QCOMPARE(klartext.axis, std::string("Y"));
        QVERIFY(klartext.forward == (Values{0.001, -0.003}) && klartext.reverse == (Values{0.002, -0.003}));
    }

    /// What LinuxCNC does not load is not there.
    void linuxcncStopsWhereTheControlStops() {
        QVERIFY_EXCEPTION_THROWN((void)readLinuxcncTable("# comment\n0 0 0\n", LinuxcncValues::positions),
                                 Error);
        QVERIFY_EXCEPTION_THROWN((void)readLinuxcncTable("\n0 0 0\n", LinuxcncValues::positions), Error);
        const FoundTable stopped = readLinuxcncTable("0 0 0\n1 1 1\n\n2 2 2\n", LinuxcncValues::positions);
        QCOMPARE(stopped.table.positions.size(), std::size_t(2));
        QCOMPARE(stopped.remarks.size(), std::size_t(1));
        QCOMPARE(readLinuxcncTable("0 0 0 rest\n1 1 1\n1 2 2\n3 3 3", LinuxcncValues::positions)
                     .table.positions.size(),
                 std::size_t(3));
        std::string many;
        for (int i = 0; i < 300; ++i)
            many += std::to_string(i) + " 0 0\n";
        QCOMPARE(readLinuxcncTable(many, LinuxcncValues::trims).table.positions.size(), std::size_t(256));
    }

    void refusesWhatNoControlTakes() {
        for (const char *text :
             {"$AA_ENC_COMP[0,0,X]=1\n", "$AA_ENC_COMP[0,0,X]=a\n", "$AA_ENC_COMP[0,0,X\n",
              "$AN_CEC[0,0]=1\n",
              // a point in between, or at the end, is missing
              "$AA_ENC_COMP[0,0,X]=1\n$AA_ENC_COMP[0,2,X]=1\n$AA_ENC_COMP_STEP[0,X]=1\n$AA_ENC_COMP_MIN[0,X]="
              "0\n",
              "$AA_ENC_COMP[0,0,X]=1\n$AA_ENC_COMP_STEP[0,X]=1\n$AA_ENC_COMP_MIN[0,X]=0\n$AA_ENC_COMP_MAX[0,"
              "X]=5\n",
              "$AA_ENC_COMP[0,0,X]=1\n$AA_ENC_COMP_STEP[0,X]=1e-9\n$AA_ENC_COMP_MIN[0,X]=0\n$AA_ENC_COMP_MAX["
              "0,X]=5\n",
              "unit = mm\n[X]\n0, 1, 2\n0, 1, 2\n", "unit = mm\n[X]\n0, 1, b\n",
              "BEGIN X.COM MM\nNR DATUM\n0 1\n", "BEGIN X.COM MM\n", ":START 1 SAMPLEDIST=1\n0\n", "hello"})
            QVERIFY_EXCEPTION_THROWN((void)read(text), Error);
    }

    /// Cut at any byte: an error, or a table that ascends.
    void cutAnywhere() {
        for (const char *text : {linuxcnc, trims, encoder, sag, weihong, heidenhain, aerotech}) {
            const QByteArray whole(text);
            for (qsizetype size = 0; size < whole.size(); ++size) {
                try {
                    const CompensationTable table = readControlTable(whole.first(size), u"x.comp").table;
                    QVERIFY(!table.positions.empty());
                    QVERIFY(table.forward.size() == table.positions.size() &&
                            table.reverse.size() == table.positions.size());
                    QVERIFY(std::ranges::adjacent_find(table.positions, std::ranges::greater_equal()) ==
                            table.positions.end());
                } catch (const Error &) {
                }
            }
        }
    }
};

QTEST_GUILESS_MAIN(ControlTablesTest)
#include "controltables.moc"
