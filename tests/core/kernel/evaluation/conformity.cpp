// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/conformity.h"

#include <QTest>

using namespace palmer;

class Conformity : public QObject {
    Q_OBJECT

private slots:
    void decides_data();
    void decides();
    void worstWins();
};

using OptionalNumber = std::optional<double>;
Q_DECLARE_METATYPE(OptionalNumber)
Q_DECLARE_METATYPE(palmer::DecisionRule)
Q_DECLARE_METATYPE(palmer::Verdict)

void Conformity::decides_data() {
    QTest::addColumn<OptionalNumber>("value");
    QTest::addColumn<double>("limit");
    QTest::addColumn<OptionalNumber>("u");
    QTest::addColumn<DecisionRule>("rule");
    QTest::addColumn<Verdict>("verdict");
    const DecisionRule simple;
    const DecisionRule proven{Rule::iso14253_1, 1.0};
    const DecisionRule narrow{Rule::iso14253_1, 0.83};
    const DecisionRule rejection{Rule::rejectionProven, 1.0};
    const OptionalNumber none;
    const auto row = [](const char *name, OptionalNumber value, double limit, OptionalNumber u,
                        DecisionRule rule,
                        Verdict verdict) { QTest::newRow(name) << value << limit << u << rule << verdict; };
    row("simple: below", 9.9, 10, none, simple, Verdict::conforms);
    row("simple: at the limit", 10, 10, none, simple, Verdict::conforms);
    row("simple: equal in decimals", 0.1 + 0.2, 0.3, none, simple, Verdict::conforms);
    row("simple: just above", 10.04, 10, 5.0, simple, Verdict::doesNotConform);
    // rounding of sums: 1e-12 of the larger of both
    row("simple: above by rounding", 10 * (1 + 0.9e-12), 10, none, simple, Verdict::conforms);
    row("simple: above by more than rounding", 10 * (1 + 1.2e-12), 10, none, simple, Verdict::doesNotConform);
    row("simple: limit of zero", 1e-9, 0, none, simple, Verdict::doesNotConform);
    row("proven: in the band by rounding", 8 + 0.9e-11, 10, 2.0, proven, Verdict::conforms);
    row("proven: in the band by more", 8 + 1.1e-11, 10, 2.0, proven, Verdict::notProven);
    row("proven: band left by rounding", 12 + 1.1e-11, 10, 2.0, proven, Verdict::notProven);
    row("proven: band left by more", 12 + 1.3e-11, 10, 2.0, proven, Verdict::doesNotConform);
    row("simple: signed value by its size", -10.5, 10, none, simple, Verdict::doesNotConform);
    row("simple: signed value inside", -9.5, 10, none, simple, Verdict::conforms);
    row("simple: no value", none, 10, none, simple, Verdict::notProven);
    row("proven: below the band", 8, 10, 2.0, proven, Verdict::conforms);
    row("proven: in the band, below", 8.1, 10, 2.0, proven, Verdict::notProven);
    row("proven: in the band, above", 12, 10, 2.0, proven, Verdict::notProven);
    row("proven: above the band", 12.1, 10, 2.0, proven, Verdict::doesNotConform);
    row("proven: narrower band", 8.3, 10, 2.0, narrow, Verdict::conforms);
    row("proven: no uncertainty", 1, 10, none, proven, Verdict::notProven);
    row("proven: signed value", -12.1, 10, 2.0, proven, Verdict::doesNotConform);
    row("rejection: in the band", 11, 10, 2.0, rejection, Verdict::notProven);
    row("rejection: above the band", 12.5, 10, 2.0, rejection, Verdict::doesNotConform);
    row("rejection: no uncertainty", 99, 10, none, rejection, Verdict::notProven);
}

void Conformity::decides() {
    QFETCH(OptionalNumber, value);
    QFETCH(double, limit);
    QFETCH(OptionalNumber, u);
    QFETCH(DecisionRule, rule);
    QFETCH(Verdict, verdict);
    QCOMPARE(static_cast<int>(decide(value, limit, u, rule)), static_cast<int>(verdict));
}

void Conformity::worstWins() {
    QVERIFY(!worst(std::nullopt, std::nullopt));
    QVERIFY(worst(Verdict::conforms, std::nullopt) == Verdict::conforms);
    QVERIFY(worst(Verdict::conforms, Verdict::notProven) == Verdict::notProven);
    QVERIFY(worst(Verdict::doesNotConform, Verdict::notProven) == Verdict::doesNotConform);
}

QTEST_GUILESS_MAIN(Conformity)
#include "conformity.moc"
