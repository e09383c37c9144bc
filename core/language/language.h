#pragma once

#include "kernel/words/message.h"

#include <QLocale>
#include <QString>
#include <memory>

class QTranslator;

namespace palmer {

/// A language as a value: texts, numbers, units and dates as French or English readers expect them. Never
/// installed, never global: two languages live side by side (window and report). Copies are cheap.
class Language {
public:
    enum class Id { english, french };

    explicit Language(Id id);

    [[nodiscard]] Id id() const { return m_id; }
    [[nodiscard]] QString code() const; ///< "en", "fr"

    /// The translation of a text of the catalogue.
    [[nodiscard]] QString text(const Text &text) const;
    /// The sentence of a message, arguments put in.
    [[nodiscard]] QString sentence(const Message &message) const;
    /// The number alone, in the unit the quantity is shown in, rounded half to even on its shortest decimal.
    [[nodiscard]] QString number(double value, Quantity quantity, int decimals) const;
    /// Number and unit, joined as the language does.
    [[nodiscard]] QString quantity(double value, Quantity quantity, int decimals = -1) const;
    /// "µm", "mm", "″", …
    [[nodiscard]] QString unit(Quantity quantity) const;
    /// "20 novembre 2026", "20 November 2026"; a dash for none. `iso` is YYYY-MM-DD.
    [[nodiscard]] QString date(const std::string &iso) const;

private:
    Id m_id;
    std::shared_ptr<const QTranslator> m_catalogue;
};

} // namespace palmer
