// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/structuretree.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <qpdf/QPDFObjectHandle.hh>
#include <string>
#include <string_view>
#include <utility>

namespace palmer {

namespace {

using Handle = QPDFObjectHandle;
using Index = Structure::Index;

std::string reference(int number) {
    return std::to_string(number) + " 0 R";
}

std::string reference(const WrittenPage &page) {
    return reference(page.number);
}

/// The kids of an element as they are written.
class Kids {
public:
    void add(const std::string &kid) { m_text += (m_count++ > 0 ? " " : "") + kid; }
    [[nodiscard]] std::string entry() const {
        return m_count == 0 ? std::string() : m_count == 1 ? " /K " + m_text : " /K [" + m_text + ']';
    }

private:
    std::string m_text;
    int m_count = 0;
};

/// All that is kept of an entry are a few numbers: there are a million of them.
class StructureTree {
public:
    StructureTree(PdfFile &file, int root, const PdfProperties &properties, MarkedContents contents,
                  const std::vector<WrittenPage> &pages, const std::vector<int> &annotations)
        : m_file(file)
        , m_root(root)
        , m_structure(properties.structure)
        , m_links(properties.links)
        , m_pages(pages)
        , m_annotations(annotations) {
        arrange(std::move(contents));
        findUsed();
    }

    void write() {
        // Kids are chained from behind, so that they are found in their order.
        std::vector<Index> next(m_structure.size());
        std::vector<Index> first(m_structure.size());
        for (std::size_t i = m_structure.size(); i-- > 1;) {
            const auto entry = static_cast<Index>(i);
            const Index parent = m_structure.parent(entry);
            next[i] = first[parent];
            first[parent] = entry;
        }
        for (std::size_t i = 0; i < m_structure.size(); ++i) {
            if (const auto entry = static_cast<Index>(i); isElement(entry))
                writeElement(entry, first[i], next);
        }
        const int tree = m_file.newNumber();
        m_file.add(tree, "<< /Nums [" + parentNumbers() + "] >>");
        m_file.add(m_root, "<< /Type /StructTreeRoot /K " + reference(m_numbers[0]) + " /ParentTree " +
                               reference(tree) + " /ParentTreeNextKey " +
                               std::to_string(m_pages.size() + m_annotations.size()) + " >>");
    }

private:
    static constexpr int unused = 0;

    [[nodiscard]] bool isElement(Index entry) const {
        return !m_structure.isContent(entry) && m_numbers[entry] != unused;
    }

    /// The marks of all pages in one row; those of the same content are chained.
    void arrange(MarkedContents contents) {
        std::size_t count = 0;
        for (const std::vector<Index> &page : contents)
            count += page.size();
        m_marked.reserve(count);
        for (std::vector<Index> &page : contents) {
            m_begins.push_back(m_marked.size());
            m_marked.insert(m_marked.end(), page.begin(), page.end());
            page = {};
        }
        m_begins.push_back(m_marked.size());
        m_numbers.resize(m_structure.size());
        m_nextMarks.resize(m_marked.size());
        for (std::size_t i = m_marked.size(); i-- > 0;) {
            int &first = m_numbers[m_marked[i]];
            m_nextMarks[i] = first;
            first = static_cast<int>(i) + 1;
        }
    }

    void findUsed() {
        std::vector<bool> used(m_structure.size());
        used[0] = true;
        for (const PdfLink &link : m_links)
            used[link.element] = true;
        for (std::size_t i = m_structure.size(); i-- > 0;) {
            const auto entry = static_cast<Index>(i);
            if (m_structure.isContent(entry)) {
                used[i] = m_numbers[i] != unused;
            } else if (!used[i]) {
                const std::string_view type = m_structure.kind(entry).type;
                used[i] = type == "/TD" || type == "/TH";
            }
            if (used[i])
                used[m_structure.parent(entry)] = true;
        }
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (used[i] && !m_structure.isContent(static_cast<Index>(i)))
                m_numbers[i] = m_file.newNumber();
        }
    }

