// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/explanations/explanation.h"

#include "figures/testfigures.h"
#include "kernel/evaluation/instrumentresult.h"
#include "kernel/evaluation/iso230_2/parameters.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/numerics/poweroften.h"
#include "language/rounding.h"
#include "report/explanations/arithmetic.h"
#include "report/explanations/circularexplanation.h"
#include "report/words/findingtext.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace palmer {

namespace {

using namespace iso230_2;

/// Explanation of one function of parameters.h. Placeholders in the formulas:
///   %s symbol of the parameter   %c %d  c and 2c     %m  number of targets
///   %1 %2 the ruling targets     %a %b  their arrows
///   [id] [id'] a quantity of the first or second ruling target; "*" in it is the direction that rules
///   [^id] its largest value      [Σid]  its sum over all targets          [=]  the result with its unit
/// A step that only chooses between numbers ("max([…") prints them with the decimals of the result.
struct Recipe {
    const ParameterFormula *function = nullptr;
    const char *formula = nullptr;
    std::array<const char *, 3> steps{};
    const char *bars = ""; ///< quantity per target
    const char *barsTitle = "";
    std::array<const char *, 3> terms{}; ///< quantities per target, whose clauses are cited too
    bool parts = false;                  ///< explain the parts of the sum
};

// clang-format off
constexpr std::array recipes{
    Recipe{&accuracyUp,   "%s = max(x̄_i↑ + %cs_i↑) − min(x̄_i↑ − %cs_i↑)",
           {"%s = (x̄_%1%a + %cs_%1%a) − (x̄_%2%b − %cs_%2%b)", "= ([mean*] + %c·[s*]) − ([mean*'] − %c·[s*'])", "= [upper*] − [lower*'] = [=]"},
           "", "", {"mean+", "s+"}},
    Recipe{&accuracyDown, "%s = max(x̄_i↓ + %cs_i↓) − min(x̄_i↓ − %cs_i↓)",
           {"%s = (x̄_%1%a + %cs_%1%a) − (x̄_%2%b − %cs_%2%b)", "= ([mean*] + %c·[s*]) − ([mean*'] − %c·[s*'])", "= [upper*] − [lower*'] = [=]"},
           "", "", {"mean-", "s-"}},
    Recipe{&accuracy,     "%s = max(x̄_i↑ + %cs_i↑; x̄_i↓ + %cs_i↓) − min(x̄_i↑ − %cs_i↑; x̄_i↓ − %cs_i↓)",
           {"%s = (x̄_%1%a + %cs_%1%a) − (x̄_%2%b − %cs_%2%b)", "= ([mean*] + %c·[s*]) − ([mean*'] − %c·[s*'])", "= [upper*] − [lower*'] = [=]"},
           "", "", {"mean+", "s+"}},
    Recipe{&systematicUp,   "%s = max x̄_i↑ − min x̄_i↑",               {"%s = x̄_%1%a − x̄_%2%b = [mean*] − [mean*'] = [=]"}, "", "", {"mean+"}},
    Recipe{&systematicDown, "%s = max x̄_i↓ − min x̄_i↓",               {"%s = x̄_%1%a − x̄_%2%b = [mean*] − [mean*'] = [=]"}, "", "", {"mean-"}},
    Recipe{&systematic,     "%s = max(x̄_i↑; x̄_i↓) − min(x̄_i↑; x̄_i↓)", {"%s = x̄_%1%a − x̄_%2%b = [mean*] − [mean*'] = [=]"}, "", "", {"mean+"}},
    Recipe{&meanRange,      "%s = max x̄_i − min x̄_i; x̄_i = (x̄_i↑ + x̄_i↓)/2", {"%s = x̄_%1 − x̄_%2 = [mean] − [mean'] = [=]"}, "", "", {"mean"}},
    Recipe{&repeatabilityUp,     "%s = max R_i↑; R_i↑ = %ds_i↑", {"%s = R_%1↑ = %d·[s+] = [=]"}, "R+", "R_i↑", {"R+", "s+"}},
    Recipe{&repeatabilityDown,   "%s = max R_i↓; R_i↓ = %ds_i↓", {"%s = R_%1↓ = %d·[s-] = [=]"}, "R-", "R_i↓", {"R-", "s-"}},
    Recipe{&repeatabilityOfAxis, "%s = max R_i; R_i = max(%cs_i↑ + %cs_i↓ + |B_i|; %ds_i↑; %ds_i↓)",
           {"R_%1 = max(%c·[s+] + %c·[s-] + |[reversal]|; %d·[s+]; %d·[s-])", "= max([sum]; [R+]; [R-]) = [=]"},
           "R", "R_i", {"R"}, true},
    Recipe{&smallerRepeatability, "%s = min(R↑; R↓); R↑ = max R_i↑; R↓ = max R_i↓", {"%s = min([^R+]; [^R-]) = [=]"}, "", "", {"R+"}},
    Recipe{&meanRepeatabilityUp,   "%s = Σ R_i↑ / m; R_i↑ = %ds_i↑", {"%s = [ΣR+] / %m = [=]"}, "R+", "R_i↑", {"R+"}},
    Recipe{&meanRepeatabilityDown, "%s = Σ R_i↓ / m; R_i↓ = %ds_i↓", {"%s = [ΣR-] / %m = [=]"}, "R-", "R_i↓", {"R-"}},
    Recipe{&meanRepeatability,     "%s = Σ R_i / m; R_i = max(%cs_i↑ + %cs_i↓ + |B_i|; %ds_i↑; %ds_i↓)", {"%s = [ΣR] / %m = [=]"}, "R", "R_i", {"R"}},
    Recipe{&reversal,     "%s = max |B_i|; B_i = x̄_i↑ − x̄_i↓", {"%s = |B_%1| = |[mean+] − [mean-]| = [=]"}, "size", "|B_i|", {"reversal"}},
    Recipe{&meanReversal, "%s = Σ B_i / m; B_i = x̄_i↑ − x̄_i↓",  {"%s = [Σreversal] / %m = [=]"}, "reversal", "B_i", {"reversal"}},
    Recipe{&vdiMeanReversal, "%s = Σ U_i / m; U_i = |x̄_i↑ − x̄_i↓|", {"%s = [Σsize] / %m = [=]"}, "size", "U_i"},
    Recipe{&vdiScatter,      "%s = max Ps_i; Ps_i = %c(s_i↑ + s_i↓)", {"%s = %c·([s+] + [s-]) = [=]"}, "scatter", "Ps_i"},
    Recipe{&vdiMeanScatter,  "%s = Σ Ps_i / m; Ps_i = %c(s_i↑ + s_i↓)", {"%s = [Σscatter] / %m = [=]"}, "scatter", "Ps_i"},
    Recipe{&vdiUncertainty,  "%s = max(x̄_i + (U_i + Ps_i)/2) − min(x̄_i − (U_i + Ps_i)/2)",
           {"%s = ([mean] + ([size] + [scatter])/2) − ([mean'] − ([size'] + [scatter'])/2)", "= [vdiUpper] − [vdiLower'] = [=]"}},
};
// clang-format on

/// targetValue(), and further quantities of the recipes.
std::optional<double> valueOf(std::string_view id, const TargetStatistics &target, double c) {
    const double scatter = c * (target.positive.s + target.negative.s);
    const double size = std::abs(target.reversal());
    struct More {
        std::string_view id;
        double value = 0;
    };
    const std::array more{More{"size", size}, More{"scatter", scatter}, More{"sum", scatter + size},
                          More{"vdiUpper", target.mean() + (size + scatter) / 2},
                          More{"vdiLower", target.mean() - (size + scatter) / 2}};
    for (const auto &entry : more) {
        if (entry.id == id)
            return std::isfinite(entry.value) ? std::optional(entry.value) : std::nullopt;
    }
    return targetValue(id, target, c);
}

const char *arrow(const std::optional<Ruling> &ruling) {
    if (!ruling || !ruling->approach)
        return "";
    return *ruling->approach == Direction::positive ? "↑" : "↓";
}

QString place(const Ruling &ruling) {
    return QString::number(ruling.target) + QString::fromUtf8(arrow(ruling));
}

class Explainer {
public:
    Explainer(const TestEvaluation &evaluation, const PositioningMeasurement &measurement,
              const Parameter &parameter, const PrintedNumbers &printed, const Recipe &recipe,
              const Language &language)
        : m_evaluation(evaluation)
        , m_results(resultsOf(measurement, evaluation))
        , m_parameter(parameter)
        , m_printed(printed)
        , m_recipe(recipe)
        , m_language(language)
        , m_c(evaluation.edition->c)
        , m_decimals(std::max(statisticDecimals(measurement), printed.decimals)) {}

