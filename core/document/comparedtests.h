// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "document/filewords.h"
#include "kernel/comparison/comparetests.h"
#include "kernel/diagnosis/diagnosis.h"

#include <memory>
#include <optional>

namespace palmer {

/// A test of an evaluated document.
struct PlacedTest {
    const EvaluatedDocument *evaluated = nullptr;
    std::size_t index = 0;

    [[nodiscard]] const Test &test() const { return *evaluated->document->tests[index]; }
    [[nodiscard]] const TestEvaluation &evaluation() const { return *evaluated->tests[index]; }
};

/// Everything else that the evaluation of a test depends on.
[[nodiscard]] Surroundings surroundingsOf(const Document &document, std::size_t test);

/// Compares two tests, of one document or of two.
[[nodiscard]] TestComparison compare(const PlacedTest &before, const PlacedTest &after,
                                     const ComparisonOptions &options = {});

/// True if a test was carried out before the other: by their roles (as found, as left), otherwise by their
/// dates.
[[nodiscard]] bool precedes(const Test &test, const Test &other);

/// The comparison that a test states (`comparedWith`): which test came first, how, and what comes out. The
/// other test is the one before, unless it is known to be the later one. Computed once for a document; may be
/// called from any thread.
struct StatedComparison {
    std::size_t other = 0; ///< the test that is named
    std::size_t before = 0;
    std::size_t after = 0;
    ComparisonOptions options;
    TestComparison comparison;
};
/// Null if the test states none.
[[nodiscard]] std::shared_ptr<const StatedComparison> statedComparison(const EvaluatedDocument &evaluated,
                                                                       std::size_t test);

/// A machine error that the diagnosis of both circles values, in base units. U: t(0.975; ν)·√(u_a² + u_b²), ν
/// by Welch and Satterthwaite.
struct ComparedSource {
    InfluenceId id = InfluenceId::centre;
    Message name;
    double before = 0;
    double after = 0;
    double uncertainty = 0;
};
[[nodiscard]] std::vector<ComparedSource> comparedSources(const PlacedTest &before, const PlacedTest &after);

/// The difference of the paths of one sense, each about its own least squares centre; after − before, mm,
/// over whole degrees. Angles where one of them has no points within a few degrees are left out.
struct ComparedPath {
    Sense sense = Sense::counterclockwise;
    std::vector<std::pair<double, double>> points;
};
[[nodiscard]] std::vector<ComparedPath> comparedPaths(const PlacedTest &before, const PlacedTest &after);

/// Returns the id of a compared parameter, that of its result: "A", "G_XY".
[[nodiscard]] std::string comparedId(const ComparedParameter &parameter);

/// Returns the first judged test of `others` that is comparable with this one: same kind, axis or plane,
/// directions and radius. Null: none.
[[nodiscard]] std::optional<std::size_t> counterpart(const PlacedTest &test, const EvaluatedDocument &others);

// Words of a comparison, in files for scripts.

template <>
inline constexpr auto fileWords<NotComparable> = wordsInOrder<NotComparable>("otherKind", "otherAxis",
                                                                             "otherDirections", "otherRadius",
                                                                             "noEdition", "sharedInstrument");
template <>
inline constexpr auto fileWords<NoWord> = wordsInOrder<NoWord>("fewTargets", "oneRun", "noRepeatability",
                                                               "noUncertainty");
template <>
inline constexpr auto fileWords<ChangeWord> = wordsInOrder<ChangeWord>("noChangeProven", "changed", "better",
                                                                       "worse", "unchangedWithin",
                                                                       "changedByMore", "notProven", "agree",
                                                                       "disagree");
template <>
inline constexpr auto
    fileWords<SharedError> = wordsInOrder<SharedError>("device", "machineTemperature", "machineExpansion",
                                                       "instrumentTemperature", "instrumentExpansion",
                                                       "misalignment");

} // namespace palmer
