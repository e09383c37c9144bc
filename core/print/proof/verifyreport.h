// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "proof/readreportpdf.h"
#include "proof/verification.h"

#include <QByteArray>
#include <functional>
#include <optional>
#include <stop_token>

namespace palmer {

/// A report that was read back: the PDF, what is in it, and its test file evaluated.
struct OpenedReport {
    QByteArray pdf;
    ReportPdf parts;
    EvaluatedDocument evaluated;
};

/// Reads a report and evaluates its test file as it was evaluated for the report: with the simulations that
/// it states. May run on any thread. Throws what readReportPdf and readDocument throw; null when stopped.
[[nodiscard]] std::optional<OpenedReport>
openReport(const QByteArray &pdf, int threads = 0, const std::stop_token &stop = {},
           const std::function<void(const SimulationProgress &)> &progress = {});

/// Composes the report again from its test file, in its language, and compares: the bytes of the PDF, the
/// words of each page, how each page looks, the results; names the signatures. Says nothing of where the data
/// come from. On the thread of the window; throws Error for pages that cannot be read.
[[nodiscard]] Verification verifyReport(const OpenedReport &report);

} // namespace palmer
