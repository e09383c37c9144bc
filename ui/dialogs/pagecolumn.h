// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/pages.h"

#include <QWidget>
#include <map>

namespace palmer::ui {

/// Printed pages in a column, as they will be printed, at any scale. Only visible pages are drawn.
class PageColumn : public QWidget {
    Q_OBJECT

public:
    explicit PageColumn(QWidget *parent = nullptr);

    void setPages(const Pages &pages);
    /// Pixels per point; keeps drawn pages if unchanged.
    void setScale(double scale);
    [[nodiscard]] double scale() const { return m_scale; }
    /// Thumbnail mode: numbers below the pages and a frame around the current one.
    void setNumbered(bool numbered) { m_numbered = numbered; }
    void setCurrent(int page);

    [[nodiscard]] int count() const { return static_cast<int>(m_pages.size()); }
    [[nodiscard]] QRect pageRect(int page) const;
    /// The page at a height, or the nearest.
    [[nodiscard]] int pageAt(int y) const;
    [[nodiscard]] QSize sizeHint() const override;

signals:
    void clicked(int page);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;

private:
    [[nodiscard]] int gap() const;
    [[nodiscard]] const QPixmap &picture(int page);

    Pages m_pages;
    std::map<int, QPixmap> m_pictures;
    double m_scale = 1;
    double m_ratio = 1;
    bool m_numbered = false;
    int m_current = -1;
};

} // namespace palmer::ui
