#pragma once

#include "kernel/evaluation/finding.h"
#include "kernel/evaluation/parameter.h"
#include "kernel/evaluation/statistics.h"

#include <optional>
#include <span>
#include <string_view>

namespace palmer {

/// The value of a parameter: NaN where a statistic it needs is missing.
struct Outcome {
    double value = 0;
    std::array<std::optional<Ruling>, 2> ruling;
};

/// What a parameter needs of the test to be listed: bits, joined with |.
enum Need : unsigned { upward = 1, downward = 2, bothWays = 3, scatter = 4 };

/// One parameter of an edition of ISO 230-2: what it is called, what it needs, how it is computed from the
/// statistics per target and the factor c.
struct Row {
    Term term;
    unsigned needs;
    Outcome (*value)(std::span<const TargetStatistics>, double c);
    bool dependsOnTemperature = false; ///< wrong away from 20 °C unless corrected
};

/// A quantity per target: what the heads of tables and the help call it.
struct TargetTerm {
    const char *id; ///< "mean+", "mean", "reversal", "s", "R+", "R", …
    Symbol symbol;
    Text name = {};
    const char *clause = "";
};

/// A point to be agreed between supplier/manufacturer and user.
struct AgreementPoint {
    const char *point;  ///< word of the file format
    const char *letter; ///< as the standard letters it; empty where no letters are printed
    Text name = {};
};

enum class Kind { positioning, circular, drift };

struct PositioningCase; // a test and all that is known of it: positioningcase.h
struct CircularCase;    // likewise: iso230_4/circularcase.h

/// One thing an edition asks of a test. `unmet`: the sentence of the finding, or null when it is met.
template <class Case>
struct RequirementOf {
    const char *id; ///< of a missing statement: the key in the file
    const char *clause;
    Grade grade;
    std::optional<Message> (*unmet)(const Case &);
};
using Requirement = RequirementOf<PositioningCase>;

/// Something the report has to state.
template <class Case>
struct StatementOf {
    const char *id; ///< the key in the file
    Text name = {};
    bool (*stated)(const Case &); ///< or does not apply to this test
};
using Statement = StatementOf<PositioningCase>;

/// What an edition of ISO 230-4 computes and asks for; see iso230_4/circularrules.h.
struct CircularRules;

/// The kind of test and what is asked of it; the first of an edition that applies is taken.
struct Scheme {
    bool (*applies)(const PositioningCase &);
    std::span<const Requirement> requirements;
};

/// One edition of a standard. Aliases share everything with their family but word and title.
struct Edition {
    const char *word;   ///< what the file says: "ISO 230-2:2006"
    const char *family; ///< word of the edition whose rules these are; verdicts hold within it
    Kind kind = Kind::positioning;
    Text title = {};          ///< the standard's own title; empty where the designation stands alone
    double c = 0;             ///< factor of s (ISO 230-2)
    bool rangeMethod = false; ///< s by the range method allowed
    Text standardCycle = {};  ///< what the measuring cycles are called (ISO 230-2)
    Text stepCycle = {};
    std::span<const Row> rows = {};
    std::span<const TargetTerm> targetTerms = {};
    std::span<const Scheme> schemes = {};
    std::span<const Requirement> requirements = {}; ///< asked of every test
    std::span<const Statement> statements = {};
    const char *statementsClause = "";
    std::span<const AgreementPoint> points = {};
    const char *pointsClause = "";
    const CircularRules *circles = nullptr; ///< of ISO 230-4; null for ISO 230-2
};

/// All editions in the order they are offered in.
[[nodiscard]] std::span<const Edition *const> editions();

/// The edition of that word, or null.
[[nodiscard]] const Edition *findEdition(std::string_view word);

/// Whether any edition of the kind has a parameter of this id (without axis index): a key of `limits`.
[[nodiscard]] bool isParameter(Kind kind, std::string_view id);

/// Whether any edition of the kind has this point to agree.
[[nodiscard]] bool isAgreementPoint(Kind kind, std::string_view point);

} // namespace palmer
