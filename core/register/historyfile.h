// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/history.h"

#include <QByteArray>

namespace palmer {

/// Returns the data of a printed history, "palmer history": all that composeHistory() uses, with the values,
/// U, dates and fingerprints of the tests; of their files only the names.
[[nodiscard]] QByteArray historyJson(const History &history);

/// Reads them. Throws Error: no such file, or a value that no register writes.
[[nodiscard]] History historyFrom(const QByteArray &json);

/// Composes the history that a PDF carries.
[[nodiscard]] Report composeHistoryFile(const QByteArray &json, const Language &language);

} // namespace palmer
