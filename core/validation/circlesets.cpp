// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/validation.h"

#include "kernel/numerics/leastsquarescircle.h"
#include "kernel/numerics/minimumzone.h"

#include <QFile>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>

namespace palmer {

namespace {

constexpr double leastSquaresTolerance = 1e-9; ///< mm
constexpr double widthTolerance = 1e-12;       ///< mm, up to radii of 10 mm
constexpr double relativeToRadius = 1e-13;     ///< resolution of the distances of large circles

/// Returns the lines of an embedded file except comments, split at commas.
std::vector<QStringList> lines(const QString &name) {
    QFile file(QStringLiteral(":/reference/circles/") + name);
    if (!file.open(QIODevice::ReadOnly))
        throw Error(Error::Kind::unreadable, {REPORT_TEXT("report", "the file cannot be read (%1)"),
                                              {file.errorString().toStdString()}});
    std::vector<QStringList> result;
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine()).trimmed();
        if (!line.isEmpty() && !line.startsWith(u'#'))
            result.push_back(line.split(u','));
    }
    return result;
}

Points points(const QString &name) {
    Points result;
    for (const QStringList &line : lines(name)) {
        result.x.push_back(line.value(0).toDouble());
        result.y.push_back(line.value(1).toDouble());
    }
    return result;
}

Comparison comparison(const QString &of, Symbol symbol, double expected, double tolerance,
                      ExpectationSource source, std::optional<double> computed) {
    Comparison result;
    result.of = of;
    result.symbol = symbol;
    result.expectation.value = expected;
    result.expectation.tolerance = tolerance;
    result.expectation.source = source;
    if (computed)
        compareWith(result, *computed);
    return result;
}

/// One line of expected.csv: its cells by column name.
using ReferenceRow = std::map<QString, QString>;

void compareSet(SetValidation &set, const ReferenceRow &row, bool constructed) {
    const QString file = row.at(QStringLiteral("file"));
    const QString of = QString(file).remove(QStringLiteral(".csv"));
    const auto number = [&](const char *column) { return row.at(QLatin1StringView(column)).toDouble(); };
    const auto add = [&](Symbol symbol, const char *column, double tolerance, ExpectationSource source,
                         std::optional<double> computed) {
        set.comparisons.push_back(comparison(of, symbol, number(column), tolerance, source, computed));
    };
    const Points measured = points(file);
    const LeastSquaresCircle fit = leastSquaresCircle(measured.view());
    const auto fitted = [&](double value) { return fit.valid() ? std::optional(value) : std::nullopt; };
    const auto ofFit = constructed ? ExpectationSource::recomputed : ExpectationSource::certified;
    add({"x", "LSC"}, "lsc_cx", leastSquaresTolerance, ofFit, fitted(fit.centre.x));
    add({"y", "LSC"}, "lsc_cy", leastSquaresTolerance, ofFit, fitted(fit.centre.y));
    add({"R", "LSC"}, "lsc_R", leastSquaresTolerance, ofFit, fitted(fit.radius));
    if (row.at(QStringLiteral("status")) != QStringLiteral("ok"))
        return; // three points have no minimum zone
    const MinimumZone zone = minimumZone(measured.view());
    add({"w", "MZC"}, "mzc_width", std::max(widthTolerance, relativeToRadius * number("mzc_Ro")),
        constructed ? ExpectationSource::exact : ExpectationSource::recomputed,
        zone.valid() && zone.certified ? std::optional(zone.width) : std::nullopt);
}

} // namespace

std::vector<SetValidation> validateCircles() {
    SetValidation nist{QStringLiteral("NIST circles"), {}, Quantity::position, {}, true};
    SetValidation constructed{QStringLiteral("Constructed circles"), {}, Quantity::position, {}, true};
    const auto table = lines(QStringLiteral("expected.csv"));
    for (std::size_t i = 1; i < table.size(); ++i) {
        ReferenceRow row;
        for (qsizetype column = 0; column < table[0].size(); ++column)
            row[table[0][column]] = table[i].value(column);
        const bool isConstructed = row[QStringLiteral("file")].startsWith(QLatin1StringView("con_"));
        compareSet(isConstructed ? constructed : nist, row, isConstructed);
    }
    return {std::move(nist), std::move(constructed)};
}

} // namespace palmer
