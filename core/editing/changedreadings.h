// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "kernel/measurement/readingplace.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace palmer {

/// A few readings of one positioning test, all that tells two documents apart: what takes one to the other
/// without a copy of either.
struct ChangedReadings {
    struct Change {
        ReadingPlace place;
        std::optional<double> before; ///< mm or degrees
        std::optional<double> after;
    };
    std::size_t test = 0;
    std::vector<Change> changes;
};

/// Null where anything else differs, the test has fewer than `least` readings, or more than a thousandth of
/// them do.
[[nodiscard]] std::optional<ChangedReadings> changedReadings(const Document &before, const Document &after,
                                                             std::size_t least);

/// The document with the readings as they were before; as they are after. It has to have their test and
/// places.
[[nodiscard]] Document withReadingsBefore(Document document, const ChangedReadings &readings);
[[nodiscard]] Document withReadingsAfter(Document document, const ChangedReadings &readings);

} // namespace palmer
