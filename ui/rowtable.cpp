// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/rowtable.h"

#include "print/figures/drawkinds.h"
#include "print/pdf/marks.h"
#include "ui/measures.h"
#include "ui/quiettable.h"
#include "ui/theme.h"

#include <QHeaderView>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int lowRowHeight = 22;
constexpr double barHeight = 9;
constexpr int markSize = 16;
constexpr double widestHistogram = 180;
constexpr double outdatedOpacity = 0.4;

/// Width of a warning's mark and words on the right of a cell.
int warningWidth(const QString &warning, const QFontMetrics &metrics) {
    return warning.isEmpty() ? 0 : markSize + 4 + metrics.horizontalAdvance(warning) + tablePadding;
}

/// Draws texts as QuietDelegate and the pictures of the roles.
class PictureDelegate : public QuietDelegate {
public:
    explicit PictureDelegate(RowTable *table)
        : QuietDelegate(table)
        , m_table(*table) {}

    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override {
        QStyleOptionViewItem shown = option;
        shown.state &= ~QStyle::State_HasFocus; // the whole row is selected
        const QString warning = index.data(RowTable::warningRole).toString();
        const QFont small = themeFont(TextSize::small);
        const int room = warningWidth(warning, QFontMetrics(small));
        QuietDelegate::paintContent(painter, shown, index);
        const Medium medium = screenMedium(option.palette);
        const QRectF inner = QRectF(option.rect).adjusted(tablePadding, 0, -tablePadding, -1);
        if (const QVariant part = index.data(RowTable::barRole); part.isValid()) {
            QRectF bar = inner;
            bar.setHeight(barHeight);
            bar.moveCenter(inner.center());
            drawBar(painter, bar, part.toDouble(), index.data(RowTable::firstRole).toBool(), medium);
        }
        if (const QVariant whisker = index.data(RowTable::whiskerRole); whisker.isValid()) {
            constexpr double points = 72 / 25.4; // of a millimetre, in which the picture is drawn
            const double scale = inner.width() / (guardPictureWidth * points);
            painter.save();
            painter.setRenderHint(QPainter::Antialiasing);
            painter.translate(inner.left(), inner.center().y() - scale * points * guardPictureHeight / 2);
            painter.scale(scale, scale);
            drawWhisker(painter, {}, whisker.value<Whisker>(), option.palette.color(QPalette::Text),
                        option.palette.color(QPalette::Base));
            painter.restore();
        }
        if (const HistogramFigure *figure = m_table.histogram(index)) {
            QRectF plot = inner.adjusted(0, 3, 0, -2);
            plot.setWidth(std::min(plot.width(), widestHistogram));
            painter.setRenderHint(QPainter::Antialiasing);
            if (index.data(RowTable::outdatedRole).toBool())
                painter.setOpacity(outdatedOpacity);
            drawHistogramBars(painter, plot, *figure, medium, 2);
        }
        if (room > 0) {
            const QColor colour = token(Token::unsure, option.palette);
            const QRect place =
                option.rect.adjusted(option.rect.width() - room - tablePadding, 0, -tablePadding, 0);
            drawLineIcon(painter, QRect(place.left(), place.top(), markSize, place.height()),
                         QStringLiteral("warn"), colour);
            painter.setPen(colour);
            painter.setFont(small);
            painter.drawText(place.adjusted(markSize + 4, 0, tablePadding, 0),
                             Qt::AlignVCenter | Qt::AlignLeft, warning);
        }
    }

private:
    const RowTable &m_table;
};

} // namespace

RowTable::RowTable(const char *name, int columns, QWidget *parent)
    : QTableWidget(0, columns, parent) {
    setObjectName(QString::fromLatin1(name));
    makeQuiet(*this, lowRowHeight, tableRowHeight);
    setItemDelegate(new PictureDelegate(this));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    verticalHeader()->setMinimumSectionSize(lowRowHeight);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setMinimumSectionSize(20);
}

