// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace palmer {

/// True if the bytes are a picture a report can contain: a PNG with intact parts (length, check sum, start of
/// its compressed data), or XML with root svg. The pixels are not decompressed.
[[nodiscard]] bool isPicture(const QByteArray &bytes);

} // namespace palmer
