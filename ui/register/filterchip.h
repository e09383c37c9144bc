// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

class QMenu;

namespace palmer::ui {

/// A filter of a list: what it filters by, or the value that was chosen with a ✕ that takes it away. A press
/// elsewhere opens the menu of the values; Delete takes the value away, too. Gives way where there is no
/// room.
class FilterChip : public QAbstractButton {
    Q_OBJECT

public:
    explicit FilterChip(QWidget *parent = nullptr);

    [[nodiscard]] QMenu *menu() const { return m_menu; }
    /// `shown`: the chosen value in words; empty where all pass.
    void setContent(const QString &name, const QString &shown);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void cleared();

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void nextCheckState() override {} ///< checked is what has a value

private:
    [[nodiscard]] bool isOnCross(const QPoint &place) const;
    void openMenu();

    QMenu *m_menu;
    bool m_clearing = false; ///< the ✕ was pressed
};

} // namespace palmer::ui
