// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;

namespace palmer::ui {

/// What holds for all windows: their language, their look, the units they show, how changes are kept,
/// what the register is made of. Each choice holds at once.
class SettingsDialog : public QDialog {
    Q_OBJECT

public:
    explicit SettingsDialog(QWidget *parent = nullptr);

protected:
    void changeEvent(QEvent *event) override;

private:
    QComboBox *addChoice(QFormLayout &form, const char *name);
    void setUnits();
    void retranslate();

    QComboBox *m_language;
    QComboBox *m_theme;
    QComboBox *m_lengths;
    QComboBox *m_angles;
    QCheckBox *m_autosave;
    QCheckBox *m_backup;
    QDialogButtonBox *m_buttons;
    std::vector<QLabel *> m_labels; ///< of the choices, in their order
};

} // namespace palmer::ui
