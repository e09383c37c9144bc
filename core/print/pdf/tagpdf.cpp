// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/tagpdf.h"

#include "print/pdf/tags.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <qpdf/Buffer.hh>
#include <string_view>

namespace palmer {

namespace {

using Handle = QPDFObjectHandle;

using Characters = PageTagger::Characters;

constexpr std::string_view macron = "0304"; ///< combining, of x̄

std::string streamOf(Handle stream) {
    const auto buffer = stream.getStreamData();
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of libqpdf
    return {reinterpret_cast<const char *>(buffer->getBuffer()), buffer->getSize()};
}

/// Replaces Qt's map, which says that the blank is a tabulator and that a missing glyph is U+0000.
Characters correctCharacters(Handle map) {
    const std::string text = streamOf(map);
    Characters characters(1);
    const std::size_t begin = text.find('[');
    const std::size_t end = text.find(']', begin);
    if (begin == std::string::npos || end == std::string::npos)
        return characters;
    for (std::size_t at = begin; (at = text.find('<', at)) < end; ++at) {
        std::string character = text.substr(at + 1, text.find('>', at) - at - 1);
        if (character == "0009")
            character = "0020";
        else if (character == "0000")
            character = "FFFD";
        characters.push_back(std::move(character));
    }
    std::string list;
    for (std::size_t i = 1; i < characters.size(); ++i)
        list += '<' + characters[i] + "> ";
    const std::size_t ranges = text.rfind("2 beginbfrange", begin);
    const std::size_t first = text.rfind('\n', begin) + 1; // of the line with the list
    if (ranges == std::string::npos)
        return characters;
    map.replaceStreamData(text.substr(0, ranges) + "1 beginbfrange\n" + text.substr(first, begin - first) +
                              '[' + list + text.substr(end),
                          Handle::newNull(), Handle::newNull());
    return characters;
}

Characters corrected(Handle font) {
    Handle own = font.getKey("/DescendantFonts");
    if (own.isArray() && own.getArrayNItems() == 1) {
        Handle descriptor = own.getArrayItem(0).getKey("/FontDescriptor");
        for (Handle named : {font, own.getArrayItem(0)})
            named.replaceKey("/BaseFont", descriptor.getKey("/FontName"));
        descriptor.removeKey("/CIDSet"); // has to be complete or absent
    }
    Handle map = font.getKey("/ToUnicode");
    return map.isStream() ? correctCharacters(map) : Characters();
}

/// Rewrites a page's content operator by operator, as Qt writes one on a line.
class ContentTagger {
public:
    ContentTagger(const std::map<std::string, const Characters *> &fonts, const Structure &structure,
                  std::vector<Structure::Index> &contents)
        : m_fonts(fonts)
        , m_structure(structure)
        , m_contents(contents) {}

    std::string operator()(std::string_view content) {
        m_out.reserve(content.size() + content.size() / 4);
        while (!content.empty()) {
            const std::string_view line = takeLine(content);
            if (line.starts_with(m_begins))
                readMark(line, content);
            else
                add(line);
        }
        belongTo(none);
        return std::move(m_out);
    }

private:
    static constexpr Structure::Index none = static_cast<Structure::Index>(-1); ///< no content is open
    static constexpr Structure::Index artifact = 0;

    static std::string_view takeLine(std::string_view &content) {
        const std::string_view line = content.substr(0, std::min(content.find('\n'), content.size() - 1) + 1);
        content.remove_prefix(line.size());
        return line;
    }

    static int numberOf(std::string_view text) {
        int number = 0;
        std::from_chars(text.data(), text.data() + text.size(), number);
        return number;
    }

    /// Reads the three lines of a mark, which are not copied: "-99999 12 m", "1 0 l", "S".
    void readMark(std::string_view first, std::string_view &rest) {
        m_current = static_cast<Structure::Index>(numberOf(first.substr(m_begins.size())));
        const int as = numberOf(takeLine(rest));
        takeLine(rest);
        m_inFigure = as == static_cast<int>(MarkedAs::figure);
        if (as != static_cast<int>(MarkedAs::text)) {
            belongTo(none);
            if (m_inFigure)
                belongTo(m_current);
        }
    }

