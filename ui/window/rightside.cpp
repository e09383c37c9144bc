#include "ui/window/rightside.h"

#include "ui/theme.h"
#include "ui/window/pagetabs.h"

#include <QEvent>
#include <QFrame>
#include <QVBoxLayout>
#include <array>

namespace palmer::ui {

RightSide::RightSide(QWidget *figure, QWidget *results, QWidget *findings, QWidget *parent)
    : QWidget(parent)
    , m_tabs(new PageTabs(this))
    , m_figure(figure)
    , m_results(results)
    , m_findings(findings) {
    setObjectName(QStringLiteral("rightSide"));
    setAttribute(Qt::WA_StyledBackground);
    setProperty("ground", QStringLiteral("base"));
    m_tabs->setObjectName(QStringLiteral("rightTabs"));
    for (int i = 0; i < 3; ++i)
        m_tabs->addTab(QString());
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *tabRow = new QHBoxLayout;
    tabRow->setContentsMargins(12, 0, 12, 0);
    tabRow->addWidget(m_tabs);
    column->addLayout(tabRow);
    column->addWidget(m_figure, 1);
    column->addWidget(m_results);
    column->addWidget(m_findings);
    m_figure->setMinimumHeight(leastFigureHeight);
    connect(m_tabs, &QTabBar::currentChanged, this, &RightSide::arrange);
    retranslate();
    arrange();
}

void RightSide::setTabbed(bool tabbed) {
    if (m_tabbed == tabbed)
        return;
    m_tabbed = tabbed;
    arrange();
}

void RightSide::setMaximised(bool maximised) {
    m_maximised = maximised;
    arrange();
}

void RightSide::arrange() {
    const std::array widgets{m_figure, m_results, m_findings};
    m_tabs->setVisible(m_tabbed && !m_maximised);
    for (std::size_t i = 0; i < widgets.size(); ++i) {
        const bool chosen = !m_tabbed || m_tabs->currentIndex() == static_cast<int>(i);
        widgets[i]->setVisible(m_maximised ? i == 0 : chosen);
    }
}

void RightSide::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void RightSide::retranslate() {
    m_tabs->setTabText(0, tr("Figure"));
    m_tabs->setTabText(1, tr("Results"));
    m_tabs->setTabText(2, tr("Findings"));
    m_tabs->setAccessibleName(tr("Figure, results, findings"));
}

} // namespace palmer::ui
