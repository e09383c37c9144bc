// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/machineidentity.h"

namespace palmer {

QString comparable(const QString &text) {
    QString result;
    for (const QChar c : text.normalized(QString::NormalizationForm_KC).toCaseFolded()) {
        if (c.isLetterOrNumber() || c.isSurrogate() || c.isMark())
            result += c;
    }
    return result;
}

MachineIdentity machineIdentity(const std::string &manufacturer, const std::string &model,
                                const std::string &serialNumber) {
    const QString maker = comparable(QString::fromStdString(manufacturer));
    const QString type = comparable(QString::fromStdString(model));
    const QString serial = comparable(QString::fromStdString(serialNumber));
    if (serial.isEmpty())
        return {QStringLiteral("?/") + maker + u'/' + type, false};
    if (maker.isEmpty())
        return {QStringLiteral("-/") + type + u'/' + serial, true};
    return {QStringLiteral("+/") + maker + u'/' + serial, true};
}

} // namespace palmer
