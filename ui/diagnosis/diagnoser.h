// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/diagnosedtest.h"
#include "figures/diagnosisfigure.h"
#include "language/language.h"
#include "ui/figures/circlecanvas.h"
#include "ui/model/background.h"

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

namespace palmer::ui {

/// The content of the page "Diagnosis" for a circular test, in one language.
struct ShownDiagnosis {
    TestEvaluationPointer of;
    std::optional<DiagnosedTest> test; ///< null if the circle allows no diagnosis
    std::vector<std::size_t> prevailing;
    LineFigure residual; ///< of all points
    LineFigure spectrum;
    /// Tests of the plane at several feeds, including the one shown; empty if there are none.
    std::vector<DiagnosedTest> atFeeds;
    Diagnosis together; ///< of atFeeds
    std::vector<PathProfile> paths;
};

/// Diagnoses the circle in view in the background and makes the path of the ticked sources.
class Diagnoser : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Starts a diagnosis unless it is ready or running; `changed` reports the result.
    void want(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    /// Makes the path of these sources; `traced` reports the result, at once and empty if there are none.
    void trace(const std::vector<std::size_t> &chosen);

    /// Result of the last request; null while it is computed.
    [[nodiscard]] const ShownDiagnosis *shown() const { return m_shown.get(); }
    [[nodiscard]] bool isBusy() const { return m_lane.isBusy() || m_traces.isBusy(); }

signals:
    void changed();
    void traced(const palmer::ui::SyntheticPaths &paths);

private:
    std::vector<TestEvaluationPointer> m_of; ///< evaluations used for the diagnosis
    QString m_language;
    std::shared_ptr<const ShownDiagnosis> m_shown;
    Background m_lane;
    Background m_traces;
};

} // namespace palmer::ui
