// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/finding.h"
#include "language/language.h"

#include <span>

namespace palmer {

/// One finding in words, as it is stored: its sentence, of practice with the remark that the text is not
/// available.
[[nodiscard]] QString findingText(const Finding &finding, const Language &language);

/// What a finding names, a point to be agreed with its letter; empty where its sentence stands for itself.
[[nodiscard]] QString findingName(const Finding &finding, const Language &language);

/// The sentences of several findings, one after the other; names that complete the same sentence stand in it
/// together, and it says how many they are. For lists whose headings say the source.
[[nodiscard]] QString findingsText(std::span<const Finding *const> findings, const Language &language);

} // namespace palmer
