#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <QByteArray>
#include <QString>
#include <string>
#include <vector>

namespace palmer {

/// Where the expected value comes from: printed in the standard; recomputed elsewhere from the same data;
/// exact by construction; certified by an institute.
enum class ExpectationSource { published, recomputed, exact, certified };

/// A value that the evaluation of a reference set has to give.
struct Expectation {
    std::string edition;   ///< the one to evaluate under
    std::string parameter; ///< id; empty where a statistic of a target is expected
    int target = 0;        ///< counted from 1
    std::string statistic; ///< id of targetValue(): "mean+", "R", …
    double value = 0;      ///< mm, or the unit of the set
    double tolerance = 0;  ///< the same, or relative to the value
    bool relative = false;
    ExpectationSource source = ExpectationSource::published;
};

/// A measurement with known answers and their origin.
struct ReferenceSet {
    QString name;
    QString origin;
    Quantity quantity = Quantity::deviation;  ///< `number`: a set without unit
    std::shared_ptr<const Document> document; ///< with one test
    std::vector<Expectation> expected;
};

/// Reads a file of reference data (JSON; the test in it as in a test file). Throws Error.
[[nodiscard]] ReferenceSet readReferenceSet(const QByteArray &bytes);

/// Names of the embedded reference files, in the order they are shown in.
[[nodiscard]] std::vector<QString> embeddedReferenceFiles();

} // namespace palmer
