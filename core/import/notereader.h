// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "import/filenotes.h"
#include "import/labelledvalues.h"

#include <QRegularExpression>
#include <QString>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace palmer {

/// The fields that a label has stated.
struct LabelState {
    std::set<const std::string *> labelled;
    bool isDateLabelled = false;
};

/// Takes the labelled facts of a line, by its number; returns what is left. Of two values of one fact the
/// first is taken.
std::vector<LabelledValue> readLabels(const std::vector<LabelledValue> &line, std::size_t number,
                                      FileNotes &notes, LabelState &state);

/// A pattern that ignores case, made once.
[[nodiscard]] const QRegularExpression &pattern(const char *text);
/// The first group of a pattern in a line.
[[nodiscard]] std::optional<QString> captured(const char *text, const QString &line);
[[nodiscard]] std::optional<double> positiveNumber(const std::optional<QString> &text);

} // namespace palmer
