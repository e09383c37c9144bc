// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/documentmodel.h"
#include "ui/model/page.h"
#include "ui/model/selection.h"
#include "ui/navigation/navigationmodel.h"

#include <QPointer>
#include <QStringList>
#include <QWidget>
#include <map>

class QFrame;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QToolButton;

namespace palmer::ui {

class AgreedPointsPage;
class CirclesPage;
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
class UncertaintyPage;

/// A window with a document open: navigation, the pages of a test with the detail card below, and at the
/// right figure, results and findings. Arranges them for the width and height there is.
class Workplace : public QWidget {
    Q_OBJECT

public:
    Workplace(DocumentModel &model, Evaluator &evaluator, QWidget *parent = nullptr);

    [[nodiscard]] Selection &selection() { return m_selection; }
    [[nodiscard]] ReadingsPage &readings() { return *m_readings; }
    /// What was typed anywhere and cannot be taken: shown in red, in no document.
    [[nodiscard]] QStringList refusedTexts() const;
    /// Takes back what stands refused in the field or table that has the focus; false: nothing does.
    bool undoTyping();
    [[nodiscard]] CirclesPage &circles() { return *m_circles; }

    /// Shows the document, keeping what is chosen where it still exists. Of a test that is pending the pages
    /// show what is edited; figure and results stay those of before, marked as being computed.
    void show(const EvaluatedDocument &evaluated);

    /// Brings a page of the report, or of the current test, into view.
    void showPage(Page page);
    void showTest(std::size_t test);
    /// Puts the keyboard into the page in view, on its first field.
    void focusPage();
    /// Puts the keyboard into the next pane, or the one before: navigation, tabs, page, figure, results,
    /// findings, round and round.
    void focusNextPane(bool forward);
    /// Brings what a step changed into view, with the keyboard on it; `edit`: the name of the step.
    void showChange(const Document &before, const Document &after, const QString &edit);

    /// What the button "+ Test" offers, and the menu of a test in the navigation.
    void setTestActions(const QList<QAction *> &add, const QList<QAction *> &change);

    /// Puts the keyboard on the first reading that is missing.
    void beginTyping();

    void setFigureMaximised(bool maximised);
    [[nodiscard]] bool isFigureMaximised() const { return m_maximised; }

    /// Walks the missing statements of the current test; false where none is missing.
    bool showNextMissing(bool forward);

signals:
    void viewChosen(std::size_t test, const QString &edition);
    void editionSet(std::size_t test, const QString &edition);
    /// What the status bar says of the current test, and of what is pointed at.
    void contentChanged(const QString &text);
    void hintChanged(const QString &text);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
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
    void retranslate();
    [[nodiscard]] bool wantsStack() const;
    [[nodiscard]] Kind kind() const; ///< of the test in view
    [[nodiscard]] bool hasPage(Page page) const;
    [[nodiscard]] QString sizesKey() const;
    [[nodiscard]] QString navigationKey() const;
    [[nodiscard]] bool isReportPage() const;
    [[nodiscard]] Form *formInView() const; ///< null on pages that are none

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
    QStackedWidget *m_readingPages = nullptr; ///< by the kind of test
    ReadingsPage *m_readings = nullptr;
    QScrollArea *m_circlesPlace = nullptr;
    CirclesPage *m_circles = nullptr;
    ConditionsPage *m_conditions = nullptr;
    AgreedPointsPage *m_agreedPoints = nullptr;
    LimitsPage *m_limits = nullptr;
    UncertaintyPage *m_uncertainty = nullptr;
    DiagnosisPage *m_diagnosis = nullptr;
    DriftPage *m_drift = nullptr;
    ReportPages *m_reportPages = nullptr;
    QWidget *m_card = nullptr;
    TargetCard *m_target = nullptr;
    KeyHints *m_keys = nullptr;
    ExplanationCard *m_explanation = nullptr;
    QWidget *m_centre = nullptr;
    RightSide *m_right = nullptr;
    FigureView *m_figure = nullptr;
    QPointer<FigureView> m_detachedFigure; ///< in a window of its own, while it is open
    ResultsPanel *m_results = nullptr;
    FindingsPanel *m_findings = nullptr;
    std::string m_resultsOf; ///< id of the test the results of which are shown
    QString m_sizesOf;       ///< the kind of test whose sizes are shown
    bool m_maximised = false;
};

} // namespace palmer::ui
