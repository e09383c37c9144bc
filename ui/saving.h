// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"

#include <QFileDialog>
#include <QString>

namespace palmer::ui {

/// Asks where a file is to be saved. Its name ends as one of the filters says, so that nothing is called what
/// it is not: of "Report 3.5", ".5" would be the ending. Under "(*)" it may be any.
class SaveDialog : public QFileDialog {
public:
    SaveDialog(QWidget *parent, const QString &title, const QStringList &filters, const QString &folder = {});

    /// The filter for the ending of a name: the chosen one if it fits, otherwise the first that does; −1:
    /// none.
    [[nodiscard]] qsizetype filterOf(const QString &name) const;

protected:
    void accept() override;
};

/// Asks where a PDF document is to be saved, which then ends with ".pdf"; empty if nowhere. `name` is
/// proposed.
[[nodiscard]] QString askForPdf(QWidget *parent, const QString &title, const QString &name);

/// Says in the status bar of the window of a widget, or of the one behind it, where a file was saved.
void saySaved(QWidget *from, const QString &path);

} // namespace palmer::ui
