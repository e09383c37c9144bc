// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/help/help.h"
#include "ui/model/background.h"
#include "ui/qtforward.h"
#include "ui/translated.h"
#include "validation/validation.h"

#include <QDialog>
#include <optional>
#include <vector>

namespace palmer::ui {

/// Help (F1): pages on the left, their content on the right, in the window's language.
class HelpWindow : public Translated<QDialog> {
    Q_OBJECT

public:
    explicit HelpWindow(QWidget *parent = nullptr);

    /// Shows a page by its ID, scrolled to an anchor. An unknown ID shows the first page.
    void showPage(const QString &id, const QString &anchor = {});
    [[nodiscard]] QString currentPage() const;
    [[nodiscard]] QString text() const;
    /// Moves to the next occurrence of the words on this or the following pages, cyclically. False if there
    /// is none. The validation is searched only while in view.
    bool find(const QString &words);

private:
    [[nodiscard]] std::optional<std::size_t> pageAt(int row) const;
    void goTo(std::size_t page);
    void sayWhether(bool found, const QString &words);
    void fillList();
    void showRow(int row);
    void saveValidation();
    void retranslate() final;

    std::vector<HelpPage> m_pages;
    std::optional<std::vector<SetValidation>> m_validated; ///< on first use the quick sets, when saved all
    Background m_lane;                                     ///< evaluates all sets
    QLineEdit *m_search;
    QListWidget *m_list;
    QTextBrowser *m_browser;
    QLabel *m_notFound;  ///< says what was not found
    QPushButton *m_save; ///< of the validation only
    QPushButton *m_close;
};

} // namespace palmer::ui
