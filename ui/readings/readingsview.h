#pragma once

#include "ui/model/selection.h"
#include "ui/readings/readingsmodel.h"

#include <QTableView>
#include <vector>

namespace palmer::ui {

/// The table of readings: a head of two storeys, and i and P that stay while the rest scrolls.
class ReadingsView : public QTableView {
    Q_OBJECT

public:
    ReadingsView(ReadingsModel &model, Selection &selection, QWidget *parent = nullptr);

    /// Widths of columns after the model changed what it shows.
    void fitColumns();
    /// Targets (indices) that rule the result explained.
    void setRuling(const std::vector<std::size_t> &targets);

signals:
    /// Mean and range of what is selected; empty: nothing.
    void summaryChanged(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void selectionChanged(const QItemSelection &selected, const QItemSelection &deselected) override;
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    bool viewportEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;
    void scrollTo(const QModelIndex &index, ScrollHint hint) override;
    void updateGeometries() override;

private:
    void hover(const QModelIndex &index);
    void showHovered();
    void showCurrent();
    void placeFrozen();
    void setRowHeight();

    ReadingsModel &m_model;
    Selection &m_selection;
    QTableView *m_frozen;
    QModelIndex m_hovered;
    bool m_following = false; ///< the selection of the window is what moves the current cell
};

} // namespace palmer::ui
