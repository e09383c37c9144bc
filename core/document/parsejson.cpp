#include "document/documenterror.h"
#include "document/json.h"
#include "document/place.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace palmer {

namespace {

using nlohmann::json;

constexpr std::size_t depthLimit = 64;
constexpr std::size_t readingLimit = 10'000'000;
// What memory bounds beside the readings: values of any kind (angles or targets accompany readings), and
// keys, which weigh ten times as much.
constexpr std::size_t valueLimit = 30'000'000;
constexpr std::size_t keyLimit = 5'000'000;

// A token of the text, as far as a sentence about a syntax error needs it.
struct Token {
    std::size_t begin = 0;
    std::size_t end = 0;
};

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
bool isPunctuation(char c) {
    return std::string_view("{}[]:,").find(c) != std::string_view::npos;
}

std::size_t tokenEnd(std::string_view text, std::size_t begin) {
    std::size_t end = begin + 1;
    if (isPunctuation(text[begin]))
        return end;
    if (text[begin] == '"') {
        while (end < text.size() && text[end] != '"')
            end += text[end] == '\\' ? 2U : 1U;
        return std::min(end + 1, text.size());
    }
    while (end < text.size() && !isSpace(text[end]) && !isPunctuation(text[end]) && text[end] != '"')
        ++end;
    return end;
}

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

// The token that reaches `position`, and the first character of the token before it (0: there is none).
std::pair<Token, char> tokenAt(std::string_view text, std::size_t position) {
    char before = 0;
    Token token;
    token.end = text.substr(0, byteOrderMark.size()) == byteOrderMark ? byteOrderMark.size() : 0;
    for (;;) {
        token.begin = token.end;
        while (token.begin < text.size() && isSpace(text[token.begin]))
            ++token.begin;
        if (token.begin == text.size())
            return {{token.begin, token.begin}, before};
        token.end = tokenEnd(text, token.begin);
        if (token.end >= position)
            return {token, before};
        before = text[token.begin];
    }
}

// line:column of a byte, both counted from 1, columns in characters.
std::string lineAndColumn(std::string_view text, std::size_t offset) {
    std::string_view upTo = text.substr(0, offset);
    if (upTo.substr(0, byteOrderMark.size()) == byteOrderMark)
        upTo.remove_prefix(byteOrderMark.size());
    const auto line = 1 + std::count(upTo.begin(), upTo.end(), '\n');
    const std::size_t lastBreak = upTo.rfind('\n');
    if (lastBreak != std::string_view::npos)
        upTo.remove_prefix(lastBreak + 1);
    const auto column = 1 + std::count_if(upTo.begin(), upTo.end(), [](char c) {
                            return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
                        });
    return std::to_string(line) + ':' + std::to_string(column);
}

// Takes what the library's parser reports, builds the value and refuses what goes beyond a test file.
class Builder {
public:
    explicit Builder(std::string_view text)
        : m_text(text) {}

    json take() { return std::move(m_root); }

    // The interface of nlohmann's SAX; the names are the library's.
    bool null() { return scalar(nullptr); }
    bool boolean(bool value) { return scalar(value); }
    bool number_integer(std::int64_t value) { return scalar(value); }
    bool number_unsigned(std::uint64_t value) { return scalar(value); }
    bool number_float(double value, const std::string &) { return scalar(value); }
    bool string(std::string &value) { return scalar(std::move(value)); }
    bool binary(json::binary_t &) { return false; } // JSON text has none

    bool start_object(std::size_t) {
        open(json::object());
        return true;
    }

    bool start_array(std::size_t) {
        open(json::array());
        return true;
    }

    bool key(std::string &name) {
        if (++m_keys > keyLimit)
            throw Error(Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more keys than a test file can have"), {}, {}}, place());
        Level &level = m_levels.back();
        const auto [entry, isNew] =
            level.container->get_ref<json::object_t &>().emplace(std::move(name), nullptr);
        level.key = &entry->first;
        level.member = &entry->second;
        if (!isNew)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "this key stands here twice; expected it once"), {}, {}},
                        place());
        return true;
    }

    bool end_object() { return close(); }
    bool end_array() { return close(); }

    bool parse_error(std::size_t position, const std::string &, const json::exception &error) {
        constexpr int numberOverflow = 406;
        if (error.id == numberOverflow)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "this number is too large; expected a finite number"), {}, {}},
                        place());
        throw syntaxError(position);
    }

