// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/blocks/report.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

class QPainter;

namespace palmer {

/// A part of a page: how and where it is drawn, in points from the top left corner of the page.
struct PagePart {
    QPointF place;
    std::function<void(QPainter &, QPointF)> draw;
    bool linked = false; ///< one of the links of its page is its area
};

/// Beginning of a test or of a part about all tests (level 0), or of a section in it (1).
struct Bookmark {
    int level = 0;
    QString title;
    double y = 0;   ///< points from the top
    QString anchor; ///< target of links; may be empty
};

/// An area that links to the bookmark with this anchor, on any page.
struct PageLink {
    QRectF area;
    QString anchor;
};

/// A page ready for drawing, independent of its report. Size in points.
struct PrintedPage {
    QSizeF size;
    std::vector<PagePart> parts; ///< in reading order; running head first, footer last
    std::vector<Bookmark> bookmarks = {};
    std::vector<PageLink> links = {};
};

using Pages = std::vector<PrintedPage>;

/// A report as pages with running heads, footers and page numbers. A section never starts in the last 25 mm,
/// a figure keeps its caption, a verdict follows its head, heads of split tables are repeated. Every report
/// gives at least one page. Pages are made when they are asked for: of a long report only a few are in
/// memory. Requires a QApplication (figures).
class LaidOutReport {
public:
    /// If stop is requested meanwhile, the pages are not those of the report.
    explicit LaidOutReport(Report report, const std::stop_token &stop = {});

    [[nodiscard]] std::size_t pageCount() const { return m_count; }
    /// Page `index`, from 0; in their order each takes least time. With Tagging they are drawn one by one in
    /// their order, each before the next is made.
    [[nodiscard]] PrintedPage page(std::size_t index) { return m_page(index); }

private:
    std::size_t m_count = 0;
    std::function<PrintedPage(std::size_t)> m_page;
};

/// All pages of a report at once, independent of it.
[[nodiscard]] Pages layoutPages(const Report &report, const std::stop_token &stop = {});

/// The first page, or those before the first page break, whose references to other pages are dashes: soon
/// there, however long the report.
[[nodiscard]] Pages firstPages(const Report &report);

/// The report as it is printed: with page numbers filled in, and with the results of a test above its figure
/// if the figure does not fit below the head.
[[nodiscard]] Report arrangedForPages(const Report &report);

/// Draws a page on paper, in a preview or into a file. The painter unit is a point; the background is not
/// filled.
void drawPage(QPainter &painter, const PrintedPage &page);

} // namespace palmer
