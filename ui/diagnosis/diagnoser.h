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

/// What the page "Diagnosis" shows of a circular test, in one language.
struct ShownDiagnosis {
    TestEvaluationPointer of;
    std::optional<DiagnosedTest> test; ///< null: the circle gives no diagnosis
    std::vector<std::size_t> prevailing;
    LineFigure residual; ///< all points
    LineFigure spectrum;
    /// Tests of the plane at several feeds, the one shown among them; empty: there are none.
    std::vector<DiagnosedTest> atFeeds;
    Diagnosis together; ///< of those
    std::vector<PathProfile> paths;
};

/// Diagnoses the circle in view beside the window, and makes the path of the sources that are ticked.
class Diagnoser : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Begins a diagnosis unless it is there or under way; `changed` tells when it is there.
    void want(const EvaluatedDocument &evaluated, std::size_t test, const Language &language);
    /// Makes the path of these sources; `traced` tells when it is there. None: an empty one at once.
    void trace(const std::vector<std::size_t> &chosen);

    /// Of what was wanted last; null while it is computed.
    [[nodiscard]] const ShownDiagnosis *shown() const { return m_shown.get(); }
    [[nodiscard]] bool isBusy() const { return m_lane.isBusy() || m_traces.isBusy(); }

signals:
    void changed();
    void traced(const palmer::ui::SyntheticPaths &paths);

private:
    std::vector<TestEvaluationPointer> m_of; ///< evaluations that the diagnosis is made from
    QString m_language;
    std::shared_ptr<const ShownDiagnosis> m_shown;
    Background m_lane;
    Background m_traces;
};

} // namespace palmer::ui
