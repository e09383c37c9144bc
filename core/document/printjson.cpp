#include "document/documenterror.h"
#include "document/json.h"
#include "document/place.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace palmer {

namespace {

constexpr std::size_t lineLength = 100;
constexpr std::size_t indentation = 2;

void appendNumber(std::string &text, double value, const Place &place) {
    if (!std::isfinite(value))
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "a file cannot hold a number that is not finite"), {}, {}},
                    place.text());
    std::array<char, 64> digits{};
    const double size = std::abs(value);
    // Positions and deviations as people write them; an exponent only beyond.
    const bool plain = size == 0 || (size >= 1e-7 && size < 1e15);
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), size == 0 ? 0.0 : value,
                                   plain ? std::chars_format::fixed : std::chars_format::scientific);
    text.append(digits.data(), end.ptr);
}

void appendInteger(std::string &text, auto value) {
    std::array<char, 24> digits{};
    text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

template <class Json>
void appendScalar(std::string &text, const Json &value, const Place &place) {
    switch (value.type()) {
    case Json::value_t::number_float:
        return appendNumber(text, value.template get<double>(), place);
    case Json::value_t::number_integer:
        return appendInteger(text, value.template get<std::int64_t>());
    case Json::value_t::number_unsigned:
        return appendInteger(text, value.template get<std::uint64_t>());
    default:
        text += value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    }
}

void appendKey(std::string &text, const std::string &key) {
    text += nlohmann::json(key).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + ": ";
}

template <class Json>
void appendCompact(std::string &text, const Json &value, const Place &place) {
    const char *separator = "";
    if (value.is_object()) {
        text += '{';
        for (const auto &[key, member] : value.template get_ref<const typename Json::object_t &>()) {
            text += separator;
            appendKey(text, key);
            appendCompact(text, member, Place(place, key));
            separator = ", ";
        }
        text += '}';
    } else if (value.is_array()) {
        text += '[';
        for (std::size_t i = 0; i < value.size(); ++i) {
            text += separator;
            appendCompact(text, value[i], Place(place, i));
            separator = ", ";
        }
        text += ']';
    } else {
        appendScalar(text, value, place);
    }
}

template <class Json>
bool isScalar(const Json &value) {
    return !value.is_structured();
}

// Worth the attempt to print it within a line: a scalar, or a short list of them.
template <class Json>
bool isSmall(const Json &value) {
    return isScalar(value) || value.empty() ||
           (value.is_array() && value.size() < lineLength / 2 &&
            std::all_of(value.begin(), value.end(), isScalar<Json>));
}

template <class Json>
class Printer {
public:
    std::string take() { return std::move(m_text); }

    void print(const Json &value, std::size_t indent, const Place &place) {
        if (value.is_object())
            printObject(value.template get_ref<const typename Json::object_t &>(), indent, place);
        else if (value.is_array())
            printArray(value.template get_ref<const typename Json::array_t &>(), indent, place);
        else
            appendScalar(m_text, value, place);
    }

private:
    void newLine(std::size_t indent) {
        m_text += '\n';
        m_lineBegin = m_text.size();
        m_text.append(indent, ' ');
    }

    [[nodiscard]] std::size_t column() const { return m_text.size() - m_lineBegin; }

    void printObject(const typename Json::object_t &object, std::size_t indent, const Place &place) {
        const bool small = indent > 0 && std::all_of(object.begin(), object.end(), [](const auto &member) {
                               return isSmall(member.second);
                           });
        if (object.empty()) {
            m_text += "{}";
            return;
        }
        if (small && printOnOneLine(object, place))
            return;
        m_text += '{';
        const char *separator = "";
        for (const auto &[key, member] : object) {
            m_text += separator;
            newLine(indent + indentation);
            appendKey(m_text, key);
            print(member, indent + indentation, Place(place, key));
            separator = ",";
        }
        newLine(indent);
        m_text += '}';
    }

    bool printOnOneLine(const Json &object, const Place &place) {
        const std::size_t begin = m_text.size();
        appendCompact(m_text, object, place);
        if (column() < lineLength)
            return true;
        m_text.resize(begin);
        return false;
    }

    void printArray(const typename Json::array_t &array, std::size_t indent, const Place &place) {
        const bool scalars = std::all_of(array.begin(), array.end(), isScalar<Json>);
        if (array.empty()) {
            m_text += "[]";
        } else if (!scalars) {
            m_text += '[';
            for (std::size_t i = 0; i < array.size(); ++i) {
                m_text += i > 0 ? "," : "";
                newLine(indent + indentation);
                print(array[i], indent + indentation, Place(place, i));
            }
            newLine(indent);
            m_text += ']';
        } else if (!printScalars(array, std::nullopt, place)) {
            printScalars(array, indent, place);
        }
    }

    // Without indent: on the rest of this line, if they fit; else on lines of their own, filled.
    bool printScalars(const typename Json::array_t &array, std::optional<std::size_t> indent,
                      const Place &place) {
        const std::size_t begin = m_text.size();
        m_text += '[';
        if (indent)
            newLine(*indent + indentation);
        for (std::size_t i = 0; i < array.size(); ++i) {
            const std::size_t elementBegin = m_text.size();
            m_text += i > 0 ? ", " : "";
            appendScalar(m_text, array[i], Place(place, i));
            if (column() < lineLength)
                continue;
            if (!indent) {
                m_text.resize(begin);
                return false;
            }
            if (i == 0)
                continue;
            const std::string element = m_text.substr(elementBegin + 2);
            m_text.resize(elementBegin);
            m_text += ',';
            newLine(*indent + indentation);
            m_text += element;
        }
        if (indent)
            newLine(*indent);
        m_text += ']';
        return true;
    }

    std::string m_text;
    std::size_t m_lineBegin = 0;
};

} // namespace

std::string compactJson(const nlohmann::json &value) {
    std::string text;
    appendCompact(text, value, {});
    return text;
}

std::string compactJson(const nlohmann::ordered_json &value) {
    std::string text;
    appendCompact(text, value, {});
    return text;
}

std::string printJson(const nlohmann::json &value) {
    Printer<nlohmann::json> printer;
    printer.print(value, 0, {});
    return printer.take() + '\n';
}

std::string printJson(const nlohmann::ordered_json &value) {
    Printer<nlohmann::ordered_json> printer;
    printer.print(value, 0, {});
    return printer.take() + '\n';
}

} // namespace palmer
