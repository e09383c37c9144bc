// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/words/message.h"
#include "language/units.h"

#include <QString>
#include <memory>
#include <optional>

class QTranslator;

namespace palmer {

/// A language as a value: texts, numbers, units and dates as French or English readers expect them. Never
/// installed, never global: two languages live side by side (window and report), and threads may share one.
/// Copies are cheap. What is in the sources is the English text; the catalogues are embedded, hence no
/// Language before main().
class Language {
public:
    enum class Id { english, french };

    explicit Language(Id id);
    /// With another catalogue than the embedded one, which is never null.
    Language(Id id, std::shared_ptr<const QTranslator> catalogue);

    /// "en" or "fr"; nothing for any other name.
    [[nodiscard]] static std::optional<Language> fromName(QStringView name);
    /// French for the name of a French locale ("fr", "fr_CH.UTF-8", "fr-CA"), English for all others.
    [[nodiscard]] static Language fromLocale(QStringView localeName);

    [[nodiscard]] Id id() const { return m_id; }
    [[nodiscard]] QString code() const; ///< "en", "fr"
    /// "; " between the members of a list.
    [[nodiscard]] QString semicolon() const {
        return m_id == Id::french ? QStringLiteral("\u202F; ") : QStringLiteral("; ");
    }

    /// The same language with numbers in other units.
    [[nodiscard]] Language withUnits(const DisplayUnits &units) const;
    [[nodiscard]] const DisplayUnits &units() const { return m_units; }

    /// The translation of a text of the catalogue; the source where there is none.
    [[nodiscard]] QString text(const Text &text) const;
    /// Whether the text reads well in this language. Of the English texts only those that are written with
    /// "(s)" need a translation.
    [[nodiscard]] bool hasTranslation(const Text &text) const;
    /// The sentence of a message, arguments put in. All places are filled at once: a `%2` inside an argument
    /// stays as it is, and so does a place without argument.
    [[nodiscard]] QString sentence(const Message &message) const;

    /// The number alone, in the unit the quantity is shown in, rounded half to even on its shortest decimal;
    /// `decimals` < 0: all its digits; counted in the default unit of the quantity. A dash for NaN, which
    /// stands for "none".
    [[nodiscard]] QString number(double value, Quantity quantity, int decimals = -1) const;
    /// An expanded uncertainty: as number(), but rounded up where rounding down would lose more than 5 %.
    [[nodiscard]] QString uncertainty(double value, Quantity quantity, int decimals) const;
    /// Number and unit, joined as the language does.
    [[nodiscard]] QString quantity(double value, Quantity quantity, int decimals = -1) const;
    /// "µm", "mm", "″", …; empty for a number without unit.
    [[nodiscard]] QString unit(Quantity quantity) const;
    /// "20 novembre 2026", "20 November 2026"; a dash for none. `iso` is YYYY-MM-DD; what is no date is
    /// returned as it stands.
    [[nodiscard]] QString date(const std::string &iso) const;
    /// The same where there is little room: "20 nov. 2026", "20 Nov 2026".
    [[nodiscard]] QString shortDate(const std::string &iso) const;

private:
    [[nodiscard]] QString shown(const std::string &decimal) const;
    [[nodiscard]] QString argument(const Argument &argument) const;

    Id m_id;
    DisplayUnits m_units;
    std::shared_ptr<const QTranslator> m_catalogue;
};

} // namespace palmer