    [[nodiscard]] std::size_t pageOf(std::size_t mark) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(m_begins, mark) - m_begins.begin()) - 1;
    }

    void writeElement(Index entry, Index kid, const std::vector<Index> &next) {
        const StructureKind &kind = m_structure.kind(entry);
        std::string text = "<< /S ";
        text += kind.type;
        text += " /P " + reference(entry == 0 ? m_root : m_numbers[m_structure.parent(entry)]);
        std::optional<std::size_t> page; // that of its first content
        Kids kids;
        for (; kid != 0; kid = next[kid])
            addKid(kids, kid, page);
        while (m_link < m_links.size() && m_links[m_link].element < entry)
            ++m_link;
        for (; m_link < m_links.size() && m_links[m_link].element == entry; ++m_link)
            kids.add(linkOf(m_link));
        if (page)
            text += " /Pg " + reference(m_pages[*page]);
        text += kids.entry();
        const TaggedFigure *figure =
            kind.type == std::string_view("/Figure") ? m_structure.figure(entry) : nullptr;
        text += figure ? figureEntries(*figure, page) : tableEntries(kind);
        m_file.add(m_numbers[entry], text + " >>");
    }

    /// `page`: that of the element, where most of its contents are.
    void addKid(Kids &kids, Index kid, std::optional<std::size_t> &page) const {
        if (!m_structure.isContent(kid)) {
            if (m_numbers[kid] != unused)
                kids.add(reference(m_numbers[kid]));
            return;
        }
        for (int mark = m_numbers[kid]; mark != unused;
             mark = m_nextMarks[static_cast<std::size_t>(mark) - 1])
            kids.add(contentOf(static_cast<std::size_t>(mark) - 1, page));
    }

    /// `page`: that of the element.
    [[nodiscard]] std::string contentOf(std::size_t mark, std::optional<std::size_t> &page) const {
        const std::size_t own = pageOf(mark);
        const std::string identifier = std::to_string(mark - m_begins[own]);
        if (!page)
            page = own;
        return own == *page ? identifier
                            : "<< /Type /MCR /Pg " + reference(m_pages[own]) + " /MCID " + identifier + " >>";
    }

    [[nodiscard]] std::string linkOf(std::size_t link) const {
        return "<< /Type /OBJR /Obj " + reference(m_annotations[link]) + " /Pg " +
               reference(m_pages[static_cast<std::size_t>(m_links[link].page)]) + " >>";
    }

    [[nodiscard]] std::string figureEntries(const TaggedFigure &figure,
                                            std::optional<std::size_t> page) const {
        std::string text = " /Alt " + Handle::newUnicodeString(figure.alternative.toStdString()).unparse();
        if (figure.area.isEmpty() || !page)
            return text;
        const double height = m_pages[*page].height;
        text += " /A << /BBox [";
        for (const double place : {figure.area.left(), height - figure.area.bottom(), figure.area.right(),
                                   height - figure.area.top()})
            text += ' ' + Handle::newReal(place, 2).unparse();
        return text + " ] /O /Layout /Placement /Block >>";
    }

    static std::string tableEntries(const StructureKind &kind) {
        if (kind.columns == 1 && kind.rows == 1 && !kind.scope)
            return {};
        std::string text = " /A <<";
        if (kind.columns != 1)
            text += " /ColSpan " + std::to_string(kind.columns);
        text += " /O /Table";
        if (kind.rows != 1)
            text += " /RowSpan " + std::to_string(kind.rows);
        if (kind.scope)
            text += " /Scope " + std::string(kind.scope);
        return text + " >>";
    }

    /// The elements of all keys; writes the lists of those on each page.
    std::string parentNumbers() {
        std::string numbers;
        for (std::size_t page = 0; page < m_pages.size(); ++page) {
            std::string parents = "[";
            for (std::size_t mark = m_begins[page]; mark < m_begins[page + 1]; ++mark)
                parents += ' ' + reference(m_numbers[m_structure.parent(m_marked[mark])]);
            const int number = m_file.newNumber();
            m_file.add(number, parents + " ]");
            numbers += std::to_string(page) + ' ' + reference(number) + ' ';
        }
        for (std::size_t i = 0; i < m_annotations.size(); ++i)
            numbers +=
                std::to_string(m_pages.size() + i) + ' ' + reference(m_numbers[m_links[i].element]) + ' ';
        return numbers;
    }

    PdfFile &m_file;
    int m_root;
    const Structure &m_structure;
    const std::vector<PdfLink> &m_links; ///< in the order of their elements
    const std::vector<WrittenPage> &m_pages;
    const std::vector<int> &m_annotations;
    std::vector<std::size_t> m_begins; ///< the first mark of each page, and the number of all
    std::vector<Index> m_marked;       ///< the contents of the marks
    std::vector<int> m_nextMarks;      ///< the next mark of the same content, from 1
    std::vector<int> m_numbers;        ///< of the objects of elements; of a content its first mark, from 1
    std::size_t m_link = 0;
};

} // namespace

void writeStructure(PdfFile &file, int root, const PdfProperties &properties, MarkedContents contents,
                    const std::vector<WrittenPage> &pages, const std::vector<int> &annotations) {
    StructureTree(file, root, properties, std::move(contents), pages, annotations).write();
}

} // namespace palmer
