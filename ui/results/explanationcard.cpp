// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/explanationcard.h"

#include "report/explanations/explanation.h"
#include "ui/elidedlabel.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/results/explanationview.h"
#include "ui/results/targetbarsview.h"
#include "ui/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

namespace palmer::ui {

namespace {

constexpr int barsWidth = 180;

} // namespace

ExplanationCard::ExplanationCard(Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_selection(selection)
    , m_name(made<ElidedLabel>("explanationName", this))
    , m_source(made<QLabel>("explanationSource", trait::secondary, this))
    , m_keys(made<QLabel>(trait::secondary, this))
    , m_copy(made<QToolButton>("copyExplanation", trait::iconOnly, trait::strongFocus, this))
    , m_close(made<QToolButton>("closeExplanation", trait::iconOnly, trait::strongFocus, this))
    , m_view(made<ExplanationView>("explanation", this))
    , m_bars(new TargetBarsView(selection, this)) {
    setObjectName(QStringLiteral("explanationCard"));
    m_copy->setIcon(lineIcon(QStringLiteral("copy")));
    m_close->setIcon(lineIcon(QStringLiteral("close")));
    m_bars->setFixedWidth(barsWidth);
    connect(m_copy, &QToolButton::clicked, this, &ExplanationCard::copy);
    connect(m_close, &QToolButton::clicked, this, [this] { m_selection.setParameter({}); });

    auto *head = inRow(8, {{m_name, 1}, m_copy, m_close});
    auto *body = inRow(20, {{m_view, 1, Qt::AlignTop}, m_bars});
    auto *foot = inRow(styleSpacing, {m_source, Placed::stretch(), m_keys});
    inColumn(this, {pageMargin, 2, pageMargin, 2}, 1,
             {head, {body, 1}, foot}); // no higher than the target card

    connect(&selection, &Selection::parameterChanged, this, &ExplanationCard::refresh);
    retranslate();
}

void ExplanationCard::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    refresh();
}

void ExplanationCard::setLanguage(const Language &language) {
    m_language = language;
    refresh();
}

void ExplanationCard::refresh() {
    const auto shown = explanation(m_evaluated, m_test, m_selection.parameter().toStdString(), m_language);
    m_view->setVisible(shown.has_value());
    m_copy->setEnabled(shown.has_value());
    if (!shown) {
        m_name->clear();
        m_source->clear();
        m_bars->setBars({}, {});
        return;
    }
    m_name->setText(shown->symbol.plain() + QStringLiteral("   ") + shown->name);
    m_view->setExplanation(*shown);
    m_view->setAccessibleName(tr("Explanation of %1").arg(shown->symbol.plain()));
    m_source->setText(shown->source);
    if (shown->bars)
        m_bars->setBars(shown->bars, tr("per target, %1").arg(shown->bars->unit));
    else
        m_bars->setBars({}, {});
}

void ExplanationCard::copy() {
    QGuiApplication::clipboard()->setText(m_name->text() + u'\n' + m_view->plainText() + u'\n' +
                                          m_source->text() + u'\n');
    emit said(tr("Explanation copied"));
}

void ExplanationCard::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.fillRect(QRect(0, 0, width(), 1), token(Token::explanation, palette()));
}

void ExplanationCard::keyPressEvent(QKeyEvent *event) {
    if (event->key() == Qt::Key_Escape)
        m_selection.setParameter({});
    else
        QWidget::keyPressEvent(event);
}

void ExplanationCard::retranslate() {
    m_name->setFont(themeFont(TextSize::head));
    m_source->setFont(themeFont(TextSize::small));
    m_keys->setFont(themeFont(TextSize::tiny));
    m_keys->setText(tr("Esc closes · ↑↓ next result"));
    nameWidget(*m_copy, tr("Copy the explanation as text"));
    m_close->setToolTip(tr("Close the explanation (Esc)"));
    m_close->setAccessibleName(tr("Close the explanation"));
    refresh();
}

} // namespace palmer::ui
