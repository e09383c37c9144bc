// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/pdf/reports.h"
#include "core/print/proof/forgery.h"
#include "export/dcc.h"
#include "proof/pdfparts.h"

#include <QGuiApplication>
#include <QHashSeed>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <qpdf/Pl_String.hh>
#include <qpdf/QPDFLogger.hh>

using namespace palmer;
using namespace palmer::testdata;

namespace {

EvaluatedDocument evaluated(const QString &name) {
    return evaluate(std::make_shared<const Document>(storedDocument(name)));
}

/// Made once for all functions, which change copies.
const QByteArray &pdfOf(const QString &name, Language::Id language = Language::Id::english) {
    static std::map<std::pair<QString, Language::Id>, QByteArray> made;
    QByteArray &pdf = made[{name, language}];
    if (pdf.isEmpty())
        pdf = reportPdf(evaluated(name), language);
    return pdf;
}

QString english(const Verification &result) {
    return verificationText(result, Language(Language::Id::english));
}

/// The sentence that a PDF is refused with.
QString refusal(const QByteArray &pdf) {
    try {
        (void)verified(pdf);
    } catch (const Error &error) {
        return Language(Language::Id::english).sentence(error.message);
    }
    return u"it was read"_s;
}

void write(const QString &path, const QByteArray &bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

QByteArray contents(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool runs(const QString &program, const QStringList &arguments) {
    QProcess process;
    process.start(program, arguments);
    return process.waitForFinished(patience) && process.exitStatus() == QProcess::NormalExit &&
           process.exitCode() == 0;
}

/// The PDF with page streams that a text editor can change, as qpdf makes it.
QByteArray uncompressed(const QByteArray &pdf) {
    QTemporaryDir folder;
    write(folder.filePath(u"r.pdf"_s), pdf);
    return testdata::run(
        u"qpdf"_s,
        {u"--stream-data=uncompress"_s, u"--object-streams=disable"_s, folder.filePath(u"r.pdf"_s), u"-"_s},
        {});
}

} // namespace

/// A report recomputed from the test file inside it.
class VerifyReport : public QObject {
    Q_OBJECT

private slots:
    void reportsFollow_data();
    void reportsFollow();
    void aReportWrittenAnewFollows();
    void aForgeryByHandIsFoundAtItsPlace();
    void theFingerprintOnThePagesIsCompared();
    void anotherVersionMayUseOtherWords();
    void anotherVersionMayLayItsPagesOutOtherwise_data();
    void anotherVersionMayLayItsPagesOutOtherwise();
    void whatIsAddedIsNamed_data();
    void whatIsAddedIsNamed();
    void whatStandsBesideThePagesFollowsToo();
    void aCertificateFollowsToo();
    void aSignatureDoesNotDisturb();
    void aSimulationIsRunAgain();
    void whatIsNoReportIsRefused();
    void encryptionIsSaid();
    void nothingUnpacksBeyondTheBound();
    void pagesThatDrawWithoutEndAreRefused();
    void tagsThatLeadBackToThemselvesAreReadOnce();
    void outcomeAsJson();
};

void VerifyReport::reportsFollow_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Language::Id>("language");
    for (const QString &name : {u"limits-2006"_s, u"mixed"_s, u"two-tests"_s}) {
        QTest::newRow(qPrintable(name + u" in French"_s)) << name << Language::Id::french;
        QTest::newRow(qPrintable(name + u" in English"_s)) << name << Language::Id::english;
    }
}

void VerifyReport::reportsFollow() {
    QFETCH(const QString, name);
    QFETCH(const Language::Id, language);
    const Verification result = verified(pdfOf(name, language));
    QVERIFY2(result.follows(), qPrintable(english(result)));
    QVERIFY(result.identical);
    QVERIFY(english(result).startsWith(
        u"The numbers follow from the attached data. Where the data come from is not verified.\n"_s));
}

void VerifyReport::aReportWrittenAnewFollows() {
    const QByteArray pdf = pdfOf(u"mixed"_s);
    const QByteArray anew = uncompressed(pdf);
    QVERIFY(anew != pdf);
    const Verification result = verified(anew);
    QVERIFY2(result.follows(), qPrintable(english(result)));
    QVERIFY(!result.identical);
    QVERIFY(result.fingerprintPrinted);
}

void VerifyReport::aForgeryByHandIsFoundAtItsPlace() {
    // A digit of the first result, as a text editor changes it in the stream of the page.
    const QByteArray pdf = pdfOf(u"limits-2006"_s);
    QPDF document;
    document.processMemoryFile("r", pdf.constData(), static_cast<std::size_t>(pdf.size()));
    const PageContent content = contentOf(document.getAllPages().front());
    QString drawn;
    for (const DrawnGlyph &glyph : content.glyphs)
        drawn += glyph.sign.isSpace() ? u' ' : glyph.sign.isNull() ? u'?' : glyph.sign;
    const qsizetype unit = drawn.indexOf(u"Verdict of the test"_s);
    qsizetype place = unit;
    while (place > 0 && !(isDigit(drawn[place]) && drawn[place - 1] == u'.'))
        --place;
    QVERIFY(place > 0);
    const DrawnGlyph &digit = content.glyphs[static_cast<std::size_t>(place)];
    int other = 0;
    for (const auto &[glyph, sign] : content.fonts.at(digit.font))
        other = isDigit(sign) && sign != digit.sign ? glyph : other;
    QVERIFY(other > 0);

    QByteArray edited = uncompressed(pdf);
    // The bytes before the digit say where it is.
    constexpr qsizetype length = 2000;
    const QByteArray before = content.stream.mid(digit.at - length, length);
    const qsizetype at = edited.indexOf(before);
    QVERIFY(at > 0 && edited.indexOf(before, at + 1) < 0);
    edited.replace(at + length, 4, QByteArray::number(other, 16).rightJustified(4, '0'));
    const Verification result = verified(edited);
    QCOMPARE(result.differences.size(), std::size_t(1));
    const Difference &difference = result.differences.front();
    QCOMPARE(difference.page, 1);
    QVERIFY(difference.printed != difference.follows);
    QVERIFY2(difference.follows.contains(digit.sign), qPrintable(difference.follows));
    QVERIFY(difference.context.contains(difference.follows));
    QVERIFY(difference.area.width() > 1 && QRectF(0, 0, 596, 842).contains(difference.area));
    QVERIFY2(english(result).contains(
                 u"page 1: printed “%1”, follows “%2”"_s.arg(difference.printed, difference.follows)),
             qPrintable(english(result)));
    const QString french = verificationText(result, Language(Language::Id::french));
    QVERIFY2(french.contains(u"page 1\u00A0: imprimé «\u00A0%1\u00A0»"_s.arg(difference.printed)),
             qPrintable(french));
}

void VerifyReport::theFingerprintOnThePagesIsCompared() {
    const EvaluatedDocument other = evaluated(u"one-direction"_s);
    const QByteArray forged = changed(pdfOf(u"limits-2006"_s), [&](QPDF &pdf) {
        replaceAttachment(pdf, ".palmer", attachedFile(*other.document));
    });
    const Verification result = verified(forged);
    QVERIFY(!result.follows());
    QVERIFY(!result.fingerprintPrinted);
    QVERIFY(english(result).contains(u"not that of the attached file"_s));
    QCOMPARE(result.fingerprint, fingerprint(attachedFile(*other.document)));
}

void VerifyReport::anotherVersionMayUseOtherWords() {
    const EvaluatedDocument document = evaluated(u"limits-2006"_s);
    const Report report =
        composeReport(document, Language(Language::Id::english), {u"Palmer 0.0.9"_s, true, {}, {}});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writePdf(report, buffer, attachedResults(document));
    Verification result = verified(buffer.data());
    QVERIFY2(result.follows(), qPrintable(english(result)));
    QCOMPARE(result.madeBy, u"Palmer 0.0.9"_s);

    Random random(1);
    const auto letter = [](QChar c) { return c == u'h'; };
    result = verified(changed(buffer.data(), [&](QPDF &pdf) {
        QVERIFY(redraw(pdf, 1, random, letter, [](QChar c) { return c == u'k'; }));
    }));
    QVERIFY2(result.follows(), qPrintable(english(result)));
    QCOMPARE(result.wording.size(), std::size_t(1));
    result = verified(
        changed(buffer.data(), [&](QPDF &pdf) { QVERIFY(redraw(pdf, 1, random, isDigit, isDigit)); }));
    QVERIFY(!result.follows());
}

void VerifyReport::anotherVersionMayLayItsPagesOutOtherwise_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Language::Id>("language");
    bool french = false;
    for (const QString &name : testdata::storedDocuments) {
        QTest::newRow(qPrintable(name)) << name << (french ? Language::Id::french : Language::Id::english);
        french = !french;
    }
}

