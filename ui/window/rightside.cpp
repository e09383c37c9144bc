// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/rightside.h"

#include "ui/figures/figureview.h"
#include "ui/madewidgets.h"
#include "ui/results/findingspanel.h"
#include "ui/results/resultspanel.h"
#include "ui/theme.h"
#include "ui/window/pagetabs.h"

#include <QFrame>
#include <QLabel>
#include <QTimer>
#include <array>
#include <utility>

namespace palmer::ui {

namespace {

enum Tab { pageTab, figureTab, resultsTab, findingsTab, tabs };

constexpr int markAfter = 150; ///< ms: no mark for shorter computations, which would flash
constexpr int markBelow = 36;  ///< the figure's header

} // namespace

RightSide::RightSide(Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_tabs(made<PageTabs>("rightTabs", this))
    , m_column(new QVBoxLayout(this))
    , m_figure(new FigureView(selection, this))
    , m_results(new ResultsPanel(selection, this))
    , m_findings(new FindingsPanel(selection, this))
    , m_mark(made<QLabel>("computingMark", this))
    , m_markLater(new QTimer(this)) {
    setObjectName(QStringLiteral("rightSide"));
    setAttribute(Qt::WA_StyledBackground);
    setProperty("ground", QStringLiteral("base"));
    setFocusProxy(m_tabs);
    for (int i = 0; i < tabs; ++i)
        m_tabs->addTab(QString());
    m_tabs->setTabVisible(pageTab, false);
    m_tabs->setCurrentIndex(figureTab);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    auto *tabRow = inRow(nullptr, {12, 0, 12, 0}, styleSpacing, {m_tabs});
    m_column->addLayout(tabRow);
    m_column->addWidget(m_figure, 1);
    m_column->addWidget(m_results);
    m_column->addWidget(m_findings);
    m_mark->setProperty("mark", true);
    m_mark->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_mark->hide();
    m_markLater->setSingleShot(true);
    m_markLater->setInterval(markAfter);
    connect(m_markLater, &QTimer::timeout, this, [this] {
        m_mark->adjustSize();
        m_mark->move((width() - m_mark->width()) / 2, m_figure->y() + markBelow);
        m_mark->raise();
        m_mark->show();
    });
    m_figure->setMinimumHeight(leastFigureHeight);
    connect(m_tabs, &QTabBar::currentChanged, this, [this] {
        arrange();
        if (m_takesTurns)
            emit turned();
    });
    retranslate();
    arrange();
}

void RightSide::setHasResults(bool has) {
    if (std::exchange(m_hasResults, has) == has)
        return;
    m_tabs->setTabVisible(resultsTab, has);
    arrange();
}

void RightSide::setInstead(QWidget *instead) {
    if (m_instead == instead)
        return;
    if (m_instead)
        m_instead->hide();
    m_instead = instead;
    if (instead && m_column->indexOf(instead) < 0)
        m_column->addWidget(instead, 1);
    arrange();
}

void RightSide::setTabbed(bool tabbed) {
    if (m_tabbed == tabbed)
        return;
    m_tabbed = tabbed;
    arrange();
}

void RightSide::setTakingTurns(bool takesTurns) {
    if (std::exchange(m_takesTurns, takesTurns) == takesTurns)
        return;
    m_tabs->setTabVisible(pageTab, takesTurns);
    m_tabs->setCurrentIndex(takesTurns ? pageTab : figureTab);
    m_column->setDirection(takesTurns ? QBoxLayout::BottomToTop : QBoxLayout::TopToBottom);
    arrange();
}

void RightSide::setLow(bool low) {
    m_tabs->setLow(low);
    arrange();
}

bool RightSide::leavesToPage() const {
    return m_takesTurns && !m_maximised && m_tabs->currentIndex() == pageTab;
}

void RightSide::turnTo(const QWidget *part) {
    if (!m_takesTurns)
        return;
    if (part == m_figure)
        m_tabs->setCurrentIndex(figureTab);
    else if (part == m_results && m_hasResults)
        m_tabs->setCurrentIndex(resultsTab);
    else if (part == m_findings)
        m_tabs->setCurrentIndex(findingsTab);
    else if (!part)
        m_tabs->setCurrentIndex(pageTab);
}

void RightSide::setMaximised(bool maximised) {
    m_maximised = maximised;
    arrange();
}

void RightSide::setComputing(bool computing) {
    if (m_computing == computing)
        return;
    m_computing = computing;
    if (computing) {
        m_markLater->start();
    } else {
        m_markLater->stop();
        m_mark->hide();
    }
}

void RightSide::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    m_mark->move((width() - m_mark->width()) / 2, m_mark->y());
}

void RightSide::arrange() {
    const std::array<QWidget *, 3> widgets{m_figure, m_results, m_findings};
    const bool instead = m_instead && !m_maximised;
    m_tabs->setVisible(m_tabbed && !m_maximised && (!instead || m_takesTurns));
    if (m_instead)
        m_instead->setVisible(instead && !leavesToPage());
    for (std::size_t i = 0; i < widgets.size(); ++i) {
        const bool chosen = !m_tabbed || m_tabs->currentIndex() == figureTab + static_cast<int>(i);
        const bool visible = m_maximised ? i == 0 : !instead && chosen && (i != 1 || m_hasResults);
        if (widgets[i]->isHidden() == visible) // showing it again would polish all below it
            widgets[i]->setVisible(visible);
    }
    setMaximumHeight(leavesToPage() ? m_tabs->sizeHint().height() : QWIDGETSIZE_MAX);
}

void RightSide::retranslate() {
    m_mark->setFont(themeFont(TextSize::small));
    m_mark->setText(tr("Being computed; shown is what was before"));
    m_tabs->setTabText(pageTab, tr("Page"));
    m_tabs->setTabText(figureTab, tr("Figure"));
    m_tabs->setTabText(resultsTab, tr("Results"));
    m_tabs->setTabText(findingsTab, tr("Findings"));
    m_tabs->setAccessibleName(tr("Figure, results, findings"));
}

} // namespace palmer::ui