    [[nodiscard]] Explanation explain() const {
        Explanation result;
        result.id = QString::fromStdString(parameterId(m_parameter));
        result.symbol = symbolFormula(m_parameter);
        result.name = m_language.text(m_parameter.term.name);
        result.formula = filled(lettered(m_recipe.formula), {});
        if (m_parameter.value) {
            const std::vector<int> decimals = decimalsOfSides();
            std::span<const int> left = decimals;
            for (const char *step : m_recipe.steps) {
                if (!step)
                    continue;
                const auto sides = static_cast<std::size_t>(sidesOf(step).size());
                result.steps.push_back(filled(QString::fromUtf8(step), left.first(sides)));
                left = left.subspan(sides);
            }
            result.result = result.symbol.plain() + QStringLiteral(" = ") + shownResult();
        }
        for (const auto &ruling : m_parameter.ruling) {
            if (ruling)
                result.ruling.push_back(*ruling);
        }
        result.words = words();
        result.source = source();
        result.bars = bars();
        return result;
    }

private:
    [[nodiscard]] QString shown(double value, int decimals) const {
        return m_language.number(value, m_parameter.term.quantity, decimals);
    }
    [[nodiscard]] QString shownResult() const {
        return withUnit(m_printed.value, m_parameter.term.quantity, m_language);
    }
    [[nodiscard]] QString factor(double value) const {
        return m_language.number(value, Quantity::number, -1);
    }
    [[nodiscard]] QString say(const Text &text, std::vector<Argument> arguments) const {
        return m_language.sentence(text, std::move(arguments));
    }
    [[nodiscard]] const TargetStatistics *target(std::size_t ruling) const {
        const auto &which = m_parameter.ruling[ruling];
        if (!which || static_cast<std::size_t>(which->target) > m_results.targets.size())
            return nullptr;
        return &m_results.targets[static_cast<std::size_t>(which->target) - 1];
    }

