// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/curves.h"
#include "register/queries.h"

#include <QChartView>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QButtonGroup;

namespace palmer::ui {

/// The mean deviations of several tests of one axis over each other, and below the difference of two.
class CurveComparison : public QWidget {
    Q_OBJECT

public:
    explicit CurveComparison(QWidget *parent = nullptr);

    /// Tests in the order of their numbers, with their curves.
    void setTests(std::vector<ListedTest> tests);
    [[nodiscard]] const std::optional<CurveDifference> &difference() const { return m_difference; }

    static constexpr std::size_t mostCurves = 6;

signals:
    void closed();

protected:
    void changeEvent(QEvent *event) override;

private:
    void rebuild();
    void rebuildDifference();
    void retranslate();
    [[nodiscard]] QPen penOf(std::size_t curve) const;
    [[nodiscard]] double scale() const;
    [[nodiscard]] QString unit() const;

    std::vector<ListedTest> m_tests;
    CurveOf m_of = CurveOf::both;
    std::optional<CurveDifference> m_difference;
    QLabel *m_title;
    QLabel *m_list;
    QChartView *m_curves;
    QChartView *m_differences;
    QLabel *m_differenceTitle;
    QComboBox *m_first;
    QComboBox *m_second;
    QLabel *m_travel;
};

} // namespace palmer::ui
