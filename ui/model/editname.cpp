// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/editname.h"

#include <QCoreApplication>
#include <QStringList>

namespace palmer::ui {

namespace {

constexpr char separator = '\x1f'; // ASCII unit separator, which no text contains

} // namespace

QByteArray changeOf(const char *context, const char *label, const QString &argument) {
    return QByteArray(context) + separator + label + separator + argument.toUtf8();
}

std::optional<EditPlace> editPlace(const QString &source) {
    const QStringList parts = source.split(QLatin1Char(separator));
    return parts.size() < 3 ? std::nullopt : std::optional(EditPlace{parts[0], parts[1].toUtf8(), parts[2]});
}

QByteArray countedEdit(const char *source, int count) {
    return QByteArray(source) + separator + QByteArray::number(count);
}

QString editName(const QString &source) {
    const QStringList parts = source.split(QLatin1Char(separator));
    if (parts.size() == 2)
        return QCoreApplication::translate("edits", parts[0].toUtf8().constData(), nullptr, parts[1].toInt());
    if (parts.size() < 3)
        return QCoreApplication::translate("edits", source.toUtf8().constData());
    QString label = QCoreApplication::translate(parts[0].toUtf8().constData(), parts[1].toUtf8().constData());
    if (!parts[2].isEmpty())
        label = label.arg(parts[2]);
    return QCoreApplication::translate("edits", "change “%1”").arg(label);
}

} // namespace palmer::ui
