// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/printednumbers.h"

#include "kernel/evaluation/conformity.h"

#include <QTest>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

using namespace palmer;
using namespace Qt::StringLiterals;

namespace {

using Whole = std::int64_t; ///< of up to 18 digits

/// A printed number as a whole number of 10⁻ⁿ: exact, other than doubles.
struct Exact {
    Whole digits = 0;
    int decimals = 0;
};

Exact exact(QString text) {
    text.remove(QChar(u'\u202F')).replace(u'\u2212', u'-').replace(u',', u'.');
    const bool negative = text.startsWith(u'-');
    Exact result;
    bool fraction = false;
    for (const QChar c : text) {
        fraction |= c == u'.';
        if (!c.isDigit())
            continue;
        result.digits = result.digits * 10 + c.digitValue();
        result.decimals += fraction ? 1 : 0;
    }
    result.digits = negative ? -result.digits : result.digits;
    return result;
}

Exact to(Exact number, int decimals) {
    for (; number.decimals < decimals; ++number.decimals)
        number.digits *= 10;
    return number;
}

int compare(const Exact &a, const Exact &b) {
    const int decimals = std::max(a.decimals, b.decimals);
    const Whole difference = to(a, decimals).digits - to(b, decimals).digits;
    return difference < 0 ? -1 : difference > 0 ? 1 : 0;
}

Exact negated(Exact number) {
    return {-number.digits, number.decimals};
}

Exact sum(const Exact &a, const Exact &b) {
    const int decimals = std::max(a.decimals, b.decimals);
    return {to(a, decimals).digits + to(b, decimals).digits, decimals};
}

Exact product(const Exact &a, const Exact &b) {
    return {a.digits * b.digits, a.decimals + b.decimals};
}

/// The verdict of a reader who has nothing but what is printed.
Verdict readersVerdict(const PrintedNumbers &numbers, Bound bound, const DecisionRule &rule,
                       const QString &factor) {
    Exact value = exact(numbers.value);
    Exact limit = exact(numbers.limit);
    if (bound == Bound::lower) {
        value = negated(value);
        limit = negated(limit);
    } else if (bound == Bound::magnitude && value.digits < 0) {
        value = negated(value);
    }
    if (rule.rule == Rule::simpleAcceptance)
        return compare(value, limit) <= 0 ? Verdict::conforms : Verdict::doesNotConform;
    if (numbers.uncertainty.isEmpty())
        return Verdict::notProven;
    const Exact guard = product(exact(numbers.uncertainty), exact(factor));
    if (compare(value, sum(limit, negated(guard))) <= 0)
        return Verdict::conforms;
    return compare(value, sum(limit, guard)) > 0 ? Verdict::doesNotConform : Verdict::notProven;
}

Parameter result(double value, double limit, std::optional<double> uncertainty, Bound bound,
                 Quantity quantity = Quantity::deviation) {
    Parameter parameter;
    parameter.term.id = "B";
    parameter.term.quantity = quantity;
    parameter.value = value;
    parameter.limit = Limit{limit, std::nullopt, {}};
    parameter.limitOf = "B";
    parameter.bound = bound;
    parameter.expandedUncertainty = uncertainty;
    return parameter;
}

Verdict verdictOf(const Parameter &p, const DecisionRule &rule) {
    return decideUpper(judgedValue(*p.value, p.bound), judgedLimit(*p.limit->value, p.bound),
                       p.expandedUncertainty, rule);
}

constexpr std::array rules{Rule::simpleAcceptance, Rule::iso14253_1, Rule::rejectionProven};
constexpr std::array bounds{Bound::magnitude, Bound::upper, Bound::lower};
constexpr std::array factors{1.0, 0.83, 0.5, 1.65};

} // namespace

class PrintedNumbersTest : public QObject {
    Q_OBJECT

private slots:
    void examples_data();
    void examples();
    void printedNumbersGiveTheVerdict();
    void theEndOfTheBandLeavesTheValueOnItsSide();
    void twoDigitsOfUncertainty();
    void noMoreDigitsThanNeeded();
    void limitsAsEntered();
    void limitOfF();
    void significantDigits_data();
    void significantDigits();
    void nothingBecomesNought();
};

