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

/// Texts typed into cells that the document cannot take. They stay in red where they were typed, with the
/// reason, until the cell is typed anew: nothing typed goes in silence. By test, so that another test in view
/// takes none away.
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
    /// Removes those of which `isGone(cell)` says that their cell is another now.
    template <class Gone>
    void removeIf(const std::string &test, const Gone &isGone) {
        const auto found = m_texts.find(test);
        if (found != m_texts.end())
            std::erase_if(found->second, [&](const auto &entry) { return isGone(entry.first); });
    }

    /// Null: none.
    [[nodiscard]] const Refused *find(const std::string &test, const Cell &cell) const {
        const auto found = m_texts.find(test);
        if (found == m_texts.end())
            return nullptr;
        const auto refused = found->second.find(cell);
        return refused == found->second.end() ? nullptr : &refused->second;
    }
    /// All of them, of all tests.
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
