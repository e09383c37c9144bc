// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/printednumbers.h"

#include "kernel/evaluation/conformity.h"
#include "kernel/numerics/poweroften.h"
#include "language/rounding.h"
#include "report/words/wording.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace palmer {

namespace {

constexpr int mostDecimals = 20;

/// The printed number as a reader reads it.
double readBack(const std::string &text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// Decimals of the value and of U.
struct Digits {
    int value = 1;
    int uncertainty = 1;
};

/// A result and its limit in the displayed unit.
struct ComparedNumbers {
    double value = 0; ///< normalised like the limit, so that less is better
    double limit = 0;
    std::optional<double> uncertainty; ///< the guard band is a multiple of it
    double rounding = roundingOfSums;

    [[nodiscard]] Verdict verdict(const DecisionRule &rule) const {
        return decideUpper(value, limit, uncertainty, rule, rounding);
    }
    /// True if the verdicts without and with the guard band are those of `other`.
    [[nodiscard]] bool agreesWith(const ComparedNumbers &other, const DecisionRule &rule) const {
        return verdict({}) == other.verdict({}) && verdict(rule) == other.verdict(rule);
    }
};

/// A number of a parameter as Language prints it in the given unit.
double printedNumber(double value, const ShownUnit &unit, int decimals) {
    return readBack(Decimal(value, unit).rounded(std::max(0, decimals + unit.decimals)));
}

ComparedNumbers printedComparison(const Parameter &p, Digits digits, const DisplayUnits &units) {
    const ShownUnit unit = shownUnit(p.term.quantity, units);
    const double limit = *p.limit->value;
    const int ofLimit = limitDecimals(limit, p.term.quantity, units);
    ComparedNumbers printed{judgedValue(printedNumber(*p.value, unit, digits.value), p.bound),
                            judgedLimit(printedNumber(limit, unit, ofLimit), p.bound),
                            {},
                            roundingOfWritten};
    if (const auto guarded = p.guardedUncertainty())
        printed.uncertainty = readBack(
            Decimal(*guarded, unit).roundedUncertainty(std::max(0, digits.uncertainty + unit.decimals)));
    return printed;
}

bool isComparable(const Parameter &p) {
    return p.value && p.limit && p.limit->value && std::isfinite(*p.value) && std::isfinite(*p.limit->value);
}

/// limit ± g from the printed limit and U, with the fewest decimals that leave the printed value on its side.
QString printedReach(const Parameter &p, const DecisionRule &rule, Digits shown, const Language &language) {
    const ComparedNumbers printed = printedComparison(p, shown, language.units());
    const auto guard = guardBand(printed.uncertainty, rule);
    if (!guard)
        return {};
    const double end = printed.limit + *guard;
    const bool beyond = printed.verdict(rule) == Verdict::doesNotConform;
    int digits = std::max(0, shown.value + shownUnit(p.term.quantity, language.units()).decimals);
    while (digits < mostDecimals && (readBack(Decimal(end).rounded(digits)) < printed.value) != beyond)
        ++digits;
    return language.number(p.bound == Bound::lower ? -end : end, Quantity::number, digits);
}

/// The fewest decimals that give the verdict of the unrounded numbers.
Digits digitsOf(const Parameter &parameter, const DecisionRule &rule, std::optional<double> resolution,
                const DisplayUnits &units, Rounding rounding) {
    int least = decimalsWithoutUncertainty;
    const Quantity quantity = parameter.term.quantity;
    if (const auto &expanded = parameter.expandedUncertainty)
        least = rounding == Rounding::twoDigits ? decimalsOfTwoDigits(*expanded, quantity)
                                                : decimalsWithUncertainty(*expanded, quantity, resolution);
    if (!isComparable(parameter))
        return {least, least};
    const ComparedNumbers exact{
        judgedValue(*parameter.value, parameter.bound), judgedLimit(*parameter.limit->value, parameter.bound),
        parameter.guardedUncertainty(), roundingBeside(parameter, *parameter.limit->value)};
    for (int more = least; more <= mostDecimals; ++more) {
        for (const Digits digits : {Digits{more, least}, Digits{least, more}, Digits{more, more}}) {
            if (printedComparison(parameter, digits, units).agreesWith(exact, rule))
                return digits;
        }
    }
    return {least, least};
}

} // namespace

PrintedNumbers printedNumbers(const Parameter &parameter, const DecisionRule &rule,
                              std::optional<double> resolution, const Language &language, Rounding rounding) {
    const Quantity quantity = parameter.term.quantity;
    PrintedNumbers result;
    const Digits digits = digitsOf(parameter, rule, resolution, language.units(), rounding);
    result.decimals = digits.value;
    result.uncertaintyDecimals = digits.uncertainty;
    if (parameter.value)
        result.value = language.number(*parameter.value, quantity, result.decimals);
    if (parameter.expandedUncertainty && parameter.value)
        result.uncertainty =
            language.uncertainty(*parameter.expandedUncertainty, quantity, digits.uncertainty);
    if (parameter.limit && parameter.limit->value) {
        const int own = limitDecimals(*parameter.limit->value, quantity, language.units());
        result.limit = language.number(*parameter.limit->value, quantity, own);
    }
    if (isComparable(parameter))
        result.reach = printedReach(parameter, rule, digits, language);
    return result;
}

PrintedNumbers printedNumbers(const Parameter &parameter, const Test &test, const Document &document,
                              const Language &language) {
    return printedNumbers(parameter, test.decisionRule, finestResolution(document, test), language,
                          document.report.rounding);
}

QString withUnit(const QString &number, Quantity quantity, const Language &language) {
    const qsizetype digits = language.number(0, quantity, 0).size();
    return number + language.quantity(0, quantity, 0).mid(digits);
}

QString significant(double size, int digits, int finest, const Language &language) {
    const double smallest = powerOfTen(-finest);
    if (size < smallest)
        return u'<' + language.number(smallest, Quantity::number, finest);
    const auto placeOfFirst = [](double number) { return static_cast<int>(std::floor(std::log10(number))); };
    const double last = std::max(powerOfTen(placeOfFirst(size) - digits + 1), smallest);
    const double rounded = std::round(size / last) * last;
    constexpr double noRounding = 1 + 1e-9; // 9.96 becomes 10, one digit more
    const int decimals = digits - 1 - placeOfFirst(rounded * noRounding);
    return language.number(rounded, Quantity::number, std::clamp(decimals, 0, finest));
}

QString limitNote(const Parameter &parameter, const Language &language) {
    if (!parameter.limit || parameter.limitOf.empty() || parameter.limitOf == parameter.term.id)
        return {};
    return language.sentence(REPORT_TEXT("report", "limit of %1"), {parameter.limitOf});
}

} // namespace palmer
