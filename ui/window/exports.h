// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

#include <QByteArray>
#include <QString>

class QWidget;

namespace palmer::ui {

/// Export formats for other programs.
enum class ExportForm { csvWithPoint, csvWithComma, json, dcc };

/// Readings and results of a test as CSV, or of all tests as JSON, with names in the window's language, or as
/// a digital calibration certificate. Throws Error where it lacks a statement or a simulation.
[[nodiscard]] QByteArray exportedReadings(const EvaluatedDocument &evaluated, std::size_t test,
                                          ExportForm form, const QString &fileName);
/// The points of a test's figure.
[[nodiscard]] QByteArray exportedFigure(const EvaluatedDocument &evaluated, std::size_t test,
                                        ExportForm form);

// Ask for the file, write it and report a failure in one sentence. The format is chosen in the file dialog.
void askExportOfReadings(QWidget *window, const EvaluatedDocument &evaluated, std::size_t test,
                         const QString &fileName);
void askExportOfFigure(QWidget *window, const EvaluatedDocument &evaluated, std::size_t test);

} // namespace palmer::ui