    // ---- Formulas ----------------------------------------------------------------------------------------

    /// The sides of a step, split at its equals signs, that contain numbers.
    [[nodiscard]] static QStringList sidesOf(const char *step) {
        QString text = QString::fromUtf8(step);
        const QString result = QStringLiteral("[=]");
        QStringList sides = text.replace(result, QStringLiteral("[]")).split(u'=');
        sides.removeIf([](const QString &side) { return !side.contains(u'['); });
        return sides.replaceInStrings(QStringLiteral("[]"), result);
    }

    /// Evaluates a side with its numbers rounded to `decimals`.
    [[nodiscard]] Calculation calculatedSide(const QString &side, int decimals) const {
        QString text;
        for (qsizetype i = 0; i < side.size(); ++i) {
            if (side[i] == u'%') {
                const double c = side[++i] == u'c' ? m_c : 2 * m_c;
                text += QString::number(side[i] == u'm' ? static_cast<double>(m_results.targets.size()) : c);
            } else if (side[i] == u'[') {
                const qsizetype end = side.indexOf(u']', i);
                const auto value = numberOf(side.mid(i + 1, end - i - 1));
                text += QString::fromStdString(
                    Decimal(value.value_or(0), m_parameter.term.quantity).rounded(decimals));
                i = end;
            } else {
                text += side[i];
            }
        }
        return calculated(text);
    }

