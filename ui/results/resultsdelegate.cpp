// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/resultsdelegate.h"

#include "print/figures/style.h"
#include "ui/formulatext.h"
#include "ui/results/resultsmodel.h"
#include "ui/theme.h"
#include "ui/verdictmark.h"

#include <QAbstractItemView>
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
    painter.setFont(font);
    painter.setPen(colour);
    const QRect room = cell.adjusted(resultMarkWidth, 0, 0, 0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(font).elidedText(line.cell("verdict"), Qt::ElideRight, room.width()));
}

/// With the keyboard, a row becomes current before it is selected.
bool isCurrentRow(const QStyleOptionViewItem &option, const QModelIndex &index) {
    const auto *table = qobject_cast<const QAbstractItemView *>(option.widget);
    return table && table->hasFocus() && table->currentIndex().row() == index.row();
}

} // namespace

void ResultsDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                            const QModelIndex &index) const {
    const auto *model = static_cast<const ResultsModel *>(index.model());
    const ResultLine &line = model->line(index.row());
    const QPalette &palette = option.palette;
    const QRect cell = option.rect;
    const QColor base = palette.color(QPalette::Base);
    const ResultColumn &column = ResultsModel::column(index.column());
    const bool explained = line.id == m_explained;
    const QColor explanation = token(Token::explanation, palette);

    QColor ground = base;
    if (explained)
        ground = blend(explanation, base, 0.13);
    else if (isCurrentRow(option, index))
        ground = selectedGround(palette);
    painter->fillRect(cell, ground);
    if (line.isFirst && index.row() > 0) {
        painter->setPen(token(Token::line, palette));
        painter->drawLine(cell.topLeft(), cell.topRight());
    }
    if (explained && column.look == ResultLook::symbol)
        painter->fillRect(QRect(cell.left(), cell.top(), 3, cell.height()), explanation);

    const QColor text = palette.color(QPalette::Text);
    const QColor secondary = token(Token::secondaryText, palette);
    QFont font = option.font;
    switch (column.look) {
    case ResultLook::symbol:
        drawFormula(*painter, cell.adjusted(8, 0, 0, 0), Qt::AlignLeft, line.symbol, font,
                    line.main ? text : secondary, line.main);
        return;
    case ResultLook::picture:
        if (line.scale)
            paintScale(*painter, cell, *line.scale, colourOf(line, model->table().provisional, palette),
                       palette);
        return;
    case ResultLook::verdict:
        if (line.verdict)
            paintVerdict(*painter, cell, line, model->table().provisional, option);
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
    painter->setFont(font);
    painter->setPen(exceeded ? token(Token::bad, palette) : quiet ? secondary : text);
    const QRect room = cell.adjusted(2, 0, -4, 0);
    painter->drawText(
        room, (ResultsModel::isNumber(index.column()) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
        QFontMetrics(font).elidedText(shown, Qt::ElideRight, room.width()));
}

} // namespace palmer::ui
