// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>

namespace palmer::ui {

/// Offers to copy the statements of another test of the file (see takeStatements); hidden until there is one.
class StatementsBox : public QCheckBox {
    Q_OBJECT

public:
    explicit StatementsBox(QWidget *parent);

    /// Shows the box, checked, with the name of the test.
    void offer(const QString &test);
};

} // namespace palmer::ui
