// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/numerics/threefry.h"

#include <QTest>

using namespace palmer;

/// The generator of the simulations against the known answers of its authors (Random123, kat_vectors).
class ThreefryTest : public QObject {
    Q_OBJECT

private slots:
    void knownAnswers_data();
    void knownAnswers();
    void vectorsGiveTheSame();
};

namespace {

using Word = std::uint32_t;
using Words = std::array<Word, 4>;

constexpr Word all = 0xffffffff;
constexpr Words piDigits{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344};
constexpr Words morePiDigits{0xa4093822, 0x299f31d0, 0x082efa98, 0xec4e6c89};

} // namespace

Q_DECLARE_METATYPE(Words)

void ThreefryTest::knownAnswers_data() {
    QTest::addColumn<int>("rounds");
    QTest::addColumn<Words>("counter");
    QTest::addColumn<Words>("key");
    QTest::addColumn<Words>("expected");
    const Words zeros{};
    const Words ones{all, all, all, all};
    QTest::newRow("13 rounds, zeros")
        << 13 << zeros << zeros << Words{0x531c7e4f, 0x39491ee5, 0x2c855a92, 0x3d6abf9a};
    QTest::newRow("13 rounds, ones") << 13 << ones << ones
                                     << Words{0xc4189358, 0x1c9cc83a, 0xd5881c67, 0x6a0a89e0};
    QTest::newRow("13 rounds, digits of pi")
        << 13 << piDigits << morePiDigits << Words{0x4aa71d8f, 0x734738c2, 0x431fc6a8, 0xae6debf1};
    QTest::newRow("20 rounds, zeros")
        << 20 << zeros << zeros << Words{0x9c6ca96a, 0xe17eae66, 0xfc10ecd4, 0x5256a7d8};
    QTest::newRow("20 rounds, ones") << 20 << ones << ones
                                     << Words{0x2a881696, 0x57012287, 0xf6c7446e, 0xa16a6732};
    QTest::newRow("20 rounds, digits of pi")
        << 20 << piDigits << morePiDigits << Words{0x59cd1dbb, 0xb8879579, 0x86b5d00c, 0xac8b6d84};
}

void ThreefryTest::knownAnswers() {
    QFETCH(int, rounds);
    QFETCH(Words, counter);
    QFETCH(Words, key);
    QFETCH(Words, expected);
    const Words found =
        rounds == 13 ? Threefry<Word>::words<13>(counter, key) : Threefry<Word>::words<20>(counter, key);
    QCOMPARE(found, expected);
}

void ThreefryTest::vectorsGiveTheSame() {
    using Vector = std::uint32_t __attribute__((vector_size(16)));
    const auto lanes = Threefry<Vector>::words(
        {Vector{5, 6, 7, 8}, Vector{1, 1, 1, 1}, Vector{0, 2, 4, 6}, Vector{9, 9, 9, 9}}, piDigits);
    for (int lane = 0; lane < 4; ++lane) {
        const auto place = static_cast<Word>(lane);
        const Words one = Threefry<Word>::words({5 + place, 1, 2 * place, 9}, piDigits);
        for (std::size_t k = 0; k < one.size(); ++k)
            QCOMPARE(Word(lanes[k][lane]), one[k]);
    }
}

QTEST_APPLESS_MAIN(ThreefryTest)
#include "threefry.moc"