private:
    struct Level {
        json *container;
        bool readings;                    // an array of readings or points
        const std::string *key = nullptr; // of the member that was begun last
        json *member = nullptr;           // its value, null once it stands
    };

    template <class Value>
    bool scalar(Value &&value) {
        put(std::forward<Value>(value));
        if (!m_levels.empty())
            m_levels.back().member = nullptr;
        return true;
    }

    template <class Value>
    json *put(Value &&value) {
        if (++m_values > valueLimit)
            throw Error(Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more values than a test file can have"), {}, {}}, place());
        if (m_levels.empty()) {
            m_root = std::forward<Value>(value);
            return &m_root;
        }
        Level &level = m_levels.back();
        if (level.member) {
            *level.member = std::forward<Value>(value);
            return level.member;
        }
        if (level.readings && ++m_readings > readingLimit)
            throw Error(Error::Kind::tooLarge,
                        {REPORT_TEXT("report", "more than 10 000 000 readings or points"), {}, {}}, place());
        auto &elements = level.container->get_ref<json::array_t &>();
        return &elements.emplace_back(std::forward<Value>(value));
    }

    void open(json &&container) {
        if (m_levels.size() == depthLimit)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "nested deeper than a test file can be"), {}, {}}, place());
        const bool readings =
            !m_levels.empty() && m_levels.back().member &&
            (*m_levels.back().key == "deviations" || *m_levels.back().key == "radialDeviations");
        json *const placed = put(std::move(container));
        m_levels.push_back({placed, readings});
    }

    bool close() {
        m_levels.pop_back();
        if (!m_levels.empty())
            m_levels.back().member = nullptr;
        return true;
    }

    // Of the value that comes next, or of the key that was read last.
    [[nodiscard]] std::string place() const {
        std::vector<Place> chain(m_levels.size() + 1);
        for (std::size_t i = 0; i < m_levels.size(); ++i) {
            const Level &level = m_levels[i];
            if (level.container->is_array()) {
                const bool innermost = i + 1 == m_levels.size();
                chain[i + 1] = Place(chain[i], level.container->size() - (innermost ? 0U : 1U));
            } else {
                chain[i + 1] = level.key ? Place(chain[i], *level.key) : chain[i];
            }
        }
        return chain.back().text();
    }

    [[nodiscard]] Text expected(char before) const {
        if (before == 0)
            return REPORT_TEXT("report", "“{”");
        if (m_levels.empty())
            return REPORT_TEXT("report", "the end of the file");
        const bool inArray = m_levels.back().container->is_array();
        switch (before) {
        case '{':
            return REPORT_TEXT("report", "a key in quotation marks or “}”");
        case '[':
            return REPORT_TEXT("report", "a value or “]”");
        case ':':
            return REPORT_TEXT("report", "a value");
        case ',':
            return inArray ? REPORT_TEXT("report", "a value")
                           : REPORT_TEXT("report", "a key in quotation marks");
        default:
            break;
        }
        if (m_levels.back().member)
            return REPORT_TEXT("report", "“:”");
        return inArray ? REPORT_TEXT("report", "“,” or “]”") : REPORT_TEXT("report", "“,” or “}”");
    }

    // A string where the grammar allows one: what is wrong must be inside.
    [[nodiscard]] bool stringAllowed(char before) const {
        if (before == 0 || m_levels.empty())
            return before == 0;
        return before == '{' || before == '[' || before == ',' || before == ':';
    }

    [[nodiscard]] Error syntaxError(std::size_t position) const {
        const auto [token, before] = tokenAt(m_text, std::min(position, m_text.size()));
        const bool atEnd = position > m_text.size();
        if (token.begin == m_text.size())
            return {Error::Kind::syntax,
                    {REPORT_TEXT("report", "the file ends here; expected %1"), {expected(before)}, {}},
                    lineAndColumn(m_text, token.begin)};
        if (m_text[token.begin] == '"' && stringAllowed(before)) {
            if (atEnd)
                return {Error::Kind::syntax,
                        {REPORT_TEXT("report", "the file ends inside this text; expected a quotation mark"),
                         {},
                         {}},
                        lineAndColumn(m_text, token.begin)};
            return {
                Error::Kind::syntax,
                {REPORT_TEXT("report", "a text cannot hold this character or escape; expected UTF-8 without "
                                       "control characters"),
                 {},
                 {}},
                lineAndColumn(m_text, position - 1)};
        }
        return {Error::Kind::syntax,
                {REPORT_TEXT("report", "found “%1”; expected %2"),
                 {excerpt(m_text.substr(token.begin, token.end - token.begin)), expected(before)},
                 {}},
                lineAndColumn(m_text, token.begin)};
    }

    std::string_view m_text;
    json m_root;
    std::vector<Level> m_levels;
    std::size_t m_values = 0;
    std::size_t m_keys = 0;
    std::size_t m_readings = 0;
};

} // namespace

json parseJson(std::string_view text) {
    // The library takes NUL for the end of the text.
    const std::size_t nul = text.find('\0');
    if (nul != std::string_view::npos)
        throw Error(Error::Kind::syntax,
                    {REPORT_TEXT("report", "found a NUL character; expected text"), {}, {}},
                    lineAndColumn(text, nul));
    Builder builder(text);
    json::sax_parse(text.data(), text.data() + text.size(), &builder);
    return builder.take();
}

} // namespace palmer
