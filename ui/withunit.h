// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace palmer::ui {

/// Joins a number that is a text already and its unit, as Language::quantity does: "5 µm", "5°".
[[nodiscard]] inline QString withUnit(const QString &number, const QString &unit) {
    const bool apart = !unit.isEmpty() && unit != QStringLiteral("°") && unit != QStringLiteral("″");
    return apart ? number + QChar(QChar::Nbsp) + unit : number + unit;
}

} // namespace palmer::ui
