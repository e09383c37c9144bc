// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "tables/table.h"

#include "document/documenterror.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <random>

using namespace palmer;

namespace {

/// A picture of a table: cells joined with |, rows with a line break; numbers in their shortest form,
/// missing ones as ?, refused ones as !text!.
QString picture(const CellTable &table) {
    QStringList lines;
    for (const TableRow &row : table.rows()) {
        QStringList cells;
        for (const TableCell &cell : table.cells(row)) {
            const QString text = QString::fromUtf8(table.text(cell));
            switch (cell.kind) {
            case CellKind::empty:
                cells << "";
                break;
            case CellKind::number:
                cells << QString::number(cell.value, 'g', 15);
                break;
            case CellKind::missing:
                cells << "?";
                break;
            case CellKind::text:
                cells << '"' + text + '"';
                break;
            default:
                cells << '!' + text + '!';
            }
        }
        lines << (row.comment ? "#" : "") + cells.join('|');
    }
    return lines.join('\n');
}

} // namespace

class TableTest : public QObject {
    Q_OBJECT

private slots:
    void findsDelimiterAndMark_data();
    void findsDelimiterAndMark();
    void readsTables_data();
    void readsTables();
    void showsDoubt();
    void takesWhatIsChosen();
    void knowsThePlaceOfACell();
    void readsBackWhatWasWritten();
    void readsLongTexts_data();
    void readsLongTexts();
    void refusesTooManyRowsAtTheirLine();
    void refusesLongLines();
    void takesCellsOneByOne();
};

void TableTest::findsDelimiterAndMark_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("delimiter");
    QTest::addColumn<bool>("comma");
    const auto row = [](const char *name, const QByteArray &text, Delimiter delimiter, bool comma) {
        QTest::newRow(name) << text << static_cast<int>(delimiter) << comma;
    };
    row("semicolon, comma", "0,00;-3,0;2,3\n150,71;0,2;5,4\n", Delimiter::semicolon, true);
    row("semicolon, point", "0.00;-3.0;2.3\n150.71;0.2;5.4\n", Delimiter::semicolon, false);
    row("comma, point", "0.00,-3.0,2.3\n150.71,0.2,5.4\n", Delimiter::comma, false);
    row("comma and blank, point", "0.00, -3.0, 2.3\n150.71, 0.2, 5.4\n", Delimiter::comma, false);
    row("comma between whole numbers", "0,1,2\n3,4,5\n", Delimiter::comma, false);
    row("comma between two whole numbers under words", "x,y\n3,4\n5,6\n", Delimiter::comma, false);
    row("tab, comma", "0,00\t-3,0\n150,71\t0,2\n", Delimiter::tab, true);
    row("tab, point", "0.00\t-3.0\n150.71\t0.2\n", Delimiter::tab, false);
    row("tab beside blanks", " 0.00 \t -3.0\n 150.71\t 0.2\n", Delimiter::tab, false);
    row("bar, point", "0.00|-3.0\n150.71|0.2\n", Delimiter::bar, false);
    row("blanks, comma", "  0,00   -3,0\n150,71    0,2\n", Delimiter::blanks, true);
    row("blanks, point", "  0.00   -3.0\n150.71    0.2\n", Delimiter::blanks, false);
    row("one column with commas: never 3256", "32,56\n1,5\n", Delimiter::tab, true);
    row("a single number with comma", "32,56", Delimiter::tab, true);
    row("words before", "a, b; c, d\nmore text, and more\n1,5;2,5\n3,5;4,5\n", Delimiter::semicolon, true);
    row("whole numbers", "1;2\n3;4\n", Delimiter::semicolon, false);
    row("dashes for missing ones", "0,0;-\n-;1,5\n", Delimiter::semicolon, true);
}

void TableTest::findsDelimiterAndMark() {
    QFETCH(QByteArray, text);
    QFETCH(int, delimiter);
    QFETCH(bool, comma);
    const CellTable table = readTable(text.toStdString());
    QCOMPARE(static_cast<int>(table.delimiter.value), delimiter);
    QCOMPARE(table.decimalMark.value == DecimalMark::comma, comma);
}