    /// Decimals of the numbers of each side: those of the statistics, and more if the printed calculation
    /// would not give the printed result.
    [[nodiscard]] std::vector<int> decimalsOfSides() const {
        QStringList sides;
        for (const char *step : m_recipe.steps)
            sides += step ? sidesOf(step) : QStringList();
        std::vector<int> decimals(static_cast<std::size_t>(sides.size()), m_printed.decimals);
        for (qsizetype i = sides.size() - 2; i >= 0; --i) {
            const int behind = decimals[static_cast<std::size_t>(i) + 1];
            const Calculation expected = calculatedSide(sides[i + 1], behind);
            const bool chooses =
                sides[i].contains(QStringLiteral("max([")) || sides[i].contains(QStringLiteral("min(["));
            const int fewest = chooses ? m_printed.decimals : m_decimals;
            constexpr int most = 6; // with more the digits are a tie
            int &used = decimals[static_cast<std::size_t>(i)];
            for (used = fewest; used < fewest + most; ++used) {
                if (comesTo(calculatedSide(sides[i], used), expected, behind))
                    break;
            }
        }
        return decimals;
    }

    /// Compares term by term (brackets or candidates) if both sides have as many, otherwise the values.
    [[nodiscard]] static bool comesTo(const Calculation &left, const Calculation &right, int decimals) {
        const double half = (0.5 + 1e-6) * powerOfTen(-decimals);
        const auto equal = [half](double a, double b) { return std::abs(a - b) <= half; };
        return left.isGrouped && left.terms.size() == right.terms.size()
                   ? std::ranges::equal(left.terms, right.terms, equal)
                   : equal(left.value, right.value);
    }

    [[nodiscard]] QString lettered(const char *formula) const {
        return inLettersOf(*m_evaluation.edition, formula);
    }

    /// The formula of a recipe with all values inserted; `decimals` of the numbers of each side.
    [[nodiscard]] Formula filled(const QString &source, std::span<const int> decimals) const {
        Formula result;
        std::size_t side = 0;
        bool hasNumbers = false;
        QString plain;
        const auto flush = [&] {
            result += formulaFrom(plain);
            plain.clear();
        };
        for (qsizetype i = 0; i < source.size(); ++i) {
            if (source[i] == u'%' && source.mid(i, 2) == QStringLiteral("%s")) {
                flush();
                result += symbolFormula(m_parameter);
                ++i;
            } else if (source[i] == u'%') {
                plain += word(source[++i]);
            } else if (source[i] == u'[') {
                const qsizetype end = source.indexOf(u']', i);
                const bool afterSign = endsInSign(plain);
                flush();
                addNumber(result, source.mid(i + 1, end - i - 1), decimals[side], afterSign);
                hasNumbers = true;
                i = end;
            } else if (source[i] == u'=') {
                side += std::exchange(hasNumbers, false) ? 1 : 0;
                plain += source[i];
            } else if (source[i] == u';' && m_language.id() == Language::Id::french) {
                plain += QStringLiteral("\u202f;");
            } else {
                plain += source[i];
            }
        }
        flush();
        return result;
    }

    [[nodiscard]] QString word(QChar name) const {
        switch (name.unicode()) {
        case 'c':
            return factor(m_c);
        case 'd':
            return factor(2 * m_c);
        case 'm':
            return m_language.count(m_results.targets.size());
        case '1':
            return m_parameter.ruling[0] ? QString::number(m_parameter.ruling[0]->target) : QString();
        case '2':
            return m_parameter.ruling[1] ? QString::number(m_parameter.ruling[1]->target) : QString();
        case 'a':
            return QString::fromUtf8(arrow(m_parameter.ruling[0]));
        case 'b':
            return QString::fromUtf8(arrow(m_parameter.ruling[1]));
        default:
            return name;
        }
    }

