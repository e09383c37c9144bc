// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "language/language.h"

#include <QFile>
#include <QLocale>
#include <QTest>
#include <QTranslator>
#include <ctime>
#include <limits>
#include <thread>

using namespace palmer;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

constexpr Text limitSentence = REPORT_TEXT("report", "%1 is %2, the limit %3");
constexpr Text accuracy = REPORT_TEXT("report", "accuracy");
constexpr Text accuracyOf1988 = REPORT_TEXT_FOR("report", "accuracy", "1988");
constexpr Text countedReadings = REPORT_TEXT_COUNTED("report", "%n reading(s) at %1");
constexpr Text unknown = REPORT_TEXT("report", "a text nobody translated: %1 %2 %9 %n %");
constexpr Text unknownPlural = REPORT_TEXT_COUNTED("report", "%n target(s) nobody translated");
constexpr Text march = REPORT_TEXT("report", "March");

/// The language with the small catalogue of this test.
Language words(Language::Id id) {
    auto catalogue = std::make_shared<QTranslator>();
    const bool loaded = catalogue->load(QString(PALMER_BINARY_DIR "/tests/words_") +
                                        (id == Language::Id::french ? "fr.qm" : "en.qm"));
    if (!loaded)
        qFatal("no catalogue for the test");
    return Language(id, catalogue);
}

} // namespace

class LanguageTest : public QObject {
    Q_OBJECT

    const Language english{Language::Id::english};
    const Language french{Language::Id::french};

private slots:
    void hasItsName();
    void comesFromTheLocale_data();
    void comesFromTheLocale();
    void embedsItsCatalogues();
    void translates();
    void tellsTextsWithoutTranslation();
    void fillsSentences();
    void fillsAllPlacesAtOnce();
    void choosesThePlural_data();
    void choosesThePlural();
    void writesNumbers_data();
    void writesNumbers();
    void joinsUnits_data();
    void joinsUnits();
    void knowsTheUnitOfEveryQuantity();
    void roundsUncertaintiesUp();
    void writesDates_data();
    void writesDates();
    void writesShortDates();
    void ignoresTheLocaleOfTheSystem();
    void isSharedByThreads();
    void isMadeInNoTime();
};

void LanguageTest::hasItsName() {
    QCOMPARE(Language::fromName(u"fr")->id(), Language::Id::french);
    QCOMPARE(Language::fromName(u"en")->id(), Language::Id::english);
    QCOMPARE(french.code(), "fr");
    QCOMPARE(english.code(), "en");
    for (const QString name : {"", "FR", "de", "fr_FR", "f", "french"})
        QVERIFY2(!Language::fromName(name), qPrintable(name));
}

void LanguageTest::comesFromTheLocale_data() {
    QTest::addColumn<QString>("expected");
    for (const char *name : {"fr", "fr_FR.UTF-8", "fr_CH", "fr-CA", "FR_be", "fr.utf8", "fr@euro"})
        QTest::newRow(name) << "fr";
    for (const char *name :
         {"", "C", "C.UTF-8", "POSIX", "en_GB.UTF-8", "de_DE", "fry_NL", "fur_IT", "_fr", "12"})
        QTest::newRow(*name ? name : "none") << "en";
}

void LanguageTest::comesFromTheLocale() {
    const QByteArray name = QTest::currentDataTag();
    QTEST(Language::fromLocale(name == "none" ? QString() : QString::fromUtf8(name)).code(), "expected");
}

void LanguageTest::embedsItsCatalogues() {
    // Nothing in this program names the resource: it comes with the library.
    QVERIFY(QFile::exists(":/translations/report_fr.qm"));
    QVERIFY(QFile::exists(":/translations/report_en.qm"));
    QVERIFY(french.hasTranslation(march));
    QCOMPARE(french.text(march), "mars");
    QCOMPARE(english.text(march), "March");
}

void LanguageTest::translates() {
    const Language language = words(Language::Id::french);
    QCOMPARE(language.text(accuracy), "exactitude");
    QCOMPARE(language.text(accuracyOf1988), "précision");
    QCOMPARE(words(Language::Id::english).text(accuracyOf1988), "accuracy");
}

