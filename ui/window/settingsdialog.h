// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QDialog>
#include <vector>

namespace palmer::ui {

/// Settings for all windows: language, theme, displayed units, how changes are kept and the folders of the
/// register. Each choice takes effect at once.
class SettingsDialog : public Translated<QDialog> {
    Q_OBJECT

public:
    /// Names of the settings, to be searched.
    [[nodiscard]] static QStringList names();

    explicit SettingsDialog(QWidget *parent = nullptr);

private:
    QComboBox *addChoice(QFormLayout &form, const char *name);
    void setUnits();
    void retranslate() final;

    QComboBox *m_language;
    QComboBox *m_theme;
    QComboBox *m_lengths;
    QComboBox *m_angles;
    QCheckBox *m_autosave;
    QCheckBox *m_backup;
    QDialogButtonBox *m_buttons;
    std::vector<QLabel *> m_labels; ///< of the choices, in order
};

} // namespace palmer::ui
