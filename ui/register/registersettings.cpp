// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/registersettings.h"

#include "register/register.h"
#include "ui/madewidgets.h"
#include "ui/register/folderlist.h"
#include "ui/register/registerservice.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QUrl>

namespace palmer::ui {

namespace {

enum Place { inFile, onServer };

/// Adds the password typed next to the address; one in the address takes precedence.
QString withPassword(const QString &address, const QString &password) {
    QUrl url(address);
    if (password.isEmpty() || !isServerAddress(address) || !url.password().isEmpty())
        return address;
    url.setPassword(password, QUrl::DecodedMode);
    return url.isValid() ? url.toString(QUrl::FullyEncoded) : address;
}

} // namespace

RegisterSettings::RegisterSettings(RegisterService &service, QWidget *parent)
    : Translated(parent)
    , m_service(service)
    , m_foldersTitle(made<QLabel>(TextSize::head))
    , m_folders(new FolderList(service.folders()))
    , m_placeTitle(made<QLabel>(TextSize::head))
    , m_place(made<QComboBox>("registerPlace"))
    , m_index(made<QLabel>("registerIndex", trait::secondary, trait::plainText, trait::wrapped))
    , m_server(new QWidget)
    , m_address(made<QLineEdit>("registerServer"))
    , m_password(made<QLineEdit>("registerPassword"))
    , m_connect(made<QPushButton>("registerConnect", trait::notDefault))
    , m_note(made<QLabel>(trait::secondary, trait::plainText, trait::wrapped))
    , m_outcome(made<QLabel>("registerOutcome", trait::wrapped, trait::plainText)) {
    constexpr int listHeight = 84;
    setObjectName(QStringLiteral("registerSettings"));
    m_folders->setMaximumHeight(2 * listHeight);
    m_folders->setMinimumHeight(listHeight);
    m_password->setEchoMode(QLineEdit::Password);
    m_index->setTextInteractionFlags(Qt::TextSelectableByMouse);
    inColumn(m_server, noMargins, styleSpacing,
             {m_address, inRow(styleSpacing, {{m_password, 1}, m_connect}), m_note});
    inColumn(this, noMargins, styleSpacing,
             {m_foldersTitle, m_folders, m_placeTitle, m_place, m_index, m_server, m_outcome});
    if (isServerAddress(service.address()))
        m_address->setText(withoutPassword(service.address()));
    retranslate();
    m_place->setCurrentIndex(isServerAddress(service.address()) ? onServer : inFile);
    showPlace();
    connect(m_folders, &FolderList::changed, this, [this] { m_service.setFolders(m_folders->folders()); });
    connect(m_place, &QComboBox::activated, this, &RegisterSettings::choosePlace);
    connect(m_connect, &QPushButton::clicked, this, &RegisterSettings::tryServer);
    for (QLineEdit *field : {m_address, m_password})
        connect(field, &QLineEdit::returnPressed, this, &RegisterSettings::tryServer);
}

void RegisterSettings::showPlace() {
    m_server->setVisible(m_place->currentIndex() == onServer);
    m_index->setText(tr("The index stands here: %1").arg(withoutPassword(m_service.address())));
    m_connect->setEnabled(!m_lane.isBusy());
}

void RegisterSettings::choosePlace(int place) {
    m_outcome->clear();
    m_lane.cancel();
    if (place == inFile && isServerAddress(m_service.address()))
        m_service.setAddress(Register::standardPath());
    showPlace();
}

void RegisterSettings::tryServer() {
    if (m_lane.isBusy())
        return;
    const QString address = withPassword(m_address->text().trimmed(), m_password->text());
    if (!isServerAddress(address)) {
        m_outcome->setText(tr("The address of a server begins with postgresql://"));
        return;
    }
    m_outcome->setText(tr("The server is being asked…"));
    m_lane.start(
        [address, language = windowLanguage()](const Background::Job &) {
            try {
                const Register reg(address);
                return QString();
            } catch (const Error &error) {
                return language.sentence(error.message);
            }
        },
        [this, address](const QString &trouble) {
            if (trouble.isEmpty()) {
                m_service.setAddress(address);
                m_address->setText(withoutPassword(address));
                m_password->clear();
                m_outcome->setText(tr("The server keeps the register now."));
            } else {
                m_outcome->setText(tr("Nothing was changed: %1").arg(trouble));
            }
            showPlace();
        });
    showPlace();
}

void RegisterSettings::retranslate() {
    m_foldersTitle->setText(tr("Folders of the register"));
    m_placeTitle->setText(tr("Index of the register"));
    {
        const QSignalBlocker blocker(m_place);
        const int chosen = m_place->currentIndex();
        m_place->clear();
        m_place->addItems({tr("In a file of this user"), tr("On a PostgreSQL server that several share")});
        m_place->setCurrentIndex(chosen);
    }
    m_place->setAccessibleName(m_placeTitle->text());
    m_address->setPlaceholderText(QStringLiteral("postgresql://user@host:5432/name"));
    m_address->setAccessibleName(tr("Address of the server"));
    m_password->setPlaceholderText(tr("Password, where the server asks for one"));
    m_password->setAccessibleName(tr("Password"));
    m_connect->setText(tr("Co&nnect"));
    m_note->setText(tr("The password is not stored: after the next start it is taken from your password file "
                       "of PostgreSQL (~/.pgpass), or asked for here again."));
    showPlace();
}

} // namespace palmer::ui
