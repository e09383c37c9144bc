// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/jsonformats.h"

#include "document/fileversion.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <nlohmann/json.hpp>

namespace palmer {

namespace {

// clang-format off
constexpr std::array formats{
    JsonFormat{"results", "palmer results", 1, "palmer-results", "evaluate --json"},
    JsonFormat{"findings", "palmer findings", 1, "palmer-results", "check --json"},
    JsonFormat{"readings", "palmer results", 1, "palmer-results", "export --as json"},
    JsonFormat{"verification", "palmer verification", 1, "palmer-verification", "verify --json"},
    JsonFormat{"explanation", "palmer explanation", 1, "palmer-explanation", "explain --json"},
    JsonFormat{"comparison", "palmer comparison", 1, "palmer-comparison", "compare --json"},
    JsonFormat{"import", "palmer import", 1, "palmer-import", "import --json"},
    JsonFormat{"targets", "palmer targets", 1, "palmer-targets", "targets --json"},
    JsonFormat{"feed", "palmer feed", 1, "palmer-feed", "feed --json"},
    JsonFormat{"truth", "palmer truth", 1, "palmer-truth", "synthesize --truth"},
    JsonFormat{"scan", "palmer scan", 1, "palmer-scan", "register scan --json"},
    JsonFormat{"list", "palmer register test", 1, "palmer-list", "register list --json"},
    JsonFormat{"trend", "palmer trend", 1, "palmer-trend", "register trend --json"},
    JsonFormat{"history", "palmer history", 1, "palmer-history", "register report"},
    JsonFormat{"type", "palmer type test", 1, "palmer-type", "register type --json"},
    JsonFormat{"selftest", "palmer validation", 1, "palmer-validation", "selftest --json"},
    JsonFormat{"error", "palmer error", 1, "palmer-error", "evaluate --json-lines"},
    JsonFormat{"test", fileFormat, fileVersion, "palmer", "import -o"},
    JsonFormat{"test-2", fileFormat, 2, "palmer", "import -o"},
    JsonFormat{"test-1", fileFormat, 1, "palmer", "import -o"},
    JsonFormat{"machines", "palmer machines", 1, "palmer-machines", "register interval"},
    JsonFormat{"reference", "palmer reference data", 1, "palmer-reference", ""}};
// clang-format on

} // namespace

std::span<const JsonFormat> jsonFormats() {
    return formats;
}

const JsonFormat *findJsonFormat(std::string_view name) {
    const auto found = std::ranges::find(formats, name, &JsonFormat::name);
    return found == formats.end() ? nullptr : &*found;
}

std::string schemaFile(const JsonFormat &format) {
    return std::string(format.schema) + '-' + std::to_string(format.version) + ".schema.json";
}

nlohmann::ordered_json jsonHead(std::string_view name) {
    const JsonFormat *row = findJsonFormat(name);
    assert(row);
    return {{"format", row->format}, {"version", row->version}};
}

} // namespace palmer
