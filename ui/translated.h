// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>

namespace palmer::ui {

/// A widget that sets its texts anew when the language of the window changes, or after one of `others`.
template <class Base, QEvent::Type... others>
class Translated : public Base {
public:
    using Base::Base;

protected:
    /// Sets all texts in the language of the window.
    virtual void retranslate() = 0;

    void changeEvent(QEvent *event) override {
        if (event->type() == QEvent::LanguageChange || (... || (event->type() == others)))
            retranslate();
        Base::changeEvent(event);
    }
};

} // namespace palmer::ui
