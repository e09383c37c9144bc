// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace palmer {

/// The fields of a machine as files state them.
struct MachineFields {
    QString name;
    QString manufacturer;
    QString model;
    QString serialNumber;
};

/// Identifies a machine by maker and serial number, without a maker by type and serial number, as two makers
/// may use equal numbers; without a serial number by all of its fields. Texts are compared without case,
/// blanks at the ends dropped and several blanks as one; nothing else is alike. Never shown.
[[nodiscard]] QString machineIdentity(const MachineFields &machine);

/// False for the identity of a machine without serial number: "-" and the like are none.
[[nodiscard]] bool isIdentified(const QString &identity);

/// Returns the text as identities compare it.
[[nodiscard]] QString asCompared(const QString &text);

/// For searching, never for telling apart: letters and digits only, in lower case.
[[nodiscard]] QString comparable(const QString &text);

} // namespace palmer
