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

/// For every command whose output has a fixed ending.
constexpr Option forceOption{
    "force", "", REPORT_TEXT("report", "write even to a name with the ending of another kind of file")};

[[nodiscard]] bool isStandardOutput(const QString &file);

/// Throws UsageError: the command needs a file to write ("-o OUT.palmer").
[[noreturn]] void refuseWithoutOutput(const char *command, const std::string &form);
/// Value of -o. Throws UsageError without it.
[[nodiscard]] QString neededOutput(const Invocation &invocation, const char *command,
                                   const std::string &form);
/// Throws UsageError if the output is an input of the same call, under any name, or has the ending of another
/// kind of file than `endings` (lower case; "" and unknown endings are allowed), unless --force is given.
/// Must be called before anything is read.
void requireOutput(const Invocation &invocation, const QString &file,
                   std::initializer_list<const char *> endings);

/// For commands that write a file for each input into a folder.
constexpr Option nameOption{
    "name", "PATTERN",
    REPORT_TEXT("report",
                "with several files: what each is called in the folder, from {machine}, {serialNumber}, "
                "{number} of the report, {axis}, {date} and {file}; of equal names the later get -2, -3")};

/// Output files of several inputs: in the folder `output`, with the input's path, or named by --name, and
/// another ending. Throws UsageError if two outputs are the same file or one would overwrite an input.
[[nodiscard]] QStringList outputsInFolder(const Invocation &invocation, const QString &output,
                                          const Inputs &inputs, const QString &ending);
/// The output of a single input. Throws UsageError for --name.
void requireNoName(const Invocation &invocation);

/// "report.pdf" → "report.fr.pdf". Folders and devices keep their name: writing reports their error.
[[nodiscard]] QString withLanguage(const QString &file, const QString &language);

/// Creates the folder of an output file. Throws Error(unwritable).
void makeFolderOf(const QString &file);

/// Writes the file with that name; "-" is standard output. Throws Error(unwritable).
void writeOutput(const QByteArray &bytes, const QString &file);

/// The same for several files: writes all or none. Throws UnsavedFile.
void writeOutputs(const std::vector<FileToSave> &outputs);
/// The same; an error is printed with the name of its file. Returns the exit code.
[[nodiscard]] int written(const Invocation &invocation, const std::vector<FileToSave> &outputs);

} // namespace palmer
