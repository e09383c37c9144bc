// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <QString>

namespace palmer {

/// Whether the name is that of a test file: it ends in .palmer, in capitals or not.
[[nodiscard]] bool isTestFileName(const QString &name);

/// Whether a file is a test file or a report, which are opened and never imported: by its name, or by what is
/// in it: JSON, PDF, keys of a test file anywhere (the beginning is missing, or something else stands before
/// it), in any encoding in which ASCII can be told. What is damaged is one all the same: its readings without
/// their limits would be another measurement.
[[nodiscard]] bool isTestFile(QByteArrayView bytes, const QString &name = {});

/// For whoever writes something else: throws Error(unwritable) when the name is that of a test file.
void demandNoTestFileName(const QString &name);

} // namespace palmer
