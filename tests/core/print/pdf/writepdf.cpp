// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/writepdf.h"

#include "core/print/pdf/reports.h"
#include "export/resultsjson.h"
#include "fulldisk.h"
#include "print/figures/exportfigure.h"
#include "print/fonts.h"
#include "print/pdf/pages.h"
#include "print/pdf/pdffile.h"
#include "print/pdf/textblock.h"
#include "report/blocks/pagetext.h"

#include <QColorSpace>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QHashSeed>
#include <QPainter>
#include <QPdfWriter>
#include <QProcess>
#include <QTemporaryFile>
#include <ctime>
#include <optional>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFOutlineDocumentHelper.hh>
#include <random>
#include <set>
#include <sys/mman.h>

using namespace palmer;
using namespace palmer::testdata;

namespace {

void addStoredDocuments() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Language::Id>("language");
    for (const QString &name : storedDocuments) {
        QTest::newRow(qPrintable(name + u" in French"_s)) << name << Language::Id::french;
        QTest::newRow(qPrintable(name + u" in English"_s)) << name << Language::Id::english;
    }
}

/// The page each anchor stands on, found by the words of its heading.
std::map<QString, int> anchorPages(const Report &report, const QStringList &pages) {
    std::map<QString, int> result;
    qsizetype page = 0;
    for (const Block &block : report.blocks) {
        const auto *heading = std::get_if<Heading>(&block);
        const auto *head = std::get_if<TestHead>(&block);
        if (!heading && !(head && head->annex))
            continue;
        const QString words =
            squeezed(heading ? heading->text + heading->note.plain() : head->title + head->subtitle);
        while (page < pages.size() && !squeezed(pages[page]).contains(words))
            ++page;
        if (const QString anchor = anchorOf(block); !anchor.isEmpty())
            result[anchor] = static_cast<int>(page) + 1;
    }
    return result;
}

/// The words of a figure are those of the figure as a file, which may be drawn in another order.
QString drawnText(const FigureBlock &figure) {
    const QString words = squeezed(pageText(Block(figure)));
    QString drawn = squeezed(pageTexts(figureAsPdf(*figure.figure, u"figure"_s)).join(QString()));
    QString sortedWords = words;
    QString sortedDrawn = drawn;
    std::sort(sortedWords.begin(), sortedWords.end());
    std::sort(sortedDrawn.begin(), sortedDrawn.end());
    if (sortedWords != sortedDrawn)
        qFatal("the figure says %s, not %s", qPrintable(drawn), qPrintable(words));
    return drawn;
}

/// What a block says, in the order it is drawn.
QString drawnText(const Block &block) {
    if (const auto *figure = std::get_if<FigureBlock>(&block))
        return drawnText(*figure);
    const auto *columns = std::get_if<SideBySide>(&block);
    if (!columns)
        return squeezed(pageText(block));
    QString result;
    for (const auto *side : {&columns->left, &columns->right}) {
        for (const Part &part : *side)
            result += std::visit([](const auto &each) { return drawnText(Block(each)); }, part);
    }
    return result;
}

Report reportOfPages(int count) {
    Report report = reportOf(storedDocument(u"one-direction"_s), Language::Id::french);
    report.blocks.clear();
    for (int i = 1; i <= count; ++i) {
        report.blocks.emplace_back(Heading{2, u"Section %1"_s.arg(i)});
        report.blocks.emplace_back(Paragraph{u"Page %1."_s.arg(i)});
        report.blocks.emplace_back(PageBreak{});
    }
    return report;
}

QString expectedText(const Report &report) {
    QString result;
    for (const Block &block : report.blocks)
        result += drawnText(block);
    return result;
}

QStringList tableHeads(const Report &report) {
    QStringList result;
    for (const Block &block : report.blocks) {
        if (const auto *table = std::get_if<Table>(&block)) {
            Table head = *table;
            head.rows.clear();
            head.packed = {};
            result << squeezed(pageText(Block(head)));
        }
    }
    return result;
}

/// Takes one of `beginnings` from the front of `text`.
void takeBeginning(QString &text, const QStringList &beginnings) {
    for (const QString &beginning : beginnings) {
        if (!beginning.isEmpty() && text.startsWith(beginning)) {
            text.remove(0, beginning.size());
            return;
        }
    }
}

