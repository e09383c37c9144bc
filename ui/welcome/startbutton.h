#pragma once

#include <QAbstractButton>

namespace palmer::ui {

/// A card to click: icon, title with its shortcut, one line of explanation.
class StartButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit StartButton(const QString &icon, QWidget *parent = nullptr);

    /// The text of the button is its title; `&` marks the mnemonic.
    void setTexts(const QString &title, const QString &detail, const QString &shortcut);

    [[nodiscard]] QSize sizeHint() const override { return {232, 56}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_icon;
    QString m_detail;
    QString m_shortcut;
};

} // namespace palmer::ui
