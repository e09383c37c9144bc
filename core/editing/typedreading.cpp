#include "editing/typedreading.h"

#include "language/decimals.h"

#include <cmath>

namespace palmer {

double deviationFrom(double target, double position) {
    constexpr double grid = 1e9;
    return std::round((position - target) * grid) / grid;
}

TypedReading typedReading(QStringView text, const Axis &axis, const DisplayUnits &units,
                          std::optional<double> target) {
    const TypedNumber number = typedNumber(text);
    if (number.decimal.empty())
        return {std::nullopt, number.problem};
    const Quantity quantity = target ? positionQuantity(axis) : deviationQuantity(axis);
    const double value = fromShown(number.decimal, quantity, units);
    return {target ? deviationFrom(*target, value) : value, {}};
}

} // namespace palmer
