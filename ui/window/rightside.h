#pragma once

#include <QWidget>

class QTabBar;
class QVBoxLayout;

namespace palmer::ui {

/// Figure, results and findings: below one another, the figure taking what is left; in a narrow window one
/// at a time behind tabs.
class RightSide : public QWidget {
    Q_OBJECT

public:
    static constexpr int leastFigureHeight = 200;

    /// Takes the three widgets as children.
    RightSide(QWidget *figure, QWidget *results, QWidget *findings, QWidget *parent = nullptr);

    void setTabbed(bool tabbed);
    [[nodiscard]] bool isTabbed() const { return m_tabbed; }
    /// The figure alone.
    void setMaximised(bool maximised);

protected:
    void changeEvent(QEvent *event) override;

private:
    void arrange();
    void retranslate();

    QTabBar *m_tabs;
    QWidget *m_figure;
    QWidget *m_results;
    QWidget *m_findings;
    bool m_tabbed = false;
    bool m_maximised = false;
};

} // namespace palmer::ui
