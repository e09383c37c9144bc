// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabletext.h"

#include "ui/model/clipboardtext.h"

#include <QMimeData>

namespace palmer::ui {

bool TableText::canInsertFromMimeData(const QMimeData *source) const {
    return QPlainTextEdit::canInsertFromMimeData(source) || !copiedText(*source).isEmpty();
}

void TableText::insertFromMimeData(const QMimeData *source) {
    const QString text = copiedText(*source);
    if (text.trimmed().contains(u'\n'))
        selectAll();
    textCursor().insertText(text);
    ensureCursorVisible();
}

} // namespace palmer::ui
