// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTabBar>

namespace palmer::ui {

/// The tabs of a test: plain words, the current one underlined in the accent colour, each followed by the
/// number of statements missing on its page.
class PageTabs : public QTabBar {
    Q_OBJECT

public:
    explicit PageTabs(QWidget *parent = nullptr);

    /// Number of missing statements of a tab; 0 shows none.
    void setCount(int tab, int count);
    [[nodiscard]] int count(int tab) const;
    using QTabBar::count;
    /// Lower tabs for windows in which each table row counts.
    void setLow(bool low);

protected:
    [[nodiscard]] QSize tabSizeHint(int index) const override;
    [[nodiscard]] QSize minimumTabSizeHint(int index) const override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void tabLayoutChange() override { fit(); }

private:
    /// Where words do not fit as wide as they are in bold, only the current one is.
    void fit();
    [[nodiscard]] int widthOf(int index, bool tight) const;

    bool m_low = false;
    bool m_tight = false;
    int m_widest = -1; ///< the current tab when the sizes were updated
};

} // namespace palmer::ui
