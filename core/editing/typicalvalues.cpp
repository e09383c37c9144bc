// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/typicalvalues.h"

#include "kernel/measurement/testfacts.h"
#include "kernel/uncertainty/positioningbudget.h"
#include "language/decimals.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double micrometresPerMm = 1000;
constexpr double typicalExpansion = 1; ///< u of what has U = 2 at k = 2, µm/(m·°C)

QString said(const Language &language, const Text &text, const QString &argument) {
    return language.sentence({text, {argument.toStdString()}});
}

void addLinear(std::vector<TypicalValue> &values, const Language &language) {
    values.push_back(
        {said(language, REPORT_TEXT("report", "Range of α, machine: %1"),
              language.quantity(typicalExpansionRange, Quantity::expansion)),
         language.text(REPORT_TEXT("report", "gives U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2")),
         [](Test &test) {
             std::get<PositioningMeasurement>(test.measurement).uncertainty.expansionRange.machine =
                 typicalExpansionRange;
         }});
    values.push_back({language.text(REPORT_TEXT("report", "Laser interferometer: α 0")),
                      language.text(REPORT_TEXT("report", "light has no material that expands")),
                      [](Test &test) {
                          auto &measurement = std::get<PositioningMeasurement>(test.measurement);
                          measurement.conditions.common.expansion.instrument = 0;
                          measurement.uncertainty.temperatureRange.instrument = 0;
                          measurement.uncertainty.expansionRange.instrument = 0;
                      }});
}

void addCircular(std::vector<TypicalValue> &values, const Document &document, const Test &test,
                 const Language &language) {
    for (const Instrument &instrument : document.instruments) {
        if (!instrument.resolution ||
            std::ranges::find(test.instruments, instrument.id) == test.instruments.end())
            continue;
        const double step = *instrument.resolution * micrometresPerMm;
        values.push_back({said(language, REPORT_TEXT("report", "Resolution: %1"),
                               language.quantity(step, Quantity::micrometres)),
                          said(language, REPORT_TEXT("report", "as stated for the instrument %1"),
                               QString::fromStdString(
                                   instrument.description.empty() ? instrument.id : instrument.description)),
                          [step](Test &changed) {
                              std::get<CircularMeasurement>(changed.measurement).uncertainty.resolution =
                                  step;
                          }});
    }
    values.push_back(
        {said(language, REPORT_TEXT("report", "u of α, machine: %1"),
              language.quantity(typicalExpansion, Quantity::expansion)),
         language.text(REPORT_TEXT("report", "half of U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2")),
         [](Test &changed) {
             std::get<CircularMeasurement>(changed.measurement)
                 .uncertainty.expansionStandardUncertainty.machine = typicalExpansion;
         }});
}

} // namespace

QString driftTestName(const Test &drift, const Language &language) {
    if (!drift.title.empty())
        return QString::fromStdString(drift.title);
    const std::string axis = axesOf(drift);
    return said(language, REPORT_TEXT("report", "drift test %1"),
                QString::fromStdString(axis.empty() ? drift.id : axis));
}

std::vector<TestPointer> driftTestsFor(const Document &document, const Test &test) {
    std::vector<TestPointer> result;
    const std::string *named = driftTestOf(test);
    for (const TestPointer &other : document.tests) {
        if (!isJudged(*other) && !other->id.empty() &&
            (motionOf(*other) == motionOf(test) || (named && *named == other->id)))
            result.push_back(other);
    }
    return result;
}

std::vector<TypicalValue> typicalValues(const Document &document, const Test &test,
                                        const Language &language) {
    std::vector<TypicalValue> values;
    if (!axisOf(test))
        addCircular(values, document, test, language);
    else if (motionOf(test) == Motion::linear)
        addLinear(values, language);
    for (const TestPointer &drift : driftTestsFor(document, test)) {
        const auto range = rangeAtRest(*drift);
        if (!range || motionOf(*drift) != motionOf(test))
            continue;
        constexpr int decimals = 2;
        values.push_back({said(language, REPORT_TEXT("report", "E_VE: %1"),
                               language.quantity(*range, deviationQuantity(*drift), decimals)),
                          driftTestName(*drift, language), [id = drift->id](Test &changed) {
                              withUncertainty(changed, [&](auto &inputs) {
                                  inputs.driftTest = id;
                                  inputs.environmentalVariation.reset();
                              });
                          }});
    }
    return values;
}

} // namespace palmer
