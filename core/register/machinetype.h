// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/typetest/typetest.h"
#include "register/machinetrend.h"

#include <map>

namespace palmer {

/// Returns the machines of a type: `words` is the type, or maker and type, compared like identities.
[[nodiscard]] std::vector<ListedMachine> machinesOfType(const std::vector<ListedMachine> &machines,
                                                        const QString &words);

/// True if a type test can be made of the parameter: signed ones (B̄, D, Fmax, Fmin) have no upper limit.
[[nodiscard]] bool hasTypeTest(const std::string &parameter);

/// The newest comparable test of a machine.
struct TypeMember {
    ListedMachine machine;
    ListedTest test;
    RegisteredResult result; ///< its value is never null
};

/// A machine of the type without a comparable test.
struct TypeOutsider {
    ListedMachine machine;
    ListedTest test; ///< its newest with the parameter
    SeriesDifference difference;
};

/// The type test of a parameter: one value a machine, from tests that are comparable like those of a trend.
struct TypeTest {
    std::string axis;
    std::string parameter;
    bool angular = false;
    TrendSeries series; ///< what the tests have in common; without entries
    Tolerance tolerance;
    TypeDistribution distribution = TypeDistribution::logNormal;
    std::vector<TypeMember> members; ///< by value
    std::vector<TypeOutsider> outsiders;
    std::optional<TypeStatistics> statistics; ///< null with fewer than `fewestMachines`
};

/// Returns the type test of an axis or plane over tests of several machines, in the order of tests(). Of the
/// series that their tests fall into, the one with the most machines is taken, then the newest. Values are
/// not corrected for their U. A machine without any value is left out silently.
[[nodiscard]] TypeTest typeTest(const std::vector<ListedMachine> &machines,
                                const std::vector<ListedTest> &tests, const std::string &axis,
                                const std::string &parameter, const Tolerance &tolerance,
                                TypeDistribution distribution);

} // namespace palmer
