// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

#include <QString>
#include <cstddef>

namespace palmer::ui {

/// The pages of the middle of the window: three of the report, the rest of a test.
enum class Page {
    identification,
    machine,
    instruments,
    readings,
    conditions,
    agreedPoints,
    limits,
    uncertainty,
    diagnosis ///< of circles: an interpretation
};

/// Where that of which a finding speaks is shown and will be edited.
/// That a test names no instrument is mended on its page of conditions, once the document has instruments.
[[nodiscard]] Page pageOf(const Finding &finding, const Document &document);

/// The field of its page that a finding speaks of, by the last part of its path; a point to be agreed by all
/// of it.
[[nodiscard]] QString fieldOf(const Finding &finding);

/// Number of what is not there on a page, statements, declarations or points: what badges count and F8 walks.
[[nodiscard]] int countMissing(const EvaluatedDocument &evaluated, std::size_t test, Page page);

} // namespace palmer::ui
