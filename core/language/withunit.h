// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace palmer {

/// Joins a printed number and the sign of its unit: "5 µm", "5°". Degree and arc second signs are
/// superscripts without a space before them in both languages (SI brochure 5.4.3).
[[nodiscard]] inline QString withUnit(const QString &number, const QString &sign) {
    const bool apart = !sign.isEmpty() && sign != u"°" && sign != u"″";
    return apart ? number + QChar(QChar::Nbsp) + sign : number + sign;
}

} // namespace palmer
