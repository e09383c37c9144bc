// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/blocks/pagetext.h"
#include "report/attachedfile.h"
#include "report/blocks/plaintext.h"

#include <QTest>

using namespace palmer;

namespace {

Table smallTable() {
    Table table;
    table.columns = {{QString("i"), {}, Alignment::right},
                     {Phrase({{"x"}, {"ij", true}}), "µm", Alignment::decimal},
                     {QString("Verdict")}};
    Cell verdict(QString("conforms"));
    verdict.mark = Mark::check;
    table.rows = {{QString("1"), QString("−0.5"), verdict}, {QString("2"), QString(), blankCell()}};
    return table;
}

} // namespace

class PageTextTest : public QObject {
    Q_OBJECT

private slots:
    void aTableReadsRowByRow() {
        QCOMPARE(pageText(Block(smallTable())), "i  xij  Verdict\nµm\n1  −0.5  conforms\n2  –\n");
    }

    void aTableWithoutHeadHasRowsOnly() {
        Table table = smallTable();
        table.headless = true;
        QCOMPARE(pageText(Block(table)), "1  −0.5  conforms\n2  –\n");
    }

    void aSpannerStandsBeforeTheTitlesOfItsColumns() {
        Table table = smallTable();
        table.spanners = {{1, 2, QString("both")}};
        QVERIFY(pageText(Block(table)).startsWith("i  both  xij  Verdict\n"));
    }

    void theLeftIsReadBeforeTheRight() {
        SideBySide both;
        both.left = {Paragraph{"left 1"}, Paragraph{"left 2"}};
        both.right = {KeyValues{{{"label", {}}}}};
        QCOMPARE(pageText(Block(both)), "left 1\nleft 2\nlabel  –\n");
    }

    void whatPagesRepeatIsNoText() {
        QCOMPARE(pageText(Block(RunningHead{"a", "b"})), QString());
        QCOMPARE(pageText(Block(PageBreak{})), QString());
    }

    void aFigureGivesItsWords() {
        CurveFigure figure;
        figure.x = {"Target position", "P", "i", "mm", false, 0, 1, 1, {{0, "0"}, {1, "1"}}};
        figure.y = {"Deviation", "x", "ij", "µm", false, -1, 1, 1, {{-1, "−1"}}};
        figure.legend = {{LegendSample::up, "x̄↑", true}};
        QCOMPARE(pageText(Block(FigureBlock{figure})),
                 "Deviation xij (µm)\n−1\nTarget position Pi (mm)\n0  1\nx̄↑\n");
    }

    void pagesArePutInWhereTheyAreKnown() {
        Report report;
        VerdictLine line;
        line.label = "a";
        line.word = "b";
        line.limits.state = "c";
        line.accordance = {"d", Mark::none, "e", QString("see page %1.")};
        line.anchor = "findings-1";
        report.blocks = {line, line};
        std::get<VerdictLine>(report.blocks[1]).anchor = "findings-2";
        QCOMPARE(pageText(report), "a  b\nc\nd  e  see page –.\na  b\nc\nd  e  see page –.\n");
        for (Block &block : report.blocks)
            QVERIFY(putPages(block, {{"findings-1", 3}}));
        QCOMPARE(pageText(report), "a  b\nc\nd  e  see page 3.\na  b\nc\nd  e  see page –.\n");
    }

    void packedRowsAreThoseThatWerePacked() {
        Table table = smallTable();
        table.rows = {{QString("1"), QString("−0.5"), boldCell(QString("漢"))},
                      {QString("2"), QString(), blankCell()}};
        Table packed = table;
        packed.rows.clear();
        for (const std::vector<Cell> &row : table.rows)
            packed.packed.append(row);
        QCOMPARE(packed.rowCount(), std::size_t(2));
        for (std::size_t i = 0; i < table.rows.size(); ++i)
            QVERIFY(packed.packed.row(i) == table.rows[i]);
        QCOMPARE(pageText(Block(packed)), pageText(Block(table)));
        Report report;
        report.blocks = {table};
        Report ofPacked;
        ofPacked.blocks = {packed};
        QCOMPARE(plainText(ofPacked, 80), plainText(report, 80));
        packed.packed.append(table.rows[0]);
        QVERIFY(packed.packed.row(2) == table.rows[0]);
        QCOMPARE(PackedRows().count(), std::size_t(0));
    }

    void rowsPrintThePageTheyLeadTo() {
        Table table;
        table.columns = {{QString("Test")}, {QString("Page")}};
        table.columns[1].pages = true;
        table.rows = {{Cell("1"), Cell()}, {Cell("2"), Cell()}, {Cell("adjusted"), blankCell()}};
        table.links = {"test-1", "test-2", "test-1"};
        Block block = table;
        QVERIFY(putPages(block, {{"test-1", 4}}));
        QCOMPARE(pageText(block), "Test  Page\n1  4\n2  –\nadjusted\n");
    }

    void aTerminalShowsEveryBlock() {
        TestHead head;
        head.laboratory = "Laboratory";
        head.number = "No. 1";
        head.title = "Title";
        Report report;
        report.blocks = {head, smallTable(), Signatures{{{"Operator", {{"Name", "N. N."}}}}},
                         EndMark{"The end"}};
        const QString text = plainText(report);
        for (const char *word : {"Laboratory", "No. 1", "Title", "−0.5", "Operator", "N. N.", "The end"})
            QVERIFY2(text.contains(word), word);
    }

    void aMissingValueIsADashAndABlankFieldIsNone() {
        QVERIFY(Cell().isMissing());
        QVERIFY(!blankCell().isMissing());
        QVERIFY(!smallTable().rows[0][2].isMissing());
    }

    void plainRowsArePackedAndOthersStay() {
        Table plain = smallTable();
        plain.rows = {{QString("1"), QString("−0.5"), boldCell(QString("x"))},
                      {QString("2"), QString(), blankCell()}};
        Table packed = plain;
        packRows(packed);
        QVERIFY(packed.rows.empty());
        QCOMPARE(packed.rowCount(), std::size_t(2));
        QVERIFY(packed.packed.row(0) == plain.rows[0] && packed.packed.row(1) == plain.rows[1]);
        QCOMPARE(pageText(Block(packed)), pageText(Block(plain)));
        Table marked = smallTable();
        packRows(marked);
        QVERIFY(marked == smallTable());
    }

    void copiesOfACellKeepWhatTheyHad() {
        Cell cell(QString("1"));
        cell.extras.edit().rows = 2;
        const Cell copy = cell;
        QVERIFY(copy == cell);
        cell.extras.edit().notes.push_back({"note"});
        QVERIFY(copy.extras->notes.empty());
        QVERIFY(copy != cell);
        QVERIFY(Cell(QString("1")).extras == Boxed<CellExtras>(CellExtras()));
    }

    void theFooterCarriesSixteenDigits() {
        QCOMPARE(shortFingerprint("3fdaeacdfdd0ed05aaaa"), "3fda eacd fdd0 ed05");
        // SHA-256 of "abc", FIPS 180-2, B.1
        QCOMPARE(fingerprint("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }
};

QTEST_GUILESS_MAIN(PageTextTest)
#include "pagetexttest.moc"
