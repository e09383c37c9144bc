#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/iso230_2/checks.h"
#include "kernel/evaluation/iso230_2/correction.h"
#include "kernel/evaluation/iso230_2/sentences.h"

#include <algorithm>
#include <cmath>

namespace palmer::iso230_2 {

namespace {

constexpr double reference = 20; ///< °C
constexpr double margin1988 = 0.5;

Number celsius(double value) {
    return {value, Quantity::temperature, -1};
}

Sentence notCorrectedFrom(const PositioningCase &test, const std::optional<MeanTemperature> &away) {
    if (!away || !isNotCorrected(test.measurement) ||
        test.common().correctionTo20 == CorrectionTo20::appliedHere)
        return std::nullopt; // asked for but impossible: correctionImpossible says why
    return Message{away->of == SensorMeasures::machine
                       ? REPORT_TEXT("report", "The machine was at %1 on average and the results are not "
                                               "corrected to 20 °C.")
                       : REPORT_TEXT("report", "The instrument was at %1 on average and the results are not "
                                               "corrected to 20 °C."),
                   {Number{away->value, Quantity::temperature, 1}}};
}

} // namespace

Sentence temperature1988(const PositioningCase &test) {
    double worst = reference;
    for (const Sensor &sensor : test.conditions().common.sensors) {
        for (const auto value : {startTemperature(sensor), endTemperature(sensor)}) {
            if (value && std::abs(*value - reference) > std::abs(worst - reference))
                worst = *value;
        }
    }
    if (std::abs(worst - reference) <= margin1988 + 1e-9)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report", "Temperature %1: where it can be controlled, 20 °C ± 0.5 °C are asked for."),
        {celsius(worst)}};
}

Sentence correction1988(const PositioningCase &test) {
    return notCorrectedFrom(test, awayFrom20(test.common(), margin1988));
}

Sentence correction(const PositioningCase &test) {
    return notCorrectedFrom(test, awayFrom20(test.common()));
}

Sentence correctionImpossible(const PositioningCase &test) {
    if (!test.linear() || test.common().correctionTo20 != CorrectionTo20::appliedHere ||
        isCorrectedTo20(test.common()))
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The correction to 20 °C cannot be applied: it needs the temperatures at start and end "
                    "and the coefficients of thermal expansion of machine and instrument (0 for a "
                    "laser whose compensation covers the air only)."),
        {}};
}

Sentence correctionOfRotary(const PositioningCase &test) {
    if (test.linear() || test.conditions().common.correctionTo20 != CorrectionTo20::appliedHere)
        return std::nullopt;
    return Message{REPORT_TEXT("report", "A rotary axis has no correction to 20 °C: none was applied."), {}};
}

Sentence expansionUncertainty(const PositioningCase &test) {
    const auto range = test.measurement.uncertainty.expansionRange.machine;
    constexpr double factor = 0.6;  // expanded uncertainty of a quantity known by its range
    constexpr double typical = 2.0; // µm/(m·°C), the smallest that is usual
    if (!test.linear() || !range || factor * *range >= typical)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "The stated uncertainty of the expansion coefficient of the machine, %1, is below the "
                    "typical minimum of %2."),
        {Number{factor * *range, Quantity::expansion, 2}, Number{typical, Quantity::expansion, -1}}};
}

Sentence incomplete(const PositioningCase &test) {
    if (test.conditions().common.complete.value_or(true))
        return std::nullopt;
    return Message{REPORT_TEXT("report", "The machine was not complete."), {}};
}

Sentence notLevelled(const PositioningCase &test) {
    if (test.conditions().common.levelled.value_or(true))
        return std::nullopt;
    return Message{REPORT_TEXT("report", "The machine was not levelled and aligned."), {}};
}

Sentence loaded(const PositioningCase &test) {
    if (test.conditions().common.unloaded.value_or(true))
        return std::nullopt;
    return Message{REPORT_TEXT("report", "The machine was not unloaded."), {}};
}

Sentence warmUp1988(const PositioningCase &test) {
    if (test.conditions().common.warmUp.kind != WarmUpKind::dryRun || test.agreed("warmUp"))
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "A dry run without an agreed warm-up: only the movements needed to set up the "
                               "instrument are allowed."),
                   {}};
}

Sentence warmUpProcedure(const PositioningCase &test) {
    const WarmUp &warmUp = test.conditions().common.warmUp;
    if (warmUp.kind != WarmUpKind::procedure || !warmUp.text.empty() || test.agreed("warmUp"))
        return std::nullopt;
    return Message{REPORT_TEXT("report", "The warm-up procedure is neither described nor agreed."), {}};
}

Sentence compensationStated(const PositioningCase &test) {
    if (!test.conditions().common.compensation.empty())
        return std::nullopt;
    return Message{REPORT_TEXT("report", "Not stated: compensation active during the test."), {}};
}

Sentence uncertaintyStated(const PositioningCase &test) {
    if (test.uncertaintyStated)
        return std::nullopt;
    return Message{REPORT_TEXT("report", "The measurement uncertainty is not stated beside every result."),
                   {}};
}

} // namespace palmer::iso230_2
