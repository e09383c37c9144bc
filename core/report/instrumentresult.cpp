#include "report/instrumentresult.h"

#include "import/units.h"

#include <string_view>

namespace palmer {

namespace {

/// Which of our results says the same as one of an instrument's program. Its circularity is the difference of
/// the largest and smallest radius over all its runs.
const Parameter *ourResult(const TestEvaluation &evaluation, const std::string &name) {
    const auto withId = [&](std::string_view id) -> const Parameter * {
        for (const Parameter &parameter : evaluation.parameters) {
            if (parameter.value && (parameterId(parameter) == id || parameter.term.id == id))
                return &parameter;
        }
        return nullptr;
    };
    if (name.ends_with("AF_CIRCULARITY")) {
        const Parameter *both = withId("G(b)");
        return both ? both : withId("G");
    }
    return withId(name);
}

} // namespace

std::vector<InstrumentResult> instrumentResults(const Test &test, const TestEvaluation &evaluation) {
    std::vector<InstrumentResult> results;
    for (const ImportedFile &file : test.imports) {
        for (const ImportedResult &stated : file.results) {
            InstrumentResult &result = results.emplace_back(InstrumentResult{&file, &stated});
            const Parameter *ours = ourResult(evaluation, stated.name);
            if (!ours)
                continue;
            const Unit *unit = unitOfSign(stated.unit);
            const bool angle = ours->term.quantity == Quantity::angularDeviation;
            if (unit && unit->kind == (angle ? UnitKind::angle : UnitKind::length)) {
                result.ours = ours;
                result.value = unit->toBase(stated.value);
            }
        }
    }
    return results;
}

} // namespace palmer
