// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/readingsdelegate.h"

#include "ui/readings/readingsmodel.h"
#include "ui/theme.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPainter>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int rulingBar = 3;
constexpr int cornerSize = 7;

/// Blends a colour over an opaque background.
QColor tint(const QColor &colour, const QColor &ground, double strength) {
    const auto mix = [strength](int a, int b) { return qRound(a * strength + b * (1 - strength)); };
    return {mix(colour.red(), ground.red()), mix(colour.green(), ground.green()),
            mix(colour.blue(), ground.blue())};
}

/// Mark of a possible outlier, recognisable by shape and place, not only by colour.
void paintCorner(QPainter &painter, const QRect &cell, const QColor &colour) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    const QPoint corner = cell.topRight() + QPoint(0, 1);
    painter.drawPolygon(QPolygon({corner, corner - QPoint(cornerSize, 0), corner + QPoint(0, cornerSize)}));
    painter.restore();
}

/// Frames a cell, the current one heavily.
void paintFrame(QPainter &painter, const QRect &cell, const QColor &colour, bool current, Qt::PenStyle line) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = current ? 2 : 1;
    painter.setPen(QPen(colour, width, line));
    painter.setBrush(Qt::NoBrush);
    const double inset = current ? 1 : 1.5;
    painter.drawRoundedRect(QRectF(cell).adjusted(inset, inset, -inset - 1, -inset - 1), 3, 3);
    painter.restore();
}

/// In narrow columns only the background marks determining rows, so that no digit is clipped.
QFont boldWhereItFits(const QFont &font, const QString &text, int width) {
    QFont bold = font;
    bold.setBold(true);
    return QFontMetrics(bold).horizontalAdvance(text) <= width ? bold : font;
}

/// State of a cell for its background, in order of precedence.
struct CellState {
    bool ruling = false;
    bool selected = false; ///< except the current cell
    bool inCurrentRow = false;
    bool computed = false;
};

QColor groundOf(const CellState &state, const QPalette &palette) {
    const QColor base = palette.color(QPalette::Base);
    const QColor accent = token(Token::accent, palette);
    if (state.ruling)
        return tint(token(Token::explanation, palette), base, 0.13);
    if (state.selected)
        return tint(accent, base, 0.26);
    if (state.inCurrentRow)
        return tint(accent, base, 0.13);
    return state.computed ? tint(palette.color(QPalette::Window), base, 0.6) : base;
}

constexpr auto initialText = "initialText";

} // namespace

void ReadingsDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                             const QModelIndex &index) const {
    const QPalette &palette = option.palette;
    const QRect cell = option.rect;
    const auto *model = static_cast<const ReadingsModel *>(index.model());
    const bool computed = index.column() >= model->computedColumn();
    const bool ruling = std::ranges::find(m_ruling, index.row()) != m_ruling.end();
    const bool selected = (option.state & QStyle::State_Selected) != 0;
    const bool current = m_current == index;
    const QColor base = palette.color(QPalette::Base);
    const QColor accent = token(Token::accent, palette);

    const bool inCurrentRow = m_current.isValid() && m_current.row() == index.row() && !current;
    painter->fillRect(cell, groundOf({ruling, selected && !current, inCurrentRow, computed}, palette));

    painter->setPen(token(Token::line, palette));
    painter->drawLine(cell.bottomLeft(), cell.bottomRight());
    if (index.data(ReadingsModel::groupEndRole).toBool()) {
        painter->setPen(tint(palette.color(QPalette::Text), base, 0.22));
        painter->drawLine(cell.topRight(), cell.bottomRight());
    }
    if (ruling && index.column() == ReadingsModel::numberColumn)
        painter->fillRect(QRect(cell.left(), cell.top(), rulingBar, cell.height()),
                          token(Token::explanation, palette));

    const bool refused = !index.data(ReadingsModel::refusedRole).toString().isEmpty();
    if (refused && !ruling)
        painter->fillRect(cell.adjusted(0, 0, -1, -1), token(Token::badGround, palette));
    const bool excluded = index.data(ReadingsModel::excludedRole).toBool();
    const bool missing = index.data(ReadingsModel::missingRole).toBool();
    QFont font = option.font;
    font.setStrikeOut(excluded);
    const QRect textArea = cell.adjusted(2, 0, -textMargin, 0);
    const QString text = index.data(Qt::DisplayRole).toString();
    painter->setFont(ruling && !computed ? boldWhereItFits(font, text, textArea.width()) : font);
    const bool secondary =
        excluded || missing || computed || (index.column() == ReadingsModel::numberColumn && !ruling);
    painter->setPen(refused     ? token(Token::bad, palette)
                    : secondary ? token(Token::secondaryText, palette)
                                : palette.color(QPalette::Text));
    painter->drawText(textArea, Qt::AlignRight | Qt::AlignVCenter,
                      refused ? painter->fontMetrics().elidedText(text, Qt::ElideRight, textArea.width())
                              : text);
    if (index.data(ReadingsModel::outlierRole).toBool())
        paintCorner(*painter, cell, token(Token::unsure, palette));

    const bool hovered = m_hovered == index;
    const bool next = m_next == index && !current;
    if (current || hovered || next)
        paintFrame(*painter, cell, accent, current, next && !hovered ? Qt::DashLine : Qt::SolidLine);
}

QWidget *ReadingsDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &,
                                        const QModelIndex &) const {
    auto *field = new QLineEdit(parent);
    field->setObjectName(QStringLiteral("readingField"));
    field->setProperty("cell", true);
    field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return field;
}

void ReadingsDelegate::setEditorData(QWidget *editor, const QModelIndex &index) const {
    auto *field = static_cast<QLineEdit *>(editor);
    // Typing is kept when other data arrive.
    if (field->property(initialText).isValid())
        return;
    const QString text = index.data(Qt::EditRole).toString();
    field->setProperty(initialText, text);
    field->setText(text);
    field->selectAll();
}

void ReadingsDelegate::setModelData(QWidget *editor, QAbstractItemModel *, const QModelIndex &index) const {
    const QString text = static_cast<QLineEdit *>(editor)->text();
    if (text != editor->property(initialText).toString())
        emit typed(index, text);
}

void ReadingsDelegate::updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                                            const QModelIndex &) const {
    editor->setGeometry(option.rect);
}

bool ReadingsDelegate::eventFilter(QObject *watched, QEvent *event) {
    auto *editor = qobject_cast<QWidget *>(watched);
    if (!editor || event->type() != QEvent::KeyPress)
        return QStyledItemDelegate::eventFilter(watched, event);
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool shift = key->modifiers().testFlag(Qt::ShiftModifier);
    Step step = Step::stay;
    switch (key->key()) {
    case Qt::Key_Enter:
    case Qt::Key_Return:
        step = shift ? Step::previous : Step::next;
        break;
    case Qt::Key_Tab:
        step = Step::right;
        break;
    case Qt::Key_Backtab:
        step = Step::left;
        break;
    case Qt::Key_Up:
        step = Step::up;
        break;
    case Qt::Key_Down:
        step = Step::down;
        break;
    default:
        return QStyledItemDelegate::eventFilter(watched, event);
    }
    emit commitData(editor);
    emit closeEditor(editor, NoHint);
    emit stepWanted(step);
    return true;
}

} // namespace palmer::ui
