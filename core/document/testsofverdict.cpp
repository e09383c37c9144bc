#include "document/testsofverdict.h"

#include <algorithm>

namespace palmer {

bool countsForVerdict(const Document &document, std::size_t test) {
    if (document.tests[test]->role != TestRole::asFound)
        return true;
    return std::ranges::none_of(document.tests, [](const TestPointer &other) {
        return !std::holds_alternative<DriftMeasurement>(other->measurement) &&
               other->role != TestRole::asFound;
    });
}

} // namespace palmer
