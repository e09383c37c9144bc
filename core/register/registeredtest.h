// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "kernel/evaluation/coverage.h"
#include "kernel/trend/trendline.h"

#include <QByteArray>
#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace palmer {

/// A result as stored in the register. Values in mm or degrees, unrounded.
struct RegisteredResult {
    std::string id; ///< "A", "G(b)_XY"
    std::optional<double> value;
    std::optional<double> expandedUncertainty;
    std::optional<double> k; ///< 2; null for a simulated U (95.45 %), and without U
    std::optional<double> limit;
    std::optional<double> guardBand;
    Bound bound = Bound::magnitude;
    std::optional<Verdict> verdict;
    std::optional<int> decimals;            ///< of the value as printed in every report; null: not stored
    std::optional<int> uncertaintyDecimals; ///< of U
    double own = 0;                         ///< r: the share of U/k that belongs to this test alone
    unsigned shared = 0;                    ///< parts of the test included in U: bit i is part i
    double sharedFactor = 1;                ///< factor of those parts
    bool withoutParts = false; ///< U has no separate parts: all of it is treated as shared by the instrument

    /// Probability covered by U; null without U.
    [[nodiscard]] std::optional<double> coverageProbability() const {
        if (!expandedUncertainty)
            return {};
        return k ? Coverage{}.probability : palmer::coverageProbability;
    }

    bool operator==(const RegisteredResult &) const = default;
};

/// An instrument used for a test.
struct RegisteredInstrument {
    std::string description; ///< description, maker and type
    std::string serialNumber;
    std::string certificate;
    std::optional<std::string> due; ///< YYYY-MM-DD

    bool operator==(const RegisteredInstrument &) const = default;
};

/// Means at a target, mm or degrees; null without readings.
struct CurvePoint {
    double target = 0;
    std::optional<double> up;
    std::optional<double> down;

    bool operator==(const CurvePoint &) const = default;
};

/// The data of a test stored in the register: a pure function of the evaluated document.
struct RegisteredTest {
    QString digest; ///< SHA-256 of program, machine, instruments and test without bytes of imported files
    QString fingerprint; ///< of the readings only
    std::string machineName;
    std::string manufacturer;
    std::string model;
    std::string serialNumber;
    std::string location;
    Kind kind = Kind::positioning;
    std::string title;
    std::string id;
    std::string edition; ///< word; empty for drift tests
    std::string axis;    ///< or plane: "XY"
    bool angular = false;
    std::optional<std::string> date;
    std::optional<std::string> time;
    std::optional<double> feed;   ///< mm/min or °/min; null: rapid or not stated
    std::optional<double> travel; ///< measurement travel, mm or degrees; for a circle its radius
    std::string setUp;            ///< further properties of the series: "step; zone 0 … 500; runs 5 + 5"
    CorrectionTo20 correction = CorrectionTo20::notStated;
    Purpose purpose = Purpose::notStated;
    TestRole role = TestRole::notStated;
    std::optional<Verdict> verdict;
    Rule rule = Rule::simpleAcceptance;
    Accordance accordance = Accordance::notChecked;
    RequirementCounts counts;
    bool awaitsSimulation = false; ///< the method is Monte Carlo and no simulation was run yet
    std::vector<RegisteredInstrument> instruments;
    std::vector<SharedPart> parts; ///< shared parts of U; standard uncertainties, mm or degrees
    std::vector<RegisteredResult> results;
    std::vector<CurvePoint> curve; ///< for a positioning test

    bool operator==(const RegisteredTest &) const = default;
};

/// Returns all tests of a document, in its order. `program` is part of the digest: another evaluation is
/// another entry. Throws the errors of writeDocument.
[[nodiscard]] std::vector<RegisteredTest> registeredTests(const EvaluatedDocument &evaluated,
                                                          const QString &program);

/// True if any of its results has a limit.
[[nodiscard]] bool hasLimit(const RegisteredTest &test);

/// Returns the result with that id; null without it.
[[nodiscard]] const RegisteredResult *resultOf(const RegisteredTest &test, const std::string &id);

/// Returns the quantity of an id without axes: "G(b)" for "G(b)_XY".
[[nodiscard]] std::string quantityOf(const std::string &resultId);

} // namespace palmer
