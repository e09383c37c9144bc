// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "editing/limitblock.h"

#include "document/documenterror.h"
#include "language/language.h"

#include <QTest>
#include <random>

using namespace palmer;

namespace {

const std::vector<LimitName> names{{"A", "A"}, {"A+", "A↑"},   {"A-", "A↓"},  {"R", "R"},
                                   {"B", "B"}, {"Bmean", "B̄"}, {"Gb", "G(b)"}};

PastedLimits paste(const QString &block, std::size_t first = 0, Limits limits = {},
                   Quantity quantity = Quantity::deviation, DisplayUnits units = {}) {
    return pasteLimits(std::move(limits), names, first, block, quantity, units);
}

QString refusal(const QString &block, std::size_t first = 0) {
    try {
        (void)paste(block, first);
    } catch (const Error &error) {
        return Language(Language::Id::english).sentence(error.message);
    }
    return "taken";
}

} // namespace

class LimitBlockTest : public QObject {
    Q_OBJECT

private slots:
    void linesAreRead_data() {
        QTest::addColumn<QString>("block");
        QTest::addColumn<QString>("id");
        QTest::addColumn<double>("limit");
        QTest::newRow("a spreadsheet") << "A\t15\nR\t8"
                                       << "R" << 0.008;
        QTest::newRow("a heading with a unit") << "Symbol\tLimit (mm)\nA\t0,015"
                                               << "A" << 0.015;
        QTest::newRow("a unit in the cell") << "A\t15 µm\nR\t0.008 mm"
                                            << "R" << 0.008;
        QTest::newRow("a unit in a cell of its own") << "A\t0.012\tmm"
                                                     << "A" << 0.012;
        QTest::newRow("with names") << "A\taccuracy\t15\nR\trepeatability\t8"
                                    << "A" << 0.015;
        QTest::newRow("symbols with arrows") << "A↑\t7,5\nA↓\t6,5"
                                             << "A-" << 0.0065;
        QTest::newRow("ids") << "A+;7.5"
                             << "A+" << 0.0075;
        QTest::newRow("a mean") << "B̄ 2,5"
                                << "Bmean" << 0.0025;
        QTest::newRow("a circle") << "G (b)\t≤ 20"
                                  << "Gb" << 0.020;
        QTest::newRow("typed") << "A 15\nR 8"
                               << "R" << 0.008;
        QTest::newRow("empty lines, CR") << "A\t15\r\n\r\nR\t8\r\n"
                                         << "R" << 0.008;
        QTest::newRow("to the last bit") << "A\t2,1 µm"
                                         << "A" << 0.0021;
        QTest::newRow("a lower one") << "A\t−10"
                                     << "A" << -0.010;
        QTest::newRow("numbers alone") << "15\n7,5\n6,5\n8"
                                       << "R" << 0.008;
    }
    void linesAreRead() {
        QFETCH(const QString, block);
        QFETCH(const QString, id);
        QFETCH(const double, limit);
        const PastedLimits pasted = paste(block);
        QVERIFY(pasted.taken > 0);
        QVERIFY(pasted.limits.contains(id.toStdString()));
        QCOMPARE(pasted.limits.at(id.toStdString()).value.value(), limit);
    }

    void whatIsNoLimitTakesNothing_data() {
        QTest::addColumn<QString>("block");
        QTest::addColumn<QString>("said");
        QTest::newRow("an unknown symbol") << "A\t15\nQ\t8"
                                           << "line 2";
        QTest::newRow("two numbers") << "A\t16,2\t15"
                                     << "several numbers";
        QTest::newRow("a text among them") << "A\t15\nsee contract\nR\t8"
                                           << "line 2";
        QTest::newRow("no number") << "A\t15\nR\t1,2,3"
                                   << "line 2";
        QTest::newRow("an angle") << "A\t15 ″"
                                  << "unit in line 1";
        QTest::newRow("more than there are") << "1\n2\n3\n4\n5\n6\n7\n8"
                                             << "line 8";
    }
    void whatIsNoLimitTakesNothing() {
        QFETCH(const QString, block);
        QFETCH(const QString, said);
        QVERIFY2(refusal(block).contains(said), qPrintable(refusal(block)));
    }

