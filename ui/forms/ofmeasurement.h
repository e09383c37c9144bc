// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/member.h"

namespace palmer::ui {

/// A member of the measurement of one kind of test, or of a part of it.
template <class Measurement, auto... members>
[[nodiscard]] auto ofMeasurement() {
    return ofTest([](auto &test) {
        auto *measurement = std::get_if<Measurement>(&test.measurement);
        return measurement ? &reach(*measurement, members...) : nullptr;
    });
}

} // namespace palmer::ui
