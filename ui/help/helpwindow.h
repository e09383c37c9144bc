// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/help/help.h"

#include <QDialog>
#include <optional>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTextBrowser;

namespace palmer::ui {

/// Help (F1): pages at the left, what they say at the right, in the language of the window.
class HelpWindow : public QDialog {
    Q_OBJECT

public:
    explicit HelpWindow(QWidget *parent = nullptr);

    /// Brings a page into view by its id, and on it the place of an anchor. An unknown page: the first.
    void showPage(const QString &id, const QString &anchor = {});
    [[nodiscard]] QString currentPage() const;
    [[nodiscard]] QString text() const;
    /// Goes to the next place where the words are, on this page or on one behind it, round and round; false:
    /// they are nowhere. The validation is looked through only while it is in view.
    bool find(const QString &words);

protected:
    void changeEvent(QEvent *event) override;

private:
    [[nodiscard]] std::optional<std::size_t> pageAt(int row) const;
    void goTo(std::size_t page);
    void sayWhether(bool found, const QString &words);
    void fillList();
    void showRow(int row);
    void retranslate();

    std::vector<HelpPage> m_pages;
    std::optional<std::vector<SetValidation>> m_validated; ///< computed when it is first looked at
    QLineEdit *m_search;
    QListWidget *m_list;
    QTextBrowser *m_browser;
    QLabel *m_notFound; ///< what was looked for and is nowhere
    QPushButton *m_close;
};

} // namespace palmer::ui
