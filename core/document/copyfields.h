// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/fields.h"

#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

/// Keys of the fields of a struct that have one of the demands; of all fields for `nothing`.
class FieldKeys {
public:
    explicit FieldKeys(unsigned demands = nothing)
        : m_demands(demands) {}

    template <class T>
    void operator()(const char *key, const T & /*member*/, unsigned demands = nothing) {
        if (m_demands == nothing || (demands & m_demands) != 0)
            m_keys.emplace_back(key);
    }
    void object(const char *key, const auto & /*members*/) { m_keys.emplace_back(key); }
    void extensions(const char *key, const std::string & /*member*/) { m_keys.emplace_back(key); }

    [[nodiscard]] std::vector<std::string_view> take() { return std::move(m_keys); }

private:
    unsigned m_demands;
    std::vector<std::string_view> m_keys;
};

enum class Copied {
    all,
    whatIsStated, ///< there
    whatIsMissing ///< here
};

template <class Struct>
void copyFields(Struct &to, const Struct &from, unsigned demands, Copied copied = Copied::all);

/// Two passes over the fields of one struct: the first records the addresses of its members, the second, over
/// another such struct, meets them in the same order.
class FieldCopier {
public:
    FieldCopier(unsigned demands, Copied copied)
        : m_demands(demands)
        , m_copied(copied) {}

    template <class T>
    void operator()(const char * /*key*/, T &member, unsigned demands = nothing) {
        using Member = std::remove_const_t<T>;
        if constexpr (!std::is_const_v<T>) {
            m_members.push_back(&member);
        } else {
            Member &to = *static_cast<Member *>(m_members[m_next++]);
            if (m_demands != nothing && (demands & m_demands) == 0) {
                if constexpr (requires { fields(std::declval<FieldKeys &>(), std::declval<Member &>()); })
                    copyFields(to, member, m_demands, m_copied);
            } else if (m_copied == Copied::whatIsMissing ? to == Member()
                                                         : m_copied == Copied::all || member != Member()) {
                to = member;
            }
        }
    }
    void object(const char * /*key*/, const auto & /*members*/) {}

private:
    unsigned m_demands;
    Copied m_copied;
    std::vector<void *> m_members;
    std::size_t m_next = 0;
};

/// Copies the fields with one of the demands, also in nested structs, and leaves the rest unchanged; all
/// fields of the struct for `nothing`.
template <class Struct>
void copyFields(Struct &to, const Struct &from, unsigned demands, Copied copied) {
    FieldCopier copier(demands, copied);
    fields(copier, to);
    fields(copier, from);
}

} // namespace palmer