void PrintedNumbersTest::examples_data() {
    QTest::addColumn<double>("value"); // µm
    QTest::addColumn<double>("limit");
    QTest::addColumn<double>("uncertainty"); // 0: none
    QTest::addColumn<double>("factor");      // 0: simple acceptance
    QTest::addColumn<int>("bound");
    QTest::addColumn<QString>("printed"); // value, U, limit, reach
    const auto row = [](const char *name, double value, double limit, double uncertainty, double factor,
                        Bound bound, const char *printed) {
        QTest::newRow(name) << value << limit << uncertainty << factor << static_cast<int>(bound)
                            << QString::fromUtf8(printed);
    };
    row("10.04 beyond 10", 10.04, 10, 0, 0, Bound::magnitude, "10.04||10|");
    row("10.05 beyond 10: the tie goes down", 10.05, 10, 0, 0, Bound::magnitude, "10.05||10|");
    row("U has no more digits for that", 10.001, 10, 14.3, 0, Bound::magnitude, "10.001|14.3|10|");
    row("10.06 beyond 10", 10.06, 10, 0, 0, Bound::magnitude, "10.1||10|");
    row("9.96 within 10", 9.96, 10, 0, 0, Bound::magnitude, "10.0||10|");
    row("9.96 within 9.98, not 10.0", 9.96, 9.98, 0, 0, Bound::magnitude, "9.96||9.98|");
    row("4.476 within 4.48, not 4.5", 4.476, 4.48, 0, 0, Bound::magnitude, "4.48||4.48|");
    row("a lower limit passed by little", -10.04, -10, 0, 0, Bound::lower, "−10.04||−10|");
    row("a lower limit passed by much", -12.3, -10, 0, 0, Bound::lower, "−12.3||−10|");
    row("above a lower limit by little", -9.96, -9.98, 0, 0, Bound::lower, "−9.96||−9.98|");
    row("above a lower limit", 3, -10, 0, 0, Bound::lower, "3.0||−10|");
    row("a lower limit and its band", -12.3, -10, 1, 1, Bound::lower, "−12.30|1.00|−10|−11.00");
    row("the band of a factor", 19.573, 18.5, 1.34, 0.83, Bound::magnitude, "19.57|1.34|18.5|19.6122");
    row("as large as the limit, with the rounding of a sum", 0.1 + 0.2, 0.3, 0, 0, Bound::magnitude,
        "0.3||0.3|");
}

void PrintedNumbersTest::examples() {
    QFETCH(double, value);
    QFETCH(double, limit);
    QFETCH(double, uncertainty);
    QFETCH(double, factor);
    QFETCH(int, bound);
    const Parameter parameter =
        result(value / 1000, limit / 1000, uncertainty > 0 ? std::optional(uncertainty / 1000) : std::nullopt,
               static_cast<Bound>(bound));
    const DecisionRule rule{factor > 0 ? Rule::iso14253_1 : Rule::simpleAcceptance, factor > 0 ? factor : 1};
    const PrintedNumbers numbers =
        printedNumbers(parameter, rule, std::nullopt, Language(Language::Id::english));
    QFETCH(QString, printed);
    const QString found =
        (QStringList{numbers.value, numbers.uncertainty, numbers.limit, numbers.reach}).join(u'|');
    if (uncertainty > 0)
        QVERIFY2(readersVerdict(numbers, parameter.bound, rule, QString::number(factor)) ==
                     verdictOf(parameter, rule),
                 qPrintable(found));
    else
        QCOMPARE(found, printed);
}

