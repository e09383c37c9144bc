// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <QString>
#include <vector>

namespace palmer {

/// A page of the help. Its headings carry the anchors for F1.
struct HelpPage {
    QString id; ///< "workflow", "keys", "fields", "editions.ISO 230-2:2006", "circles", "validation"
    QString title;
    Report content;
};

/// The help in one language: workflow, keys, meaning of each field, and for each edition every symbol with
/// name, formula and clause, from the program's tables. Anchors: for fields the key in the file ("sensors"),
/// for symbols the id of the parameter ("R+").
[[nodiscard]] std::vector<HelpPage> composeHelp(const Language &language);

} // namespace palmer
