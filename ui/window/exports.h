// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"

#include <QByteArray>
#include <QString>

class QWidget;

namespace palmer::ui {

/// What is written of a test for other programs.
enum class ExportForm { csvWithPoint, csvWithComma, json };

/// Readings and results of a test as CSV, or of all tests as JSON; names in the language of the window.
[[nodiscard]] QByteArray exportedReadings(const EvaluatedDocument &evaluated, std::size_t test,
                                          ExportForm form, const QString &fileName);
/// The points of the figure of a test.
[[nodiscard]] QByteArray exportedFigure(const EvaluatedDocument &evaluated, std::size_t test,
                                        ExportForm form);

// Ask where to, write, and say in one sentence why that fails. The form is a choice of the file dialog.
void askExportOfReadings(QWidget *window, const EvaluatedDocument &evaluated, std::size_t test,
                         const QString &fileName);
void askExportOfFigure(QWidget *window, const EvaluatedDocument &evaluated, std::size_t test);

} // namespace palmer::ui
