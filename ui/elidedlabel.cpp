#include "ui/elidedlabel.h"

#include <QPainter>

namespace palmer::ui {

ElidedLabel::ElidedLabel(QWidget *parent)
    : QLabel(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

void ElidedLabel::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, width());
    painter.drawText(rect(), static_cast<int>(alignment()), shown);
    setToolTip(shown == text() ? QString() : text());
}

} // namespace palmer::ui
