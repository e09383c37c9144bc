// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/navigation/navigationmodel.h"
#include "ui/translated.h"

#include <QListView>

namespace palmer::ui {

/// The list on the left of a window: 184 px wide, or collapsed to 48 px with icons and verdict marks.
class NavigationList : public Translated<QListView> {
    Q_OBJECT

public:
    static constexpr int fullWidth = 184;
    static constexpr int railWidth = 48;

    explicit NavigationList(NavigationModel &model, QWidget *parent = nullptr);

    void setRail(bool rail);
    [[nodiscard]] bool isRail() const { return m_rail; }
    /// Marks the row in view without emitting signals.
    void setCurrentRow(const QModelIndex &index);

signals:
    void pageChosen(palmer::ui::Page page);
    void testChosen(std::size_t test);

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;

private:
    void retranslate() final;

    NavigationModel &m_model;
    bool m_rail = false;
    bool m_silent = false;
};

} // namespace palmer::ui
