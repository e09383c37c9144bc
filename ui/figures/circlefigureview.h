// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/circlefigure.h"
#include "language/language.h"
#include "report/explanations/explanation.h"
#include "ui/figures/circlecanvas.h"
#include "ui/model/selection.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

namespace palmer::ui {

/// The figures of a circular test: the choice of figure (combined, one of the standard's, or G(b) and both G
/// side by side), what it shows, and its canvases.
class CircleFigureView : public Translated<QWidget, QEvent::FontChange> {
    Q_OBJECT

public:
    explicit CircleFigureView(Selection &selection, QWidget *parent = nullptr);

    /// Precondition: `test` is circular.
    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    void setContacts(bool shown);
    void setSynthetic(const SyntheticPaths &paths);
    void setMarking(const QString &label, const std::vector<RulingPoint> &points);
    void clear();
    void fit();
    /// Zooms all canvases together, so that they stay comparable.
    void zoomBy(int steps);

    /// Sets the accessible description of the current figure.
    void describe(const QString &content);
    /// The figure to copy and save, of several the one used last; null without a test.
    [[nodiscard]] std::optional<CircleFigure> paperFigure() const;
    /// Deviation of a point in the figure used last.
    [[nodiscard]] QString deviationText(const ReadingPlace &point) const;
    [[nodiscard]] CircleCanvas *canvas() const { return m_canvases.front(); }

signals:
    /// Another figure is shown, or other paths in it.
    void figureChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void fitNames();
    void fillChoice();
    [[nodiscard]] std::vector<CircleFigureOptions> chosen() const;
    void retranslate() final;

    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    bool m_contacts = true;
    SyntheticPaths m_synthetic;
    std::vector<CircleFigureOptions> m_separate; ///< figures of the standard available for the test
    QComboBox *m_choice;
    QToolButton *m_counterclockwise;
    QToolButton *m_clockwise;
    QToolButton *m_repetitions;
    std::array<CircleCanvas *, 3> m_canvases{};
    CircleCanvas *m_current = nullptr;
};

} // namespace palmer::ui
