// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/evaluation/iso230_4/contouringfeed.h"

#include "kernel/words/quantity.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QDialog>
#include <vector>

namespace palmer::ui {

class Field;

/// "Contouring feed…": the feed for a circle of another diameter (ISO 230-4, annex C), computed during
/// typing. Starts with the example of the annex. Changes no document.
class FeedDialog : public Translated<QDialog> {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(FeedDialog)

public:
    explicit FeedDialog(QWidget *parent = nullptr);
    /// Hides first, so that a focused field commits its text while the dialog still exists.
    ~FeedDialog() override { hide(); }

    /// Shows these numbers, except those not above 0.
    void setNumbers(const iso230_4::ContouringFeed &numbers);

private:
    struct NumberField {
        Field *field = nullptr;
        Quantity quantity = Quantity::number;
        double iso230_4::ContouringFeed::*member = nullptr;
    };

    Field *addNumber(const char *name, Quantity quantity, double iso230_4::ContouringFeed::*member);
    void showFeed();
    void retranslate() final;

    std::vector<NumberField> m_fields;
    iso230_4::ContouringFeed m_numbers;
    Field *m_specifiedDiameter;
    Field *m_specifiedFeed;
    Field *m_diameter;
    QLabel *m_feedLabel;
    QLabel *m_feed;
    QLabel *m_formula;
    QDialogButtonBox *m_buttons;
};

} // namespace palmer::ui
