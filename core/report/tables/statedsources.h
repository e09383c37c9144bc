// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "kernel/measurement/test.h"
#include "language/language.h"

#include <QString>
#include <vector>

namespace palmer {

/// A machine fault stated by the program of the instrument, compared with our own diagnosis.
struct StatedSource {
    QString name; ///< as in its file: "AF_SQUARENESS"
    QString stated;
    QString statedUnit;
    QString source; ///< "Squareness X–Y"
    QString here;   ///< empty if the circle does not determine it
    QString u;
    QString unit;
    QString positive; ///< a sentence: meaning of a positive value of ours
};

/// Results of the imported files of a test that are recognised by name. Their signs are those of the file,
/// which states no convention.
[[nodiscard]] std::vector<StatedSource> statedSources(const Test &test, const Diagnosis &diagnosis,
                                                      const Language &language);

} // namespace palmer
