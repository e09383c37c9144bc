#pragma once

#include "report/help.h"

#include <QDialog>
#include <optional>
#include <vector>

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

protected:
    void changeEvent(QEvent *event) override;

private:
    void showRow(int row);
    void retranslate();

    std::vector<HelpPage> m_pages;
    std::optional<std::vector<SetValidation>> m_validated; ///< computed when it is first looked at
    QListWidget *m_list;
    QTextBrowser *m_browser;
    QPushButton *m_close;
};

} // namespace palmer::ui
