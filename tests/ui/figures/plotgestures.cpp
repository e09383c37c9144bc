// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/plotgestures.h"

#include <QTest>
#include <QWheelEvent>

using namespace palmer;
using namespace palmer::ui;

namespace {

/// A plot of 0 … 100 by 0 … 10 over 400 × 200 pixels.
class Plot : public PlotCanvas {
public:
    Plot()
        : PlotCanvas(nullptr) {
        resize(400, 200);
    }

    [[nodiscard]] QRectF range() const override { return m_range; }
    void setRange(const QRectF &range) override { m_range = rangeWithin(range, whole(), deepestZoom()); }
    [[nodiscard]] QPointF valueAt(const QPointF &place) const override {
        return {m_range.left() + place.x() / width() * m_range.width(),
                m_range.bottom() - place.y() / height() * m_range.height()};
    }
    [[nodiscard]] QRectF whole() const override { return {0, 0, 100, 10}; }

    int clicks = 0;
    std::optional<QPointF> hovered;
    QSizeF deepest{50, 50};

protected:
    [[nodiscard]] QSizeF deepestZoom() const override { return deepest; }
    [[nodiscard]] QRectF plotArea() const override { return rect(); }
    void drawPicture(QPainter &) override {}
    void hover(const std::optional<QPointF> &at) override { hovered = at; }
    void click(const QPointF &) override { ++clicks; }

private:
    QRectF m_range{0, 0, 100, 10};
};

void wheel(Plot &plot, QPointF at, int steps) {
    QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&plot, &event);
    QVERIFY(event.isAccepted());
}

void move(Plot &plot, QPointF at, Qt::MouseButtons buttons) {
    QMouseEvent event(QEvent::MouseMove, at, plot.mapToGlobal(at), Qt::NoButton, buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(&plot, &event);
}

} // namespace

/// Zoom, pan and hover of all plots.
class PlotGesturesTest : public QObject {
    Q_OBJECT

private slots:
    void theWheelKeepsTheValueUnderThePointer() {
        Plot plot;
        const QPointF at(300, 50);
        const QPointF value = plot.valueAt(at);
        for (int k = 0; k < 40; ++k) { // beyond the limit
            wheel(plot, at, 1);
            const QPointF away = plot.valueAt(at) - value;
            QVERIFY(std::abs(away.x()) < 1e-9 && std::abs(away.y()) < 1e-9);
        }
        QVERIFY(std::abs(plot.range().width() - 2) < 1e-9);
        for (int k = 0; k < 40; ++k)
            wheel(plot, at, -1);
        QVERIFY(plot.range() == plot.whole());
    }

    void aDepthOfOneNeverZooms() {
        Plot plot;
        plot.deepest = {50, 1};
        plot.zoomBy(3);
        QVERIFY(plot.range().width() < 60);
        QCOMPARE(plot.range().top(), 0.0);
        QCOMPARE(plot.range().height(), 10.0);
    }

    void draggingMovesAndAClickDoesNot() {
        Plot plot;
        plot.setRange({40, 4, 20, 2});
        QTest::mousePress(&plot, Qt::LeftButton, {}, {200, 100});
        move(plot, {201, 100}, Qt::LeftButton);
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, {201, 100});
        QCOMPARE(plot.range(), QRectF(40, 4, 20, 2));
        QCOMPARE(plot.clicks, 1);
        QTest::mousePress(&plot, Qt::LeftButton, {}, {200, 100});
        move(plot, {260, 130}, Qt::LeftButton);
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, {260, 130});
        QCOMPARE(plot.range(), QRectF(37, 4.3, 20, 2));
        QCOMPARE(plot.clicks, 1);
        QTest::keyClick(&plot, Qt::Key_Right); // 40 pixels
        QCOMPARE(plot.range(), QRectF(39, 4.3, 20, 2));
        QTest::mouseDClick(&plot, Qt::LeftButton, {}, {200, 100});
        QCOMPARE(plot.range(), plot.whole());
    }

    void aPointerThatLeavesIsForgotten() {
        Plot plot;
        move(plot, {10, 10}, Qt::NoButton);
        QCOMPARE(plot.hovered, std::optional(QPointF(10, 10)));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&plot, &leave);
        QVERIFY(!plot.hovered);
    }

    void otherKeysAreLeftToTheWindow() {
        Plot plot;
        QKeyEvent key(QEvent::KeyPress, Qt::Key_PageDown, Qt::NoModifier);
        QCoreApplication::sendEvent(&plot, &key);
        QVERIFY(!key.isAccepted());
    }
};

QTEST_MAIN(PlotGesturesTest)
#include "plotgestures.moc"
