// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/tagpdf.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <string>
#include <string_view>
#include <tuple>

namespace palmer {

namespace {

using Handle = QPDFObjectHandle;

// ---- Fonts
// ---------------------------------------------------------------------------------------------------

/// UTF-16 of each glyph of a font, in hexadecimal.
using Characters = std::vector<std::string>;

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

/// The fonts of a page by their names in it. Each font is corrected once.
class Fonts {
public:
    std::map<std::string, const Characters *> of(Handle page) {
        std::map<std::string, const Characters *> result;
        for (auto &[name, font] : page.getKey("/Resources").getKey("/Font").getDictAsMap()) {
            auto [known, isNew] = m_characters.try_emplace(font.getObjGen());
            if (isNew)
                known->second = correct(font);
            result.emplace(name, &known->second);
        }
        return result;
    }

private:
    static Characters correct(Handle font) {
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

    std::map<QPDFObjGen, Characters> m_characters;
};

// ---- Content
// -------------------------------------------------------------------------------------------------

/// Where a content stands: page, from 0, and its identifier there.
struct MarkedContent {
    std::size_t page = 0;
    int id = 0;
};

/// The places of all contents, by number; usually one each.
using MarkedContents = std::vector<std::vector<MarkedContent>>;

/// Rewrites a page's content operator by operator, as Qt writes one on a line.
class ContentTagger {
public:
    ContentTagger(std::size_t page, const std::map<std::string, const Characters *> &fonts,
                  MarkedContents &contents, const std::vector<const char *> &types)
        : m_page(page)
        , m_fonts(fonts)
        , m_contents(contents)
        , m_types(types) {}

    std::string operator()(std::string_view content) {
        m_out.reserve(content.size() + content.size() / 4);
        while (!content.empty()) {
            const std::size_t length = std::min(content.find('\n'), content.size() - 1) + 1;
            const std::string_view line = content.substr(0, length);
            content.remove_prefix(length);
            if (readMark(line))
                content.remove_prefix(std::min(content.find('\n'), content.size() - 1) + 1); // its "f"
            else
                add(line);
        }
        belongTo(none);
        return std::move(m_out);
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1); ///< no content is open
    static constexpr std::size_t artifact = 0;

    /// True for a mark, which is not copied.
    bool readMark(std::string_view line) {
        static const std::string begins = std::to_string(markX) + ' ';
        if (!line.starts_with(begins) || !line.ends_with(" re\n"))
            return false;
        std::array<int, 2> numbers{};
        const char *at = line.data() + begins.size();
        for (int &number : numbers)
            at = std::from_chars(at, line.data() + line.size(), number).ptr + 1;
        m_current = static_cast<std::size_t>(numbers[0]);
        m_inFigure = numbers[1] == static_cast<int>(MarkedAs::figure);
        if (numbers[1] != static_cast<int>(MarkedAs::text)) {
            belongTo(none);
            if (m_inFigure)
                belongTo(m_current);
        }
        return true;
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
    void belongTo(std::size_t content) {
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
            m_out += std::string(m_types.at(content)) + " <</MCID " + std::to_string(m_count) + ">> BDC\n";
            m_contents.at(content).push_back({m_page, m_count++});
        }
    }

    std::size_t m_page;
    const std::map<std::string, const Characters *> &m_fonts;
    MarkedContents &m_contents;
    const std::vector<const char *> &m_types; ///< of the elements of all contents, by number
    std::string m_out;
    std::string m_state; ///< changes of the graphics state since the last content
    std::size_t m_current = artifact;
    std::size_t m_open = none;
    bool m_inFigure = false;
    bool m_inText = false;
    int m_count = 0;
    const Characters *m_font = nullptr;
    std::string m_letter; ///< the last character in hexadecimal, which begins at m_letterAt
    std::size_t m_letterAt = 0;
};

// ---- Structure
// -----------------------------------------------------------------------------------------------

double heightOf(Handle page) {
    return page.getKey("/MediaBox").getArrayItem(3).getNumericValue();
}

/// Builds the structure tree and its way back from the contents.
class StructureTree {
public:
    StructureTree(QPDF &document, const PdfProperties &properties, const MarkedContents &contents)
        : m_document(document)
        , m_elements(properties.structure)
        , m_contents(contents)
        , m_pages(document.getAllPages())
        , m_objects(m_elements.size(), Handle::newNull())
        , m_parents(m_pages.size()) {}

