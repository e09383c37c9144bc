// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/thinsplitter.h"

#include "ui/theme.h"

#include <QMouseEvent>
#include <QPainter>

namespace palmer::ui {

namespace {

constexpr int grabWidth = 8;

class ThinHandle : public QSplitterHandle {
public:
    using QSplitterHandle::QSplitterHandle;

protected:
    // The splitter makes the handle a few pixels wider than its line; here it is widened to grabWidth, over
    // its neighbours, and paints only its line.
    void resizeEvent(QResizeEvent *) override { widen(); }
    void moveEvent(QMoveEvent *) override { widen(); }

    void paintEvent(QPaintEvent *) override {
        QPainter painter(this);
        painter.fillRect(line(), token(Token::line, palette()));
    }

    void mousePressEvent(QMouseEvent *event) override {
        m_offset = along(event->position().toPoint()) - along(line().topLeft());
    }
    void mouseMoveEvent(QMouseEvent *event) override {
        if (event->buttons().testFlag(Qt::LeftButton))
            moveSplitter(along(mapToParent(event->position().toPoint())) - m_offset);
    }
    void mouseReleaseEvent(QMouseEvent *) override {}

private:
    [[nodiscard]] int along(const QPoint &point) const {
        return orientation() == Qt::Horizontal ? point.x() : point.y();
    }
    [[nodiscard]] QRect line() const {
        constexpr int start = (grabWidth - 1) / 2;
        return orientation() == Qt::Horizontal ? QRect(start, 0, 1, height()) : QRect(0, start, width(), 1);
    }
    void widen() {
        const QRect now = geometry();
        QRect wide = now;
        if (orientation() == Qt::Horizontal)
            wide.setRect(now.center().x() - (grabWidth - 1) / 2, now.y(), grabWidth, now.height());
        else
            wide.setRect(now.x(), now.center().y() - (grabWidth - 1) / 2, now.width(), grabWidth);
        if (wide.size() != now.size())
            setGeometry(wide);
        setMask(line()); // only the line is painted
    }

    int m_offset = 0;
};

} // namespace

ThinSplitter::ThinSplitter(Qt::Orientation orientation, QWidget *parent)
    : QSplitter(orientation, parent) {
    setHandleWidth(1);
    setChildrenCollapsible(false);
}

QSplitterHandle *ThinSplitter::createHandle() {
    auto *handle = new ThinHandle(orientation(), this);
    handle->setAttribute(Qt::WA_MouseNoMask);
    handle->setFocusPolicy(Qt::NoFocus);
    return handle;
}

} // namespace palmer::ui
