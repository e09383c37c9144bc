// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "commandline/jobs.h"
#include "document/document.h"

#include <QString>
#include <functional>
#include <vector>

namespace palmer {

/// A file processed by a command.
struct Input {
    QString file;
    QString shown; ///< name for display
    QString below; ///< path within the FOLDER it was found in; only the name if given directly
    bool found = false;
    QStringList beside = {}; ///< its reports, found next to it: x.pdf, x.fr.pdf of x.palmer; no inputs
};

/// The given FILEs, and the test files and PDFs in each FOLDER and below, sorted; without PDFs in the folder
/// of -o and, where test files are wanted, without reports next to their test file.
struct Inputs {
    std::vector<Input> list;
    bool several = false; ///< more than one, or a folder: output names its file
    int code = 0;         ///< cannotRead: a folder is unreadable or has no such file (already reported)
};

enum class InFolders { testFilesAndReports, reports };
[[nodiscard]] Inputs inputsOf(const Invocation &invocation, InFolders which = InFolders::testFilesAndReports);

/// True if the call names a single file: then options without effect on it are errors.
[[nodiscard]] bool isOneFile(const Invocation &invocation);

/// Separator on stdout between the results of several inputs.
enum class Between { emptyLine, nothing };

/// Processes all inputs, --jobs at a time, and returns the worst code. A failed input is reported in one line
/// and does not stop the others.
int eachInput(const Invocation &invocation, const Inputs &inputs,
              const std::function<JobResult(const Input &)> &work, Between between = Between::emptyLine,
              const std::function<void(const JobResult &)> &heard = {});

/// True if the input was found in a folder and is no report of this program: it is skipped.
[[nodiscard]] bool isToBePassedOver(const Input &input);

/// The same with the document of every input that is not skipped.
int eachDocument(const Invocation &invocation, const Inputs &inputs,
                 const std::function<JobResult(const Input &, Document)> &work,
                 Between between = Between::emptyLine,
                 const std::function<void(const JobResult &)> &heard = {});

/// Value of --jobs; by default the number of processors. Throws UsageError.
[[nodiscard]] int jobsOf(const Invocation &invocation);

/// For commands with many files.
inline constexpr Option jobsOption{
    "jobs", "N", REPORT_TEXT("report", "files worked on at a time; without it one per processor")};

} // namespace palmer