void LanguageTest::tellsTextsWithoutTranslation() {
    const Language fr = words(Language::Id::french), en = words(Language::Id::english);
    QCOMPARE(fr.text(unknown), QString(unknown.source));
    QVERIFY(!fr.hasTranslation(unknown));
    QVERIFY(fr.hasTranslation(accuracy));
    QVERIFY(fr.hasTranslation(accuracyOf1988));
    QVERIFY(fr.hasTranslation(countedReadings));
    QVERIFY2(en.hasTranslation(accuracy), "the source is English");
    QVERIFY(en.hasTranslation(countedReadings));
    QVERIFY2(!en.hasTranslation(unknownPlural), "English plurals do need a translation");
    QVERIFY(!french.hasTranslation(countedReadings));
}

void LanguageTest::fillsSentences() {
    const Message message{
        limitSentence,
        {accuracy, Number{0.01625, Quantity::deviation, 1}, Number{0.01, Quantity::deviation}},
        std::nullopt};
    QCOMPARE(words(Language::Id::english).sentence(message),
             "accuracy is 16.2\u00A0µm, the limit 10\u00A0µm");
    QCOMPARE(words(Language::Id::french).sentence(message),
             "limite 10\u00A0µm, exactitude vaut 16,2\u00A0µm");
}

void LanguageTest::fillsAllPlacesAtOnce() {
    const Language language = words(Language::Id::english);
    QCOMPARE(language.sentence(
                 {limitSentence, {std::string("%2%n"), std::string("%1"), std::string("Éü %%3")}, 7}),
             "%2%n is %1, the limit Éü %%3");
    QCOMPARE(language.sentence({limitSentence, {std::string("A")}, std::nullopt}), "A is %2, the limit %3");
    QCOMPARE(language.sentence({unknown, {std::string("A")}, std::nullopt}),
             "a text nobody translated: A %2 %9 %n %");
    QCOMPARE(language.sentence({unknown, std::vector<Argument>(9, std::string("x")), 3}),
             "a text nobody translated: x x x 3 %");
    QCOMPARE(language.sentence({}), "");
}

void LanguageTest::choosesThePlural_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<QString>("inEnglish");
    QTest::addColumn<QString>("inFrench");
    QTest::newRow("none: plural in English only") << 0 << "0 readings at X"
                                                  << "0 relevé en X";
    QTest::newRow("one") << 1 << "1 reading at X"
                         << "1 relevé en X";
    QTest::newRow("two") << 2 << "2 readings at X"
                         << "2 relevés en X";
    QTest::newRow("thousands") << 12345 << "12\u202F345 readings at X"
                               << "12\u202F345 relevés en X";
}

void LanguageTest::choosesThePlural() {
    QFETCH(int, count);
    const Message message{countedReadings, {std::string("X")}, count};
    QTEST(words(Language::Id::english).sentence(message), "inEnglish");
    QTEST(words(Language::Id::french).sentence(message), "inFrench");
}

void LanguageTest::writesNumbers_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("inEnglish");
    QTest::addColumn<QString>("inFrench");
    const auto row = [](const char *name, double value, Quantity quantity, int decimals, const QString &en,
                        const QString &fr) {
        QTest::newRow(name) << value << quantity << decimals << en << fr;
    };
    using Q = Quantity;
    // clang-format off
    row("tie to even",         0.00125,   Q::deviation, 1,  "1.2",                "1,2");
    row("minus sign",         -0.0135,    Q::deviation, 1,  "\u221213.5",         "\u221213,5");
    row("never minus nought", -0.00001,   Q::deviation, 1,  "0.0",                "0,0");
    row("below a thousand",    999.5,     Q::position,  2,  "999.50",             "999,50");
    row("a thousand",          1000,      Q::position,  0,  "1\u202F000",         "1\u202F000");
    row("minus a thousand",   -1000,      Q::position,  0,  "\u22121\u202F000",   "\u22121\u202F000");
    row("minus a hundred",    -100,       Q::position,  0,  "\u2212100",          "\u2212100");
    row("millions",            1234567.125, Q::number,  2,  "1\u202F234\u202F567.12", "1\u202F234\u202F567,12");
    row("fraction ungrouped",  0.12345678, Q::number,  -1,  "0.12345678",         "0,12345678");
    row("shortest form",       0.3,       Q::number,   -1,  "0.3",                "0,3");
    row("shortest whole",      0.012,     Q::deviation, -1, "12",                 "12");
    row("arc seconds",         0.001,     Q::angularDeviation, 2, "3.60",         "3,60");
    row("huge, all digits",   -1.5e300,   Q::number,   -1,  "\u22121.5e300",      "\u22121,5e300");
    row("small, all digits",   1.5e-9,    Q::number,   -1,  "1.5e\u22129",        "1,5e\u22129");
    row("none",                notANumber, Q::deviation, 1, "–",                "–");
    row("infinite",            infinite,  Q::deviation, 1,  "∞",                  "∞");
    row("minus infinite",     -infinite,  Q::deviation, -1, "\u2212∞",            "\u2212∞");
    // clang-format on
}

