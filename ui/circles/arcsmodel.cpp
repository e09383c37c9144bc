// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/arcsmodel.h"

#include "figures/extremes.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "kernel/evaluation/resultsof.h"
#include "print/figures/style.h"
#include "ui/circles/arctexts.h"
#include "ui/theme.h"

#include <QApplication>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int arcAngleDecimals = 2;
constexpr int radiusDecimals = 2;

} // namespace

ArcsModel::ArcsModel(QObject *parent)
    : RowModel(parent) {
    makeColumns({});
}

/// In the order of Column.
void ArcsModel::makeColumns(const QString &unit) {
    constexpr Qt::Alignment left = Qt::AlignLeft;
    constexpr Qt::Alignment right = Qt::AlignRight;
    m_columns = {
        {tr("Sense"), left},
        {tr("points"), right},
        {tr("from"), right},
        {tr("to"), right},
        {tr("cut off"), right, {}, tr("Measured but not evaluated: feed-in, feed-out, angular overshoot")},
        {tr("R_LSC − R %1", "unit").arg(unit),
         right,
         {},
         tr("Radius of the least squares circle − nominal radius")},
        {tr("use"), left, {}, tr("Of each sense the first arc is evaluated; further ones are repetitions")}};
}

void ArcsModel::show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language) {
    beginResetModel();
    m_rows.clear();
    makeColumns(language.unit(Quantity::deviation));
    const auto *measurement = measured<CircularMeasurement>(evaluated, test);
    const QString none = QStringLiteral("–");
    for (std::size_t k = 0; measurement && k < measurement->arcs.size(); ++k) {
        const CircularResults &results = resultsOf(*measurement, *evaluated.tests[test]);
        const Arc &arc = measurement->arcs[k];
        const bool repetition = std::ranges::find(results.repetitions, k) != results.repetitions.end();
        const auto range = iso230_4::evaluatedRange(arc);
        QStringList texts;
        for (int column = 0; column < columns; ++column)
            texts << none;
        texts[sense] = arcName(*measurement, k);
        texts[points] = language.number(static_cast<double>(arc.angles.size()), Quantity::count, 0);
        if (range) {
            const int decimals = decimalsOf(arc.angles, Quantity::angle, arcAngleDecimals);
            const auto angle = [&](double value) {
                return language.quantity(value, Quantity::angle, decimals);
            };
            const bool ascending = arc.angles.back() >= arc.angles.front();
            const auto [low, high] = extremesOf(arc.angles);
            const double first = std::max(low, range->from);
            const double last = std::min(high, range->to);
            texts[from] = angle(ascending ? first : last);
            texts[to] = angle(ascending ? last : first);
            texts[cut] = angle(std::max(0.0, first - low) + std::max(0.0, high - last));
        }
        const CircleResult *circle =
            repetition ? nullptr
                       : results.circle(arc.sense == Sense::counterclockwise ? CircleOf::counterclockwise
                                                                             : CircleOf::clockwise,
                                        ReferenceCircle::leastSquares);
        if (circle)
            texts[radius] = language.number(circle->radius - measurement->nominalRadius, Quantity::deviation,
                                            radiusDecimals);
        texts[use] = repetition ? tr("repetition") : tr("evaluated");
        m_rows.push_back({arc.sense, texts});
    }
    endResetModel();
}

QVariant ArcsModel::cell(const ArcRow &row, int column, int role) const {
    if (role == Qt::DisplayRole)
        return row.texts[column];
    if (role != Qt::ForegroundRole || column != sense)
        return {};
    return token(row.sense == Sense::counterclockwise ? Token::up : Token::downText, QApplication::palette());
}

} // namespace palmer::ui
