// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace palmer {

/// The machine tool under test; empty = not stated.
struct Machine {
    std::string name;
    std::string manufacturer;
    std::string model;
    std::string serialNumber;
    std::string controller;
    std::optional<int> year;
    std::string location;
    std::string condition;

    bool operator==(const Machine &) const = default;
};

/// The calibration that an instrument is traceable to; empty: not stated.
struct Traceability {
    std::string laboratory; ///< that calibrated it; empty: `Instrument::calibratedBy`
    std::string accreditation;
    std::string certificate; ///< empty: `Instrument::certificate`

    bool operator==(const Traceability &) const = default;
};

/// A measuring instrument and its traceability; tests name instruments by `id`.
struct Instrument {
    std::string id;
    std::string description;
    std::string manufacturer;
    std::string model;
    std::string serialNumber;
    std::string certificate;
    std::string calibratedBy;
    std::optional<std::string> calibrationDate; ///< YYYY-MM-DD
    std::optional<std::string> calibrationDue;  ///< YYYY-MM-DD
    std::optional<double> resolution;           ///< mm; angular instruments: degrees
    Traceability traceability;

    bool operator==(const Instrument &) const = default;
};

} // namespace palmer
