// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/keyhints.h"

#include "kernel/evaluation/resultsof.h"
#include "language/decimals.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QEvent>
#include <QKeySequence>
#include <QLabel>

namespace palmer::ui {

namespace {

constexpr int lineHeight = 34;

} // namespace

KeyHints::KeyHints(QWidget *parent)
    : QWidget(parent)
    , m_drift(made<QLabel>("drift", TextSize::small, this)) {
    setObjectName(QStringLiteral("keyHints"));
    setFixedHeight(lineHeight);
    auto *row = inRow(this, {pageMargin, 0, pageMargin, 0}, 6, {});
    for (Hint &hint : m_hints) {
        hint = {made<QLabel>(TextSize::tiny, this), made<QLabel>(TextSize::small, trait::secondary, this)};
        hint.key->setProperty("keycap", true);
        row->addWidget(hint.key, 0, Qt::AlignVCenter);
        row->addWidget(hint.text);
        row->addSpacing(6);
    }
    row->addStretch();
    row->addWidget(m_drift);
    retranslate();
}

void KeyHints::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    showDrift();
}

void KeyHints::setLanguage(const Language &language) {
    m_language = language;
    showDrift();
}

void KeyHints::showDrift() {
    const auto *measurement = measured<PositioningMeasurement>(m_evaluated, m_test);
    const PositioningResults *results =
        measurement ? &resultsOf(*measurement, *m_evaluated.tests[m_test]) : nullptr;
    m_drift->setVisible(results && results->drift);
    if (!results || !results->drift) {
        m_drift->clear();
        fit();
        return;
    }
    const DriftStatistic &drift = *results->drift;
    const QString change = m_language.quantity(drift.change, deviationQuantity(measurement->axis), 1);
    const bool steady = drift.significant();
    m_drift->setText((steady ? QStringLiteral("⚠ ") : QString()) + tr("Drift D %1").arg(change));
    m_drift->setProperty("secondary", !steady);
    m_drift->setToolTip(
        steady ? tr("Steady progression from the first to the last run (t = %1): the thermal conditions may "
                    "be unstable")
                     .arg(m_language.number(drift.t, Quantity::number, 1))
               : tr("From the first to the last run; no more than chance (t = %1)")
                     .arg(m_language.number(drift.t, Quantity::number, 1)));
    fit();
}

/// Hides hints that do not fit, from the right.
void KeyHints::fit() {
    int left = width() - 2 * pageMargin - (m_drift->text().isEmpty() ? 0 : m_drift->sizeHint().width() + 12);
    for (const Hint &hint : m_hints) {
        left -= hint.key->sizeHint().width() + hint.text->sizeHint().width() + 24;
        hint.key->setVisible(left >= 0);
        hint.text->setVisible(left >= 0);
    }
}

void KeyHints::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showDrift();
    }
    QWidget::changeEvent(event);
}

void KeyHints::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    fit();
}

void KeyHints::retranslate() {
    m_hints[0].key->setText(tr("Enter", "key"));
    m_hints[0].text->setText(tr("follows the cycle"));
    m_hints[1].key->setText(tr("Tab", "key"));
    m_hints[1].text->setText(tr("to the right"));
    m_hints[2].key->setText(QStringLiteral("F2"));
    m_hints[2].text->setText(tr("edits"));
    m_hints[3].key->setText(QKeySequence(QKeySequence::Paste).toString(QKeySequence::NativeText));
    m_hints[3].text->setText(tr("pastes"));
    setAccessibleName(tr("Keys"));
}

} // namespace palmer::ui
