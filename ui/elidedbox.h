// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace palmer::ui {

/// A combo box whose text is elided with "…" if it does not fit; styles clip it mid-letter.
class ElidedBox : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    /// The visible part of the chosen text.
    [[nodiscard]] QString shownText() const;

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace palmer::ui
