// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "export/compensation.h"
#include "kernel/evaluation/iso230_4/contouringfeed.h"
#include "kernel/numerics/points.h"
#include "kernel/trend/notbefore.h"
#include "kernel/typetest/typetest.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <map>
#include <string>
#include <vector>

namespace palmer {

/// Source of the expected value: printed in the standard; recomputed elsewhere from the same data; exact by
/// construction; certified by an institute; computed by the second implementation
/// (resources/reference/second).
enum class ExpectationSource { published, recomputed, exact, certified, second };

/// Kind of expected value, by its key in the file, whose value is its id: "A", "mean+", "device", "range", …
enum class Expected {
    parameter,    ///< `of`: value, budget, budgetActual, expandedUncertainty, mean, u, low, high, verdict
    statistic,    ///< of a target
    contribution, ///< to a budget, k = 2
    drift,        ///< range of a drift test; change or t of the runs of an axis
    correction,   ///< C to 20 °C of a circular test
    influence,    ///< a source of a diagnosis, in the unit shown
    comparison, ///< of two tests, `of`: difference, U, word; `test` is the one after, the test before it its
                ///< pair
    compensation,   ///< value of a table at its point `target`, by direction
    trend,          ///< a number of a line, "statement" or "notBefore"
    contouringFeed, ///< for another diameter
    circle,   ///< of points: lsc_cx, lsc_cy, lsc_R, lsc_width; mzc_cx, mzc_cy, mzc_Ro, mzc_Ri, mzc_width
    sheet,    ///< the state of a row of the acceptance sheet, by its number
    response, ///< k, tau or slope of a drift test: its first channel and temperature
    typeTest, ///< a number of a type
};

/// A value that the evaluation of a reference set must give.
struct Expectation {
    Expected what = Expected::parameter;
    std::string id;
    std::string of;                  ///< of a parameter; empty: its value
    std::string variant;             ///< of the documents of the set
    std::string edition;             ///< empty: that of the test
    std::size_t test = 0;            ///< index in the tests, trends, points or types of the set
    int target = 0;                  ///< counted from 1
    std::string axis;                ///< of an influence: its letter
    iso230_4::ContouringFeed feed{}; ///< inputs of the contouring feed
    CompensationFormat format = CompensationFormat::csv;
    CompensationOptions table{};
    double value = 0;      ///< mm, or the unit of the set
    std::string word = {}; ///< expected instead of a value: a verdict
    double tolerance = 0;  ///< the same, or relative to the value
    bool relative = false;
    ExpectationSource source = ExpectationSource::published;
};

/// Values over time and the limit that their line may reach.
struct ReferenceTrend {
    std::vector<TrendPoint> points;
    TrendLimits limits;
    double reserve = 0;
};

/// Values of the machines of a type.
struct ReferenceType {
    std::vector<double> values;
    Tolerance tolerance;
};

/// Words in the language of a reader, by its code; a file may state the same for all.
using Words = std::map<QString, QString>;

/// Measurements with known answers and their origin.
struct ReferenceSet {
    Words name;
    Words origin;
    Quantity quantity = Quantity::deviation; ///< of all expected values
    /// By variant: the same tests with other settings; "": as they are in the file.
    std::map<std::string, std::shared_ptr<const Document>> documents;
    std::vector<ReferenceTrend> trends;
    std::vector<Points> points;
    std::vector<ReferenceType> types;
    std::vector<Expectation> expected;
};

/// Reads a file of reference data (JSON; its tests as in a test file). Throws Error.
[[nodiscard]] ReferenceSet readReferenceSet(const QByteArray &bytes);

/// Returns the names of the reference files (.json) of a folder, sorted.
[[nodiscard]] QStringList referenceFilesIn(const QString &folder);

/// The embedded files: those that a report is preceded by, and all, with those of the second implementation,
/// which take some seconds.
[[nodiscard]] QStringList quickReferenceFiles();
[[nodiscard]] QStringList allReferenceFiles();

} // namespace palmer
