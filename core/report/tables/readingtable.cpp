// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/readingtable.h"

#include "report/words/wording.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace palmer {

namespace {

/// Additional decimals of µm in mm, and of arc seconds in degrees.
constexpr int digitsOfMicrometre = 3;
constexpr int digitsOfSecond = 4;

/// True if the test has the quantity and the table shows it: for both directions R without R↑ and R↓; x̄ is
/// shown in the card of the target.
bool has(const TargetTerm &term, const PositioningResults &results) {
    const bool both = results.upward && results.downward;
    return isShown(term, results) && !(both && term.weight == Weight::detail);
}

} // namespace

std::vector<ReadingColumn> readingColumns(const PositioningMeasurement &measurement,
                                          ReadingGrouping grouping) {
    std::vector<ReadingColumn> columns;
    int ups = 0;
    int downs = 0;
    for (std::size_t j = 0; j < measurement.runs.size(); ++j) {
        const Direction approach = measurement.runs[j].approach;
        columns.push_back({j, approach == Direction::positive ? ++ups : ++downs, approach});
    }
    const auto group = [grouping](const ReadingColumn &column) {
        return grouping == ReadingGrouping::byRun ? column.number : static_cast<int>(column.approach);
    };
    std::ranges::stable_sort(columns, [&](const ReadingColumn &a, const ReadingColumn &b) {
        const auto key = [&](const ReadingColumn &column) {
            return std::tuple(group(column), static_cast<int>(column.approach), column.number);
        };
        return key(a) < key(b);
    });
    for (std::size_t k = 0; k < columns.size(); ++k)
        columns[k].endsGroup = k + 1 == columns.size() || group(columns[k + 1]) != group(columns[k]);
    return columns;
}

std::vector<StatisticColumn> statisticColumns(const TestEvaluation &evaluation, const Language &language) {
    std::vector<StatisticColumn> columns;
    if (!evaluation.edition)
        return columns;
    for (const TargetTerm &term : evaluation.edition->targetTerms) { // for axes; circles have no targets
        if (has(term, std::get<PositioningResults>(evaluation.results)))
            columns.push_back({term.id, symbolFormula(Symbol{term.symbol.base, "", term.symbol.arrow}),
                               language.text(term.name)});
    }
    return columns;
}

ReadingTexts::ReadingTexts(const PositioningMeasurement &measurement, Language language, ReadingUnit unit)
    : m_measurement(&measurement)
    , m_language(std::move(language))
    , m_unit(unit)
    , m_aside(measurement)
    , m_positionDecimals(positionDecimals(measurement))
    , m_readingDecimals(readingDecimals(measurement))
    , m_statisticDecimals(statisticDecimals(measurement)) {}

QString ReadingTexts::position(std::size_t target) const {
    return m_language.number(m_measurement->targets[target], positionQuantity(m_measurement->axis),
                             m_positionDecimals);
}

QString ReadingTexts::shown(double deviation, std::size_t target) const {
    if (m_unit == ReadingUnit::deviations)
        return m_language.number(deviation, deviationQuantity(m_measurement->axis), m_readingDecimals);
    const bool linear = m_measurement->axis.motion == Motion::linear;
    return m_language.number(m_measurement->targets[target] + deviation,
                             positionQuantity(m_measurement->axis),
                             m_readingDecimals + (linear ? digitsOfMicrometre : digitsOfSecond));
}

ShownReading ReadingTexts::reading(std::size_t run, std::size_t target) const {
    const auto &deviations = m_measurement->runs[run].deviations;
    if (target < deviations.size() && deviations[target])
        return {shown(*deviations[target], target), false, false, {}};
    if (const ExcludedReading *aside = m_aside.at(run, target))
        return {shown(aside->value, target), false, true, QString::fromStdString(aside->reason)};
    return {QStringLiteral("–"), true, false, {}};
}

QString ReadingTexts::statistic(std::optional<double> value) const {
    return m_language.number(value.value_or(std::numeric_limits<double>::quiet_NaN()),
                             deviationQuantity(m_measurement->axis), m_statisticDecimals);
}

QString ReadingTexts::arrowAndNumber(std::size_t run) const {
    const Direction approach = m_measurement->runs[run].approach;
    const auto number = std::count_if(m_measurement->runs.begin(),
                                      m_measurement->runs.begin() + static_cast<std::ptrdiff_t>(run) + 1,
                                      [approach](const Run &r) { return r.approach == approach; });
    return (approach == Direction::positive ? QStringLiteral("↑ ") : QStringLiteral("↓ ")) +
           QString::number(number);
}

QString ReadingTexts::label(std::size_t run, std::size_t target) const {
    const ShownReading here = reading(run, target);
    const QString value = here.missing ? here.text : here.text + u'\u00A0' + readingUnit();
    return QStringLiteral("i = %1 · %2 · %3").arg(QString::number(target + 1), arrowAndNumber(run), value);
}

QString ReadingTexts::positionUnit() const {
    return m_language.unit(positionQuantity(m_measurement->axis));
}
QString ReadingTexts::deviationUnit() const {
    return m_language.unit(deviationQuantity(m_measurement->axis));
}
QString ReadingTexts::readingUnit() const {
    return m_unit == ReadingUnit::deviations ? deviationUnit() : positionUnit();
}

QString ReadingTexts::summary(std::span<const std::pair<std::size_t, std::size_t>> places) const {
    double sum = 0;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    int count = 0;
    for (const auto &[run, target] : places) {
        const auto &deviations = m_measurement->runs[run].deviations;
        if (target >= deviations.size() || !deviations[target])
            continue;
        ++count;
        sum += *deviations[target];
        least = std::min(least, *deviations[target]);
        most = std::max(most, *deviations[target]);
    }
    if (count == 0)
        return {};
    const Quantity quantity = deviationQuantity(m_measurement->axis);
    if (count == 1)
        return places.size() == 1 ? label(places[0].first, places[0].second)
                                  : m_language.quantity(sum, quantity, m_readingDecimals);
    return m_language.sentence(REPORT_TEXT("report", "%1 readings: mean %2, range %3"),
                               {wholeNumber(count), Number{sum / count, quantity, m_statisticDecimals},
                                Number{most - least, quantity, m_readingDecimals}});
}

} // namespace palmer
