#include "ui/figures/exportfigure.h"

#include "ui/figures/drawfigure.h"

#include <QBuffer>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <stdexcept>

namespace palmer::ui {

namespace {

constexpr double millimetresPerInch = 25.4;

QRectF pageInPoints(const Figure &figure) {
    return {QPointF(0, 0), paperSize(figure) * pointsPerMillimetre};
}

void begin(QPainter &painter, QPaintDevice *device) {
    if (!painter.begin(device))
        throw std::runtime_error("the figure cannot be drawn");
}

} // namespace

QByteArray figureAsSvg(const Figure &figure, const QString &title) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const QRectF page = pageInPoints(figure);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(72);
    generator.setSize(page.size().toSize());
    generator.setViewBox(page);
    generator.setTitle(title);
    generator.setDescription(QString());
    QPainter painter;
    begin(painter, &generator);
    drawFigure(painter, page, figure, Medium::paper);
    painter.end();
    return buffer.data();
}

QByteArray figureAsPdf(const Figure &figure, const QString &title) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(1200);
        writer.setPageLayout(
            QPageLayout(QPageSize(paperSize(figure), QPageSize::Millimeter, QString(), QPageSize::ExactMatch),
                        QPageLayout::Portrait, QMarginsF(0, 0, 0, 0), QPageLayout::Millimeter));
        writer.setTitle(title);
        writer.setCreator(QStringLiteral("Palmer"));
        QPainter painter;
        begin(painter, &writer);
        painter.scale(1200 / 72.0, 1200 / 72.0);
        drawFigure(painter, pageInPoints(figure), figure, Medium::paper);
    }
    return buffer.data();
}

QByteArray figureAsPng(const Figure &figure, int dotsPerInch) {
    const double scale = dotsPerInch / 72.0;
    const QRectF page = pageInPoints(figure);
    QImage image((page.size() * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    image.setDotsPerMeterX(qRound(dotsPerInch * 1000 / millimetresPerInch));
    image.setDotsPerMeterY(qRound(dotsPerInch * 1000 / millimetresPerInch));
    QPainter painter;
    begin(painter, &image);
    painter.scale(scale, scale);
    drawFigure(painter, page, figure, Medium::paper);
    painter.end();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw std::runtime_error("the figure cannot be written as PNG");
    return buffer.data();
}

} // namespace palmer::ui
