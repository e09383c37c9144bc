// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/settingsdialog.h"

#include "ui/formrows.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/settings.h"
#include "ui/register/registerservice.h"
#include "ui/register/registersettings.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QSignalBlocker>

namespace palmer::ui {

namespace {

/// Sets the texts of a box and its current index.
void setWords(QComboBox &box, const QStringList &words, int chosen) {
    const QSignalBlocker blocker(&box);
    box.clear();
    box.addItems(words);
    box.setCurrentIndex(chosen);
}

} // namespace

SettingsDialog::SettingsDialog(QWidget *parent)
    : Translated(parent) {
    setObjectName(QStringLiteral("settingsDialog"));
    auto *form = new QFormLayout;
    m_language = addChoice(*form, "settingsLanguage");
    m_theme = addChoice(*form, "settingsTheme");
    m_lengths = addChoice(*form, "settingsLengths");
    m_angles = addChoice(*form, "settingsAngles");
    alignLabels(*form);
    const auto addSwitch = [this](const QString &name, bool on) {
        auto *box = made<QCheckBox>(name, this);
        box->setChecked(on);
        return box;
    };
    m_autosave = addSwitch(QStringLiteral("settingsAutosave"), keepsCopies());
    m_backup = addSwitch(QStringLiteral("settingsBackup"), keepsBackups());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_buttons = buttons;
    inColumn(this, {pageMargin, pageMargin, pageMargin, pageMargin}, 12,
             {form, m_autosave, m_backup, new RegisterSettings(RegisterService::instance(), this),
              Placed::stretch(), m_buttons});
    retranslate();
    connect(m_language, &QComboBox::activated, this,
            [](int index) { setWindowLanguage(index == 0 ? Language::Id::french : Language::Id::english); });
    connect(m_theme, &QComboBox::activated, this,
            [](int index) { setThemeChoice(static_cast<ThemeChoice>(index)); });
    for (QComboBox *box : {m_lengths, m_angles})
        connect(box, &QComboBox::activated, this, &SettingsDialog::setUnits);
    connect(m_autosave, &QCheckBox::clicked, this, &setKeepsCopies);
    connect(m_backup, &QCheckBox::clicked, this, &setKeepsBackups);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QComboBox *SettingsDialog::addChoice(QFormLayout &form, const char *name) {
    auto *box = made<QComboBox>(name, trait::strongFocus, this);
    auto *label = new QLabel(this);
    label->setBuddy(box);
    form.addRow(label, box);
    m_labels.push_back(label);
    return box;
}

void SettingsDialog::setUnits() {
    setWindowUnits({static_cast<LengthDisplay>(m_lengths->currentIndex()),
                    static_cast<AngleDisplay>(m_angles->currentIndex())});
}

namespace {

QStringList labelsOfChoices() {
    return {SettingsDialog::tr("&Language of the window"), SettingsDialog::tr("&Theme"),
            SettingsDialog::tr("L&engths"), SettingsDialog::tr("An&gles")};
}

} // namespace

QStringList SettingsDialog::names() {
    QStringList names = labelsOfChoices() << tr("&Keep changes safe from a crash")
                                          << tr("Keep the version &before when saving");
    return names.replaceInStrings(QStringLiteral("&"), QString());
}

void SettingsDialog::retranslate() {
    setWindowTitle(tr("Settings"));
    const QStringList labels = labelsOfChoices();
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        m_labels[i]->setText(labels[static_cast<qsizetype>(i)]);
        m_labels[i]->buddy()->setAccessibleName(QString(labels[static_cast<qsizetype>(i)]).remove(u'&'));
    }
    const DisplayUnits units = windowLanguage().units();
    setWords(*m_language, {QStringLiteral("Français"), QStringLiteral("English")},
             windowLanguage().id() == Language::Id::french ? 0 : 1);
    setWords(*m_theme, {tr("as the system"), tr("light"), tr("dark")}, static_cast<int>(themeChoice()));
    setWords(*m_lengths, {tr("µm and mm"), tr("mm only"), tr("µin and inches")},
             static_cast<int>(units.lengths));
    setWords(*m_angles, {tr("arc seconds and degrees"), tr("degrees only")}, static_cast<int>(units.angles));
    m_autosave->setText(tr("&Keep changes safe from a crash"));
    m_autosave->setToolTip(tr("A copy of what is not saved, in a folder of Palmer; it goes when you save"));
    m_backup->setText(tr("Keep the version &before when saving"));
    m_backup->setToolTip(tr("Beside the file, with .bak at the end of its name"));
    m_buttons->button(QDialogButtonBox::Close)->setText(tr("&Close"));
}

} // namespace palmer::ui
