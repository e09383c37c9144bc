// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/background.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QWidget>

namespace palmer::ui {

class FolderList;
class RegisterService;

/// Settings of the register: its folders and the location of its index, a file of this user or a PostgreSQL
/// server shared by several. A server is accepted only once it was reached; its password is kept only until
/// the program ends.
class RegisterSettings : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit RegisterSettings(RegisterService &service, QWidget *parent = nullptr);

    [[nodiscard]] bool isBusy() const { return m_lane.isBusy(); }

private:
    void showPlace();
    void choosePlace(int place);
    void tryServer();
    void retranslate() final;

    RegisterService &m_service;
    QLabel *m_foldersTitle;
    FolderList *m_folders;
    QLabel *m_placeTitle;
    QComboBox *m_place;
    QLabel *m_index; ///< location of the index
    QWidget *m_server;
    QLineEdit *m_address;
    QLineEdit *m_password;
    QPushButton *m_connect;
    QLabel *m_note;
    QLabel *m_outcome;
    Background m_lane;
};

} // namespace palmer::ui
