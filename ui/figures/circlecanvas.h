// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/circlefigure.h"
#include "report/explanations/explanation.h"
#include "ui/figures/circleplot.h"
#include "ui/model/background.h"
#include "ui/model/selection.h"

#include <memory>
#include <optional>
#include <vector>

namespace palmer::ui {

/// Paths of diagnosed sources, to be drawn over the measured ones.
struct SyntheticPaths {
    TestEvaluationPointer of;                         ///< evaluation they belong to
    std::shared_ptr<const std::vector<Points>> paths; ///< see profilesOfPaths; null: none

    bool operator==(const SyntheticPaths &) const = default;
};

/// Content of a circle figure, for any test.
struct CircleCanvasContent {
    CircleFigureOptions options; ///< the canvas replaces the size
    bool counterclockwise = true;
    bool clockwise = true;
    SyntheticPaths synthetic = {}; ///< not shown if they belong to another evaluation

    bool operator==(const CircleCanvasContent &) const = default;
};

/// Canvas of a circle figure: zooms, pans and reads angle, deviation and time of the point under the pointer.
/// A ReadingPlace identifies a point by its arc and index. The points about the centre are computed once per
/// evaluation; each view is binned again, so that millions of points stay responsive.
class CircleCanvas : public CirclePlot {
    Q_OBJECT

public:
    explicit CircleCanvas(Selection &selection, QWidget *parent = nullptr);

    /// Profiles of many points are made in the background; until then the former figure is shown.
    void show(const EvaluatedDocument &evaluated, std::size_t test, const CircleCanvasContent &content,
              const Language &language);
    /// True if the last request is not shown yet.
    [[nodiscard]] bool isMaking() const { return m_making.isBusy(); }
    void clear();
    /// Label explaining the chosen parameter ("G = 20,42 µm"), and the points that determine it.
    void setMarking(const QString &label, const std::vector<RulingPoint> &points);

    /// The same content and view in page size, for paper; null without a test.
    [[nodiscard]] std::optional<CircleFigure> paperFigure() const;
    /// Area of the text that names the centre.
    [[nodiscard]] QRect centreBox() const;
    /// Position of a point on the canvas; null if out of view.
    [[nodiscard]] std::optional<QPointF> placeOf(const ReadingPlace &point);
    /// Text of a point, "XY 12,30°  −2,21 µm  0,39 s"; empty if not shown.
    [[nodiscard]] QString readOut(const ReadingPlace &point) const;
    /// Text of its deviation, "−2,21 µm"; empty if not shown.
    [[nodiscard]] QString deviationText(const ReadingPlace &point) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {140, 140}; }
    [[nodiscard]] QSize sizeHint() const override { return {480, 330}; }

signals:
    void pressed();
    /// A figure made in the background is now shown.
    void made();

protected:
    [[nodiscard]] CircleFigure wholeFigure(QSizeF size, double pointStep) const override;
    [[nodiscard]] std::span<const PathProfile> paths() const override { return m_profiles; }
    void drawPicture(QPainter &painter) override;
    void paintOver(QPainter &painter) override;
    void hover(const std::optional<QPointF> &at) override {
        m_selection.setHovered(at ? pointedAt(*at) : std::nullopt);
    }
    void click(const QPointF &at) override;
    void mousePressEvent(QMouseEvent *event) override;

private:
    /// A point by the indices of its profile and within it.
    struct ProfilePoint {
        std::size_t profile = 0;
        std::size_t point = 0;
    };

    /// A request.
    struct Asked {
        EvaluatedDocument evaluated;
        std::size_t test = 0;
        CircleCanvasContent content;
    };

    void receive(std::optional<std::vector<PathProfile>> profiles);
    void addSynthetic(const Test &test, const SyntheticPaths &synthetic);
    [[nodiscard]] CircleFigure withoutHidden(CircleFigure figure) const;
    [[nodiscard]] bool shows(Sense sense) const;
    [[nodiscard]] QPointF shown(const TracePoint &point) const;
    [[nodiscard]] std::optional<ProfilePoint> nearest(QPointF at) const;
    [[nodiscard]] std::optional<ProfilePoint> pointOf(const RulingPoint &ruling) const;
    [[nodiscard]] std::optional<ProfilePoint> find(const ReadingPlace &place) const;
    [[nodiscard]] std::optional<ReadingPlace> pointedAt(const QPointF &at) const;
    void paintMarking(QPainter &painter) const;
    void paintCentre(QPainter &painter) const;

    Selection &m_selection;
    Asked m_asked;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    CircleCanvasContent m_content;
    TestEvaluationPointer m_profilesOf; ///< the evaluation of the profiles
    std::vector<PathProfile> m_profiles;
    CircleFigure m_shown; ///< m_figure without hidden parts
    QString m_markingLabel;
    std::vector<RulingPoint> m_ruling;
    double m_leftOfSenses = 0; ///< x in the picture
    Background m_making;
};

} // namespace palmer::ui
