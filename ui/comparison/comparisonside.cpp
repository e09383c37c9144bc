// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/comparison/comparisonside.h"

#include "figures/differencefigure.h"
#include "report/comparison.h"
#include "report/parts/comparedtests.h"
#include "ui/elidedlabel.h"
#include "ui/figures/comparisonview.h"
#include "ui/figures/figurecard.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/testname.h"
#include "ui/windowlanguage.h"

#include <QLabel>
#include <QScrollArea>
#include <algorithm>

namespace palmer::ui {

ComparisonSide::ComparisonSide(QWidget *parent)
    : QWidget(parent)
    , m_differenceTitle(made<QLabel>("differenceTitle", TextSize::head, this))
    , m_differenceNote(made<ElidedLabel>("differenceNote", TextSize::small, trait::secondary, this))
    , m_difference(made<LineView>("differenceFigure", this))
    , m_meansTitle(made<QLabel>("meansTitle", TextSize::head, this))
    , m_means(made<ComparisonView>("meansFigure", this))
    , m_methodTitle(made<QLabel>("differenceUncertainty", TextSize::head, this))
    , m_methodPlace(made<QScrollArea>("differenceMethodPlace", this))
    , m_method(made<QLabel>("differenceMethod", trait::secondary, trait::wrapped)) {
    setObjectName(QStringLiteral("comparisonSide"));
    setAttribute(Qt::WA_StyledBackground);
    setProperty("ground", QStringLiteral("base"));
    m_methodPlace->setFrameShape(QFrame::NoFrame);
    m_methodPlace->setWidgetResizable(true);
    m_methodPlace->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_methodPlace->setWidget(m_method);
    m_methodPlace->viewport()->setAutoFillBackground(false);
    m_method->setAutoFillBackground(false);
    m_method->setAlignment(Qt::AlignTop);
    auto *title = inRow(8, {m_differenceTitle, {m_differenceNote, 1}});
    inColumn(this, {pageMargin, 12, pageMargin, 12}, 4,
             {title,
              {m_difference, 3},
              Placed::gap(8),
              m_meansTitle,
              {m_means, 2},
              Placed::gap(8),
              m_methodTitle,
              m_methodPlace});
    clear();
}

void ComparisonSide::show(const TestComparison &comparison, const PlacedTest &before,
                          const PlacedTest &after) {
    const Language &language = windowLanguage();
    CurveFigure difference = differenceFigure(comparison, language);
    const bool curves = !difference.curves.empty();
    m_differenceTitle->setText(difference.title);
    m_differenceNote->setText(tr("%n common target(s)", nullptr, static_cast<int>(comparison.commonTargets)));
    LineFigure paths = pathDifferenceFigure(comparedPaths(before, after), language);
    const bool circles = !paths.lines.empty();
    if (circles)
        m_differenceTitle->setText(paths.title);
    m_difference->setAccessibleName(m_differenceTitle->text());
    m_difference->setFigure(curves    ? std::optional<Figure>(std::move(difference))
                            : circles ? std::optional<Figure>(std::move(paths))
                                      : std::nullopt);
    m_differenceNote->setVisible(curves);
    const auto named = [](const PlacedTest &placed) {
        return ComparedTest{*placed.evaluated, placed.index, testName(placed.test())};
    };
    m_means->show(comparisonFigure({named(before), named(after)}, language));
    m_meansTitle->setText(tr("Both tests"));
    m_means->setAccessibleName(m_meansTitle->text());
    const QStringList sentences = methodSentences(comparison, language);
    m_methodTitle->setText(tr("Uncertainty of the difference"));
    m_method->setText(sentences.join(u'\n'));
    for (QWidget *part : std::initializer_list<QWidget *>{m_differenceTitle, m_difference})
        part->setVisible(curves || circles);
    for (QWidget *part : std::initializer_list<QWidget *>{m_meansTitle, m_means})
        part->setVisible(true);
    for (QWidget *part : std::initializer_list<QWidget *>{m_methodTitle, m_methodPlace})
        part->setVisible(!sentences.isEmpty());
    fitMethod();
}

void ComparisonSide::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    fitMethod();
}

/// As high as its text; in a low window a third is left to it, and it scrolls.
void ComparisonSide::fitMethod() {
    const int whole = m_method->heightForWidth(width() - 2 * pageMargin);
    m_methodPlace->setFixedHeight(std::clamp(whole, 0, height() / 3)); // −1 without text
}

void ComparisonSide::clear() {
    for (QWidget *part : findChildren<QWidget *>(Qt::FindDirectChildrenOnly))
        part->hide();
}

} // namespace palmer::ui
