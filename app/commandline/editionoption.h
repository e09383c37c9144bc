// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "document/document.h"
#include "kernel/evaluation/edition.h"

#include <optional>

namespace palmer {

/// The edition of this designation, as editionAsked(). Throws UsageError.
[[nodiscard]] const Edition *editionCalled(const QString &word, std::optional<Kind> kind = {});

/// The edition that --edition asks for, null without the option: its designation, or as much of it as leaves
/// no choice, in any case and with or without blanks ("2006", "iso230-4:2005", "VDI"). Throws UsageError with
/// the editions that it may be, of the kind if there is one.
[[nodiscard]] const Edition *editionAsked(const Invocation &invocation, std::optional<Kind> kind = {});

/// Throws UsageError where no test of the document is of the kind of the edition: it would change nothing.
void demandTestOf(const Edition &edition, const Document &document);

} // namespace palmer
