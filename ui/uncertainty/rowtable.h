// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "print/figures/style.h"

#include <QTableWidget>
#include <initializer_list>
#include <vector>

namespace palmer::ui {

/// A quiet table of a page that scrolls as a whole: every row is in view, a row is chosen as one. Cells are
/// texts, or hold one of the pictures below.
class RowTable : public QTableWidget {
    Q_OBJECT

public:
    /// What a cell may hold besides its text.
    enum Role {
        barRole = Qt::UserRole + 1, ///< double: a bar, this part (0 … 1) of the cell
        firstRole,                  ///< bool: of a bar, it is what is to be improved first
        histogramRole,              ///< index of a histogram handed over with setHistograms()
        warningRole,                ///< QString: a warning mark and these words behind the text
        outdatedRole,               ///< bool: a histogram stands back
        keyRole,                    ///< of the first cell of a row: what the row stands for
    };

    RowTable(const char *name, int columns, QWidget *parent);

    /// `number`: at the right edge.
    void setHead(int column, const QString &text, bool number);
    QTableWidgetItem *setCell(int row, int column, const QString &text, bool number, bool bold = false);
    void setHistograms(std::vector<HistogramFigure> histograms);
    [[nodiscard]] const HistogramFigure *histogram(const QModelIndex &index) const;
    /// As high as its rows, columns as wide as what they say; `flexible` takes what is left, of those in
    /// `elided` is taken what is missing to its `least` width.
    void fit(int flexible, int least, std::initializer_list<int> elided = {});
    /// Key of a row, empty where there is none.
    [[nodiscard]] QString key(int row) const;
    /// The row of a key; −1 for none.
    [[nodiscard]] int rowOf(const QString &wanted) const;

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void wheelEvent(QWheelEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void fitColumns();
    [[nodiscard]] int wantedWidth(int column) const;

    int m_flexible = -1;
    int m_least = 0;
    std::vector<int> m_elided;
    std::vector<HistogramFigure> m_histograms;
};

/// Light or dark, as the palette is.
[[nodiscard]] Medium screenMedium(const QPalette &palette);

} // namespace palmer::ui
