#pragma once

#include <QLabel>

namespace palmer::ui {

/// A label on one line that ends in "…" where it has no room; the tool tip has all of it then.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget *parent = nullptr);

    [[nodiscard]] QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent *event) override;
};

} // namespace palmer::ui
