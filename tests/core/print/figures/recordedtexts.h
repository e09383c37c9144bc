// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <memory>
#include <vector>

/// A paint device that keeps the texts and lines drawn on it and where they stand, for tests.
namespace palmer::testdata {

struct RecordedText {
    QString text;
    QRectF box;        ///< in device units, from the baseline to the height of capitals
    QPolygonF outline; ///< the same of a text that is turned
};

struct RecordedLine {
    QPolygonF points; ///< in device units
    QPen pen;
};

class TextRecorder : public QPaintDevice {
public:
    explicit TextRecorder(QSize size)
        : m_size(size)
        , m_engine(std::make_unique<Engine>(texts, lines)) {}

    [[nodiscard]] QPaintEngine *paintEngine() const override { return m_engine.get(); }

    std::vector<RecordedText> texts;
    std::vector<RecordedLine> lines;

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth:
            return m_size.width();
        case PdmHeight:
            return m_size.height();
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 72;
        case PdmDepth:
            return 32;
        case PdmDevicePixelRatio:
            return 1;
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    class Engine : public QPaintEngine {
    public:
        Engine(std::vector<RecordedText> &texts, std::vector<RecordedLine> &lines)
            : QPaintEngine(AllFeatures)
            , m_texts(texts)
            , m_lines(lines) {}
        bool begin(QPaintDevice *) override { return true; }
        bool end() override { return true; }
        void updateState(const QPaintEngineState &changed) override {
            if (changed.state() & DirtyPen)
                m_pen = changed.pen();
        }
        void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
        void drawPath(const QPainterPath &) override {}
        void drawPolygon(const QPointF *points, int count, PolygonDrawMode mode) override {
            if (mode == PolylineMode)
                record(QPolygonF(QList<QPointF>(points, points + count)));
        }
        void drawLines(const QLineF *lines, int count) override {
            for (int i = 0; i < count; ++i)
                record({lines[i].p1(), lines[i].p2()});
        }
        [[nodiscard]] Type type() const override { return User; }
        void drawTextItem(const QPointF &baseline, const QTextItem &item) override {
            const double height = 0.72 * item.font().pixelSize();
            const QRectF box(baseline.x(), baseline.y() - height, item.width(), height);
            const QTransform transform = painter()->combinedTransform();
            m_texts.push_back({item.text(), transform.mapRect(box), transform.map(QPolygonF(box))});
        }

    private:
        void record(const QPolygonF &points) {
            m_lines.push_back({painter()->combinedTransform().map(points), m_pen});
        }

        std::vector<RecordedText> &m_texts;
        std::vector<RecordedLine> &m_lines;
        QPen m_pen;
    };

    QSize m_size;
    std::unique_ptr<Engine> m_engine;
};

} // namespace palmer::testdata
