// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "language/language.h"
#include "print/pdf/structure.h"

#include <QRectF>
#include <QString>
#include <memory>
#include <vector>

class QPainter;

namespace palmer {

/// The structure of what this thread draws during its life.
class Tagging {
public:
    explicit Tagging(const Language &language); ///< of the alternative texts
    ~Tagging();
    Tagging(const Tagging &) = delete;
    Tagging &operator=(const Tagging &) = delete;

    void beginPage();
    /// Gives up the structure: called once, when all is drawn.
    [[nodiscard]] Structure takeStructure();
    /// The elements of the linked areas, in the order in which they were drawn.
    [[nodiscard]] std::vector<Structure::Index> links() const;

    struct Record;

private:
    std::unique_ptr<Record> m_record;
};

/// A cell of a table.
struct CellTag {
    int columns = 1; ///< 0: covered by another cell
    int rows = 1;
    const char *scope = nullptr; ///< of a heading cell
};

/// During its life, what is drawn belongs to an element inside that of the enclosing tag. Without Tagging it
/// does nothing. What belongs to no element is an artifact of the page: rules, running heads, footers.
class Tag {
public:
    /// `of`: where the same is given again on this page or the next, the element is continued; null: always a
    /// new element. Without a type all within is an artifact.
    explicit Tag(const char *type, const void *of = nullptr);
    Tag(const CellTag &cell, const void *of);
    /// A figure, all of which is one content; `alternative` in words, or the sentence of a figure.
    Tag(QPainter &painter, const QRectF &area, const QString &alternative);
    Tag(QPainter &painter, const QRectF &area, const Figure &figure);
    ~Tag();
    Tag(const Tag &) = delete;
    Tag &operator=(const Tag &) = delete;

    /// True where this was drawn neither on this page nor the one before: repeated heads of tables are
    /// artifacts.
    [[nodiscard]] static bool isFirst(const void *of);

private:
    void open(const StructureKind &kind, const void *of);
    void beginFigure(const QRectF &area, const QString &alternative);

    QPainter *m_figure = nullptr; ///< of a figure that marks its content
    bool m_artifact = false;
    bool m_opened = false;
};

/// During its life, the next content is that of a link.
class LinkTag {
public:
    explicit LinkTag(bool linked);
    ~LinkTag();
    LinkTag(const LinkTag &) = delete;
    LinkTag &operator=(const LinkTag &) = delete;

private:
    bool m_linked;
};

/// True if what is drawn next belongs to the content that has begun.
[[nodiscard]] bool contentGoesOn();

/// Begins the next content of the current element unless the last one goes on; called before text is drawn.
void markContent(QPainter &painter);

// How contents are marked in what Qt writes: a line from this x that finishPdf() takes out again; the y is
// the entry of the content, 0 for an artifact, the other x what begins.
inline constexpr int markX = -99999;
enum class MarkedAs { text = 1, figure, endOfFigure };

} // namespace palmer