void VerifyReport::anotherVersionMayLayItsPagesOutOtherwise() {
    QFETCH(const QString, name);
    QFETCH(const Language::Id, language);
    const EvaluatedDocument document = evaluated(name);
    Report report = composeReport(document, Language(language), {u"Palmer 0.0.9"_s, true, {}, {}});
    const QString more = u"What only that version said in 99 words.\n"_s.repeated(30);
    for (std::size_t i = report.blocks.size(); i > 0; --i) {
        if (std::holds_alternative<TestHead>(report.blocks[i - 1]))
            report.blocks.insert(report.blocks.begin() + static_cast<std::ptrdiff_t>(i), Paragraph{more});
    }
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writePdf(report, buffer, attachedResults(document));
    const Verification result = verified(buffer.data());
    QVERIFY2(result.follows(), qPrintable(english(result)));
    QVERIFY(result.otherVersion);
    QVERIFY(english(result).startsWith(u"Results and verdicts follow"_s));

    // The same report, and one value of a table of results is another.
    for (Block &block : report.blocks) {
        auto *table = std::get_if<Table>(&block);
        const auto isResult = [](const std::vector<Cell> &row) {
            return std::ranges::any_of(row, [](const Cell &cell) { return cell.extras->guard.has_value(); });
        };
        if (!table || std::ranges::none_of(table->rows, isResult))
            continue;
        for (Cell &cell : *std::ranges::find_if(table->rows, isResult)) {
            QString text = cell.text.plain();
            static const QRegularExpression number(
                u"^\u2212?[0-9]+[.,][0-9]+$"_s); // not the targets that rule
            if (!number.match(text).hasMatch())
                continue;
            const auto digit = std::ranges::find_if(text, [](QChar c) { return c.isDigit(); });
            *digit = *digit == u'9' ? u'8' : QChar(digit->unicode() + 1);
            cell.text = text;
            buffer.close();
            buffer.setData({});
            buffer.open(QIODevice::WriteOnly);
            writePdf(report, buffer, attachedResults(document));
            const Verification forged = verified(buffer.data());
            QVERIFY(!forged.follows());
            return;
        }
    }
    QVERIFY(std::ranges::none_of(document.tests, [](const auto &test) {
        return std::ranges::any_of(test->parameters,
                                   [](const Parameter &p) { return p.verdict.has_value(); });
    }));
}

