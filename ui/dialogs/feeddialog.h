#pragma once

#include "kernel/evaluation/iso230_4/contouringfeed.h"

#include <QDialog>

class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;

namespace palmer::ui {

/// "Contouring feed…": the feed for a circle of another diameter (ISO 230-4, annex C), computed while one
/// types. Begins with the example of the annex. Changes no document.
class FeedDialog : public QDialog {
    Q_OBJECT

public:
    explicit FeedDialog(QWidget *parent = nullptr);

    /// Shows these numbers; where one is not above 0 what is shown stays.
    void setNumbers(const iso230_4::ContouringFeed &numbers);

protected:
    void changeEvent(QEvent *event) override;

private:
    QDoubleSpinBox *addNumber(const char *name, double largest);
    void showFeed();
    void retranslate();

    QLabel *m_specifiedDiameterLabel;
    QLabel *m_specifiedFeedLabel;
    QLabel *m_diameterLabel;
    QDoubleSpinBox *m_specifiedDiameter;
    QDoubleSpinBox *m_specifiedFeed;
    QDoubleSpinBox *m_diameter;
    QLabel *m_feedLabel;
    QLabel *m_feed;
    QLabel *m_formula;
    QDialogButtonBox *m_buttons;
};

} // namespace palmer::ui
