// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/readinglists.h"

#include "document/fields.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace palmer {

namespace {

template <class T>
constexpr bool isList = false;
template <class T>
constexpr bool isList<std::vector<T>> = true;

/// Collects the keys of the lists that hold readings.
class ReadingLists {
public:
    std::set<std::string, std::less<>> keys;

    template <class T>
    void operator()(const char *key, const T & /*member*/, unsigned demands = nothing) {
        if ((demands & reading) != 0 && isList<T>)
            keys.insert(key);
        else
            look<T>();
    }
    void object(const char *, const auto &) {}
    void extensions(const char *, const std::string &) {}

private:
    template <class T>
    void look() {
        if constexpr (isList<T>)
            look<typename T::value_type>();
        else if constexpr (requires(ReadingLists & visit, const T &value) { fields(visit, value); }) {
            const T value{};
            fields(*this, value);
        }
    }
};

} // namespace

bool isListOfReadings(std::string_view key) {
    static const auto keys = [] {
        ReadingLists visit;
        for (const Kind kind : allKinds) {
            const Test test = testOf(kind);
            fields(visit, test);
        }
        return visit.keys;
    }();
    return keys.contains(key);
}

} // namespace palmer
