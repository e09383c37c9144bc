// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "print/pdf/pages.h"

#include <QWidget>
#include <map>

namespace palmer::ui {

/// Printed pages below one another, as they come out of the printer, in any size. Only what is in sight is
/// drawn.
class PageColumn : public QWidget {
    Q_OBJECT

public:
    explicit PageColumn(QWidget *parent = nullptr);

    void setPages(const Pages &pages);
    /// Pixels a point; keeps what was drawn where it is the same.
    void setScale(double scale);
    [[nodiscard]] double scale() const { return m_scale; }
    /// Writes the number below each page and frames the current one: the pages in small.
    void setNumbered(bool numbered) { m_numbered = numbered; }
    void setCurrent(int page);

    [[nodiscard]] int count() const { return static_cast<int>(m_pages.size()); }
    [[nodiscard]] QRect pageRect(int page) const;
    /// The page at a height; the nearest where there is none.
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
