// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/jsonprinter.h"

#include <QByteArray>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

/// Members of a JSON object; they borrow the data they print.
class Members {
public:
    Members &text(std::string_view key, const std::string &value) {
        m_list.push_back({key, true, [&value](JsonPrinter &printer, const Place &) { printer.text(value); }});
        return *this;
    }
    Members &textOrNull(std::string_view key, const std::string &value) {
        return value.empty() ? word(key, "null") : text(key, value);
    }
    Members &textOrNull(std::string_view key, const std::optional<std::string> &value) {
        return value ? text(key, *value) : word(key, "null");
    }
    Members &quoted(std::string_view key, const char *value) {
        m_list.push_back({key, true, [value](JsonPrinter &printer, const Place &) { printer.text(value); }});
        return *this;
    }
    Members &number(std::string_view key, std::optional<double> value) {
        if (!value || !std::isfinite(*value))
            return word(key, "null");
        m_list.push_back({key, true, [v = *value](JsonPrinter &printer, const Place &place) {
                              printer.number(v, place);
                          }});
        return *this;
    }
    Members &whole(std::string_view key, int value) {
        m_list.push_back({key, true, [value](JsonPrinter &printer, const Place &) { printer.whole(value); }});
        return *this;
    }
    Members &word(std::string_view key, const char *value) {
        m_list.push_back({key, true, [value](JsonPrinter &printer, const Place &) { printer.word(value); }});
        return *this;
    }
    Members &object(std::string_view key, Members members) {
        m_list.push_back(
            {key, false, [list = std::move(members.m_list)](JsonPrinter &printer, const Place &place) {
                 printer.object(list, place);
             }});
        return *this;
    }
    Members &list(std::string_view key, std::vector<Members> members) {
        m_list.push_back(
            {key, false, [members = std::move(members)](JsonPrinter &printer, const Place &place) {
                 printer.list(members.size(),
                              [&](std::size_t i) { printer.object(members[i].m_list, place); });
             }});
        return *this;
    }
    [[nodiscard]] QByteArray line() const {
        JsonPrinter printer(JsonPrinter::Form::oneLine);
        printer.object(m_list, {});
        return printer.take() + '\n';
    }

private:
    std::vector<JsonMember> m_list;
};

} // namespace palmer
