// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "language/language.h"

#include <QWidget>
#include <array>

class QLabel;

namespace palmer::ui {

/// The line below the readings page: key hints, and on the right the drift of the test, D compared with R
/// (notes tell if it is more than chance).
class KeyHints : public QWidget {
    Q_OBJECT

public:
    explicit KeyHints(QWidget *parent = nullptr);

    void show(const EvaluatedDocument &evaluated, std::size_t test);
    void setLanguage(const Language &language);

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void retranslate();
    void showDrift();
    void fit();

    struct Hint {
        QLabel *key = nullptr;
        QLabel *text = nullptr;
    };

    EvaluatedDocument m_evaluated;
    std::size_t m_test = 0;
    Language m_language{Language::Id::english};
    std::array<Hint, 4> m_hints{};
    QLabel *m_drift;
};

} // namespace palmer::ui