void VerifyReport::whatIsAddedIsNamed_data() {
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QString>("said");
    QTest::newRow("an action") << QByteArray("/OpenAction")
                               << QByteArray("<< /S /JavaScript /JS (app.alert\\(1\\)) >>")
                               << u"OpenAction"_s;
    QTest::newRow("layers") << QByteArray("/OCProperties") << QByteArray("<< /OCGs [] /D << >> >>")
                            << u"OCProperties"_s;
    QTest::newRow("a form of another kind")
        << QByteArray("/AcroForm") << QByteArray("<< /Fields [] /XFA (x) >>") << u"XFA"_s;
    QTest::newRow("a further attachment")
        << QByteArray("/AF")
        << QByteArray("[ << /Type /Filespec /F (more.txt) /UF (more.txt) /EF << /F 4 0 R >> >> ]")
        << QString();
}

void VerifyReport::whatIsAddedIsNamed() {
    QFETCH(const QByteArray, key);
    QFETCH(const QByteArray, value);
    QFETCH(const QString, said);
    const Verification result = verified(changed(pdfOf(u"limits-2006"_s), [&](QPDF &pdf) {
        if (key == "/AF") {
            Handle file = Handle::parse("<< /Type /Filespec /F (more.txt) /UF (more.txt) >>");
            Handle files = Handle::newDictionary();
            files.replaceKey("/F", Handle::newStream(&pdf, "more"));
            file.replaceKey("/EF", files);
            pdf.getRoot().getKey("/AF").appendItem(pdf.makeIndirectObject(file));
        } else {
            pdf.getRoot().replaceKey(key.toStdString(), Handle::parse(value.toStdString()));
        }
    }));
    QCOMPARE(result.differences.size(), std::size_t(1));
    QVERIFY2(english(result).contains(said.isEmpty() ? u"more.txt"_s : said), qPrintable(english(result)));
}

