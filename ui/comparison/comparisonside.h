// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/comparedtests.h"
#include "ui/qtforward.h"

#include <QWidget>

namespace palmer::ui {

class ComparisonView;
class ElidedLabel;
class LineView;

/// Beside the page "Comparison": the difference of the mean deviations with its band, both means, and how the
/// uncertainty of the difference was made.
class ComparisonSide : public QWidget {
    Q_OBJECT

public:
    explicit ComparisonSide(QWidget *parent = nullptr);

    void show(const TestComparison &comparison, const PlacedTest &before, const PlacedTest &after);
    void clear();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void fitMethod();

    QLabel *m_differenceTitle;
    ElidedLabel *m_differenceNote;
    LineView *m_difference;
    QLabel *m_meansTitle;
    ComparisonView *m_means;
    QLabel *m_methodTitle;
    QScrollArea *m_methodPlace;
    QLabel *m_method;
};

} // namespace palmer::ui
