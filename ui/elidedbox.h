// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace palmer::ui {

/// A box whose chosen words end in "…" where they have no room; styles cut them off in a letter.
class ElidedBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    /// What is seen of the chosen words.
    [[nodiscard]] QString shownText() const;

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace palmer::ui
