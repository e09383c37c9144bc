// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/quiettable.h"
#include "ui/verdictmark.h"

#include <QListView>
#include <QString>
#include <vector>

namespace palmer::ui {

/// A file offered in a list of the welcome page.
struct StartEntry {
    QString path;
    QString icon;
    QString name;
    QString detail;
    QString right;               ///< date, or year of the edition
    VerdictMark mark;            ///< limits
    VerdictMark accordance = {}; ///< with the editions
};

class StartModel : public RowModel<StartEntry> {
    Q_OBJECT

public:
    using RowModel::RowModel;

    void setEntries(std::vector<StartEntry> entries) { reset(std::move(entries)); }

protected:
    [[nodiscard]] QVariant cell(const StartEntry &entry, int column, int role) const override;
};

/// Files to start from; a click or Enter chooses one. Either two lines each, as high as its rows up to
/// `mostRows`, or one line each in as many columns as fit, all visible.
class StartList : public QListView {
    Q_OBJECT

public:
    StartList(StartModel &model, int mostRows, QWidget *parent = nullptr);
    explicit StartList(StartModel &model, QWidget *parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    [[nodiscard]] bool isCompact() const { return m_mostRows == 0; }
    /// Size of a one-line entry.
    [[nodiscard]] QSize compactSize() const;

    static constexpr int rowHeight = 52;
    static constexpr int lineHeight = 22;

signals:
    void chosen(const QString &path);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool viewportEvent(QEvent *event) override;

private:
    [[nodiscard]] int columns() const;
    void choose(const QModelIndex &index);

    int m_mostRows; ///< 0: one line each, in columns
};

} // namespace palmer::ui
