#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "editing/typednumber.h"

#include <QTest>

using namespace palmer;

class TypedNumberTest : public QObject {
    Q_OBJECT

private slots:
    void reads_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("decimal");
        QTest::addColumn<QString>("problem");
        const auto number = [](const char *typed, const char *decimal) {
            QTest::newRow(typed) << QString::fromUtf8(typed) << QString(decimal) << QString();
        };
        const auto refused = [](const char *typed, const char *problem) {
            QTest::newRow(typed) << QString::fromUtf8(typed) << QString() << QString(problem);
        };
        number("5,4", "5.4");
        number("5.4", "5.4");
        number("−4,8", "-4.8");
        number("-4.8", "-4.8");
        number("–4.8", "-4.8");
        number("+3", "3");
        number(" 12 ", "12");
        number(",5", ".5");
        number("5.", "5.");
        number("1\u202F050,02", "1050.02"); // as the window writes it
        number("", "");
        number("–", ""); // as the window writes a missing reading
        refused("4,,8", "two commas");
        refused("4..8", "two points");
        refused("1,234.5", "comma and point in one number");
        refused("12O", "not a number");
        refused("--3", "not a number");
        refused("3-", "not a number");
        refused(",", "not a number");
        refused("1e3", "not a number");
        refused("nan", "not a number");
        refused("5,4 µm", "not a number");
        refused("11111111111111111111111111111111111111111", "too long for a number");
    }

    void reads() {
        QFETCH(QString, typed);
        QFETCH(QString, decimal);
        QFETCH(QString, problem);
        const TypedNumber number = typedNumber(typed);
        QCOMPARE(QString::fromStdString(number.decimal), decimal);
        QCOMPARE(QString::fromUtf8(number.problem.source), problem);
        QCOMPARE(number.isEmpty(), decimal.isEmpty() && problem.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TypedNumberTest)
#include "typednumber.moc"