    /// True if a negative number at this place needs parentheses.
    [[nodiscard]] static bool endsInSign(const QString &plain) {
        const QString before = plain.trimmed();
        return before.endsWith(u'+') || before.endsWith(u'−') || before.endsWith(u'·');
    }

    /// The value of a name in a recipe.
    [[nodiscard]] std::optional<double> numberOf(QString id) const {
        if (id == QStringLiteral("="))
            return m_parameter.value;
        const std::size_t which = id.endsWith(u'\'') ? 1 : 0;
        id = statisticOf(std::move(id));
        return id.startsWith(u'Σ')   ? sum(id.mid(1).toStdString())
               : id.startsWith(u'^') ? largest(id.mid(1).toStdString())
               : target(which)       ? valueOf(id.toStdString(), *target(which), m_c)
                                     : std::nullopt;
    }
    /// The statistic of a name; by default that of the ruling direction.
    [[nodiscard]] QString statisticOf(QString id) const {
        const std::size_t which = id.endsWith(u'\'') ? 1 : 0;
        id.chop(static_cast<qsizetype>(which));
        const bool up = QString::fromUtf8(arrow(m_parameter.ruling[which])) == QStringLiteral("↑");
        return id.replace(u'*', up ? u'+' : u'-');
    }

    void addNumber(Formula &formula, QString id, int decimals, bool afterSign) const {
        if (id == QStringLiteral("=")) {
            formula.spans.push_back({shownResult(), false, true});
            return;
        }
        const std::optional<double> value = numberOf(id);
        id = statisticOf(std::move(id));
        FormulaSpan span{value ? shown(*value, decimals) : QStringLiteral("–"), false, true};
        if (id.endsWith(u'+'))
            span.approach = Direction::positive;
        else if (id.endsWith(u'-'))
            span.approach = Direction::negative;
        if (afterSign && span.text.startsWith(u'−'))
            span.text = u'(' + span.text + u')';
        formula.spans.push_back(std::move(span));
    }

    [[nodiscard]] std::optional<double> sum(const std::string &id) const {
        double result = 0;
        for (const TargetStatistics &target : m_results.targets)
            result += valueOf(id, target, m_c).value_or(0);
        return result;
    }
    [[nodiscard]] std::optional<double> largest(const std::string &id) const {
        std::optional<double> result;
        for (const TargetStatistics &target : m_results.targets) {
            if (const auto value = valueOf(id, target, m_c))
                result = std::max(result.value_or(*value), *value);
        }
        return result;
    }

    // ---- Words -------------------------------------------------------------------------------------------

    [[nodiscard]] QStringList words() const {
        if (!m_parameter.value)
            return {whyNoValue()};
        QStringList result;
        const auto &[first, second] = m_parameter.ruling;
        if (first && second)
            result << say(REPORT_TEXT("report", "Largest at target %1, smallest at target %2."),
                          {place(*first).toStdString(), place(*second).toStdString()});
        else if (first)
            result << say(REPORT_TEXT("report", "Target %1 rules it."), {place(*first).toStdString()});
        else
            result << m_language.sentence(
                {REPORT_TEXT_COUNTED("report", "Mean over %n target(s): none rules it alone."),
                 {},
                 static_cast<int>(m_results.targets.size())});
        if (m_recipe.parts && target(0))
            result << weights(*target(0));
        if (m_results.standardDeviation == DeviationMethod::range)
            result << say(REPORT_TEXT("report", "s by the range method: s = W / k(n)."), {});
        if (!m_results.corrections.empty())
            result << say(REPORT_TEXT("report", "With the correction to 20 °C applied here."), {});
        else if (m_results.at20 == At20::wrong && m_parameter.dependsOnTemperature)
            result << say(REPORT_TEXT("report", "Not corrected to 20 °C."), {});
        return result;
    }

