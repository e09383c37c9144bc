// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"
#include "ui/translated.h"
#include "ui/welcome/startlist.h"

#include <QWidget>

namespace palmer::ui {

class StartButton;

/// The window's page before a file is open: ways to start, recent files, examples.
class WelcomePage : public Translated<QWidget> {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget *parent = nullptr);

    /// Reads the recent files again.
    void refresh();

signals:
    void newAsked();
    void newCircleAsked();
    void openAsked();
    void importAsked();
    void planAsked();
    void fileChosen(const QString &path);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void retranslate() final;

    StartModel m_recent;
    StartModel m_examples;
    StartModel m_teaching;
    // Parts are made with their final parent: reparenting recomputes all styles below them.
    QScrollArea *m_place;
    QWidget *m_page; ///< scrolls on low screens
    QWidget *m_body;
    QLabel *m_subtitle;
    QLabel *m_dropHint;
    QLabel *m_recentTitle;
    QLabel *m_noRecent;
    QLabel *m_examplesTitle;
    QLabel *m_examplesNote;
    QLabel *m_teachingTitle;
    StartButton *m_new;
    StartButton *m_newCircle;
    StartButton *m_open;
    StartButton *m_import;
    StartButton *m_plan;
    StartList *m_recentList;
    StartList *m_examplesList;
    StartList *m_teachingList;
};

} // namespace palmer::ui
