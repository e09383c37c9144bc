// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <string_view>

namespace palmer {

/// The document with a value at a path of its file: "machine.name", "tests[0].limits.A.value"; a path that
/// begins with no key of the file is that of every test ("limits.A.value"). Elements count from 0; one behind
/// the last is added. The value is what the file would hold there, a number (also with a comma), true, false,
/// null or a text; what the field takes decides, "0815" of a serial number is a text. A length or angle that
/// the window shows in µm or arc seconds says its unit: "20 um", "0.02 mm", "5 arcsec"; only 0 needs none.
/// Throws Error for a path or value that the file does not know, with the place and what is expected there.
[[nodiscard]] Document withField(const Document &document, std::string_view path, std::string_view value);

/// Whether a path begins with a key that a file or a test of some kind has.
[[nodiscard]] bool beginsAsField(std::string_view path);

} // namespace palmer
