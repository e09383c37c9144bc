// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/circlefigure.h"
#include "language/language.h"
#include "print/figures/drawfigure.h"
#include "report/explanations/explanation.h"
#include "ui/model/background.h"
#include "ui/model/selection.h"

#include <QPixmap>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace palmer::ui {

/// Paths to be drawn over the measured ones: what sources of a diagnosis make.
struct SyntheticPaths {
    TestEvaluationPointer of;                         ///< whose paths they are
    std::shared_ptr<const std::vector<Points>> paths; ///< see profilesOfPaths; null: none

    bool operator==(const SyntheticPaths &) const = default;
};

/// What of a circle figure is shown, whatever the test.
struct CircleCanvasContent {
    CircleFigureOptions options; ///< size: that of the canvas counts
    bool counterclockwise = true;
    bool clockwise = true;
    SyntheticPaths synthetic = {}; ///< of another evaluation: not shown

    bool operator==(const CircleCanvasContent &) const = default;
};

/// The surface of a circle figure: zoom, pan, reads angle, deviation and time of the point under the pointer.
/// A point is named by a ReadingPlace: its arc and its index there. The points about the centre are computed
/// once per evaluation; every view bins what is in it anew, so that millions of points stay fluid.
class CircleCanvas : public QWidget {
    Q_OBJECT

public:
    explicit CircleCanvas(Selection &selection, QWidget *parent = nullptr);

    /// Profiles of many points are made beside the window, which shows the figure of before until then.
    void show(const EvaluatedDocument &evaluated, std::size_t test, const CircleCanvasContent &content,
              const Language &language);
    /// Whether what was asked for last is not shown yet.
    [[nodiscard]] bool isMaking() const { return m_making.isBusy(); }
    void clear();
    /// What the explanation of the chosen parameter says ("G = 20,42 µm"), and the points that rule it.
    void setMarking(const QString &label, const std::vector<RulingPoint> &points);

    /// The figure for paper: the same content and view in the size of a page; nothing without a test.
    [[nodiscard]] std::optional<CircleFigure> paperFigure() const;
    [[nodiscard]] const CircleView &view() const { return m_view; }
    void setView(const CircleView &view);
    /// The sentence about which centre it is drawn.
    [[nodiscard]] QRect centreBox() const;
    void fit() { setView({}); }
    /// In by so many steps of the wheel about the middle, out where negative.
    void zoomBy(int steps);
    /// The view nearest to one that shows nothing beyond the figure and zooms no deeper than makes sense.
    [[nodiscard]] static CircleView within(CircleView view, const CircleFigure &figure);
    /// Where a point stands on the canvas; nothing where it is out of view.
    [[nodiscard]] std::optional<QPointF> placeOf(const ReadingPlace &point);
    /// "XY 12,30°  −2,21 µm  0,39 s" of a point; empty where it is not shown.
    [[nodiscard]] QString readOut(const ReadingPlace &point) const;
    /// "−2,21 µm": the deviation of it; empty where it is not shown.
    [[nodiscard]] QString deviationText(const ReadingPlace &point) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {140, 140}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 330}; }

signals:
    void pressed();
    /// The figure that had to be waited for is shown.
    void made();

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    /// A point of a profile: indices of both.
    struct ProfilePoint {
        std::size_t profile = 0;
        std::size_t point = 0;
    };

    /// What is to be shown.
    struct Asked {
        EvaluatedDocument evaluated;
        std::size_t test = 0;
        CircleCanvasContent content;
    };

    void take(std::optional<std::vector<PathProfile>> profiles);
    void drawAnew();
    void addSynthetic(const Test &test, const SyntheticPaths &synthetic);
    void zoom(double factor, QPointF about);
    void pan(QPointF by);
    [[nodiscard]] CircleFigure withoutHidden(CircleFigure figure) const;
    [[nodiscard]] bool shows(Sense sense) const;
    [[nodiscard]] QPointF shown(const TracePoint &point) const;
    [[nodiscard]] std::optional<ProfilePoint> nearest(QPointF at) const;
    [[nodiscard]] std::optional<ProfilePoint> pointOf(const RulingPoint &ruling) const;
    [[nodiscard]] std::optional<ProfilePoint> find(const ReadingPlace &place) const;
    [[nodiscard]] ReadingPlace placeOf(const ProfilePoint &point) const;
    void paintMarking(QPainter &painter) const;
    void paintHover(QPainter &painter) const;
    void paintCentre(QPainter &painter) const;

    Selection &m_selection;
    Asked m_asked;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    CircleCanvasContent m_content;
    Language m_language{Language::Id::english};
    TestEvaluationPointer m_profilesOf; ///< the evaluation the profiles were made from
    std::vector<PathProfile> m_profiles;
    std::optional<CircleFigure> m_figure; ///< in the view painted last; null: to be made
    CircleFigure m_shown;                 ///< what of it is not hidden
    CircleView m_view;
    QString m_markingLabel;
    std::vector<RulingPoint> m_ruling;
    QPixmap m_drawn; ///< null: to be drawn
    FigureTransform m_transform;
    double m_leftOfSenses = 0;     ///< of m_drawn
    std::optional<QPointF> m_drag; ///< where the pointer was
    bool m_dragged = false;
    Background m_making;
};

} // namespace palmer::ui
