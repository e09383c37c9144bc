// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "print/pdf/textblock.h"

#include "kernel/evaluation/edition.h"
#include "print/pdf/pages.h"
#include "print/pdf/strips.h"
#include "report/blocks/report.h"

#include <QGuiApplication>
#include <QTest>
#include <random>

using namespace palmer;

namespace {

constexpr TextStyle style{9, false, black, 1.2};

QString repeated(const QString &piece, qsizetype characters) {
    return piece.repeated(characters / piece.size());
}

/// Characters measured in laying out the report.
std::size_t workOf(const Report &report) {
    const std::size_t before = charactersMeasured();
    (void)layoutPages(report);
    return charactersMeasured() - before;
}

Report with(Block block) {
    Report report;
    report.blocks.push_back(std::move(block));
    return report;
}

/// A report in which the text stands in one place.
Report reportWith(const QString &place, const QString &text) {
    if (place == "paragraph")
        return with(Paragraph{text});
    if (place == "value")
        return with(KeyValues{{{"Key", text}}});
    if (place == "key")
        return with(KeyValues{{{text, "Value"}}});
    if (place == "heading")
        return with(Heading{2, text});
    if (place == "note of a heading")
        return with(Heading{2, "Heading", Phrase(text)});
    if (place == "head") {
        TestHead head;
        head.laboratory = head.address = head.number = head.title = head.subtitle = head.editionTitle = text;
        return with(head);
    }
    if (place == "cell" || place == "number" || place == "column title" || place == "short cell") {
        Table table;
        table.columns = {Column{QString(place == "column title" ? text : "Title")},
                         Column{QString("Number"), {}, Alignment::decimal, false, 20}};
        table.columns[0].width = place == "short cell" ? 20 : 0;
        table.rows = {{Cell(QString(place == "column title" || place == "number" ? "x" : text)),
                       Cell(QString(place == "number" ? text : "1.5"))}};
        return with(table);
    }
    if (place == "finding") {
        FindingsBlock findings;
        findings.lines = {{{}, Grade::requirement, "requirement", "4.3", text}};
        return with(findings);
    }
    if (place == "signature") {
        Signatures signatures;
        signatures.columns = {{text, {{"Name", text, false}}}};
        return with(signatures);
    }
    if (place == "legend") {
        ResultsLegend legend;
        legend.items = {{LegendSign::limit, text}};
        return with(legend);
    }
    Report report = with(RunningHead{text, text});
    report.footerLeft = report.footerCentre = text;
    report.blocks.emplace_back(Paragraph{"first"});
    report.blocks.emplace_back(PageBreak{});
    report.blocks.emplace_back(Paragraph{"second"});
    return report;
}

} // namespace

class TextBlockTest : public QObject {
    Q_OBJECT

private slots:
    /// Eight times the text is eight times the work, whatever it is made of and wherever it stands. Of
    /// quadratic work it would be 64 times as much.
    void workGrowsAsTheText_data() {
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("piece");
        for (const char *place :
             {"paragraph", "value", "key", "heading", "note of a heading", "head", "cell", "short cell",
              "number", "column title", "finding", "signature", "legend", "running head and foot"}) {
            for (const char *piece : {"x", "a b ", "a-", "e\u0301", "😀", "W ", "word\n", "\u00a0"})
                QTest::addRow("%s: %s", place, qPrintable(QString(piece).simplified())) << place << piece;
        }
    }
    void workGrowsAsTheText() {
        QFETCH(const QString, place);
        QFETCH(const QString, piece);
        constexpr qsizetype shorter = 1024;
        const std::size_t less = workOf(reportWith(place, repeated(piece, shorter)));
        const std::size_t more = workOf(reportWith(place, repeated(piece, 8 * shorter)));
        QVERIFY2(more <= 16 * less, qPrintable(QStringLiteral("%1 and %2").arg(less).arg(more)));
        QVERIFY(more <= 1000 * 8 * shorter); // a line of short words is measured word by word
    }

    /// Every line is full: with the next character or word it would be too wide; nothing is lost.
    void linesAreFullAndNothingIsLost() {
        std::mt19937 random(4);
        const QStringList letters{"i", "i", "W", "m", ".", "e\u0301", "-", "/", " ", "\n"};
        for (int round = 0; round < 400; ++round) {
            QString text;
            for (int i = 0; i < 1 + int(random() % 300); ++i)
                text += letters[qsizetype(random() % std::size_t(letters.size() - (round % 3)))];
            const double width = 4 + double(random() % 100);
            const TextBlock block(text, style, width);
            QString drawn;
            for (std::size_t i = 0; i < block.lineCount(); ++i) {
                const TextBlock line = block.line(i);
                // The narrowest line holds one character.
                QVERIFY(line.width() <= std::max(width, textWidth("W", style)) + 0.02);
                QCOMPARE(line.width(), textWidth(line.text(), style));
                QVERIFY(!line.text().startsWith(QChar(0x301)));
                drawn += line.text();
            }
            QString all = text;
            QCOMPARE(drawn.remove(' '), all.remove(' ').remove('\n'));
        }
    }

