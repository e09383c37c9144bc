// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QPixmap>

class QPainter;

namespace palmer::ui {

/// A card to click: icon, title with its shortcut, one line of explanation; the large one with a picture of
/// what it makes above them and the standard below the title.
class StartButton : public QAbstractButton {
    Q_OBJECT

public:
    enum class Picture { none, deviation, circle };

    explicit StartButton(QString icon, QWidget *parent = nullptr, Picture picture = Picture::none);

    /// The text of the button is its title; `&` marks the mnemonic.
    void setTexts(const QString &title, const QString &detail, const QString &shortcut);

    /// By which standard the new test can be evaluated, on a line of its own.
    void setStandard(const QString &standard);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void describe();
    void paintPicture(QPainter &painter, const QRectF &area) const;
    [[nodiscard]] const QPixmap &picture();

    QString m_icon;
    Picture m_picture;
    QString m_detail;
    QString m_standard;
    QString m_shortcut;
    QPixmap m_painted; ///< the picture; null: to be painted
};

} // namespace palmer::ui
