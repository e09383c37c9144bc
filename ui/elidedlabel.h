// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QString>

namespace palmer::ui {

/// True if a text contains a symbol with a subscript.
[[nodiscard]] bool namesSymbol(const QString &text);

/// Draws a text on one line, vertically centred, elided with "…" if it does not fit.
void drawElided(QPainter &painter, const QRect &area, Qt::Alignment side, const QString &text);
/// The same in a font and colour, which the painter keeps.
void drawElided(QPainter &painter, const QRect &area, Qt::Alignment side, const QString &text,
                const QFont &font, const QColor &colour);

/// A one-line label, elided with "…" if it does not fit; the tooltip then shows the whole text. Indices of
/// symbols such as E_VE and R_LSC are subscripts.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    /// Text parts between this separator, then those between commas, are left out whole, from the last, if
    /// they do not fit.
    void setSeparator(const QString &separator);
    [[nodiscard]] QString shownText() const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_separator;
};

/// A button whose text is elided with "…" if it does not fit; styles cut it at both ends. The tooltip then
/// shows the whole text.
class ElidedButton : public QPushButton {
    Q_OBJECT

public:
    explicit ElidedButton(QWidget *parent = nullptr);

    [[nodiscard]] QString shownText() const;

    [[nodiscard]] QSize minimumSizeHint() const override {
        return {0, QPushButton::minimumSizeHint().height()};
    }

protected:
    void paintEvent(QPaintEvent *event) override;
};

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
