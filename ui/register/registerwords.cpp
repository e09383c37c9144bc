// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registerwords.h"

#include "ui/windowlanguage.h"

namespace palmer::ui {

QString counted(QString text, int number) {
    return text.replace(QString::number(number), windowLanguage().number(number, Quantity::count));
}

} // namespace palmer::ui