void VerifyReport::whatStandsBesideThePagesFollowsToo() {
    using Change = std::function<void(QPDF &)>;
    const Handle forged = Handle::newUnicodeString("CONFORME");
    const auto lastBookmark = [](QPDF &pdf) { return pdf.getRoot().getKey("/Outlines").getKey("/Last"); };
    const Change changes[]{
        [&](QPDF &pdf) { pdf.getTrailer().getKey("/Info").replaceKey("/Title", forged); },
        [&](QPDF &pdf) { pdf.getTrailer().getKey("/Info").replaceKey("/Author", forged); },
        [&](QPDF &pdf) { pdf.getTrailer().getKey("/Info").replaceKey("/Keywords", forged); },
        [&](QPDF &pdf) { lastBookmark(pdf).replaceKey("/Title", forged); },
        [&](QPDF &pdf) { pdf.getRoot().getKey("/Outlines").getKey("/First").replaceKey("/Title", forged); },
        [&](QPDF &pdf) { // one more
            Handle more = pdf.makeIndirectObject(Handle::newDictionary({{"/Title", forged}}));
            lastBookmark(pdf).replaceKey("/Next", more);
        },
        [&](QPDF &pdf) { // all of them
            pdf.getRoot().removeKey("/Outlines");
        },
        [&](QPDF &pdf) { // what a screen reader says of the first figure
            for (Handle one : pdf.getAllObjects()) {
                if (one.isDictionary() && one.hasKey("/Alt")) {
                    one.replaceKey("/Alt", forged);
                    break;
                }
            }
        },
        [&](QPDF &pdf) { // where a link is said to lead
            for (Handle one : pdf.getAllObjects()) {
                if (one.isDictionary() && one.hasKey("/Contents") && one.hasKey("/StructParent"))
                    one.replaceKey("/Contents", forged);
            }
        },
        [&](QPDF &pdf) { pdf.getRoot().getKey("/StructTreeRoot").getKey("/K").replaceKey("/T", forged); },
        [&](QPDF &pdf) { pdf.getRoot().removeKey("/StructTreeRoot"); },
    };
    for (const Change &change : changes) {
        const Verification result = verified(changed(pdfOf(u"limits-2006"_s), change));
        QCOMPARE(result.differences.size(), std::size_t(1));
        QVERIFY2(english(result).contains(u"bookmarks"_s), qPrintable(english(result)));
    }
    const Verification unit = verified(changed(pdfOf(u"limits-2006"_s), [](QPDF &pdf) {
        Handle page = pdf.getAllPages().front();
        page.replaceKey("/UserUnit", Handle::newInteger(2));
    }));
    QVERIFY2(english(unit).contains(u"UserUnit"_s), qPrintable(english(unit)));
}

void VerifyReport::aCertificateFollowsToo() {
    Document document = storedDocument(u"limits-2006"_s);
    ReportHead &head = document.report;
    head.number = "R-1";
    head.laboratory.name = "Laboratory";
    head.laboratory.country = "FR";
    head.authorisedBy.name = "B. Durand";
    head.customer = {"Customer", "Street 1"};
    head.place = "Hall 2";
    head.performedFrom = "2026-11-20";
    document.machine.name = document.machine.manufacturer = document.machine.serialNumber = "M1";
    const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
    const Report report = composeReport(evaluated, Language(Language::Id::french),
                                        {u"Palmer " PALMER_VERSION ""_s, true, {}, {}});
    const auto written = [&](const QByteArray &certificate) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        writePdf(report, buffer, attachedResults(evaluated), certificate);
        return buffer.data();
    };
    const QByteArray certificate = dcc(evaluated);
    const Verification result = verified(written(certificate));
    QVERIFY2(result.identical, qPrintable(english(result)));
    QByteArray forged = certificate;
    forged.replace("<dcc:conformity>", "<dcc:conformity> ");
    QVERIFY(forged != certificate);
    const Verification other = verified(written(forged));
    QVERIFY(!other.follows());
    QVERIFY(english(other).contains(u"the digital calibration certificate in the PDF is not the one"_s));
}