void LanguageTest::writesNumbers() {
    QFETCH(double, value);
    QFETCH(Quantity, quantity);
    QFETCH(int, decimals);
    QTEST(english.number(value, quantity, decimals), "inEnglish");
    QTEST(french.number(value, quantity, decimals), "inFrench");
}

void LanguageTest::joinsUnits_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<QString>("inFrench");
    QTest::newRow("no unit") << 1.5 << Quantity::number << "1,5";
    QTest::newRow("a count") << 12.0 << Quantity::count << "12";
    QTest::newRow("mm") << 2000.0 << Quantity::position << "2\u202F000\u00A0mm";
    QTest::newRow("degrees stand at the number") << 360.0 << Quantity::angle << "360°";
    QTest::newRow("µm") << 0.0162 << Quantity::deviation << "16,2\u00A0µm";
    QTest::newRow("arc seconds stand at the number") << 0.001 << Quantity::angularDeviation << "3,6″";
    QTest::newRow("entered µm") << 0.6 << Quantity::micrometres << "0,6\u00A0µm";
    QTest::newRow("entered arc seconds") << 0.6 << Quantity::arcSeconds << "0,6″";
    QTest::newRow("temperature") << -0.5 << Quantity::temperature << "\u22120,5\u00A0°C";
    QTest::newRow("gradient") << 0.5 << Quantity::gradient << "0,5\u00A0°C/h";
    QTest::newRow("expansion") << 11.5 << Quantity::expansion << "11,5\u00A0µm/(m·°C)";
    QTest::newRow("feed") << 1000.0 << Quantity::feed << "1\u202F000\u00A0mm/min";
    QTest::newRow("angular feed") << 360.0 << Quantity::angularFeed << "360\u00A0°/min";
    QTest::newRow("time") << 3.0 << Quantity::time << "3\u00A0s";
    QTest::newRow("pressure") << 1013.25 << Quantity::pressure << "1\u202F013,25\u00A0hPa";
    QTest::newRow("per cent") << 95.0 << Quantity::percent << "95\u00A0%";
    QTest::newRow("none has no unit") << notANumber << Quantity::deviation << "–";
}

void LanguageTest::joinsUnits() {
    QFETCH(double, value);
    QFETCH(Quantity, quantity);
    QFETCH(QString, inFrench);
    QCOMPARE(french.quantity(value, quantity), inFrench);
    QCOMPARE(english.quantity(value, quantity), inFrench.replace(u',', u'.'));
}

void LanguageTest::knowsTheUnitOfEveryQuantity() {
    for (int i = 0; i <= static_cast<int>(Quantity::percent); ++i) {
        const auto quantity = static_cast<Quantity>(i);
        QCOMPARE(english.unit(quantity), french.unit(quantity));
        QCOMPARE(english.unit(quantity).isEmpty(),
                 quantity == Quantity::number || quantity == Quantity::count);
    }
}

void LanguageTest::roundsUncertaintiesUp() {
    QCOMPARE(french.uncertainty(0.00074, Quantity::deviation, 1), "0,8");
    QCOMPARE(french.number(0.00074, Quantity::deviation, 1), "0,7");
    QCOMPARE(english.uncertainty(0.01044, Quantity::deviation, 1), "10.4");
}

