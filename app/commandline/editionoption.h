// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "document/document.h"
#include "kernel/evaluation/edition.h"

#include <optional>

namespace palmer {

/// Returns the edition with this designation, like editionAsked(). Throws UsageError.
[[nodiscard]] const Edition *editionCalled(const QString &word, std::optional<Kind> kind = {});

/// The edition of --edition, null without the option: its designation or an unambiguous part of it, in any
/// case, with or without blanks ("2006", "iso230-4:2005", "VDI"). Throws UsageError with the possible
/// editions, of the given kind if any.
[[nodiscard]] const Edition *editionAsked(const Invocation &invocation, std::optional<Kind> kind = {});

/// Throws UsageError if no test has the kind of the edition, which would then have no effect.
void demandTestOf(const Edition &edition, const Document &document);

} // namespace palmer
