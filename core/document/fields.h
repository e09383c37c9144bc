// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/fileunit.h"
#include "kernel/measurement/testfacts.h"

#include <concepts>
#include <type_traits>

namespace palmer {

/// Requirements of the file format for a value beyond its type; bits, combined with |.
enum Demand : unsigned {
    nothing = 0,
    obligatory = 1U << 0U,  ///< the key must be present
    positive = 1U << 1U,    ///< > 0
    notNegative = 1U << 2U, ///< ≥ 0
    date = 1U << 3U,        ///< YYYY-MM-DD, an existing day
    timeOfDay = 1U << 4U,   ///< HH:MM
    base64 = 1U << 5U,
    longText = 1U << 6U,     ///< remarks, agreements, addresses: `mostOfText` instead of `mostOfLine`
    reading = 1U << 7U,      ///< within ± `mostOfReading`
    trialCount = 1U << 8U,   ///< 1 … mostTrialsStated
    added = 1U << 9U,        ///< new in version 2: written only if not empty
    celsius = 1U << 10U,     ///< a temperature, at least `leastTemperature`
    coefficient = 1U << 11U, ///< of expansion, within ± `mostOfExpansion`
    leftOut = 1U << 12U,     ///< written only if not empty, as older programs accept no null
    declared = 1U << 13U,    ///< the same for every test at a site: part of a conditions template
    shared = 1U << 14U,      ///< the same for all tests of a machine: copied from another test
    alike = 1U << 15U,       ///< likewise, for tests of one kind on axes of one motion
    latest = 1U << 16U,      ///< new in version 3: null or left out if empty, written only if not
    countryCode = 1U << 17U, ///< ISO 3166-1 alpha-2
    percentage = 1U << 18U,  ///< 0 … 100
    /// Files from before have other values: they are read, and the value is a finding; see
    /// impossiblevalues.h. A new value is refused where it is entered.
    questioned = 1U << 19U,
    ascending = 1U << 20U, ///< a list whose values never fall; always questioned
};

/// The demands of a number in a unit of the file: fileUnitOf returns it.
constexpr unsigned operator|(unsigned demands, FileUnit unit) {
    return demands | static_cast<unsigned>(unit) << firstBitOfFileUnit;
}

// Fields of the test file: one function per struct, shared by reader and writer, so that each key exists
// once. `visit(key, member, demands)` takes a member, `visit.object(key, function)` an object that is not a
// struct, `visit.extensions(key, member)` content kept as it is.

template <class T, class Struct>
concept Like = std::same_as<std::remove_const_t<T>, Struct>;

template <class Visit, Like<Laboratory> T>
void fields(Visit &visit, T &laboratory) {
    visit("name", laboratory.name);
    visit("address", laboratory.address, longText);
    visit("accreditation", laboratory.accreditation);
    visit("country", laboratory.country, latest | countryCode);
    visit("logo", laboratory.logo, base64);
    visit("mark", laboratory.mark, base64);
}

template <class Visit, Like<Party> T>
void fields(Visit &visit, T &party) {
    visit("name", party.name);
    visit("address", party.address, longText);
    visit("contact", party.contact, latest);
}

template <class Visit, Like<Authorisation> T>
void fields(Visit &visit, T &authorisation) {
    visit("name", authorisation.name);
    visit("function", authorisation.function);
}

template <class Visit, Like<DecisionRule> T>
void fields(Visit &visit, T &decision) {
    visit("rule", decision.rule);
    visit("guardFactor", decision.guardFactor, notNegative);
}

template <class Visit, Like<SheetSource> T>
void fields(Visit &visit, T &source) {
    visit("test", source.test, obligatory);
    visit("parameter", source.parameter, obligatory);
}

template <class Visit, Like<SheetRow> T>
void fields(Visit &visit, T &row) {
    visit("number", row.number, latest);
    visit("object", row.object, latest);
    visit("permitted", row.permitted, latest);
    visit("measured", row.measured, latest);
    visit("uncertainty", row.uncertainty, latest | notNegative);
    visit("unit", row.unit, latest);
    visit("instrument", row.instrument, latest);
    visit("remark", row.remark, latest | longText);
    visit("standard", row.standard, latest);
    visit("notApplicable", row.notApplicable, latest);
    visit("from", row.from, latest);
}

template <class Visit, Like<ReportHead> T>
void fields(Visit &visit, T &report) {
    visit("title", report.title);
    visit("number", report.number);
    visit("revision", report.revision);
    visit("replaces", report.replaces);
    visit("revisionReason", report.revisionReason, latest);
    visit("date", report.date, date);
    visit("performedFrom", report.performedFrom, date);
    visit("performedTo", report.performedTo, date);
    visit("place", report.place);
    visit("laboratory", report.laboratory);
    visit("customer", report.customer);
    visit("supplier", report.supplier);
    visit("order", report.order);
    visit("procedure", report.procedure);
    visit("deviationsFromMethod", report.deviationsFromMethod, longText | latest);
    visit("operator", report.operatorName);
    visit("authorisedBy", report.authorisedBy);
    visit("signatures", report.signatures);
    visit("languages", report.languages);
    visit("paper", report.paper);
    visit("leaveOut", report.leaveOut);
    visit("include", report.include);
    visit("editions", report.editions);
    visit("figures", report.figures);
    visit("rounding", report.rounding, latest);
    visit("adjustments", report.adjustments);
    visit("remarks", report.remarks, longText);
    visit("sheet", report.sheet, latest);
    visit("decisionRule", report.decisionRule, latest);
}

template <class Visit, Like<Machine> T>
void fields(Visit &visit, T &machine) {
    visit("name", machine.name);
    visit("manufacturer", machine.manufacturer);
    visit("model", machine.model);
    visit("serialNumber", machine.serialNumber);
    visit("controller", machine.controller);
    visit("year", machine.year);
    visit("location", machine.location);
    visit("condition", machine.condition);
}

template <class Visit, Like<Instrument> T>
void fields(Visit &visit, T &instrument) {
    visit("id", instrument.id);
    visit("description", instrument.description);
    visit("manufacturer", instrument.manufacturer);
    visit("model", instrument.model);
    visit("serialNumber", instrument.serialNumber);
    visit("certificate", instrument.certificate);
    visit("calibratedBy", instrument.calibratedBy);
    visit("calibrationDate", instrument.calibrationDate, date);
    visit("calibrationDue", instrument.calibrationDue, date);
    visit("resolution", instrument.resolution, notNegative | FileUnit::deviation);
    visit("traceability", instrument.traceability, latest);
}

template <class Visit, Like<Traceability> T>
void fields(Visit &visit, T &traceability) {
    visit("laboratory", traceability.laboratory, latest);
    visit("accreditation", traceability.accreditation, latest);
    visit("certificate", traceability.certificate, latest);
}

template <class Visit, Like<Interval> T>
void fields(Visit &visit, T &interval) {
    visit("from", interval.from, obligatory);
    visit("to", interval.to, obligatory);
}

template <class Visit, Like<Axis> T>
void fields(Visit &visit, T &axis) {
    visit("name", axis.name);
    visit("motion", axis.motion);
    visit("travel", axis.travel, positive | FileUnit::position);
    visit("range", axis.range, nothing | FileUnit::position);
    visit("positionFeedback", axis.positionFeedback);
    visit("scaleElement", axis.scaleElement, notNegative | added | FileUnit::position);
}

template <class Visit, Like<TargetChoice> T>
void fields(Visit &visit, T &choice) {
    visit("kind", choice.kind);
    visit("interval", choice.interval, positive | questioned | FileUnit::position);
    visit("period", choice.period, positive | questioned | FileUnit::position);
    visit("seed", choice.seed);
    visit("faces", choice.faces, positive | added);
}

template <class Visit, Like<Run> T>
void fields(Visit &visit, T &run) {
    visit("approach", run.approach, obligatory);
    visit("deviations", run.deviations, obligatory | reading | FileUnit::deviation);
}

template <class Visit, Like<ExcludedReading> T>
void fields(Visit &visit, T &excluded) {
    visit("run", excluded.run, obligatory | positive);
    visit("target", excluded.target, obligatory | positive);
    visit("value", excluded.value, obligatory | reading | FileUnit::deviation);
    visit("reason", excluded.reason);
}

template <class Visit, Like<WarmUp> T>
void fields(Visit &visit, T &warmUp) {
    visit("kind", warmUp.kind);
    visit("text", warmUp.text);
    visit("specifiedBy", warmUp.specifiedBy, added);
}

template <class Visit, Like<TemperatureSeries> T>
void fields(Visit &visit, T &series) {
    visit("times", series.times, obligatory | ascending | FileUnit::seconds);
    visit("temperatures", series.temperatures, obligatory | celsius | FileUnit::temperature);
}

template <class Visit, Like<Sensor> T>
void fields(Visit &visit, T &sensor) {
    visit("measures", sensor.measures);
    visit("position", sensor.position);
    visit("start", sensor.start, celsius | FileUnit::temperature);
    visit("end", sensor.end, celsius | FileUnit::temperature);
    visit("series", sensor.series);
}

template <class Visit, Like<Expansion> T>
void fields(Visit &visit, T &expansion) {
    visit("machine", expansion.machine, coefficient | questioned | shared | FileUnit::expansion);
    visit("instrument", expansion.instrument, coefficient | questioned | alike | FileUnit::expansion);
}

template <class Visit, Like<Conditions> T>
void fields(Visit &visit, T &conditions) {
    visit("warmUp", conditions.warmUp, declared | shared);
    visit("compensation", conditions.compensation, declared | shared);
    visit("otherAxes", conditions.otherAxes);
    visit("load", conditions.load, declared | shared);
    visit("levelled", conditions.levelled, declared | shared);
    visit("complete", conditions.complete, declared | shared);
    visit("unloaded", conditions.unloaded, declared | shared);
    visit("soak", conditions.soak, declared | shared);
    visit("shielded", conditions.shielded, declared | shared);
    visit("temperatureControlled", conditions.temperatureControlled, added | declared | shared);
    visit("stabilised", conditions.stabilised, added | declared | shared);
    visit("instrumentCompensation", conditions.instrumentCompensation, added | declared | alike);
    visit("thermalGuidelines", conditions.thermalGuidelines, declared | shared);
    visit("toolOffset", conditions.toolOffset, nothing | FileUnit::length);
    visit("workpieceOffset", conditions.workpieceOffset, nothing | FileUnit::length);
    visit("instrumentPosition", conditions.instrumentPosition);
    visit("sensors", conditions.sensors);
    visit("expansion", conditions.expansion);
    visit("correctionTo20", conditions.correctionTo20, alike);
}

template <class Visit, Like<PositioningConditions> T>
void fields(Visit &visit, T &conditions) {
    fields(visit, conditions.common);
    visit("feed", conditions.feed, positive | questioned | alike | FileUnit::feed);
    visit("feedMode", conditions.feedMode, leftOut | alike);
    visit("dwell", conditions.dwell, notNegative | questioned | alike | FileUnit::seconds);
    visit("approachDistance", conditions.approachDistance,
          notNegative | questioned | alike | FileUnit::position);
    visit("airPressure", conditions.airPressure, positive | questioned | FileUnit::pressure);
    visit("airHumidity", conditions.airHumidity, percentage | questioned | FileUnit::percent);
    visit("gradientPerHour", conditions.gradientPerHour, nothing | FileUnit::gradient);
    visit("gradientHoursBefore", conditions.gradientHoursBefore, notNegative | added | FileUnit::hours);
    visit("continuousDevice", conditions.continuousDevice, added | alike);
    visit("referencePosition", conditions.referencePosition, nothing | FileUnit::position);
}

template <class Visit, Like<CircularConditions> T>
void fields(Visit &visit, T &conditions) {
    fields(visit, conditions.common);
    visit("centre", conditions.centre, nothing | FileUnit::length);
    visit("startPoint", conditions.startPoint);
    visit("stopPoint", conditions.stopPoint);
    visit("smoothing", conditions.smoothing, alike);
    visit("recentredBetweenRuns", conditions.recentredBetweenRuns, alike);
}

/// Ranges and uncertainties: a negative one is read and questioned.
inline constexpr unsigned rangeOrUncertainty = notNegative | questioned;

template <class Visit, Like<DeviceUncertainty> T>
void fields(Visit &visit, T &device) {
    visit("kind", device.kind);
    visit("fixed", device.fixed, rangeOrUncertainty | FileUnit::uncertainty);
    visit("perMetre", device.perMetre, rangeOrUncertainty | FileUnit::perMetre);
    visit("coverageFactor", device.coverageFactor, positive);
}

template <class Visit, Like<MachineAndInstrument> T>
void fields(Visit &visit, T &pair) {
    visit("machine", pair.machine);
    visit("instrument", pair.instrument);
}

template <class Visit, Like<PositioningUncertaintyInputs> T>
void fields(Visit &visit, T &uncertainty) {
    visit("method", uncertainty.method, alike);
    visit("device", uncertainty.device, alike);
    visit("misalignmentRange", uncertainty.misalignmentRange, rangeOrUncertainty | FileUnit::length);
    visit("temperatureRange", uncertainty.temperatureRange,
          rangeOrUncertainty | alike | FileUnit::temperatureRange);
    visit("expansionRange", uncertainty.expansionRange, rangeOrUncertainty | alike | FileUnit::expansion);
    visit("environmentalVariation", uncertainty.environmentalVariation,
          rangeOrUncertainty | FileUnit::uncertainty);
    visit("driftTest", uncertainty.driftTest);
    visit("driftModel", uncertainty.driftModel);
    visit("length", uncertainty.length, positive | questioned | FileUnit::position);
    visit("trials", uncertainty.trials, trialCount | alike);
    visit("seed", uncertainty.seed);
    visit("expanded", uncertainty.expanded, notNegative | FileUnit::uncertainty);
}

template <class Visit, Like<ExpandedValue> T>
void fields(Visit &visit, T &value) {
    visit("expanded", value.expanded, rangeOrUncertainty | FileUnit::uncertainty);
    visit("coverageFactor", value.coverageFactor, positive);
}

template <class Visit, Like<CircularUncertaintyInputs> T>
void fields(Visit &visit, T &uncertainty) {
    visit("method", uncertainty.method, alike);
    visit("displacement", uncertainty.displacement, alike);
    visit("resolution", uncertainty.resolution, rangeOrUncertainty | alike | FileUnit::uncertainty);
    visit("pointNoise", uncertainty.pointNoise, rangeOrUncertainty | alike | FileUnit::uncertainty);
    visit("repeatability", uncertainty.repeatability, rangeOrUncertainty | FileUnit::uncertainty);
    visit("environmentalVariation", uncertainty.environmentalVariation,
          rangeOrUncertainty | FileUnit::uncertainty);
    visit("driftTest", uncertainty.driftTest);
    visit("centring", uncertainty.centring, rangeOrUncertainty | FileUnit::uncertainty);
    visit("sameSensor", uncertainty.sameSensor, alike);
    visit("temperatureStandardUncertainty", uncertainty.temperatureStandardUncertainty,
          rangeOrUncertainty | alike | FileUnit::temperatureRange);
    visit("expansionStandardUncertainty", uncertainty.expansionStandardUncertainty,
          rangeOrUncertainty | alike | FileUnit::expansion);
    visit("trials", uncertainty.trials, trialCount | alike);
    visit("seed", uncertainty.seed);
    visit("expanded", uncertainty.expanded, notNegative | FileUnit::uncertainty);
}

template <class Visit, Like<AgreedPoint> T>
void fields(Visit &visit, T &agreed) {
    visit("point", agreed.point, obligatory);
    visit("state", agreed.state, obligatory);
    visit("text", agreed.text, longText);
    const bool isFeed = agreed.point == "feed";
    const bool isGradient = agreed.point == "gradient";
    visit("value", agreed.value,
          added | questioned | (isFeed ? positive : notNegative) |
              (isFeed       ? FileUnit::feed
               : isGradient ? FileUnit::gradient
                            : FileUnit::none));
}

template <class Visit, Like<Limit> T>
void fields(Visit &visit, T &limit) {
    visit("value", limit.value, nothing | FileUnit::deviation);
    visit("edition", limit.edition);
    visit("source", limit.source);
}

template <class Visit, Like<ImportedResult> T>
void fields(Visit &visit, T &result) {
    visit("name", result.name);
    visit("value", result.value, obligatory);
    visit("unit", result.unit);
}

template <class Visit, Like<ImportedFile> T>
void fields(Visit &visit, T &file) {
    visit("fileName", file.fileName);
    visit("sha256", file.sha256);
    visit("data", file.data, base64);
    visit("results", file.results);
    visit("signAssumed", file.signAssumed, added);
}

template <class Visit, Like<Plane> T>
void fields(Visit &visit, T &plane) {
    visit("first", plane.first);
    visit("second", plane.second);
}

template <class Visit, Like<ReferenceLength> T>
void fields(Visit &visit, T &length) {
    visit("calibrated", length.calibrated);
    visit("expandedUncertainty", length.expandedUncertainty, rangeOrUncertainty | FileUnit::uncertainty);
    visit("coverageFactor", length.coverageFactor, positive);
}

template <class Visit, Like<SpecifiedCircle> T>
void fields(Visit &visit, T &circle) {
    visit("diameter", circle.diameter, positive | FileUnit::length);
    visit("feed", circle.feed, positive | FileUnit::feed);
}

template <class Visit, Like<DeclaredAccordance> T>
void fields(Visit &visit, T &declared) {
    visit("by", declared.by);
    visit("date", declared.date, date);
    visit("text", declared.text, longText);
}

template <class Visit, Like<ComparedWith> T>
void fields(Visit &visit, T &compared) {
    visit("test", compared.test, obligatory);
    visit("tolerance", compared.tolerance, positive | FileUnit::deviation);
    visit("setUpUntouched", compared.setUpUntouched);
}

template <class Visit, Like<Arc> T>
void fields(Visit &visit, T &arc) {
    visit("sense", arc.sense, obligatory);
    visit("angleReference", arc.angleReference);
    visit("angles", arc.angles, obligatory | FileUnit::angle);
    visit("radialDeviations", arc.radialDeviations, obligatory | reading | FileUnit::linearDeviation);
    visit("evaluated", arc.evaluated, nothing | FileUnit::angle);
    visit("sampleInterval", arc.sampleInterval, positive | FileUnit::seconds);
    visit("cutOff", arc.cutOff, added);
}

template <class Visit, Like<PositioningMeasurement> T>
void fields(Visit &visit, T &measurement) {
    visit("standardDeviation", measurement.standardDeviation);
    visit("axis", measurement.axis);
    visit("cycle", measurement.cycle, leftOut);
    visit("zone", measurement.zone, nothing | FileUnit::position);
    visit("targets", measurement.targets, obligatory | FileUnit::position);
    visit("targetChoice", measurement.targetChoice);
    visit("runs", measurement.runs, obligatory);
    visit("excluded", measurement.excluded);
    visit("conditions", measurement.conditions);
    visit("uncertainty", measurement.uncertainty);
}

template <class Visit, Like<CircularMeasurement> T>
void fields(Visit &visit, T &measurement) {
    visit("plane", measurement.plane);
    visit("positionFeedback", measurement.positionFeedback);
    visit("nominalRadius", measurement.nominalRadius, obligatory | positive | FileUnit::length);
    visit("feed", measurement.feed, positive | questioned | FileUnit::feed);
    visit("specified", measurement.specified, added);
    visit("source", measurement.source);
    visit("centring", measurement.centring);
    visit("referenceCircle", measurement.referenceCircle);
    visit("referenceLength", measurement.referenceLength);
    visit("requiredResults", measurement.requiredResults);
    visit("arcs", measurement.arcs, obligatory);
    visit("conditions", measurement.conditions);
    visit("uncertainty", measurement.uncertainty);
}

template <class Visit, Like<DriftChannel> T>
void fields(Visit &visit, T &channel) {
    visit("name", channel.name);
    visit("quantity", channel.quantity);
    visit("values", channel.values,
          obligatory | reading |
              (channel.quantity == ChannelQuantity::angularDeviation ? FileUnit::angularDeviation
                                                                     : FileUnit::linearDeviation));
}

template <class Visit, Like<DriftTemperature> T>
void fields(Visit &visit, T &temperature) {
    visit("measures", temperature.measures);
    visit("resolution", temperature.resolution, notNegative | FileUnit::temperatureRange);
    visit("values", temperature.values, obligatory | celsius | FileUnit::temperature);
}

template <class Visit, Like<DriftMeasurement> T>
void fields(Visit &visit, T &measurement) {
    visit.object("axis", [&](auto &axis) {
        axis("name", measurement.axis.name);
        axis("motion", measurement.axis.motion);
    });
    visit("times", measurement.times, obligatory | ascending | FileUnit::seconds);
    visit("channels", measurement.channels, latest);
    // Several channels have the readings instead.
    visit("deviations", measurement.deviations,
          reading | (measurement.channels.empty() ? obligatory : latest) | FileUnit::deviation);
    visit("temperatures", measurement.temperatures, latest);
    visit("settled", measurement.settled, latest);
}

/// The keys of a test and of its measurement, in one object; `kind` is handled by reader and writer. Drift
/// tests are not judged: they have no edition and no agreements.
template <class Visit, Like<Test> T>
void fields(Visit &visit, T &test) {
    visit("id", test.id);
    visit("title", test.title);
    visit("date", test.date, date);
    visit("time", test.time, timeOfDay);
    visit("instruments", test.instruments);
    if (isJudged(test)) {
        visit("edition", test.edition, obligatory);
        visit("purpose", test.purpose, added);
        visit("role", test.role, added);
        visit("declaredAccordance", test.declaredAccordance, added);
        visit("duration", test.duration, positive | latest | FileUnit::minutes);
        visit("comparedWith", test.comparedWith, latest);
        visit("agreedPoints", test.agreedPoints);
        visit("limits", test.limits);
        visit("decisionRule", test.decisionRule);
        visit("imports", test.imports);
    }
    visit("remarks", test.remarks, longText);
    visit.extensions("extensions", test.extensions);
    std::visit([&](auto &measurement) { fields(visit, measurement); }, test.measurement);
}

/// Without `format` and `version`, which reader and writer handle.
template <class Visit, Like<Document> T>
void fields(Visit &visit, T &document) {
    visit("writtenBy", document.writtenBy);
    visit("report", document.report);
    visit("machine", document.machine);
    visit("instruments", document.instruments);
    visit("tests", document.tests);
    visit.extensions("extensions", document.extensions);
}

} // namespace palmer
