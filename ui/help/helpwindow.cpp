// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/helpwindow.h"

#include "document/savedocument.h"
#include "kernel/evaluation/edition.h"
#include "print/pdf/writepdf.h"
#include "ui/elidedlabel.h"
#include "ui/help/reporthtml.h"
#include "ui/madewidgets.h"
#include "ui/saving.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"
#include "validation/validationreport.h"

#include <QBuffer>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTextBrowser>
#include <QTextDocument>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int listWidth = 210;
constexpr int textMargin = 12;
constexpr int pageRole = Qt::UserRole + 1; ///< page index of a row; none for a group title

} // namespace

HelpWindow::HelpWindow(QWidget *parent)
    : Translated(parent)
    , m_search(made<QLineEdit>("helpSearch", this))
    , m_list(made<QListWidget>("helpPages", this))
    , m_browser(made<QTextBrowser>("helpText", this))
    , m_notFound(made<ElidedLabel>("helpNotFound", trait::plainText, this))
    , m_save(made<QPushButton>("saveValidation", trait::notDefault, this))
    , m_close(made<QPushButton>("closeHelp", trait::notDefault, this)) {
    setObjectName(QStringLiteral("helpWindow"));
    setModal(false);
    resize(1000, 680);
    m_list->setFixedWidth(listWidth);
    m_list->setProperty("roomy", true);
    m_browser->setOpenLinks(false);
    m_browser->document()->setDocumentMargin(textMargin);
    m_search->setClearButtonEnabled(true);
    m_search->setFixedWidth(listWidth);
    auto *side = inColumn(styleSpacing, {m_search, {m_list, 1}});
    auto *row = inRow(styleSpacing, {side, {m_browser, 1}});
    m_notFound->setProperty("tone", QStringLiteral("bad"));
    m_notFound->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto *foot = inRow(styleSpacing, {{m_notFound, 1}, m_save, m_close});
    inColumn(this, styleMargins, styleSpacing, {{row, 1}, foot});
    connect(m_list, &QListWidget::currentRowChanged, this, &HelpWindow::showRow);
    // While typing, the search starts at the current match.
    connect(m_search, &QLineEdit::textEdited, this, [this](const QString &words) {
        QTextCursor from = m_browser->textCursor();
        from.setPosition(from.selectionStart());
        m_browser->setTextCursor(from);
        sayWhether(words.isEmpty() || find(words), words);
    });
    connect(m_search, &QLineEdit::returnPressed, this,
            [this] { sayWhether(m_search->text().isEmpty() || find(m_search->text()), m_search->text()); });
    connect(m_save, &QPushButton::clicked, this, &HelpWindow::saveValidation);
    connect(m_close, &QPushButton::clicked, this, &QWidget::close);
    retranslate();
}

std::optional<std::size_t> HelpWindow::pageAt(int row) const {
    const QListWidgetItem *item = m_list->item(row);
    const QVariant page = item ? item->data(pageRole) : QVariant();
    return page.isValid() ? std::optional(page.value<std::size_t>()) : std::nullopt;
}

void HelpWindow::goTo(std::size_t page) {
    for (int row = 0; row < m_list->count(); ++row) {
        if (pageAt(row) == page)
            m_list->setCurrentRow(row);
    }
}

void HelpWindow::showRow(int row) {
    const auto index = pageAt(row);
    if (!index)
        return;
    HelpPage &page = m_pages[*index];
    m_save->setVisible(page.id == u"validation");
    if (page.id == u"validation" && page.content.blocks.empty()) {
        if (!m_validated)
            m_validated = validateFiles(quickReferenceFiles());
        page.content = composeValidation(*m_validated, windowLanguage());
    }
    m_browser->setHtml(reportHtml(page.content));
}