    void numbersAloneBeginAtTheRow() {
        const PastedLimits pasted = paste("1\n2", 3);
        QCOMPARE(pasted.limits.size(), std::size_t(2));
        QCOMPARE(pasted.limits.at("R").value.value(), 0.001);
        QCOMPARE(pasted.limits.at("B").value.value(), 0.002);
        QVERIFY(refusal("1\n2", 6).contains("line 2"));
    }

    void theRestStaysAsItIs() {
        const Limits before{{"A", {0.03, "ISO 230-2:2006", "contract 1"}}, {"B", {0.004, {}, "contract 1"}}};
        const PastedLimits pasted = paste("A\t15\tISO 230-2:2014\nB\t–\nR\t8", 0, before);
        QCOMPARE(pasted.taken, std::size_t(2));
        QCOMPARE(pasted.limits.at("A").value.value(), 0.015);
        QCOMPARE(pasted.limits.at("A").edition.value(), std::string("ISO 230-2:2014"));
        QCOMPARE(pasted.limits.at("A").source, std::string("contract 1"));
        QVERIFY(pasted.limits.at("B") == before.at("B"));
        QVERIFY(paste("\n \n", 0, before).limits == before);
    }

    void unitsAreThoseShown() {
        DisplayUnits units;
        units.lengths = LengthDisplay::millimetres;
        QCOMPARE(paste("A\t0.015", 0, {}, Quantity::deviation, units).limits.at("A").value.value(), 0.015);
        QCOMPARE(paste("A\t7.2", 0, {}, Quantity::angularDeviation).limits.at("A").value.value(), 7.2 / 3600);
        QCOMPARE(paste("A\t0.002 °", 0, {}, Quantity::angularDeviation).limits.at("A").value.value(), 0.002);
    }

    /// The unit that was taken is said, and another can be chosen for numbers that have none of their own.
    void theUnitCanBeChosen() {
        const auto unitOf = [](const PastedLimits &pasted) {
            return pasted.units.empty() ? QString() : QString::fromStdString(pasted.units.front().value);
        };
        QCOMPARE(unitOf(paste("A\t15")), QString("um"));
        QCOMPARE(unitOf(paste("Symbol\tLimit (mm)\nA\t0.015")), QString("mm"));
        QCOMPARE(unitOf(paste("A\t15 µm")), QString());
        const PastedLimits chosen = pasteLimits({}, names, 0, "Symbol\tLimit (µm)\nA\t15\nR\t8 µm",
                                                Quantity::deviation, {}, {{"unit", "mm"}});
        QCOMPARE(chosen.limits.at("A").value.value(), 15.0);
        QCOMPARE(chosen.limits.at("R").value.value(), 0.008);
        QCOMPARE(unitOf(chosen), QString("mm"));
    }

    /// Any order of lines, separator, decimal mark and unit gives the same limits.
    void theFormDoesNotMatter() {
        std::mt19937 random(5);
        for (int trial = 0; trial < 500; ++trial) {
            Limits wanted;
            QStringList lines;
            const bool comma = random() % 2 == 0;
            const QString separator = QStringList{"\t", ";", "|"}.at(static_cast<qsizetype>(random() % 3));
            for (const LimitName &name : names) {
                if (random() % 3 == 0)
                    continue;
                const int tenths = 1 + static_cast<int>(random() % 999);
                wanted[name.id].value = QString("%1e-4").arg(tenths).toDouble();
                const bool mm = random() % 4 == 0;
                QString number = QString::number(mm ? tenths * 1e-4 : tenths / 10.0, 'f', mm ? 4 : 1);
                if (comma)
                    number.replace('.', ',');
                QStringList cells{random() % 2 == 0 ? name.symbol : QString::fromStdString(name.id)};
                if (random() % 3 == 0)
                    cells << "any words";
                if (mm)
                    cells << (random() % 2 == 0 ? number + " mm" : number + separator + "mm");
                else
                    cells << number;
                lines << cells.join(separator);
            }
            std::ranges::shuffle(lines, random);
            if (random() % 2 == 0)
                lines.prepend(QStringList{"Symbol", "Limit (µm)"}.join(separator));
            const PastedLimits pasted = paste(lines.join('\n'));
            QCOMPARE(pasted.taken, wanted.size());
            QVERIFY2(pasted.limits == wanted, qPrintable(lines.join('\n')));
        }
    }
};

QTEST_APPLESS_MAIN(LimitBlockTest)
#include "limitblock.moc"