    void add(std::string_view line) {
        const std::string_view operation = operatorOf(line);
        if (operation == "BT") {
            belongTo(m_current);
            m_inText = true;
            m_out += line;
        } else if (m_inText) {
            addText(line, operation);
            m_inText = operation != "ET";
        } else if (m_inFigure) {
            m_out += line;
        } else if (paints(operation)) {
            belongTo(artifact);
            m_out += line;
        } else {
            m_state += line;
        }
    }

    static std::string_view operatorOf(std::string_view line) {
        while (!line.empty() && (line.back() == '\n' || line.back() == ' '))
            line.remove_suffix(1);
        return line.substr(line.rfind(' ') + 1);
    }

    /// True for operators of paths, their painting, images and shadings.
    static bool paints(std::string_view operation) {
        static constexpr std::array<std::string_view, 21> operators{"m",  "l", "c",  "v", "y", "h",  "re",
                                                                    "W*", "S", "s",  "f", "F", "f*", "B",
                                                                    "B*", "b", "b*", "n", "W", "Do", "sh"};
        return std::ranges::find(operators, operation) != operators.end();
    }

    /// A letter and the accent that follows it are marked as the character they make.
    void addText(std::string_view line, std::string_view operation) {
        const std::size_t at = m_out.size();
        m_out += line;
        if (operation == "Tm") { // "/F7 105 Tf 1 0 0 -1 0 0 Tm"
            const auto font = m_fonts.find(std::string(line.substr(0, line.find(' '))));
            m_font = font == m_fonts.end() ? nullptr : font->second;
            m_letter.clear();
        }
        if (operation != "Tj" || !m_font)
            return;
        const std::size_t hex = line.find('<') + 1;
        unsigned glyph = 0;
        std::from_chars(line.data() + hex, line.data() + line.size(), glyph, 16);
        const std::string character = glyph < m_font->size() ? (*m_font)[glyph] : std::string();
        if (character == macron && !m_letter.empty()) {
            m_out.insert(m_letterAt,
                         "/Span <</ActualText <FEFF" + m_letter + std::string(macron) + ">>> BDC\n");
            m_out += "EMC\n";
        }
        m_letter = character;
        m_letterAt = at;
    }

    /// Ends the open content, unless it is this one, and opens it. Changes of the state stand outside.
    void belongTo(Structure::Index content) {
        if (content != m_open && m_open != none)
            m_out += "EMC\n";
        m_out += m_state;
        m_state.clear();
        if (content == m_open)
            return;
        m_open = content;
        if (content == artifact) {
            m_out += "/Artifact BMC\n";
        } else if (content != none) {
            m_out += m_structure.kind(m_structure.parent(content)).type;
            m_out += " <</MCID " + std::to_string(m_contents.size()) + ">> BDC\n";
            m_contents.push_back(content);
        }
    }

    const std::string m_begins = std::to_string(markX) + ' '; ///< of a mark
    const std::map<std::string, const Characters *> &m_fonts;
    const Structure &m_structure;
    std::vector<Structure::Index> &m_contents; ///< by identifier
    std::string m_out;
    std::string m_state; ///< changes of the graphics state since the last content
    Structure::Index m_current = artifact;
    Structure::Index m_open = none;
    bool m_inFigure = false;
    bool m_inText = false;
    const Characters *m_font = nullptr;
    std::string m_letter; ///< the last character in hexadecimal, which begins at m_letterAt
    std::size_t m_letterAt = 0;
};

} // namespace

std::string PageTagger::taggedContent(Handle page, std::vector<Structure::Index> &contents) {
    std::map<std::string, const Characters *> fonts; // by their names on the page
    for (auto &[name, font] : page.getKey("/Resources").getKey("/Font").getDictAsMap()) {
        auto [known, isNew] = m_characters.try_emplace(font.getObjGen());
        if (isNew)
            known->second = corrected(font);
        fonts.emplace(name, &known->second);
    }
    return ContentTagger(fonts, m_structure, contents)(streamOf(page.getKey("/Contents")));
}

} // namespace palmer
