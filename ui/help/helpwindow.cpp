// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/helpwindow.h"

#include "ui/help/reporthtml.h"
#include "ui/windowlanguage.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int listWidth = 210;

} // namespace

HelpWindow::HelpWindow(QWidget *parent)
    : QDialog(parent)
    , m_search(new QLineEdit(this))
    , m_list(new QListWidget(this))
    , m_browser(new QTextBrowser(this))
    , m_close(new QPushButton(this)) {
    setObjectName(QStringLiteral("helpWindow"));
    setModal(false);
    resize(900, 640);
    m_list->setObjectName(QStringLiteral("helpPages"));
    m_list->setFixedWidth(listWidth);
    m_browser->setObjectName(QStringLiteral("helpText"));
    m_browser->setOpenLinks(false);
    m_close->setObjectName(QStringLiteral("closeHelp"));
    m_close->setAutoDefault(false);
    auto *row = new QHBoxLayout;
    m_search->setObjectName(QStringLiteral("helpSearch"));
    m_search->setClearButtonEnabled(true);
    m_search->setFixedWidth(listWidth);
    auto *side = new QVBoxLayout;
    side->addWidget(m_search);
    side->addWidget(m_list, 1);
    row->addLayout(side);
    row->addWidget(m_browser, 1);
    auto *foot = new QHBoxLayout;
    foot->addStretch();
    foot->addWidget(m_close);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(row, 1);
    layout->addLayout(foot);
    connect(m_list, &QListWidget::currentRowChanged, this, &HelpWindow::showRow);
    connect(m_search, &QLineEdit::returnPressed, this, [this] { find(m_search->text()); });
    connect(m_close, &QPushButton::clicked, this, &QWidget::close);
    retranslate();
}

void HelpWindow::showRow(int row) {
    if (row < 0 || row >= static_cast<int>(m_pages.size()))
        return;
    HelpPage &page = m_pages[static_cast<std::size_t>(row)];
    if (page.id == u"validation" && page.content.blocks.empty()) {
        if (!m_validated)
            m_validated = validateAll();
        page = composeValidationHelp(*m_validated, windowLanguage());
    }
    m_browser->setHtml(reportHtml(page.content));
}

void HelpWindow::showPage(const QString &id, const QString &anchor) {
    const auto found = std::ranges::find(m_pages, id, &HelpPage::id);
    m_list->setCurrentRow(found == m_pages.end() ? 0 : static_cast<int>(found - m_pages.begin()));
    if (!anchor.isEmpty())
        m_browser->scrollToAnchor(anchor);
}

QString HelpWindow::currentPage() const {
    const int row = m_list->currentRow();
    return row < 0 ? QString() : m_pages[static_cast<std::size_t>(row)].id;
}

QString HelpWindow::text() const {
    return m_browser->toPlainText();
}

bool HelpWindow::find(const QString &words) {
    if (words.isEmpty())
        return false;
    if (m_browser->find(words))
        return true;
    const int pages = m_list->count();
    for (int step = 1; step <= pages; ++step) {
        const int row = (m_list->currentRow() + step) % pages;
        if (row != m_list->currentRow() && m_pages[static_cast<std::size_t>(row)].id == u"validation")
            continue; // it would have to be computed
        QTextDocument text;
        text.setHtml(reportHtml(m_pages[static_cast<std::size_t>(row)].content));
        if (row != m_list->currentRow() && text.find(words).isNull())
            continue;
        m_list->setCurrentRow(row);
        m_browser->moveCursor(QTextCursor::Start);
        if (m_browser->find(words))
            return true;
    }
    return false;
}

void HelpWindow::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void HelpWindow::retranslate() {
    const QString current = currentPage();
    setWindowTitle(tr("Help"));
    m_search->setPlaceholderText(tr("Search, Enter: next place"));
    m_search->setAccessibleName(tr("Search the help"));
    m_list->setAccessibleName(tr("Pages of the help"));
    m_browser->setAccessibleName(tr("Text of the help"));
    m_close->setText(tr("&Close"));
    m_pages = composeHelp(windowLanguage());
    m_pages.push_back({QStringLiteral("validation"), tr("Validation"), {}});
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        for (const HelpPage &page : m_pages)
            m_list->addItem(page.title);
    }
    showPage(current);
}

} // namespace palmer::ui
