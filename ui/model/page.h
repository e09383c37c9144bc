// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "kernel/evaluation/accordance.h"

#include <QString>
#include <cstddef>

namespace palmer::ui {

/// The pages in the middle of the window: the first four belong to the report, the others to a test.
enum class Page {
    identification,
    machine,
    instruments,
    sheet, ///< the acceptance sheet
    readings,
    conditions,
    agreedPoints,
    limits,
    uncertainty,
    comparison, ///< with another test: interpretation
    diagnosis,  ///< circular tests only: interpretation
    thermal     ///< drift tests only: interpretation
};

/// Returns the page that shows and edits the subject of a finding.
/// Missing instruments of a test are added on its conditions page once the document has instruments.
[[nodiscard]] Page pageOf(const Finding &finding, const Document &document);

/// The field of a finding: the last part of its path, or the whole path of a point to be agreed.
[[nodiscard]] QString fieldOf(const Finding &finding);

/// Number of findings of a page that lack something required, as counted by badges and visited by F8, or
/// usual only.
[[nodiscard]] int countMissing(const EvaluatedDocument &evaluated, std::size_t test, Page page,
                               Lack lack = Lack::required);

/// The same for the whole document: what all tests share counts once.
[[nodiscard]] int countMissing(const EvaluatedDocument &evaluated);

} // namespace palmer::ui
