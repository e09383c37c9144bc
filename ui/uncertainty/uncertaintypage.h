#pragma once

#include "ui/forms/form.h"
#include "ui/model/simulator.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace palmer::ui {

/// How the uncertainty of a test is found: the method, its inputs, the contributions of the budget with the
/// largest first, and the U of each result by budget and simulation side by side. The simulation is started
/// here, never by an edit.
class UncertaintyPage : public Form {
    Q_OBJECT

public:
    UncertaintyPage(DocumentModel &model, Evaluator &evaluator, Selection &selection,
                    QWidget *parent = nullptr);

protected:
    void prepare() override;
    void refreshOthers() override;
    [[nodiscard]] QString missingText(int count) const override;

private:
    void addPositioningInputs(bool rotary);
    void addCircularInputs();
    void addStatedUncertainties(const Edition &edition, bool rotary);
    void addOutcome();
    void showContributions(const TestEvaluation &evaluation);
    void showResults(const TestEvaluation &evaluation);
    void showSimulation();
    void takeTypicalRange();
    [[nodiscard]] Quantity deviation() const;

    Simulator m_simulator;
    QStringList m_built; ///< for which kind of test, edition and method there are fields
    // Parts that are made anew with the fields; null without a budget.
    Field *m_perMetre = nullptr;
    QPushButton *m_typical = nullptr;
    QLabel *m_advice = nullptr;
    QTableWidget *m_contributions = nullptr;
    QTableWidget *m_results = nullptr;
    QLabel *m_simulationText = nullptr;
    QProgressBar *m_bar = nullptr;
    QPushButton *m_simulate = nullptr;
    QPushButton *m_cancel = nullptr;
};

} // namespace palmer::ui
