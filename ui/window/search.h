// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <vector>

namespace palmer::ui {

/// Groups of what can be found, in the order of display.
enum class SearchGroup { fields, results, findings, settings };

/// Something that can be found: what it is called, what it says, where it is, and how to get there.
struct SearchEntry {
    SearchGroup group = SearchGroup::fields;
    QString name;
    QString value;
    QString place;
    std::function<void()> go;
    bool isMissing = false; ///< required and not stated
};

/// An entry with the place of the words in its name; `begin` −1: they are in its value or place only.
struct SearchHit {
    SearchEntry entry;
    qsizetype begin = -1;
    qsizetype length = 0;
};

/// The text without case and accents, letter by letter.
[[nodiscard]] QString folded(const QString &text);

/// Returns the entries that contain what was typed, by group; those that begin with it first, then those that
/// have it in their name. Nothing for a blank text.
[[nodiscard]] std::vector<SearchHit> search(const std::vector<SearchEntry> &entries, const QString &typed);

} // namespace palmer::ui
