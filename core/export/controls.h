// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "export/compensation.h"
#include "export/partprogram.h"

#include <optional>
#include <string_view>

namespace palmer {

/// The dialect that a machine's control reads; null where it is not known.
struct ControlFormats {
    std::optional<Dialect> program;
    std::optional<CompensationFormat> compensation;
};

/// Recognises a control as it is stated of a machine: "SINUMERIK 840D sl", "Heidenhain TNC 640".
[[nodiscard]] ControlFormats formatsOfControl(std::string_view controller);

} // namespace palmer
