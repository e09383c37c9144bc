// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/languageswitch.h"

#include "ui/madewidgets.h"
#include "ui/windowlanguage.h"

#include <QButtonGroup>
#include <QToolButton>

namespace palmer::ui {

LanguageSwitch::LanguageSwitch(Names names, QWidget *parent)
    : Translated(parent)
    , m_french(
          made<QToolButton>("french", trait::checkable, trait::strongFocus, trait::segment("first"), this))
    , m_english(
          made<QToolButton>("english", trait::checkable, trait::strongFocus, trait::segment("last"), this)) {
    inRow(this, noMargins, 0, {m_french, m_english});
    auto *group = new QButtonGroup(this);
    for (QToolButton *button : {m_french, m_english})
        group->addButton(button);
    // Language names are not translated.
    m_french->setText(names == Names::codes ? QStringLiteral("FR") : QStringLiteral("Français"));
    m_english->setText(names == Names::codes ? QStringLiteral("EN") : QStringLiteral("English"));
    m_french->setAccessibleName(QStringLiteral("Français"));
    m_english->setAccessibleName(QStringLiteral("English"));
    connect(m_french, &QToolButton::clicked, this, [] { setWindowLanguage(Language::Id::french); });
    connect(m_english, &QToolButton::clicked, this, [] { setWindowLanguage(Language::Id::english); });
    retranslate();
}

void LanguageSwitch::retranslate() {
    const bool french = windowLanguage().id() == Language::Id::french;
    m_french->setChecked(french);
    m_english->setChecked(!french);
    const QString hint = tr("Language of the window; the report has its own");
    m_french->setToolTip(hint);
    m_english->setToolTip(hint);
    setAccessibleName(hint);
}

} // namespace palmer::ui
