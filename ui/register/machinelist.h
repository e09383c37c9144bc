// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/due.h"
#include "register/queries.h"
#include "ui/quiettable.h"

#include <vector>

namespace palmer::ui {

inline constexpr int machineRowHeight = 50;

/// A machine as shown in the list.
struct MachineRow {
    ListedMachine machine;
    std::vector<AxisState> axes;
    MachineDue due;
    int tests = 0;

    [[nodiscard]] QString title() const; ///< its name, or that it has none
    /// Days until an action is due; null if none is due within the warning time.
    [[nodiscard]] std::optional<int> daysToTest(const QDate &today) const;
    [[nodiscard]] std::optional<int> daysToCertificate(const QDate &today) const;
    [[nodiscard]] bool isToDo(const QDate &today) const;
    /// Returns what it is known by besides its name: maker, type, serial number or that it has none,
    /// location.
    [[nodiscard]] QStringList facts() const;
};

inline constexpr int warningDays = 30;

/// The machines, filtered by words and by what is due.
class MachineModel : public RowModel<MachineRow> {
    Q_OBJECT

public:
    using RowModel::RowModel;

    void setRows(std::vector<MachineRow> rows);
    enum class Show { all, toDo };
    void setFilter(const QString &words, Show show);
    [[nodiscard]] int toDoCount() const;
    [[nodiscard]] const std::vector<MachineRow> &all() const { return m_all; }
    [[nodiscard]] int machineCount() const { return static_cast<int>(m_all.size()); }
    [[nodiscard]] int testCount() const;

protected:
    [[nodiscard]] QVariant cell(const MachineRow &machine, int column, int role) const override;

private:
    void filter();

    std::vector<MachineRow> m_all;
    QString m_words;
    Show m_show = Show::all;
};

/// Draws a machine: its name, what identifies it, the marks of its axes and what is due.
class MachineDelegate : public RowDelegate {
    Q_OBJECT

public:
    explicit MachineDelegate(QObject *parent)
        : RowDelegate(parent, selectedBar | focusFrame) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

protected:
    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override;
};

} // namespace palmer::ui