void RowTable::setHead(int column, const QString &text, bool number) {
    auto *item = new QTableWidgetItem(text);
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    setHorizontalHeaderItem(column, item);
}

QTableWidgetItem *RowTable::setCell(int row, int column, const QString &text, bool number, bool bold) {
    auto *item = new QTableWidgetItem(text);
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (bold) {
        QFont font = themeFont(TextSize::base);
        font.setBold(true);
        item->setFont(font);
    }
    setItem(row, column, item);
    return item;
}

void RowTable::setHistograms(std::vector<HistogramFigure> histograms) {
    m_histograms = std::move(histograms);
}

const HistogramFigure *RowTable::histogram(const QModelIndex &index) const {
    const QVariant number = index.data(histogramRole);
    if (!number.isValid() || number.toUInt() >= m_histograms.size())
        return nullptr;
    return &m_histograms[number.toUInt()];
}

int RowTable::wantedWidth(int column) const {
    const QFontMetrics head(themeFont(TextSize::small));
    const QTableWidgetItem *title = horizontalHeaderItem(column);
    int width = title ? head.horizontalAdvance(title->text()) : 0;
    for (int row = 0; row < rowCount(); ++row) {
        const QTableWidgetItem *cell = item(row, column);
        if (!cell)
            continue;
        const QVariant own = cell->data(Qt::FontRole);
        const QFontMetrics metrics(own.isValid() ? own.value<QFont>() : font());
        width = std::max(width, metrics.horizontalAdvance(cell->text()) +
                                    warningWidth(cell->data(warningRole).toString(), head));
    }
    return width + 2 * tablePadding + 2;
}

void RowTable::fitColumns() {
    if (m_flexible < 0)
        return;
    std::vector<int> widths;
    int left = viewport()->width();
    for (int column = 0; column < columnCount(); ++column) {
        const bool isOthers = column == m_flexible || column == m_pictures || isColumnHidden(column);
        widths.push_back(isOthers ? 0 : wantedWidth(column));
        left -= widths.back();
    }
    if (m_pictures >= 0) {
        const bool fits = left - m_pictureWidth >= wantedWidth(m_flexible);
        setColumnHidden(m_pictures, !fits);
        widths.at(static_cast<std::size_t>(m_pictures)) = fits ? m_pictureWidth : 0;
        left -= widths.at(static_cast<std::size_t>(m_pictures));
    }
    for (const int column : m_elided) { // the last ones shrink first
        int &width = widths.at(static_cast<std::size_t>(column));
        const int taken = std::clamp(m_least - left, 0, width / 2);
        width -= taken;
        left += taken;
    }
    widths.at(static_cast<std::size_t>(m_flexible)) = std::max(left, 0);
    for (int column = 0; column < columnCount(); ++column)
        setColumnWidth(column, widths.at(static_cast<std::size_t>(column)));
}

void RowTable::setPictures(int column, int width) {
    m_pictures = column;
    m_pictureWidth = width;
}

void RowTable::fit(int flexible, int least, std::initializer_list<int> elided) {
    setFixedHeight(tableRowHeight + rowCount() * lowRowHeight);
    m_flexible = flexible;
    m_least = least;
    m_elided = elided;
    fitColumns();
}

void RowTable::resizeEvent(QResizeEvent *event) {
    QTableWidget::resizeEvent(event);
    fitColumns();
}

QString RowTable::key(int row) const {
    const QTableWidgetItem *first = item(row, 0);
    return first ? first->data(keyRole).toString() : QString();
}

int RowTable::rowOf(const QString &wanted) const {
    for (int row = 0; row < rowCount(); ++row) {
        if (key(row) == wanted)
            return row;
    }
    return -1;
}

QSize RowTable::minimumSizeHint() const {
    return {0, tableRowHeight};
}

/// All rows are visible: leave the wheel to the page.
void RowTable::wheelEvent(QWheelEvent *event) {
    event->ignore();
}

} // namespace palmer::ui
