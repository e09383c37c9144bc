// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <compare>
#include <cstddef>
#include <map>
#include <string>

namespace palmer::ui {

/// Texts typed into cells that the document cannot accept. They stay in their cells in red, with the reason,
/// until the cell is typed again, so that no typing is lost silently. Kept by test, so that switching tests
/// removes none.
class RefusedTexts {
public:
    struct Cell {
        std::size_t row = 0;
        std::size_t column = 0;

        // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14 at every default <=>
        auto operator<=>(const Cell &) const = default;
    };
    struct Refused {
        QString text;
        QString reason;
    };

    void put(const std::string &test, const Cell &cell, const QString &text, const QString &reason) {
        m_texts[test][cell] = {text, reason};
    }
    void remove(const std::string &test, const Cell &cell) {
        const auto found = m_texts.find(test);
        if (found != m_texts.end())
            found->second.erase(cell);
    }
    /// Removes the texts for which `isGone(cell)` is true: their cell no longer exists or changed.
    template <class Gone>
    void removeIf(const std::string &test, const Gone &isGone) {
        const auto found = m_texts.find(test);
        if (found != m_texts.end())
            std::erase_if(found->second, [&](const auto &entry) { return isGone(entry.first); });
    }

    /// Null if there is none.
    [[nodiscard]] const Refused *find(const std::string &test, const Cell &cell) const {
        const auto found = m_texts.find(test);
        if (found == m_texts.end())
            return nullptr;
        const auto refused = found->second.find(cell);
        return refused == found->second.end() ? nullptr : &refused->second;
    }
    /// All refused texts of all tests.
    [[nodiscard]] QStringList texts() const {
        QStringList all;
        for (const auto &[test, cells] : m_texts) {
            for (const auto &[cell, refused] : cells)
                all << refused.text;
        }
        return all;
    }

private:
    std::map<std::string, std::map<Cell, Refused>> m_texts;
};

} // namespace palmer::ui
