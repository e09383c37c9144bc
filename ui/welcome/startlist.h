// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/verdictmark.h"

#include <QAbstractListModel>
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

class StartModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role {
        detailRole = Qt::UserRole + 1,
        rightRole,
        iconRole,
        markRole,
        markColourRole,
        accordanceRole,
        accordanceColourRole,
        pathRole
    };

    using QAbstractListModel::QAbstractListModel;

    void setEntries(std::vector<StartEntry> entries);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    std::vector<StartEntry> m_entries;
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
    static constexpr int lineHeight = 26;

signals:
    void chosen(const QString &path);

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool viewportEvent(QEvent *event) override;

private:
    [[nodiscard]] int columns() const;

    int m_mostRows; ///< 0: one line each, in columns
};

} // namespace palmer::ui
