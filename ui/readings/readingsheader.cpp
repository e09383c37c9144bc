// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/readingsheader.h"

#include "ui/formulatext.h"
#include "ui/readings/readingsdelegate.h"
#include "ui/theme.h"

#include <QPaintEvent>
#include <QPainter>

namespace palmer::ui {

namespace {

constexpr int headHeight = 44;

} // namespace

ReadingsHeader::ReadingsHeader(const ReadingsModel &model, QWidget *parent)
    : QHeaderView(Qt::Horizontal, parent)
    , m_model(model) {
    setSectionResizeMode(QHeaderView::Fixed);
    setSectionsClickable(true);
    setHighlightSections(false);
    setMinimumSectionSize(1);
}

QSize ReadingsHeader::sizeHint() const {
    return {QHeaderView::sizeHint().width(), headHeight};
}

void ReadingsHeader::paintColumn(QPainter &painter, int column, const QRect &area) const {
    const ReadingsModel::Head &head = m_model.head(column);
    const bool grouped = !head.group.isEmpty();
    const QRect lower =
        grouped ? area.adjusted(2, height() / 2, -textMargin, 0) : area.adjusted(2, 0, -textMargin, 0);
    QColor colour = token(Token::secondaryText, palette());
    if (head.approach)
        colour = token(*head.approach == Direction::positive ? Token::up : Token::downText, palette());
    else if (!grouped)
        colour = palette().color(QPalette::Text);
    drawFormula(painter, lower, Qt::AlignRight | Qt::AlignVCenter, head.text,
                grouped && !head.approach ? themeFont(TextSize::small) : font(), colour,
                head.approach.has_value());
}

void ReadingsHeader::paintEvent(QPaintEvent *event) {
    QPainter painter(viewport());
    painter.fillRect(event->rect(), palette().color(QPalette::Window));
    const QColor line = token(Token::line, palette());
    const int columns = count();
    int from = 0;
    while (from < columns) {
        const QString &group = m_model.head(from).group;
        int to = from;
        while (to + 1 < columns && !group.isEmpty() && m_model.head(to + 1).group == group)
            ++to;
        const int left = sectionViewportPosition(from);
        const int right = sectionViewportPosition(to) + sectionSize(to);
        if (right > event->rect().left() && left <= event->rect().right() && right > left) {
            for (int column = from; column <= to; ++column) {
                if (!isSectionHidden(column))
                    paintColumn(painter, column,
                                QRect(sectionViewportPosition(column), 0, sectionSize(column), height() - 1));
            }
            if (!group.isEmpty()) {
                painter.setFont(themeFont(TextSize::small));
                painter.setPen(palette().color(QPalette::Text));
                // The title of a wide group stays in the visible part.
                const int seenLeft = std::max(left, 0);
                const int seenRight = std::min(right, viewport()->width());
                painter.drawText(QRect(seenLeft, 3, seenRight - seenLeft, height() / 2 - 3), Qt::AlignCenter,
                                 group);
                painter.setPen(line);
                painter.drawLine(left + 6, height() / 2 + 1, right - 7, height() / 2 + 1);
            }
            if (from >= ReadingsModel::positionColumn) {
                painter.setPen(line);
                painter.drawLine(right - 1, 0, right - 1, height() - 1);
            }
        }
        from = to + 1;
    }
    painter.setPen(token(Token::lineStrong, palette()));
    painter.drawLine(0, height() - 1, viewport()->width(), height() - 1);
}

} // namespace palmer::ui
