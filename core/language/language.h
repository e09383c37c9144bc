// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"
#include "language/units.h"

#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QTranslator;

namespace palmer {

/// A language as a value: texts, numbers, units and dates as French or English readers expect them. Never
/// installed or global: two languages can coexist (window and report), and threads may share one. Copies are
/// cheap. The sources contain the English text; the catalogues are embedded, hence no Language before main().
class Language {
public:
    enum class Id { english, french };

    explicit Language(Id id);
    /// Uses a catalogue other than the embedded one; must not be null.
    Language(Id id, std::shared_ptr<const QTranslator> catalogue);

    /// Returns the language "en" or "fr"; null for any other name.
    [[nodiscard]] static std::optional<Language> fromName(QStringView name);
    /// Returns French for a French locale ("fr", "fr_CH.UTF-8", "fr-CA"), English for all others.
    [[nodiscard]] static Language fromLocale(QStringView localeName);

    [[nodiscard]] Id id() const { return m_id; }
    [[nodiscard]] QString code() const; ///< "en", "fr"
    /// Returns the separator between list members: "; ".
    [[nodiscard]] QString semicolon() const {
        return m_id == Id::french ? QStringLiteral("\u202F; ") : QStringLiteral("; ");
    }

    /// Returns the same language with numbers in other units.
    [[nodiscard]] Language withUnits(const DisplayUnits &units) const;
    [[nodiscard]] const DisplayUnits &units() const { return m_units; }

    /// Returns the translation of a text in the catalogue, or the source if there is none.
    [[nodiscard]] QString text(const Text &text) const;
    /// True if the text is readable in this language. English texts need a translation only if written with
    /// "(s)".
    [[nodiscard]] bool hasTranslation(const Text &text) const;
    /// Returns the sentence of a message with its arguments. All placeholders are replaced at once: a `%2`
    /// inside an argument is kept, and so is a placeholder without argument.
    [[nodiscard]] QString sentence(const Message &message) const;
    [[nodiscard]] QString sentence(const Text &text, std::vector<Argument> arguments) const {
        return sentence(Message{text, std::move(arguments)});
    }

    /// Returns the number only, in the unit shown for the quantity, rounded half to even on its shortest
    /// decimal; `decimals` refers to the default unit of the quantity, < 0: all digits. A dash for NaN, which
    /// means "none".
    [[nodiscard]] QString number(double value, Quantity quantity, int decimals = -1) const;
    [[nodiscard]] QString count(std::integral auto value) const {
        return number(static_cast<double>(value), Quantity::count, 0);
    }
    /// For an expanded uncertainty: like number(), but rounded up if rounding down would lose more than 5 %.
    [[nodiscard]] QString uncertainty(double value, Quantity quantity, int decimals) const;
    /// Returns number and unit, joined as usual in the language.
    [[nodiscard]] QString quantity(double value, Quantity quantity, int decimals = -1) const;
    /// Returns "µm", "mm", "″", …; empty for a number without unit.
    [[nodiscard]] QString unit(Quantity quantity) const;
    /// Returns a standard after a preposition: "ISO 230-2:2006", "l’ISO 230-2:2006".
    [[nodiscard]] QString designation(const std::string &word) const;
    /// Returns a text in the quotation marks of the language.
    [[nodiscard]] QString quoted(const std::string &text) const;
    /// Returns "20 novembre 2026", "20 November 2026"; a dash if empty. `iso` is YYYY-MM-DD; other texts are
    /// returned unchanged.
    [[nodiscard]] QString date(const std::string &iso) const;
    /// The same for narrow places: "20 nov. 2026", "20 Nov 2026".
    [[nodiscard]] QString shortDate(const std::string &iso) const;

private:
    [[nodiscard]] QString shown(const std::string &decimal) const;
    [[nodiscard]] QString argument(const Argument &argument) const;

    Id m_id;
    DisplayUnits m_units;
    std::shared_ptr<const QTranslator> m_catalogue;
};

} // namespace palmer
