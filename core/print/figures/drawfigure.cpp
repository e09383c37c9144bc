// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/drawfigure.h"

#include "figures/circlefigure.h"
#include "print/figures/drawkinds.h"
#include "print/fonts.h"

#include <QPainter>

namespace palmer {

namespace {

struct PaperSize {
    QSizeF operator()(const CurveFigure &) const { return {175, 86}; }
    QSizeF operator()(const CircleFigure &figure) const { return printedSize(figure); }
    QSizeF operator()(const LineFigure &) const { return {175, 62}; }
    QSizeF operator()(const BarFigure &figure) const { return {175, printedHeight(figure)}; }
    QSizeF operator()(const HistogramFigure &) const { return {130, 62}; }
    QSizeF operator()(const TrendFigure &figure) const {
        constexpr double row = 26;
        constexpr double alone = 90;
        return {175, figure.panels.size() == 1 && figure.label.isEmpty() ? alone : row};
    }
};

} // namespace

QSizeF paperSize(const Figure &figure) {
    return std::visit(PaperSize(), figure);
}

FigureTransform drawFigure(QPainter &painter, const QRectF &rect, const Figure &figure, Medium medium) {
    loadFonts();
    const double unit = medium == Medium::paper ? 1 : 1 / pointsPerPixel; // painter units per point
    painter.save();
    if (medium != Medium::paper)
        painter.fillRect(rect, figureColor(FigureRole::background, medium));
    painter.translate(rect.topLeft());
    painter.scale(unit, unit);
    const QRectF area(QPointF(0, 0), rect.size() / unit);
    FigureTransform drawn =
        std::visit([&](const auto &kind) { return drawKind(painter, area, kind, medium); }, figure);
    painter.restore();

    const QTransform back = QTransform::fromTranslate(rect.left(), rect.top()).scale(unit, unit);
    drawn.plotArea = back.mapRect(drawn.plotArea);
    drawn.toPainter = drawn.toPainter * back;
    drawn.readingShift *= unit;
    return drawn;
}

} // namespace palmer
