// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/form.h"
#include "ui/model/simulator.h"
#include "ui/qtforward.h"

#include <QByteArray>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace palmer::ui {

class FigureCard;
class RowTable;
class SimulationRow;

/// The uncertainty of a test: the method that decides, its inputs, the contributions of the budget in
/// descending order, the U of each result by budget and simulation side by side with the distribution of
/// the trials, and the decision rule. The simulation is only started here, never by an edit. Over 500
/// lines: inputs, budget, results and simulation of one method follow the same edit.
class UncertaintyPage : public Form {
    Q_OBJECT

public:
    UncertaintyPage(DocumentModel &model, Evaluator &evaluator, Selection &selection,
                    QWidget *parent = nullptr);

    bool focusField(const QString &id) override;
    bool focusNextRequired(bool forward) override;

protected:
    void prepare() override;
    void refreshOthers() override;
    [[nodiscard]] QString missingText(int count) const override;

private:
    void forgetParts();
    void makeTypical();
    void addMethods();
    void addInputs(const PositioningUncertaintyInputs &inputs);
    void addInputs(const CircularUncertaintyInputs &inputs);
    void addEnvironment(Quantity size, Member<Amount> member);
    void addTrials(Member<std::optional<long long>> trials, Member<long long> seed);
    void addStatedUncertainties(const Edition &edition, bool rotary);
    void addContributions();
    void addResults(bool linear);
    void addDecision();
    void chooseMethod(UncertaintyMethod method);
    void fillTypical();
    void focusContribution(const QString &id);
    [[nodiscard]] bool awaitsSimulation() const;
    void focusSimulation();

    void showMethods(const TestEvaluation &evaluation);
    void showPlaceholders(const TestEvaluation &evaluation);
    void showContributions(const TestEvaluation &evaluation);
    void showResults(const TestEvaluation &evaluation);
    void nameResultColumns(UncertaintyMethod method);
    void showResult(int row, const Parameter &parameter, const TestEvaluation &evaluation);
    void showSimulated(int row, const Parameter &parameter);
    void showOutdated(int row);
    void showDifference(int row, const Parameter &parameter);
    void showDistribution();
    [[nodiscard]] QString shortName(const Contribution &contribution) const;
    [[nodiscard]] QString driftPlaceholder() const;
    [[nodiscard]] Quantity deviation() const;

    Simulator m_simulator;
    QStringList m_built;                  ///< kind of test, edition and method the fields were built for
    QString m_chosen;                     ///< parameter whose distribution is shown
    std::vector<std::string> m_drifts;    ///< IDs of the drift tests offered
    std::vector<QByteArray> m_driftNames; ///< their names, UTF-8
    // Parts rebuilt with the fields; null if the method does not use them.
    std::map<std::string, Field *> m_fields; ///< field of its size by contribution
    std::array<QToolButton *, 5> m_methods{};
    QLabel *m_methodNote = nullptr;
    QToolButton *m_typical = nullptr;
    Field *m_perMetre = nullptr;
    Field *m_length = nullptr;
    Field *m_environment = nullptr;
    Field *m_duration = nullptr;
    Field *m_repeatability = nullptr;
    Field *m_trials = nullptr;
    QPushButton *m_advice = nullptr;
    RowTable *m_contributions = nullptr;
    RowTable *m_results = nullptr;
    SimulationRow *m_simulation = nullptr;
    QLabel *m_decides = nullptr;
    QLabel *m_distributionTitle = nullptr;
    FigureCard *m_distribution = nullptr;
    QLabel *m_rule = nullptr;
};

} // namespace palmer::ui
