// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <QString>
#include <QWidget>

namespace palmer::ui {

/// A short word with its mark on a coloured ground: a verdict, a count of what is missing.
class Chip : public QWidget {
    Q_OBJECT

public:
    explicit Chip(QWidget *parent = nullptr);

    /// A text that is wider than the chip ends in an ellipsis: where that may be, it needs a tooltip.
    void setContent(const QString &text, const QString &icon, Token colour, Token ground);
    [[nodiscard]] QString text() const { return m_text; }

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_text;
    QString m_icon;
    Token m_colour = Token::secondaryText;
    Token m_ground = Token::hover;
};

} // namespace palmer::ui
