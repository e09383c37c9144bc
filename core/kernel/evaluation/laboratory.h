// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/commonchecks.h"
#include "kernel/evaluation/requirement.h"
#include "kernel/evaluation/stated.h"
#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>
#include <span>

/// Good laboratory practice for tests of all kinds: notes that never count.
namespace palmer::laboratory {

/// Name or type of the machine.
template <class Case>
bool named(const Case &test) {
    return stated::ofMachine<&Machine::name>(test) || stated::ofMachine<&Machine::model>(test);
}

// ---- Further checks
// ------------------------------------------------------------------------------------------

template <class Case>
std::optional<Message> purposeNotStated(const Case &test) {
    return sentenceIf(test.test.purpose == Purpose::notStated,
                      REPORT_TEXT("report", "Purpose of the test not stated."));
}

/// One of two tests of the same axis or plane does not state whether it is before or after.
template <class Case>
std::optional<Message> roleNotStated(const Case &test) {
    return sentenceIf(test.surroundings.repeated && test.test.role == TestRole::notStated,
                      REPORT_TEXT("report", "As found or as left: not stated."));
}

template <class Case>
std::optional<Message> adjustmentsNotStated(const Case &test) {
    return sentenceIf(test.test.role == TestRole::asLeft && !test.surroundings.adjustmentsStated,
                      REPORT_TEXT("report", "Adjustments not stated."));
}

template <class Case>
std::optional<Message> picturesNotReadable(const Case &test) {
    return sentenceIf(!test.surroundings.picturesReadable,
                      REPORT_TEXT("report", "The logo or the mark of the laboratory is no PNG or SVG "
                                            "picture: the report is printed without it."));
}

/// Instruments whose calibration had expired or was made after the test. ISO dates compare as strings.
template <class Case>
std::optional<Message> calibrationNotValid(const Case &test) {
    std::string names;
    for (const Instrument *instrument : test.surroundings.instruments) {
        const auto &day = test.test.date;
        if (!day || ((!instrument->calibrationDue || *day <= *instrument->calibrationDue) &&
                     (!instrument->calibrationDate || *day >= *instrument->calibrationDate)))
            continue;
        names += (names.empty() ? "" : ", ") +
                 (instrument->description.empty() ? instrument->id : instrument->description);
    }
    if (names.empty())
        return std::nullopt;
    return Message{REPORT_TEXT("report", "Calibration of %1 not valid on the date of the test."), {names}};
}

/// The report predates the test, or the test is outside the stated period of testing.
template <class Case>
std::optional<Message> datesContradict(const Case &test) {
    const auto &day = test.test.date;
    const Surroundings &around = test.surroundings;
    const auto contradict = [](const std::string &a, const std::string &b) {
        return Message{REPORT_TEXT("report", "Dates contradict each other: %1, %2."), {Date{a}, Date{b}}};
    };
    if (day && around.reportDate && *around.reportDate < *day)
        return contradict(*day, *around.reportDate);
    if (day && around.performedFrom && *day < *around.performedFrom)
        return contradict(*day, *around.performedFrom);
    if (day && around.performedTo && *day > *around.performedTo)
        return contradict(*day, *around.performedTo);
    return std::nullopt;
}

/// The budget names a drift test it cannot use: with too few readings, or without a channel of the axis.
template <class Case>
std::optional<Message> driftTestOfNoUse(const Case &test) {
    const std::string *drift = driftTestOf(test.test);
    if (!drift || test.surroundings.environmentalVariation)
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "The drift test “%1” gives no E_VE for this budget: none of its channels is "
                               "that of the axis, or it has fewer than two readings."),
                   {*drift}};
}

/// The drift test does not cover the duration of the test.
template <class Case>
std::optional<Message> driftTestTooShort(const Case &test) {
    bool isUsed = false; // a number beside it wins
    withUncertainty(test.test, [&](const auto &inputs) { isUsed = !inputs.environmentalVariation; });
    if (!isUsed || !test.surroundings.variationIsLowerBound)
        return std::nullopt;
    return Message{REPORT_TEXT("report",
                               "E_VE of the drift test “%1” is a lower bound: its record is shorter than the "
                               "test, or has a gap of more than a tenth of it."),
                   {*driftTestOf(test.test)}};
}

