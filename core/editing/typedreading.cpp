#include "editing/typedreading.h"

#include "language/decimals.h"

#include <cmath>

namespace palmer {

double deviationFrom(double target, double position) {
    constexpr double grid = 1e9;
    return std::round((position - target) * grid) / grid;
}

NumberEntry typedReading(QStringView text, const Axis &axis, const DisplayUnits &units,
                         std::optional<double> target) {
    const QStringView typed = text.trimmed();
    if (typed == u"-" || typed == u"–" || typed == u"−")
        return {};
    NumberEntry entry =
        enteredNumber(typed, target ? positionQuantity(axis) : deviationQuantity(axis), units);
    if (target && entry.value)
        entry.value = deviationFrom(*target, *entry.value);
    return entry;
}

} // namespace palmer
