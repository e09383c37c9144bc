// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/directioncodes.h"

#include <optional>

namespace palmer {

namespace {

/// The passes of a code by the order of their targets.
struct Order {
    std::size_t up = 0;
    std::size_t down = 0;
    std::size_t unclear = 0;

    [[nodiscard]] std::optional<Direction> direction() const {
        if (unclear > 0 || (up > 0) == (down > 0))
            return {};
        return up > 0 ? Direction::positive : Direction::negative;
    }
    [[nodiscard]] bool isKnown() const { return direction().has_value(); }
    [[nodiscard]] bool isEmpty() const { return up + down + unclear == 0; }
};

/// Consecutive lines of one code and run are a pass; without run numbers perhaps several, between which the
/// axis returns by one large step.
std::map<double, Order> ordersOf(const std::vector<CodedTarget> &lines) {
    std::map<double, Order> orders;
    std::size_t rises = 0;
    std::size_t falls = 0;
    const auto finish = [&](double code) {
        Order &order = orders[code];
        if (rises > 2 * falls)
            ++order.up;
        else if (falls > 2 * rises)
            ++order.down;
        else if (rises + falls > 0)
            ++order.unclear;
        rises = falls = 0;
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (i > 0 && (lines[i].code != lines[i - 1].code || lines[i].run != lines[i - 1].run)) {
            finish(lines[i - 1].code);
        } else if (i > 0) {
            rises += lines[i].target > lines[i - 1].target ? 1 : 0;
            falls += lines[i].target < lines[i - 1].target ? 1 : 0;
        }
    }
    if (!lines.empty())
        finish(lines.back().code);
    return orders;
}

/// True if the targets rise under one code and fall under the other, which may have none that say.
bool areOpposite(const Order &low, const Order &high) {
    const bool isEither = low.isKnown() || high.isKnown();
    return isEither && (low.isKnown() || low.isEmpty()) && (high.isKnown() || high.isEmpty()) &&
           low.direction() != high.direction();
}

} // namespace

DirectionCodes directionCodes(const std::vector<CodedTarget> &lines) {
    const std::map<double, Order> orders = ordersOf(lines);
    DirectionCodes result;
    if (orders.empty())
        return result;
    const bool hasSigns = orders.contains(-1);
    for (const auto &[code, order] : orders)
        result.directions[code] = code == (hasSigns ? orders.rbegin()->first : orders.begin()->first)
                                      ? Direction::positive
                                      : Direction::negative;
    if (orders.size() == 1) {
        if (hasSigns)
            result = {{{-1, Direction::negative}}, DirectionCodes::Origin::stated};
        return result;
    }
    const auto &[first, low] = *orders.begin();
    const auto &[last, high] = *orders.rbegin();
    const bool isOrdered = orders.size() == 2 && areOpposite(low, high);
    const bool lowRises = low.direction() == Direction::positive || high.direction() == Direction::negative;
    if (hasSigns) { // known, unless every pass contradicts them
        result.origin =
            isOrdered && lowRises ? DirectionCodes::Origin::unclear : DirectionCodes::Origin::stated;
    } else if (isOrdered) {
        result.origin = DirectionCodes::Origin::ordered;
        result.directions = {{first, lowRises ? Direction::positive : Direction::negative},
                             {last, lowRises ? Direction::negative : Direction::positive}};
    } else {
        result.origin = DirectionCodes::Origin::unclear;
    }
    return result;
}

} // namespace palmer
