// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/tags.h"

#include "figures/figuretexts.h"

#include <QPainter>
#include <unordered_map>
#include <utility>

namespace palmer {

struct Tagging::Record {
    using Index = Structure::Index;

    /// The element of what was drawn, and when last.
    struct Known {
        Index element = 0;
        std::size_t page = 0;
    };

    Language language;
    Structure structure = {};
    std::vector<Index> links = {};
    std::vector<Index> open{0}; ///< the current element and those around it
    std::size_t page = 0;
    std::unordered_map<const void *, Known> known = {};
    std::unordered_map<const void *, std::size_t> drawn = {}; ///< on which page last
    Index marked = 0;  ///< the content that text would belong to now; 0: none
    int artifacts = 0; ///< tags without a type around
    bool inFigure = false;
    bool linkNext = false;

    Index addContent() { return structure.addContent(open.back()); }
    void addLink() {
        links.push_back(structure.addElement(open.back(), {"/Link"}));
        linkNext = false;
    }
};

namespace {

thread_local Tagging::Record
    *current = // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): of a thread
    nullptr;

void drawSign(QPainter &painter, Structure::Index content, MarkedAs as) {
    const QPen pen = painter.pen();
    if (pen.style() == Qt::NoPen || !pen.brush().isOpaque()) // with others Qt goes on as it is
        painter.setPen(Qt::black);
    painter.drawLine(QPointF(markX, static_cast<double>(content)), QPointF(static_cast<int>(as), 0));
    painter.setPen(pen);
}

} // namespace

Tagging::Tagging(const Language &language)
    : m_record(std::make_unique<Record>(Record{language})) {
    current = m_record.get();
}

Tagging::~Tagging() {
    current = nullptr;
}

/// Forgets what the last page did not go on with: a long report has a million of parts, and what is drawn
/// next may stand where one of them was.
void Tagging::beginPage() { // NOLINT(readability-make-member-function-const): changes the record
    m_record->marked = 0;
    const std::size_t last = m_record->page++;
    std::erase_if(m_record->known, [&](const auto &each) { return each.second.page < last; });
    std::erase_if(m_record->drawn, [&](const auto &each) { return each.second < last; });
}

Structure Tagging::takeStructure() {
    return std::exchange(m_record->structure, {});
}

std::vector<Structure::Index> Tagging::links() const {
    return m_record->links;
}

Tag::Tag(const char *type, const void *of) {
    m_artifact = current && !type;
    if (m_artifact)
        ++current->artifacts;
    else
        open({type}, of);
}

Tag::Tag(const CellTag &cell, const void *of) {
    open({cell.scope ? "/TH" : "/TD", cell.columns, cell.rows, cell.scope}, of);
}

Tag::Tag(QPainter &painter, const QRectF &area, const QString &alternative) {
    m_figure = &painter;
    beginFigure(area, alternative);
}

Tag::Tag(QPainter &painter, const QRectF &area, const Figure &figure)
    : Tag(painter, area, current ? figureSentence(figure, current->language) : QString()) {}

void Tag::open(const StructureKind &kind, const void *of) {
    if (!current || current->inFigure || current->artifacts > 0)
        return;
    const auto known = of ? current->known.find(of) : current->known.end();
    const Structure::Index element = known != current->known.end()
                                         ? known->second.element
                                         : current->structure.addElement(current->open.back(), kind);
    if (of)
        current->known[of] = {element, current->page};
    current->open.push_back(element);
    m_opened = true;
}

void Tag::beginFigure(const QRectF &area, const QString &alternative) {
    if (!current || current->inFigure || current->artifacts > 0) {
        m_figure = nullptr;
        return;
    }
    constexpr double pointsPerInch = 72;
    const double points = pointsPerInch / m_figure->device()->logicalDpiX();
    const QRectF dots = m_figure->combinedTransform().mapRect(area);
    current->open.push_back(current->structure.addFigure(
        current->open.back(), {alternative, QRectF(dots.topLeft() * points, dots.size() * points)}));
    m_opened = true;
    current->inFigure = true;
    drawSign(*m_figure, current->addContent(), MarkedAs::figure);
}

Tag::~Tag() {
    if (m_figure) {
        drawSign(*m_figure, 0, MarkedAs::endOfFigure);
        current->inFigure = false;
        current->marked = 0;
    }
    if (m_artifact)
        --current->artifacts;
    if (m_opened)
        current->open.pop_back();
}

bool Tag::isFirst(const void *of) {
    return !current || current->drawn.insert_or_assign(of, current->page).second;
}

LinkTag::LinkTag(bool linked)
    : m_linked(linked && current) {
    if (m_linked)
        current->linkNext = true;
}

LinkTag::~LinkTag() {
    if (m_linked && current->linkNext)
        current->addLink(); // without text
}

namespace {

/// True where what is drawn next is an artifact.
bool isArtifact() {
    return current->artifacts > 0 || current->open.size() == 1;
}

} // namespace

bool contentGoesOn() {
    if (!current || current->inFigure)
        return true;
    if (isArtifact())
        return current->marked == 0;
    return !current->linkNext && current->marked != 0 &&
           current->structure.parent(current->marked) == current->open.back();
}

void markContent(QPainter &painter) {
    if (contentGoesOn())
        return;
    if (!isArtifact() && current->linkNext) {
        current->addLink();
        current->open.push_back(current->links.back());
        current->marked = current->addContent();
        current->open.pop_back();
    } else {
        current->marked = isArtifact() ? 0 : current->addContent();
    }
    drawSign(painter, current->marked, MarkedAs::text);
}

} // namespace palmer
