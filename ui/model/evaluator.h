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

/// Keeps a document evaluated. Small changes (at most 10⁴ readings to compute anew) are evaluated at once, in
/// the call; larger ones on a thread of its own, and of several only the latest is told. Results always come
/// together with the document they were computed from; until they come the document is told without them.
class Evaluator : public QObject {
    Q_OBJECT

public:
    explicit Evaluator(QObject *parent = nullptr);

    /// Evaluates another document, or the next state of the same; views of tests that are gone are forgotten.
    void setDocument(std::shared_ptr<const Document> document);

    /// Shows a test under another edition of its kind: results and no verdicts, the file stays as it is. The
    /// test's own edition, or an empty word, ends the view.
    void setView(std::size_t test, const std::string &edition);

    /// Puts a simulation beside the results of a test; it is marked as outdated when the test was edited
    /// since the simulation began. A test that is gone is forgotten.
    void setSimulation(std::size_t test, const TestSimulation &simulation);

    /// The latest results; of no document at first.
    [[nodiscard]] const EvaluatedDocument &current() const { return m_current; }
    /// The latest document: with its results, or pending while they are computed.
    [[nodiscard]] const EvaluatedDocument &latest() const { return isBusy() ? m_awaiting : m_current; }
    /// Newer results are being computed.
    [[nodiscard]] bool isBusy() const { return m_worker.isBusy(); }

signals:
    void evaluated(const palmer::EvaluatedDocument &evaluated);
    /// Another document, the results of which are being computed.
    void awaiting(const palmer::EvaluatedDocument &awaiting);
    void busyChanged(bool busy);

private:
    struct EndedSimulation {
        std::size_t test = 0;
        TestSimulation simulation;
    };

    void evaluate();
    void putSimulations();
    void take(EvaluatedDocument evaluated);
    [[nodiscard]] std::vector<std::string> editions() const;

    std::shared_ptr<const Document> m_document;
    EvaluatedDocument m_current;
    EvaluatedDocument m_awaiting;
    std::map<std::string, std::string> m_views; ///< edition by id of the test
    std::deque<EndedSimulation> m_simulations;  ///< not yet beside the results
    Background m_worker;
};

} // namespace palmer::ui
