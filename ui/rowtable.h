// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "figures/figure.h"
#include "report/blocks/report.h"

#include <QTableWidget>
#include <initializer_list>
#include <vector>

namespace palmer::ui {

/// A quiet table without scrolling, whose page scrolls. Rows are selected; cells hold a text or a picture
/// below.
class RowTable : public QTableWidget {
    Q_OBJECT

public:
    /// Content of a cell besides its text.
    enum Role {
        barRole = Qt::UserRole + 1, ///< double: a bar over this part (0 … 1) of the cell
        firstRole,                  ///< bool: the bar is the first to improve
        histogramRole,              ///< index of a histogram set with setHistograms()
        warningRole,                ///< QString: a warning mark with these words after the text
        outdatedRole,               ///< bool: the histogram is dimmed
        whiskerRole,                ///< Whisker: the picture of a difference
        keyRole,                    ///< ID of the row, stored in its first cell
    };

    RowTable(const char *name, int columns, QWidget *parent);

    /// `number`: aligned right.
    void setHead(int column, const QString &text, bool number);
    QTableWidgetItem *setCell(int row, int column, const QString &text, bool number, bool bold = false);
    void setHistograms(std::vector<HistogramFigure> histograms);
    [[nodiscard]] const HistogramFigure *histogram(const QModelIndex &index) const;
    /// Fits the height to the rows and columns to their content; `flexible` takes the remaining width, of
    /// which `elided` columns give up what its `least` width lacks.
    void fit(int flexible, int least, std::initializer_list<int> elided = {});
    /// A column of pictures of that width, left out where the flexible one would be cut.
    void setPictures(int column, int width);
    /// Key of a row; empty if there is none.
    [[nodiscard]] QString key(int row) const;
    /// The row of a key; −1 if there is none.
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
    int m_pictures = -1;
    int m_pictureWidth = 0;
    std::vector<HistogramFigure> m_histograms;
};

} // namespace palmer::ui

Q_DECLARE_METATYPE(palmer::Whisker)
