// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/forms/field.h"

#include <QString>
#include <QStringList>
#include <map>

namespace palmer::ui {

/// Keeps refused texts of fields that now show another test or arc, and restores them with the one they were
/// typed for.
class RefusedFields {
public:
    /// `of`: what the field showed.
    void keep(const QString &of, const Field &field) {
        if (field.isRefused())
            m_texts[{of, field.edit()->objectName()}] = field.text();
    }
    /// Restores the text of `of` in a field that shows its value again.
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
