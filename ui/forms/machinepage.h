// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/form.h"

namespace palmer::ui {

/// The machine under test.
class MachinePage : public Form {
    Q_OBJECT

public:
    MachinePage(DocumentModel &model, Selection &selection, QWidget *parent = nullptr);
};

} // namespace palmer::ui
