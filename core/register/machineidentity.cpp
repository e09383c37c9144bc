// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/machineidentity.h"

#include <QStringList>

namespace palmer {

QString comparable(const QString &text) {
    QString result;
    for (const QChar c : text.normalized(QString::NormalizationForm_KC).toCaseFolded()) {
        if (c.isLetterOrNumber() || c.isSurrogate() || c.isMark())
            result += c;
    }
    return result;
}

QString asCompared(const QString &text) {
    return text.toCaseFolded().simplified();
}

QString machineIdentity(const MachineFields &machine) {
    QStringList parts{machine.manufacturer, machine.serialNumber};
    QString sign = QStringLiteral("+");
    if (comparable(machine.serialNumber).isEmpty()) {
        parts << machine.name << machine.model;
        sign = QStringLiteral("?");
    } else if (asCompared(machine.manufacturer).isEmpty()) {
        parts << machine.model;
        sign = QStringLiteral("-");
    }
    for (QString &part : parts)
        part = asCompared(part);
    return sign + parts.join(u'\n'); // compared texts have no line breaks
}

bool isIdentified(const QString &identity) {
    return !identity.startsWith(u'?');
}

} // namespace palmer