void VerifyReport::aSignatureDoesNotDisturb() {
    for (const QString &program : {u"certutil"_s, u"pdfsig"_s}) {
        if (QStandardPaths::findExecutable(program).isEmpty())
            QSKIP(qPrintable(program + u" is not there"_s));
    }
    QTemporaryDir folder;
    const auto path = [&folder](const QString &name) { return folder.filePath(name); };
    QDir(folder.path()).mkdir(u"nss"_s);
    write(path(u"noise"_s), QByteArray(64, '7'));
    QVERIFY(runs(u"certutil"_s, {u"-N"_s, u"-d"_s, path(u"nss"_s), u"--empty-password"_s}));
    QVERIFY(runs(u"certutil"_s,
                 {u"-S"_s, u"-d"_s, path(u"nss"_s), u"-n"_s, u"signer"_s, u"-s"_s, u"CN=Jeanne Martin"_s,
                  u"-x"_s, u"-t"_s, u"CT,C,C"_s, u"-v"_s, u"120"_s, u"-z"_s, path(u"noise"_s)}));
    const QByteArray pdf = pdfOf(u"limits-2006"_s);
    write(path(u"r.pdf"_s), pdf);
    QVERIFY(runs(u"pdfsig"_s, {u"-nssdir"_s, path(u"nss"_s), u"-add-signature"_s, u"-nick"_s, u"signer"_s,
                               path(u"r.pdf"_s), path(u"signed.pdf"_s)}));
    const QByteArray signedPdf = contents(path(u"signed.pdf"_s));
    QVERIFY(signedPdf.size() > pdf.size());

    const Verification result = verified(signedPdf);
    QVERIFY2(result.follows(), qPrintable(english(result)));
    QVERIFY(result.appended && !result.identical);
    QCOMPARE(result.signatures.size(), std::size_t(1));
    QCOMPARE(result.signatures.front().signer, u"Jeanne Martin"_s);
    QCOMPARE(result.signatures.front().state, SignatureStatement::State::valid);
    QVERIFY(result.signatures.front().whole);

    const Verification longer = verified(signedPdf + "% a note\n");
    QVERIFY2(longer.follows(), qPrintable(english(longer)));
    QVERIFY(!longer.signatures.front().whole);

    // A byte of what was signed that no reader shows: the binary comment behind the header.
    QByteArray broken = signedPdf;
    broken[11] = static_cast<char>(broken[11] ^ 1);
    const Verification after = verified(broken);
    QVERIFY(!after.follows());
    QCOMPARE(after.signatures.front().state, SignatureStatement::State::broken);
    QVERIFY2(english(after).contains(u"changed after"_s), qPrintable(english(after)));
}

void VerifyReport::aSimulationIsRunAgain() {
    Document document = storedDocument(u"budget-2006"_s);
    for (TestPointer &test : document.tests) {
        auto quick = std::make_shared<Test>(*test);
        std::get<PositioningMeasurement>(quick->measurement).uncertainty.trials = 2000;
        test = std::move(quick);
    }
    const EvaluatedDocument simulated =
        withSimulations(evaluate(std::make_shared<const Document>(document)), SimulateWhich::forReport)
            .value();
    const QByteArray pdf = reportPdf(simulated, Language::Id::english);
    QVERIFY(pdf != reportPdf(evaluate(std::make_shared<const Document>(document)), Language::Id::english));
    const Verification result = verified(pdf);
    QVERIFY2(result.identical, qPrintable(english(result)));
}

