// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>

namespace palmer::ui {

class FigureView;
class FindingsPanel;
class PageTabs;
class ResultsPanel;
class Selection;

/// Figure, results and findings in a column, the figure taking the remaining height; in a narrow window one
/// at a time behind tabs. In a window too low for table and figure in a column, the page of the test is one
/// of the tabs too, which are then at the bottom.
class RightSide : public Translated<QWidget> {
    Q_OBJECT

public:
    static constexpr int leastFigureHeight = 200;

    explicit RightSide(Selection &selection, QWidget *parent = nullptr);

    [[nodiscard]] FigureView *figure() const { return m_figure; }
    [[nodiscard]] ResultsPanel *results() const { return m_results; }
    [[nodiscard]] FindingsPanel *findings() const { return m_findings; }

    /// A drift test has no results and shows no empty table.
    void setHasResults(bool has);
    void setTabbed(bool tabbed);
    /// Shows a widget made with this as parent instead of figure, results and findings; null: these again.
    void setInstead(QWidget *instead);
    [[nodiscard]] bool isTabbed() const { return m_tabbed; }
    /// Makes the page one of the tabs, and the current one.
    void setTakingTurns(bool takesTurns);
    /// Lower tabs for windows in which each table row counts.
    void setLow(bool low);
    [[nodiscard]] bool isTakingTurns() const { return m_takesTurns; }
    /// True if the page is shown and only the tab bar remains here.
    [[nodiscard]] bool leavesToPage() const;
    /// If the page is one of the tabs, shows a part (figure, results or findings) or, if null, the page.
    void turnTo(const QWidget *part);
    /// Shows only the figure.
    void setMaximised(bool maximised);
    /// Marks the figure as outdated while computing, after a delay so that the mark does not flash.
    void setComputing(bool computing);
    [[nodiscard]] bool isComputing() const { return m_computing; }

signals:
    /// The current tab changed while the page is one of the tabs.
    void turned();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void arrange();
    void retranslate() final;

    PageTabs *m_tabs;
    QVBoxLayout *m_column;
    FigureView *m_figure;
    ResultsPanel *m_results;
    FindingsPanel *m_findings;
    QLabel *m_mark; ///< over the figure
    QTimer *m_markLater;
    QWidget *m_instead = nullptr;
    bool m_computing = false;
    bool m_hasResults = true;
    bool m_tabbed = false;
    bool m_takesTurns = false;
    bool m_maximised = false;
};

} // namespace palmer::ui
