// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Reports, forgeries and damaged files in numbers, each by chance from one seed:
//
//     print_tests core/print/proof/verifyreports REPORTS FORGERIES DAMAGED [SEED]
//
// Every report has to follow from its data, no forgery may, and of damaged files only those whose text,
// attachments and pages, read with other programs, are still the same. Prints the counts; ends with 1 and
// what it found when one is not as it has to be.

#include "core/print/proof/forgery.h"
#include "document/readdocument.h"
#include "patience.h"

#include <QDir>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QHashSeed>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>

using namespace palmer;
using namespace palmer::testdata;

namespace {

struct Made {
    EvaluatedDocument evaluated;
    Language::Id language = Language::Id::english;
    QByteArray pdf;
};

std::vector<Document> storedDocuments() {
    std::vector<Document> result;
    for (const char *folder : {DOCUMENTS, EXAMPLES}) {
        const QDir directory(QString::fromUtf8(folder));
        for (const QString &name : directory.entryList({u"*.palmer"_s}, QDir::Files, QDir::Name)) {
            QFile file(directory.filePath(name));
            if (file.open(QIODevice::ReadOnly) && file.size() < 400'000)
                result.push_back(readDocument(file.readAll()));
        }
    }
    return result;
}

/// The same test with other readings: by up to 2 µm (or 2e-3 degrees).
void shake(Test &test, Random &random) {
    std::uniform_real_distribution<double> step(-0.002, 0.002);
    const auto move = [&](double &value) { value = std::round((value + step(random)) * 1e5) / 1e5; };
    if (auto *positioning = std::get_if<PositioningMeasurement>(&test.measurement)) {
        for (Run &run : positioning->runs) {
            for (auto &deviation : run.deviations) {
                if (deviation)
                    move(*deviation);
            }
        }
    } else if (auto *circular = std::get_if<CircularMeasurement>(&test.measurement)) {
        for (Arc &arc : circular->arcs)
            std::ranges::for_each(arc.radialDeviations, move);
    }
}

Document madeDocument(const std::vector<Document> &stored, Random &random) {
    Document document = stored[below(random, stored.size())];
    for (TestPointer &test : document.tests) {
        auto shaken = std::make_shared<Test>(*test);
        shake(*shaken, random);
        shaken->date = u"2026-%1-%2"_s.arg(1 + below(random, 12), 2, 10, QChar(u'0'))
                           .arg(1 + below(random, 28), 2, 10, QChar(u'0'))
                           .toStdString();
        test = std::move(shaken);
    }
    if (below(random, 3) == 0 && document.tests.size() == 1) { // several tests
        auto other = std::make_shared<Test>(*document.tests.front());
        shake(*other, random);
        other->id.clear();
        document.tests.push_back(std::move(other));
    }
    document.report.number = "R/" + std::to_string(below(random, 100000));
    document.report.paper = below(random, 2) == 0 ? Paper::a4 : Paper::letter;
    if (below(random, 3) == 0)
        document.report.leaveOut = {ReportPart::readings};
    if (below(random, 5) == 0)
        document.report.leaveOut.push_back(ReportPart::annex);
    if (below(random, 4) == 0)
        document.report.date.reset();
    return document;
}

Made made(const std::vector<Document> &stored, Random &random) {
    Made result;
    result.evaluated = evaluate(std::make_shared<const Document>(madeDocument(stored, random)));
    result.language = below(random, 2) == 0 ? Language::Id::french : Language::Id::english;
    result.pdf = reportPdf(result.evaluated, result.language, below(random, 5) != 0);
    return result;
}

struct Forgery {
    const char *name;
    std::function<bool(QPDF &, const Made &, const Made &other, Random &)>
        forge; ///< false: there is nothing to
};

int anyPage(QPDF &document, Random &random) {
    return static_cast<int>(below(random, document.getAllPages().size()));
}

QByteArray anotherNumber(QByteArray json, Random &random) {
    static const QRegularExpression value(u"(?<=\"value\": )-?[0-9.]+[0-9]"_s);
    auto matches = value.globalMatch(QString::fromUtf8(json));
    std::vector<QRegularExpressionMatch> found;
    while (matches.hasNext())
        found.push_back(matches.next());
    if (found.empty())
        return {};
    const auto &chosen = found[below(random, found.size())];
    json.replace(chosen.capturedStart(), chosen.capturedLength(), "0.123456");
    return json;
}

/// The glyph is drawn as another one of its font, and said to be what it was.
bool drawUnsaid(QPDF &document, Random &random) {
    Handle page = document.getAllPages().at(static_cast<std::size_t>(anyPage(document, random)));
    Handle fonts = page.getKey("/Resources").getKey("/Font");
    const auto names = fonts.getKeys();
    for (const std::string &name : names) {
        Handle font = fonts.getKey(name);
        const auto signs = signsOf(font);
        std::vector<int> digits;
        for (const auto &[glyph, sign] : signs) {
            if (isDigit(sign))
                digits.push_back(glyph);
        }
        const PageContent content = contentOf(page);
        const auto isDrawn = [&](int glyph) {
            return std::ranges::any_of(content.glyphs, [&](const DrawnGlyph &drawn) {
                return drawn.glyph == glyph && "/" + drawn.font == name;
            });
        };
        if (digits.size() < 2 || !isDrawn(digits[0]))
            continue;
        QByteArray map;
        for (int glyph = 0; glyph <= signs.rbegin()->first; ++glyph) {
            const int drawn = glyph == digits[0] ? digits[1] : glyph;
            map += static_cast<char>(drawn >> 8);
            map += static_cast<char>(drawn & 0xFF);
        }
        font.getKey("/DescendantFonts")
            .getArrayItem(0)
            .replaceKey("/CIDToGIDMap", Handle::newStream(&document, map.toStdString()));
        return true;
    }
    return false;
}

std::vector<Forgery> forgeries() {
    const auto letters = [](QChar c) { return c.isLetter(); };
    return {
        {"a digit",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             return redraw(pdf, anyPage(pdf, random), random, isDigit, isDigit);
         }},
        {"a sign",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             return redraw(
                 pdf, anyPage(pdf, random), random,
                 [](QChar c) { return c == QChar(0x2212) || c == u'+' || c == QChar(0xB1); },
                 [](QChar c) { return c.isSpace() || c == u'+' || c == QChar(0xB1); });
         }},
        {"a decimal mark",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             return redraw(
                 pdf, anyPage(pdf, random), random, [](QChar c) { return c == u'.' || c == u','; }, isDigit);
         }},
        {"a letter",
         [letters](QPDF &pdf, const Made &, const Made &, Random &random) {
             return redraw(pdf, anyPage(pdf, random), random, letters, letters);
         }},
        {"a digit that is drawn otherwise than it is said",
         [](QPDF &pdf, const Made &, const Made &, Random &random) { return drawUnsaid(pdf, random); }},
        {"the data of another report",
         [](QPDF &pdf, const Made &, const Made &other, Random &) {
             replaceAttachment(pdf, ".palmer", attachedFile(*other.evaluated.document));
             return true;
         }},
        {"other results",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             const QByteArray json = anotherNumber(dataOf(attachment(pdf, "results.json")), random);
             if (!json.isEmpty())
                 replaceAttachment(pdf, "results.json", json);
             return !json.isEmpty();
         }},
        {"a page of another report",
         [](QPDF &pdf, const Made &, const Made &other, Random &random) {
             QPDF another;
             another.processMemoryFile("other", other.pdf.constData(),
                                       static_cast<std::size_t>(other.pdf.size()));
             Handle theirs = pdf.copyForeignObject(
                 QPDFPageObjectHelper(another.getAllPages().front()).shallowCopyPage().getObjectHandle());
             const Handle ours = pdf.getAllPages().at(static_cast<std::size_t>(anyPage(pdf, random)));
             pdf.addPageAt(theirs, true, ours);
             pdf.removePage(ours);
             return true;
         }},
        {"a page less",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             const auto pages = pdf.getAllPages();
             pdf.removePage(pages.at(below(random, pages.size())));
             return true;
         }},
        {"a page cut",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             Handle(pdf.getAllPages().at(static_cast<std::size_t>(anyPage(pdf, random))))
                 .replaceKey("/CropBox", Handle::parse("[0 100 595 842]"));
             return true;
         }},
        {"a number over a number",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             Handle note = Handle::parse("<< /Type /Annot /Subtype /FreeText /F 4 /Rect [200 400 260 420] "
                                         "/Contents (8.7) /DA (/Helv 9 Tf 0 g) >>");
             Handle page = pdf.getAllPages().at(static_cast<std::size_t>(anyPage(pdf, random)));
             if (!page.hasKey("/Annots"))
                 page.replaceKey("/Annots", Handle::newArray());
             page.getKey("/Annots").appendItem(pdf.makeIndirectObject(note));
             return true;
         }},
        {"a white box",
         [](QPDF &pdf, const Made &, const Made &, Random &random) {
             Handle page = pdf.getAllPages().at(static_cast<std::size_t>(anyPage(pdf, random)));
             // Beside the transformation of the page: over its footer, which every page has.
             setContent(pdf, page, "q\n" + contentOf(page).stream + "\nQ q 1 g 0 20 595 20 re f Q");
             return true;
         }},
        {"another language",
         [](QPDF &pdf, const Made &made, const Made &, Random &) {
             Handle packet = pdf.getRoot().getKey("/Metadata");
             QByteArray xmp = dataOf(packet);
             const bool french = made.language == Language::Id::french;
             xmp.replace(french ? "<palmer:Language>fr" : "<palmer:Language>en",
                         french ? "<palmer:Language>en" : "<palmer:Language>fr");
             packet.replaceStreamData(xmp.toStdString(), Handle::newNull(), Handle::newNull());
             return true;
         }},
    };
}