void TableTest::readsTables_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("expected");
    QTest::newRow("line ends of three systems") << QByteArray("1;2\r\n3;4\r5;6\n7;8") << "1|2\n3|4\n5|6\n7|8";
    QTest::newRow("empty cells stay") << QByteArray("1;;3\n;5;6\n7;8;\n") << "1||3\n|5|6\n7|8|";
    QTest::newRow("rows of nothing go") << QByteArray("1;2\n\n;;\n  \n3;4\n") << "1|2\n3|4";
    QTest::newRow("missing readings") << QByteArray("1.5;na;-\n2.5;n/a;#N/A\n") << "1.5|?|?\n2.5|?|?";
    QTest::newRow("comments") << QByteArray("# by me ; X\n% two\n// three\n1.5;2.5\n#N/A;4.5\n")
                              << "#\"by me ; X\"\n#\"two\"\n#\"three\"\n1.5|2.5\n?|4.5";
    QTest::newRow("head") << QByteArray("Point;1A;1R\n0,5;1,5;2,5\n")
                          << "\"Point\"|\"1A\"|\"1R\"\n0.5|1.5|2.5";
    QTest::newRow("quoted cells") << QByteArray("\"a;b\";\"c\"\"d\"\n\"1,5\";2,5\n")
                                  << "\"a;b\"|\"c\"\"d\"\n1.5|2.5";
    QTest::newRow("quoted line break")
        << QByteArray("\"x\nmm\"\t\"y\"\n1.5\t2.5\n") << "\"x\nmm\"|\"y\"\n1.5|2.5";
    QTest::newRow("inches are no quotation")
        << QByteArray("12\"\t5\n1.5\t2.5\n\"open\t3\n") << "\"12\"\"|5\n1.5|2.5\n\"\"open\"|3";
    QTest::newRow("broken numbers") << QByteArray("0,5;-4,,7\n1,5;2.5\n3,5;4,5\n")
                                    << "0.5|!-4,,7!\n1.5|!2.5!\n3.5|4.5";
    QTest::newRow("thousands between both marks")
        << QByteArray("1.050,02;5,5\n1.201,90;0,5\n5,5;6,5\n7,5;8,5\n9,5;0,5\n")
        << "1050.02|5.5\n1201.9|0.5\n5.5|6.5\n7.5|8.5\n9.5|0.5";
    QTest::newRow("list with words") << QByteArray("1 0.0 up 1 -3.5\n2 5.0 up 1 0.25\n")
                                     << "1|0|\"up\"|1|-3.5\n2|5|\"up\"|1|0.25";
    QTest::newRow("no line end, one cell") << QByteArray("7") << "7";
}

void TableTest::readsTables() {
    QFETCH(QByteArray, text);
    QFETCH(QString, expected);
    QCOMPARE(picture(readTable(text.toStdString())), expected);
}

void TableTest::showsDoubt() {
    // "1,5" may be one number or two.
    QVERIFY(readTable("1,5 2,5\n3,5 4,5\n").decimalMark.origin == Origin::recognised);
    QVERIFY(readTable("1,5\n3,25\n").decimalMark.origin == Origin::guessed);
    QVERIFY(readTable("0,1,2\n3,4,5\n").delimiter.origin == Origin::recognised);
    // A line with the other mark changes nothing, half of the lines make the mark a guess.
    QVERIFY(readTable("1.5;2\n3.5;4\n3,5;4\n3.5;4\n").decimalMark.origin == Origin::recognised);
    QVERIFY(readTable("1.5;2\n3.5;4\n3,5;4\n3,5;4\n").decimalMark.origin == Origin::guessed);
}

void TableTest::takesWhatIsChosen() {
    TableOptions options;
    options.delimiter = Delimiter::comma;
    const CellTable commas = readTable("1,5\n2,25\n", options);
    QCOMPARE(picture(commas), QString("1|5\n2|25"));
    QVERIFY(commas.delimiter.origin == Origin::chosen);
    options = {};
    options.decimalMark = DecimalMark::point;
    QCOMPARE(picture(readTable("1,5;2\n2,25;3\n", options)), QString("!1,5!|2\n!2,25!|3"));
    options = {};
    options.comments = false;
    QCOMPARE(picture(readTable("#1\t2\n3\t4\n", options)), QString("\"#1\"|2\n3|4"));
}

void TableTest::knowsThePlaceOfACell() {
    const CellTable table = readTable("# é\r\n\r\nécart;  1,5\r\n0,5;x\r\n");
    QCOMPARE(table.rows().size(), std::size_t(3));
    QCOMPARE(table.rows()[1].line, 3U);
    QCOMPARE(table.column(table.cells(table.rows()[1])[1]), std::size_t(9));
    QCOMPARE(table.rows()[2].line, 4U);
    QCOMPARE(table.column(table.cells(table.rows()[2])[1]), std::size_t(5));
}

void TableTest::readsBackWhatWasWritten() {
    std::mt19937 random(3);
    const std::array delimiters{'\t', ';', '|', ',', ' '};
    for (int trial = 0; trial < 200; ++trial) {
        const char delimiter = delimiters[random() % delimiters.size()];
        const bool comma = delimiter != ',' && random() % 2;
        const auto rows = 2 + random() % 30;
        const auto columns = 2 + random() % 12;
        std::string text;
        QString expected;
        for (unsigned i = 0; i < rows; ++i) {
            for (unsigned j = 0; j < columns; ++j) {
                const double value = (static_cast<double>(random() % 2'000'001) - 1'000'000) / 1000 + 0.0005;
                std::string number = QString::number(value, 'f', 4).toStdString();
                expected += (j ? "|" : i ? "\n" : "") + QString::number(value, 'g', 15);
                if (comma)
                    std::ranges::replace(number, '.', ',');
                text += (j ? std::string(1, delimiter) : "") + number;
            }
            text += trial % 3 == 0 ? "\r\n" : trial % 3 == 1 ? "\n" : "\r";
        }
        const CellTable table = readTable(text);
        QCOMPARE(picture(table), expected);
        QVERIFY(table.delimiter.origin == Origin::recognised);
    }
}

