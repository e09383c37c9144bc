// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/figuredata.h"

#include "kernel/words/shortest.h"

#include <array>
#include <charconv>

namespace palmer {

namespace {

class PointTable {
public:
    explicit PointTable(char decimalMark)
        : m_mark(decimalMark)
        , m_delimiter(decimalMark == ',' ? ';' : ',') {}

    void head(const QString &title, const QString &x, const QString &y) {
        m_text = "# " + QString(title).replace(u'\n', u' ').toUtf8() + '\n';
        row("", x.toUtf8(), y.toUtf8());
    }

    void point(const QString &line, double x, double y) { row(line.toUtf8(), number(x), number(y)); }

    [[nodiscard]] QByteArray take() { return std::move(m_text); }

private:
    void row(const QByteArray &line, const QByteArray &x, const QByteArray &y) {
        m_text += cell(line) + m_delimiter + cell(x) + m_delimiter + cell(y) + '\n';
    }

    [[nodiscard]] QByteArray cell(QByteArray text) const {
        if (!text.contains(m_delimiter) && !text.contains('"') && !text.contains('\n'))
            return text;
        return '"' + text.replace('"', "\"\"") + '"';
    }

    [[nodiscard]] QByteArray number(double value) const {
        return QByteArray::fromStdString(shortest(value)).replace('.', m_mark);
    }

    char m_mark;
    char m_delimiter;
    QByteArray m_text;
};

QString headingOf(const FigureAxis &axis) {
    return axis.symbol + axis.subscript + QStringLiteral(" (") + axis.unit + QLatin1Char(')');
}

QString arrowOf(CurveRole role) {
    switch (role) {
    case CurveRole::up:
        return QStringLiteral("↑");
    case CurveRole::down:
        return QStringLiteral("↓");
    default:
        return {};
    }
}

QString nameOf(CurveRole role) {
    return role == CurveRole::drift ? QStringLiteral("x") : QStringLiteral("x̄") + arrowOf(role);
}

void add(PointTable &table, const CurveFigure &figure) {
    table.head(figure.title, headingOf(figure.x), headingOf(figure.y));
    for (const Curve &curve : figure.curves) {
        for (const FigurePoint &point : curve.points)
            table.point(nameOf(curve.role), point.x, point.y);
    }
    for (const Band &band : figure.bands) {
        const QString arrow = arrowOf(band.role);
        for (const BandPoint &point : band.points)
            table.point(QStringLiteral("x̄%1 − s%1").arg(arrow), point.x, point.lower);
        for (const BandPoint &point : band.points)
            table.point(QStringLiteral("x̄%1 + s%1").arg(arrow), point.x, point.upper);
    }
    for (const ReadingMark &reading : figure.readings)
        table.point(QStringLiteral("x %1 %2").arg(reading.run).arg(arrowOf(reading.role)), reading.x,
                    reading.y);
}

void add(PointTable &table, const LineFigure &figure) {
    table.head(figure.title, headingOf(figure.x), headingOf(figure.y));
    for (const FigureLine &line : figure.lines) {
        for (const QPointF &point : line.points)
            table.point(line.name, point.x(), point.y());
    }
}

void add(PointTable &table, const CircleFigure &figure) {
    table.head(figure.title + QStringLiteral(", ") + figure.centre, QStringLiteral("φ (°)"),
               QStringLiteral("Δr (µm)"));
    int number = 0;
    for (const CircleTrace &trace : figure.traces) {
        const QString sense =
            trace.sense == Sense::counterclockwise ? QStringLiteral("↺") : QStringLiteral("↻");
        ++number;
        const QString made = trace.synthetic ? QStringLiteral(" *") : QString();
        for (const TracePoint &point : trace.points)
            table.point(QStringLiteral("%1 %2%3").arg(number).arg(sense, made), point.angle, point.deviation);
    }
}

void add(PointTable &table, const BarFigure &figure) {
    table.head(figure.title, QString(), headingOf(figure.x));
    for (std::size_t i = 0; i < figure.bars.size(); ++i)
        table.point(figure.bars[i].name + figure.bars[i].subscript, static_cast<double>(i + 1),
                    figure.bars[i].size);
}

void add(PointTable &table, const HistogramFigure &figure) {
    table.head(figure.title, headingOf(figure.x), QStringLiteral("n"));
    for (std::size_t i = 0; i < figure.counts.size(); ++i)
        table.point(QString(), figure.from + (static_cast<double>(i) + 0.5) * figure.width,
                    static_cast<double>(figure.counts[i]));
}

void add(PointTable &table, const TrendFigure &figure) {
    if (!figure.panels.empty())
        table.head(figure.title, headingOf(figure.panels.front().x), headingOf(figure.panels.front().y));
    for (const TrendPanel &panel : figure.panels) {
        for (const TrendValue &value : panel.values)
            table.point(panel.symbol, value.x, value.y);
    }
}

} // namespace

QByteArray figureCsv(const Figure &figure, char decimalMark) {
    PointTable table(decimalMark);
    std::visit([&](const auto &kind) { add(table, kind); }, figure);
    return table.take();
}

} // namespace palmer