QByteArray damaged(QByteArray bytes, Random &random) {
    for (auto changes = 1 + below(random, 3); changes > 0; --changes) {
        const auto at = static_cast<qsizetype>(below(random, static_cast<std::size_t>(bytes.size())));
        switch (below(random, 5)) {
        case 0:
            bytes.truncate(at);
            break;
        case 1:
            bytes.remove(at, static_cast<qsizetype>(1 + below(random, 200)));
            break;
        case 2:
            bytes.insert(
                at, QByteArray(static_cast<qsizetype>(1 + below(random, 20)), static_cast<char>(random())));
            break;
        case 3: // bits that flip
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8)));
            break;
        default: // a block of zeros, as a lost sector leaves
            std::fill(bytes.begin() + at, bytes.begin() + std::min<qsizetype>(at + 512, bytes.size()), '\0');
        }
        if (bytes.isEmpty())
            break;
    }
    return bytes;
}

QByteArray output(const QString &program, const QStringList &arguments) {
    QProcess process;
    process.start(program, arguments);
    process.waitForFinished(patience);
    return process.readAllStandardOutput();
}

/// Text, pages and attachments as the programs of poppler see them.
QByteArray seen(const QByteArray &pdf) {
    const QTemporaryDir folder;
    QFile file(folder.filePath(u"report.pdf"_s));
    if (!file.open(QIODevice::WriteOnly) || file.write(pdf) != pdf.size())
        return {};
    file.close();
    QByteArray result = output(u"pdftotext"_s, {u"-raw"_s, file.fileName(), u"-"_s});
    result += output(u"pdftoppm"_s, {u"-r"_s, u"72"_s, file.fileName()});
    output(u"pdfdetach"_s, {u"-saveall"_s, u"-o"_s, folder.path(), file.fileName()});
    for (const QString &name : QDir(folder.path()).entryList(QDir::Files, QDir::Name)) {
        QFile attached(folder.filePath(name));
        if (name != "report.pdf"_L1 && attached.open(QIODevice::ReadOnly))
            result += name.toUtf8() + attached.readAll();
    }
    return result;
}

