// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace palmer::ui {

/// The name of a step that changes one field, for DocumentModel::edit: the label as context and source, so
/// that the step is called in whatever language the window speaks when it is shown.
[[nodiscard]] QByteArray changeOf(const char *context, const char *label, const QString &argument = {});

/// The name of a step that did something so many times: `source` is a counted text of the context "edits",
/// "clear %n reading(s)".
[[nodiscard]] QByteArray countedEdit(const char *source, int count);

/// The field a step changed: context and source of its label, and what stands for %1 in it.
struct EditPlace {
    QString context;
    QByteArray label;
    QString argument;
};

/// Where a step was made, from its name (its source); null for steps that are no change of one field.
[[nodiscard]] std::optional<EditPlace> editPlace(const QString &source);

/// The name of a step (its source) in the language of the window.
[[nodiscard]] QString editName(const QString &source);

} // namespace palmer::ui
