// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/proof/reportbar.h"

#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/windowlanguage.h"

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QStyle>
#include <algorithm>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int mostLines = 6; ///< visible at once

} // namespace

ReportBar::ReportBar(QWidget *parent)
    : Translated(parent)
    , m_sentence(made<QLabel>("reportSentence", trait::wrapped, trait::plainText, this))
    , m_list(made<QListWidget>("reportDifferences", trait::wrapped, this))
    , m_details(made<QPushButton>("reportDetails", trait::checkable, this))
    , m_close(made<QPushButton>("closeReportBar", this)) {
    setObjectName(QStringLiteral("reportBar"));
    setProperty("notice", true);
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    auto *row = inRow(8, {{m_sentence, 1}, m_details, m_close});
    inColumn(this, {pageMargin, 6, pageMargin, 6}, styleSpacing, {row, m_list});
    connect(m_details, &QPushButton::toggled, m_list, &QWidget::setVisible);
    connect(m_close, &QPushButton::clicked, this, &QWidget::hide);
    hide();
}

void ReportBar::showResult(const Verification &verification) {
    m_verification = verification;
    m_problem.reset();
    m_details->setChecked(!verification.follows());
    m_list->setVisible(!verification.follows());
    retranslate();
    show();
}

void ReportBar::showProblem(const Message &sentence) {
    m_verification.reset();
    m_problem = sentence;
    m_details->setChecked(false);
    m_list->hide();
    retranslate();
    show();
}

void ReportBar::setEdited(bool edited) {
    if (std::exchange(m_edited, edited) != edited)
        retranslate();
}

QString ReportBar::sentence() const {
    return m_sentence->text();
}

QStringList ReportBar::lines() const {
    QStringList result;
    for (int i = 0; i < m_list->count(); ++i)
        result << m_list->item(i)->text();
    return result;
}

void ReportBar::retranslate() {
    const Language &language = windowLanguage();
    m_details->setText(tr("&Details"));
    m_close->setText(tr("&Close"));
    m_list->setAccessibleName(tr("Differences of the report"));
    m_list->clear();
    m_details->setVisible(m_verification.has_value());
    if (m_problem)
        m_sentence->setText(QStringLiteral("⚠ ") +
                            tr("The report was not verified: %1").arg(language.sentence(*m_problem)));
    if (m_verification) {
        QStringList lines = verificationText(*m_verification, language).trimmed().split(u'\n');
        const QString sign = m_verification->follows() ? QStringLiteral("✓ ") : QStringLiteral("⚠ ");
        const QString head = m_verification->follows() ? tr("Report verified.") : tr("Report NOT verified.");
        const QString result = sign + head + u' ' + lines.takeFirst();
        m_sentence->setText(
            m_edited ? QStringLiteral("⚠ ") +
                           tr("Edited since: the window no longer shows what was verified in the report.")
                     : result);
        if (m_edited)
            m_list->addItem(result);
        for (const QString &line : lines)
            m_list->addItem(line.trimmed());
        const int seen = std::min(m_list->count(), mostLines);
        m_list->setFixedHeight(seen * (m_list->fontMetrics().height() + 2) + 2 * m_list->frameWidth() + 4);
    }
    const bool good = m_verification && m_verification->follows() && !m_edited;
    setProperty("notice", good ? QStringLiteral("good") : QStringLiteral("true"));
    style()->unpolish(this); // applies the changed property
    style()->polish(this);
    setAccessibleName(m_sentence->text());
}

} // namespace palmer::ui
