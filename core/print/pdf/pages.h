// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <functional>
#include <vector>

class QPainter;

namespace palmer {

/// Something on a page: what draws it, and where, in points from the page's top left corner.
struct PagePart {
    QPointF place;
    std::function<void(QPainter &, QPointF)> draw;
};

/// The beginning of a test or of a part over all tests (level 0) or of a section in it (1).
struct Bookmark {
    int level = 0;
    QString title;
    double y = 0;   ///< points from the top
    QString anchor; ///< what links lead to it by; may be empty
};

/// An area that leads to the place of the bookmark with this anchor, on whatever page that stands.
struct PageLink {
    QRectF area;
    QString anchor;
};

/// A page ready to be drawn; it needs nothing of the report it was made from. Size in points.
struct PrintedPage {
    QSizeF size;
    std::vector<PagePart> parts; ///< in the order of reading; running head first, footer last
    std::vector<Bookmark> bookmarks = {};
    std::vector<PageLink> links = {};
};

using Pages = std::vector<PrintedPage>;

/// The report as pages, with running heads, footers and the numbers of pages put in. A section never starts
/// in the last 25 mm, a figure keeps its caption, the results with their verdict stay whole, heads of split
/// tables repeat. Any report gives pages; an empty one gives one page. Needs a QApplication (figures).
[[nodiscard]] Pages layoutPages(const Report &report);

/// The report as its pages carry it: with the numbers of pages put in, and the verdict of a test directly
/// below its head where the results find no room on that page.
[[nodiscard]] Report arrangedForPages(const Report &report);

/// Draws a page on paper, in a preview or into a file. One unit of the painter is a point; the page is not
/// filled.
void drawPage(QPainter &painter, const PrintedPage &page);

} // namespace palmer
