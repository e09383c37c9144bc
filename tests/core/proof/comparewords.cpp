// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/compare.h"

#include <QTest>
#include <random>

using namespace palmer;

namespace {

/// Each word is 10 points wide, in one line.
PrintedWords words(const QStringList &texts) {
    PrintedWords result;
    for (const QString &text : texts)
        result.push_back({text, QRectF(10.0 * static_cast<double>(result.size()), 0.0, 9.0, 5.0)});
    return result;
}

PrintedWords randomWords(std::mt19937 &random, int alphabet, int count) {
    QStringList result;
    for (int i = 0; i < count; ++i)
        result << QString(QChar(u'a' + static_cast<int>(random() % static_cast<unsigned>(alphabet))));
    return words(result);
}

/// The length of the longest common sequence, by trying everything: for a few words.
std::size_t common(const PrintedWords &a, const PrintedWords &b, std::size_t i, std::size_t j) {
    if (i == a.size() || j == b.size())
        return 0;
    if (a[i].text == b[j].text)
        return 1 + common(a, b, i + 1, j + 1);
    return std::max(common(a, b, i + 1, j), common(a, b, i, j + 1));
}

qsizetype count(const QString &text) {
    return text.split(u' ', Qt::SkipEmptyParts).size();
}

} // namespace

class CompareWords : public QObject {
    Q_OBJECT

private slots:
    void oneChangedWordIsOneDifferenceAtItsPlace() {
        std::mt19937 random(1);
        for (int trial = 0; trial < 500; ++trial) {
            const PrintedWords follows = randomWords(random, 3, 1 + static_cast<int>(random() % 40));
            PrintedWords printed = follows;
            const std::size_t at = random() % printed.size();
            printed[at].text = QStringLiteral("7,7");
            const auto found = compareWords(printed, follows, 4);
            QCOMPARE(found.size(), std::size_t(1));
            QCOMPARE(found[0].page, 4);
            QCOMPARE(found[0].printed, QStringLiteral("7,7"));
            QCOMPARE(found[0].follows, follows[at].text);
            QCOMPARE(found[0].area, printed[at].area);
            QVERIFY(!found[0].what);
            QStringList around; // four on each side
            for (std::size_t i = at - std::min<std::size_t>(at, 4); i < std::min(at + 5, follows.size()); ++i)
                around << follows[i].text;
            QCOMPARE(found[0].context, around.join(u' '));
        }
    }

    void aMissingAndAnAddedWordAreNamed() {
        const PrintedWords all = words({"A", "12,3", "µm", "U", "0,4"});
        const PrintedWords less = words({"A", "12,3", "U", "0,4"});
        const auto missing = compareWords(less, all, 1);
        QCOMPARE(missing.size(), std::size_t(1));
        QCOMPARE(missing[0].printed, QString());
        QCOMPARE(missing[0].follows, QStringLiteral("µm"));
        QCOMPARE(missing[0].area, all[2].area); // where it should stand
        const auto added = compareWords(all, less, 1);
        QCOMPARE(added.size(), std::size_t(1));
        QCOMPARE(added[0].printed, QStringLiteral("µm"));
        QCOMPARE(added[0].follows, QString());
        QCOMPARE(added[0].area, all[2].area);
        QVERIFY(compareWords(all, all, 1).empty());
        QVERIFY(compareWords({}, {}, 1).empty());
        QCOMPARE(compareWords({}, all, 1).size(), std::size_t(1));
        QCOMPARE(compareWords(all, {}, 1).size(), std::size_t(1));
    }

    /// Against all alignments tried one by one: no word is named that need not be, and none is passed over.
    void noMoreWordsAreNamedThanDiffer() {
        std::mt19937 random(2);
        for (int trial = 0; trial < 2000; ++trial) {
            const PrintedWords printed = randomWords(random, 3, static_cast<int>(random() % 9));
            const PrintedWords follows = randomWords(random, 3, static_cast<int>(random() % 9));
            const auto same = static_cast<qsizetype>(common(printed, follows, 0, 0));
            qsizetype named = 0;
            qsizetype missing = 0;
            for (const Difference &difference : compareWords(printed, follows, 1)) {
                named += count(difference.printed);
                missing += count(difference.follows);
            }
            QCOMPARE(named, static_cast<qsizetype>(printed.size()) - same);
            QCOMPARE(missing, static_cast<qsizetype>(follows.size()) - same);
        }
    }

    void twoPlacesAreTwoDifferences() {
        const auto found =
            compareWords(words({"a", "X", "b", "c", "Y"}), words({"a", "x", "b", "c", "y"}), 2);
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0].printed, QStringLiteral("X"));
        QCOMPARE(found[1].printed, QStringLiteral("Y"));
    }

    /// Where the table of an alignment would be too large, all between the first and the last is one
    /// difference.
    void thousandsOfOtherWordsAreOneDifference() {
        QStringList one{"head"};
        QStringList other{"head"};
        for (int i = 0; i < 4001; ++i) {
            one << QStringLiteral("a%1").arg(i);
            other << QStringLiteral("b%1").arg(i);
        }
        one << QStringLiteral("foot");
        other << QStringLiteral("foot");
        const auto found = compareWords(words(one), words(other), 1);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(found[0].printed.startsWith(QStringLiteral("a0 a1 ")));
        QVERIFY(found[0].printed.endsWith(u'…') && found[0].printed.size() <= 301);
        QVERIFY(found[0].context.startsWith(QStringLiteral("head b0 ")));
    }
};

QTEST_APPLESS_MAIN(CompareWords)
#include "comparewords.moc"