    void write(const PdfProperties &properties, const std::vector<Handle> &annotations) {
        m_root = m_document.makeIndirectObject(Handle::parse("<< /Type /StructTreeRoot >>"));
        findUsed(properties.links);
        for (std::size_t i = 0; i < m_elements.size(); ++i) {
            if (m_used[i])
                m_objects[i] = m_document.makeIndirectObject(elementOf(i));
        }
        for (std::size_t i = 0; i < m_elements.size(); ++i) {
            if (m_used[i])
                addKids(i);
        }
        Handle numbers = Handle::newArray();
        for (std::size_t i = 0; i < m_pages.size(); ++i) {
            m_pages[i].replaceKey("/StructParents", Handle::newInteger(static_cast<long long>(i)));
            m_pages[i].replaceKey("/Tabs", Handle::newName("/S"));
            numbers.appendItem(Handle::newInteger(static_cast<long long>(i)));
            numbers.appendItem(m_document.makeIndirectObject(Handle::newArray(m_parents[i])));
        }
        for (std::size_t i = 0; i < annotations.size(); ++i)
            addAnnotation(properties.links[i], annotations[i], m_pages.size() + i, numbers);
        Handle tree = Handle::newDictionary();
        tree.replaceKey("/Nums", numbers);
        m_root.replaceKey("/K", m_objects.front());
        m_root.replaceKey("/ParentTree", m_document.makeIndirectObject(tree));
        m_root.replaceKey("/ParentTreeNextKey",
                          Handle::newInteger(static_cast<long long>(m_pages.size()) +
                                             static_cast<long long>(annotations.size())));
        m_document.getRoot().replaceKey("/StructTreeRoot", m_root);
        m_document.getRoot().replaceKey("/MarkInfo", Handle::parse("<< /Marked true >>"));
    }

private:
    /// Elements without content are left out, except cells, which keep the columns of their row.
    void findUsed(const std::vector<PdfLink> &links) {
        m_used.assign(m_elements.size(), false);
        m_used[0] = true;
        for (const PdfLink &link : links)
            m_used[link.element] = true;
        for (std::size_t i = m_elements.size(); i-- > 0;) {
            const StructureElement &element = m_elements[i];
            const std::string_view type = element.type;
            const bool isCell = type == "/TD" || type == "/TH";
            m_used[i] = m_used[i] || isCell ||
                        std::ranges::any_of(element.kids, [&](const StructureElement::Kid &kid) {
                            return kid.isContent && !m_contents[kid.index].empty();
                        });
            if (m_used[i])
                m_used[element.parent] = true;
        }
    }

    [[nodiscard]] Handle elementOf(std::size_t index) {
        const StructureElement &element = m_elements[index];
        Handle result = Handle::newDictionary();
        auto [type, isNew] = m_types.try_emplace(element.type);
        if (isNew)
            type->second = Handle::newName(element.type);
        result.replaceKey("/S", type->second);
        result.replaceKey("/P", index == 0 ? m_root : m_objects[element.parent]);
        const bool isFigure = std::string_view(element.type) == "/Figure";
        if (isFigure)
            result.replaceKey("/Alt", Handle::newUnicodeString(element.alternative.toStdString()));
        if (element.columns != 1 || element.rows != 1 || element.scope)
            result.replaceKey("/A", attributesOf(element));
        return result;
    }

    Handle attributesOf(const StructureElement &element) {
        auto [known, isNew] = m_attributes.try_emplace({element.scope, element.columns, element.rows});
        Handle &attributes = known->second;
        if (!isNew)
            return attributes;
        attributes = Handle::parse("<< /O /Table >>");
        if (element.scope)
            attributes.replaceKey("/Scope", Handle::newName(element.scope));
        if (element.columns != 1)
            attributes.replaceKey("/ColSpan", Handle::newInteger(element.columns));
        if (element.rows != 1)
            attributes.replaceKey("/RowSpan", Handle::newInteger(element.rows));
        return attributes;
    }

