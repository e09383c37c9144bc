// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/explanations/circularexplanation.h"

#include "figures/circlefigure.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/evaluation/iso230_4/parameters.h"
#include "kernel/evaluation/resultsof.h"
#include "language/decimals.h"
#include "report/words/findingtext.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

using namespace iso230_4;

constexpr int leastDecimals = 2; ///< of inserted numbers: 0.01 µm, like the statistics per target
constexpr int angleDecimals = 1; ///< of ruling points

/// Explanation of one function of parameters.h. Placeholders in the formulas:
///   %s symbol of the parameter    [=]  the result with its unit
///   [+] [-] [r]  largest and smallest distance, radius of the circle, each from the nominal radius
///   [C] the correction; the text in {} is omitted if nothing is corrected here
struct CircularRecipe {
    std::optional<double> (*function)(const CircularCase &, const EvaluatedPath *) = nullptr;
    const char *formula = nullptr;
    const char *step = nullptr;
    bool ofPair = false;
    bool length = false; ///< F, D: about the least squares circle or the set-up
};

// clang-format off
constexpr std::array circularRecipes{
    CircularRecipe{deviationOfPath,         "%s = max r − min r", "%s = (max r − R) − (min r − R) = [+] − [-] = [=]", false, false},
    CircularRecipe{deviationOfPair,         "%s = max r − min r", "%s = (max r − R) − (min r − R) = [+] − [-] = [=]", true,  false},
    CircularRecipe{largestRadialDeviation,  "%s = max r − R + C", "%s = (max r − R){ + C} = {[+] + [C] = }[=]",       false, true},
    CircularRecipe{smallestRadialDeviation, "%s = min r − R + C", "%s = (min r − R){ + C} = {[-] + [C] = }[=]",       false, true},
    CircularRecipe{meanRadialDeviation,     "%s = R_LSC − R + C", "%s = (R_LSC − R){ + C} = {[r] + [C] = }[=]",       true,  true},
    CircularRecipe{hysteresis,              "%s = max |r_ccw(θ) − r_cw(θ)|", "%s = [=]",                              true,  true},
};
// clang-format on

class CircularExplainer {
public:
    CircularExplainer(const Test &test, const TestEvaluation &evaluation, const Parameter &parameter,
                      const PrintedNumbers &printed, const CircularRecipe &recipe, const Language &language)
        : m_test(test)
        , m_measurement(std::get<CircularMeasurement>(test.measurement))
        , m_evaluation(evaluation)
        , m_results(resultsOf(m_measurement, evaluation))
        , m_parameter(parameter)
        , m_printed(printed)
        , m_decimals(std::max(leastDecimals, printed.decimals))
        , m_recipe(recipe)
        , m_language(language) {
        if (!aboutSetUp())
            m_circle = m_results.circle(of(), recipe.length ? ReferenceCircle::leastSquares
                                                            : m_measurement.referenceCircle);
        m_correction = recipe.length && parameter.dependsOnTemperature ? m_results.correction : std::nullopt;
    }

    [[nodiscard]] Explanation explain() const {
        Explanation result;
        result.id = QString::fromStdString(parameterId(m_parameter));
        result.symbol = symbolFormula(m_parameter);
        result.name = m_language.text(m_parameter.term.name);
        result.formula = filled(QString::fromUtf8(m_recipe.formula));
        const std::string edition = m_evaluation.edition->word;
        result.source = *m_parameter.term.clause == 0 ? QString::fromStdString(edition)
                                                      : say(REPORT_TEXT("report", "%1, clause %2"),
                                                            {edition, std::string(m_parameter.term.clause)});
        if (!m_parameter.value) {
            result.words = reasons();
            return result;
        }
        result.points = rulingPoints();
        if (m_correction)
            result.steps.push_back(correctionStep());
        result.steps.push_back(filled(withCorrection(QString::fromUtf8(m_recipe.step))));
        result.words = words(result.points);
        result.result = result.symbol.plain() + QStringLiteral(" = ") + shownResult();
        return result;
    }

private:
    [[nodiscard]] QString say(const Text &text, std::vector<Argument> arguments = {}) const {
        return m_language.sentence(text, std::move(arguments));
    }

    [[nodiscard]] bool aboutSetUp() const {
        return m_recipe.length && !m_recipe.ofPair && m_measurement.centring == Centring::instrument;
    }

    [[nodiscard]] const EvaluatedPath *path() const {
        const auto found = std::ranges::find(m_results.paths, m_parameter.index, &EvaluatedPath::index);
        return found == m_results.paths.end() ? nullptr : &*found;
    }

