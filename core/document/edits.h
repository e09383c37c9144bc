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

// Edits that touch more than one member of a document, so that what belongs together stays together. Indices
// from 0; an index beyond the end changes nothing.

/// Lets `change` alter a copy of the test and puts the copy in its place.
void editTest(Document &document, std::size_t test, const std::function<void(Test &)> &change);

/// The same for what a test of one kind measured; a test of another kind stays as it is.
template <class Measurement>
void editMeasurement(Document &document, std::size_t test, const std::function<void(Measurement &)> &change) {
    if (measured<Measurement>(document, test))
        editTest(document, test, [&](Test &changed) { change(std::get<Measurement>(changed.measurement)); });
}

/// An id that no instrument has yet: "instrument", "instrument2", …
[[nodiscard]] std::string freeInstrumentId(const Document &document);

/// Adds an instrument. An empty id is replaced by a free one. Tests that name none get it when it is the
/// first of the document: there is no other they could have been made with.
void addInstrument(Document &document, Instrument instrument);

/// Removes an instrument, also from the tests that name it.
void removeInstrument(Document &document, std::size_t index);

/// Gives an instrument another id, also in the tests that name it. False, and no change, for an id that is
/// empty or taken.
bool renameInstrument(Document &document, std::size_t index, const std::string &id);

/// The sensor number `ordinal` among those that measure `what`; null where there is none.
[[nodiscard]] const Sensor *sensorOf(const Conditions &conditions, SensorMeasures what, std::size_t ordinal);

/// How many sensors measure `what`.
[[nodiscard]] std::size_t countSensors(const Conditions &conditions, SensorMeasures what);

/// Lets `change` alter that sensor, which is made when it is the next one. A sensor that says nothing more
/// and is the last of its kind goes.
void editSensor(Conditions &conditions, SensorMeasures what, std::size_t ordinal,
                const std::function<void(Sensor &)> &change);
void removeSensor(Conditions &conditions, SensorMeasures what, std::size_t ordinal);

/// State and text of a point to agree; null: nothing is declared of it, and it goes.
void setAgreedPoint(Test &test, const std::string &point, std::optional<AgreementState> state,
                    const std::string &text);

/// The number of an agreement (gradient, programmed feed) from the conditions, where they state one.
void takeAgreedValue(Test &test, std::string_view point);

/// Lets `change` alter the limit of a parameter; one without value, edition and source goes.
void editLimit(Test &test, const std::string &id, const std::function<void(Limit &)> &change);

} // namespace palmer