    [[nodiscard]] QString whyNoValue() const {
        for (const Finding &finding : m_evaluation.findings) {
            if (finding.explains == Explains::missingValues)
                return findingText(finding, m_language);
        }
        return {};
    }

    /// Weights of the parts of the sum, if the sum rules.
    [[nodiscard]] QString weights(const TargetStatistics &target) const {
        const double up = m_c * target.positive.s;
        const double down = m_c * target.negative.s;
        const double reversal = std::abs(target.reversal());
        const double total = up + down + reversal;
        if (!(total > 0) || total < std::max(2 * up, 2 * down))
            return say(REPORT_TEXT("report", "The scatter of one direction alone is the largest form."), {});
        const auto percent = [&](double part) { return Number{100 * part / total, Quantity::percent, 0}; };
        const auto number = [&](double part) { return Number{part, m_parameter.term.quantity, m_decimals}; };
        const std::string c = factor(m_c).toStdString();
        return say(REPORT_TEXT("report", "What weighs: |B| %1 (%2), %3 %4 (%5), %6 %7 (%8)."),
                   {number(reversal), percent(reversal), c + "s↑", number(up), percent(up), c + "s↓",
                    number(down), percent(down)});
    }

    // ---- Clauses -----------------------------------------------------------------------------------------

    /// Clauses of the parameter and of the quantities per target it is based on, ascending.
    [[nodiscard]] QString source() const {
        std::vector<QString> clauses;
        const auto add = [&](const char *clause) {
            const QString text = QString::fromUtf8(clause);
            if (!text.isEmpty() && std::ranges::count(clauses, text) == 0)
                clauses.push_back(text);
        };
        add(m_parameter.term.clause);
        for (const TargetTerm &term : m_evaluation.edition->targetTerms) {
            for (const char *id : m_recipe.terms) {
                if (id && std::string_view(id) == term.id)
                    add(term.clause);
            }
        }
        std::ranges::sort(clauses, [](const QString &a, const QString &b) {
            const auto key = [](const QString &clause) {
                return std::pair(clause.section(u'.', 0, 0).toInt(), clause.section(u'.', 1, 1).toInt());
            };
            return key(a) < key(b);
        });
        const std::string edition = m_evaluation.edition->word;
        if (clauses.empty())
            return QString::fromStdString(edition);
        const std::string last = clauses.back().toStdString();
        clauses.pop_back();
        if (clauses.empty())
            return say(REPORT_TEXT("report", "%1, clause %2"), {edition, last});
        QStringList before(clauses.begin(), clauses.end());
        return say(REPORT_TEXT("report", "%1, clauses %2 and %3"),
                   {edition, before.join(QStringLiteral(", ")).toStdString(), last});
    }

    [[nodiscard]] std::optional<TargetBars> bars() const {
        if (*m_recipe.bars == 0 || m_results.targets.empty())
            return std::nullopt;
        TargetBars result;
        result.title = formulaFrom(lettered(m_recipe.barsTitle));
        result.unit = m_language.unit(m_parameter.term.quantity);
        for (const TargetStatistics &target : m_results.targets) {
            const auto value = valueOf(m_recipe.bars, target, m_c);
            result.values.push_back(value);
            result.labels.push_back(value ? shown(*value, m_printed.decimals) : QString());
        }
        if (m_parameter.ruling[0])
            result.ruling = static_cast<std::size_t>(m_parameter.ruling[0]->target) - 1;
        return result;
    }

    const TestEvaluation &m_evaluation;
    const PositioningResults &m_results;
    const Parameter &m_parameter;
    const PrintedNumbers m_printed;
    const Recipe &m_recipe;
    const Language &m_language;
    double m_c;
    int m_decimals; ///< of inserted numbers
};

} // namespace

