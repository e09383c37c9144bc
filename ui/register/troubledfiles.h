// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

#include <QDialog>

namespace palmer::ui {

/// The files of the register that cannot be read or found, each with its reason. Accepted if those not found
/// are to be removed.
class TroubledFiles : public QDialog {
    Q_OBJECT

public:
    explicit TroubledFiles(const std::vector<ListedSource> &files, QWidget *parent = nullptr);
};

} // namespace palmer::ui
