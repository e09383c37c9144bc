// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <QString>

namespace palmer {

/// True if the name is that of a test file: it ends in .palmer, in any case.
[[nodiscard]] bool isTestFileName(const QString &name);

/// True if a file is a test file or a report, which are opened and never imported: by its name, or by its
/// content: JSON, PDF, or keys of a test file anywhere (the beginning may be missing or preceded by something
/// else), in any encoding that shows ASCII. Damaged files count, too: their readings without their limits
/// would be another measurement.
[[nodiscard]] bool isTestFile(QByteArrayView bytes, const QString &name = {});

/// For writers of other formats: throws Error(unwritable) if the name is that of a test file.
void requireNoTestFileName(const QString &name);

} // namespace palmer
