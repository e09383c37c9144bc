#pragma once

#include "document/document.h"
#include "kernel/evaluation/testevaluation.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palmer {

using TestEvaluationPointer = std::shared_ptr<const TestEvaluation>;

/// A document together with its evaluation: a result can never be shown beside data it was not computed from.
/// Immutable once made; copies are cheap.
struct EvaluatedDocument {
    std::shared_ptr<const Document> document;
    std::vector<TestEvaluationPointer> tests; ///< one a test of the document

    /// The worst verdict of the tests; null where none has a limit.
    [[nodiscard]] std::optional<Verdict> verdict() const;
};

/// Evaluates all tests; those that are the same as in `previous` keep their evaluation.
/// `edition`: the word of another edition for all tests of its kind (a view, no verdicts); empty: each its
/// own.
[[nodiscard]] EvaluatedDocument evaluate(std::shared_ptr<const Document> document,
                                         const EvaluatedDocument *previous = nullptr,
                                         std::string_view edition = {});

/// The same, each test under the edition of its own word in `editions`; empty or none: the test's. A
/// `previous` without document counts as none.
[[nodiscard]] EvaluatedDocument evaluateUnder(std::shared_ptr<const Document> document,
                                              std::span<const std::string> editions,
                                              const EvaluatedDocument *previous = nullptr);

} // namespace palmer