class Trial {
public:
    explicit Trial(Random::result_type seed)
        : m_random(seed)
        , m_stored(storedDocuments()) {}

    void reports(int count) {
        QElapsedTimer since;
        since.start();
        int identical = 0;
        for (int i = 0; i < count; ++i) {
            const Made report = made(m_stored, m_random);
            // As it is, and written anew by another program: then words and pictures are compared.
            const bool anew = i % 2 == 1;
            const Verification result = verified(anew ? changed(report.pdf, [](QPDF &) {}) : report.pdf);
            identical += result.identical ? 1 : 0;
            if (!result.follows() || (!anew && !result.identical))
                fail("report", i, result);
        }
        std::printf("%d reports: all follow, %d of them identical (%lld ms)\n", count, identical,
                    static_cast<long long>(since.elapsed()));
    }

    void forgeriesOf(int count) {
        const std::vector<Forgery> kinds = forgeries();
        std::map<std::string, int> counts;
        int refused = 0;
        for (int i = 0; i < count;) {
            const Made report = made(m_stored, m_random);
            const Made other = made(m_stored, m_random);
            for (int k = 0; k < 10 && i < count; ++k) { // several of each, to make fewer
                const Forgery &kind = kinds[static_cast<std::size_t>(i) % kinds.size()];
                bool isForged = false;
                QByteArray forged = changed(
                    report.pdf, [&](QPDF &pdf) { isForged = kind.forge(pdf, report, other, m_random); });
                ++i;
                if (!isForged)
                    continue;
                ++counts[kind.name];
                try {
                    const Verification result = verified(forged);
                    if (result.follows())
                        fail(kind.name, i, result);
                } catch (const Error &) {
                    ++refused; // the data of another report cannot be read as such
                }
            }
        }
        int all = 0;
        for (const auto &[name, number] : counts) {
            std::printf("  %5d %s\n", number, name.c_str());
            all += number;
        }
        std::printf("%d forgeries: %d found, %d refused, none passed\n", all, all - refused - m_failures,
                    refused);
    }

