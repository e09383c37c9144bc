// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/curves.h"
#include "register/queries.h"
#include "ui/qtforward.h"

#include <QChartView>
#include <QWidget>
#include <vector>

namespace palmer::ui {

/// A chart with numbered tags at the ends of its curves and a boxed label at a point.
class TaggedChart : public QChartView {
    Q_OBJECT

public:
    explicit TaggedChart(const char *name);

    struct Tag {
        int number = 0; ///< of the curve, from 1
        QPointF end;    ///< end of the curve, in the units of the axes
    };
    void setTags(std::vector<Tag> tags);
    /// An empty text removes the box.
    void setBox(const QPointF &at, const QString &text, const QColor &colour);
    /// Centres of the tags in the chart, px, in the order of the curves.
    [[nodiscard]] std::vector<QPointF> tagPlaces() const;
    [[nodiscard]] const QString &box() const { return m_box; }

protected:
    void drawForeground(QPainter *painter, const QRectF &rect) override;

private:
    std::vector<Tag> m_tags;
    QPointF m_boxAt;
    QString m_box;
    QColor m_boxColour;
};

/// The mean deviations of several tests of an axis superimposed, and below them the difference of two.
class CurveComparison : public QWidget {
    Q_OBJECT

public:
    explicit CurveComparison(QWidget *parent = nullptr);

    /// Tests with their curves, in the order of their numbers.
    void setTests(std::vector<ListedTest> tests);
    [[nodiscard]] const std::optional<CurveDifference> &difference() const { return m_difference; }

    /// Height for all rows of the list and both charts.
    [[nodiscard]] int wantedHeight() const;

    static constexpr std::size_t mostCurves = 6;

signals:
    void closed();

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void rebuild();
    void rebuildDifference();
    void sayDifference(const QColor &ink);
    void retranslate();
    void showList();
    [[nodiscard]] QString listOf(int mostWords) const;
    void fitList();
    [[nodiscard]] int heightOfOthers() const;
    [[nodiscard]] bool isAngular() const;
    [[nodiscard]] Quantity valueQuantity() const;
    [[nodiscard]] Quantity positionQuantity() const;
    [[nodiscard]] QPen penOf(std::size_t curve) const;
    [[nodiscard]] QPointF scales() const; ///< from mm or degrees to the units of the window
    void addAxes(QChart &chart, const QString &title) const;

    std::vector<ListedTest> m_tests;
    CurveOf m_of = CurveOf::both;
    std::optional<CurveDifference> m_difference;
    QLabel *m_title;
    QLabel *m_list;
    QScrollArea *m_listArea;
    TaggedChart *m_curves;
    TaggedChart *m_differences;
    QLabel *m_differenceTitle;
    QComboBox *m_first;
    QComboBox *m_second;
    QLabel *m_travel;
};

} // namespace palmer::ui
