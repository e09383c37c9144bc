// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/testfigures.h"

#include "figures/ticks.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr double percent = 100;
constexpr double leastShare = 0.005; ///< smaller shares are printed as "< 1"
constexpr double mostLengthTicks = 6;

/// Splits the index off a symbol at the end of a name: "…, E_VE" becomes "…, E" and "VE".
void splitIndex(Bar &bar) {
    const qsizetype at = bar.name.lastIndexOf(u'_');
    if (at < 0)
        return;
    bar.subscript = bar.name.mid(at + 1);
    bar.name.truncate(at);
}

} // namespace

QString contributionName(const Contribution &contribution, const Language &language) {
    QString name = language.text(contribution.name);
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

QString shareText(double share, const Language &language) {
    if (share < leastShare)
        return share > 0 ? QStringLiteral("<\u00A01") : QStringLiteral("0");
    return language.number(share * percent, Quantity::number, 0);
}

BarFigure budgetFigure(const Test &test, const TestEvaluation &evaluation, const Language &language) {
    BarFigure figure;
    const UncertaintyEvaluation &uncertainty = evaluation.uncertainty;
    if (!usesContributions(uncertainty.method))
        return figure;
    const Quantity quantity = deviationQuantity(test);
    const double scale = unitScale(quantity, language.units());
    const auto &contributions = uncertainty.contributions;
    const Contribution *first = uncertainty.complete ? toImproveFirst(contributions) : nullptr;
    const QString none = QStringLiteral("–");
    double largest = 0;
    for (const Contribution *contribution : bySize(contributions)) {
        const bool shown = contribution->expanded && contribution->applies;
        const double share = shareOf(*contribution, contributions);
        Bar bar;
        bar.id = QString::fromUtf8(contribution->id);
        bar.name = contributionName(*contribution, language);
        splitIndex(bar);
        bar.size = contribution->expanded.value_or(0) * scale;
        bar.value = shown ? language.number(*contribution->expanded, quantity, contributionDecimals) : none;
        bar.share = shown ? shareText(share, language) : none;
        bar.first = contribution == first;
        largest = std::max(largest, bar.size);
        figure.bars.push_back(std::move(bar));
    }
    figure.title = language.text(REPORT_TEXT("report", "Uncertainty budget"));
    figure.shareTitle = language.text(REPORT_TEXT_FOR("report", "Share", "of a budget"));
    if (first)
        figure.note =
            language.sentence(REPORT_TEXT("report", "Improve first: %1 (%2 % of the budget)."),
                              {QString(language.text(first->name)).remove(u'_').toStdString(),
                               Number{shareOf(*first, contributions) * percent, Quantity::number, 0}});
    figure.x.symbol = QStringLiteral("U");
    figure.x.subscript = QStringLiteral("i");
    figure.x.unit = language.unit(quantity);
    setRange(figure.x, 0, scaleEnd(largest), mostLengthTicks, TickSteps::lengths, language);
    return figure;
}

} // namespace palmer
