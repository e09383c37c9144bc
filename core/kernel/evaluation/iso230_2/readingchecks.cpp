// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/agreedpoints.h"
#include "kernel/evaluation/iso230_2/checks.h"
#include "kernel/evaluation/iso230_2/parameters.h"
#include "kernel/evaluation/iso230_2/sentences.h"
#include "kernel/words/characters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace palmer::iso230_2 {

namespace {

constexpr int approachesOfTest = 5; ///< per direction

/// Returns the places without a reading; `withSetAside`: including those set aside.
NameList gaps(const PositioningCase &test, bool withSetAside) {
    const PositioningMeasurement &m = test.measurement;
    NameList result;
    std::set<std::pair<int, int>> setAside;
    if (!withSetAside) {
        for (const ExcludedReading &reading : m.excluded)
            setAside.emplace(reading.run, reading.target);
    }
    for (std::size_t run = 0; run < m.runs.size(); ++run) {
        const auto &deviations = m.runs[run].deviations;
        if (std::ranges::all_of(deviations, [](const auto &x) { return x.has_value(); }))
            continue;
        for (std::size_t target = 0; target < deviations.size(); ++target) {
            const std::pair place(static_cast<int>(run) + 1, static_cast<int>(target) + 1);
            if (!deviations[target] && !setAside.contains(place))
                result.add(readingName(test.edition, m, run, target));
        }
    }
    return result;
}

/// True if a target has fewer readings left than a full test requires although there were enough runs.
bool tooFewLeft(const PositioningCase &test) {
    if (std::min(test.positiveRuns, test.negativeRuns) < approachesOfTest)
        return false;
    const auto few = [&](const TargetStatistics &target) {
        return target.positive.n < approachesOfTest || target.negative.n < approachesOfTest;
    };
    return std::ranges::any_of(test.statistics, few);
}

int eachWay(const PositioningCase &test) {
    return std::min(test.positiveRuns, test.negativeRuns);
}

std::vector<Argument> approaches(const PositioningCase &test) {
    return {count(static_cast<std::size_t>(test.positiveRuns)),
            count(static_cast<std::size_t>(test.negativeRuns))};
}

Message gapMessage(const NameList &list) {
    return {REPORT_TEXT_COUNTED("report",
                                "No reading at %1 (%n in all): the statistics use the readings that exist."),
            {list.text()},
            list.count()};
}

} // namespace

Sentence fiveApproaches(const PositioningCase &test) {
    if (eachWay(test) >= approachesOfTest)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report", "Approaches in the positive direction: %1, in the negative: %2; 5 each way are "
                              "required."),
        approaches(test)};
}

Sentence moreThanFive(const PositioningCase &test) {
    if (std::max(test.positiveRuns, test.negativeRuns) <= approachesOfTest)
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "Approaches in the positive direction: %1, in the negative: %2; the text "
                               "speaks of five."),
                   approaches(test)};
}

Sentence oneApproach(const PositioningCase &test) {
    if (eachWay(test) >= 1)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "Approaches in the positive direction: %1, in the negative: %2; at least 1 each way is "
                    "required."),
        approaches(test)};
}

Sentence fewReadings(const PositioningCase &test) {
    const NameList list = gaps(test, true);
    if (list.empty() || !tooFewLeft(test))
        return std::nullopt;
    return gapMessage(list);
}

Sentence missingReadings(const PositioningCase &test) {
    const NameList list = gaps(test, false);
    if (list.empty() || tooFewLeft(test))
        return std::nullopt;
    return gapMessage(list);
}

Sentence refusedReadings(const PositioningCase &test) {
    const PositioningMeasurement &m = test.measurement;
    NameList list;
    for (const RefusedReading &reading : m.refused) {
        const auto run = static_cast<std::size_t>(reading.run - 1);
        if (run < m.runs.size())
            list.add(readingName(test.edition, m, run, static_cast<std::size_t>(reading.target - 1)) + " [" +
                     reading.text + "]");
    }
    if (list.empty())
        return std::nullopt;
    return Message{REPORT_TEXT_COUNTED("report", "Readings that are no numbers (%n), hence missing: %1."),
                   {list.text()},
                   list.count()};
}