    void addKids(std::size_t index) {
        const StructureElement &element = m_elements[index];
        Handle object = m_objects[index];
        std::vector<Handle> kids;
        std::optional<std::size_t> page;
        for (const StructureElement::Kid &kid : element.kids) {
            if (!kid.isContent) {
                if (m_used[kid.index])
                    kids.push_back(m_objects[kid.index]);
                continue;
            }
            for (const MarkedContent &content : m_contents[kid.index]) {
                kids.push_back(contentOf(content, page));
                auto &parents = m_parents[content.page];
                parents.resize(std::max(parents.size(), static_cast<std::size_t>(content.id) + 1),
                               Handle::newNull());
                parents[static_cast<std::size_t>(content.id)] = object;
                if (!element.area.isEmpty())
                    object.replaceKey("/A", boxOf(element.area, m_pages[content.page]));
            }
        }
        if (page)
            object.replaceKey("/Pg", m_pages[*page]);
        if (!kids.empty())
            object.replaceKey("/K", kids.size() == 1 ? kids.front() : Handle::newArray(kids));
    }

    /// `page`: that of the element, where most of its contents are.
    Handle contentOf(const MarkedContent &content, std::optional<std::size_t> &page) {
        if (!page)
            page = content.page;
        while (m_identifiers.size() <= static_cast<std::size_t>(content.id))
            m_identifiers.push_back(Handle::newInteger(static_cast<long long>(m_identifiers.size())));
        const Handle &identifier = m_identifiers[static_cast<std::size_t>(content.id)];
        if (content.page == *page)
            return identifier;
        Handle reference = Handle::parse("<< /Type /MCR >>");
        reference.replaceKey("/Pg", m_pages[content.page]);
        reference.replaceKey("/MCID", identifier);
        return reference;
    }

    static Handle boxOf(const QRectF &area, const Handle &page) {
        Handle attributes = Handle::parse("<< /O /Layout /Placement /Block >>");
        const double height = heightOf(page);
        attributes.replaceKey(
            "/BBox",
            Handle::newArray({Handle::newReal(area.left(), 2), Handle::newReal(height - area.bottom(), 2),
                              Handle::newReal(area.right(), 2), Handle::newReal(height - area.top(), 2)}));
        return attributes;
    }

    void addAnnotation(const PdfLink &link, Handle annotation, std::size_t key, Handle numbers) {
        Handle object = m_objects[link.element];
        annotation.replaceKey("/StructParent", Handle::newInteger(static_cast<long long>(key)));
        Handle reference = Handle::parse("<< /Type /OBJR >>");
        reference.replaceKey("/Obj", annotation);
        reference.replaceKey("/Pg", m_pages[static_cast<std::size_t>(link.page)]);
        Handle kids = object.getKey("/K");
        if (!kids.isArray())
            kids = kids.isNull() ? Handle::newArray() : Handle::newArray({kids});
        kids.appendItem(reference);
        object.replaceKey("/K", kids);
        numbers.appendItem(Handle::newInteger(static_cast<long long>(key)));
        numbers.appendItem(object);
    }

    QPDF &m_document;
    const std::vector<StructureElement> &m_elements;
    const MarkedContents &m_contents;
    std::vector<Handle> m_pages;
    std::vector<Handle> m_objects;              ///< by element
    std::vector<std::vector<Handle>> m_parents; ///< by page and identifier
    std::vector<bool> m_used;
    // One object for all elements with the same: a report of 1 000 tests has half a million of them.
    std::map<std::string_view, Handle> m_types;
    std::vector<Handle> m_identifiers;
    std::map<std::tuple<const char *, int, int>, Handle> m_attributes; ///< by scope, columns and rows
    Handle m_root;
};

/// The types of the elements of all contents, by number.
std::vector<const char *> typesOf(const std::vector<StructureElement> &elements) {
    std::vector<const char *> types(1);
    for (const StructureElement &element : elements) {
        for (const StructureElement::Kid &kid : element.kids) {
            if (!kid.isContent)
                continue;
            types.resize(std::max(types.size(), kid.index + 1));
            types[kid.index] = element.type;
        }
    }
    return types;
}

} // namespace

void tagPdf(QPDF &document, const PdfProperties &properties, const std::vector<Handle> &annotations) {
    const std::vector<const char *> types = typesOf(properties.structure);
    MarkedContents contents(types.size());
    Fonts fonts;
    std::size_t index = 0;
    for (Handle page : document.getAllPages()) {
        const auto used = fonts.of(page);
        Handle stream = page.getKey("/Contents");
        const std::string tagged = ContentTagger(index++, used, contents, types)(streamOf(stream));
        // Packed at once: libqpdf would keep the contents of all pages until it writes the first.
        stream.replaceStreamData(properties.pack(QByteArray::fromStdString(tagged)).toStdString(),
                                 Handle::newName("/FlateDecode"), Handle::newNull());
    }
    StructureTree(document, properties, contents).write(properties, annotations);
}

} // namespace palmer