void PrintedNumbersTest::printedNumbersGiveTheVerdict() {
    std::mt19937_64 random(14253);
    std::uniform_real_distribution<double> uniform(0, 1);
    const Language english(Language::Id::english);
    const Language french(Language::Id::french);
    int verdicts[3]{};
    for (int i = 0; i < 60'000; ++i) {
        const DecisionRule rule{rules[random() % 3], factors[random() % 4]};
        const Bound bound = bounds[random() % 3];
        const Quantity quantity = random() % 4 ? Quantity::deviation : Quantity::angularDeviation;
        const double unit = quantity == Quantity::deviation ? 1e-3 : 1 / 3600.0;
        // Limits and U as people write them, values from near the borders and far from them, some of them
        // with few digits so that equality is met.
        const double limit = std::round(uniform(random) * 400 + 1) / (random() % 2 ? 10 : 100);
        const double u =
            random() % 2 ? std::round(uniform(random) * 40 + 1) / 10 : uniform(random) * limit / 2;
        const double border = limit + (static_cast<int>(random() % 3) - 1) * rule.guardFactor * u;
        double value = border + std::pow(10, -5 * uniform(random)) * (uniform(random) - 0.5);
        if (random() % 3 == 0)
            value = std::round(value * 100) / 100;
        if (random() % 5 == 0)
            value = border;
        const double sign = bound == Bound::lower ? -1 : 1;
        const double signOfValue = bound == Bound::magnitude && random() % 2 ? -1 : sign;
        const auto uncertainty = random() % 8 ? std::optional(u * unit) : std::nullopt;
        const Parameter parameter =
            result(signOfValue * value * unit, sign * limit * unit, uncertainty, bound, quantity);
        const Verdict verdict = verdictOf(parameter, rule);
        ++verdicts[static_cast<int>(verdict)];
        const PrintedNumbers numbers =
            printedNumbers(parameter, rule, std::nullopt, random() % 2 ? english : french,
                           i % 2 ? Rounding::twoDigits : Rounding::palmer);
        const QString shown = numbers.value + u' ' + numbers.uncertainty + u" against "_s + numbers.limit +
                              u", factor "_s + QString::number(rule.guardFactor);
        QVERIFY2(readersVerdict(numbers, bound, rule, QString::number(rule.guardFactor)) == verdict,
                 qPrintable(shown));
        QVERIFY2(numbers.value.size() < 20 && numbers.limit.size() < 12, qPrintable(shown));
    }
    for (const int count : verdicts)
        QVERIFY(count > 5'000);
}

void PrintedNumbersTest::theEndOfTheBandLeavesTheValueOnItsSide() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    const Language language(Language::Id::english);
    int beyond = 0;
    for (int i = 0; i < 20'000; ++i) {
        const DecisionRule rule{Rule::iso14253_1, factors[random() % 4]};
        const Bound bound = bounds[random() % 3];
        const double sign = bound == Bound::lower ? -1 : 1;
        const double limit = std::round(uniform(random) * 300 + 10) / 10;
        const double u = uniform(random) * 4 + 0.05;
        const double value = limit + rule.guardFactor * u + (uniform(random) - 0.3) * 0.2;
        const Parameter p = result(sign * value / 1000, sign * limit / 1000, u / 1000, bound);
        const PrintedNumbers numbers = printedNumbers(p, rule, std::nullopt, language);
        const int order = compare(exact(numbers.value), exact(numbers.reach)) * static_cast<int>(sign);
        const bool isBeyond = verdictOf(p, rule) == Verdict::doesNotConform;
        beyond += isBeyond;
        QVERIFY2((order > 0) == isBeyond, qPrintable(numbers.value + u" against "_s + numbers.reach));
        // limit ± g of the printed numbers, rounded
        const Exact band = product(exact(numbers.uncertainty), exact(QString::number(rule.guardFactor)));
        const Exact end = sum(exact(numbers.limit), sign < 0 ? negated(band) : band);
        const auto number = [](const Exact &e) {
            return static_cast<double>(e.digits) * std::pow(10, -e.decimals);
        };
        const Exact reach = exact(numbers.reach);
        QVERIFY(std::abs(number(reach) - number(end)) <= 0.5001 * std::pow(10, -reach.decimals));
    }
    QVERIFY(beyond > 5'000 && beyond < 19'000);
}

void PrintedNumbersTest::twoDigitsOfUncertainty() {
    const auto printed = [](double value, double limit, double uncertainty,
                            std::optional<double> resolution) {
        const PrintedNumbers numbers =
            printedNumbers(result(value / 1000, limit / 1000, uncertainty / 1000, Bound::magnitude),
                           DecisionRule(), resolution, Language(Language::Id::english), Rounding::twoDigits);
        return (QStringList{numbers.value, numbers.uncertainty, numbers.limit}).join(u'|');
    };
    QCOMPARE(printed(16.23, 30, 14.46, {}), u"16|14|30"_s);
    QCOMPARE(printed(16.234, 30, 1.446, 0.001), u"16.2|1.4|30"_s); // whatever the resolution is
    QCOMPARE(printed(16.234, 30, 0.0996, 0.001), u"16.23|0.10|30"_s);
    QCOMPARE(printed(30.2, 30, 14.46, {}), u"30.2|14|30"_s); // “30” would hide that it is exceeded
}

void PrintedNumbersTest::noMoreDigitsThanNeeded() {
    const Language language(Language::Id::english);
    std::mt19937 random(17025);
    std::uniform_int_distribution<int> limits(1, 400), offsets(-2000, 2000);
    for (int i = 0; i < 20'000; ++i) {
        const double limit = limits(random) / 10.0;
        const double value = limit + offsets(random) / 1e5;
        const int decimals =
            printedNumbers(result(value / 1000, limit / 1000, {}, Bound::upper), DecisionRule(), {}, language)
                .decimals;
        const auto above = [&](int count) {
            return QString::number(value, 'f', count).toDouble() > limit + 1e-9;
        };
        for (int fewer = 1; fewer < decimals; ++fewer)
            QVERIFY(above(fewer) != (value > limit + 1e-9) ||
                    std::abs(std::remainder(value * std::pow(10, fewer), 1)) > 0.499); // ties
    }
}