Sentence unequalRuns(const PositioningCase &test) {
    if (test.positiveRuns == test.negativeRuns || eachWay(test) == 0)
        return std::nullopt;
    return Message{
        REPORT_TEXT("report",
                    "Runs in the positive direction: %1, in the negative: %2; each direction is evaluated "
                    "with its own."),
        approaches(test)};
}

Sentence excludedReadings(const PositioningCase &test) {
    const PositioningMeasurement &m = test.measurement;
    if (m.excluded.empty())
        return std::nullopt;
    NameList list;
    for (const ExcludedReading &reading : m.excluded) {
        const auto run = static_cast<std::size_t>(reading.run - 1);
        if (run < m.runs.size())
            list.add(readingName(test.edition, m, run, static_cast<std::size_t>(reading.target - 1)));
    }
    return Message{
        test.edition.textRead == TextRead::all
            ? REPORT_TEXT_COUNTED("report", "Readings set aside (%n): %1. The text provides for none.")
            : REPORT_TEXT_COUNTED("report", "Readings set aside (%n): %1."),
        {list.text()},
        list.count()};
}

Sentence excludedWithoutReason(const PositioningCase &test) {
    const auto without =
        std::ranges::count_if(test.measurement.excluded, [](const auto &e) { return isBlank(e.reason); });
    if (without == 0)
        return std::nullopt;
    return Message{REPORT_TEXT_COUNTED("report", "Readings set aside without a reason: %n."),
                   {},
                   static_cast<int>(without)};
}

Sentence rangeMethodElsewhere(const PositioningCase &test) {
    return sentenceIf(
        test.measurement.standardDeviation == DeviationMethod::range && !test.edition.rangeMethod,
        REPORT_TEXT("report",
                    "The range method for s belongs to ISO 230-2:1988 only: s is calculated here."));
}

Sentence rangeMethodRuns(const PositioningCase &test) {
    if (test.measurement.standardDeviation != DeviationMethod::range || !test.edition.rangeMethod)
        return std::nullopt;
    const auto outside = [](const DirectionStatistics &d) { return d.n > 0 && !rangeFactor(d.n); };
    for (std::size_t i = 0; i < test.statistics.size(); ++i) {
        const TargetStatistics &target = test.statistics[i];
        for (const Direction direction : {Direction::positive, Direction::negative}) {
            const auto &d = direction == Direction::positive ? target.positive : target.negative;
            if (outside(d))
                return Message{
                    REPORT_TEXT("report",
                                "The range method is defined for 2 to 10 readings; target %1 has %2."),
                    {std::to_string(i + 1) + arrow(direction), count(static_cast<std::size_t>(d.n))}};
        }
    }
    return std::nullopt;
}

Sentence drift(const PositioningCase &test) {
    if (!test.drift || !test.drift->significant())
        return std::nullopt;
    // VDI/DGQ 3441 has no R.
    constexpr std::array scatters{&repeatabilityOfAxis, &repeatabilityUp, &repeatabilityDown, &vdiScatter};
    const auto valueOf = [&](const Row &row) { return (*row.value)(test.statistics, test.edition.c).value; };
    const auto beside = std::ranges::find_if(test.edition.rows, [&](const Row &row) {
        return std::ranges::find(scatters, row.value) != scatters.end() && !std::isnan(valueOf(row));
    });
    const Number change = deviation(test, test.drift->change, 2);
    // Runs that differ only by the progression leave no scatter but rounding errors.
    constexpr double largest = 1e6;
    const double ratio = std::abs(test.drift->t);
    const Argument t =
        ratio < largest ? Argument(Number{ratio, Quantity::number, 1}) : Argument(std::string("∞"));
    const Number critical{test.drift->critical, Quantity::number, 2};
    if (beside == test.edition.rows.end())
        return Message{
            REPORT_TEXT("report",
                        "The deviations at the same target progress steadily from approach to approach: "
                        "D = %1 from the first to the last (t = %2, above %3). The thermal "
                        "conditions may be unstable."),
            {change, t, critical}};
    return Message{
        REPORT_TEXT("report",
                    "The deviations at the same target progress steadily from approach to approach: "
                    "D = %1 from the first to the last, beside %4 = %5 (t = %2, above %3). The "
                    "thermal conditions may be unstable."),
        {change, t, critical, std::string(beside->term.symbol.base) + beside->term.symbol.subscript,
         deviation(test, valueOf(*beside), 2)}};
}

