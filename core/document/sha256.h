// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>
#include <string>

namespace palmer {

/// SHA-256 of a file: 64 hex digits in small letters, what `sha256sum` prints of it.
[[nodiscard]] std::string sha256(QByteArrayView bytes);

} // namespace palmer
