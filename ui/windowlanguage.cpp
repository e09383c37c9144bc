// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <QWidget>
#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

namespace palmer::ui {

namespace {

constexpr auto settingsKey = "window/language";
constexpr auto lengthsKey = "window/lengths";
constexpr auto anglesKey = "window/angles";

// Settings values in the order of the enumerations; never change them.
constexpr std::array lengthWords{"micrometres", "millimetres", "inches"};
constexpr std::array angleWords{"arcSeconds", "degrees"};

/// Texts of Qt's file dialogs and message boxes that its French catalogue lacks or translates differently.
[[maybe_unused]] constexpr std::array textsOfQt{
    QT_TRANSLATE_NOOP("QAbstractFileIconProvider", "Drive"),
    QT_TRANSLATE_NOOP("QAbstractFileIconProvider", "Folder"),
    QT_TRANSLATE_NOOP("QAbstractFileIconProvider", "Shortcut"),
    QT_TRANSLATE_NOOP("QAbstractFileIconProvider", "Unknown"),
    QT_TRANSLATE_NOOP("QFileDialog", "Drive"),
    QT_TRANSLATE_NOOP("QFileDialog", "Change to detail view mode"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "OK"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Cancel"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Close"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Discard"),
    QT_TRANSLATE_NOOP("QPlatformTheme", "Save")};

template <class Choice, class Words>
Choice restored(const char *key, const Words &words) {
    const QByteArray kept = QSettings().value(QLatin1StringView(key)).toByteArray();
    const auto found = std::ranges::find(words, std::string_view(kept.constData()));
    return found == words.end() ? Choice{} : static_cast<Choice>(found - words.begin());
}

/// Texts shared with the report, looked up in its catalogue for every class.
class SharedTexts : public QTranslator {
public:
    QString translate(const char * /*context*/, const char *source, const char *comment,
                      int count) const override {
        return QTranslator::translate("report", source, comment, count);
    }
};

Language &current() {
    static Language language(Language::Id::english);
    return language;
}

void install(Language::Id id) {
    static std::array<std::unique_ptr<QTranslator>, 3> installed;
    current() = Language(id).withUnits(current().units());
    const bool french = id == Language::Id::french;
    QLocale::setDefault(french ? QLocale(QLocale::French, QLocale::France)
                               : QLocale(QLocale::English, QLocale::UnitedKingdom));
    for (auto &translator : installed)
        translator.reset(); // uninstalls itself
    // The last installed is asked first: ours adds to Qt's texts and overrides some.
    const std::array names{QStringLiteral(":/translations/report_%1.qm").arg(current().code()),
                           QStringLiteral(":/translations/qtbase_%1.qm").arg(current().code()),
                           QStringLiteral(":/translations/ui_%1.qm").arg(current().code())};
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::unique_ptr<QTranslator> translator =
            i == 0 ? std::make_unique<SharedTexts>() : std::make_unique<QTranslator>();
        if (!translator->load(names[i])) // Qt's own texts are English
            continue;
        QCoreApplication::installTranslator(translator.get());
        installed[i] = std::move(translator);
    }
}

} // namespace

const Language &windowLanguage() {
    return current();
}

void setWindowLanguage(Language::Id id) {
    install(id);
    QSettings().setValue(QLatin1StringView(settingsKey), current().code());
}

void setWindowUnits(const DisplayUnits &units) {
    current() = current().withUnits(units);
    QSettings settings;
    settings.setValue(QLatin1StringView(lengthsKey),
                      QByteArray(lengthWords.at(static_cast<std::size_t>(units.lengths))));
    settings.setValue(QLatin1StringView(anglesKey),
                      QByteArray(angleWords.at(static_cast<std::size_t>(units.angles))));
    for (QWidget *window : QApplication::topLevelWidgets())
        QCoreApplication::postEvent(window, new QEvent(QEvent::LanguageChange));
}

void restoreWindowLanguage() {
    current() = current().withUnits(
        {restored<LengthDisplay>(lengthsKey, lengthWords), restored<AngleDisplay>(anglesKey, angleWords)});
    const QString chosen = QSettings().value(QLatin1StringView(settingsKey)).toString();
    if (const auto language = Language::fromName(chosen))
        install(language->id());
    else
        install(Language::fromLocale(QLocale::system().name()).id());
}

QString withGroups(QString text, int count) {
    return text.replace(QString::number(count), windowLanguage().number(count, Quantity::count, 0));
}

} // namespace palmer::ui
