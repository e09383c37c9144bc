// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"
#include "kernel/evaluation/iso230_4/contouringfeed.h"

#include <QByteArray>
#include <QString>
#include <string>
#include <vector>

namespace palmer {

/// Source of the expected value: printed in the standard; recomputed elsewhere from the same data; exact by
/// construction; certified by an institute.
enum class ExpectationSource { published, recomputed, exact, certified };

/// Kind of expected value: a parameter of a test, a statistic of one of its targets, the correction C to 20
/// °C of a circular test, or a contouring feed for another diameter.
enum class Expected { parameter, statistic, correction, contouringFeed };

/// A value that the evaluation of a reference set must give.
struct Expectation {
    Expected what = Expected::parameter;
    std::string edition;             ///< edition of the evaluation
    std::size_t test = 0;            ///< index in the set
    std::string parameter;           ///< id
    int target = 0;                  ///< counted from 1
    std::string statistic;           ///< id of targetValue(): "mean+", "R", …
    iso230_4::ContouringFeed feed{}; ///< inputs of the contouring feed
    double value = 0;                ///< mm, or the unit of the set
    double tolerance = 0;            ///< the same, or relative to the value
    bool relative = false;
    ExpectationSource source = ExpectationSource::published;
};

/// A measurement with known answers and their origin.
struct ReferenceSet {
    QString name;
    QString origin;
    Quantity quantity = Quantity::deviation; ///< of all expected values
    std::shared_ptr<const Document> document;
    std::vector<Expectation> expected;
};

/// Reads a file of reference data (JSON; its tests as in a test file). Throws Error.
[[nodiscard]] ReferenceSet readReferenceSet(const QByteArray &bytes);

/// Returns the names of the embedded reference files in display order.
[[nodiscard]] std::vector<QString> embeddedReferenceFiles();

} // namespace palmer
