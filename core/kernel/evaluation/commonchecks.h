// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/requirement.h"
#include "kernel/measurement/test.h"

/// What editions ask of positioning and circular tests alike: of their conditions, and of what was agreed.
namespace palmer::common {

/// The air within 20 ± 0.5 °C where the room can be controlled: every value of its sensors, of which each has
/// start and end. The tolerance is that of ISO 230-2:1988, 3.1; ISO 230-4 has none in its text.
[[nodiscard]] Judgement temperature(const Conditions &conditions, Text outside);
/// Corrected to 20 °C where the test was made at another temperature.
[[nodiscard]] Judgement correction(const Conditions &conditions, At20 lengths,
                                   Message (*notCorrected)(const OtherTemperature &away));
[[nodiscard]] bool mayBeControlled(const Conditions &conditions);

[[nodiscard]] Judgement
stabilised(const Conditions &conditions); ///< declared, or a time of soaking is stated
[[nodiscard]] Judgement shielded(const Conditions &conditions);
[[nodiscard]] Judgement complete(const Conditions &conditions);
[[nodiscard]] Judgement levelled(const Conditions &conditions);
[[nodiscard]] Judgement unloaded(const Conditions &conditions);
[[nodiscard]] Judgement otherAxes(const Conditions &conditions);

/// As the maker specifies or as agreed; nothing specified: only the movements that set up the instruments.
[[nodiscard]] Judgement warmUpOrSetUp(const Conditions &conditions, const Test &test);
/// As the maker specifies or as agreed; nothing specified: a dry run or set-up movements. Stated in any case.
[[nodiscard]] Judgement warmUpStated(const Conditions &conditions, const Test &test);

/// A text, or the offsets of the measuring line to tool and workpiece.
[[nodiscard]] bool instrumentPosition(const Conditions &conditions);
/// The machine has sensors, and each that may be one of them says where it is.
[[nodiscard]] bool machineSensorsPlaced(const Conditions &conditions);
/// Every sensor says what it measures.
[[nodiscard]] bool sensorsNamed(const Conditions &conditions);
/// A start, an end or a series of any sensor of that kind.
[[nodiscard]] bool anyTemperature(const Conditions &conditions, SensorMeasures what);
/// Start and end of all sensors that have one of them.
[[nodiscard]] Judgement temperaturesAtStartAndEnd(const Conditions &conditions);
/// Coefficients of expansion of machine and instrument.
[[nodiscard]] Judgement expansionStated(const Conditions &conditions);
/// Offsets of the measuring line to tool and workpiece.
[[nodiscard]] Judgement offsetsStated(const Conditions &conditions);
/// U of each result; `results`: those without one, as resultsWithoutUncertainty.
[[nodiscard]] Judgement uncertainty(const std::string &results);
[[nodiscard]] bool allStated(const Point3 &point);

/// A row on the conditions of a test.
template <auto check, class Case>
Judgement ofConditions(const Case &test) {
    if constexpr (requires { check(test.common(), test.test); })
        return Judgement(check(test.common(), test.test));
    else
        return Judgement(check(test.common()));
}

/// The same for what is stated or not.
template <auto stated, class Case>
Judgement statingConditions(const Case &test) {
    return stated(test.common()) ? Judgement::met() : Judgement::unmet();
}

template <class Case>
bool controllable(const Case &test) {
    return mayBeControlled(test.common());
}

} // namespace palmer::common
