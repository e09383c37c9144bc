// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/measurement/testfacts.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace palmer {

// Edits that keep related members of a document consistent. Indices count from 0; an index beyond the end
// changes nothing.

/// Applies `change` to a copy of the test and replaces the test by the copy.
void editTest(Document &document, std::size_t test, const std::function<void(Test &)> &change);

/// The same for the measurement of a test; a test of another kind is unchanged.
template <class Measurement>
void editMeasurement(Document &document, std::size_t test, const std::function<void(Measurement &)> &change) {
    if (measured<Measurement>(document, test))
        editTest(document, test, [&](Test &changed) { change(std::get<Measurement>(changed.measurement)); });
}

/// Adds to the angles of all arcs, degrees, and to their evaluated ranges.
void turnAngles(CircularMeasurement &circle, double by);

/// Returns an id not used by any instrument: "instrument", "instrument2", …
[[nodiscard]] std::string freeInstrumentId(const Document &document);

/// Adds an instrument. An empty id is replaced by a free one. The first instrument of a document is assigned
/// to all tests that name none, as they cannot have been made with another.
void addInstrument(Document &document, Instrument instrument);

/// Removes an instrument, also from the tests that name it.
void removeInstrument(Document &document, std::size_t index);

/// Changes the id of an instrument, also in the tests that name it. Returns false without change if the id is
/// empty or taken.
bool renameInstrument(Document &document, std::size_t index, const std::string &id);

/// Returns the `ordinal`-th sensor that measures `what`, or null.
[[nodiscard]] const Sensor *sensorOf(const Conditions &conditions, SensorMeasures what, std::size_t ordinal);

/// Returns the number of sensors that measure `what`.
[[nodiscard]] std::size_t countSensors(const Conditions &conditions, SensorMeasures what);

/// Applies `change` to that sensor, creating it if it is the next one. An empty sensor is removed if it is
/// the last of its kind.
void editSensor(Conditions &conditions, SensorMeasures what, std::size_t ordinal,
                const std::function<void(Sensor &)> &change);
void removeSensor(Conditions &conditions, SensorMeasures what, std::size_t ordinal);

/// Sets state and text of a point to agree; null: nothing is declared, and the point is removed.
void setAgreedPoint(Test &test, const std::string &point, std::optional<AgreementState> state,
                    const std::string &text);

/// Takes the number of an agreement (gradient, programmed feed) from the conditions, if stated there.
void takeAgreedValue(Test &test, std::string_view point);

/// Applies `change` to the limit of a parameter; a limit without value, edition and source is removed.
void editLimit(Test &test, const std::string &id, const std::function<void(Limit &)> &change);

} // namespace palmer
