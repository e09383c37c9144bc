// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace palmer {

namespace {

template <class Json>
bool isOneValue(const Json &value) {
    return !value.is_structured();
}

template <class Json>
bool isSmall(const Json &value) {
    return isOneValue(value) || value.empty() ||
           (value.is_array() && JsonPrinter::isSmallList(value.size()) &&
            std::all_of(value.begin(), value.end(), isOneValue<Json>));
}

template <class Json>
void printTree(JsonPrinter &printer, const Json &value, const Place &place);

template <class Json>
std::vector<JsonMember> membersOfTree(const Json &object) {
    std::vector<JsonMember> members;
    for (const auto &[key, member] : object.template get_ref<const typename Json::object_t &>())
        members.push_back({key, isSmall(member),
                           [&each = member](JsonPrinter &to, const Place &at) { printTree(to, each, at); }});
    return members;
}

template <class Json>
void printTree(JsonPrinter &printer, const Json &value, const Place &place) {
    switch (value.type()) {
    case Json::value_t::object:
        return printer.object(membersOfTree(value), place);
    case Json::value_t::array: {
        const auto print = [&](JsonPrinter &to, std::size_t i) { printTree(to, value[i], Place(place, i)); };
        if (std::all_of(value.begin(), value.end(), isOneValue<Json>))
            return printer.listOfScalars(value.size(), print);
        return printer.list(value.size(), [&](std::size_t i) { print(printer, i); });
    }
    case Json::value_t::number_float:
        return printer.number(value.template get<double>(), place);
    case Json::value_t::number_integer:
        return printer.whole(value.template get<std::int64_t>());
    case Json::value_t::number_unsigned:
        return printer.whole(value.template get<std::uint64_t>());
    case Json::value_t::string:
        return printer.text(value.template get_ref<const std::string &>());
    case Json::value_t::boolean:
        return printer.word(value.template get<bool>() ? "true" : "false");
    default:
        printer.word("null");
    }
}

template <class Json>
std::string printed(const Json &value, JsonPrinter::Form form) {
    JsonPrinter printer(form);
    printTree(printer, value, {});
    return printer.take().toStdString();
}

} // namespace

void printValue(JsonPrinter &printer, const nlohmann::ordered_json &value, const Place &place) {
    printTree(printer, value, place);
}

std::vector<JsonMember> membersOf(const nlohmann::ordered_json &object) {
    return membersOfTree(object);
}

JsonMember jsonMember(std::string_view key, nlohmann::json value) {
    const bool small = isSmall(value);
    return {key, small, [value = std::move(value)](JsonPrinter &printer, const Place &place) {
                printTree(printer, value, place);
            }};
}

nlohmann::ordered_json numberOrNull(std::optional<double> value) {
    return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

std::string compactJson(const nlohmann::json &value) {
    return printed(value, JsonPrinter::Form::oneLine);
}

std::string compactJson(const nlohmann::ordered_json &value) {
    return printed(value, JsonPrinter::Form::oneLine);
}

std::string printJson(const nlohmann::json &value) {
    return printed(value, JsonPrinter::Form::lines) + '\n';
}

std::string printJson(const nlohmann::ordered_json &value) {
    return printed(value, JsonPrinter::Form::lines) + '\n';
}

} // namespace palmer