/// The certificate is one of an accredited laboratory.
template <class Case>
bool accredited(const Case &test) {
    return test.surroundings.accredited.has_value();
}
template <auto member, class Case>
bool inHead(const Case &test) {
    return (*test.surroundings.accredited).*member;
}
template <class Case>
bool calibrated(const Case &test) {
    return std::ranges::all_of(test.surroundings.instruments, [](const Instrument *i) {
        return !isBlank(i->calibratedBy) || !isBlank(i->traceability.laboratory);
    });
}
template <class Case>
bool evaluatesUncertainty(const Case &test) {
    return *methodOf(test.test) != UncertaintyMethod::none;
}
// clang-format off
template <class Case>
inline constexpr std::array checkTable{
    RequirementOf<Case>{"purpose", Source::laboratory, "", Grade::note, Subject::conditions, nullptr, unless<purposeNotStated<Case>>, {}, {}, {"purpose"}},
    RequirementOf<Case>{"role", Source::laboratory, "", Grade::note, Subject::conditions, nullptr, unless<roleNotStated<Case>>, {}, {}, {"role"}},
    RequirementOf<Case>{"role", Source::laboratory, "", Grade::note, Subject::report, nullptr, unless<adjustmentsNotStated<Case>>, {}, {}, {"report.adjustments"}},
    RequirementOf<Case>{"pictures", Source::laboratory, "", Grade::note, Subject::report, nullptr, unless<picturesNotReadable<Case>>, {}, {}, {"report.laboratory.logo"}},
    RequirementOf<Case>{"calibrationDue", Source::laboratory, "", Grade::note, Subject::instruments, nullptr, unless<calibrationNotValid<Case>>, {}, {}, {"instruments.calibrationDue"}},
    RequirementOf<Case>{"dates", Source::laboratory, "", Grade::note, Subject::conditions, nullptr, unless<datesContradict<Case>>, {}, {}, {"date"}},
    RequirementOf<Case>{"driftTest", Source::program, "", Grade::note, Subject::uncertainty, nullptr, unless<driftTestOfNoUse<Case>>, {}, {}, {"uncertainty.driftTest"}},
    RequirementOf<Case>{"driftTest", Source::program, "", Grade::note, Subject::uncertainty, nullptr, unless<driftTestTooShort<Case>>, {}, {}, {"uncertainty.driftTest"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::report, accredited<Case>, stating<inHead<&StatedHead::laboratoryAddress, Case>>, REPORT_TEXT("report", "address of the laboratory"), {}, {"report.laboratory.address"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::report, accredited<Case>, stating<inHead<&StatedHead::number, Case>>, REPORT_TEXT("report", "number of the report"), {}, {"report.number"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::report, accredited<Case>, stating<inHead<&StatedHead::issueDate, Case>>, REPORT_TEXT("report", "date of issue"), {}, {"report.date"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::report, accredited<Case>, stating<inHead<&StatedHead::place, Case>>, REPORT_TEXT("report", "place of the tests"), {}, {"report.place"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::report, accredited<Case>, stating<inHead<&StatedHead::customer, Case>>, REPORT_TEXT("report", "customer with address"), {}, {"report.customer"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::report, accredited<Case>, stating<inHead<&StatedHead::authorised, Case>>, REPORT_TEXT("report", "who authorises the report"), {}, {"report.authorisedBy"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::machine, accredited<Case>, stating<stated::ofMachine<&Machine::condition, Case>>, REPORT_TEXT("report", "condition of the machine"), {}, {"machine.condition"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::instruments, accredited<Case>, stating<calibrated<Case>>, REPORT_TEXT("report", "who calibrated each instrument"), {}, {"instruments.calibratedBy"}},
    RequirementOf<Case>{"accredited", Source::laboratory, "", Grade::note, Subject::uncertainty, accredited<Case>, stating<evaluatesUncertainty<Case>>, REPORT_TEXT("report", "measurement uncertainty"), {}, {"uncertainty.method"}},
};

template <class Case>
inline constexpr std::array machineTable{
    RequirementOf<Case>{"date", Source::laboratory, "", Grade::note, Subject::conditions, nullptr, stating<stated::date<Case>>, REPORT_TEXT("report", "date of the test"), {}, {"date"}},
    RequirementOf<Case>{"machineName", Source::laboratory, "", Grade::note, Subject::machine, nullptr, stating<named<Case>>, REPORT_TEXT("report", "name of the machine"), {}, {"machine.name"}},
    RequirementOf<Case>{"manufacturer", Source::laboratory, "", Grade::note, Subject::machine, nullptr, stating<stated::ofMachine<&Machine::manufacturer, Case>>, REPORT_TEXT("report", "manufacturer of the machine"), {}, {"machine.manufacturer"}},
    RequirementOf<Case>{"model", Source::laboratory, "", Grade::note, Subject::machine, nullptr, stating<stated::ofMachine<&Machine::model, Case>>, REPORT_TEXT("report", "type of the machine"), {}, {"machine.model"}},
    RequirementOf<Case>{"machineSerialNumber", Source::laboratory, "", Grade::note, Subject::machine, nullptr, stating<stated::ofMachine<&Machine::serialNumber, Case>>, REPORT_TEXT("report", "serial number of the machine"), {}, {"machine.serialNumber"}},
    RequirementOf<Case>{"load", Source::laboratory, "", Grade::note, Subject::conditions, nullptr, stating<stated::common<&Conditions::load, Case>>, REPORT_TEXT("report", "load of the machine"), {}, {"conditions.load"}},
    RequirementOf<Case>{"sensors", Source::laboratory, "", Grade::note, Subject::conditions, nullptr, common::statingConditions<common::sensorsNamed, Case>, REPORT_TEXT("report", "what a temperature sensor measures"), {}, {"conditions.sensors"}},
    RequirementOf<Case>{"startAndEnd", Source::laboratory, "", Grade::note, Subject::conditions, nullptr, common::ofConditions<common::temperaturesAtStartAndEnd, Case>, REPORT_TEXT("report", "temperatures at start and end"), {}, {"conditions.sensors"}},
};

template <class Case>
inline constexpr std::array instrumentTable{
    RequirementOf<Case>{"instruments", Source::laboratory, "", Grade::note, Subject::namedInstruments, nullptr, stating<stated::instruments<Case>>, REPORT_TEXT("report", "instrument"), {}, {"instruments"}},
    RequirementOf<Case>{"instrumentSerialNumber", Source::laboratory, "", Grade::note, Subject::instruments, nullptr, stating<stated::ofInstruments<&Instrument::serialNumber, Case>>, REPORT_TEXT("report", "serial number of each instrument"), {}, {"instruments.serialNumber"}},
    RequirementOf<Case>{"certificate", Source::laboratory, "", Grade::note, Subject::instruments, nullptr, stating<stated::ofInstruments<&Instrument::certificate, Case>>, REPORT_TEXT("report", "calibration certificate of each instrument"), {}, {"instruments.certificate"}},
    RequirementOf<Case>{"calibrationDate", Source::laboratory, "", Grade::note, Subject::instruments, nullptr, stating<stated::ofInstruments<&Instrument::calibrationDate, Case>>, REPORT_TEXT("report", "calibration date of each instrument"), {}, {"instruments.calibrationDate"}},
    RequirementOf<Case>{"calibrationDue", Source::laboratory, "", Grade::note, Subject::instruments, nullptr, stating<stated::ofInstruments<&Instrument::calibrationDue, Case>>, REPORT_TEXT("report", "end of validity of each calibration"), {}, {"instruments.calibrationDue"}},
};
// clang-format on

template <class Case>
std::span<const RequirementOf<Case>> rows() {
    return machineTable<Case>;
}

template <class Case>
std::span<const RequirementOf<Case>> checks() {
    return checkTable<Case>;
}

template <class Case>
std::span<const RequirementOf<Case>> instrumentRows() {
    return instrumentTable<Case>;
}

} // namespace palmer::laboratory
