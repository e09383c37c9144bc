// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/requirement.h"
#include "kernel/measurement/test.h"

/// Requirements common to positioning and circular tests, on conditions and agreed points.
namespace palmer::common {

/// Air within 20 ± 0.5 °C if the room can be controlled: all values of its sensors, each with start and end.
/// The tolerance is from ISO 230-2:1988, 3.1; ISO 230-4 has none in its text.
[[nodiscard]] Judgement temperature(const Conditions &conditions, Text outside);
/// Corrected to 20 °C if the test was made at another temperature.
[[nodiscard]] Judgement correction(const Conditions &conditions, At20 lengths,
                                   Message (*notCorrected)(const OtherTemperature &away));
[[nodiscard]] bool mayBeControlled(const Conditions &conditions);

[[nodiscard]] Judgement otherAxes(const Conditions &conditions);

/// As specified by the maker or agreed; if not specified, only the movements to set up the instruments.
[[nodiscard]] Judgement warmUpOrSetUp(const Conditions &conditions, const Test &test);
/// As specified by the maker or agreed; if not specified, a dry run or set-up movements. Always stated.
[[nodiscard]] Judgement warmUpStated(const Conditions &conditions, const Test &test);

/// A text, or the offsets of the measuring line to tool and workpiece.
[[nodiscard]] bool instrumentPosition(const Conditions &conditions);
/// The machine has sensors, and each sensor that may be one states its location.
[[nodiscard]] bool machineSensorsPlaced(const Conditions &conditions);
/// True if every sensor states what it measures.
[[nodiscard]] bool sensorsNamed(const Conditions &conditions);
/// True if any sensor of that kind has a start, an end or a series.
[[nodiscard]] bool anyTemperature(const Conditions &conditions, SensorMeasures what);
/// Start and end of all sensors that have either.
[[nodiscard]] Judgement temperaturesAtStartAndEnd(const Conditions &conditions);
/// Coefficients of expansion of machine and instrument.
[[nodiscard]] Judgement expansionStated(const Conditions &conditions);
/// Offsets of the measuring line to tool and workpiece.
[[nodiscard]] Judgement offsetsStated(const Conditions &conditions);
/// U of each result; `results`: those without U, from resultsWithoutUncertainty.
[[nodiscard]] Judgement uncertainty(const std::string &results);
[[nodiscard]] bool allStated(const Point3 &point);

/// A row about the conditions of a test.
template <auto check, class Case>
Judgement ofConditions(const Case &test) {
    if constexpr (requires { check(test.common(), test.test); })
        return Judgement(check(test.common(), test.test));
    else
        return Judgement(check(test.common()));
}

/// A row about a condition that is declared or not.
template <auto member, class Case>
Judgement ofDeclared(const Case &test) {
    return Judgement::of(test.common().*member);
}

/// A row about a condition that is stated or not.
template <auto stated, class Case>
Judgement statingConditions(const Case &test) {
    return stated(test.common()) ? Judgement::met() : Judgement::unmet();
}

/// A row about U of the results.
template <class Case>
Judgement uncertaintyStated(const Case &test) {
    return uncertainty(test.withoutUncertainty);
}

template <class Case>
bool controllable(const Case &test) {
    return mayBeControlled(test.common());
}

} // namespace palmer::common
