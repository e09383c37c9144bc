// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

class QMenu;

namespace palmer::ui {

/// A filter of a list: shows its name, or the chosen value with a ✕ that clears it. A click elsewhere opens
/// the menu of values; Delete clears too. Shrinks if space is short.
class FilterChip : public QAbstractButton {
    Q_OBJECT

public:
    explicit FilterChip(QWidget *parent = nullptr);

    [[nodiscard]] QMenu *menu() const { return m_menu; }
    /// `shown`: the chosen value in words; empty if nothing is filtered.
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
    void nextCheckState() override {} ///< checked means that a value is set

private:
    [[nodiscard]] bool isOnCross(const QPoint &place) const;
    void openMenu();

    QMenu *m_menu;
    bool m_clearing = false; ///< the ✕ was pressed
};

} // namespace palmer::ui
