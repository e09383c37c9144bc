// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace palmer::ui {

/// Name of a step that changes one field, for DocumentModel::edit. It holds the label with its translation
/// context, so that it is shown in the current language of the window.
[[nodiscard]] QByteArray changeOf(const char *context, const char *label, const QString &argument = {});

/// Name of a step with a count: `source` is a plural text of the context "edits", e.g. "clear %n reading(s)".
[[nodiscard]] QByteArray countedEdit(const char *source, int count);

/// The field a step changed: context and source text of its label, and the argument for %1.
struct EditPlace {
    QString context;
    QByteArray label;
    QString argument;
};

/// Returns the field a step changed, from the step's source name; null if it did not change a single field.
[[nodiscard]] std::optional<EditPlace> editPlace(const QString &source);

/// Name of a step, from its source name, in the language of the window.
[[nodiscard]] QString editName(const QString &source);

} // namespace palmer::ui
