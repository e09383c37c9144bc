// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/feeddialog.h"

#include "language/decimals.h"
#include "language/entry.h"
#include "ui/forms/field.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>

namespace palmer::ui {

namespace {

constexpr int feedDialogWidth = 320;
constexpr iso230_4::ContouringFeed exampleOfTheAnnex{100, 500, 125};

} // namespace

FeedDialog::FeedDialog(QWidget *parent)
    : Translated(parent)
    , m_numbers(exampleOfTheAnnex)
    , m_specifiedDiameter(
          addNumber("specifiedDiameter", Quantity::position, &iso230_4::ContouringFeed::specifiedDiameter))
    , m_specifiedFeed(addNumber("specifiedFeed", Quantity::feed, &iso230_4::ContouringFeed::specifiedFeed))
    , m_diameter(addNumber("diameter", Quantity::position, &iso230_4::ContouringFeed::diameter))
    , m_feedLabel(new QLabel(this))
    , m_feed(made<QLabel>("feed", this))
    , m_formula(made<QLabel>(trait::secondary, this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Close, this)) {
    setObjectName(QStringLiteral("feedDialog"));
    m_feed->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_feed->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_buttons->button(QDialogButtonBox::Close)->setAutoDefault(false); // Enter belongs to the fields

    auto *result = inRow(styleSpacing, {m_feedLabel, {m_feed, 1}});
    inColumn(
        this, {pageMargin, pageMargin, pageMargin, pageMargin}, pageMargin,
        {m_specifiedDiameter, m_specifiedFeed, m_diameter, result, m_formula, m_buttons, Placed::stretch()});
    setMinimumWidth(feedDialogWidth);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    retranslate();
}

Field *FeedDialog::addNumber(const char *name, Quantity quantity, double iso230_4::ContouringFeed::*member) {
    auto *field = new Field(Field::Kind::number, this);
    field->edit()->setObjectName(QLatin1StringView(name));
    field->setReader([quantity](const QString &typed) -> Field::Reading {
        const NumberEntry entry = enteredNumber(typed, quantity, windowLanguage().units());
        if (entry.refusal)
            return {{}, windowLanguage().text(*entry.refusal)};
        if (!entry.value)
            return {{}, tr("a number is needed")};
        if (!(*entry.value > 0))
            return {{}, tr("not greater than 0")};
        return {windowLanguage().number(certain(*entry.value), quantity), {}};
    });
    connect(field, &Field::entered, this, [this, field, quantity, member] {
        const auto value = enteredNumber(field->valueText(), quantity, windowLanguage().units()).value;
        m_numbers.*member = value.value_or(m_numbers.*member);
        showFeed();
    });
    m_fields.push_back({field, quantity, member});
    return field;
}

void FeedDialog::setNumbers(const iso230_4::ContouringFeed &numbers) {
    for (const NumberField &each : m_fields) {
        if (numbers.*each.member > 0)
            m_numbers.*each.member = numbers.*each.member;
    }
    showFeed();
}

void FeedDialog::showFeed() {
    for (const NumberField &each : m_fields)
        each.field->show(windowLanguage().number(m_numbers.*each.member, each.quantity), false);
    const auto feed = iso230_4::contouringFeed(m_numbers);
    m_feed->setText(feed ? windowLanguage().quantity(*feed, Quantity::feed, feedDecimals(*feed))
                         : QStringLiteral("–"));
}

void FeedDialog::retranslate() {
    setWindowTitle(tr("Contouring feed"));
    m_specifiedDiameter->setLabel(tr("Specified diameter d₂"));
    m_specifiedFeed->setLabel(tr("Specified feed V₂"));
    m_diameter->setLabel(tr("Diameter of the test d₁"));
    for (const NumberField &each : m_fields)
        each.field->setUnit(windowLanguage().unit(each.quantity));
    m_feedLabel->setText(tr("Feed of the test V₁"));
    m_feedLabel->setFont(themeFont(TextSize::head));
    m_feed->setFont(themeFont(TextSize::head));
    m_feed->setAccessibleName(m_feedLabel->text());
    m_formula->setFont(themeFont(TextSize::small));
    m_formula->setText(QStringLiteral("V₁ = V₂·√(d₁/d₂)   ") + tr("ISO 230-4, annex C"));
    m_buttons->button(QDialogButtonBox::Close)->setText(tr("Close"));
    showFeed();
}

} // namespace palmer::ui
