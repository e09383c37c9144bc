// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

#include <QString>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace palmer::ui {

/// Indices of the targets that determine a parameter of a test, without repetition; empty if the test has no
/// such parameter. `id` as in parameterId.
[[nodiscard]] inline std::vector<std::size_t> rulingTargets(const EvaluatedDocument &evaluated,
                                                            std::size_t test, const QString &id) {
    std::vector<std::size_t> targets;
    if (test >= evaluated.tests.size() || id.isEmpty())
        return targets;
    for (const Parameter &parameter : evaluated.tests[test]->parameters) {
        if (QString::fromStdString(parameterId(parameter)) != id)
            continue;
        for (const auto &ruling : parameter.ruling) {
            if (!ruling)
                continue;
            const auto target = static_cast<std::size_t>(ruling->target) - 1;
            if (std::ranges::find(targets, target) == targets.end())
                targets.push_back(target);
        }
    }
    return targets;
}

} // namespace palmer::ui
