// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QRectF>
#include <QSizeF>
#include <memory>

class QPainter;
class QSvgRenderer;

namespace palmer {

/// A picture in the head of a report, PNG or SVG; empty for anything else. Opaque, because archival PDF does
/// not support transparency.
class Logo {
public:
    explicit Logo(const QByteArray &bytes);

    [[nodiscard]] bool empty() const { return m_size.isEmpty(); }
    /// Largest size that fits into `room`, keeping the proportions.
    [[nodiscard]] QSizeF size(QSizeF room) const;
    void draw(QPainter &painter, const QRectF &rect) const;

private:
    std::shared_ptr<QSvgRenderer> m_vector;
    QImage m_pixels;
    QSizeF m_size;
};

} // namespace palmer
