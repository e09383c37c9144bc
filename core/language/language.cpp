// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/language.h"

#include "language/decimals.h"
#include "language/rounding.h"
#include "language/visibletext.h"
#include "language/withunit.h"

#include <QDate>
#include <QFile>
#include <QLocale>
#include <QTranslator>
#include <algorithm>
#include <array>
#include <tuple>

namespace palmer {
namespace {

constexpr const char *catalogueContext = "report";
constexpr QChar noBreakSpace(u'\u00A0');
constexpr QChar narrowNoBreakSpace(u'\u202F');
constexpr QChar minus(u'\u2212');
constexpr QChar dash(u'\u2013');
constexpr qsizetype groupSize = 3;

QLatin1StringView nameOf(Language::Id id) {
    return id == Language::Id::french ? QLatin1StringView("fr") : QLatin1StringView("en");
}

/// Returns the catalogue of a language, loaded once and never changed: all languages and threads share it.
std::shared_ptr<const QTranslator> catalogue(Language::Id id) {
    const auto load = [](Language::Id language) {
        const QString path =
            QLatin1StringView(":/translations/report_") + nameOf(language) + QLatin1StringView(".qm");
        if (!QFile::exists(path))
            qFatal("The catalogue %s is missing from the program.", qPrintable(path));
        auto translator = std::make_shared<QTranslator>();
        // Qt reports failure for a catalogue without texts (English, as long as nothing is counted).
        std::ignore = translator->load(path);
        return std::shared_ptr<const QTranslator>(std::move(translator));
    };
    if (id == Language::Id::french) {
        static const auto french = load(Language::Id::french);
        return french;
    }
    static const auto english = load(Language::Id::english);
    return english;
}

constexpr std::array months{
    REPORT_TEXT("report", "January"), REPORT_TEXT("report", "February"), REPORT_TEXT("report", "March"),
    REPORT_TEXT("report", "April"),   REPORT_TEXT("report", "May"),      REPORT_TEXT("report", "June"),
    REPORT_TEXT("report", "July"),    REPORT_TEXT("report", "August"),   REPORT_TEXT("report", "September"),
    REPORT_TEXT("report", "October"), REPORT_TEXT("report", "November"), REPORT_TEXT("report", "December"),
};

std::string withoutZeros(std::string decimal) {
    if (decimal.find('.') != std::string::npos)
        decimal.erase(decimal.find_last_not_of('0') + 1);
    if (decimal.ends_with('.'))
        decimal.pop_back();
    return decimal;
}

bool isPlural(QStringView source) {
    return source.contains(QLatin1StringView("%n"));
}

} // namespace

Language::Language(Id id)
    : Language(id, catalogue(id)) {}

Language::Language(Id id, std::shared_ptr<const QTranslator> catalogue)
    : m_id(id)
    , m_catalogue(std::move(catalogue)) {}

std::optional<Language> Language::fromName(QStringView name) {
    for (const Id id : {Id::english, Id::french})
        if (name == nameOf(id))
            return Language(id);
    return std::nullopt;
}

Language Language::fromLocale(QStringView localeName) {
    const auto end =
        std::find_if(localeName.begin(), localeName.end(), [](QChar c) { return !c.isLetter(); });
    const QStringView language = localeName.first(end - localeName.begin());
    return Language(language.compare(nameOf(Id::french), Qt::CaseInsensitive) == 0 ? Id::french
                                                                                   : Id::english);
}

QString Language::code() const {
    return nameOf(m_id);
}

QString Language::text(const Text &text) const {
    const QString translated = m_catalogue->translate(catalogueContext, text.source, text.comment);
    return translated.isNull() ? QString::fromUtf8(text.source) : translated;
}

bool Language::hasTranslation(const Text &text) const {
    if (m_id == Id::english && !isPlural(QString::fromUtf8(text.source)))
        return true;
    return !m_catalogue->translate(catalogueContext, text.source, text.comment, 1).isNull();
}

QString Language::sentence(const Message &message) const {
    const Text &text = message.text;
    QString pattern =
        m_catalogue->translate(catalogueContext, text.source, text.comment, message.count.value_or(-1));
    if (pattern.isNull())
        pattern = QString::fromUtf8(text.source);
    QString result;
    result.reserve(pattern.size() * 2);
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const QChar place = pattern[i] == u'%' && i + 1 < pattern.size() ? pattern[i + 1] : QChar();
        const auto index = static_cast<std::size_t>(place.unicode() - u'1');
        if (place >= u'1' && place <= u'9' && index < message.arguments.size())
            result += argument(message.arguments[index]), ++i;
        else if (place == u'n' && message.count)
            result += number(*message.count, Quantity::count, 0), ++i;
        else
            result += pattern[i];
    }
    return result;
}