void PrintedNumbersTest::limitsAsEntered() {
    const Language language(Language::Id::english);
    const auto printed = [&](double limit, Quantity quantity) {
        return printedNumbers(result(limit, limit, {}, Bound::magnitude, quantity), DecisionRule(), {},
                              language)
            .limit;
    };
    QCOMPARE(printed(0.0010000000000000002, Quantity::deviation), u"1"_s);
    QCOMPARE(printed(std::nextafter(0.0125, 1), Quantity::deviation), u"12.5"_s);
    QCOMPARE(printed(0.02, Quantity::deviation), u"20"_s);
    QCOMPARE(printed(0.01234567, Quantity::deviation), u"12.34567"_s);
    QCOMPARE(printed(12.5 / 3600, Quantity::angularDeviation), u"12.5"_s);
    // One unit in the last place away from the limit is the limit.
    for (const double limit : {0.001, 0.01, 0.0125, 0.3e-3, 1.0 / 3600}) {
        for (const double value : {std::nextafter(limit, 0), limit, std::nextafter(limit, 1)}) {
            const Parameter p = result(value, limit, {}, Bound::magnitude);
            const PrintedNumbers numbers = printedNumbers(p, DecisionRule(), {}, language);
            QVERIFY2(numbers.value.size() <= 5 || limit == 1.0 / 3600, qPrintable(numbers.value));
        }
    }
}

void PrintedNumbersTest::limitOfF() {
    Parameter p = result(0.01, 0.02, {}, Bound::magnitude);
    p.term.id = "Fmax";
    p.limitOf = "F";
    QCOMPARE(limitNote(p, Language(Language::Id::english)), u"limit of F"_s);
    p.limitOf = "Fmax";
    QCOMPARE(limitNote(p, Language(Language::Id::english)), QString());
    p.limitOf.clear();
    QCOMPARE(limitNote(p, Language(Language::Id::english)), QString());
}

void PrintedNumbersTest::significantDigits_data() {
    QTest::addColumn<double>("size");
    QTest::addColumn<int>("digits");
    QTest::addColumn<QString>("printed");
    QTest::newRow("two") << 12.3 << 2 << "12";
    QTest::newRow("below 10") << 3.44 << 2 << "3.4";
    QTest::newRow("below 1") << 0.344 << 2 << "0.34";
    QTest::newRow("the second is nought") << 0.5 << 2 << "0.50";
    QTest::newRow("one") << 0.5 << 1 << "0.5";
    QTest::newRow("up to the next place") << 9.96 << 2 << "10";
    QTest::newRow("one, up to the next place") << 0.96 << 1 << "1";
    QTest::newRow("large") << 1234.0 << 2 << "1\u202f200";
    QTest::newRow("one is left") << 0.0344 << 2 << "0.03";
    QTest::newRow("the smallest") << 0.01 << 2 << "0.01";
    QTest::newRow("none is left") << 0.0099 << 2 << "<0.01";
}

void PrintedNumbersTest::significantDigits() {
    QFETCH(double, size);
    QFETCH(int, digits);
    QTEST(significant(size, digits, 2, Language(Language::Id::english)), "printed");
}

void PrintedNumbersTest::nothingBecomesNought() {
    std::mt19937_64 random(101);
    std::uniform_real_distribution<double> uniform(0, 1);
    const Language french(Language::Id::french);
    for (int i = 0; i < 20'000; ++i) {
        const double size = std::pow(10, 12 * uniform(random) - 8);
        const int digits = 1 + static_cast<int>(random() % 2);
        QString text = significant(size, digits, 2, french);
        const bool below = text.startsWith(u'<');
        const Exact shown = exact(text.remove(u'<'));
        const double value = static_cast<double>(shown.digits) * std::pow(10, -shown.decimals);
        QVERIFY(shown.digits > 0 && shown.decimals <= 2);
        QCOMPARE(below, size < 0.01);
        if (below)
            continue;
        QString significantOnes = QString::number(shown.digits);
        while (shown.decimals == 0 && significantOnes.endsWith(u'0'))
            significantOnes.chop(1);
        QVERIFY2(significantOnes.size() <= digits, qPrintable(text));
        const double half = std::max(0.5 * std::pow(10, std::floor(std::log10(size)) - digits + 1), 0.005);
        QVERIFY2(std::abs(value - size) <= half * (1 + 1e-9), qPrintable(text));
    }
}

QTEST_APPLESS_MAIN(PrintedNumbersTest)
#include "printednumbers.moc"
