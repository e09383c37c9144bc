#pragma once

#include "editing/newtest.h"
#include "language/language.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace palmer::ui {

/// Asks what a new circular test begins with; its arcs are typed or pasted in the page.
class NewCircleDialog : public QDialog {
    Q_OBJECT

public:
    /// `like`: the test the values of which are proposed, if it is a circular one; null: none.
    explicit NewCircleDialog(const Language &language, const Test *like = nullptr, QWidget *parent = nullptr);

    /// What was asked for; complete once the dialog is accepted.
    [[nodiscard]] NewCircularTest wanted() const;

private:
    void check();

    Language m_language;
    QComboBox *m_plane;
    QLineEdit *m_radius;
    QLineEdit *m_feed;
    QComboBox *m_source;
    QComboBox *m_edition;
    QLabel *m_problem;
    QPushButton *m_create;
};

} // namespace palmer::ui
