// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "ui/model/background.h"

#include <QObject>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace palmer::ui {

/// Keeps a document evaluated. Small changes (at most 10⁴ readings to recompute) are evaluated in the call,
/// larger ones on a background thread, where only the latest result is reported. Results always come with the
/// document they were computed from; until then the document is reported without them.
class Evaluator : public QObject {
    Q_OBJECT

public:
    explicit Evaluator(QObject *parent = nullptr);

    /// Evaluates another document or the next state of the same one; views of deleted tests are dropped.
    void setDocument(std::shared_ptr<const Document> document);

    /// Shows a test under another edition of its kind: results without verdicts, the file unchanged. The
    /// test's own edition, or an empty string, ends the view.
    void setView(std::size_t test, const std::string &edition);

    /// Adds a simulation to a test's results, marked as outdated if the test was edited since. Dropped if the
    /// test was deleted.
    void setSimulation(std::size_t test, const TestSimulation &simulation);

    /// The latest results; empty at first.
    [[nodiscard]] const EvaluatedDocument &current() const { return m_current; }
    /// The latest document: with its results, or pending while they are being computed.
    [[nodiscard]] const EvaluatedDocument &latest() const { return isBusy() ? m_awaiting : m_current; }
    /// True while newer results are being computed.
    [[nodiscard]] bool isBusy() const { return m_worker.isBusy(); }

signals:
    void evaluated(const palmer::EvaluatedDocument &evaluated);
    /// Another document, whose results are being computed.
    void awaiting(const palmer::EvaluatedDocument &awaiting);
    void busyChanged(bool busy);

private:
    struct EndedSimulation {
        std::size_t test = 0;
        TestSimulation simulation;
    };

    void evaluate();
    void putSimulations();
    void receive(EvaluatedDocument evaluated);
    [[nodiscard]] std::vector<std::string> editions() const;

    std::shared_ptr<const Document> m_document;
    EvaluatedDocument m_current;
    EvaluatedDocument m_awaiting;
    std::map<std::string, std::string> m_views; ///< edition by id of the test
    std::deque<EndedSimulation> m_simulations;  ///< not yet added to the results
    Background m_worker;
};

} // namespace palmer::ui
