// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/arcs.h"

#include "document/place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

// Columns of a table of circles that are not read.

namespace palmer {

namespace {

struct Extent {
    double low = INFINITY;
    double high = -INFINITY;

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] double size() const { return high - low; }
};

/// True if a column that is not read says the same as the one that is, up to rounding.
bool agree(const TableReading &reading, std::size_t read, std::size_t other, const RadialOf &radial) {
    constexpr double part = 0.25; // of the larger range
    const Unit *unit = reading.body.columns[other].unit;
    for (const double factor : unit ? std::vector{unit->toBase(1)} : std::vector{1.0, 0.001}) {
        Extent ofRead;
        Extent ofOther;
        Extent ofDifference;
        for (const TableBlock &block : reading.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const auto a = radial(row, read);
                const auto b = reading.numberAt(row, other);
                if (!a || !b)
                    continue;
                ofRead.add(*a);
                ofOther.add(factor * *b);
                ofDifference.add(*a - factor * *b);
            }
        }
        if (ofDifference.size() <= part * std::max(ofRead.size(), ofOther.size()))
            return true;
    }
    return false;
}

/// True if a column is the difference of two others, or their mean, up to rounding.
bool isComputedFrom(const TableReading &reading, std::size_t column, std::size_t first, std::size_t second) {
    constexpr double rounding = 0.02; // of the range
    std::array<Extent, 3> errors;     // of a − b, b − a, the mean
    Extent range;
    for (const TableBlock &block : reading.body.blocks) {
        for (const std::uint32_t row : block.rows) {
            const auto a = reading.numberAt(row, first);
            const auto b = reading.numberAt(row, second);
            const auto c = reading.numberAt(row, column);
            if (!a || !b || !c)
                continue;
            range.add(*a);
            range.add(*b);
            errors[0].add(*c - (*a - *b));
            errors[1].add(*c - (*b - *a));
            errors[2].add(*c - (*a + *b) / 2);
        }
    }
    return std::ranges::any_of(errors, [&](const Extent &error) {
        return std::max(std::abs(error.low), std::abs(error.high)) <= rounding * range.size();
    });
}

} // namespace

void askForUnread(TableReading &reading, const CircleColumns &columns, const RadialOf &radial) {
    const std::vector<TableColumn> &heads = reading.body.columns;
    const auto isIgnored = [&](std::size_t c) {
        return reading.result.columns[c].role == ColumnRole::ignored;
    };
    std::set<std::size_t> compared(columns.conditions.begin(), columns.conditions.end());
    for (std::size_t c = 0; c < heads.size() && columns.seconds.size() == 2; ++c) {
        if (heads[c].isNumeric() && isIgnored(c) &&
            isComputedFrom(reading, c, columns.seconds.front(), columns.seconds.back()))
            compared.insert(c);
    }
    for (const Meaning meaning : {Meaning::radius, Meaning::deviation}) {
        std::vector<std::size_t> unread = reading.body.numberColumns(meaning);
        std::erase_if(unread, [&](std::size_t c) { return !isIgnored(c) || compared.contains(c); });
        for (std::size_t k = 0; k < unread.size() && unread.size() == columns.seconds.size(); ++k) {
            compared.insert(unread[k]);
            if (!agree(reading, columns.seconds[k], unread[k], radial))
                reading.remarks.problem(
                    "columns",
                    REPORT_TEXT("report", "Columns: “%1” says something else than “%2”, which is read."),
                    excerpt(heads[unread[k]].heading), excerpt(heads[columns.seconds[k]].heading));
        }
    }
    // "X scale" beside "X encoder".
    const auto isOfReadAxis = [&](std::size_t c) {
        return columns.layout == "xy" && isPosition(heads[c]) && heads[c].meaning != Meaning::target &&
               (heads[c].words.axis == heads[*columns.first].words.axis ||
                heads[c].words.axis == heads[columns.seconds.front()].words.axis);
    };
    const auto isCondition = [&](std::size_t c) {
        return std::ranges::find(columns.conditions, c) != columns.conditions.end();
    };
    reading.askForMarks([&](std::size_t c) { return !isIgnored(c); });
    reading.remarkUnread(
        [&](std::size_t c) { return !isIgnored(c) || heads[c].meaning == Meaning::index || isCondition(c); },
        [&](std::size_t c) {
            return heads[c].isNumeric() && !compared.contains(c) &&
                   (isOfReadAxis(c) || senseIn(heads[c].heading) ||
                    isOneOf(heads[c].meaning, {Meaning::radius, Meaning::deviation, Meaning::reading,
                                               Meaning::actual, Meaning::run}));
        });
}

} // namespace palmer
