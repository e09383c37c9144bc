// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "language/entry.h"

#include "language/language.h"

#include <QDate>
#include <QTest>

using namespace palmer;

/// What people type into fields.
class EntryTest : public QObject {
    Q_OBJECT

private slots:
    void readsNumbers_data();
    void readsNumbers();
    void refusesWhatIsNoNumber_data();
    void refusesWhatIsNoNumber();
    void readsWhatIsShown();
    void nothingIsNoValueAndNoMistake();
    void readsDates_data();
    void readsDates();
    void aPowerOfTenIsRefusedAsOne();
    void anAmbiguousDateOffersBothReadings();
    void readsTimes();
    void readsIntervals();
};

void EntryTest::readsNumbers_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<Quantity>("quantity");
    QTest::addColumn<double>("value");

    // clang-format off
    QTest::newRow("a point")                      << "20.6"          << Quantity::temperature << 20.6;
    QTest::newRow("a comma")                      << "20,6"          << Quantity::temperature << 20.6;
    QTest::newRow("a comma is never a group")     << "1,234"         << Quantity::position    << 1.234;
    QTest::newRow("spaces are groups")            << "1 234 567,5"   << Quantity::position    << 1234567.5;
    QTest::newRow("narrow no-break spaces too")   << "1\u202f013"    << Quantity::pressure    << 1013.0;
    QTest::newRow("hyphen as minus")              << "-3"            << Quantity::number      << -3.0;
    QTest::newRow("typographic minus")            << "\u22123"       << Quantity::number      << -3.0;
    QTest::newRow("a plus")                       << "+3"            << Quantity::number      << 3.0;
    QTest::newRow("the unit shown")               << "2,5 s"         << Quantity::time        << 2.5;
    QTest::newRow("the unit shown, a deviation")  << "-12.5µm"       << Quantity::deviation   << -0.0125;
    QTest::newRow("the same as it can be typed")  << "-12.5 um"      << Quantity::deviation   << -0.0125;
    QTest::newRow("without the sign of degrees")  << "20.5 C"        << Quantity::temperature << 20.5;
    QTest::newRow("no digit before the mark")     << ",5"            << Quantity::number      << 0.5;
    QTest::newRow("no digit after it")            << "5."            << Quantity::number      << 5.0;
    QTest::newRow("blanks around")                << "  5 "          << Quantity::number      << 5.0;
    QTest::newRow("micrometres are shifted")      << "5.4"           << Quantity::deviation   << 0.0054;
    QTest::newRow("also where 0.1 is no double")  << "0.1"           << Quantity::deviation   << 0.0001;
    QTest::newRow("dash of word processors")      << "\u20133"       << Quantity::number      << -3.0;
    QTest::newRow("arc seconds")                  << "36"            << Quantity::angularDeviation << 0.01;
    // clang-format on
}

void EntryTest::readsNumbers() {
    QFETCH(QString, typed);
    QFETCH(Quantity, quantity);
    QFETCH(double, value);
    const NumberEntry entry = enteredNumber(typed, quantity);
    QVERIFY(!entry.refusal);
    QVERIFY(entry.value == value); // exactly: no tolerance
}

void EntryTest::refusesWhatIsNoNumber_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("reason");
    QTest::newRow("a letter among digits") << "12O"
                                           << "not a number";
    QTest::newRow("two commas") << "5,,4"
                                << "two commas";
    QTest::newRow("two points") << "5..4"
                                << "two points";
    QTest::newRow("comma and point") << "1,234.5"
                                     << "comma and point in one number";
    QTest::newRow("a mark alone") << ","
                                  << "not a number";
    QTest::newRow("a sign alone") << "-"
                                  << "not a number";
    QTest::newRow("two numbers") << "12 5"
                                 << "not a number";
    QTest::newRow("a group after the mark") << "1,234 567"
                                            << "not a number";
    QTest::newRow("a sign inside") << "1-2"
                                   << "not a number";
    QTest::newRow("another unit") << "5 in"
                                  << "another unit than the one shown";
    QTest::newRow("infinity") << "inf"
                              << "not a number";
    QTest::newRow("no number") << "nan"
                               << "not a number";
    QTest::newRow("beyond every double") << QString(400, '9') << "larger than any number";
}

void EntryTest::refusesWhatIsNoNumber() {
    QFETCH(QString, typed);
    QFETCH(QString, reason);
    const NumberEntry entry = enteredNumber(typed, Quantity::position);
    QVERIFY(!entry.value);
    QVERIFY(entry.refusal);
    QCOMPARE(QString::fromUtf8(entry.refusal->source), reason);
}

/// Whatever a language shows is read back as the same number.
void EntryTest::readsWhatIsShown() {
    for (const auto id : {Language::Id::english, Language::Id::french}) {
        const Language language(id);
        for (const double value : {0.0, -0.0054, 1234567.25, 0.1, -1500.41, 1e-5, 12345.678}) {
            for (const Quantity quantity : {Quantity::position, Quantity::deviation, Quantity::number}) {
                const NumberEntry entry = enteredNumber(language.number(value, quantity), quantity);
                QVERIFY2(entry.value && *entry.value == value, qPrintable(language.number(value, quantity)));
            }
        }
        for (const char *date : {"2026-01-01", "2026-08-12", "1999-12-31", "2024-02-29"}) {
            const MomentEntry entry = enteredDate(language.date(date), language);
            QVERIFY2(entry.value && *entry.value == date, qPrintable(language.date(date)));
        }
    }
}