    [[nodiscard]] CircleOf of() const {
        return m_recipe.ofPair || !path() ? CircleOf::both : circleOf(path()->sense);
    }

    // ---- Formulas ----------------------------------------------------------------------------------------

    [[nodiscard]] QString number(double value) const {
        return m_language.number(value, Quantity::deviation, m_decimals);
    }
    [[nodiscard]] QString shownResult() const {
        return withUnit(m_printed.value, Quantity::deviation, m_language);
    }
    /// A negative number after an operator is put in parentheses.
    [[nodiscard]] static QString inSum(const QString &shown) {
        return shown.startsWith(u'−') ? u'(' + shown + u')' : shown;
    }

    /// The value of a placeholder, mm.
    [[nodiscard]] double valueOf(QChar name) const {
        const double nominal = m_measurement.nominalRadius;
        const double c = m_correction.value_or(0);
        switch (name.unicode()) {
        case '+':
            return m_circle ? m_circle->outerRadius - nominal : *m_parameter.value - c;
        case '-':
            return m_circle ? m_circle->innerRadius - nominal : *m_parameter.value - c;
        case 'r':
            return m_circle ? m_circle->radius - nominal : *m_parameter.value - c;
        default:
            return c;
        }
    }

    [[nodiscard]] QString withCorrection(QString source) const {
        for (qsizetype open = source.indexOf(u'{'); open >= 0; open = source.indexOf(u'{')) {
            const qsizetype close = source.indexOf(u'}', open);
            const QString inside = m_correction ? source.mid(open + 1, close - open - 1) : QString();
            source.replace(open, close - open + 1, inside);
        }
        return source;
    }

    [[nodiscard]] Formula filled(const QString &source) const {
        Formula result;
        QString plain;
        const auto flush = [&] {
            result += formulaFrom(plain);
            plain.clear();
        };
        for (qsizetype i = 0; i < source.size(); ++i) {
            if (source[i] == u'%') {
                flush();
                result += symbolFormula(m_parameter);
                ++i;
            } else if (source[i] == u'[') {
                const bool afterSign =
                    plain.endsWith(QStringLiteral("+ ")) || plain.endsWith(QStringLiteral("− "));
                flush();
                const QChar name = source[i + 1];
                const QString shown = name == u'=' ? shownResult() : number(valueOf(name));
                result.spans.push_back({afterSign ? inSum(shown) : shown, false, true});
                i += 2;
            } else {
                plain += source[i];
            }
        }
        flush();
        return result;
    }

    [[nodiscard]] Formula correctionStep() const {
        const Conditions &conditions = m_measurement.conditions.common;
        const auto shown = [&](std::optional<double> value, Quantity quantity) {
            // A mean may have no short decimal form.
            return value ? m_language.number(*value, quantity, decimalsOf(*value, quantity))
                         : QStringLiteral("–");
        };
        const auto part = [&](std::optional<double> alpha, SensorMeasures what) {
            return QStringLiteral("%1·(%2 − 20)")
                .arg(shown(alpha, Quantity::expansion),
                     shown(meanTemperature(conditions, what), Quantity::temperature));
        };
        Formula result =
            formulaFrom(QStringLiteral("C = R·[α_i·(T_i − 20) − α_m·(T_m − 20)] = %1·[%2 − %3]/1000 = ")
                            .arg(m_language.number(m_measurement.nominalRadius, Quantity::position),
                                 part(conditions.expansion.instrument, SensorMeasures::instrument),
                                 part(conditions.expansion.machine, SensorMeasures::machine)));
        result.spans.push_back(
            {m_language.quantity(*m_correction, Quantity::deviation, m_decimals), false, true});
        return result;
    }

    // ---- Ruling points -----------------------------------------------------------------------------------

    [[nodiscard]] std::vector<RulingPoint> rulingPoints() const {
        if (m_recipe.length && m_recipe.ofPair)
            return {}; // the radius depends on all points
        CircleFigureOptions options;
        options.of = of();
        options.subject = m_recipe.length ? CircleSubject::radialDeviation : CircleSubject::circularDeviation;
        options.contacts = true;
        const CircleFigure figure = circleFigure(m_test, m_evaluation, m_language, options);
        const bool smallest = m_recipe.function == smallestRadialDeviation;
        std::vector<RulingPoint> result;
        for (const ContactMark &contact : figure.contacts) {
            if (m_recipe.length && contact.outer == smallest)
                continue; // belongs to the other one of Fmax and Fmin
            result.push_back({axisIndexOf(contact.mark.sense), std::remainder(contact.mark.at.angle, 360.0),
                              contact.outer});
        }
        return result;
    }

