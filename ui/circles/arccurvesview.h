// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/figure.h"
#include "figures/pathprofile.h"
#include "language/language.h"
#include "ui/model/background.h"
#include "ui/model/selection.h"
#include "ui/picturewidget.h"

#include <optional>
#include <vector>

namespace palmer::ui {

/// The arcs of a circular test unwrapped: radial deviation from the least squares centre over the angle. The
/// evaluated range of the current arc has a handle at each end; the part outside is shaded.
class ArcCurvesView : public PictureWidget {
    Q_OBJECT

public:
    explicit ArcCurvesView(Selection &selection, QWidget *parent = nullptr);

    /// Curves of many points are made in the background; until then the former ones are shown.
    void show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    void clear();
    [[nodiscard]] bool isMaking() const { return m_making.isBusy(); }
    void setCurrentArc(std::size_t arc);

    /// x coordinate in the widget of an angle (degrees).
    [[nodiscard]] double xOf(double angle) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 110}; }
    [[nodiscard]] QSize sizeHint() const override { return {528, 164}; }

signals:
    /// The user dragged a handle of the current arc: the range to evaluate (degrees).
    void rangeWanted(std::size_t arc, const palmer::Interval &range);

protected:
    void drawPicture(QPainter &painter) override;
    void paintOver(QPainter &painter) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    enum class Handle { none, from, to };

    /// The whole arcs and their extent.
    struct Curves {
        std::vector<PathProfile> profiles;
        Interval angles;
        Interval deviations; ///< µm
    };

    [[nodiscard]] static Curves curvesOf(const Test &test, const TestEvaluation &evaluation);
    void receive(Curves curves);
    void fitAxes();
    void drawAxes(QPainter &painter) const;
    void drawCurves(QPainter &painter) const;
    void paintRange(QPainter &painter) const;
    void paintHovered(QPainter &painter) const;
    [[nodiscard]] QRectF plot() const;
    [[nodiscard]] double valueScale() const;
    [[nodiscard]] double yOf(double deviation) const; ///< µm
    [[nodiscard]] double angleAt(double x) const;
    [[nodiscard]] std::optional<Interval> range() const;
    [[nodiscard]] Handle handleAt(QPointF at) const;
    [[nodiscard]] std::optional<ReadingPlace> nearest(QPointF at) const;

    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    TestEvaluationPointer m_curvesOf;
    Language m_language{Language::Id::english};
    const CircularMeasurement *m_measurement = nullptr; ///< owned by m_evaluated
    Curves m_curves;
    std::size_t m_arc = 0;
    FigureAxis m_angles;
    FigureAxis m_deviations;
    double m_plotTop = 0; ///< y below the title, with the font of the last drawing
    Handle m_dragged = Handle::none;
    std::optional<Interval> m_preview; ///< the range during a drag
    Background m_making;
};

} // namespace palmer::ui
