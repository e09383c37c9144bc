// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"

#include <span>
#include <string_view>

namespace palmer::iso230_2 {

/// Returns ISO 230-2 of 1988, 1997, 2006, 2014, VDI/DGQ 3441 and the national aliases.
[[nodiscard]] std::span<const Edition> editions();

/// The demands of the text of an edition. Requirements are in the order of the printed standard, followed by
/// good laboratory practice and rows of the program itself.
struct Demands {
    std::string_view text; ///< word of the edition: "ISO 230-2:1988"
    std::span<const Requirement> requirements;
    std::span<const AgreementPoint> points = {};
};

/// Returns the demands of a text. Precondition: requirements.cpp has a row for it.
[[nodiscard]] const Demands &demandsOf(std::string_view text);

} // namespace palmer::iso230_2
