// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "language/visibletext.h"

#include "document/json.h"
#include "language/csvwriter.h"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace palmer;

class VisibleTextTest : public QObject {
    Q_OBJECT

private slots:
    void showsWhatIsNotSeen_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        QTest::newRow("plain") << "Tour 3, é Ω"
                               << "Tour 3, é Ω";
        QTest::newRow("lines") << "a\nb\r\nc"
                               << "a\nb\nc";
        QTest::newRow("tabulator") << "a\tb"
                                   << "a b";
        QTest::newRow("escape sequence") << "\x1b[31mred"
                                         << "‹U+001B›[31mred";
        QTest::newRow("title of a terminal") << "\x1b]0;x\a"
                                             << "‹U+001B›]0;x‹U+0007›";
        QTest::newRow("carriage return") << "good\rbad"
                                         << "good‹U+000D›bad";
        QTest::newRow("delete, next line") << QStringLiteral("\u007f\u0085") << "‹U+007F›‹U+0085›";
        for (const char16_t mark :
             u"\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069") {
            if (mark == 0) // the end of the text
                continue;
            const QString number = QString::number(mark, 16).toUpper().rightJustified(4, u'0');
            QTest::addRow("U+%s", qPrintable(number))
                << QString(QChar(mark)) << QStringLiteral("‹U+%1›").arg(number);
        }
    }
    void showsWhatIsNotSeen() {
        QFETCH(QString, text);
        QFETCH(QString, shown);
        QCOMPARE(visibleText(text), shown);
        QCOMPARE(visibleText(shown), shown);
        // JSON says the same without any of it.
        const std::string json = compactJson(nlohmann::json(text.toStdString()));
        QCOMPARE(nlohmann::json::parse(json).get<std::string>(), text.toStdString());
        QCOMPARE(visibleText(QString::fromStdString(json)), QString::fromStdString(json));
    }

    /// A spreadsheet reads texts as texts, and numbers as numbers.
    void noCellIsAFormula_data() {
        QTest::addColumn<QString>("cell");
        QTest::addColumn<QString>("written");
        QTest::newRow("text") << "Tour 3"
                              << "Tour 3";
        QTest::newRow("=") << "=1+1"
                           << "'=1+1";
        QTest::newRow("+") << "+cmd"
                           << "'+cmd";
        QTest::newRow("-") << "-x"
                           << "'-x";
        QTest::newRow("minus") << "−x"
                               << "'−x";
        QTest::newRow("@") << "@SUM(1;2)"
                           << "\"'@SUM(1;2)\"";
        QTest::newRow("tabulator") << "\t=1"
                                   << "' =1";
        QTest::newRow("a number") << "-3.25"
                                  << "-3.25";
        QTest::newRow("an exponent") << "-1e-7"
                                     << "-1e-7";
        QTest::newRow("quotation marks") << "a \"b\", c"
                                         << "\"a \"\"b\"\", c\"";
        QTest::newRow("escape") << "a\x1b"
                                << "a‹U+001B›";
    }
    void noCellIsAFormula() {
        QFETCH(QString, cell);
        QFETCH(QString, written);
        CsvWriter csv('.');
        csv.text(cell.toStdString());
        QCOMPARE(QString::fromUtf8(csv.bytes()), written);
    }

    /// What follows a separator in a comment is a cell of its own to a spreadsheet.
    void noCommentIsAFormula() {
        CsvWriter csv('.');
        csv.comment("a,=1+1,@x\nb");
        QCOMPARE(csv.bytes(), QByteArray("# a,'=1+1,'@x b\n"));
    }
};

QTEST_MAIN(VisibleTextTest)
#include "visibletexttest.moc"
