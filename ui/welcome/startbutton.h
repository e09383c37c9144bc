// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QPixmap>

class QPainter;

namespace palmer::ui {

/// A clickable card: icon, title with shortcut and a line of explanation; the large one also has a picture of
/// the result above and the standard below the title.
class StartButton : public QAbstractButton {
    Q_OBJECT

public:
    enum class Picture { none, deviation, circle };

    explicit StartButton(QString icon, QWidget *parent = nullptr, Picture picture = Picture::none);

    /// `title` is the button's text; `&` marks the mnemonic.
    void setTexts(const QString &title, const QString &detail, const QString &shortcut);

    /// Standard for evaluating the new test, on a separate line.
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
    QPixmap m_painted; ///< cached picture; null if outdated
};

} // namespace palmer::ui