void VerifyReport::whatIsNoReportIsRefused() {
    const QByteArray pdf = pdfOf(u"limits-2006"_s);
    QCOMPARE(refusal(pdf), u"it was read"_s);
    const QString foreign = refusal(pdfOf(u"limits-2006"_s).isEmpty() ? QByteArray() : [] {
        Report report;
        report.language = u"en"_s;
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        writePdf(report, buffer);
        return buffer.data();
    }());
    QVERIFY2(foreign.contains(u"no report of Palmer"_s), qPrintable(foreign));
    for (const qsizetype length : {qsizetype(0), qsizetype(5), pdf.size() / 3, pdf.size() - 20}) {
        const QString damaged = refusal(pdf.first(length));
        QVERIFY2(damaged.contains(u"damaged"_s), qPrintable(damaged));
    }
    QCOMPARE(refusal(changed(pdf,
                             [](QPDF &document) {
                                 Handle copy = document.getRoot().getKey("/AF").getArrayItem(0).shallowCopy();
                                 copy.replaceKey("/UF", Handle::newString("other.palmer"));
                                 document.getRoot().getKey("/AF").appendItem(copy);
                             }))
                 .contains(u"more than one test file"_s),
             true);
    std::string complaints; // of the library, which would reach the user beside our sentence
    QPDFLogger::defaultLogger()->setError(std::make_shared<Pl_String>("complaints", nullptr, complaints));
    QByteArray plain = withoutObjectStreams(pdf);
    const qsizetype name = plain.indexOf('(', plain.indexOf("/Names [ ("));
    QVERIFY(name > 0);
    plain[name] = '$'; // what follows has no owner any more
    const QString noDictionary = refusal(plain);
    QPDFLogger::defaultLogger()->setError(nullptr);
    QVERIFY2(noDictionary.contains(u"damaged"_s), qPrintable(noDictionary));
    QCOMPARE(QByteArray::fromStdString(complaints), QByteArray());
    const QString wrong = refusal(changed(pdf, [](QPDF &document) {
        replaceAttachment(document, ".palmer", "{\"format\": \"palmer test\"}");
    }));
    QVERIFY(wrong != u"it was read"_s);
}

/// Whatever opens it: only who asked for it again for being damaged would get the same.
void VerifyReport::encryptionIsSaid() {
    const QByteArray pdf = pdfOf(u"limits-2006"_s);
    for (const char *user : {"", "secret"}) {
        QPDF document;
        document.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));
        QPDFWriter writer(document);
        writer.setOutputMemory();
        writer.setObjectStreamMode(qpdf_o_disable);
        writer.setR6EncryptionParameters(user, "owner", true, true, true, true, true, true, qpdf_r3p_full,
                                         true);
        writer.write();
        const auto buffer = writer.getBufferSharedPointer();
        QByteArray closed(reinterpret_cast<const char *>(buffer->getBuffer()),
                          static_cast<qsizetype>(buffer->getSize()));
        QVERIFY2(refusal(closed).contains(u"is encrypted"_s), qPrintable(refusal(closed)));
        closed.replace("/Filter /Standard", "/Filter /Stendard"); // of somebody, as certificates have
        QVERIFY2(refusal(closed).contains(u"is encrypted"_s), qPrintable(refusal(closed)));
        QVERIFY(!isForeignPdf(closed));
    }
}

void VerifyReport::nothingUnpacksBeyondTheBound() {
    const QByteArray pdf = pdfOf(u"limits-2006"_s);
    const QByteArray zeros(static_cast<qsizetype>(mostUnpacked / 2 + 1), '\0');
    constexpr int lengthBefore = 4; // what qCompress writes before the packed bytes
    const std::string packed = qCompress(zeros, 1).mid(lengthBefore).toStdString();
    const QByteArray bomb = changed(pdf, [&](QPDF &document) {
        for (const char *ending : {".palmer", "results.json"})
            attachment(document, ending)
                .replaceStreamData(packed, Handle::newName("/FlateDecode"), Handle::newNull());
    });
    QVERIFY(bomb.size() < 4'000'000);
    const QString sentence = refusal(bomb);
    QVERIFY2(sentence.contains(u"512 MiB"_s), qPrintable(sentence));
}

