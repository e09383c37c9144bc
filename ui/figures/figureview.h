// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/figure.h"
#include "language/language.h"
#include "ui/figures/figurecanvas.h"
#include "ui/model/background.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QTemporaryDir>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

namespace palmer::ui {

class CircleFigureView;
class ElidedLabel;
struct SyntheticPaths;
class ZoomButtons;

/// The figure of the test in view: reads values under the pointer, zooms, pans, copies and saves. Follows
/// the theme on screen; copies and files are white. Over 500 lines: every kind of figure has the same
/// commands.
class FigureView : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    explicit FigureView(Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

    /// The figure of a positioning test as shown, with the zoomed ranges; null for other tests.
    [[nodiscard]] std::optional<CurveFigure> figure() const;
    /// Deviation of a point in a circle figure, relative to its centre; empty if not shown.
    [[nodiscard]] QString deviationText(const ReadingPlace &point) const;
    /// Draws these over the paths of their circular test.
    void setSynthetic(const SyntheticPaths &paths);
    void fit();
    /// Zooms in about the middle by so many wheel steps, or out if negative.
    void zoomBy(int steps);
    /// Makes it a separate window, deleted when closed.
    void standAlone();
    /// Copies the figure to the clipboard, as vectors (SVG, PDF) and as a bitmap.
    void copy();
    /// The figure for another program as SVG, PDF and PNG, and for a folder as a file that stays while the
    /// window is open; null without a figure.
    [[nodiscard]] QMimeData *dragged();
    /// Writes the figure in the format of the suffix (pdf, svg, png). False on failure.
    bool saveTo(const QString &path);

signals:
    /// The user wants the figure in a separate window, or maximised.
    void detachWanted();
    void maximiseWanted();
    /// Status bar message about an action without visible effect.
    void said(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;
    /// Title and copy button are where the figure is dragged out, as the canvas pans.
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Leaving {
        Figure figure;
        QString title;
    };

    /// A figure of curves, made independently of the window.
    struct Content {
        std::shared_ptr<const CurveFigure> whole; ///< at full range
        FigureReadings readings;
        CurveFigure shown;
        QString sentence; ///< the figure described in words
    };

    static Content contentOf(const Test &test, const TestEvaluation &evaluation, const Language &language,
                             bool marks, const std::optional<std::array<Interval, 2>> &zoomed);
    void refresh();
    void refreshCurves();
    void refreshCircles();
    void forget();
    void receive(Content content);
    /// Titles and notes by kind of test.
    void showTitle();
    void showTitle(const PositioningMeasurement &measurement, const PositioningResults &results);
    void showTitle(const DriftMeasurement &drift, const DriftResults &results);
    void showTitle(const CircularMeasurement &measurement, const CircularResults &results);
    [[nodiscard]] const Test *shownTest() const; ///< may be null
    [[nodiscard]] bool showsCircles() const;
    void describe();
    [[nodiscard]] std::optional<std::array<Interval, 2>> zoomedRanges() const;
    /// The current figure on paper, to be copied or saved.
    [[nodiscard]] std::optional<Leaving> leaving() const;
    [[nodiscard]] QMimeData *formatsOf(const Leaving &shown) const;
    void showRanges(const Interval &x, const Interval &y);
    void mark();
    void showHoverLabel();
    void askWhereToSave();
    void retranslate() final;

    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    std::shared_ptr<const CurveFigure> m_whole; ///< at full range; may be null
    std::optional<CurveFigure> m_shown;
    FigureReadings m_readings;
    QString m_sentence;
    bool m_readingMarks = true;
    QLabel *m_title;
    ElidedLabel *m_note;
    FigureCanvas *m_canvas;
    CircleFigureView *m_circles;
    QToolButton *m_marks;
    ZoomButtons *m_zoom;
    QToolButton *m_copy;
    QToolButton *m_save;
    QToolButton *m_detach;
    QToolButton *m_maximise;
    QPoint m_pressed;                            ///< where a drag may begin
    std::unique_ptr<QTemporaryDir> m_dragFolder; ///< of the file that was dragged out
    Background m_making;                         ///< makes the figure of a large test
    Background m_zooming;                        ///< makes the part of it in the zoomed ranges
};

} // namespace palmer::ui
