// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "document/document.h"

#include <array>

namespace palmer {

/// Options that change what is evaluated or printed, not the file: --template, --editions.
inline constexpr std::array preparationOptions{
    Option{
        "template", "FILE.palmer-template",
        REPORT_TEXT("report",
                    "take machine, instrument, laboratory, limits or conditions from a template; may stand "
                    "several times"),
        true, "", false, itself},
    Option{"editions", "A,B", REPORT_TEXT("report", "editions to print side by side, without verdicts")},
};

/// Applies --template, --editions and the paths of --set to the document; prints what a template replaces.
/// Throws UsageError for invalid values and for templates that fit no test of a single file, Error for an
/// unreadable template and one of another machine or instrument.
[[nodiscard]] Document prepared(Document document, const QString &file, const Invocation &invocation);

/// True if the files of --template can be read; otherwise prints one error line, however many files are to be
/// prepared.
[[nodiscard]] bool canReadTemplates(const Invocation &invocation);

/// The --set options that are paths of the test file and no choices of the import, in the given order. Throws
/// UsageError without key=value.
struct FieldSetting {
    QString path;
    QString value;
};
[[nodiscard]] std::vector<FieldSetting> fieldSettings(const Invocation &invocation);

} // namespace palmer
