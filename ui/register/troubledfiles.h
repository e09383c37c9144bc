// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "register/queries.h"

#include <QDialog>

namespace palmer::ui {

/// The register's files that cannot be read or found, each with its reason. Accepted to remove those not
/// found.
class TroubledFiles : public QDialog {
    Q_OBJECT

public:
    explicit TroubledFiles(const std::vector<ListedSource> &files, QWidget *parent = nullptr);
};

} // namespace palmer::ui
