// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/theme.h"

#include <QAbstractButton>
#include <QString>
#include <QWidget>

namespace palmer::ui {

/// A short text with a mark on a coloured background, e.g. a verdict or a count of missing statements.
class Chip : public QWidget {
    Q_OBJECT

public:
    explicit Chip(QWidget *parent = nullptr);

    /// A text wider than the chip is elided, and then needs a tooltip.
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

/// A chip that leads to the list of what it counts: by a click, by Enter or Space.
class LinkChip : public QAbstractButton {
    Q_OBJECT

public:
    explicit LinkChip(QWidget *parent = nullptr);

    void setContent(const QString &text, const QString &icon, Token colour, Token ground);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_icon;
    Token m_colour = Token::secondaryText;
    Token m_ground = Token::hover;
};

} // namespace palmer::ui
