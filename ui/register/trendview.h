// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"
#include "ui/register/registermenus.h"
#include "ui/register/trendchart.h"
#include "ui/register/trendfacts.h"

#include <QPushButton>
#include <QToolButton>
#include <array>
#include <set>

namespace palmer::ui {

/// The trend of a parameter: its chart and facts, the parameters to choose from, what is done with the chart.
class TrendView : public QWidget {
    Q_OBJECT

public:
    /// The buttons for editions and for the trend alone do what the menus do.
    explicit TrendView(const RegisterMenus &menus);

    /// Shows tests of one axis or plane; the chosen parameter stays if they have it. `about` follows its
    /// symbol in the title.
    void setTests(std::vector<ListedTest> tests, const QString &about);
    void setChosen(const std::map<QString, int> &numbers) { m_chart->setChosen(numbers); }
    void showFacts(bool show) { m_facts->setVisible(show); }
    void showEditions(bool show) { m_under->setVisible(show); } ///< or only their menu
    void retranslate();

signals:
    void testChosen(const QString &digest);
    void othersShown(const std::set<QString> &digests); ///< the tests of other series

protected:
    void changeEvent(QEvent *event) override;

private:
    QLayout *makeHead(const RegisterMenus &menus);
    void showParameters();
    void chooseParameter(const QAbstractButton *button);
    void showTrend();
    void showLegend();
    void sayMaximised(bool maximised);

    std::vector<ListedTest> m_tests;
    QString m_about;
    std::string m_parameter; ///< ID; empty: none
    QLabel *m_title = made<ElidedLabel>("trendTitle", TextSize::head);
    std::array<QToolButton *, 5> m_parameters{}; ///< the first ones are shown
    QPushButton *m_under = made<QPushButton>("evaluateUnder");
    QToolButton *m_copy = made<QToolButton>("copyTrend");
    QToolButton *m_maximise = made<QToolButton>("maximiseTrend", trait::checkable);
    TrendChart *m_chart = new TrendChart;
    QLabel *m_legend = made<QLabel>("trendLegend", TextSize::tiny, trait::wrapped);
    TrendFacts *m_facts = new TrendFacts;
};

} // namespace palmer::ui