    void damagedFiles(int count) {
        int refused = 0, different = 0, same = 0;
        for (int i = 0; i < count;) {
            const Made report = made(m_stored, m_random);
            const QByteArray expected = count > 0 ? seen(report.pdf) : QByteArray();
            for (int k = 0; k < 100 && i < count; ++k, ++i) {
                const QByteArray file = damaged(report.pdf, m_random);
                try {
                    const Verification result = verified(file);
                    if (!result.follows()) {
                        ++different;
                    } else if (file == report.pdf || seen(file) == expected) {
                        ++same;
                    } else {
                        fail("damaged", i, result);
                        keep(u"damaged-%1.pdf"_s.arg(i), file);
                        keep(u"damaged-%1-before.pdf"_s.arg(i), report.pdf);
                    }
                } catch (const Error &) {
                    ++refused;
                }
            }
        }
        std::printf("%d damaged: %d refused, %d differ, %d are unchanged in text, pages and attachments\n",
                    count, refused, different, same);
    }

    [[nodiscard]] int failures() const { return m_failures; }

private:
    /// To be looked at.
    static void keep(const QString &name, const QByteArray &bytes) {
        QFile file(QDir::temp().filePath(name));
        if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size())
            std::printf("  kept as %s\n", qPrintable(file.fileName()));
    }

    void fail(const char *what, int index, const Verification &result) {
        ++m_failures;
        std::printf("WRONG: %s %d: %s\n", what, index,
                    verificationText(result, Language(Language::Id::english)).toUtf8().constData());
    }

    Random m_random;
    std::vector<Document> m_stored;
    int m_failures = 0;
};

} // namespace

PALMER_TEST(runVerifyReports) {
    QHashSeed::setDeterministicGlobalSeed();
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QGuiApplication application(argc, argv);
    if (argc < 4) {
        std::fprintf(stderr, "verifyreports REPORTS FORGERIES DAMAGED [SEED]\n");
        return 2;
    }
    Trial run(argc > 4 ? static_cast<Random::result_type>(std::atoll(argv[4])) : 1);
    run.reports(std::atoi(argv[1]));
    run.forgeriesOf(std::atoi(argv[2]));
    run.damagedFiles(std::atoi(argv[3]));
    return run.failures() == 0 ? 0 : 1;
}