/// Lines of many forms, together longer than the longest line and than what is looked at to find the marks.
void TableTest::readsLongTexts_data() {
    QTest::addColumn<QByteArray>("lineEnd");
    QTest::addColumn<QByteArray>("last");
    for (const char *end : {"\n", "\r\n", "\r"}) {
        const QByteArray name = end[0] == '\n' ? "LF" : end[1] == '\n' ? "CRLF" : "CR";
        QTest::newRow(name) << QByteArray(end) << QByteArray("7;8;9");
    }
    QTest::newRow("no line behind the last end") << QByteArray("\n") << QByteArray();
    QTest::newRow("quoted") << QByteArray("\n") << QByteArray("7;8;\"9\"");
}

void TableTest::readsLongTexts() {
    QFETCH(const QByteArray, lineEnd);
    QFETCH(const QByteArray, last);
    std::mt19937 random(11);
    std::string text = "a;b;c" + lineEnd.toStdString();
    struct Line {
        unsigned number = 0;
        std::vector<double> values;
    };
    std::vector<Line> expected;
    for (unsigned line = 2; text.size() < 1'200'000; ++line) {
        const auto kind = static_cast<unsigned>(random() % 50);
        std::vector<double> values;
        if (kind == 0) {
            text += "# a remark; 1";
        } else if (kind > 1) {
            for (unsigned i = 0; i < 2 + kind % 3; ++i) {
                const auto parts = static_cast<unsigned>(random() % 100'000);
                values.push_back(parts / 8.0);
                text += (i > 0 ? ";" : "") + std::to_string(parts / 8) + '.' +
                        std::to_string(1000 + parts % 8 * 125).substr(1);
            }
        }
        if (kind != 1)
            expected.push_back({line, values});
        text += lineEnd.toStdString();
    }
    text += last.toStdString();
    TableOptions options;
    options.delimiter = Delimiter::semicolon;
    const CellTable table = readTable(text, options);
    QCOMPARE(table.rows().size(), expected.size() + 1 + (last.isEmpty() ? 0 : 1));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const TableRow &row = table.rows()[i + 1];
        const auto cells = row.comment ? std::span<const TableCell>() : table.cells(row);
        if (row.line != expected[i].number || row.comment != expected[i].values.empty() ||
            !std::ranges::equal(cells, expected[i].values, {}, &TableCell::value))
            QFAIL(qPrintable(QString::number(row.line)));
    }
}

void TableTest::refusesTooManyRowsAtTheirLine() {
    constexpr std::size_t most = 10'000'000;
    std::string text(2 * most, '1');
    for (std::size_t i = 1; i < text.size(); i += 2)
        text[i] = '\n';
    try {
        (void)readTable(text + "1\n1\n");
        QFAIL("it was read");
    } catch (const Error &error) {
        QCOMPARE(error.place, std::string("10000001:1"));
    }
}

void TableTest::refusesLongLines() {
    constexpr std::size_t most = std::size_t(1) << 20U;
    const std::string line(most, '1');
    const std::string beside = "1;2\n3;4\n";
    (void)readTable(beside + line + '\n' + beside);
    (void)readTable(line);
    (void)readTable(beside + line + "\r\n" + line);
    for (const std::string &text : {beside + line + "1\n" + beside, line + '1', beside + line + '1',
                                    beside + beside + line + "\r" + line + "1\r"}) {
        try {
            (void)readTable(text);
            QFAIL("it was read");
        } catch (const Error &error) {
            QVERIFY(error.kind == Error::Kind::tooLarge);
            const auto before = std::count(text.begin(), text.end() - most, '\n') +
                                std::count(text.begin(), text.end() - most, '\r');
            QCOMPARE(error.place, std::to_string(before + 1) + ":1");
        }
    }
}

void TableTest::takesCellsOneByOne() {
    TableBuilder builder;
    builder.beginRow(4);
    builder.add("Point");
    builder.add("a\tb");
    builder.beginRow(6);
    builder.add(0.5, "0.5");
    builder.add("1,5");
    builder.add("");
    const CellTable table = builder.take();
    QCOMPARE(picture(table), QString("\"Point\"|\"a b\"\n0.5|1.5|")); // typed as text, a number all the same
    QCOMPARE(table.rows()[1].line, 6U);
}

QTEST_APPLESS_MAIN(TableTest)
#include "table.moc"
