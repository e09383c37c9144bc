// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/iso230_4/results.h"

#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/paths.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer::iso230_4 {

namespace {

constexpr std::array senses{Sense::counterclockwise, Sense::clockwise};

/// Returns the indices of the arcs of a sense in chronological order.
std::vector<std::size_t> arcsOf(const CircularMeasurement &measurement, Sense sense) {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < measurement.arcs.size(); ++k) {
        if (measurement.arcs[k].sense == sense)
            result.push_back(k);
    }
    return result;
}

/// Returns the leading rows of one quantity: Fmax and Fmin of a path are adjacent.
std::span<const CircularRow> rowsOfAQuantity(std::span<const CircularRow> rows) {
    const Term &first = rows.front().term;
    std::size_t count = 1;
    while (count < rows.size() && rows[count].term.circle == first.circle && rows[count].term.of == first.of)
        ++count;
    return rows.first(count);
}

std::optional<double> standardDeviation(const std::vector<double> &values) {
    if (values.size() < 2)
        return std::nullopt;
    const auto n = static_cast<double>(values.size());
    double sum = 0;
    for (const double value : values)
        sum += value;
    double squares = 0;
    for (const double value : values)
        squares += (value - sum / n) * (value - sum / n);
    return std::sqrt(squares / (n - 1));
}

/// One repetition: a path of each sense.
struct Repetition {
    CircularMeasurement measurement;
    std::array<bool, 2> own{}; ///< false: the first path of that sense again
};

Repetition repetition(const CircularMeasurement &whole, const std::array<std::vector<std::size_t>, 2> &arcs,
                      std::size_t time) {
    Repetition result{whole, {}};
    result.measurement.arcs.clear();
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < senses.size(); ++k) {
        result.own[k] = time < arcs[k].size();
        if (!arcs[k].empty())
            chosen.push_back(arcs[k][result.own[k] ? time : 0]);
    }
    if (chosen.size() == 2 && arcs[0].front() > arcs[1].front())
        std::swap(chosen[0], chosen[1]); // the path measured first gives the index
    for (const std::size_t k : chosen)
        result.measurement.arcs.push_back(whole.arcs[k]);
    return result;
}

/// Returns C = R·[α_i·(T_i − 20) − α_m·(T_m − 20)] in mm, added to F and D; R nominal radius in mm, i
/// instrument, m machine (evaluation/correctionto20.h). Null unless the conditions say "applied here" and all
/// inputs are stated.
std::optional<double> correctionTo20(const CircularMeasurement &measurement) {
    const Conditions &conditions = measurement.conditions.common;
    if (conditions.correctionTo20 != CorrectionTo20::appliedHere ||
        measurement.source == SignalSource::feedback) // which has neither F nor D
        return std::nullopt;
    const auto expansion = differentialExpansion(conditions);
    if (!expansion)
        return std::nullopt;
    return -measurement.nominalRadius * *expansion;
}

} // namespace

CircularResults circularResults(const CircularMeasurement &measurement) {
    CircularResults results;
    Paths paths = iso230_4::paths(measurement);
    results.paths = std::move(paths.evaluated);
    results.repetitions = std::move(paths.repetitions);
    results.centringError = paths.centringError;
    results.circles = circles(results.paths);
    results.correction = correctionTo20(measurement);
    results.at20 = lengthsAt20(measurement.conditions.common, measurement.nominalRadius);
    return results;
}

std::vector<ListedParameter> listedParameters(const CircularCase &test) {
    std::vector<ListedParameter> result;
    for (auto rows = test.edition.circles->rows; !rows.empty();) {
        const auto quantity = rowsOfAQuantity(rows);
        rows = rows.subspan(quantity.size());
        if (quantity.front().external == test.feedback())
            continue;
        if (quantity.front().term.of == Of::path) {
            for (const EvaluatedPath &path : test.results.paths) {
                for (const CircularRow &row : quantity)
                    result.push_back({&row, &path, path.index});
            }
        } else if (test.results.paths.size() == 2) {
            result.push_back({&quantity.front(), nullptr, test.results.paths.front().index});
        }
    }
    return result;
}

std::optional<double> value(const ListedParameter &parameter, const CircularCase &test) {
    const auto found = parameter.row->value(test, parameter.path);
    return found && std::isfinite(*found) ? found : std::nullopt;
}

std::vector<std::optional<double>> repeatabilities(const CircularCase &test) {
    const CircularMeasurement &whole = test.measurement;
    const std::array arcs{arcsOf(whole, senses[0]), arcsOf(whole, senses[1])};
    const std::size_t times = std::max(arcs[0].size(), arcs[1].size());
    std::vector<std::vector<double>> values(listedParameters(test).size());
    for (std::size_t time = 0; time < times && times > 1; ++time) {
        const auto [once, own] = repetition(whole, arcs, time);
        const CircularResults results = circularResults(once);
        const CircularCase repeated{test.test, once, test.surroundings, test.edition, results};
        const auto parameters = listedParameters(repeated);
        for (std::size_t k = 0; k < parameters.size() && k < values.size(); ++k) {
            const EvaluatedPath *path = parameters[k].path;
            if (path && !own[path->sense == senses[0] ? 0 : 1])
                continue; // the same path again
            if (const auto found = value(parameters[k], repeated))
                values[k].push_back(*found);
        }
    }
    std::vector<std::optional<double>> result;
    result.reserve(values.size());
    for (const auto &list : values)
        result.push_back(standardDeviation(list));
    return result;
}

} // namespace palmer::iso230_4