/// Forms within forms: a few hundred bytes that draw 10¹² lines. What bounds them is no clock.
void VerifyReport::pagesThatDrawWithoutEndAreRefused() {
    const QByteArray endless = changed(pdfOf(u"limits-2006"_s), [&](QPDF &document) {
        QPDFObjectHandle form;
        for (int level = 0; level < 12; ++level) {
            std::string content;
            for (int time = 0; time < 10; ++time)
                content += level == 0 ? "0 0 m 1 1 l S " : "/Inner Do ";
            QPDFObjectHandle outer = QPDFObjectHandle::newStream(&document, content);
            outer.replaceDict(QPDFObjectHandle::parse(
                "<< /Type /XObject /Subtype /Form /BBox [0 0 10 10] /Resources << /XObject << >> >> >>"));
            if (level > 0)
                outer.getDict().getKey("/Resources").getKey("/XObject").replaceKey("/Inner", form);
            form = document.makeIndirectObject(outer);
        }
        QPDFPageObjectHelper page = QPDFPageDocumentHelper(document).getAllPages().front();
        QPDFObjectHandle resources = page.getAttribute("/Resources", true);
        if (!resources.getKey("/XObject").isDictionary())
            resources.replaceKey("/XObject", QPDFObjectHandle::newDictionary());
        resources.getKey("/XObject").replaceKey("/Endless", form);
        page.addPageContents(QPDFObjectHandle::newStream(&document, "/Endless Do"), false);
    });
    const QString sentence = refusal(endless);
    QVERIFY2(sentence.contains(u"drawing operators: too long to verify here"_s), qPrintable(sentence));
}

/// Arrays of arrays, as a damaged reference makes of them: the text in the last one was read 10⁵ times.
void VerifyReport::tagsThatLeadBackToThemselvesAreReadOnce() {
    const QByteArray pdf = pdfOf(u"limits-2006"_s);
    const auto besideOf = [](const QByteArray &bytes) {
        bool exceeded = false;
        return pdfParts(bytes.constData(), static_cast<std::size_t>(bytes.size()), mostUnpacked, exceeded)
            .beside;
    };
    const QByteArray many = changed(pdf, [](QPDF &document) {
        Handle array = document.makeIndirectObject(Handle::parse("[ << /Alt (read aloud) >> ]"));
        for (int level = 0; level < 5; ++level)
            array = document.makeIndirectObject(Handle::newArray(std::vector<Handle>(10, array)));
        document.getRoot().getKey("/StructTreeRoot").replaceKey("/K", array);
    });
    QCOMPARE(std::ranges::count(besideOf(many), "read aloud"), 1);
    const QByteArray endless = changed(pdf, [](QPDF &document) {
        Handle array = document.makeIndirectObject(Handle::parse("[ << /Alt (read aloud) >> ]"));
        array.appendItem(array);
        document.getRoot().getKey("/StructTreeRoot").replaceKey("/K", array);
    });
    QCOMPARE(std::ranges::count(besideOf(endless), "read aloud"), 1);
    QVERIFY(!verified(endless).follows());
}

void VerifyReport::outcomeAsJson() {
    const auto objectOf = [](const Verification &result, bool oneLine) {
        return QJsonDocument::fromJson(
                   verificationJson(result, u"r.pdf"_s, Language(Language::Id::english), oneLine))
            .object();
    };
    const QByteArray pdf = pdfOf(u"limits-2006"_s);
    const QJsonObject json = objectOf(verified(pdf), true);
    QCOMPARE(json["format"_L1].toString(), u"palmer verification"_s);
    QCOMPARE(json["version"_L1].toInt(), 1);
    QCOMPARE(json["follows"_L1], QJsonValue(true));
    QCOMPARE(json["identical"_L1], QJsonValue(true));
    QCOMPARE(json["differences"_L1].toArray().size(), 0);
    Random random(2);
    const QByteArray forged =
        changed(pdf, [&](QPDF &document) { QVERIFY(redraw(document, 0, random, isDigit, isDigit)); });
    const QJsonObject found = objectOf(verified(forged), false);
    QCOMPARE(found["follows"_L1], QJsonValue(false));
    const QJsonObject difference = found["differences"_L1].toArray().first().toObject();
    QCOMPARE(difference["page"_L1].toInt(), 1);
    QVERIFY(difference["printed"_L1].toString() != difference["follows"_L1].toString());
}

PALMER_TEST(runVerifyReport) {
    QHashSeed::setDeterministicGlobalSeed();
    QGuiApplication application(argc, argv);
    VerifyReport test;
    return QTest::qExec(&test, argc, argv);
}

#include "export/resultsjson.h"
#include "verifyreport.moc"
