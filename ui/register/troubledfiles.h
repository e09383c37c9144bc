// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

#include <QDialog>

namespace palmer::ui {

/// The files of the register that cannot be read or are not found any more, each with its reason. Those that
/// are not found can be taken out: accepted then.
class TroubledFiles : public QDialog {
    Q_OBJECT

public:
    explicit TroubledFiles(const std::vector<ListedSource> &files, QWidget *parent = nullptr);
};

} // namespace palmer::ui