void LanguageTest::writesDates_data() {
    QTest::addColumn<QString>("iso");
    QTest::addColumn<QString>("inEnglish");
    QTest::addColumn<QString>("inFrench");
    QTest::newRow("a day") << "2026-11-20"
                           << "20\u00A0November 2026"
                           << "20\u00A0novembre 2026";
    QTest::newRow("first of a month") << "2026-08-01"
                                      << "1\u00A0August 2026"
                                      << "1er\u00A0août 2026";
    QTest::newRow("leap day") << "2024-02-29"
                              << "29\u00A0February 2024"
                              << "29\u00A0février 2024";
    QTest::newRow("last month") << "1988-12-31"
                                << "31\u00A0December 1988"
                                << "31\u00A0décembre 1988";
    QTest::newRow("none") << ""
                          << "–"
                          << "–";
    QTest::newRow("no such day") << "2026-02-30"
                                 << "2026-02-30"
                                 << "2026-02-30";
    QTest::newRow("no date") << "in autumn"
                             << "in autumn"
                             << "in autumn";
}

void LanguageTest::writesDates() {
    QFETCH(QString, iso);
    QTEST(english.date(iso.toStdString()), "inEnglish");
    QTEST(french.date(iso.toStdString()), "inFrench");
}

void LanguageTest::writesShortDates() {
    QCOMPARE(english.shortDate("2026-11-20"), "20\u00A0Nov\u00A02026");
    QCOMPARE(french.shortDate("2026-11-20"), "20\u00A0nov.\u00A02026");
    QCOMPARE(french.shortDate("2026-10-01"), "1er\u00A0oct.\u00A02026");
    QCOMPARE(english.shortDate("2026-10-01"), "1\u00A0Oct\u00A02026");
    QCOMPARE(french.shortDate("2026-05-01"), "1er\u00A0mai\u00A02026");
    QCOMPARE(french.shortDate("in autumn"), "in autumn");
    QCOMPARE(french.shortDate(""), french.date(""));
}

void LanguageTest::ignoresTheLocaleOfTheSystem() {
    for (const auto &locale :
         {QLocale(QLocale::German), QLocale(QLocale::Arabic, QLocale::Egypt), QLocale::c()}) {
        QLocale::setDefault(locale);
        QCOMPARE(french.quantity(12.3456, Quantity::deviation, 1), "12\u202F345,6\u00A0µm");
        QCOMPARE(english.quantity(12.3456, Quantity::deviation, 1), "12\u202F345.6\u00A0µm");
        QCOMPARE(french.date("2026-03-20"), "20\u00A0mars 2026");
    }
    QLocale::setDefault(QLocale::c());
}

void LanguageTest::isSharedByThreads() {
    const Language shared = words(Language::Id::french);
    const auto speak = [&shared](int &wrong) {
        for (int i = 0; i < 5000; ++i) {
            const Message message{countedReadings, {Number{0.01625, Quantity::deviation, 1}}, i};
            const QString expected = QString("%1 relevé%2 en 16,2\u00A0µm")
                                         .arg(shared.number(i, Quantity::count, 0), i > 1 ? "s" : "");
            wrong += shared.sentence(message) == expected ? 0 : 1;
            wrong +=
                Language(Language::Id::french).date("2026-03-20") == QString("20\u00A0mars 2026") ? 0 : 1;
        }
    };
    int wrongHere = 0, wrongThere = 0;
    std::thread other([&] { speak(wrongThere); });
    speak(wrongHere);
    other.join();
    QCOMPARE(wrongHere, 0);
    QCOMPARE(wrongThere, 0);
}

void LanguageTest::isMadeInNoTime() {
    const std::clock_t begin = std::clock(); // of this process alone: others may keep the machine busy
    constexpr int times = 10'000;
    qsizetype length = 0;
    for (int i = 0; i < times; ++i)
        length += Language(i % 2 == 0 ? Language::Id::french : Language::Id::english).code().size();
    QCOMPARE(length, 2 * times);
    const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
    QVERIFY2(seconds < times / 10'000.0,
             "0.1 ms each, ten times below what is asked for"); // a hundredth is usual
}

QTEST_GUILESS_MAIN(LanguageTest)
#include "languagetest.moc"
