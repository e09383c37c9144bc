// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/imported.h"
#include "kernel/planning/cycleprogram.h"
#include "language/language.h"
#include "report/explanations/explanation.h"

#include <QByteArray>
#include <QString>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palmer {

/// A value offered for a budget with the settings that apply it: path in the test file, value.
struct OfferedValue {
    QString value;
    QString source;
    std::vector<std::pair<std::string, std::string>> settings;
};

/// The explanation of a test, as `explain` prints it.
struct ExplainedTest {
    std::size_t test = 0; ///< index
    std::vector<Explanation> parameters;
    std::vector<OfferedValue> typical;
};

/// An imported file: what was read, and the ids of the questions that are still open.
struct ImportAnswer {
    QString file;
    Imported imported;
    bool accepted = false; ///< assumptions were confirmed
};

// Answers of commands, as JSON with a format and a version (document/jsonformats.h); ends with a line break.
// Lengths in mm, angles in degrees.
[[nodiscard]] QByteArray explanationJson(const EvaluatedDocument &evaluated, const QString &fileName,
                                         const std::vector<ExplainedTest> &tests);
[[nodiscard]] QByteArray importJson(const std::vector<ImportAnswer> &files, const QString &output,
                                    const Language &language);
[[nodiscard]] QByteArray targetsJson(std::span<const PlannedMeasurement> plans, const CycleProgram &program,
                                     const std::string &edition);
[[nodiscard]] QByteArray feedJson(double feed); ///< mm/min
/// One line: a file on which a command failed, with its exit code.
[[nodiscard]] QByteArray errorJson(const QString &file, const QString &error, int exit);

} // namespace palmer
