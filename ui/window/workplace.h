// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/documentmodel.h"
#include "ui/model/page.h"
#include "ui/model/selection.h"
#include "ui/navigation/navigationmodel.h"
#include "ui/qtforward.h"
#include "ui/translated.h"
#include "ui/window/search.h"

#include <QPointer>
#include <QStringList>
#include <QWidget>
#include <map>

namespace palmer::ui {

class AgreedPointsPage;
class CirclesPage;
class ComparisonPage;
class ComparisonSide;
class ConditionsPage;
class DiagnosisPage;
class DocumentModel;
class DriftPage;
class Evaluator;
class ExplanationCard;
class FigureView;
class FindingsPanel;
class Form;
class KeyHints;
class LimitsPage;
class NavigationList;
class PageTabs;
class ReadingsPage;
class ReportPages;
class ResultsPanel;
class RightSide;
class TargetCard;
class TestHead;
class ThermalPage;
class UncertaintyPage;

/// Returns true for pages of the report and for those that a test of the kind has.
[[nodiscard]] bool hasPage(Kind kind, Page page);

/// A window with an open document: navigation, the pages of a test with the detail card below, and on the
/// right figure, results and findings. Arranges them for the available size. Over 500 lines: each page and
/// panel is made and placed here, one short function each.
class Workplace : public Translated<QWidget> {
    Q_OBJECT

public:
    Workplace(DocumentModel &model, Evaluator &evaluator, QWidget *parent = nullptr);

    [[nodiscard]] Selection &selection() { return m_selection; }
    [[nodiscard]] ReadingsPage &readings() { return *m_readings; }
    /// Texts typed anywhere that cannot be accepted: shown in red and not part of the document.
    [[nodiscard]] QStringList refusedTexts() const;
    /// Undoes refused typing in the focused field or table. False if there is none.
    bool undoTyping();
    [[nodiscard]] CirclesPage &circles() { return *m_circles; }

    /// Shows the document, keeping the selection if it still exists. For a pending test the pages show the
    /// edited data; figure and results stay the former ones, marked as being computed.
    void show(const EvaluatedDocument &evaluated);

    /// Brings a page of the report or of the current test into view.
    void showPage(Page page);
    void showTest(std::size_t test);
    /// Sets the focus to the first field of the page in view.
    void focusPage();
    /// Focuses the next or previous pane, cyclically: navigation, tabs, page, figure, results, findings.
    void focusNextPane(bool forward);
    /// Brings the change of a step into view and focuses it; `edit`: name of the step.
    void showChange(const Document &before, const Document &after, const QString &edit);

    /// Actions of the button "+ Test" and of a test's context menu in the navigation.
    /// `report`: shows the test in the report, for the menus of figure, results and findings too.
    void setTestActions(const QList<QAction *> &add, const QList<QAction *> &change, QAction *report);
    /// The part of the report that shows what has the focus: the findings or the test.
    [[nodiscard]] QString anchorInReport() const;
    /// Brings the list of the findings into view and focuses it.
    void showFindings();

    /// Focuses the first missing reading.
    void beginTyping();

    void setFigureMaximised(bool maximised);
    [[nodiscard]] bool isFigureMaximised() const { return m_maximised; }

    /// Moves through the missing statements of the current test. False if none is missing.
    bool showNextMissing(bool forward);

    /// Everything that can be found: fields of all pages, results, findings of the test in view.
    [[nodiscard]] std::vector<SearchEntry> searchEntries();

signals:
    void viewChosen(std::size_t test, const QString &edition);
    void editionSet(std::size_t test, const QString &edition);
    /// Status bar texts on the current test and on what the pointer is at.
    void contentChanged(const QString &text);
    void hintChanged(const QString &text);
    /// The things that the test lacks, as counted by badges and findings; empty: nothing.
    void lackChanged(const QString &text);
    void likeLastWanted();

protected:
    void resizeEvent(QResizeEvent *event) override;
    [[nodiscard]] QSize minimumSizeHint() const override;

private:
    [[nodiscard]] std::map<Page, QStringList> missingFields() const;
    bool showNextMissingHere(const std::map<Page, QStringList> &missing, bool forward);
    QWidget *makeCentre();
    void makePages(QWidget *centre);
    void showChangedMeasurement(const Test &before, const Test &after);
    void showChanged(const PositioningMeasurement &was, const PositioningMeasurement &is);
    void showChanged(const CircularMeasurement &was, const CircularMeasurement &is);
    void showChanged(const DriftMeasurement & /*was*/, const DriftMeasurement & /*is*/) {}
    void connectParts();
    void present();
    void presentTest();
    void presentResults();
    void detachFigure();
    void presentPage();
    void presentCard();
    void presentTurn();
    void presentStatus();
    void presentStatusOf(const PositioningMeasurement &measurement);
    void presentStatusOf(const CircularMeasurement &measurement);
    void presentStatusOf(const DriftMeasurement &measurement);
    void arrange();
    void restoreSizes();
    void restoreNavigation();
    void keepSizes() const;
    void retranslate() final;
    [[nodiscard]] bool wantsStack() const;
    [[nodiscard]] Kind kind() const; ///< of the test in view
    [[nodiscard]] bool hasPage(Page page) const { return palmer::ui::hasPage(kind(), page); }
    [[nodiscard]] QString sizesKey() const;
    [[nodiscard]] QString navigationKey() const;
    [[nodiscard]] bool isReportPage() const;
    [[nodiscard]] Form *formInView() const; ///< null if the page is not a form

    DocumentModel &m_model;
    Evaluator &m_evaluator;
    Selection m_selection;
    NavigationModel m_navigationModel;
    EvaluatedDocument m_evaluated;

    QSplitter *m_outer = nullptr;
    QWidget *m_side = nullptr; ///< navigation with the button below
    QSplitter *m_inner = nullptr;
    NavigationList *m_navigation = nullptr;
    QToolButton *m_addTest = nullptr;
    TestHead *m_head = nullptr;
    PageTabs *m_tabs = nullptr;
    QStackedWidget *m_pages = nullptr;
    QStackedWidget *m_readingPages = nullptr; ///< one per kind of test
    ReadingsPage *m_readings = nullptr;
    QScrollArea *m_circlesPlace = nullptr;
    CirclesPage *m_circles = nullptr;
    ConditionsPage *m_conditions = nullptr;
    AgreedPointsPage *m_agreedPoints = nullptr;
    LimitsPage *m_limits = nullptr;
    UncertaintyPage *m_uncertainty = nullptr;
    ComparisonPage *m_comparison = nullptr;
    ComparisonSide *m_comparisonSide = nullptr;
    DiagnosisPage *m_diagnosis = nullptr;
    DriftPage *m_drift = nullptr;
    ThermalPage *m_thermal = nullptr;
    ReportPages *m_reportPages = nullptr;
    QWidget *m_card = nullptr;
    TargetCard *m_target = nullptr;
    KeyHints *m_keys = nullptr;
    ExplanationCard *m_explanation = nullptr;
    QWidget *m_centre = nullptr;
    RightSide *m_right = nullptr;
    FigureView *m_figure = nullptr;
    QPointer<FigureView> m_detachedFigure; ///< in its own window, while open
    ResultsPanel *m_results = nullptr;
    FindingsPanel *m_findings = nullptr;
    std::string m_resultsOf; ///< ID of the test whose results are shown
    QString m_sizesOf;       ///< kind of test whose sizes are shown
    bool m_maximised = false;
};

} // namespace palmer::ui
