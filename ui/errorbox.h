// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>

namespace palmer {
class Error;
}

namespace palmer::ui {

/// A text that begins a line: with a capital. What the core says stands elsewhere behind a colon.
[[nodiscard]] QString capitalised(QString text);

/// Opens a box before the parent: what could not be done, and why. It returns at once; the box ("errorBox")
/// goes when it is closed. Without a title, that of the parent's window.
QMessageBox *showError(QWidget *parent, const QString &what, const QString &why,
                       QMessageBox::Icon icon = QMessageBox::Critical, const QString &title = {});

/// The same with the sentence of the error in the language of the window, and the place in the file if it has
/// one.
QMessageBox *showError(QWidget *parent, const QString &what, const Error &error,
                       QMessageBox::Icon icon = QMessageBox::Critical, const QString &title = {});

} // namespace palmer::ui
