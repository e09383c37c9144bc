// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/qtforward.h"
#include "ui/translated.h"
#include "ui/window/search.h"

#include <QLineEdit>

class QFrame;

namespace palmer::ui {

class SearchModel;

/// One search over fields, results, findings and settings: a box in the toolbar, its answers below it. The
/// box keeps the keyboard: arrows choose, Enter goes there, Ctrl+Enter without closing, Esc closes.
class SearchBox : public Translated<QLineEdit, QEvent::FontChange> {
    Q_OBJECT

public:
    explicit SearchBox(QWidget *parent = nullptr);

    /// Called when the search begins.
    void setSource(std::function<std::vector<SearchEntry>()> source) { m_source = std::move(source); }

signals:
    /// The text about the hit for the status bar; empty when the search ends.
    void said(const QString &text);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void find();
    void step(int by);
    void go(bool closes);
    void end();
    void retranslate() final;

    std::function<std::vector<SearchEntry>()> m_source;
    std::vector<SearchEntry> m_entries;
    SearchModel *m_model;
    QAction *m_icon;
    QFrame *m_panel = nullptr; ///< a child of the window, so that the box keeps the keyboard
    QListView *m_list = nullptr;
    QLabel *m_keys = nullptr;
};

} // namespace palmer::ui
