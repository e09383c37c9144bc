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

struct Edition;

/// The user's choices for an import: key → word, as for --set and in profiles.
using ImportOptions = std::map<std::string, std::string, std::less<>>;

/// A word that a choice can have, and its displayed name.
struct ImportWord {
    const char *word = nullptr;
    Text name;
    std::optional<Kind> kind = {}; ///< of the only tests that it fits; null: of all
};

enum class ImportValue { word, number, text };

/// Whether a guess of a choice is a question.
enum class Asked {
    never, ///< a wrong one changes no number and no direction
    guess,
    owed,  ///< not stated, or stated as a unit that cannot be used: then only the user can answer
    doubt, ///< about the numbers, answered by confirming them
};

/// A choice known to importers.
struct ImportKey {
    const char *key = nullptr;
    Text name;
    ImportValue value = ImportValue::word;
    std::span<const ImportWord> words = {}; ///< if `value` is `word`
    Asked asked = Asked::never;
};

/// All keys, in display order.
[[nodiscard]] std::span<const ImportKey> importKeys();
[[nodiscard]] const ImportKey *findImportKey(std::string_view key);

/// Names of a choice and of its word for sentences, which do not show keys.
[[nodiscard]] Argument nameOfChoice(std::string_view key);
[[nodiscard]] Argument nameOfWord(std::string_view key, std::string_view word);

/// Throws Error(content) for an unknown key or word, listing the known ones.
void requireKnown(const ImportOptions &options);

/// A choice after reading, to be shown, confirmed or changed.
struct ImportChoice {
    std::string key;
    std::string value;
    Origin origin = Origin::recognised;

    bool operator==(const ImportChoice &) const = default;
};

/// The choices of one reading: the user's take precedence over what was found.
class Choices {
public:
    /// `usual` applies if neither the user nor the file states anything: the units shown in a window.
    explicit Choices(ImportOptions options, ImportOptions usual = {})
        : m_options(std::move(options))
        , m_usual(std::move(usual)) {}

    [[nodiscard]] const ImportOptions &options() const { return m_options; }
    [[nodiscard]] bool isChosen(std::string_view key) const;
    /// The user's choice, empty if there is none.
    [[nodiscard]] std::string_view chosen(std::string_view key) const;
    [[nodiscard]] std::optional<double> chosenNumber(std::string_view key) const;

    /// The usual value, empty if there is none.
    [[nodiscard]] std::string_view usual(std::string_view key) const;
    [[nodiscard]] std::optional<double> usualNumber(std::string_view key) const;

    /// Settles and remembers a choice: the user's, otherwise what was found.
    Choice<std::string> resolve(std::string_view key, std::string_view found, Origin origin);
    Choice<double> resolveNumber(std::string_view key, double found, Origin origin);
    /// The edition for reading a test of the kind: the chosen one, otherwise the default. Throws
    /// Error(content) if it is of another kind.
    std::string resolveEdition(Kind kind, const Edition *stated = nullptr);

    [[nodiscard]] std::vector<ImportChoice> take() { return std::move(m_settled); }

private:
    void remember(std::string_view key, std::string value, Origin origin);

    ImportOptions m_options;
    ImportOptions m_usual;
    std::vector<ImportChoice> m_settled;
};

} // namespace palmer
