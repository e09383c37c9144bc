// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

#include <QString>
#include <vector>

namespace palmer {

/// A fault of the machine that the program of the instrument states, beside the same of ours.
struct StatedSource {
    QString name; ///< as its file says: "AF_SQUARENESS"
    QString stated;
    QString statedUnit;
    QString source; ///< "Squareness X–Y"
    QString here;   ///< empty where the circle does not tell it
    QString u;
    QString unit;
    QString positive; ///< a sentence: what a positive value of ours means
};

/// Those of the results in the files a test came from that are known by their name. Their signs are what the
/// file says: it states no convention.
[[nodiscard]] std::vector<StatedSource> statedSources(const Test &test, const Diagnosis &diagnosis,
                                                      const Language &language);

} // namespace palmer