bool stepCycleInWriting(const PositioningCase &test) {
    const AgreedPoint *point = agreedPoint(test.test, "stepCycle");
    return point && point->state == AgreementState::agreed && !isBlank(point->text);
}

Judgement cycleStated(const PositioningCase &test) {
    if (!test.measurement.cycle)
        return Judgement::undeclared();
    if (test.measurement.cycle == Cycle::step)
        return Judgement::met(); // its runs have no order of their own
    // Unequal numbers of runs cannot all alternate.
    const auto &runs = test.measurement.runs;
    const int allowed = std::max(std::abs(test.positiveRuns - test.negativeRuns) - 1, 0);
    const auto same = [](const Run &a, const Run &b) { return a.approach == b.approach; };
    const auto first = std::ranges::adjacent_find(runs, same);
    int found = 0;
    for (std::size_t j = 1; j < runs.size(); ++j)
        found += same(runs[j - 1], runs[j]) ? 1 : 0;
    if (eachWay(test) == 0 || found <= allowed)
        return Judgement::met();
    const auto run = static_cast<std::size_t>(first - runs.begin()) + 1;
    return Judgement::unmet(
        {REPORT_TEXT("report", "Runs %1 and %2 were made in the same direction, one after the other: the "
                               "stated cycle alternates."),
         {count(run), count(run + 1)}});
}

Judgement cycleOf2006(const PositioningCase &test) {
    if (test.measurement.cycle != Cycle::step || stepCycleInWriting(test))
        return cycleStated(test);
    if (test.test.purpose == Purpose::acceptance)
        return Judgement::unmet({REPORT_TEXT("report", "Step cycle without written agreement; strict "
                                                       "reference for acceptance is the standard cycle.")});
    return Judgement::unmet({REPORT_TEXT("report", "Step cycle without written agreement.")});
}

Sentence stepCycleAgreed(const PositioningCase &test) {
    if (test.measurement.cycle != Cycle::step || !stepCycleInWriting(test))
        return std::nullopt;
    return Message{REPORT_TEXT("report", "Step cycle by written agreement: %1."),
                   {agreedPoint(test.test, "stepCycle")->text}};
}

Sentence workedExample(const PositioningCase &test) {
    // Readings of targets 6↓ and 7↑, missing in the readable copy: no real test has exactly these.
    constexpr std::array sixDown{-0.0061, -0.0057, -0.0045, -0.0036, -0.0031};
    constexpr std::array sevenUp{-0.0065, -0.0056, -0.0048, -0.0039, -0.0035};
    const PositioningMeasurement &m = test.measurement;
    if (m.targets.size() != 11 || m.runs.size() != 10)
        return std::nullopt;
    std::size_t up = 0;
    std::size_t down = 0;
    for (const Run &run : m.runs) {
        const bool positive = run.approach == Direction::positive;
        const std::size_t j = positive ? up++ : down++;
        if (j >= 5 || run.deviations.size() != 11)
            return std::nullopt;
        const auto reading = run.deviations[positive ? 6 : 5];
        if (!reading || std::abs(*reading - (positive ? sevenUp : sixDown)[j]) > 1e-9)
            return std::nullopt;
    }
    const auto published = [&](double micrometres, int decimals) {
        return deviation(test, micrometres / 1000, decimals);
    };
    return Message{REPORT_TEXT("report",
                               "Worked example of ISO 230-2:1988 (table 2): the position of the first "
                               "target and ten readings are substitutes with the published mean and "
                               "s. Compare the mean reversal value (published: %1), R↑ (%2), R↓ "
                               "(%3), R (%4), A (%5) and the values per target, never the single "
                               "readings."),
                   {published(-1.53, 2), published(11.84, 2), published(9.9, 1), published(13.49, 2),
                    published(18.03, 2)}};
}

} // namespace palmer::iso230_2
