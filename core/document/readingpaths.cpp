// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/readingpaths.h"

#include "document/fields.h"

#include <algorithm>
#include <utility>

namespace palmer {

namespace {

constexpr std::string_view anyIndex = ".*";

template <class T>
constexpr bool isList = false;
template <class T>
constexpr bool isList<std::vector<T>> = true;

/// Collects the paths of the fields that hold readings.
class ReadingFields {
public:
    explicit ReadingFields(std::vector<std::string> &paths, std::string prefix = {})
        : m_paths(paths)
        , m_prefix(std::move(prefix)) {}

    template <class T>
    void operator()(std::string_view key, const T & /*member*/, unsigned demands = nothing) {
        const std::string path = m_prefix + std::string(key);
        if ((demands & reading) != 0)
            add(path + (isList<T> ? std::string(anyIndex) : std::string()));
        else
            look<T>(path);
    }
    void object(const char *, const auto &) {}
    void extensions(const char *, const std::string &) {}

private:
    template <class T>
    void look(const std::string &path) {
        if constexpr (isList<T>)
            look<typename T::value_type>(path + std::string(anyIndex));
        else if constexpr (requires(ReadingFields & visit, const T &value) { fields(visit, value); }) {
            ReadingFields inner(m_paths, path + '.');
            const T value{};
            fields(inner, value);
        }
    }

    void add(std::string path) {
        if (std::ranges::find(m_paths, path) == m_paths.end())
            m_paths.push_back(std::move(path));
    }

    std::vector<std::string> &m_paths;
    std::string m_prefix;
};

} // namespace

const std::vector<std::string> &readingPaths() {
    static const auto paths = [] {
        std::vector<std::string> found;
        ReadingFields visit(found);
        for (const Kind kind : allKinds) {
            const Test test = testOf(kind);
            fields(visit, test);
        }
        return found;
    }();
    return paths;
}

bool isListOfReadings(std::string_view key) {
    return std::ranges::any_of(readingPaths(), [key](std::string_view path) {
        if (!path.ends_with(anyIndex))
            return false;
        path.remove_suffix(anyIndex.size());
        return path.substr(path.rfind('.') + 1) == key;
    });
}

} // namespace palmer
