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

/// A file that a command works on.
struct Input {
    QString file;
    QString shown; ///< its name as people read it
    QString below; ///< path from the FOLDER it was found in; of a file that was named its name alone
    bool found = false;
};

/// FILE… as they are named, and of each FOLDER the test files and PDFs in it and below it, sorted.
struct Inputs {
    std::vector<Input> list;
    bool several = false; ///< more than one, or a folder: what is printed names its file
    int code = 0;         ///< cannotRead: a folder cannot be read or has no such file, which is printed
};

enum class InFolders { testFilesAndReports, reports };
[[nodiscard]] Inputs inputsOf(const Invocation &invocation, InFolders which = InFolders::testFilesAndReports);

/// Whether the call names one file: what has no effect on it has none at all.
[[nodiscard]] bool isOneFile(const Invocation &invocation);

/// What stands on stdout between the results of several inputs.
enum class Between { emptyLine, nothing };

/// Works on every input, also after a bad one, whose error is one line; --jobs at a time, and returns the
/// worst code.
int eachInput(const Invocation &invocation, const Inputs &inputs,
              const std::function<JobResult(const Input &)> &work, Between between = Between::emptyLine,
              const std::function<void(const JobResult &)> &heard = {});

/// Whether it was found in a folder and is no report of this program: to be passed over.
[[nodiscard]] bool isToBePassedOver(const Input &input);

/// The same with the document of every input, but those to be passed over.
int eachDocument(const Invocation &invocation, const Inputs &inputs,
                 const std::function<JobResult(const Input &, Document)> &work,
                 Between between = Between::emptyLine,
                 const std::function<void(const JobResult &)> &heard = {});

/// --jobs, without it as many as there are processors. Throws UsageError.
[[nodiscard]] int jobsOf(const Invocation &invocation);

/// Of commands that work on many files.
inline constexpr Option jobsOption{
    "jobs", "N", REPORT_TEXT("report", "files worked on at a time; without it one per processor")};

} // namespace palmer
