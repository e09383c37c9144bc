// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/figuretexts.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

class Range {
public:
    void add(double value) {
        m_from = std::min(m_from, value);
        m_to = std::max(m_to, value);
    }
    /// "−9.9 to 6.4 µm"; empty if no value was added.
    [[nodiscard]] QString text(const QString &unit, int decimals, const Language &language) const {
        if (m_from > m_to)
            return {};
        const auto number = [&](double value) {
            return language.number(value, Quantity::number, decimals).toStdString();
        };
        const QString span =
            language.sentence(REPORT_TEXT_FOR("report", "%1 to %2", "from one value to another"),
                              {number(m_from), number(m_to)});
        return unit.isEmpty() ? span : span + u'\u00a0' + unit;
    }

private:
    double m_from = std::numeric_limits<double>::infinity();
    double m_to = -std::numeric_limits<double>::infinity();
};

/// Decimals needed for a tenth of the axis step.
int decimalsOf(const FigureAxis &axis) {
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(std::max(axis.step, 1e-9)))), 0, 9);
}

QString ofAxis(const FigureAxis &axis, const QString &range) {
    return range.isEmpty() ? QString() : axis.quantity.isEmpty() ? range : axis.quantity + u' ' + range;
}

struct Describe {
    const Language &language;

    [[nodiscard]] QString titled(const QString &title, QStringList parts) const {
        parts.removeAll(QString());
        const QString text = parts.join(language.semicolon());
        return text.isEmpty() ? title
                              : language.sentence(REPORT_TEXT("report", "%1: %2"),
                                                  {title.toStdString(), text.toStdString()});
    }

    QString operator()(const CurveFigure &figure) const {
        Range x;
        Range y;
        for (const Curve &curve : figure.curves) {
            for (const FigurePoint &point : curve.points) {
                x.add(point.x);
                y.add(point.y);
            }
        }
        for (const Band &band : figure.bands) {
            for (const BandPoint &point : band.points) {
                y.add(point.lower);
                y.add(point.upper);
            }
        }
        for (const ReadingMark &mark : figure.readings)
            y.add(mark.y);
        QStringList parts{ofAxis(figure.x, x.text(figure.x.unit, -1, language)),
                          ofAxis(figure.y, y.text(figure.y.unit, decimalsOf(figure.y), language))};
        for (const LegendEntry &entry : figure.legend)
            parts << entry.text;
        for (const Dimension &dimension : figure.dimensions)
            parts << dimension.label + u' ' +
                         language.number(dimension.upper - dimension.lower, Quantity::number,
                                         decimalsOf(figure.y)) +
                         u'\u00a0' + figure.y.unit;
        return titled(figure.title, parts << figure.note);
    }

    QString operator()(const CircleFigure &figure) const {
        Range deviations;
        for (const CircleTrace &trace : figure.traces) {
            for (const TracePoint &point : trace.points)
                deviations.add(point.deviation);
        }
        const QString unit =
            figure.divisionLabel.section(u'\u202f', -1).section(u'\u00a0', -1).section(u' ', -1);
        QStringList parts{figure.centre, figure.caption, deviations.text(unit, 1, language)};
        for (const CircleLegendEntry &entry : figure.legend)
            parts << entry.text;
        if (figure.envelope)
            parts << figure.envelope->label + figure.envelope->subscript << figure.envelope->limitLabel;
        return titled(figure.title, parts);
    }

    QString operator()(const LineFigure &figure) const {
        Range x;
        QStringList parts;
        for (const FigureLine &line : figure.lines) {
            Range y;
            for (const QPointF &point : line.points) {
                x.add(point.x());
                y.add(point.y());
            }
            parts << line.name + u' ' + y.text(figure.y.unit, decimalsOf(figure.y), language);
        }
        parts.prepend(ofAxis(figure.x, x.text(figure.x.unit, decimalsOf(figure.x), language)));
        return titled(figure.title, parts);
    }

    QString operator()(const BarFigure &figure) const {
        QStringList parts;
        for (const Bar &bar : figure.bars)
            parts << (bar.name + bar.subscript + u' ' + bar.value + u' ' + bar.share).trimmed();
        for (const BarLine &line : figure.lines)
            parts << line.text;
        return titled(figure.title, parts << figure.note);
    }

    QString operator()(const TrendFigure &figure) const {
        QStringList parts{figure.label, figure.note};
        for (const TrendPanel &panel : figure.panels)
            parts << (panel.symbol + u' ' + panel.statement).trimmed();
        for (const TrendLegendEntry &entry : figure.legend)
            parts << entry.text;
        return titled(figure.title, parts);
    }

    QString operator()(const HistogramFigure &figure) const {
        return titled(figure.title, {figure.evaluatedText, figure.meanText, figure.coverageText});
    }
};

} // namespace

QString figureSentence(const Figure &figure, const Language &language) {
    return std::visit(Describe{language}, figure);
}

} // namespace palmer
