// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/figure.h"
#include "language/language.h"
#include "ui/figures/figurecanvas.h"
#include "ui/model/background.h"
#include "ui/model/selection.h"

#include <QWidget>
#include <array>
#include <memory>
#include <optional>

class QLabel;
class QToolButton;

namespace palmer::ui {

class CircleFigureView;
class ElidedLabel;
struct SyntheticPaths;
class ZoomButtons;

/// The figure of the test in view: reads values under the pointer, zooms, pans, copies and saves. Follows the
/// theme; what leaves it is white.
class FigureView : public QWidget {
    Q_OBJECT

public:
    explicit FigureView(Selection &selection, QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

    /// The figure of a positioning test as it is shown, with the ranges zoomed to; nothing for other tests.
    [[nodiscard]] std::optional<CurveFigure> figure() const;
    /// What a figure of circles says of a point, about its own centre; empty where it does not show it.
    [[nodiscard]] QString deviationText(const ReadingPlace &point) const;
    /// Draws these over the paths of the circular test they belong to.
    void setSynthetic(const SyntheticPaths &paths);
    void fit();
    /// In by so many steps of the wheel about the middle, out where negative.
    void zoomBy(int steps);
    /// Makes it a window of its own, which goes away when it is closed.
    void standAlone();
    /// Puts the figure on the clipboard, as vectors (SVG, PDF) and as a picture.
    void copy();
    /// Writes the figure; the kind follows the suffix (pdf, svg, png). False: it could not be written.
    bool saveTo(const QString &path);

signals:
    /// The user wants it in a window of its own, or as large as the window.
    void detachWanted();
    void maximiseWanted();
    /// What was done and cannot be seen, for the status bar.
    void said(const QString &text);

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Leaving {
        Figure figure;
        QString title;
    };

    /// A figure of curves, made without the window.
    struct Content {
        std::shared_ptr<const CurveFigure> whole; ///< with the ranges that show everything
        FigureReadings readings;
        CurveFigure shown;
        QString sentence; ///< what it shows, in words
    };

    static Content contentOf(const Test &test, const TestEvaluation &evaluation, const Language &language,
                             bool marks, const std::optional<std::array<Interval, 2>> &zoomed);
    void refresh();
    void refreshCurves();
    void refreshCircles();
    void forget();
    void take(Content content);
    /// Title and note: each kind has its own.
    void showTitle();
    void showTitle(const PositioningMeasurement &measurement, const PositioningResults &results);
    void showTitle(const DriftMeasurement &drift, const DriftResults &results);
    void showTitle(const CircularMeasurement &measurement, const CircularResults &results);
    [[nodiscard]] const Test *shownTest() const; ///< null: none
    [[nodiscard]] bool showsCircles() const;
    void describe();
    [[nodiscard]] std::optional<std::array<Interval, 2>> zoomedRanges() const;
    /// What is copied and saved: the figure in view, for paper.
    [[nodiscard]] std::optional<Leaving> leaving() const;
    void showRanges(const Interval &x, const Interval &y);
    void mark();
    void showHoverLabel();
    void askWhereToSave();
    void retranslate();

    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    std::shared_ptr<const CurveFigure> m_whole; ///< with the ranges that show everything; null: none
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
    Background m_making;  ///< of the figure of a large test
    Background m_zooming; ///< of what of it belongs to the ranges in view
};

} // namespace palmer::ui
