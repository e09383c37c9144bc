// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"
#include "kernel/words/message.h"
#include "kernel/words/text.h"
#include "tables/choice.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palmer {

/// What the user has chosen for an import: key → word, as after --set and in a profile.
using ImportOptions = std::map<std::string, std::string, std::less<>>;

/// A word that a choice can have, and what it is called.
struct ImportWord {
    const char *word = nullptr;
    Text name;
};

enum class ImportValue { word, number, text };

/// A choice that importers know.
struct ImportKey {
    const char *key = nullptr;
    Text name;
    ImportValue value = ImportValue::word;
    std::span<const ImportWord> words = {}; ///< of `word`
};

/// All of them, in the order they are shown in.
[[nodiscard]] std::span<const ImportKey> importKeys();
[[nodiscard]] const ImportKey *findImportKey(std::string_view key);

/// What a choice is called, and a word it can have: in sentences, which know no keys.
[[nodiscard]] Argument nameOfChoice(std::string_view key);
[[nodiscard]] Argument nameOfWord(std::string_view key, std::string_view word);

/// Throws Error(content) for a key or word that is unknown, with those that are known.
void demandKnown(const ImportOptions &options);

/// A choice as it stands after reading: to be shown, confirmed or changed.
struct ImportChoice {
    std::string key;
    std::string value;
    Origin origin = Origin::recognised;

    bool operator==(const ImportChoice &) const = default;
};

/// The choices of one reading: what the user chose wins, else what was found.
class Choices {
public:
    /// `usual` holds where neither the user nor the file says anything: the units that a window shows.
    explicit Choices(ImportOptions options, ImportOptions usual = {})
        : m_options(std::move(options))
        , m_usual(std::move(usual)) {}

    [[nodiscard]] const ImportOptions &options() const { return m_options; }
    [[nodiscard]] bool isChosen(std::string_view key) const;
    /// What the user chose for it, empty if nothing.
    [[nodiscard]] std::string_view chosen(std::string_view key) const;
    [[nodiscard]] std::optional<double> chosenNumber(std::string_view key) const;

    /// What is usual for it, empty if nothing.
    [[nodiscard]] std::string_view usual(std::string_view key) const;

    /// Settles a choice: the user's, or what was found; remembers it.
    Choice<std::string> settle(std::string_view key, std::string_view found, Origin origin);
    Choice<double> settleNumber(std::string_view key, double found, Origin origin);
    /// Under which a test of the kind is read: the default unless one is chosen. Throws Error(content) when
    /// that is one of another kind.
    std::string settleEdition(Kind kind);

    [[nodiscard]] std::vector<ImportChoice> take() { return std::move(m_settled); }

private:
    void remember(std::string_view key, std::string value, Origin origin);

    ImportOptions m_options;
    ImportOptions m_usual;
    std::vector<ImportChoice> m_settled;
};

} // namespace palmer