/// Compares page by page: running head, footer and repeated heads of tables apart, all must be there, once
/// and in order.
void compare(const Report &composed, const QByteArray &pdf) {
    const QStringList pages = pageTexts(pdf);
    const auto found = anchorPages(arrangedForPages(composed), pages); // in the order of the pages
    Report numbered = composed;
    for (Block &block : numbered.blocks)
        putPages(block, found);
    const Report report = arrangedForPages(numbered);
    const QString expected = expectedText(report);
    const QStringList heads = tableHeads(report);
    QStringList runningHeads;
    for (const Block &block : report.blocks) {
        if (const auto *running = std::get_if<RunningHead>(&block))
            runningHeads << squeezed(running->left + running->right);
    }
    qsizetype at = 0;
    for (qsizetype i = 0; i < pages.size(); ++i) {
        QString text = squeezed(pages[i]);
        QString footer = report.footerLeft + report.footerCentre + report.footerRight;
        footer.replace(u"%1"_s, QString::number(i + 1)).replace(u"%2"_s, QString::number(pages.size()));
        QVERIFY2(text.endsWith(squeezed(footer)), qPrintable(text));
        text.chop(squeezed(footer).size());
        takeBeginning(text, runningHeads);
        if (!expected.mid(at).startsWith(text))
            takeBeginning(text, heads);
        if (!expected.mid(at).startsWith(text)) {
            qsizetype same = 0;
            while (same < text.size() && at + same < expected.size() && text[same] == expected[at + same])
                ++same;
            QFAIL(qPrintable(u"page %1 says “%2” and should say “%3”"_s.arg(i + 1).arg(
                text.mid(std::max<qsizetype>(same - 20, 0), 80),
                expected.mid(at + std::max<qsizetype>(same - 20, 0), 80))));
        }
        at += text.size();
    }
    QCOMPARE(expected.mid(at), QString());
}

const QByteArray pngLogo = [] {
    QImage image(300, 120, QImage::Format_ARGB32);
    image.fill(QColor(0, 60, 120, 128));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}();

const QByteArray svgLogo = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 40 20'>"
                           "<rect width='40' height='20' fill='#003c78'/>"
                           "<circle cx='20' cy='10' r='8' fill='#ffffff'/></svg>";

} // namespace

/// The report as a PDF.
class WritePdf : public QObject {
    Q_OBJECT

private slots:
    void textIsThatOfTheReport_data() { addStoredDocuments(); }
    void textIsThatOfTheReport();
    void textCanBeSearched();
    void sameBytesAtAnyTimeAndPlace();
    void saysTitleAndLanguage();
    void carriesNoDateButTheReports();
    void onlyTheShippedFont_data() { addStoredDocuments(); }
    void onlyTheShippedFont();
    void isVectorsOnly();
    void logoIsPartOfTheHead_data();
    void logoIsPartOfTheHead();
    void isSoundForOtherReaders();
    void longReportsAreDrawnIntoAFile();
    void saysThatThereIsNoRoomForThePages();
    void packedRowsPrintAsOthers();
    void textsDrawnAsOneKeepTheirColours();
    void textsDrawnAsOneKeepTheirCells();
    void plainTextsAreDrawnAsQtDrawsThem();
    void moreThanFourGigabytesAreRefused();
    void saysThatTheDeviceIsFull();
    void isArchivalWithItsData_data() { addStoredDocuments(); }
    void isArchivalWithItsData();
    void carriesFilesOfAnyLength_data();
    void carriesFilesOfAnyLength();
    void bookmarksAndLinksLeadToTheirPages();
    void attachedNamesAreNamesOfFiles_data();
    void attachedNamesAreNamesOfFiles();
};

void WritePdf::textIsThatOfTheReport() {
    QFETCH(const QString, name);
    QFETCH(const Language::Id, language);
    const Report report = reportOf(storedDocument(name), language);
    compare(report, storedPdf(name, language));
}

