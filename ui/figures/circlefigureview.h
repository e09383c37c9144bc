// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "figures/circlefigure.h"
#include "language/language.h"
#include "report/explanations/explanation.h"
#include "ui/figures/circlecanvas.h"
#include "ui/model/selection.h"

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

class QComboBox;
class QHBoxLayout;
class QToolButton;

namespace palmer::ui {

/// The figures of a circular test: which of them is shown (combined, one of those of the standard, or G(b)
/// and both G side by side), what of it, and the surface.
class CircleFigureView : public QWidget {
    Q_OBJECT

public:
    explicit CircleFigureView(Selection &selection, QWidget *parent = nullptr);

    /// `test` is a circular one.
    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);
    void setContacts(bool shown);
    void setSynthetic(const SyntheticPaths &paths);
    void setMarking(const QString &label, const std::vector<RulingPoint> &points);
    void clear();
    void fit();
    /// All surfaces alike: they are compared with one another.
    void zoomBy(int steps);

    /// The figure that is copied and saved: of several that used last. Nothing without a test.
    /// Says for those who cannot see it what the current figure shows.
    void describe(const QString &content);
    [[nodiscard]] std::optional<CircleFigure> paperFigure() const;
    /// Of a point in the figure used last.
    [[nodiscard]] QString deviationText(const ReadingPlace &point) const;
    [[nodiscard]] CircleCanvas *canvas() const { return m_canvases.front(); }

signals:
    /// Another figure is shown, or other paths of it.
    void figureChanged();

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void refresh();
    void fitNames();
    void fillChoice();
    [[nodiscard]] std::vector<CircleFigureOptions> chosen() const;
    void retranslate();

    Selection &m_selection;
    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    bool m_contacts = true;
    SyntheticPaths m_synthetic;
    std::vector<CircleFigureOptions> m_separate; ///< those of the standard that the test has
    QComboBox *m_choice;
    QToolButton *m_counterclockwise;
    QToolButton *m_clockwise;
    QToolButton *m_repetitions;
    std::array<CircleCanvas *, 3> m_canvases{};
    CircleCanvas *m_current = nullptr;
};

} // namespace palmer::ui
