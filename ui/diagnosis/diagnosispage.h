// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"
#include "report/tables/diagnosisrows.h"
#include "ui/diagnosis/diagnoser.h"
#include "ui/qtforward.h"

#include <QWidget>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace palmer::ui {

class FeedsView;
class LineChart;
class RowTable;

/// The page "Diagnosis" of a circular test: an interpretation of the circle as machine errors. Sources by
/// their part of G(b), with what to check; ticked ones are drawn over the measured path; the residual as a
/// curve and a spectrum. If tests of the plane have several feeds, a second view shows their joint
/// diagnosis. Diagnoses only while in view. Over 500 lines: list, figure, residual and feeds follow one
/// choice of sources.
class DiagnosisPage : public QWidget {
    Q_OBJECT

public:
    explicit DiagnosisPage(QWidget *parent = nullptr);

    /// Shows a circular test; empty for any other.
    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

    /// Names of the drawn sources.
    [[nodiscard]] QStringList tracedNames() const;
    [[nodiscard]] bool isBusy() const { return m_diagnoser.isBusy(); }

signals:
    /// Paths to draw over the measured one; none while the page is out of view.
    void pathsWanted(const palmer::ui::SyntheticPaths &paths);
    /// The commanded angles of the test in view are too large by that, degrees.
    void startAngleCorrected(double by);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QToolButton *addSegment(const char *segment, const char *name);
    QWidget *makeBar();
    QWidget *makeBelow();
    void want();
    void refresh();
    void fillTable();
    void fillBelow();
    [[nodiscard]] QStringList statedTexts() const;
    void fillChart();
    void tick(std::size_t row, bool on);
    void trace();
    void showRow(int at);
    void retranslate();
    [[nodiscard]] bool isTicked(const DiagnosisRow &row) const;
    [[nodiscard]] bool canBeTraced(const DiagnosisRow &row) const;
    [[nodiscard]] bool isOfFeeds() const;
    [[nodiscard]] const Diagnosis *diagnosis() const; ///< of the current view
    [[nodiscard]] QString idOf(std::size_t place) const;
    [[nodiscard]] std::optional<std::size_t> currentRow() const;

    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    std::string m_testId;
    Language m_language{Language::Id::english};
    Diagnoser m_diagnoser;
    std::vector<DiagnosisRow> m_rows;
    std::optional<std::set<QString>>
        m_ticked;      ///< source IDs; null: the prevailing ones, as the user has not chosen
    QString m_current; ///< ID of the source in view

    QLabel *m_nature = nullptr; ///< says that all of it is an interpretation
    QLabel *m_summary = nullptr;
    QToolButton *m_circle = nullptr;
    QToolButton *m_feeds = nullptr;
    QToolButton *m_trace = nullptr;
    QLabel *m_empty = nullptr;
    QScrollArea *m_area = nullptr;
    QWidget *m_content = nullptr;
    RowTable *m_table = nullptr;
    QLabel *m_warnings = nullptr; ///< what has to be known before any source
    QPushButton *m_correct = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_text = nullptr;
    QToolButton *m_rest = nullptr;
    QToolButton *m_spectrum = nullptr;
    QLabel *m_chartNote = nullptr;
    QWidget *m_chartBar = nullptr;
    FeedsView *m_overlay = nullptr;
    LineChart *m_chart = nullptr;
    QLabel *m_remarks = nullptr;
};

} // namespace palmer::ui