void WritePdf::textCanBeSearched() {
    // Accents are signs of their own in a PDF: white space may stand before them.
    const QString text = squeezed(pageTexts(storedPdf(u"limits-2006"_s, Language::Id::french)).join(u' '));
    for (const QString &word : {u"µm"_s, u"±"_s, u"A↑"_s, u"A↓"_s, u"x\u0304"_s, u"B\u0304"_s, u"°C"_s,
                                u"Répétabilité"_s, u"−1,5"_s})
        QVERIFY2(text.contains(squeezed(word)), qPrintable(word));
}

void WritePdf::sameBytesAtAnyTimeAndPlace() {
    const QByteArray first = storedPdf(u"two-tests"_s, Language::Id::french);
    QTest::qWait(1100); // times in a PDF have whole seconds
    qputenv("TZ", "Asia/Tokyo");
    tzset();
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::French));
    const QByteArray second = pdfOf(reportOf(storedDocument(u"two-tests"_s), Language::Id::french));
    QLocale::setDefault(before);
    qputenv("TZ", "UTC");
    tzset();
    QVERIFY(first == second);
}

void WritePdf::saysTitleAndLanguage() {
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        const Report report = reportOf(storedDocument(u"limits-2006"_s), language);
        const QByteArray pdf = storedPdf(u"limits-2006"_s, language);
        const QString information = QString::fromUtf8(run(u"pdfinfo"_s, {u"-"_s}, pdf));
        QVERIFY2(information.contains(report.title), qPrintable(information));
        QVERIFY2(information.contains(QRegularExpression(u"Page size: +595[0-9.]* x 84[12][0-9.]* pts"_s)),
                 qPrintable(information));
        QTemporaryDir folder;
        QFile file(folder.filePath(u"report.pdf"_s));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(pdf);
        file.close();
        const QByteArray objects = run(u"qpdf"_s, {u"--qdf"_s, file.fileName(), u"-"_s}, {});
        QVERIFY(objects.contains(language == Language::Id::french ? "/Lang (fr)" : "/Lang (en)"));
    }
}

void WritePdf::carriesNoDateButTheReports() {
    Report report = reportOf(storedDocument(u"limits-2006"_s), Language::Id::english);
    report.date = u"2026-11-20"_s;
    const QByteArray dated = run(u"pdfinfo"_s, {u"-rawdates"_s, u"-"_s}, pdfOf(report));
    QVERIFY2(dated.contains("D:20261120000000Z"), dated.constData());
    report.date.clear();
    const QByteArray undated = run(u"pdfinfo"_s, {u"-rawdates"_s, u"-"_s}, pdfOf(report));
    QVERIFY2(!undated.contains("Date"), undated.constData());
}

void WritePdf::onlyTheShippedFont() {
    QFETCH(const QString, name);
    QFETCH(const Language::Id, language);
    const QList<QByteArray> lines =
        run(u"pdffonts"_s, {u"-"_s}, storedPdf(name, language)).split('\n').mid(2);
    QVERIFY(lines.size() > 2);
    for (const QByteArray &line : lines) {
        if (line.isEmpty())
            continue;
        // name, type, encoding, embedded, subset, with Unicode
        const QRegularExpression expected(u"LiberationSans\\S* +CID TrueType +\\S+ +yes +\\S+ +yes "_s);
        QVERIFY2(QString::fromLatin1(line).contains(expected), line.constData());
    }
}

void WritePdf::isVectorsOnly() {
    for (const QString &name : storedDocuments) {
        const QByteArray images =
            run(u"pdfimages"_s, {u"-list"_s, u"-"_s}, storedPdf(name, Language::Id::french));
        QCOMPARE(images.trimmed().count('\n'), 1); // two lines of head
    }
}

void WritePdf::logoIsPartOfTheHead_data() {
    QTest::addColumn<QByteArray>("logo");
    QTest::addColumn<int>("images");
    QTest::newRow("PNG with transparency") << pngLogo << 1;
    QTest::newRow("SVG stays vectors") << svgLogo << 0;
    QTest::newRow("what is no picture is left out") << QByteArray("no picture") << 0;
}

