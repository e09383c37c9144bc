// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/logo.h"

#include "system/streams.h"

#include <QPainter>
#include <QSvgRenderer>

namespace palmer {

namespace {

constexpr int largestSide = 1200; ///< pixels: 3000 dpi at 10 mm

QImage pngImage(const QByteArray &bytes) {
    // libpng itself reports damaged pictures there, but Palmer reports them once in its own words.
    const QuietErrors quiet;
    return QImage::fromData(bytes, "PNG");
}

QImage onWhite(const QImage &image) {
    QImage result(image.size(), QImage::Format_RGB32);
    result.fill(Qt::white);
    QPainter painter(&result);
    painter.drawImage(0, 0, image);
    return result;
}

} // namespace

Logo::Logo(const QByteArray &bytes) {
    if (bytes.isEmpty())
        return;
    if (bytes.startsWith("\x89PNG")) {
        QImage image = pngImage(bytes);
        if (image.isNull())
            return;
        if (std::max(image.width(), image.height()) > largestSide)
            image = image.scaled(largestSide, largestSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        m_pixels = onWhite(image);
        m_size = m_pixels.size();
        return;
    }
    m_vector = std::make_shared<QSvgRenderer>(bytes);
    if (m_vector->isValid()) {
        m_vector->setAspectRatioMode(Qt::KeepAspectRatio);
        m_size = m_vector->viewBoxF().size();
        if (m_size.isEmpty())
            m_size = m_vector->defaultSize();
    }
}

QSizeF Logo::size(QSizeF room) const {
    return empty() ? QSizeF(0, 0) : m_size.scaled(room, Qt::KeepAspectRatio);
}

void Logo::draw(QPainter &painter, const QRectF &rect) const {
    if (empty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::LosslessImageRendering);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (m_vector)
        m_vector->render(&painter, rect);
    else
        painter.drawImage(rect, m_pixels);
    painter.restore();
}

} // namespace palmer
