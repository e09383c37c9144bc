// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proof/verification.h"
#include "ui/qtforward.h"
#include "ui/translated.h"

#include <QFrame>
#include <optional>

namespace palmer::ui {

/// Bar above a document opened from a report: says if the report follows from its data, or lists differences.
class ReportBar : public Translated<QFrame> {
    Q_OBJECT

public:
    explicit ReportBar(QWidget *parent = nullptr);

    void showResult(const Verification &verification);
    /// For a report whose pages cannot be read.
    void showProblem(const Message &sentence);
    /// `edited`: the window no longer shows the verified data. The bar then says so; details keep the result.
    void setEdited(bool edited);

    [[nodiscard]] QString sentence() const;
    [[nodiscard]] QStringList lines() const;

private:
    void retranslate() final;

    QLabel *m_sentence;
    QListWidget *m_list;
    QPushButton *m_details;
    QPushButton *m_close;
    std::optional<Verification> m_verification;
    std::optional<Message> m_problem;
    bool m_edited = false;
};

} // namespace palmer::ui
