// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/resultsdelegate.h"

#include "print/figures/style.h"
#include "ui/elidedlabel.h"
#include "ui/formulatext.h"
#include "ui/results/resultsmodel.h"
#include "ui/theme.h"
#include "ui/verdictmark.h"

#include <QPainter>
#include <string_view>

namespace palmer::ui {

namespace {

constexpr double scaleHalf = 25;
constexpr double bandHalfHeight = 5.5;
constexpr double diamond = 4;
constexpr double hatchStep = 3.2;
constexpr int resultMarkWidth = 20;
constexpr double dimmed = 0.55;

void paintScale(QPainter &painter, const QRect &area, const DecisionScale &scale, const QColor &valueColour,
                const QPalette &palette) {
    const double middle = area.center().x() + 0.5;
    const double y = area.center().y() + 0.5;
    painter.setPen(QPen(token(Token::secondaryText, palette), 1));
    painter.drawLine(QPointF(middle - scaleHalf, y), QPointF(middle + scaleHalf, y));
    if (scale.band) {
        const double half = scaleHalf * DecisionScale::guard;
        const QRectF band(middle - half, y - bandHalfHeight, 2 * half, 2 * bandHalfHeight);
        painter.save();
        painter.setClipRect(band);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(token(Token::secondaryText, palette), 0.8));
        double x = band.left() - band.height();
        while (x < band.right()) {
            painter.drawLine(QPointF(x, band.bottom()), QPointF(x + band.height(), band.top()));
            x += hatchStep;
        }
        painter.restore();
    }
    painter.setPen(QPen(palette.color(QPalette::Text), 2));
    painter.drawLine(QPointF(middle, y - 6), QPointF(middle, y + 6));

    const double x = middle + scale.value * (scaleHalf - (scale.below || scale.above ? 0 : diamond));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette.color(QPalette::Base), 1));
    painter.setBrush(valueColour);
    if (scale.below || scale.above) {
        const double tip = scale.above ? x + 2 : x - 2;
        const double back = scale.above ? tip - 8 : tip + 8;
        painter.drawPolygon(QPolygonF{{tip, y}, {back, y - 4.5}, {back, y + 4.5}});
    } else {
        painter.drawPolygon(
            QPolygonF{{x, y - diamond}, {x + diamond, y}, {x, y + diamond}, {x - diamond, y}});
    }
    painter.restore();
}

/// Colour of the verdict, dimmed while the test is unfinished.
QColor colourOf(const ResultLine &line, bool provisional, const QPalette &palette) {
    const QColor colour =
        line.verdict ? token(verdictMark(line.verdict).colour, palette) : palette.color(QPalette::Text);
    return provisional ? blend(colour, palette.color(QPalette::Base), dimmed) : colour;
}

void paintVerdict(QPainter &painter, const QRect &cell, const ResultLine &line, bool provisional,
                  const QStyleOptionViewItem &option) {
    const QColor colour = colourOf(line, provisional, option.palette);
    drawLineIcon(painter, QRect(cell.left(), cell.top(), resultMarkWidth - 4, cell.height()),
                 verdictMark(line.verdict).icon, colour);
    QFont font = option.font;
    font.setWeight(provisional ? QFont::Normal : QFont::DemiBold);
    drawElided(painter, cell.adjusted(resultMarkWidth, 0, 0, 0), Qt::AlignLeft, line.cell("verdict"), font,
               colour);
}

const ResultLine &lineAt(const QModelIndex &index) {
    return static_cast<const ResultsModel *>(index.model())->line(index.row());
}

} // namespace

QColor ResultsDelegate::ground(const QStyleOptionViewItem &option, const QModelIndex &index) const {
    const QColor base = option.palette.color(QPalette::Base);
    return lineAt(index).id == m_explained ? blend(token(Token::explanation, option.palette), base, 0.13)
           : isCurrentRow(option, index)   ? selectedGround(option.palette)
                                           : base;
}

void ResultsDelegate::paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                                   const QModelIndex &index) const {
    const ResultLine &line = lineAt(index);
    const bool provisional = static_cast<const ResultsModel *>(index.model())->table().provisional;
    const QPalette &palette = option.palette;
    const QRect cell = option.rect;
    const ResultColumn &column = ResultsModel::column(index.column());
    if (line.isFirst && index.row() > 0) {
        painter.setPen(token(Token::line, palette));
        painter.drawLine(cell.topLeft(), cell.topRight());
    }
    if (line.id == m_explained && column.look == ResultLook::symbol)
        painter.fillRect(QRect(cell.left(), cell.top(), 3, cell.height()),
                         token(Token::explanation, palette));

    const QColor text = palette.color(QPalette::Text);
    const QColor secondary = token(Token::secondaryText, palette);
    QFont font = option.font;
    switch (column.look) {
    case ResultLook::symbol:
        drawFormula(painter, cell.adjusted(8, 0, 0, 0), Qt::AlignLeft, line.symbol, font,
                    line.main ? text : secondary, line.main);
        return;
    case ResultLook::picture:
        if (line.scale)
            paintScale(painter, cell, *line.scale, colourOf(line, provisional, palette), palette);
        return;
    case ResultLook::verdict:
        if (line.verdict)
            paintVerdict(painter, cell, line, provisional, option);
        return;
    case ResultLook::text:
    case ResultLook::name:
    case ResultLook::number:
        break;
    }
    const QString shown = index.data(Qt::DisplayRole).toString();
    const std::string_view key = column.key;
    const bool strong = key == "value" && line.main;
    const bool isUncertainty = key == "expandedUncertainty" || key == "otherUncertainty";
    const bool quiet =
        (!line.main && column.look == ResultLook::name) || isUncertainty || shown == QStringLiteral("–");
    const bool exceeded = key == "other" && line.otherVerdict == Verdict::doesNotConform;
    if (strong)
        font.setWeight(QFont::DemiBold);
    const bool isNumber = ResultsModel::isNumber(index.column());
    const int after = isNumber ? static_cast<const ResultsModel *>(index.model())
                                     ->roomAfter(shown, index.column(), QFontMetrics(font))
                               : 0;
    drawElided(painter, cell.adjusted(2, 0, -4 - after, 0), isNumber ? Qt::AlignRight : Qt::AlignLeft, shown,
               font,
               exceeded ? token(Token::bad, palette)
               : quiet  ? secondary
                        : text);
}

} // namespace palmer::ui
