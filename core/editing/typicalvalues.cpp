// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/typicalvalues.h"

#include "document/evaluateddocument.h"
#include "document/setfield.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/uncertainty/positioningbudget.h"
#include "kernel/words/shortest.h"
#include "language/decimals.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double micrometresPerMm = 1000;
constexpr double typicalExpansion = 1; ///< standard uncertainty for U = 2 at k = 2, µm/(m·°C)

QString said(const Language &language, const Text &text, const QString &argument) {
    return language.sentence({text, {argument.toStdString()}});
}

void addLinear(std::vector<TypicalValue> &values, const Language &language) {
    values.push_back(
        {said(language, REPORT_TEXT("report", "Range of α, machine: %1"),
              language.quantity(typicalExpansionRange, Quantity::expansion)),
         language.text(REPORT_TEXT("report", "gives U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2")),
         {{"uncertainty.expansionRange.machine", shortest(typicalExpansionRange)}}});
    values.push_back({language.text(REPORT_TEXT("report", "Laser interferometer: α 0")),
                      language.text(REPORT_TEXT("report", "light has no material that expands")),
                      {{"conditions.expansion.instrument", "0"},
                       {"uncertainty.temperatureRange.instrument", "0"},
                       {"uncertainty.expansionRange.instrument", "0"}}});
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
                          {{"uncertainty.resolution", shortest(step)}}});
    }
    values.push_back(
        {said(language, REPORT_TEXT("report", "u of α, machine: %1"),
              language.quantity(typicalExpansion, Quantity::expansion)),
         language.text(REPORT_TEXT("report", "half of U(α) = 2 µm/(m·°C), the typical minimum of ISO 230-2")),
         {{"uncertainty.expansionStandardUncertainty.machine", shortest(typicalExpansion)}}});
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
        if (isDrift(*other) && !other->id.empty() &&
            (motionOf(*other) == motionOf(test) || driftVariation(document, other->id, test) ||
             (named && *named == other->id)))
            result.push_back(other);
    }
    return result;
}

std::vector<TypicalValue> typicalValues(const Document &document, const Test &test,
                                        const Language &language) {
    std::vector<TypicalValue> values;
    if (!methodOf(test))
        return values; // has no uncertainty
    if (isCircle(test))
        addCircular(values, document, test, language);
    else if (motionOf(test) == Motion::linear)
        addLinear(values, language);
    for (const TestPointer &drift : driftTestsFor(document, test)) {
        const auto found = driftVariation(document, drift->id, test);
        if (!found)
            continue;
        constexpr int decimals = 2;
        values.push_back(
            {said(language, REPORT_TEXT("report", "E_VE: %1"),
                  language.quantity(found->value, deviationQuantity(test), decimals)),
             driftTestName(*drift, language),
             {{"uncertainty.driftTest", drift->id}, {"uncertainty.environmentalVariation", "null"}}});
    }
    return values;
}

std::string pathInFile(std::size_t test, const std::string &field) {
    return "tests[" + std::to_string(test) + "]." + field;
}

Document withTypicalValue(Document document, std::size_t test, const TypicalValue &value) {
    for (const auto &[field, text] : value.fields)
        document = withField(document, pathInFile(test, field), text);
    return document;
}

} // namespace palmer
