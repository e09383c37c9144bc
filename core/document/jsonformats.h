// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <string_view>

namespace palmer {

/// A JSON text that the program writes, with a schema in resources/schema. The command `schema`, its
/// completion and the test that validates every output are made from these rows: another output is a row and
/// a schema.
struct JsonFormat {
    const char *name;    ///< "results", for `palmer-cli schema`
    const char *format;  ///< "palmer results": the value of its key `format`
    int version;         ///< counts incompatible changes; new keys are none
    const char *schema;  ///< name of the file without version: "palmer-results"
    const char *command; ///< writes it
};

[[nodiscard]] std::span<const JsonFormat> jsonFormats();

/// Returns the row of that name; null if there is none.
[[nodiscard]] const JsonFormat *findJsonFormat(std::string_view name);

/// Returns "palmer-results-1.schema.json".
[[nodiscard]] std::string schemaFile(const JsonFormat &format);

/// Returns {"format": "palmer results", "version": 1}. Precondition: there is a row of that name.
[[nodiscard]] nlohmann::ordered_json jsonHead(std::string_view name);

} // namespace palmer
