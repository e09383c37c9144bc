// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/machine.h"
#include "kernel/measurement/sheet.h"
#include "kernel/measurement/test.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace palmer {

enum class Signer { operatorSigns, laboratory, supplier, customer };
enum class ReportLanguage { fr, en };
enum class Paper { a4, letter };
enum class ReportPart {
    readings,
    targetTable,
    uncertainty,
    findings,
    diagnosis,
    signatures,
    temperatureCurve,
    annex ///< all that is not part of the certificate
};
enum class ReportExtra {
    readingMarks,
    meanRepeatability,
    repetitions,
    allReadings, ///< tables of readings and targets whatever their number of rows
    diagnosis    ///< a page with the interpretation of circles
};
enum class CircleFigures { combined, separate };
enum class Rounding {
    palmer,   ///< U to two digits, but never coarser than 0.1 µm nor finer than the instrument
    twoDigits ///< U to two significant digits, the value likewise
};

struct Laboratory {
    std::string name;
    std::string address;
    std::string accreditation;
    std::string country = {};        ///< ISO 3166-1 alpha-2
    std::optional<std::string> logo; ///< base64, PNG or SVG picture
    std::optional<std::string> mark; ///< base64, mark of the accreditation body

    bool operator==(const Laboratory &) const = default;
};

struct Party {
    std::string name;
    std::string address;
    std::string contact = {}; ///< person, telephone, e-mail

    bool operator==(const Party &) const = default;
};

struct Authorisation {
    std::string name;
    std::string function;

    bool operator==(const Authorisation &) const = default;
};

/// Contents of the report besides the tests. Dates YYYY-MM-DD; empty or null = not stated.
struct ReportHead {
    std::string title;
    std::string number;
    std::string revision;
    std::string replaces;
    std::string revisionReason = {}; ///< why it was revised and what changed
    std::optional<std::string> date;
    std::optional<std::string> performedFrom;
    std::optional<std::string> performedTo;
    std::string place;
    Laboratory laboratory;
    Party customer;
    Party supplier;
    std::string order;
    std::string procedure;
    std::string deviationsFromMethod = {}; ///< additions to, deviations and exclusions from the method
    std::string operatorName;
    Authorisation authorisedBy;
    std::vector<Signer> signatures{Signer::operatorSigns, Signer::supplier, Signer::customer};
    std::vector<ReportLanguage> languages{ReportLanguage::fr};
    Paper paper = Paper::a4;
    std::vector<ReportPart> leaveOut;
    std::vector<ReportExtra> include{ReportExtra::readingMarks};
    std::vector<std::string> editions; ///< printed next to each other, without verdict
    CircleFigures figures = CircleFigures::combined;
    Rounding rounding = Rounding::palmer;
    std::string adjustments;
    std::string remarks;
    std::vector<SheetRow> sheet = {}; ///< what was checked beside the tests
    DecisionRule decisionRule = {};   ///< of the sheet

    bool operator==(const ReportHead &) const = default;
};

using TestPointer = std::shared_ptr<const Test>;

/// One file: one report with machine, instruments and any number of tests. Tests are shared and immutable, so
/// copies are cheap; an edit replaces one pointer. Results are never part of it.
struct Document {
    std::string writtenBy;
    ReportHead report;
    Machine machine;
    std::vector<Instrument> instruments;
    std::vector<TestPointer> tests;
    std::string extensions = "{}"; ///< JSON object, kept as text

    /// Compares tests by value.
    friend bool operator==(const Document &a, const Document &b);
};

/// Returns the measurement of a test; null for a test of another kind and for an index beyond the end.
template <class Measurement>
[[nodiscard]] const Measurement *measured(const Document &document, std::size_t test) {
    return test < document.tests.size() ? std::get_if<Measurement>(&document.tests[test]->measurement)
                                        : nullptr;
}

} // namespace palmer
