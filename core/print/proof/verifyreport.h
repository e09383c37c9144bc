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

/// A report or history that was read: the PDF, its parts, and its evaluated test file; without one for a
/// history.
struct OpenedReport {
    QByteArray pdf;
    ReportPdf parts;
    EvaluatedDocument evaluated;
};

/// Reads a report and evaluates its test file as for the report, with the stated simulations. Runs on any
/// thread. Throws what readReportPdf() and readDocument() throw; null if stopped.
[[nodiscard]] std::optional<OpenedReport>
openReport(const QByteArray &pdf, int threads = 0, const std::stop_token &stop = {},
           const std::function<void(const SimulationProgress &)> &progress = {});

/// Composes a printed history again from the data in its PDF: composeHistoryFile() of the register.
using HistoryComposer = Report (*)(const QByteArray &data, const Language &language);

/// Composes the report again from its test file, or the history from its data, in its language, and compares:
/// the bytes of the PDF, the words and appearance of each page, the results; lists the signatures. Does not
/// prove the origin of the data. Runs on the GUI thread; throws Error if the pages or the data of a history
/// cannot be read. `history` is needed for histories.
[[nodiscard]] Verification verifyReport(const OpenedReport &report, HistoryComposer history = nullptr);

} // namespace palmer
