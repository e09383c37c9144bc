// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/model/clipboardtext.h"

#include "tables/richtext.h"
#include "ui/tabletext.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMimeData>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;

namespace {

QString copied(const char *format, const QByteArray &bytes) {
    QMimeData data;
    data.setData(format, bytes);
    return copiedText(data);
}

} // namespace

/// What programs copy: as HTML, as RTF, and into fields that hold tables.
class ClipboardTextTest : public QObject {
    Q_OBJECT

private slots:
    void tablesOfHtml() {
        QCOMPARE(copied("text/html",
                        "<p>Axis X</p><table><tr><th>P<br>(mm)</th><th colspan=2>1 &#8593;</th></tr>"
                        "<tr><td>0</td><td>1,5</td><td>&nbsp;2</td></tr></table><p>end</p>"),
                 QString("Axis X\n\nP (mm)\t1 ↑\t\n0\t1,5\t2\n\nend"));
    }

    void richText_data() {
        QTest::addColumn<QByteArray>("rtf");
        QTest::addColumn<QString>("text");
        QTest::newRow("a table") << QByteArray(
                                        "{\\rtf1\\ansi{\\fonttbl{\\f0 Arial 12;}}\\trowd\\cellx1\\cellx2\n"
                                        "\\pard\\intbl P (mm)\\cell 1 \\u8593? (\\'b5m)\\cell\\row\n"
                                        "\\pard\\intbl 0\\cell -1,5\\cell\\row}")
                                 << "P (mm)\t1 ↑ (µm)\n0\t-1,5\n";
        QTest::newRow("paragraphs with tabs")
            << QByteArray("{\\rtf1 0\\tab 1.5\\par 10\\tab 2\\par}") << "0\t1.5\n10\t2\n";
        QTest::newRow("signs") << QByteArray("{\\rtf1 \\{a\\}\\~b\\_c\\emdash\\uc2\\u181?xd}")
                               << "{a}\u00A0b-c—µd";
        QTest::newRow("a number behind a sign") << QByteArray("{\\rtf1 1\\~000,5\\_2}") << "1\u00A0000,5-2";
        QTest::newRow("what says nothing")
            << QByteArray("{\\rtf1{\\info{\\author 7}}{\\*\\generator 1}{\\pict 89504e}{\\header 3}12}")
            << "12";
        QTest::newRow("binary data") << QByteArray("{\\rtf1 1\\bin3 }}}2}") << "12";
        QTest::newRow("no RTF") << QByteArray("1 2 3") << "";
        QTest::newRow("cut off") << QByteArray("{\\rtf1 12\\'b") << "12";
    }
    void richText() {
        QFETCH(QByteArray, rtf);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(textOfRtf({rtf.data(), static_cast<std::size_t>(rtf.size())})), text);
        for (qsizetype size = 0; size < rtf.size(); ++size) // whatever is left of it
            (void)textOfRtf({rtf.data(), static_cast<std::size_t>(size)});
    }

    /// Programs copy several forms: the text where it says numbers.
    void plainTextIsPreferred() {
        QMimeData data;
        data.setText("1\t2");
        data.setHtml("<table><tr><td>3</td></tr></table>");
        QCOMPARE(copiedText(data), QString("1\t2"));
        data.setText("a picture");
        QCOMPARE(copiedText(data), QString("3"));
        data.setHtml("<img src='x'>");
        QCOMPARE(copiedText(data), QString("a picture"));
    }

    /// Lines take the place of what stands there, a word does not.
    void pastedLinesReplace() {
        TableText text;
        text.setPlainText("0\t1\n1\t2");
        text.moveCursor(QTextCursor::End);
        QGuiApplication::clipboard()->setText("7\t8\n9\t10");
        text.paste();
        QCOMPARE(text.toPlainText(), QString("7\t8\n9\t10"));
        auto *html = new QMimeData;
        html->setHtml("<table><tr><td>1</td><td>2</td></tr><tr><td>3</td><td>4</td></tr></table>");
        QGuiApplication::clipboard()->setMimeData(html);
        text.paste();
        QCOMPARE(text.toPlainText().trimmed(), QString("1\t2\n3\t4"));
        text.moveCursor(QTextCursor::End);
        QGuiApplication::clipboard()->setText("5");
        text.paste();
        QVERIFY(text.toPlainText().endsWith("5") && text.toPlainText().startsWith("1\t2"));
    }
};

QTEST_MAIN(ClipboardTextTest)
#include "clipboardtexttest.moc"