void EntryTest::nothingIsNoValueAndNoMistake() {
    QVERIFY(!enteredNumber(u" ", Quantity::number).value);
    QVERIFY(!enteredNumber(u" ", Quantity::number).refusal);
    const Language french(Language::Id::french);
    QVERIFY(!enteredDate(u"", french).value && !enteredDate(u"", french).refusal);
    QVERIFY(!enteredTime(u"").refusal);
    QVERIFY(!enteredInterval(u"", Quantity::position).refusal);
}

void EntryTest::readsDates_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("french"); // empty: refused
    QTest::addColumn<QString>("english");
    const auto row = [](const char *name, const char *typed, const char *french, const char *english) {
        QTest::newRow(name) << QString(typed) << QString(french) << QString(english);
    };
    const auto same = [&](const char *name, const char *typed, const char *date) {
        row(name, typed, date, date);
    };
    same("as in the file", "2026-03-12", "2026-03-12");
    same("points, the day first", "12.03.2026", "2026-03-12");
    row("slashes: the day first, or one of two", "5/3/2026", "2026-03-05", "");
    row("two digits of a year", "12/03/26", "2026-03-12", "");
    row("hyphens", "12-03-26", "2026-03-12", "");
    same("both readings are one", "3/3/26", "2026-03-03");
    same("only a day first exists", "25/03/2026", "2026-03-25");
    row("only a month first exists", "03/25/2026", "", "2026-03-25");
    same("points and two digits", "12.03.26", "2026-03-12");
    same("the century before", "12.03.99", "1999-03-12");
    same("French words", "1er août 2026", "2026-08-01");
    same("English words", "1 August 2026", "2026-08-01");
    same("a month in short", "12 mars. 2026", "2026-03-12");
    same("capitals", "12 MAI 2026", "2026-05-12");
    same("a day that does not exist", "31.02.2026", "");
    same("no leap year", "29.02.2026", "");
    same("juin or juillet", "1 jui 2026", "");
    same("no month", "12 brumaire 2026", "");
    same("words", "yesterday", "");
}

void EntryTest::readsDates() {
    QFETCH(QString, typed);
    for (const Language::Id id : {Language::Id::french, Language::Id::english}) {
        QFETCH(const QString, french);
        QFETCH(const QString, english);
        const QString date = id == Language::Id::french ? french : english;
        const MomentEntry entry = enteredDate(typed, Language(id));
        QCOMPARE(QString::fromStdString(entry.value.value_or("")), date);
        QCOMPARE(entry.refusal.has_value(), date.isEmpty());
    }
}

/// A number is refused for what it is, not as none at all.
void EntryTest::aPowerOfTenIsRefusedAsOne() {
    for (const char16_t *typed : {u"1e99", u"2.5E-3", u"-3e5"})
        QVERIFY(QByteArray(enteredNumber(typed, Quantity::number).refusal->source).contains("power of ten"));
    for (const char16_t *typed : {u"e", u"1e", u"12 abc"})
        QCOMPARE(QByteArray(enteredNumber(typed, Quantity::number).refusal->source),
                 QByteArray("not a number"));
}

/// Either is one word away.
void EntryTest::anAmbiguousDateOffersBothReadings() {
    const Language english(Language::Id::english);
    const MomentEntry entry = enteredDate(u"12/03/26", english);
    const QString said = english.sentence(*entry.refusal).replace(QChar(u'\u00A0'), u' ');
    QVERIFY2(said.contains("12 March 2026") && said.contains("3 December 2026"), qPrintable(said));
    const std::string today = QDate::currentDate().toString(Qt::ISODate).toStdString();
    QCOMPARE(enteredDate(u"today", english).value, std::optional(today));
    QCOMPARE(enteredDate(u"Aujourd\u2019hui", Language(Language::Id::french)).value, std::optional(today));
    const MomentEntry none = enteredDate(u"soon", english);
    QVERIFY(english.sentence(*none.refusal).contains("2026-03-12")); // says what is accepted
}

void EntryTest::readsTimes() {
    QCOMPARE(enteredTime(u"9:05").value, std::optional<std::string>("09:05"));
    QCOMPARE(enteredTime(u"14 h 02").value, std::optional<std::string>("14:02"));
    QVERIFY(enteredTime(u"24:00").refusal);
    QVERIFY(enteredTime(u"9").refusal);
}

void EntryTest::readsIntervals() {
    for (const char *typed :
         {"-5 … 1800,5", "-5..1800.5", "-5 ; 1 800,5", "-5 to 1800.5", "-5 à 1800,5", "-5 - 1800,5"}) {
        const IntervalEntry entry = enteredInterval(QString::fromUtf8(typed), Quantity::position);
        QVERIFY2(entry.value, typed);
        QCOMPARE(*entry.value, (Interval{-5, 1800.5}));
    }
    QVERIFY(enteredInterval(u"5", Quantity::position).refusal);
    QVERIFY(enteredInterval(u"5 … 5", Quantity::position).refusal);
    QVERIFY(enteredInterval(u"5 … 4", Quantity::position).refusal);
    QVERIFY(enteredInterval(u"a … b", Quantity::position).refusal);
}

QTEST_APPLESS_MAIN(EntryTest)
#include "entrytest.moc"
