// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QTimer;
class QVBoxLayout;

namespace palmer::ui {

class FigureView;
class FindingsPanel;
class PageTabs;
class ResultsPanel;
class Selection;

/// Figure, results and findings: below one another, the figure taking what is left; in a narrow window one
/// at a time behind tabs. Where that is so low that table and figure find no room below one another, the page
/// of the test is one of the tabs, too, which then stand at the bottom.
class RightSide : public QWidget {
    Q_OBJECT

public:
    static constexpr int leastFigureHeight = 200;

    explicit RightSide(Selection &selection, QWidget *parent = nullptr);

    [[nodiscard]] FigureView *figure() const { return m_figure; }
    [[nodiscard]] ResultsPanel *results() const { return m_results; }
    [[nodiscard]] FindingsPanel *findings() const { return m_findings; }

    /// A drift test has no results: no empty table for it.
    void setHasResults(bool has);
    void setTabbed(bool tabbed);
    [[nodiscard]] bool isTabbed() const { return m_tabbed; }
    /// The page takes turns with what is here; begins with the page.
    void setTakingTurns(bool takesTurns);
    /// For windows in which each row of a table counts.
    void setLow(bool low);
    [[nodiscard]] bool isTakingTurns() const { return m_takesTurns; }
    /// It is the turn of the page: nothing but the tabs is here.
    [[nodiscard]] bool leavesToPage() const;
    /// Gives the turn to a part, where they take turns: figure, results or findings; null: the page.
    void turnTo(const QWidget *part);
    /// The figure alone.
    void setMaximised(bool maximised);
    /// Marks what is shown as of before an edit; a mark that would go at once does not come.
    void setComputing(bool computing);
    [[nodiscard]] bool isComputing() const { return m_computing; }

signals:
    /// Another has its turn.
    void turned();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void arrange();
    void retranslate();

    PageTabs *m_tabs;
    QVBoxLayout *m_column;
    FigureView *m_figure;
    ResultsPanel *m_results;
    FindingsPanel *m_findings;
    QLabel *m_mark; ///< over the figure
    QTimer *m_markLater;
    bool m_computing = false;
    bool m_hasResults = true;
    bool m_tabbed = false;
    bool m_takesTurns = false;
    bool m_maximised = false;
};

} // namespace palmer::ui
