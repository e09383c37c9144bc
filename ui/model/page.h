#pragma once

#include "document/evaluateddocument.h"

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
    uncertainty
};

/// Where that of which a finding speaks is shown and will be edited.
/// That a test names no instrument is mended on its page of conditions, once the document has instruments.
[[nodiscard]] Page pageOf(const Finding &finding, const Edition *edition, const Document &document);

/// Whether the finding is a statement the report needs, or a point to agree, that is not there: what badges
/// count and F8 walks.
[[nodiscard]] bool isMissing(const Finding &finding, const Edition *edition);

/// Number of missing statements (or points) of a page.
[[nodiscard]] int countMissing(const EvaluatedDocument &evaluated, std::size_t test, Page page);

} // namespace palmer::ui
