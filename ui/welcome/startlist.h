#pragma once

#include "ui/verdictmark.h"

#include <QAbstractListModel>
#include <QListView>
#include <QString>
#include <vector>

namespace palmer::ui {

/// A file that a list of the welcome page offers.
struct StartEntry {
    QString path;
    QString icon;
    QString name;
    QString detail;
    QString right; ///< date, or year of the edition
    VerdictMark mark;
};

class StartModel : public QAbstractListModel {
    Q_OBJECT

public:
    enum Role { detailRole = Qt::UserRole + 1, rightRole, iconRole, markRole, markColourRole, pathRole };

    using QAbstractListModel::QAbstractListModel;

    void setEntries(std::vector<StartEntry> entries);

    [[nodiscard]] int rowCount(const QModelIndex &parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex &index, int role) const override;

private:
    std::vector<StartEntry> m_entries;
};

/// Files to start from, two lines each; a click or Enter chooses one. As high as its rows, up to `mostRows`.
class StartList : public QListView {
    Q_OBJECT

public:
    StartList(StartModel &model, int mostRows, QWidget *parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, rowHeight}; }

    static constexpr int rowHeight = 52;

signals:
    void chosen(const QString &path);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    int m_mostRows;
};

} // namespace palmer::ui
