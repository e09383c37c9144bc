// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/laws.h"

#include "document/savedocument.h"

#include <QApplication>
#include <QTest>

using namespace palmer::laws;

/// A small sample of what palmer-laws does: the same files in every run.
class LawsTest : public QObject {
    Q_OBJECT

private slots:
    void everyLawHolds();
    void noDefaultClaimsAFact();

private:
    Json m_schema = Json::parse(palmer::readBytes(QStringLiteral(PALMER_SCHEMA)).toStdString());
};

void LawsTest::everyLawHolds() {
    constexpr std::uint64_t files = 300;
    constexpr std::size_t statements = 0; // of each file all
    Counts all;
    for (std::uint64_t seed = 1; seed <= files; ++seed) {
        Generator generator(m_schema, seed);
        Laws laws(generator, statements, seed);
        const Json file = generator.file();
        for (const Violation &violation : laws.follow(file, seed % 20 == 0))
            QFAIL(qPrintable(
                QStringLiteral("file %1, %2: %3")
                    .arg(seed)
                    .arg(QString::fromStdString(violation.law), QString::fromStdString(violation.what))));
        all.tests += laws.counts().tests;
        all.limits += laws.counts().limits;
        all.statements += laws.counts().statements;
        all.texts += laws.counts().texts;
        all.numbers += laws.counts().numbers;
        all.pages += laws.counts().pages;
        all.reports += laws.counts().reports;
    }
    // Something was followed: a generator that makes nothing breaks no law.
    QVERIFY(all.tests > 400 && all.limits > 1000 && all.statements > 20'000 && all.texts > 10'000);
    QVERIFY(all.numbers > 10'000 && all.pages > 500 && all.reports == 15);
}

/// A key that a file leaves out says nothing, unless it is a choice of evaluation or report.
void LawsTest::noDefaultClaimsAFact() {
    const std::set<std::string> choices{"motion",
                                        "source", // what makes the readings results at all
                                        "standardDeviation",
                                        "centring",
                                        "referenceCircle",
                                        "rule", // printed as the choice made
                                        "guardFactor",
                                        "method",
                                        "positioningUncertaintyMethod",
                                        "uncertaintyMethod",
                                        "driftModel",
                                        "seed",
                                        "kind",
                                        "sameSensor",
                                        "coverageFactor", // how the uncertainty is made
                                        "signatures",
                                        "languages",
                                        "paper",
                                        "include",
                                        "figures",         // of the report
                                        "angleReference"}; // how angles count
    QStringList claims;
    int defaults = 0;
    const auto walk = [&](const auto &self, const Json &at, const std::string &name) -> void {
        if (at.is_object() && at.contains("default")) {
            ++defaults;
            const Json &value = at["default"];
            const bool nothing = value.is_null() || value == "" || value == "notStated" ||
                                 value == "not stated" ||
                                 (value.is_structured() &&
                                  std::ranges::all_of(value, [](const Json &one) { return one.is_null(); }));
            if (!nothing && !choices.contains(name))
                claims << QString::fromStdString(name + ": " + value.dump());
        }
        if (at.is_structured()) {
            for (const auto &[key, below] : at.items())
                self(self, below, key);
        }
    };
    walk(walk, m_schema, "");
    QCOMPARE(claims.join(u' '), QString());
    QVERIFY(defaults > 40);
}

QTEST_MAIN(LawsTest)
#include "lawstest.moc"