    [[nodiscard]] QString axisIndexOf(Sense sense) const {
        const auto found = std::ranges::find(m_results.paths, sense, &EvaluatedPath::sense);
        return found == m_results.paths.end() ? QString() : QString::fromStdString(found->index);
    }

    [[nodiscard]] QString places(const std::vector<RulingPoint> &points, bool outer) const {
        QStringList texts;
        for (const RulingPoint &point : points) {
            if (point.outer == outer)
                texts << m_language.quantity(point.angle, Quantity::angle, angleDecimals) +
                             QStringLiteral(" (") + point.path + u')';
        }
        return texts.join(QStringLiteral(", "));
    }

    // ---- Words -------------------------------------------------------------------------------------------

    [[nodiscard]] QString centre() const {
        const auto coordinate = [&](const std::string &axis, double value) {
            return QString::fromStdString(axis) + QStringLiteral("\u00A0") + number(value);
        };
        return coordinate(m_measurement.plane.first, m_circle->centre.x) + QStringLiteral(", ") +
               coordinate(m_measurement.plane.second, m_circle->centre.y) + QStringLiteral("\u00A0") +
               m_language.unit(Quantity::deviation);
    }

    [[nodiscard]] QStringList words(const std::vector<RulingPoint> &points) const {
        QStringList result;
        if (m_circle && m_circle->kind == ReferenceCircle::minimumZone)
            result << say(REPORT_TEXT("report", "About the centre of the minimum zone circles: %1."),
                          {centre().toStdString()});
        else if (m_circle)
            result << say(REPORT_TEXT("report", "About the centre of the least squares circle: %1."),
                          {centre().toStdString()});
        else if (aboutSetUp())
            result << say(REPORT_TEXT(
                "report", "About the centre the instrument was set up at: the set-up error is part of it."));
        if (m_recipe.ofPair)
            result << say(m_recipe.length
                              ? REPORT_TEXT("report", "Both paths about one centre, each with equal weight.")
                              : REPORT_TEXT("report", "The points of both paths about one centre."));
        if (m_circle && m_circle->certified)
            result << say(
                *m_circle->certified
                    ? REPORT_TEXT("report", "Proven: no narrower pair of circles holds all points.")
                    : REPORT_TEXT("report", "Not proven: a narrower pair of circles may hold all points."));
        if (const QString outer = places(points, true); !outer.isEmpty())
            result << say(REPORT_TEXT("report", "Farthest from the centre at %1."), {outer.toStdString()});
        if (const QString inner = places(points, false); !inner.isEmpty())
            result << say(REPORT_TEXT("report", "Nearest to the centre at %1."), {inner.toStdString()});
        if (m_correction)
            result << say(REPORT_TEXT("report", "With the correction to 20 °C applied here."));
        else if (m_results.at20 == At20::wrong && m_parameter.dependsOnTemperature)
            result << say(REPORT_TEXT("report", "Not corrected to 20 °C."));
        return result;
    }

    [[nodiscard]] QStringList reasons() const {
        QStringList result;
        for (const Finding &finding : m_evaluation.findings) {
            if (finding.explains == Explains::missingValues)
                result << findingText(finding, m_language);
        }
        return result;
    }

    const Test &m_test;
    const CircularMeasurement &m_measurement;
    const TestEvaluation &m_evaluation;
    const CircularResults &m_results;
    const Parameter &m_parameter;
    const PrintedNumbers m_printed;
    int m_decimals; ///< of inserted numbers
    const CircularRecipe &m_recipe;
    const Language &m_language;
    const CircleResult *m_circle = nullptr; ///< circle the distances start from; null: the set-up
    std::optional<double> m_correction;     ///< mm
};

} // namespace

std::optional<Explanation> circularExplanation(const Test &test, const TestEvaluation &evaluation,
                                               const Parameter &parameter, const PrintedNumbers &printed,
                                               const Language &language) {
    const auto &rows = evaluation.edition->circles->rows;
    const auto row = std::ranges::find(rows, std::string_view(parameter.term.id),
                                       [](const CircularRow &r) { return std::string_view(r.term.id); });
    if (row == rows.end())
        return std::nullopt;
    const auto recipe = std::ranges::find(circularRecipes, row->value, &CircularRecipe::function);
    if (recipe == circularRecipes.end())
        return std::nullopt;
    return CircularExplainer(test, evaluation, parameter, printed, *recipe, language).explain();
}

} // namespace palmer
