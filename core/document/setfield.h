// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/documenterror.h"

#include <string_view>

namespace palmer {

/// Returns the document with a value set at a path of its file: "machine.name", "tests[0].limits.A.value"; a
/// path that does not begin with a key of the file applies to every test that it fits ("limits.A.value").
/// Indices count from 0; one after the last appends. The value is that of the file: a number (also with a
/// comma), true, false, null, a text, an object or a list; the type of the field decides, so "0815" as a
/// serial number is a text. A number may have a unit that fits its field: "500 mm", "2 m/min", "22.5 °C"; in
/// an object or list it is a text then. A length or angle shown in µm or arc seconds in the window needs one:
/// "20 um", "0.02 mm", "5 arcsec"; except 0. Throws Error with place and expectation for a path or value
/// unknown to the file, and for a value that its statement cannot have.
[[nodiscard]] Document withField(const Document &document, std::string_view path, std::string_view value);

/// True if a path begins with a key of a file or of a test of some kind.
[[nodiscard]] bool beginsAsField(std::string_view path);

/// True if the commas of a number may separate thousands: "1,000" is a thousand or one, "0,125" is clear.
[[nodiscard]] bool mayBeGrouped(std::string_view number);

} // namespace palmer
