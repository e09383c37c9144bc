// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace palmer {

/// Identifies a machine, never shown.
struct MachineIdentity {
    QString key;
    bool isIdentified = true; ///< false: no serial number; all such machines of one maker and type share it
};

/// Compares maker and serial number without case, spaces and punctuation; without a maker the type replaces
/// it, as two makers may use equal numbers. Without a serial number: "not identified", per maker and type.
[[nodiscard]] MachineIdentity machineIdentity(const std::string &manufacturer, const std::string &model,
                                              const std::string &serialNumber);

/// Returns letters and digits only, in lower case.
[[nodiscard]] QString comparable(const QString &text);

} // namespace palmer