namespace {

std::optional<Explanation> explained(const PositioningMeasurement &measurement, const Test & /*source*/,
                                     const TestEvaluation &evaluation, const Parameter &parameter,
                                     const PrintedNumbers &printed, const Language &language) {
    const Row *row = rowOf(*evaluation.edition, parameter);
    if (!row)
        return std::nullopt;
    const auto recipe = std::ranges::find(recipes, row->value, &Recipe::function);
    if (recipe == recipes.end())
        return std::nullopt;
    return Explainer(evaluation, measurement, parameter, printed, *recipe, language).explain();
}

std::optional<Explanation> explained(const auto & /*circles*/, const Test &source,
                                     const TestEvaluation &evaluation, const Parameter &parameter,
                                     const PrintedNumbers &printed, const Language &language) {
    return circularExplanation(source, evaluation, parameter, printed, language);
}

/// How much of the systematic part of the uncertainty its actual targets carry.
QStringList systematicCarried(const TestEvaluation &evaluation, const Parameter &parameter,
                              const Language &language) {
    const UncertaintyEvaluation &uncertainty = evaluation.uncertainty;
    if (!usesContributions(uncertainty.method) || !uncertainty.systematic || !parameter.effectiveSystematic)
        return {};
    const auto size = [&](double value) {
        return Number{value, parameter.term.quantity, contributionDecimals};
    };
    return {language.sentence(
        REPORT_TEXT("report",
                    "Of the systematic part S = %1 of its uncertainty the actual targets carry %2."),
        {size(*uncertainty.systematic), size(*parameter.effectiveSystematic)})};
}

/// Statements of the instrument's program about the result.
QStringList statedBeside(const Test &source, const TestEvaluation &evaluation, const Parameter &parameter,
                         const Language &language) {
    constexpr int decimals = 2; // of µm; programs state one
    const Quantity quantity = parameter.term.quantity;
    QStringList sentences;
    for (const InstrumentResult &stated : instrumentResults(source, evaluation)) {
        if (stated.ours == &parameter)
            sentences << language.sentence(
                REPORT_TEXT("report",
                            "The instrument’s program states %1 (%2); the result here differs by %3."),
                {Number{stated.value, quantity, decimals}, stated.stated->name,
                 Number{*parameter.value - stated.value, quantity, decimals}});
    }
    return sentences;
}

} // namespace

std::optional<Explanation> explanation(const EvaluatedDocument &evaluated, std::size_t test,
                                       std::string_view id, const Language &language) {
    if (test >= evaluated.tests.size())
        return std::nullopt;
    const Test &source = *evaluated.document->tests[test];
    const TestEvaluation &evaluation = *evaluated.tests[test];
    if (!evaluation.edition)
        return std::nullopt;
    const auto parameter =
        std::ranges::find(evaluation.parameters, id, [](const Parameter &p) { return parameterId(p); });
    if (parameter == evaluation.parameters.end())
        return std::nullopt;
    const PrintedNumbers printed = printedNumbers(*parameter, source, *evaluated.document, language);
    std::optional<Explanation> result = std::visit(
        [&](const auto &measurement) {
            return explained(measurement, source, evaluation, *parameter, printed, language);
        },
        source.measurement);
    if (result) {
        result->words += systematicCarried(evaluation, *parameter, language);
        result->words += statedBeside(source, evaluation, *parameter, language);
    }
    return result;
}

Formula formulaOf(const Edition &edition, const Row &row, const Language &language) {
    const auto recipe = std::ranges::find(recipes, row.value, &Recipe::function);
    if (recipe == recipes.end())
        return {};
    QString source = inLettersOf(edition, recipe->formula);
    source.replace(QStringLiteral("%c"), language.number(edition.c, Quantity::number));
    source.replace(QStringLiteral("%d"), language.number(2 * edition.c, Quantity::number));
    const QString place = QStringLiteral("%s");
    const qsizetype at = source.indexOf(place);
    Formula formula = formulaFrom(source.left(at));
    formula += symbolFormula(row.term.symbol);
    formula += formulaFrom(source.mid(at + place.size()));
    return formula;
}

} // namespace palmer
