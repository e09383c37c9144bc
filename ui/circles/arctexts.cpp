// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/arctexts.h"

#include "kernel/evaluation/iso230_4/paths.h"
#include "language/rounding.h"

#include <QCoreApplication>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr std::size_t sample = 1000; ///< points examined

QString circlesText(const char *text) {
    return QCoreApplication::translate("palmer::ui::CirclesPage", text);
}

} // namespace

QString senseWord(Sense sense) {
    return sense == Sense::counterclockwise
               ? circlesText(QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "anticlockwise"))
               : circlesText(QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "clockwise"));
}

QString arcName(const CircularMeasurement &measurement, std::size_t arc) {
    const Sense sense = measurement.arcs[arc].sense;
    return senseWord(sense) + QStringLiteral(", ") +
           QString::fromStdString(iso230_4::axisIndex(measurement.plane, sense));
}

int decimalsOf(std::span<const double> values, Quantity quantity, int most) {
    int result = 0;
    const std::size_t stride = std::max<std::size_t>(1, values.size() / sample);
    for (std::size_t i = 0; i < values.size() && result < most; i += stride) {
        const std::string digits = Decimal(values[i], quantity).shortest();
        const std::size_t point = digits.find('.');
        if (point != std::string::npos)
            result = std::max(result, static_cast<int>(digits.size() - point) - 1);
    }
    return std::min(result, most);
}

QString pointText(const CircularMeasurement &measurement, std::size_t arc, std::size_t point,
                  const Language &language) {
    const Arc &measured = measurement.arcs[arc];
    constexpr int mostDecimals = 3;
    return circlesText(QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "%1, point %2: %3 · %4"))
        .arg(senseWord(measured.sense), language.number(static_cast<double>(point + 1), Quantity::count, 0),
             language.quantity(measured.angles[point], Quantity::angle,
                               decimalsOf(measured.angles, Quantity::angle, mostDecimals)),
             language.quantity(measured.radialDeviations[point], Quantity::deviation,
                               decimalsOf(measured.radialDeviations, Quantity::deviation, mostDecimals)));
}

} // namespace palmer::ui
