// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace palmer {

/// Whether the bytes are a picture as a report can carry: a PNG whose parts are whole (length, check sum, the
/// beginning of its compressed data), or XML whose root is svg. The pixels are not unpacked.
[[nodiscard]] bool isPicture(const QByteArray &bytes);

} // namespace palmer
