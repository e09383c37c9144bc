// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <string>

namespace palmer {

/// Returns the SHA-256 of a file: 64 lower-case hex digits, as `sha256sum` prints it.
[[nodiscard]] std::string sha256(QByteArrayView bytes);

} // namespace palmer
