// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/translated.h"

#include <QWidget>

class QToolButton;

namespace palmer::ui {

/// Two buttons that choose the language of the windows: "FR
/// EN", or the full names on the welcome page.
class LanguageSwitch : public Translated<QWidget> {
    Q_OBJECT

public:
    enum class Names { codes, full };

    explicit LanguageSwitch(Names names, QWidget *parent = nullptr);

private:
    void retranslate() final;

    QToolButton *m_french;
    QToolButton *m_english;
};

} // namespace palmer::ui
