#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <memory>
#include <vector>

/// A paint device that keeps the texts drawn on it and where they stand, for tests.
namespace palmer::testdata {

struct RecordedText {
    QString text;
    QRectF box; ///< in device units, from the baseline to the height of capitals
};

class TextRecorder : public QPaintDevice {
public:
    explicit TextRecorder(QSize size)
        : m_size(size)
        , m_engine(std::make_unique<Engine>(texts)) {}

    [[nodiscard]] QPaintEngine *paintEngine() const override { return m_engine.get(); }

    std::vector<RecordedText> texts;

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
        explicit Engine(std::vector<RecordedText> &texts)
            : QPaintEngine(AllFeatures)
            , m_texts(texts) {}
        bool begin(QPaintDevice *) override { return true; }
        bool end() override { return true; }
        void updateState(const QPaintEngineState &) override {}
        void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
        void drawPath(const QPainterPath &) override {}
        void drawPolygon(const QPointF *, int, PolygonDrawMode) override {}
        [[nodiscard]] Type type() const override { return User; }
        void drawTextItem(const QPointF &baseline, const QTextItem &item) override {
            const double height = 0.72 * item.font().pixelSize();
            const QRectF box(baseline.x(), baseline.y() - height, item.width(), height);
            m_texts.push_back({item.text(), painter()->combinedTransform().mapRect(box)});
        }

    private:
        std::vector<RecordedText> &m_texts;
    };

    QSize m_size;
    std::unique_ptr<Engine> m_engine;
};

} // namespace palmer::testdata
