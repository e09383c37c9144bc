// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "commandline/inputs.h"
#include "document/savefiles.h"

#include <QByteArray>
#include <QString>
#include <initializer_list>
#include <vector>

namespace palmer {

/// Of every command whose output has no ending of its own choice.
constexpr Option forceOption{
    "force", "", REPORT_TEXT("report", "write even to a name with the ending of another kind of file")};

/// Throws UsageError for an output that is an input of the same call, whatever its name, or that has the
/// ending of another kind of file than `endings` (lower case, those of the command; "" and unknown ones are
/// free), unless --force is given. To be asked before anything is read.
void demandOutput(const Invocation &invocation, const QString &file,
                  std::initializer_list<const char *> endings);

/// Where the output of each of several inputs goes: into the folder `output`, under the path it was found
/// under, with another ending. Throws UsageError where two would go into one file, or one over an input.
[[nodiscard]] QStringList outputsInFolder(const QString &output, const Inputs &inputs, const QString &ending);

/// "report.pdf" → "report.fr.pdf". A folder or a device keeps its name: writing says what is wrong with it.
[[nodiscard]] QString withLanguage(const QString &file, const QString &language);

/// Makes the folder of a file that is to be written there. Throws Error(unwritable).
void makeFolderOf(const QString &file);

/// Writes to the file of that name, "-" is standard output. Throws Error(unwritable).
void writeOutput(const QByteArray &bytes, const QString &file);

/// The same of several files: none is written unless all can be. Throws UnsavedFile.
void writeOutputs(const std::vector<FileToSave> &outputs);

} // namespace palmer