void WritePdf::logoIsPartOfTheHead() {
    QFETCH(const QByteArray, logo);
    QFETCH(const int, images);
    Report report = reportOf(storedDocument(u"limits-2006"_s), Language::Id::french);
    for (Block &block : report.blocks) {
        if (auto *head = std::get_if<TestHead>(&block))
            head->logo = logo;
    }
    const QByteArray pdf = pdfOf(report);
    const QByteArray list = run(u"pdfimages"_s, {u"-list"_s, u"-"_s}, pdf);
    QCOMPARE(list.trimmed().count('\n') - 1, 2 * images); // of certificate and annex; no mask: opaque
    compare(report, pdf);
    // 10 mm high from the top margin, at the left margin.
    constexpr int perInch = 254;
    const QImage page = pictures(pdf, perInch).front();
    const bool drawn = logo != "no picture";
    QCOMPARE(qGray(page.pixel(205, 155)) < 200, drawn);
    QCOMPARE(qGray(page.pixel(205, 245)) < 200, drawn);
    QCOMPARE(qGray(page.pixel(205, 255)), 255);
}

void WritePdf::isSoundForOtherReaders() {
    QTemporaryDir folder;
    QFile file(folder.filePath(u"report.pdf"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(storedPdf(u"two-tests"_s, Language::Id::french));
    file.close();
    QVERIFY(
        run(u"qpdf"_s, {u"--check"_s, file.fileName()}, {}).contains("No syntax or stream encoding errors"));
}

/// More pages than are drawn in memory; without a place for the file they are drawn there all the same.
void WritePdf::longReportsAreDrawnIntoAFile() {
    constexpr int count = 90;
    const Report report = reportOfPages(count);
    const QByteArray pdf = pdfOf(report);
    const QStringList pages = pageTexts(pdf);
    QCOMPARE(pages.size(), count);
    for (int i = 1; i <= count; ++i)
        QVERIFY(pages[i - 1].contains(u"Page %1."_s.arg(i)));
    QPDF read;
    read.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));
    QCOMPARE(read.getWarnings().size(), std::size_t(0));
    QCOMPARE(QPDFOutlineDocumentHelper(read).getTopLevelOutlines().size(), std::size_t(count));
    QCOMPARE(pdfOf(report), pdf);
    const QByteArray usual = qgetenv("TMPDIR");
    qputenv("TMPDIR", "/there/is/no/such/folder");
    const QByteArray inMemory = pdfOf(report);
    usual.isEmpty() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", usual);
    QCOMPARE(inMemory, pdf);
}

