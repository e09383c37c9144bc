// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/laws.h"
#include "laws/doors.h"
#include "laws/importchoices.h"

#include <QApplication>
#include <QTest>

using namespace palmer::laws;

/// A small sample of what palmer-laws does: the same files in every run.
class LawsTest : public QObject {
    Q_OBJECT

private slots:
    void everyLawHolds();
    void noDefaultClaimsAFact();
    void everyDoorSaysTheSame();
    void everyAnswerIsTaken();
};

void LawsTest::everyLawHolds() {
    constexpr int files = 200;
    QStringList violations;
    const Counts all = followFiles(files, 1, 0, [&](std::uint64_t seed, const Violation &violation) {
        violations << QStringLiteral("file %1, %2: %3")
                          .arg(seed)
                          .arg(QString::fromStdString(violation.law), QString::fromStdString(violation.what));
    });
    QVERIFY2(violations.isEmpty(), qPrintable(violations.join(u'\n')));
    // Something was followed: a generator that makes nothing breaks no law.
    QVERIFY(all.tests > files && all.limits > 700 && all.results > 1500 && all.statements > 20'000 &&
            all.texts > 10'000);
    QVERIFY(all.numbers > 10'000 && all.pages > 500 && all.reports == files / 20 && all.readBack > files &&
            all.programs > files / 2);
}

/// A key that a file leaves out says nothing.
void LawsTest::noDefaultClaimsAFact() {
    for (const std::string &claim : claimingDefaults())
        QFAIL(claim.c_str());
}

void LawsTest::everyDoorSaysTheSame() {
    constexpr int tables = 60; // of each kind
    QStringList violations;
    const DoorCounts all = followDoors(tables, 1, [&](const std::string &door, const std::string &what) {
        violations << QString::fromStdString(door + ": " + what);
    });
    QVERIFY2(violations.isEmpty(), qPrintable(violations.join(u"\n=====\n")));
    QVERIFY(all.tables == 6 * tables && all.equal > 12 * tables && all.asked + all.refused < tables);
}

void LawsTest::everyAnswerIsTaken() {
    constexpr int rounds = 4; // files of each kind
    QStringList violations;
    const ChoiceCounts all = followChoices(rounds, 1, [&](const std::string &law, const std::string &what) {
        violations << QString::fromStdString(law + ": " + what);
    });
    QVERIFY2(violations.isEmpty(), qPrintable(violations.join(u"\n=====\n")));
    for (const std::string &key : all.missing())
        QFAIL(("in no file: " + key).c_str());
    QVERIFY(all.refused * 4 < all.files && all.answers > 10 * rounds);
}

QTEST_MAIN(LawsTest)
#include "lawstest.moc"