QString Language::designation(const std::string &word) const {
    const QString whole = QString::fromStdString(word);
    const QString iso = QStringLiteral("ISO ");
    return whole.startsWith(iso) ? sentence(REPORT_TEXT_FOR("report", "ISO %1", "after a preposition"),
                                            {whole.mid(iso.size()).toStdString()})
                                 : whole;
}

QString Language::quoted(const std::string &text) const {
    return sentence(REPORT_TEXT("report", "“%1”"), {text});
}

QString Language::argument(const Argument &argument) const {
    if (const auto *number = std::get_if<Number>(&argument))
        return quantity(number->value, number->quantity, number->decimals);
    if (const auto *word = std::get_if<Text>(&argument))
        return text(*word);
    if (const auto *day = std::get_if<Date>(&argument))
        return date(day->iso);
    if (const auto *standard = std::get_if<Designation>(&argument))
        return designation(standard->word);
    return visibleText(QString::fromStdString(std::get<std::string>(argument)));
}

QString Language::number(double value, Quantity quantity, int decimals) const {
    const ShownUnit unit = shownUnit(quantity, m_units);
    const Decimal decimal(value, unit);
    if (decimals >= 0)
        return shown(decimal.rounded(std::max(0, decimals + unit.decimals)));
    // A converted number has no natural number of decimals.
    return shown(unit.finest < 0 ? decimal.rounded(-1) : withoutZeros(decimal.rounded(unit.finest)));
}

QString Language::uncertainty(double value, Quantity quantity, int decimals) const {
    const ShownUnit unit = shownUnit(quantity, m_units);
    return shown(Decimal(value, unit)
                     .roundedUncertainty(decimals < 0 ? decimals : std::max(0, decimals + unit.decimals)));
}

QString Language::shown(const std::string &decimal) const {
    const QString plain = QString::fromStdString(decimal);
    if (plain == QLatin1StringView("nan"))
        return dash;
    const qsizetype first = plain.startsWith(u'-') ? 1 : 0;
    const auto notDigit =
        std::find_if(plain.begin() + first, plain.end(), [](QChar c) { return !c.isDigit(); });
    const qsizetype whole = notDigit - plain.begin();
    QString result;
    for (qsizetype i = 0; i < plain.size(); ++i) {
        if (i > first && i < whole && (whole - i) % groupSize == 0)
            result += narrowNoBreakSpace;
        const QChar c = plain[i];
        if (c == u'-')
            result += minus;
        else if (c == u'.' && m_id == Id::french)
            result += u',';
        else
            result += c;
    }
    return result.replace(QStringLiteral("inf"), QStringLiteral("\u221E"));
}

QString Language::quantity(double value, Quantity quantity, int decimals) const {
    QString digits = number(decimals < 0 ? certain(value) : value, quantity, decimals);
    return digits == dash ? digits : withUnit(digits, unit(quantity));
}

QString Language::unit(Quantity quantity) const {
    return QString::fromUtf8(shownUnit(quantity, m_units).sign);
}

Language Language::withUnits(const DisplayUnits &units) const {
    Language result = *this;
    result.m_units = units;
    return result;
}

namespace {

QString dayOfMonth(const QDate &date, Language::Id language) {
    const bool ordinal = language == Language::Id::french && date.day() == 1;
    return ordinal ? QStringLiteral("1er") : QString::number(date.day());
}

} // namespace

QString Language::date(const std::string &iso) const {
    if (iso.empty())
        return dash;
    QString written = QString::fromStdString(iso);
    const QDate date = QDate::fromString(written, Qt::ISODate);
    if (!date.isValid())
        return written;
    return dayOfMonth(date, m_id) + noBreakSpace + text(months[static_cast<std::size_t>(date.month() - 1)]) +
           u' ' + QString::number(date.year());
}

QString Language::shortDate(const std::string &iso) const {
    const QDate day = QDate::fromString(QString::fromStdString(iso), Qt::ISODate);
    if (!day.isValid())
        return date(iso);
    const QLocale locale(m_id == Id::french ? QLocale::French : QLocale::English);
    QString written = dayOfMonth(day, m_id) + locale.toString(day, QStringLiteral(" MMM yyyy"));
    return written.replace(u' ', noBreakSpace);
}

} // namespace palmer
