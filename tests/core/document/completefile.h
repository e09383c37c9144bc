// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

/// A valid test file in which every key is stated, mostly with another value than its default.
inline QByteArray completeFile() {
    QFile file(QStringLiteral(PALMER_SOURCE_DIR "/tests/data/complete.palmer"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
