// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/fileunit.h"

namespace palmer {

Quantity quantityOf(FileUnit unit, Motion motion) {
    const bool linear = motion == Motion::linear;
    switch (unit) {
    case FileUnit::none:
    case FileUnit::minutes:
    case FileUnit::hours:
        break;
    case FileUnit::position:
        return linear ? Quantity::position : Quantity::angle;
    case FileUnit::deviation:
        return linear ? Quantity::deviation : Quantity::angularDeviation;
    case FileUnit::uncertainty:
        return linear ? Quantity::micrometres : Quantity::arcSeconds;
    case FileUnit::feed:
        return linear ? Quantity::feed : Quantity::angularFeed;
    case FileUnit::length:
        return Quantity::position;
    case FileUnit::linearDeviation:
        return Quantity::deviation;
    case FileUnit::angle:
        return Quantity::angle;
    case FileUnit::angularDeviation:
        return Quantity::angularDeviation;
    case FileUnit::perMetre: // the name of the field says "per metre"
        return Quantity::micrometres;
    case FileUnit::temperature:
        return Quantity::temperature;
    case FileUnit::gradient:
        return Quantity::gradient;
    case FileUnit::expansion:
        return Quantity::expansion;
    case FileUnit::seconds:
        return Quantity::time;
    case FileUnit::pressure:
        return Quantity::pressure;
    case FileUnit::percent:
        return Quantity::percent;
    }
    return Quantity::number;
}

} // namespace palmer