void HelpWindow::saveValidation() {
    const QString path = askForPdf(this, tr("Save the validation document"), QStringLiteral("validation"));
    if (path.isEmpty())
        return;
    m_save->setEnabled(false);
    m_lane.start([](const Background::Job &) { return validateFiles(allReferenceFiles()); },
                 [this, path](std::vector<SetValidation> sets) {
                     m_save->setEnabled(true);
                     try {
                         QBuffer pdf;
                         pdf.open(QIODevice::WriteOnly);
                         writePdf(composeValidationDocument(sets, windowLanguage()), pdf);
                         saveBytes(pdf.data(), path);
                         saySaved(this, path);
                     } catch (const Error &error) {
                         QMessageBox::warning(this, tr("The document was not saved"),
                                              windowLanguage().sentence(error.message));
                     }
                     m_validated = std::move(sets);
                     retranslate();
                 });
}

void HelpWindow::showPage(const QString &id, const QString &anchor) {
    const auto found = std::ranges::find(m_pages, id, &HelpPage::id);
    goTo(found == m_pages.end() ? 0 : static_cast<std::size_t>(found - m_pages.begin()));
    if (!anchor.isEmpty())
        m_browser->scrollToAnchor(anchor);
}

QString HelpWindow::currentPage() const {
    const auto page = pageAt(m_list->currentRow());
    return page ? m_pages[*page].id : QString();
}

QString HelpWindow::text() const {
    return m_browser->toPlainText();
}

void HelpWindow::sayWhether(bool found, const QString &words) {
    m_notFound->setText(found ? QString() : tr("“%1” is not found").arg(words));
}

bool HelpWindow::find(const QString &words) {
    if (words.isEmpty())
        return false;
    if (m_browser->find(words))
        return true;
    const std::size_t pages = m_pages.size();
    const std::size_t here = pageAt(m_list->currentRow()).value_or(0);
    for (std::size_t step = 1; step <= pages; ++step) {
        const std::size_t page = (here + step) % pages;
        if (page != here && m_pages[page].id == u"validation")
            continue; // it would have to be computed
        QTextDocument text;
        text.setHtml(reportHtml(m_pages[page].content));
        if (page != here && text.find(words).isNull())
            continue;
        goTo(page);
        m_browser->moveCursor(QTextCursor::Start);
        if (m_browser->find(words))
            return true;
    }
    return false;
}

/// Groups: instructions, then editions by kind of test, then the validation.
void HelpWindow::fillList() {
    m_list->clear();
    const auto groupOf = [](const HelpPage &page) {
        const QString prefix = QStringLiteral("editions.");
        if (!page.id.startsWith(prefix))
            return page.id == u"validation" ? tr("Proof") : tr("Working with Palmer");
        const Edition *edition = findEdition(page.id.mid(prefix.size()).toStdString());
        return edition && edition->circles ? tr("Circular tests") : tr("Positioning of axes");
    };
    QString group;
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        if (groupOf(m_pages[i]) != group) {
            group = groupOf(m_pages[i]);
            auto *title = new QListWidgetItem(group, m_list);
            title->setFlags(Qt::NoItemFlags);
            title->setFont(themeFont(TextSize::head));
            title->setForeground(token(Token::secondaryText, palette())); // not the colour of disabled items
        }
        auto *item = new QListWidgetItem(m_pages[i].title, m_list);
        item->setData(pageRole, QVariant::fromValue(i));
    }
}

void HelpWindow::retranslate() {
    const QString current = currentPage();
    setWindowTitle(tr("Help"));
    m_search->setPlaceholderText(tr("Search, Enter: next place"));
    m_search->setAccessibleName(tr("Search the help"));
    m_list->setAccessibleName(tr("Pages of the help"));
    m_browser->setAccessibleName(tr("Text of the help"));
    m_save->setText(tr("Evaluate all and &save as PDF…"));
    m_close->setText(tr("&Close"));
    m_pages = composeHelp(windowLanguage());
    m_pages.push_back({QStringLiteral("validation"), tr("Validation"), {}});
    {
        const QSignalBlocker quiet(m_list);
        fillList();
    }
    showPage(current);
}

} // namespace palmer::ui
