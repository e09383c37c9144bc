// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/tags.h"

#include "figures/figuretexts.h"

#include <QPainter>
#include <set>
#include <unordered_map>
#include <utility>

namespace palmer {

struct Tagging::Record {
    Language language;
    std::vector<StructureElement> elements = std::vector<StructureElement>(1);
    std::vector<std::size_t> links = {};
    std::vector<std::size_t> open{0}; ///< the current element and those around it
    std::unordered_map<const void *, std::size_t> known = {};
    std::set<const void *> drawn = {};
    std::size_t contents = 0;
    std::size_t marked = 0; ///< the content that text would belong to now; 0: none
    int artifacts = 0;      ///< tags without a type around
    bool inFigure = false;
    bool linkNext = false;

    std::size_t add(StructureElement element) {
        const std::size_t index = elements.size();
        element.parent = open.back();
        elements.push_back(std::move(element));
        elements[open.back()].kids.push_back({false, index});
        return index;
    }
    std::size_t addContent() {
        elements[open.back()].kids.push_back({true, ++contents});
        return contents;
    }
    void addLink() {
        links.push_back(add({"/Link"}));
        linkNext = false;
    }
};

namespace {

thread_local Tagging::Record
    *current = // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): of a thread
    nullptr;

void drawSign(QPainter &painter, std::size_t content, MarkedAs as) {
    const QPen pen = painter.pen();
    const QBrush brush = painter.brush();
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::black);
    painter.drawRect(QRectF(markX, static_cast<double>(content), static_cast<int>(as), 1));
    painter.setPen(pen);
    painter.setBrush(brush);
}

} // namespace

Tagging::Tagging(const Language &language)
    : m_record(std::make_unique<Record>(Record{language})) {
    current = m_record.get();
}

Tagging::~Tagging() {
    current = nullptr;
}

void Tagging::beginPage() { // NOLINT(readability-make-member-function-const): changes the record
    m_record->marked = 0;
}

std::vector<StructureElement> Tagging::takeElements() {
    return std::exchange(m_record->elements, {});
}

std::vector<std::size_t> Tagging::links() const {
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
    open({cell.scope ? "/TH" : "/TD", 0, {}, {}, {}, cell.columns, cell.rows, cell.scope}, of);
}

Tag::Tag(QPainter &painter, const QRectF &area, const QString &alternative) {
    m_figure = &painter;
    beginFigure(area, alternative);
}

Tag::Tag(QPainter &painter, const QRectF &area, const Figure &figure)
    : Tag(painter, area, current ? figureSentence(figure, current->language) : QString()) {}

void Tag::open(StructureElement element, const void *of) {
    if (!current || current->inFigure || current->artifacts > 0)
        return;
    const auto known = of ? current->known.find(of) : current->known.end();
    const std::size_t index =
        known != current->known.end() ? known->second : current->add(std::move(element));
    if (of)
        current->known.emplace(of, index);
    current->open.push_back(index);
    m_opened = true;
}

void Tag::beginFigure(const QRectF &area, const QString &alternative) {
    constexpr double pointsPerInch = 72;
    const double points = pointsPerInch / m_figure->device()->logicalDpiX();
    const QRectF dots = m_figure->combinedTransform().mapRect(area);
    open({"/Figure", 0, {}, alternative, QRectF(dots.topLeft() * points, dots.size() * points)}, nullptr);
    if (!m_opened) {
        m_figure = nullptr;
        return;
    }
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
    return !current || current->drawn.insert(of).second;
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

void markContent(QPainter &painter) {
    if (!current || current->inFigure)
        return;
    const bool isArtifact = current->artifacts > 0 || current->open.size() == 1;
    if (isArtifact && current->marked == 0)
        return;
    if (!isArtifact && current->linkNext) {
        current->addLink();
        current->open.push_back(current->links.back());
        current->marked = current->addContent();
        current->open.pop_back();
    } else {
        current->marked = isArtifact ? 0 : current->addContent();
    }
    drawSign(painter, current->marked, MarkedAs::text);
}

} // namespace palmer
