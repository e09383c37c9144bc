// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/field.h"

#include <QString>
#include <QStringList>
#include <map>

namespace palmer::ui {

/// Refused texts of fields that show something else for a while: another test, another arc. They come back
/// with what they were typed for.
class RefusedFields {
public:
    /// `of`: what the field showed.
    void keep(const QString &of, const Field &field) {
        if (field.isRefused())
            m_texts[{of, field.edit()->objectName()}] = field.text();
    }
    /// Into a field that shows the value of `of`.
    void giveBack(const QString &of, Field &field) {
        const auto found = m_texts.find({of, field.edit()->objectName()});
        if (found == m_texts.end())
            return;
        field.refuse(found->second);
        m_texts.erase(found);
    }
    [[nodiscard]] QStringList texts() const {
        QStringList all;
        for (const auto &[place, text] : m_texts)
            all << text;
        return all;
    }

private:
    std::map<std::pair<QString, QString>, QString> m_texts;
};

} // namespace palmer::ui
