// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>

namespace palmer {
class Error;
}

namespace palmer::ui {

/// The text with a capital first letter. Texts of the core follow a colon elsewhere.
[[nodiscard]] QString capitalised(QString text);

/// Opens a box for the parent that says what failed and why. Returns at once; the box ("errorBox") is deleted
/// on closing. Without a title it has that of the parent's window.
QMessageBox *showError(QWidget *parent, const QString &what, const QString &why,
                       QMessageBox::Icon icon = QMessageBox::Critical, const QString &title = {});

/// The same with the error's message in the window's language, and its position in the file if known.
QMessageBox *showError(QWidget *parent, const QString &what, const Error &error,
                       QMessageBox::Icon icon = QMessageBox::Critical, const QString &title = {});

} // namespace palmer::ui
