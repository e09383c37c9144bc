// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/place.h"

#include "kernel/numerics/runinbackground.h"

#include <QByteArray>
#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <functional>
#include <future>
#include <span>
#include <string>
#include <string_view>

namespace palmer {

class JsonPrinter;

/// A member of an object, printed later. Data that `print` refers to must live as long.
struct JsonMember {
    std::string_view key;
    bool isSmall = false; ///< a scalar, empty, or a short list of scalars: may share a line
    std::function<void(JsonPrinter &, const Place &)> print;
};

/// Writes JSON text directly from values, without a tree: two spaces per level, lists of scalars wrapped at
/// about 100 columns, small objects on one line; or everything on one line. Places are those of the values in
/// the file, for errors.
class JsonPrinter {
public:
    enum class Form { lines, oneLine };

    explicit JsonPrinter(Form form)
        : m_oneLine(form == Form::oneLine) {}

    /// In the shortest round-trip form. Throws Error(unwritable) for a non-finite number.
    void number(double value, const Place &place);
    void whole(std::integral auto value) {
        std::array<char, 24> digits{};
        append({digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr});
    }
    void text(std::string_view utf8);                    ///< replaces invalid UTF-8 by U+FFFD
    void word(std::string_view value) { append(value); } ///< true, false, null
    void object(std::span<const JsonMember> members, const Place &place);
    /// `print(i)` prints the element with index i.
    template <class Print>
    void list(std::size_t count, const Print &print);
    /// `print(printer, i)` prints an element; two threads share a long list, with fixed line breaks.
    template <class Print>
    void listOfScalars(std::size_t count, const Print &print);

    [[nodiscard]] static bool isSmallList(std::size_t size) { return size < lineLength / 2; }
    /// Reserves memory for that many more characters at once, instead of doubling step by step.
    void expect(std::size_t characters);
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] QByteArray take() {
        m_text.truncate(static_cast<qsizetype>(m_size));
        return std::move(m_text);
    }

private:
    static constexpr std::size_t lineLength = 100;
    static constexpr std::size_t indentation = 2;
    static constexpr std::size_t sampleSize = 1000;
    static constexpr std::size_t longList = 100 * sampleSize;

    /// Returns the end of the text, with space for that many characters after it.
    char *room(std::size_t characters) {
        if (static_cast<std::size_t>(m_text.size()) < m_size + characters) {
            const std::size_t wanted = 2 * m_size + characters;
            m_text.resize(static_cast<qsizetype>(wanted));
        }
        return m_text.data() + m_size;
    }
    void append(std::string_view text) {
        std::ranges::copy(text, room(text.size()));
        m_size += text.size();
    }
    void append(char c) {
        *room(1) = c;
        ++m_size;
    }
    void breakLine(std::size_t at);
    void newLine();
    void open(char bracket);
    void close(char bracket);
    [[nodiscard]] std::size_t column() const { return size() - m_lineBegin; }
    /// Returns false and prints nothing if it is too long for the rest of the line.
    bool printOnThisLine(std::span<const JsonMember> members, const Place &place);
    template <class Print>
    bool printOnThisLine(std::size_t count, const Print &print);
    /// Prints the elements from `first` to before `last`, reserving memory for `expected`.
    template <class Print>
    void scalars(std::size_t first, std::size_t last, std::size_t expected, const Print &print);

    QByteArray m_text; ///< grows in place and is written directly: texts of many MB are never copied
    /// Number of characters printed; the buffer is longer. Appending to a QByteArray takes a call or two, a
    /// third of the time of printing a long list.
    std::size_t m_size = 0;
    std::size_t m_lineBegin = 0;
    std::size_t m_indent = 0;
    bool m_oneLine;
};

template <class Print>
void JsonPrinter::list(std::size_t count, const Print &print) {
    if (m_oneLine || count == 0) {
        printOnThisLine(count, print);
        return;
    }
    open('[');
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) {
            append(',');
            newLine();
        }
        print(i);
    }
    close(']');
}

template <class Print>
void JsonPrinter::listOfScalars(std::size_t count, const Print &print) {
    if (printOnThisLine(count, [&](std::size_t i) { print(*this, i); }))
        return;
    open('[');
    if (count <= longList) {
        scalars(0, count, count, print);
    } else {
        const std::size_t middle = count / 2;
        JsonPrinter rest(Form::lines);
        rest.m_indent = m_indent;
        auto printed = runInBackground(true, [&] {
            rest.newLine();
            rest.scalars(middle, count, count - middle, print);
        });
        scalars(0, middle, count, print);
        printed.get();
        append(',');
        append({rest.m_text.constData(), rest.m_size});
    }
    close(']');
}

template <class Print>
void JsonPrinter::scalars(std::size_t first, std::size_t last, std::size_t expected, const Print &print) {
    const std::size_t begin = size();
    for (std::size_t i = first; i < last; ++i) {
        const std::size_t end = size();
        if (i == first + sampleSize && last - first >= longList / 2) // the others are about as long
            expect((end - begin) * (expected + expected / 8) / sampleSize);
        append(i > first ? ", " : "");
        print(*this, i);
        if (i > first && column() >= lineLength)
            breakLine(end + 1); // at the blank
    }
}

template <class Print>
bool JsonPrinter::printOnThisLine(std::size_t count, const Print &print) {
    const std::size_t begin = m_size;
    append('[');
    for (std::size_t i = 0; i < count; ++i) {
        append(i > 0 ? ", " : "");
        print(i);
        if (!m_oneLine && column() >= lineLength) {
            m_size = begin;
            return false;
        }
    }
    append(']');
    return true;
}

} // namespace palmer
