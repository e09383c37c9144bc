// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/evaluatetest.h"

#include <QFile>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

/// Circular tests for tests.
namespace palmer::testdata {

/// A test in the plane XY with a calibrated reference length.
inline Test circularTest(std::vector<Arc> arcs, double radius = 150, const char *edition = "ISO 230-4:2005") {
    CircularMeasurement m;
    m.plane = {"X", "Y"};
    m.nominalRadius = radius;
    m.referenceLength.calibrated = true;
    m.arcs = std::move(arcs);
    Test test;
    test.edition = edition;
    test.measurement = std::move(m);
    return test;
}

inline CircularMeasurement &circular(Test &test) {
    return std::get<CircularMeasurement>(test.measurement);
}

inline TestEvaluation evaluatedCircular(const Test &test, const char *edition = nullptr) {
    static const Machine machine;
    Surroundings surroundings;
    surroundings.machine = &machine;
    return evaluateTest(test, surroundings, edition ? findEdition(edition) : nullptr);
}

/// A path with the radial deviations `shape` (µm, of the angle in radians) at n angles over `extent` degrees.
template <typename Shape>
Arc pathOf(Sense sense, int n, Shape shape, double start = 0, double extent = 360) {
    Arc arc;
    arc.sense = sense;
    const double sign = sense == Sense::counterclockwise ? 1 : -1;
    arc.angles.reserve(static_cast<std::size_t>(n));
    arc.radialDeviations.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        const double angle = start + sign * extent * i / n;
        arc.angles.push_back(angle);
        arc.radialDeviations.push_back(shape(angle * std::numbers::pi / 180) * 1e-3);
    }
    return arc;
}

/// An arc of resources/reference/circles: lines "angle;radial deviation in µm".
inline Arc referenceArc(const char *name, Sense sense) {
    Arc arc;
    arc.sense = sense;
    QFile file(QStringLiteral(PALMER_SOURCE_DIR "/resources/reference/circles/") + QString::fromUtf8(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no %s", name);
    for (const QByteArray &line : file.readAll().split('\n')) {
        const QList<QByteArray> cells = line.trimmed().split(line.contains(';') ? ';' : ',');
        bool isNumber = false;
        const double angle = cells.value(0).toDouble(&isNumber);
        if (!isNumber || cells.size() < 2)
            continue;
        arc.angles.push_back(angle);
        arc.radialDeviations.push_back(cells[1].toDouble() * 1e-3);
    }
    return arc;
}

/// The published ballbar pair, R 150.
inline Test ballbarPair() {
    return circularTest({referenceArc("ballbar_pair_ccw.csv", Sense::counterclockwise),
                         referenceArc("ballbar_pair_cw.csv", Sense::clockwise)});
}

/// n points a path with the shape of a machine, and noise of 0.4 µm that any run makes alike.
inline Test longPair(int n) {
    const auto shape = [n](double sign) {
        return [n, sign](double angle) {
            const double noise = std::sin(angle * n * 0.7311) + std::sin(angle * n * 0.1937 + sign);
            return 6 * std::cos(2 * angle + 0.3 * sign) + sign * 1.5 * std::copysign(1.0, std::sin(angle)) +
                   0.2 * noise;
        };
    };
    return circularTest(
        {pathOf(Sense::counterclockwise, n, shape(1)), pathOf(Sense::clockwise, n, shape(-1), 360)});
}

} // namespace palmer::testdata