    void aWordTooWideFillsItsLines() {
        const QString word(1000, 'x');
        const double width = 100;
        const TextBlock block(word, style, width);
        const double one = textWidth("x", style);
        for (std::size_t i = 0; i + 1 < block.lineCount(); ++i) {
            const TextBlock line = block.line(i);
            QVERIFY(line.width() <= width);
            QVERIFY(line.width() + one > width - 0.02); // kerning
        }
    }

    /// No line ends between a count and what is counted, or before the number of a seed.
    void numbersStayWithTheirWords() {
        const QString text("En tout (2014) : 1 exigence non satisfaite, 12 recommandations (germe 7)");
        for (int width = 110; width < 400; ++width) {
            const TextBlock block(text, style, width);
            for (std::size_t i = 0; i + 1 < block.lineCount(); ++i) {
                const QString line = block.line(i).text();
                for (const char *end : {" 1", " 12", "(germe"})
                    QVERIFY2(!line.endsWith(end), qPrintable(line));
            }
        }
    }

    void anElidedTextIsAsLongAsFits() {
        std::mt19937 random(8);
        for (int round = 0; round < 200; ++round) {
            QString text;
            for (int i = 0; i < int(random() % 200); ++i)
                text += QChar('a' + int(random() % 26));
            const double width = 20 + double(random() % 400);
            const TextBlock block = elided(text, style, width);
            if (textWidth(text, style) <= width) {
                QCOMPARE(block.text(), text);
                continue;
            }
            QVERIFY(block.text().endsWith(QChar(u'…')));
            QVERIFY(block.width() <= width);
            const QString longer = text.first(block.text().size()) + QChar(u'…');
            QVERIFY(textWidth(longer, style) > width);
        }
        QCOMPARE(elided("x", style, 1).text(), QString("…"));
        QVERIFY(elided({}, style, 10).text().isEmpty());
    }

    /// A column that fits has its texts on one line, and takes the room from what is spare, then from the
    /// flexible one; a monstrous text breaks all the same.
    void columnsFitTheirTexts() {
        const auto heightOf = [](const QString &text, bool fitting) {
            Table table;
            table.headless = true;
            table.columns = {Column{QString(), {}, Alignment::left, false, 7},
                             Column{QString(), {}, Alignment::left, true},
                             Column{QString(), {}, Alignment::left, false, 20}};
            table.columns[0].fitting = fitting;
            table.columns[2].spare = 2;
            table.rows = {{Cell(text), Cell(QString("x")), Cell(QString("y"))}};
            double height = 0;
            for (const Strip &strip : tableStrips(std::make_shared<const Table>(table), 175 * mm))
                height += strip.height;
            return height;
        };
        const double oneLine = heightOf("x", false);
        QVERIFY(heightOf("12↓ – 10↑ of XY", false) > 1.5 * oneLine);
        QCOMPARE(heightOf("12↓ – 10↑ of XY", true), oneLine);
        QVERIFY(heightOf(repeated("a b ", 4096), true) > 1.5 * oneLine);
    }

    /// A designation is one word: what surrounds it never shares its line where there is no room.
    void designationsDoNotBreak_data() {
        QTest::addColumn<QString>("designation");
        for (const Kind kind : allKinds) {
            for (const Edition *edition : editionsOf(kind))
                QTest::newRow(edition->word) << QString::fromUtf8(edition->word);
        }
        QTest::newRow("of no edition") << "ASME B5.54-2005";
        QTest::newRow("a guide") << "JCGM 100:2008";
    }
    void designationsDoNotBreak() {
        QFETCH(QString, designation);
        const double width = TextBlock(designation, style).width() + 0.5;
        QCOMPARE(TextBlock("abc " + designation + " abc", style, width).lineCount(), std::size_t(3));
        QCOMPARE(TextBlock("abc (" + designation + ") abc", style, 1.2 * width).lineCount(), std::size_t(3));
        // Other letters before a number are no designation.
        const double other = TextBlock("MIS C 6190-2:2016", style).width() + 0.5;
        QCOMPARE(TextBlock("abc MIS C 6190-2:2016 abc", style, other).lineCount(), std::size_t(2));
    }

    /// What is too long for the head of a page goes on over the next ones.
    void aLongHeadTakesManyPages() {
        QVERIFY(layoutPages(reportWith("head", repeated("a b ", 16384))).size() > 8);
    }

    /// Lines of a tall row are strips of their own: what each holds is its line, not the whole text again.
    void aLongValueTakesManyPages() {
        const Pages pages = layoutPages(reportWith("value", repeated("a b ", 65536)));
        QVERIFY(pages.size() > 5 && pages.size() < 40);
    }
};

QTEST_MAIN(TextBlockTest)
#include "textblock.moc"
