// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editing/readingblock.h"
#include "language/language.h"

#include <QFrame>

class QButtonGroup;
class QComboBox;
class QLabel;
class QToolButton;

namespace palmer::ui {

/// What a paste did, and how it was understood: shown above the table until something else is done. Another
/// choice pastes anew.
class PasteBar : public QFrame {
    Q_OBJECT

public:
    explicit PasteBar(QWidget *parent = nullptr);

    void show(const PastedBlock &pasted, const BlockChoices &choices, const Language &language, bool canUndo);

signals:
    void decimalMarkChosen(palmer::DecimalMark mark);
    void contentChosen(palmer::BlockContent content);
    void undoWanted();

protected:
    void changeEvent(QEvent *event) override;

private:
    void retranslate();

    QLabel *m_summary;
    QLabel *m_remarks;
    QLabel *m_guess;
    QButtonGroup *m_marks;
    QToolButton *m_comma;
    QToolButton *m_point;
    QComboBox *m_content;
    QToolButton *m_undo;
    QToolButton *m_close;
};

} // namespace palmer::ui
