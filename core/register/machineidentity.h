// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace palmer {

/// What tells machines apart, never shown.
struct MachineIdentity {
    QString key;
    bool isIdentified = true; ///< false: no serial number; all such machines of a maker and type have one key
};

/// Maker and serial number, compared without case, spaces and punctuation; without a maker the type stands in
/// its place, for two makers may count alike. Without a serial number: "not identified", per maker and type.
[[nodiscard]] MachineIdentity machineIdentity(const std::string &manufacturer, const std::string &model,
                                              const std::string &serialNumber);

/// Letters and digits alone, in lower case.
[[nodiscard]] QString comparable(const QString &text);

} // namespace palmer
