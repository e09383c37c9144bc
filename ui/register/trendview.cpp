// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/trendview.h"

#include "register/listing.h"
#include "register/trendfigure.h"
#include "register/trendoutput.h"
#include "ui/figures/zoombuttons.h"
#include "ui/measures.h"
#include "ui/windowlanguage.h"

#include <QAction>
#include <QButtonGroup>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QMenu>
#include <algorithm>

namespace palmer::ui {

namespace {

const QString parameterButton = QStringLiteral("parameter "); ///< its name begins so, its ID follows

} // namespace

TrendView::TrendView(const RegisterMenus &menus) {
    m_legend->setAlignment(Qt::AlignCenter);
    m_legend->setTextFormat(Qt::RichText);
    m_legend->setSizePolicy(QSizePolicy::Ignored,
                            QSizePolicy::Preferred); // the list of machines keeps its width
    auto *trend = new QWidget;
    trend->setMinimumWidth(1); // hidden next to the curves when space is short
    inColumn(trend, {pageMargin, 8, 8, 8}, styleSpacing, {makeHead(menus), {m_chart, 1}, m_legend});
    inRow(this, noMargins, 0, {{trend, 1}, m_facts});
    connect(m_chart, &TrendChart::testChosen, this, &TrendView::testChosen);
}

QLayout *TrendView::makeHead(const RegisterMenus &menus) {
    m_under->setMinimumWidth(1); // hidden when space is short
    m_under->setMenu(menus.under);
    for (const auto &[button, icon] : {std::pair(m_copy, "copy"), std::pair(m_maximise, "maxi")}) {
        button->setIcon(lineIcon(QString::fromLatin1(icon)));
        button->setProperty("iconOnly", true);
    }
    connect(m_copy, &QToolButton::clicked, this, [this] {
        if (!m_chart->panel().values.empty())
            QGuiApplication::clipboard()->setPixmap(m_chart->grab());
    });
    connect(m_maximise, &QToolButton::toggled, this, &TrendView::sayMaximised);
    connect(m_maximise, &QToolButton::toggled, menus.trendAlone, &QAction::setChecked);
    connect(menus.trendAlone, &QAction::toggled, m_maximise, &QToolButton::setChecked);
    auto *zoom = new ZoomButtons;
    connect(zoom, &ZoomButtons::zoomWanted, m_chart, &TrendChart::zoomBy);
    connect(zoom, &ZoomButtons::fitWanted, m_chart, &TrendChart::showAll);
    auto *choice = new QButtonGroup(this);
    auto *parameters = inRow(0, {});
    for (QToolButton *&button : m_parameters) {
        button = made<QToolButton>({}, trait::checkable);
        choice->addButton(button);
        parameters->addWidget(button);
    }
    connect(choice, &QButtonGroup::buttonClicked, this, &TrendView::chooseParameter);
    return inRow(styleSpacing, {{m_title, 1}, parameters, m_under, zoom, m_copy, m_maximise});
}

void TrendView::changeEvent(QEvent *event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) // the colours of the texts are set once
        showTrend();
}

void TrendView::retranslate() {
    m_under->setText(tr("Evaluate all under…"));
    nameWidget(*m_copy, tr("Copy the chart"));
    sayMaximised(m_maximise->isChecked());
    showLegend();
}

void TrendView::sayMaximised(bool maximised) {
    const QString does = maximised ? tr("Show tests and machines again (Esc)") : tr("Show the trend alone");
    nameWidget(*m_maximise, does);
}

/// Shows the legend in the colours of the chart.
void TrendView::showLegend() {
    const QString accent = token(Token::accent, palette()).name();
    const QString secondary = token(Token::secondaryText, palette()).name();
    const QString text = palette().color(QPalette::WindowText).name();
    const QString explanation = token(Token::explanation, palette()).name();
    const std::array<std::pair<const char *, QString>, 7> signs{{{"○", accent},
                                                                 {"●", accent},
                                                                 {"□", secondary},
                                                                 {"━", text},
                                                                 {"▬", accent},
                                                                 {"┊", explanation},
                                                                 {"△", accent}}}; // as in TrendSign
    QStringList legend;
    for (const TrendLegendEntry &entry : trendLegend(windowLanguage(), {m_chart->trend()})) {
        const auto &[sign, colour] = signs.at(static_cast<std::size_t>(entry.sign));
        const QString one = entry.sign == TrendSign::otherSeries
                                ? otherSeries(m_chart->trend(), windowLanguage())
                                : entry.text;
        // Line breaks only between the entries.
        legend << QStringLiteral("<span style='color:%1'>%2</span>&nbsp;%3")
                      .arg(colour, QString::fromUtf8(sign),
                           one.toHtmlEscaped().replace(u' ', QStringLiteral("&nbsp;")));
    }
    m_legend->setText(legend.join(QStringLiteral(" &nbsp;&nbsp;&nbsp; ")));
}

void TrendView::setTests(std::vector<ListedTest> tests, const QString &about) {
    m_tests = std::move(tests);
    m_about = about;
    m_under->setEnabled(!m_tests.empty());
    showParameters();
    showTrend();
}

void TrendView::showParameters() {
    std::vector<std::string> parameters = parametersOf(m_tests);
    parameters.resize(std::min(parameters.size(), m_parameters.size()));
    if (std::ranges::find(parameters, m_parameter) == parameters.end())
        m_parameter = parameters.empty() ? std::string() : parameters.front();
    for (std::size_t i = 0; i < m_parameters.size(); ++i) {
        QToolButton *button = m_parameters.at(i);
        button->setVisible(i < parameters.size());
        if (i >= parameters.size())
            continue;
        button->setText(plainSymbolOf(parameters[i]));
        button->setObjectName(parameterButton + QString::fromStdString(parameters[i]));
        if (parameters[i] == m_parameter)
            button->setChecked(true);
    }
}

void TrendView::chooseParameter(const QAbstractButton *button) {
    m_parameter = button->objectName().mid(parameterButton.size()).toStdString();
    showTrend();
}

void TrendView::showTrend() {
    const MachineTrend trend = machineTrend(m_tests, m_parameter);
    m_chart->setTrend(trend, QDate::currentDate());
    std::set<QString> others;
    for (std::size_t i = 1; i < trend.series.size(); ++i) {
        for (const TrendEntry &entry : trend.series[i].entries)
            others.insert(entry.digest);
    }
    emit othersShown(others);
    m_facts->setTrend(trend);
    m_title->setText(m_parameter.empty() ? tr("Trend")
                                         : tr("Trend of %1, %2").arg(plainSymbolOf(m_parameter), m_about));
    showLegend();
}

} // namespace palmer::ui
