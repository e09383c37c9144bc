// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/help/help.h"

#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace palmer {

namespace {

constexpr int digitsOfDifference = 2;
constexpr int digitsShown = 12; ///< the difference shows the rest

Text sourceText(ExpectationSource source) {
    return inOrder(source, {REPORT_TEXT("report", "published"), REPORT_TEXT("report", "recomputed"),
                            REPORT_TEXT("report", "exact"), REPORT_TEXT("report", "certified")});
}

/// Name and origin of a set, translated; the files give both in English with all details.
struct SetWords {
    const char *name = "";
    Text shown;
    Text origin;
};

constexpr const char *nistPrefix = "NIST StRD ";

const std::array setWords{
    SetWords{"Ballbar pair", REPORT_TEXT("report", "Ballbar pair"),
             REPORT_TEXT("report",
                         "Synthetic paths, R 150 mm, 1800 points each way, with scale mismatch, squareness, "
                         "servo mismatch, backlash, lateral play and straightness of known size. The "
                         "results were computed elsewhere from the same points.")},
    SetWords{"Correction C to 20 °C", REPORT_TEXT("report", "Correction C to 20 °C"),
             REPORT_TEXT("report", "Computed by hand for radii of 75 mm, 150 mm and 300 mm, each with other "
                                   "temperatures and coefficients of expansion.")},
    SetWords{"Constructed set", REPORT_TEXT("report", "Constructed set"),
             REPORT_TEXT("report",
                         "Readings of mean + s·(−1, −1, 0, 1, 1) at each target, whose standard deviation is "
                         "exactly s: every result is exact. No published set.")},
    SetWords{
        "ISO 230-2:1988, table 2", REPORT_TEXT("report", "ISO 230-2:1988, table 2"),
        REPORT_TEXT("report",
                    "Worked example of the standard, reconstructed from the printed means, s, B and R. The "
                    "position of the first target and ten readings (target 6 in the negative, target 7 "
                    "in the positive direction) are substitutes with the published mean and s: compare "
                    "the mean reversal value, R, A and the values per target, never the single "
                    "readings.")},
    SetWords{"ISO 230-4:2005, annex C", REPORT_TEXT("report", "ISO 230-4:2005, annex C"),
             REPORT_TEXT("report",
                         "500 mm/min at a diameter of 100 mm are 559 mm/min at 125 mm, printed to 1 mm/min; "
                         "exactly 500·√1.25 mm/min.")},
    SetWords{"NIST circles", REPORT_TEXT("report", "NIST circles"),
             REPORT_TEXT("report",
                         "NIST reference pairs of two-dimensional circles: least squares centre (x, y) and "
                         "radius R published by NIST; width w of the minimum zone circles recomputed in "
                         "exact arithmetic, certified here as the least")},
    SetWords{"Constructed circles", REPORT_TEXT("report", "Constructed circles"),
             REPORT_TEXT("report",
                         "Points between two circles with four alternating contacts: the width w of the "
                         "minimum zone is exact by construction; least squares circle recomputed in exact "
                         "arithmetic")},
    SetWords{nistPrefix,
             {},
             REPORT_TEXT("report",
                         "Univariate data of the statistical reference datasets of NIST (public domain), "
                         "https://www.itl.nist.gov/div898/strd/univ/")}};

/// Words of a set; null for an unknown name.
const SetWords *wordsOf(const SetValidation &set) {
    const auto found = std::ranges::find_if(setWords, [&](const SetWords &words) {
        const QString name = QString::fromUtf8(words.name);
        return words.name == nistPrefix ? set.name.startsWith(name) : set.name == name;
    });
    return found == setWords.end() ? nullptr : &*found;
}

/// Converts "−1.5e−11" to "−1.5·10⁻¹¹".
QString withPower(const QString &number) {
    const qsizetype at = number.indexOf(u'e');
    if (at < 0)
        return number;
    static constexpr std::u16string_view raised = u"⁰¹²³⁴⁵⁶⁷⁸⁹";
    QString power;
    for (const QChar digit : number.mid(at + 1)) {
        if (digit.isDigit())
            power += QChar(raised[static_cast<std::size_t>(digit.digitValue())]);
        else if (digit != u'+')
            power += QChar(u'⁻');
    }
    const QString factor = number.left(at);
    return (factor == QStringLiteral("1") ? QString() : factor + QChar(u'·')) + QStringLiteral("10") + power;
}

double rounded(double value, int digits) {
    return QString::number(value, 'g', digits).toDouble();
}

std::vector<Cell> row(const Comparison &comparison, Quantity quantity, const Language &language) {
    const Expectation &expected = comparison.expectation;
    const Quantity ofDifference = expected.relative ? Quantity::number : quantity;
    const auto shown = [&](std::optional<double> value) {
        return value ? Phrase(language.number(rounded(*value, digitsShown), quantity)) : Phrase();
    };
    return {comparison.of,
            symbolPhrase(comparison.symbol, comparison.index),
            language.text(sourceText(expected.source)),
            shown(expected.value),
            shown(comparison.computed),
            comparison.difference ? Phrase(withPower(language.number(
                                        rounded(*comparison.difference, digitsOfDifference), ofDifference)))
                                  : Phrase(),
            withPower(language.number(expected.tolerance, ofDifference)),
            language.text(comparison.agrees ? REPORT_TEXT("report", "agrees")
                                            : REPORT_TEXT("report", "DOES NOT AGREE"))};
}

Table table(const SetValidation &set, const Language &language) {
    const QString unit = set.quantity == Quantity::number ? QString() : language.unit(set.quantity);
    const auto title = [&](const Text &words) { return Phrase(language.text(words)); };
    Table result;
    result.columns = {{title(set.points ? REPORT_TEXT("report", "File") : REPORT_TEXT("report", "Edition")),
                       {},
                       Alignment::left,
                       false},
                      {title(REPORT_TEXT("report", "Quantity")), {}, Alignment::left, false},
                      {title(REPORT_TEXT("report", "Source")), {}, Alignment::left, false},
                      {title(REPORT_TEXT("report", "Expected")), unit, Alignment::decimal, false},
                      {title(REPORT_TEXT("report", "Computed")), unit, Alignment::decimal, false},
                      {title(REPORT_TEXT("report", "Difference")), unit, Alignment::right, false},
                      {title(REPORT_TEXT("report", "Tolerance")), unit, Alignment::right, false},
                      {{}, {}, Alignment::left, false}};
    for (const Comparison &comparison : set.comparisons)
        result.rows.push_back(row(comparison, set.quantity, language));
    return result;
}

} // namespace

Report composeValidation(const std::vector<SetValidation> &sets, const Language &language) {
    Report report;
    std::size_t values = 0;
    std::size_t reproduced = 0;
    for (const SetValidation &set : sets) {
        values += set.comparisons.size();
        reproduced +=
            static_cast<std::size_t>(std::ranges::count(set.comparisons, true, &Comparison::agrees));
    }
    report.blocks.emplace_back(
        Paragraph{language.sentence(REPORT_TEXT("report", "%1 of %2 values reproduced."),
                                    {wholeNumber(reproduced), wholeNumber(values)})});
    if (reproduced < values)
        report.blocks.emplace_back(Paragraph{language.sentence(
            REPORT_TEXT("report", "Values that do NOT agree with the reference data: %1 of %2."),
            {wholeNumber(values - reproduced), wholeNumber(values)})});
    for (const SetValidation &set : sets) {
        const SetWords *words = wordsOf(set);
        const QString name = words ? language.text(words->shown) : QString();
        report.blocks.emplace_back(Heading{1, name.isEmpty() ? set.name : name});
        report.blocks.emplace_back(Paragraph{words ? language.text(words->origin) : set.origin});
        report.blocks.emplace_back(table(set, language));
    }
    return report;
}

} // namespace palmer
