// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QString>

namespace palmer::ui {

/// Whether a text of the window has a symbol in it whose index is to stand lower.
[[nodiscard]] bool namesSymbol(const QString &text);

/// A label on one line that ends in "…" where it has no room; the tool tip has all of it then. The indices of
/// the symbols that labels name, E_VE and R_LSC, stand lower.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    /// Of parts that stand between this, those that have no room are left out as a whole, from the last.
    void setSeparator(const QString &separator);
    [[nodiscard]] QString shownText() const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_separator;
};

} // namespace palmer::ui