/// While the pages are drawn; what is written would be a torso.
void WritePdf::saysThatThereIsNoRoomForThePages() {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    std::optional<Error::Kind> said;
    try {
        const FullDisk full(20'000);
        writePdf(reportOfPages(90), buffer);
    } catch (const Error &error) {
        said = error.kind;
    }
    QVERIFY(said == Error::Kind::unwritable);
    QVERIFY(buffer.data().isEmpty());
}

void WritePdf::packedRowsPrintAsOthers() {
    Table table;
    table.columns = {columnOf(u"i"_s, 20, Alignment::right), columnOf(u"x"_s, 30, Alignment::decimal),
                     flexibleColumn(u"text"_s, 60)};
    Table packed = table;
    for (int i = 0; i < 2500; ++i) { // such long ones are told row by row
        const std::vector<Cell> row{QString::number(i), boldCell(QString::number(i / 8.0)),
                                    i % 3 == 0 ? blankCell()
                                               : Cell(u"a text that needs two lines "_s.repeated(i % 4))};
        table.rows.push_back(row);
        packed.packed.append(row);
    }
    Report report = reportOf(storedDocument(u"one-direction"_s), Language::Id::french);
    report.blocks = {table};
    const QByteArray pdf = pdfOf(report);
    report.blocks = {packed};
    QCOMPARE(pdfOf(report), pdf);
    QVERIFY(pageTexts(pdf).size() > 20);
}

void WritePdf::textsDrawnAsOneKeepTheirColours() {
    const TextRun plain{u"plain "_s};
    TextRun grey{u"grey "_s};
    grey.grey = true;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    QPainter painter(&writer);
    TextBlock(RichText{plain, grey}, {8.5, false, black, 1.2}).draw(painter, {0, 0});
    painter.end();
    QPDF read;
    read.processMemoryFile("pdf", buffer.data().constData(), static_cast<std::size_t>(buffer.data().size()));
    QPDFObjectHandle page = read.getAllPages().at(0);
    const auto content = page.getKey("/Contents").getStreamData();
    const std::string all(reinterpret_cast<const char *>(content->getBuffer()), content->getSize());
    const std::size_t first = all.find("/CSp cs 0 0 0 scn");
    const std::size_t second = all.find("/CSp cs 0.2", first);
    QVERIFY(first != std::string::npos && second != std::string::npos);
    QVERIFY(all.find(" Tj", first) < second);
    QVERIFY(all.find(" Tj", second) != std::string::npos);
}

void WritePdf::textsDrawnAsOneKeepTheirCells() {
    Table table;
    table.columns = {columnOf(u"first head"_s, 40), columnOf(u"second head"_s, 40)};
    table.rows = {{Cell(u"north"_s), Cell(u"south"_s)}, {Cell(u"east"_s), Cell(u"west"_s)}};
    Report report = reportOf(storedDocument(u"one-direction"_s), Language::Id::english);
    report.blocks = {table};
    QTemporaryFile file;
    QVERIFY(file.open());
    file.write(pdfOf(report));
    file.close();
    QProcess process;
    process.start(u"pdfinfo"_s, {u"-struct-text"_s, file.fileName()});
    QVERIFY(process.waitForFinished(-1));
    const QString structure = squeezed(QString::fromUtf8(process.readAllStandardOutput()));
    for (const QString &cell : {u"TD\"north\""_s, u"TD\"south\""_s, u"TD\"east\""_s, u"TD\"west\""_s})
        QVERIFY2(structure.contains(cell), qPrintable(structure));
}

/// They are neither shaped nor measured as a whole.
void WritePdf::plainTextsAreDrawnAsQtDrawsThem() {
    loadFonts();
    const QString characters =
        u" 0123456789.,−+±()/:AVTWYLPFfijlrtyvw-–—’“”…≤≥↑↓\u202F\u00A0°µ×éÀÇœ%"_s + QChar(0x7e);
    std::mt19937 random(1);
    const auto upTo = [&](qsizetype most) {
        return static_cast<qsizetype>(random() % static_cast<std::mt19937::result_type>(most));
    };
    for (const bool bold : {false, true}) {
        const TextStyle style{8.5, bold, black, 1.2};
        constexpr int em = 2048; // of the font: a unit of texts
        constexpr double units = em / 8.5;
        const QFont font = paperFont(em, bold, false);
        std::vector<std::pair<QPointF, QString>> texts;
        for (int i = 0; i < 300; ++i) {
            QString text;
            for (qsizetype length = 1 + upTo(20); length > 0; --length)
                text += characters[upTo(characters.size())];
            text = u'x' + text.split(u' ', Qt::SkipEmptyParts).join(u' ');
            texts.emplace_back(QPointF(static_cast<double>(upTo(50'000)) / 97, 100), text);
            QCOMPARE(textWidth(text, style), QFontMetricsF(font).horizontalAdvance(text) / units);
        }
        const auto drawn = [&](auto draw) {
            QBuffer buffer;
            buffer.open(QIODevice::WriteOnly);
            QPdfWriter writer(&buffer);
            QPainter painter(&writer);
            for (const auto &[place, text] : texts) {
                painter.save();
                draw(painter, place, text);
                painter.restore();
            }
            painter.end();
            QPDF read;
            read.processMemoryFile("pdf", buffer.data().constData(),
                                   static_cast<std::size_t>(buffer.data().size()));
            QPDFObjectHandle page = read.getAllPages().at(0);
            const auto content = page.getKey("/Contents").getStreamData();
            return std::string(reinterpret_cast<const char *>(content->getBuffer()), content->getSize());
        };
        const std::string own = drawn([&](QPainter &painter, QPointF at, const QString &text) {
            TextBlock(text, style).draw(painter, at);
        });
        const std::string shaped = drawn([&](QPainter &painter, QPointF at, const QString &text) {
            const double ascent = TextBlock(text, style).ascent();
            const QTransform points = painter.transform();
            painter.scale(1 / units, 1 / units);
            painter.setPen(QColor::fromRgb(black));
            painter.setFont(font);
            painter.drawText(((at + QPointF(0, ascent)) * units).toPoint(), text + u' ');
            painter.setTransform(points);
        });
        QVERIFY(own == shaped);
    }
}

/// The memory is never read.
void WritePdf::moreThanFourGigabytesAreRefused() {
    constexpr std::size_t size = std::size_t(1) << 32U;
    void *const room = ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    QVERIFY(room != MAP_FAILED);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    PdfFile file(buffer, pack, 2);
    QVERIFY_EXCEPTION_THROWN(file.addStream(1, {}, {static_cast<const char *>(room), size}), PdfTooLarge);
    ::munmap(room, size);
}

void WritePdf::saysThatTheDeviceIsFull() {
    QFile full(u"/dev/full"_s);
    QVERIFY(full.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
    try {
        writePdf(reportOf(storedDocument(u"one-direction"_s), Language::Id::french), full);
        QFAIL("nothing was thrown");
    } catch (const Error &error) {
        QCOMPARE(error.kind, Error::Kind::unwritable);
    }
}

/// What ISO 19005-3 asks of such a file and no packaged program checks, piece by piece.
void WritePdf::isArchivalWithItsData() {
    QFETCH(const QString, name);
    QFETCH(const Language::Id, language);
    const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(storedDocument(name)));
    const Report report = composeReport(evaluated, Language(language), {u"Palmer 0.1.0"_s, true, {}, {}});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writePdf(report, buffer, attachedResults(evaluated));
    const QByteArray bytes = buffer.data();
    QVERIFY(bytes.startsWith("%PDF-1.7\n%"));
    QVERIFY(static_cast<uchar>(bytes[10]) > 127 && static_cast<uchar>(bytes[11]) > 127); // a binary comment

    QPDF pdf;
    pdf.processMemoryFile("report", bytes.constData(), static_cast<std::size_t>(bytes.size()));
    QPDFObjectHandle root = pdf.getRoot();
    QVERIFY(!pdf.isEncrypted());
    QVERIFY(pdf.getTrailer().getKey("/ID").isArray());
    QCOMPARE(QString::fromStdString(root.getKey("/Lang").getUTF8Value()), report.language);
    for (const char *forbidden : {"/OpenAction", "/AA", "/AcroForm", "/OCProperties"})
        QVERIFY2(!root.hasKey(forbidden), forbidden);

    // One profile of colours, for red, green and blue; it is unpacked where it says so itself.
    QCOMPARE(root.getKey("/OutputIntents").getArrayNItems(), 1);
    QPDFObjectHandle intent = root.getKey("/OutputIntents").getArrayItem(0);
    QCOMPARE(intent.getKey("/S").getName(), "/GTS_PDFA1");
    QPDFObjectHandle profile = intent.getKey("/DestOutputProfile");
    QCOMPARE(profile.getDict().getKey("/N").getIntValue(), 3LL);
    const auto icc = profile.getStreamData();
    const QByteArray data(reinterpret_cast<const char *>(icc->getBuffer()),
                          static_cast<qsizetype>(icc->getSize()));
    QCOMPARE(data.mid(36, 4), "acsp");
    QCOMPARE(data.mid(12, 8), "mntrRGB ");
    QCOMPARE(data.mid(8, 2), QByteArray::fromHex("0420")); // the version that PDF/A-3 knows
    QCOMPARE(QColorSpace::fromIccProfile(data), QColorSpace(QColorSpace::SRgb));
    QVERIFY(data.contains("para") && !data.contains("curv")); // formulas: pages open four times as fast

    // The packet is not packed, and says what the dictionary says.
    QPDFObjectHandle metadata = root.getKey("/Metadata");
    QVERIFY(!metadata.getDict().hasKey("/Filter"));
    const auto packet = metadata.getStreamData();
    const QString xmp = QString::fromUtf8(reinterpret_cast<const char *>(packet->getBuffer()),
                                          static_cast<qsizetype>(packet->getSize()));
    for (const QString &expected :
         {u"<pdfaid:part>3</pdfaid:part>"_s, u"<pdfaid:conformance>A</pdfaid:conformance>"_s,
          report.title.toHtmlEscaped(), u"<xmp:CreatorTool>Palmer</xmp:CreatorTool>"_s,
          u"<pdfaSchema:prefix>palmer</pdfaSchema:prefix>"_s, u"<rdf:li>%1</rdf:li>"_s.arg(report.language)})
        QVERIFY2(xmp.contains(expected), qPrintable(expected));
    QPDFObjectHandle information = pdf.getTrailer().getKey("/Info");
    QCOMPARE(QString::fromStdString(information.getKey("/Title").getUTF8Value()), report.title);
    QCOMPARE(information.hasKey("/CreationDate"), xmp.contains(u"<xmp:CreateDate>"));

    // Both files, associated, typed, named, and byte for byte.
    QPDFObjectHandle files = root.getKey("/AF");
    QCOMPARE(files.getArrayNItems(), 2);
    const struct {
        const char *relationship;
        const char *type;
        QString name;
        QByteArray content;
    } expected[]{{"/Source", "/application/vnd.palmer+json", report.testFileName, report.testFile},
                 {"/Data", "/application/json", u"results.json"_s, attachedResults(evaluated)}};
    for (int i = 0; i < 2; ++i) {
        QPDFObjectHandle file = files.getArrayItem(i);
        QCOMPARE(file.getKey("/AFRelationship").getName(), expected[i].relationship);
        for (const char *key : {"/F", "/UF"})
            QCOMPARE(QString::fromStdString(file.getKey(key).getUTF8Value()), expected[i].name);
        QPDFObjectHandle stream = file.getKey("/EF").getKey("/F");
        QCOMPARE(stream.getDict().getKey("/Subtype").getName(), expected[i].type);
        const auto content = stream.getStreamData();
        QCOMPARE(QByteArray(reinterpret_cast<const char *>(content->getBuffer()),
                            static_cast<qsizetype>(content->getSize())),
                 expected[i].content);
        QCOMPARE(stream.getDict().getKey("/Params").hasKey("/ModDate"), !report.date.isEmpty());
    }
    QCOMPARE(fingerprint(expected[0].content), report.fingerprint);

    // Nothing transparent, no annotation that is not printed, every font inside.
    for (QPDFObjectHandle object : pdf.getAllObjects()) {
        if (object.isStream())
            object = object.getDict();
        if (!object.isDictionary())
            continue;
        for (const char *key : {"/CA", "/ca"})
            QVERIFY(!object.hasKey(key) || object.getKey(key).getNumericValue() == 1);
        QVERIFY(!object.hasKey("/SMask") || object.getKey("/SMask").isName());
        QVERIFY(!object.hasKey("/JS") && !object.hasKey("/Launch"));
        if (object.isDictionaryOfType("/Annot"))
            QCOMPARE(object.getKey("/F").getIntValue(), 4LL);
        if (object.isDictionaryOfType("/FontDescriptor"))
            QVERIFY(object.getKey("/FontFile2").isStream());
    }
}

void WritePdf::carriesFilesOfAnyLength_data() {
    QTest::addColumn<qsizetype>("size");
    constexpr qsizetype limit = 4'194'304; // longer ones are packed in another way, on a thread
    QTest::newRow("one byte") << qsizetype(1);
    QTest::newRow("short") << qsizetype(70'000);
    QTest::newRow("the longest short one") << limit;
    QTest::newRow("the shortest long one") << limit + 1;
    QTest::newRow("long") << 5 * limit / 2;
}

void WritePdf::carriesFilesOfAnyLength() {
    QFETCH(const qsizetype, size);
    Report report = reportOf(storedDocument(u"one-direction"_s), Language::Id::french);
    std::mt19937 random(static_cast<unsigned>(size));
    report.testFile.resize(size);
    for (char &c : report.testFile)
        c = "0123456789.,-"[random() % 13];
    const QByteArray bytes = pdfOf(report);
    QVERIFY(pdfOf(report) == bytes);
    QPDF pdf;
    pdf.processMemoryFile("report", bytes.constData(), static_cast<std::size_t>(bytes.size()));
    QPDFObjectHandle stream = pdf.getRoot().getKey("/AF").getArrayItem(0).getKey("/EF").getKey("/F");
    QCOMPARE(stream.getDict().getKey("/Type").getName(), "/EmbeddedFile");
    QCOMPARE(stream.getDict().getKey("/Params").getKey("/Size").getIntValue(), static_cast<long long>(size));
    const auto content = stream.getStreamData();
    QVERIFY(QByteArray(reinterpret_cast<const char *>(content->getBuffer()),
                       static_cast<qsizetype>(content->getSize())) == report.testFile);
    // 13 signs take 3.7 bits each, and packed quickly 4.3.
    QVERIFY(stream.getRawStreamData()->getSize() < static_cast<std::size_t>(2 * size / 3 + 100));
}

void WritePdf::bookmarksAndLinksLeadToTheirPages() {
    const Report report = reportOf(storedDocument(u"mixed"_s), Language::Id::english);
    const QByteArray bytes = pdfOf(report);
    const QStringList pages = pageTexts(bytes);
    QPDF pdf;
    pdf.processMemoryFile("report", bytes.constData(), static_cast<std::size_t>(bytes.size()));
    const auto &all = pdf.getAllPages();
    const auto pageOf = [&](QPDFObjectHandle destination) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (QPDFObjectHandle(all[i]).getObjGen() == destination.getArrayItem(0).getObjGen())
                return static_cast<qsizetype>(i);
        }
        return qsizetype(-1);
    };
    int tests = 0, sections = 0;
    QPDFOutlineDocumentHelper outline(pdf);
    for (QPDFOutlineObjectHelper test : outline.getTopLevelOutlines()) {
        ++tests;
        std::vector<QPDFOutlineObjectHelper> items = test.getKids();
        sections += static_cast<int>(items.size());
        items.push_back(test);
        for (QPDFOutlineObjectHelper &item : items) {
            const qsizetype page = pageOf(item.getDest());
            QVERIFY(page >= 0);
            const QString title = squeezed(QString::fromStdString(item.getTitle()));
            QVERIFY2(squeezed(pages[page]).contains(title), qPrintable(title));
        }
    }
    qsizetype heads = 0;
    for (const Block &block : report.blocks) {
        const auto *head = std::get_if<TestHead>(&block);
        heads += head && !head->annex ? 1 : 0;
    }
    QVERIFY(heads > 2);
    QVERIFY2(tests > heads, "summary, tests, and what stands behind them");
    QVERIFY(sections > 3 * heads);
    // From the summary to each test, and from the verdict of a test to its findings.
    QPDFObjectHandle first = all.front();
    std::set<qsizetype> targets;
    QPDFObjectHandle links = first.getKey("/Annots");
    for (int i = 0; i < links.getArrayNItems(); ++i)
        targets.insert(pageOf(links.getArrayItem(i).getKey("/Dest")));
    QCOMPARE(qsizetype(targets.size()), heads - 1);
    QVERIFY(!targets.contains(-1) && !targets.contains(0));
    int others = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        others += QPDFObjectHandle(all[i]).hasKey("/Annots") ? 1 : 0;
    QVERIFY(others > 0);
    QCOMPARE(pdf.getRoot().getKey("/PageLabels").getKey("/Nums").getArrayNItems(), 2);
}

void WritePdf::attachedNamesAreNamesOfFiles_data() {
    QTest::addColumn<QString>("number");
    QTest::addColumn<QString>("name");
    QTest::newRow("a number") << u"2026-0117"_s << u"2026-0117.palmer"_s;
    QTest::newRow("none") << QString() << u"report.palmer"_s;
    QTest::newRow("folders") << u"../etc/R:1\\2"_s << u"etc-R-1-2.palmer"_s;
    QTest::newRow("control characters") << u"a\nb\u202Ec"_s << u"a-b-c.palmer"_s;
    QTest::newRow("an option") << u"--help"_s << u"help.palmer"_s;
    QTest::newRow("letters of any language") << u"Nº 7é"_s << u"Nº 7é.palmer"_s;
}

void WritePdf::attachedNamesAreNamesOfFiles() {
    QFETCH(const QString, number);
    QFETCH(const QString, name);
    Document document;
    document.report.number = number.toStdString();
    QCOMPARE(attachedFileName(document), name);
}

PALMER_TEST(runWritePdf) {
    QHashSeed::setDeterministicGlobalSeed();
    QGuiApplication application(argc, argv);
    WritePdf test;
    return QTest::qExec(&test, argc, argv);
}

#include "writepdf.moc"
