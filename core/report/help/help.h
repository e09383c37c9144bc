// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/edition.h"
#include "language/language.h"
#include "report/blocks/report.h"
#include "validation/validation.h"

#include <QString>
#include <vector>

namespace palmer {

/// A page of the help. Headings carry the anchors that F1 goes to.
struct HelpPage {
    QString id; ///< "workflow", "keys", "fields", "editions.ISO 230-2:2006", "circles", "validation"
    QString title;
    Report content;
};

/// The help in one language: the workflow, the keys, what each field means, and for each edition every symbol
/// with its name, formula and clause as the tables of the program have them. Anchors: of fields the key in
/// the file ("sensors"), of symbols the id of the parameter ("R+").
[[nodiscard]] std::vector<HelpPage> composeHelp(const Language &language);

/// The page of the reference data, whose computing takes a moment.
[[nodiscard]] HelpPage composeValidationHelp(const std::vector<SetValidation> &sets,
                                             const Language &language);

/// What the field of that key in the file means and who asks for it; empty for a key that is not explained.
[[nodiscard]] QString fieldHelp(std::string_view key, const Language &language);

} // namespace palmer
