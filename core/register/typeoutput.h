// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "language/language.h"
#include "register/machinetype.h"
#include "report/blocks/report.h"

#include <QByteArray>

namespace palmer {

/// Returns the type test as one line of JSON (palmer-type-1.schema.json); values in mm or degrees.
[[nodiscard]] QByteArray typeTestJson(const TypeTest &test);

/// Returns a readable report: the limits, then the machines with their values and U.
[[nodiscard]] Report composeTypeTest(const TypeTest &test, const Language &language);

} // namespace palmer
