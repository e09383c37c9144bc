#include "ui/windowlanguage.h"

#include <QApplication>
#include <QLocale>
#include <QSettings>
#include <QTranslator>
#include <array>
#include <memory>

namespace palmer::ui {

namespace {

constexpr auto settingsKey = "window/language";

Language &current() {
    static Language language(Language::Id::english);
    return language;
}

void install(Language::Id id) {
    static std::array<std::unique_ptr<QTranslator>, 2> installed;
    current() = Language(id);
    const bool french = id == Language::Id::french;
    QLocale::setDefault(french ? QLocale(QLocale::French, QLocale::France)
                               : QLocale(QLocale::English, QLocale::UnitedKingdom));
    for (auto &translator : installed)
        translator.reset(); // removes itself
    const std::array names{QStringLiteral(":/translations/ui_%1.qm").arg(current().code()),
                           QStringLiteral(":/translations/qtbase_%1.qm").arg(current().code())};
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto translator = std::make_unique<QTranslator>();
        if (!translator->load(names[i])) // English is what Qt speaks itself
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

void restoreWindowLanguage() {
    const QString chosen = QSettings().value(QLatin1StringView(settingsKey)).toString();
    if (const auto language = Language::fromName(chosen))
        install(language->id());
    else
        install(Language::fromLocale(QLocale::system().name()).id());
}

} // namespace palmer::ui
