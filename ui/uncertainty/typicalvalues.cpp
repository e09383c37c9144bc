// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/uncertainty/typicalvalues.h"

#include "kernel/measurement/testfacts.h"
#include "kernel/uncertainty/positioningbudget.h"
#include "language/decimals.h"

#include <QCoreApplication>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr double micrometresPerMm = 1000;
constexpr double typicalExpansion = 1; ///< u of what has U = 2 at k = 2, µm/(m·°C)

QString uncertaintyText(const char *source) {
    return QCoreApplication::translate("palmer::ui::UncertaintyPage", source);
}

void addLinear(std::vector<TypicalValue> &values, const Language &language) {
    values.push_back(
        {uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Range of α, machine: %1"))
             .arg(language.quantity(typicalExpansionRange, Quantity::expansion)),
         uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage",
                                           "gives U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2")),
         [](Test &test) {
             std::get<PositioningMeasurement>(test.measurement).uncertainty.expansionRange.machine =
                 typicalExpansionRange;
         }});
    values.push_back(
        {uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Laser interferometer: α 0")),
         uncertaintyText(
             QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "light has no material that expands")),
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
        values.push_back({uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Resolution: %1"))
                              .arg(language.quantity(step, Quantity::micrometres)),
                          uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage",
                                                            "as stated for the instrument %1"))
                              .arg(QString::fromStdString(
                                  instrument.description.empty() ? instrument.id : instrument.description)),
                          [step](Test &changed) {
                              std::get<CircularMeasurement>(changed.measurement).uncertainty.resolution =
                                  step;
                          }});
    }
    values.push_back(
        {uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "u of α, machine: %1"))
             .arg(language.quantity(typicalExpansion, Quantity::expansion)),
         uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage",
                                           "half of U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2")),
         [](Test &changed) {
             std::get<CircularMeasurement>(changed.measurement)
                 .uncertainty.expansionStandardUncertainty.machine = typicalExpansion;
         }});
}

} // namespace

QString driftTestName(const Test &drift) {
    if (!drift.title.empty())
        return QString::fromStdString(drift.title);
    const std::string axis = axesOf(drift);
    return uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "drift test %1"))
        .arg(QString::fromStdString(axis.empty() ? drift.id : axis));
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
        values.push_back({uncertaintyText(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "E_VE: %1"))
                              .arg(language.quantity(*range, deviationQuantity(*drift), decimals)),
                          driftTestName(*drift), [id = drift->id](Test &changed) {
                              withUncertainty(changed, [&](auto &inputs) {
                                  inputs.driftTest = id;
                                  inputs.environmentalVariation.reset();
                              });
                          }});
    }
    return values;
}

} // namespace palmer::ui
