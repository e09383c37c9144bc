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

    /// How the tabs get room: none is needed, only the current word is bold, words are small as well, counts
    /// are dots.
    enum class Tightness { none, tight, small, dots };

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
    void fit();
    void paintCount(QPainter &painter, const QRect &badge, int count) const;
    [[nodiscard]] bool fits(Tightness tightness) const;
    [[nodiscard]] int widthOf(int index, Tightness tightness) const;

    bool m_low = false;
    Tightness m_tightness = Tightness::none;
    int m_widest = -1; ///< the current tab when the sizes were updated
};

} // namespace palmer::ui
