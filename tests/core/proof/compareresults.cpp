// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/compare.h"

#include <QTest>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

using namespace palmer;
using nlohmann::json;

namespace {

QByteArray bytes(const json &value, int indent = -1) {
    return QByteArray::fromStdString(value.dump(indent));
}

json randomValue(std::mt19937 &random, int depth) {
    switch (random() % (depth > 0 ? 6 : 4)) {
    case 0:
        return static_cast<double>(random() % 1000) / 8.0;
    case 1:
        return "word " + std::to_string(random() % 100);
    case 2:
        return random() % 2 == 0;
    case 3:
        return nullptr;
    case 4: {
        json array = json::array();
        for (unsigned i = 1 + random() % 4; i > 0; --i)
            array.push_back(randomValue(random, depth - 1));
        return array;
    }
    default: {
        json object = json::object();
        for (unsigned i = 1 + random() % 4; i > 0; --i)
            object["k" + std::to_string(i)] = randomValue(random, depth - 1);
        return object;
    }
    }
}

json randomResults(std::mt19937 &random) {
    json result{{"format", "palmer results"}, {"program", "Palmer 9"}};
    for (const char *key : {"tests", "instruments", "verdict"})
        result[key] = randomValue(random, 4);
    return result;
}

struct Leaf {
    json *value;
    QString path;
};

void collect(json &value, const QString &path, std::vector<Leaf> &leaves) {
    if (value.is_object()) {
        for (auto &[key, item] : value.items())
            collect(item, (path.isEmpty() ? path : path + u'.') + QString::fromStdString(key), leaves);
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i)
            collect(value[i], path + u'[' + QString::number(i) + u']', leaves);
    } else {
        leaves.push_back({&value, path});
    }
}

/// What a difference says of a value.
json value(const QString &text, const json &like) {
    return like.is_string() ? json(text.toStdString()) : json::parse(text.toStdString());
}

} // namespace

class CompareResults : public QObject {
    Q_OBJECT

private slots:
    void theSameBytesDoNotDiffer() {
        std::mt19937 random(1);
        for (int trial = 0; trial < 50; ++trial) {
            const QByteArray file = bytes(randomResults(random));
            QVERIFY(compareResults(file, file, true).empty());
            QVERIFY(compareResults(file, file, false).empty());
        }
    }

    void anyChangedValueIsFoundAtItsPath() {
        std::mt19937 random(2);
        for (int trial = 0; trial < 400; ++trial) {
            const json follows = randomResults(random);
            json printed = follows;
            std::vector<Leaf> leaves;
            collect(printed, {}, leaves);
            const Leaf leaf = leaves[random() % leaves.size()];
            const json before = *leaf.value;
            *leaf.value =
                before.is_number() ? json(before.get<double>() * (1 + 2e-9) + 2e-9) : json("forged");
            const bool sameProgram = leaf.path == QStringLiteral("program") || trial % 2 == 0;
            const auto found = compareResults(bytes(printed), bytes(follows), sameProgram);
            QCOMPARE(found.size(), std::size_t(1));
            QCOMPARE(found[0].context, QStringLiteral("results.json: ") + leaf.path);
            QVERIFY(value(found[0].printed, *leaf.value) == *leaf.value);
            QVERIFY(value(found[0].follows, before) == before);
            QCOMPARE(found[0].page, 0);
        }
    }

    /// Measured between processors with and without fused multiply-add: up to 2·10⁻¹² of a value.
    void theRoundingOfAnotherProcessorIsNoDifference() {
        const auto differs = [](const json &printed, const json &follows) {
            return !compareResults(bytes({{"a", printed}}), bytes({{"a", follows}}), true).empty();
        };
        for (const double number : {8.870774416783144, -0.0003575822151368143, 393.9078599903453, 1e-273}) {
            QVERIFY(!differs(number, number * (1 + 5e-10)));
            QVERIFY(!differs(number * (1 + 5e-10), number));
            QCOMPARE(differs(number, number * (1 + 2e-9)), std::abs(number) > 1e-3);
            QVERIFY(differs(number, number + 1e-5));
        }
        QVERIFY(!differs(0, 5e-13));
        QVERIFY(differs(0, 2e-12));
        QVERIFY(!differs(2, 2 + 4e-16));
        QVERIFY(differs(2'000'000'000, 2'000'000'001)); // whole numbers are counted
        QVERIFY(differs(1.5, "1.5"));
    }

    /// A newer program has more to say; what an older one said must still follow.
    void anotherVersionMaySayMoreAndNameItself() {
        const json printed{{"program", "Palmer 1"}, {"tests", {{{"A", 1.5}}}}};
        const json follows{{"program", "Palmer 2"}, {"tests", {{{"A", 1.5}, {"new", 2}}}}, {"more", true}};
        QVERIFY(compareResults(bytes(printed), bytes(follows), false).empty());
        QCOMPARE(compareResults(bytes(printed), bytes(follows), true).size(), std::size_t(3));
        const auto less = compareResults(bytes(follows), bytes(printed), false);
        QCOMPARE(less.size(), std::size_t(2));
        QCOMPARE(less[0].follows, QString());
        // Only the program's own name: one of the same word deeper down is a value.
        const json deep{{"tests", {{{"program", "a"}}}}};
        const json other{{"tests", {{{"program", "b"}}}}};
        QCOMPARE(compareResults(bytes(deep), bytes(other), false).size(), std::size_t(1));
    }

    void arraysOfOtherLengthsAreOneDifference() {
        const json printed{{"values", {1, 2, 3}}};
        const json follows{{"values", {1, 2}}};
        for (const bool same : {true, false}) {
            const auto found = compareResults(bytes(printed), bytes(follows), same);
            QCOMPARE(found.size(), std::size_t(1));
            QCOMPARE(found[0].printed, QStringLiteral("[1, 2, 3]"));
            QCOMPARE(found[0].context, QStringLiteral("results.json: values"));
        }
    }

    void longValuesAreCut() {
        const json printed{{"a", std::string(5000, 'x')}};
        const auto found = compareResults(bytes(printed), bytes({{"a", "y"}}), true);
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].printed, QString(300, u'x') + u'…');
    }

    void whatIsMissingWrittenOtherwiseOrNoJsonIsSaid() {
        const json results{{"a", 1}, {"b", {2, 3}}};
        for (const QByteArray &printed :
             {QByteArray(), bytes(results, 4), QByteArray("{\"a\":1"), QByteArray("\xff\xfe"),
              QByteArray("{\"a\":1,\"a\":1,\"b\":[2,3]}")}) {
            const auto found = compareResults(printed, bytes(results), true);
            QCOMPARE(found.size(), std::size_t(1));
            QVERIFY(found[0].what);
        }
        QVERIFY(compareResults(bytes(results, 4), bytes(results), false).empty());
    }

    void neverMoreThanTenThousand() {
        json printed = json::array();
        json follows = json::array();
        for (int i = 0; i < 12'000; ++i) {
            printed.push_back(i);
            follows.push_back(i + 1);
        }
        QCOMPARE(compareResults(bytes({{"v", printed}}), bytes({{"v", follows}}), true).size(),
                 std::size_t(10'000));
    }
};

QTEST_APPLESS_MAIN(CompareResults)
#include "compareresults.moc"
