// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/figuretexts.h"

#include "language/csvwriter.h"

#include <cmath>

namespace palmer {

namespace {

/// Points of a figure, one per row: curve, x, y.
class PointTable {
public:
    explicit PointTable(char decimalMark)
        : m_csv(decimalMark) {}

    void head(const QString &title, const QString &of, const QString &x, const QString &y) {
        m_csv.comment(title.toStdString());
        row(of, x, y);
    }

    void point(const QString &of, double x, double y) {
        m_csv.text(of.toStdString());
        m_csv.number(shown(x));
        m_csv.number(shown(y));
        m_csv.endRow();
    }

    [[nodiscard]] QByteArray take() const { return m_csv.bytes(); }

private:
    void row(const QString &of, const QString &x, const QString &y) {
        for (const QString &heading : {of, x, y})
            m_csv.text(heading.toStdString());
        m_csv.endRow();
    }

    /// Rounds away digits that are only noise of the conversion to µm.
    static double shown(double value) {
        constexpr int digits = 12;
        return QByteArray::number(value, 'g', digits).toDouble();
    }

    CsvWriter m_csv;
};

QString headingOf(const FigureAxis &axis) {
    const QString unit = axis.unit.isEmpty() ? QString() : QStringLiteral(" (") + axis.unit + u')';
    return axis.symbol + axis.subscript + unit;
}

QString arrowOf(CurveRole role) {
    return role == CurveRole::up     ? QStringLiteral("↑")
           : role == CurveRole::down ? QStringLiteral("↓")
                                     : QString();
}

QString nameOf(CurveRole role) {
    return role == CurveRole::drift ? QStringLiteral("x") : QStringLiteral("x̄") + arrowOf(role);
}

QString curve(const Language &language) {
    return language.text(REPORT_TEXT("report", "curve"));
}

void add(PointTable &table, const CurveFigure &figure, const Language &language) {
    table.head(figure.title, curve(language), headingOf(figure.x), headingOf(figure.y));
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

void add(PointTable &table, const LineFigure &figure, const Language &language) {
    table.head(figure.title, curve(language), headingOf(figure.x), headingOf(figure.y));
    for (const FigureLine &line : figure.lines) {
        for (const QPointF &point : line.points)
            table.point(line.name, point.x(), point.y());
    }
}

void add(PointTable &table, const CircleFigure &figure, const Language &language) {
    table.head(figure.title + QStringLiteral(", ") + figure.centre, curve(language), QStringLiteral("φ (°)"),
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

void add(PointTable &table, const BarFigure &figure, const Language &language) {
    table.head(
        figure.title,
        language.text(figure.dots ? REPORT_TEXT("report", "Machine") : REPORT_TEXT("report", "Contribution")),
        QStringLiteral("i"), headingOf(figure.x));
    for (std::size_t i = 0; i < figure.bars.size(); ++i)
        table.point(figure.bars[i].name + figure.bars[i].subscript, static_cast<double>(i + 1),
                    figure.bars[i].size);
}

void add(PointTable &table, const HistogramFigure &figure, const Language &language) {
    table.head(figure.title, curve(language), headingOf(figure.x), QStringLiteral("n"));
    for (std::size_t i = 0; i < figure.counts.size(); ++i)
        table.point(figure.x.symbol + figure.x.subscript,
                    figure.from + (static_cast<double>(i) + 0.5) * figure.width,
                    static_cast<double>(figure.counts[i]));
}

void add(PointTable &table, const TrendFigure &figure, const Language &language) {
    if (!figure.panels.empty())
        table.head(figure.title, curve(language), headingOf(figure.panels.front().x),
                   headingOf(figure.panels.front().y));
    for (const TrendPanel &panel : figure.panels) {
        for (const TrendValue &value : panel.values)
            table.point(panel.symbol, value.x, value.y);
    }
}

} // namespace

QByteArray figureCsv(const Figure &figure, const Language &language, char decimalMark) {
    PointTable table(decimalMark);
    std::visit([&](const auto &kind) { add(table, kind, language); }, figure);
    return table.take();
}

} // namespace palmer
