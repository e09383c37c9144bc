// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace palmer::laws {

using Json = nlohmann::json;

/// Keys from the file down to a value: "tests", "0", "conditions", "feed".
using Path = std::vector<std::string>;

[[nodiscard]] std::string joined(const Path &path);

/// Makes test files from the JSON schema: a key that is added there is generated from then on. Numbers, words
/// and texts are the schema's; the measurement and what ties fields together (ids, lengths of lists, `from`
/// below `to`) is made here, so that each kind of test has its maker. Every text is unique in its file, so
/// that it can be looked for on a page.
class Generator {
public:
    /// Throws std::logic_error for a kind of test in the schema that is not made here.
    Generator(Json schema, std::uint64_t seed);

    /// A file with one to three tests of any kind, edition, direction and number of runs; each of its fields
    /// is stated, null or absent.
    [[nodiscard]] Json file();

    /// What may be left out or null without taking away what was measured or asked for: the paths of all
    /// fields of `file` that the law of silence holds for.
    [[nodiscard]] std::vector<Path> statements(const Json &file) const;

    /// True if the schema allows null at the path.
    [[nodiscard]] bool mayBeNull(const Path &path, const Json &file) const;

private:
    [[nodiscard]] const Json &resolved(const Json &schema) const;
    [[nodiscard]] Json value(const Json &schema, const std::string &key);
    [[nodiscard]] Json object(const Json &schema);
    [[nodiscard]] Json text(std::size_t most);
    [[nodiscard]] double number(const std::string &key);
    [[nodiscard]] Json agreedPoints(const Json &schema);
    [[nodiscard]] Json limits(const Json &schema, double scale);
    [[nodiscard]] Json positioning();
    [[nodiscard]] Json circular();
    [[nodiscard]] Json drift();
    [[nodiscard]] Json anyTest();
    void checkSheet(Json &report);
    void measureAxis(Json &test);
    void measurePaths(Json &test);
    [[nodiscard]] const Json *schemaAt(const Path &path, const Json &file) const;

    [[nodiscard]] bool chance(double probability) { return m_uniform(m_random) < probability; }
    [[nodiscard]] double between(double from, double to) { return from + (to - from) * m_uniform(m_random); }
    [[nodiscard]] int below(int count) { return static_cast<int>(between(0, count)); }
    template <class List>
    [[nodiscard]] const auto &anyOf(const List &list) {
        return list[static_cast<std::size_t>(below(static_cast<int>(list.size())))];
    }

    /// Makes the measurements of a kind; the shares in all tests add up to 1.
    struct Maker {
        std::string_view kind;
        double share = 0;
        Json (Generator::*make)() = nullptr;
    };
    static const std::array<Maker, 3> makers;

    Json m_schema;
    std::mt19937_64 m_random;
    std::uniform_real_distribution<double> m_uniform{0, 1};
    int m_texts = 0;
};

} // namespace palmer::laws
