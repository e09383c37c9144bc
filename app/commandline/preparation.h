// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commandline/command.h"
#include "document/document.h"

#include <array>

namespace palmer {

/// The options that change what is evaluated or printed, not the file: --template, --editions.
inline constexpr std::array preparationOptions{
    Option{
        "template", "FILE.palmer-template",
        REPORT_TEXT("report",
                    "take machine, instrument, laboratory, limits or conditions from a template; may stand "
                    "several times"),
        true},
    Option{"editions", "A,B", REPORT_TEXT("report", "editions to print side by side, without verdicts")},
};

/// The document with what --template, --editions and those of --set say that are paths of the test file.
/// Throws UsageError for what cannot be, Error for a template that cannot be read.
[[nodiscard]] Document prepared(Document document, const Invocation &invocation);

/// Whether the files of --template can be read; else one line says which cannot, however many files are to be
/// prepared.
[[nodiscard]] bool canReadTemplates(const Invocation &invocation);

/// Of --set what is a path of the test file and no choice of the import, in the order given. Throws
/// UsageError for what is no key=value.
struct FieldSetting {
    QString path;
    QString value;
};
[[nodiscard]] std::vector<FieldSetting> fieldSettings(const Invocation &invocation);

} // namespace palmer
