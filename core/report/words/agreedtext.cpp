// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/words/agreedtext.h"

#include "document/edits.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"

namespace palmer {
namespace {

QString feedText(const PositioningMeasurement &measurement, const Language &language) {
    const PositioningConditions &conditions = measurement.conditions;
    const bool linear = measurement.axis.motion == Motion::linear;
    if (conditions.feedMode == FeedMode::rapid)
        return language.text(REPORT_TEXT("report", "rapid feed"));
    return conditions.feed
               ? language.quantity(*conditions.feed, linear ? Quantity::feed : Quantity::angularFeed)
               : QString();
}

QString fromTo(double from, double to, Quantity quantity, const Language &language) {
    const Message sentence{
        REPORT_TEXT("report", "%1 to %2"), {Number{from, quantity, -1}, Number{to, quantity, -1}}, {}};
    return language.sentence(sentence);
}

/// Statements that only positioning tests have.
QString agreedText(const PositioningMeasurement &measurement, std::string_view point,
                   const Language &language) {
    const Quantity position = positionQuantity(measurement.axis);
    if (point == "feed")
        return feedText(measurement, language);
    if (point == "gradient" && measurement.conditions.gradientPerHour)
        return language.quantity(*measurement.conditions.gradientPerHour, Quantity::gradient);
    if (point == "dwell" && measurement.conditions.dwell)
        return language.quantity(*measurement.conditions.dwell, Quantity::time);
    if (point == "zone" && measurement.zone)
        return fromTo(measurement.zone->from, measurement.zone->to, position, language);
    if (point == "firstLastTarget" && measurement.targets.size() > 1)
        return fromTo(measurement.targets.front(), measurement.targets.back(), position, language);
    return {};
}

QString agreedText(const CircularMeasurement &measurement, std::string_view point, const Language &language) {
    return point == "feed" && measurement.feed ? language.quantity(*measurement.feed, Quantity::feed)
                                               : QString();
}

QString agreedText(const Unjudged auto & /*measurement*/, std::string_view /*point*/,
                   const Language & /*language*/) {
    return {};
}

} // namespace

QString agreedTextFromConditions(const Test &test, std::string_view point, const Language &language) {
    const Conditions *conditions = conditionsOf(test);
    if (!conditions)
        return {};
    if (point == "warmUp")
        return QString::fromStdString(conditions->warmUp.text);
    if (point == "instrumentPosition" || point == "measuringReference")
        return QString::fromStdString(conditions->instrumentPosition);
    if (point == "otherAxes")
        return QString::fromStdString(conditions->otherAxes);
    return std::visit([&](const auto &measurement) { return agreedText(measurement, point, language); },
                      test.measurement);
}

} // namespace palmer
