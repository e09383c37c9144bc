// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/pdf/reports.h"
#include "print/pdf/pages.h"

#include <QDir>
#include <QRawFont>
#include <map>
#include <optional>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <set>

using namespace palmer;
using namespace palmer::testdata;

namespace {

using Handle = QPDFObjectHandle;

QString bytesOf(Handle stream) {
    const auto buffer = stream.getStreamData();
    return QString::fromUtf8(reinterpret_cast<const char *>(buffer->getBuffer()),
                             static_cast<qsizetype>(buffer->getSize()));
}

QStringList arrayOfHex(const QString &text) {
    QStringList result;
    static const QRegularExpression hex(u"<([0-9A-F]+)>"_s);
    for (auto match = hex.globalMatch(text); match.hasNext();)
        result << match.next().captured(1);
    return result;
}

QString fromUtf16(const QString &hex) {
    const QByteArray bytes = QByteArray::fromHex(hex.toLatin1());
    QString result;
    for (qsizetype i = 0; i + 1 < bytes.size(); i += 2)
        result +=
            QChar(static_cast<ushort>(static_cast<uchar>(bytes[i]) << 8 | static_cast<uchar>(bytes[i + 1])));
    return result;
}

/// A font of a page: the text of its glyphs.
struct FontText {
    std::map<unsigned, QString> glyphs;
};

/// A page read operator by operator: what its marked contents say, and what is wrong with it.
class PageReader : public Handle::ParserCallbacks {
public:
    explicit PageReader(Handle page) {
        for (auto &[name, dictionary] : page.getKey("/Resources").getKey("/Font").getDictAsMap()) {
            FontText text;
            const QString map = bytesOf(dictionary.getKey("/ToUnicode"));
            const QStringList list = arrayOfHex(map.mid(map.indexOf(u'[')));
            const QStringList range = arrayOfHex(map.mid(map.indexOf(u"beginbfrange"_s)));
            bool isNumber = false;
            const unsigned first = range.value(0).toUInt(&isNumber, 16);
            for (qsizetype i = 0; i < list.size(); ++i)
                text.glyphs[first + static_cast<unsigned>(i)] = fromUtf16(list[i]);
            fonts[name] = text;
        }
        page.parsePageContents(this);
        if (!open.empty())
            problems << u"marked content is not ended"_s;
    }

    void handleObject(Handle object) override {
        if (!object.isOperator()) {
            operands.push_back(object);
            return;
        }
        const std::string operation = object.getOperatorValue();
        if (operation == "BDC" || operation == "BMC")
            begin();
        else if (operation == "EMC")
            end();
        else if (operation == "BT" || operation == "ET")
            inText = operation == "BT";
        else if (operation == "Tf")
            font = &fonts.at(operands[0].getName());
        else if (operation == "Tj")
            addText();
        else if (paints(operation) && open.empty())
            problems << u"%1 outside of marked content"_s.arg(QString::fromStdString(operation));
        operands.clear();
    }
    void handleEOF() override {}

    std::map<int, QString> texts; ///< by identifier
    QString artifacts;
    QStringList problems;
    bool accentAlone = false;

private:
    struct Open {
        std::optional<int> id;
        bool artifact = false;
        bool actual = false;
        bool inText = false;
    };

    static bool paints(const std::string &operation) {
        static const std::set<std::string> all{"S", "s", "f", "f*", "B", "B*", "b", "b*", "Do", "sh"};
        return all.contains(operation);
    }

    void begin() {
        Open now;
        now.inText = inText;
        now.artifact = operands[0].getName() == "/Artifact";
        const bool isInside = !open.empty();
        if (operands.size() > 1 && operands[1].hasKey("/MCID")) {
            now.id = operands[1].getKey("/MCID").getIntValueAsInt();
            if (texts.contains(*now.id))
                problems << u"identifier %1 twice"_s.arg(*now.id);
            texts[*now.id] = QString();
            if (isInside)
                problems << u"a content within another"_s;
        } else if (operands.size() > 1 && operands[1].hasKey("/ActualText")) {
            now.actual = true;
            add(QString::fromStdString(operands[1].getKey("/ActualText").getUTF8Value()));
        }
        open.push_back(now);
    }

    void end() {
        if (open.empty() || open.back().inText != inText)
            problems << u"marked content is not balanced"_s;
        if (!open.empty())
            open.pop_back();
    }

    void addText() {
        const std::string glyphs = operands[0].getStringValue();
        for (std::size_t i = 0; i + 1 < glyphs.size(); i += 2) {
            const unsigned glyph = static_cast<unsigned>(static_cast<uchar>(glyphs[i])) << 8 |
                                   static_cast<unsigned>(static_cast<uchar>(glyphs[i + 1]));
            const auto known = font->glyphs.find(glyph);
            if (known == font->glyphs.end()) {
                problems << u"glyph %1 has no text"_s.arg(glyph);
                continue;
            }
            if (glyph == 0)
                problems << u"a character that no font has"_s;
            const QString &text = known->second;
            if (text.isEmpty() || text[0].isNull() || text[0] == u'\xFEFF' || text[0] == u'\xFFFE' ||
                text[0] == u'\t')
                problems << u"glyph %1 maps to no character"_s.arg(glyph);
            if (!open.empty() && open.back().actual)
                continue;
            accentAlone = accentAlone || text == u"\u0304"_s;
            add(text);
        }
        if (open.empty())
            problems << u"text outside of marked content"_s;
    }

    void add(const QString &text) {
        for (auto each = open.rbegin(); each != open.rend(); ++each) {
            if (each->id) {
                texts[*each->id] += text;
                return;
            }
        }
        artifacts += text;
    }

    std::map<std::string, FontText> fonts;
    const FontText *font = nullptr;
    std::vector<Handle> operands;
    std::vector<Open> open;
    bool inText = false;
};

/// An element as a reader meets it.
struct Element {
    std::string type;
    mutable Handle object; // libqpdf asks only variable ones
    std::size_t depth = 0;
    std::vector<Element> kids = {};
    QString text = {}; ///< its own, without that of its kids
    int contents = 0;
    int links = 0; ///< references to annotations
};

/// A report taken apart.
class Tagged {
public:
    explicit Tagged(QByteArray bytes)
        : m_bytes(std::move(bytes)) {
        pdf.processMemoryFile("report", m_bytes.constData(), static_cast<std::size_t>(m_bytes.size()));
        for (Handle page : pdf.getAllPages()) {
            numbers[page.getObjGen()] = pages.size();
            pages.emplace_back(page);
            problems << pages.back().problems;
        }
        tree = pdf.getRoot().getKey("/StructTreeRoot");
        if (tree.isDictionary())
            root = elementOf(tree.getKey("/K"), tree, 0);
        checkWayBack();
    }

    /// Calls `visit` with each element in reading order.
    template <class Visit>
    void each(Visit visit) const {
        eachOf(root, visit);
    }

    [[nodiscard]] QString text() const {
        QString result;
        each([&](const Element &element) { result += element.text; });
        return result;
    }

    QPDF pdf;
    std::vector<PageReader> pages;
    Handle tree;
    Element root;
    QStringList problems;

private:
    const QByteArray m_bytes; ///< that libqpdf reads from as long as it lives
    template <class Visit>
    static void eachOf(const Element &element, Visit &visit) {
        visit(element);
        for (const Element &kid : element.kids)
            eachOf(kid, visit);
    }

    Element elementOf(Handle object, Handle parent, std::size_t depth) {
        Element result{object.getKey("/S").getName(), object, depth};
        if (object.getKey("/P").getObjGen() != parent.getObjGen())
            problems << u"an element has another parent"_s;
        Handle kids = object.getKey("/K");
        if (!kids.isArray())
            kids = kids.isNull() ? Handle::newArray() : Handle::newArray({kids});
        for (Handle kid : kids.getArrayAsVector()) {
            if (kid.isInteger())
                addContent(result, object.getKey("/Pg"), kid.getIntValueAsInt());
            else if (kid.getKey("/Type").isNameAndEquals("/MCR"))
                addContent(result, kid.getKey("/Pg"), kid.getKey("/MCID").getIntValueAsInt());
            else if (kid.getKey("/Type").isNameAndEquals("/OBJR"))
                ++result.links;
            else
                result.kids.push_back(elementOf(kid, object, depth + 1));
        }
        return result;
    }

    void addContent(Element &element, Handle page, int id) {
        const auto number = numbers.find(page.getObjGen());
        if (number == numbers.end() || !pages[number->second].texts.contains(id)) {
            problems << u"an element names content that is not there"_s;
            return;
        }
        if (!taken.insert({number->second, id}).second)
            problems << u"content belongs to two elements"_s;
        element.text += pages[number->second].texts[id];
        ++element.contents;
        owners[{number->second, id}] = element.object.getObjGen();
    }

    /// Every content has an element, and the parent tree names it.
    void checkWayBack() {
        if (!tree.isDictionary())
            return;
        Handle nums = tree.getKey("/ParentTree").getKey("/Nums");
        std::map<long long, Handle> parents;
        for (int i = 0; i + 1 < nums.getArrayNItems(); i += 2)
            parents[nums.getArrayItem(i).getIntValue()] = nums.getArrayItem(i + 1);
        std::size_t number = 0;
        for (Handle page : pdf.getAllPages()) {
            Handle list = parents[page.getKey("/StructParents").getIntValue()];
            for (const auto &[id, text] : pages[number].texts) {
                const auto owner = owners.find({number, id});
                if (owner == owners.end())
                    problems << u"content without an element: %1"_s.arg(text);
                else if (id >= list.getArrayNItems() || list.getArrayItem(id).getObjGen() != owner->second)
                    problems << u"the parent tree names another element"_s;
            }
            ++number;
            if (!page.hasKey("/Annots"))
                continue;
            for (Handle annotation : page.getKey("/Annots").getArrayAsVector()) {
                Handle link = parents[annotation.getKey("/StructParent").getIntValue()];
                if (!link.isDictionary() || !link.getKey("/S").isNameAndEquals("/Link"))
                    problems << u"an annotation has no element"_s;
            }
        }
    }

    std::map<QPDFObjGen, std::size_t> numbers; ///< of the pages
    std::set<std::pair<std::size_t, int>> taken;
    std::map<std::pair<std::size_t, int>, QPDFObjGen> owners;
};

// ---- The requirements: what is wrong with a PDF, or nothing ----

bool isTrue(Handle value) {
    return value.isBool() && value.getBoolValue();
}

QStringList isIdentified(Tagged &file) {
    QStringList wrong;
    Handle root = file.pdf.getRoot();
    if (!isTrue(root.getKey("/MarkInfo").getKey("/Marked")) || !file.tree.isDictionary())
        wrong << u"not tagged"_s;
    const QString xmp = bytesOf(root.getKey("/Metadata"));
    for (const QString &needed : {u"<pdfaid:part>3<"_s, u"<pdfaid:conformance>A<"_s, u"<pdfuaid:part>1<"_s,
                                  u"<pdfaSchema:prefix>pdfuaid<"_s, u"<dc:title>"_s}) {
        if (!xmp.contains(needed))
            wrong << needed;
    }
    return wrong;
}

QStringList hasLanguageAndTitle(Tagged &file) {
    QStringList wrong;
    Handle root = file.pdf.getRoot();
    if (root.getKey("/Lang").getUTF8Value().size() != 2)
        wrong << u"language"_s;
    if (!isTrue(root.getKey("/ViewerPreferences").getKey("/DisplayDocTitle")))
        wrong << u"title"_s;
    return wrong;
}

QStringList contentIsMarked(Tagged &file) {
    return file.problems;
}

QStringList elementsAreKnown(Tagged &file) {
    static const std::set<std::string> known{"/Document", "/H1", "/H2",  "/H3",     "/P",
                                             "/L",        "/LI", "/Lbl", "/LBody",  "/Table",
                                             "/TR",       "/TH", "/TD",  "/Figure", "/Link"};
    QStringList wrong;
    file.each([&](const Element &element) {
        if (!known.contains(element.type))
            wrong << QString::fromStdString(element.type);
    });
    return wrong;
}

QStringList headingsSkipNoLevel(Tagged &file) {
    QStringList wrong;
    int level = 0;
    file.each([&](const Element &element) {
        if (element.type.size() != 3 || element.type[1] != 'H')
            return;
        const int own = element.type[2] - '0';
        if (own > level + 1)
            wrong << u"H%1 after H%2: %3"_s.arg(own).arg(level).arg(element.text);
        level = own;
    });
    if (level == 0)
        wrong << u"no heading"_s;
    return wrong;
}

int attribute(const Element &cell, const char *name) {
    Handle value =
        cell.object.getKey("/A").isDictionary() ? cell.object.getKey("/A").getKey(name) : Handle::newNull();
    return value.isInteger() ? value.getIntValueAsInt() : 1;
}

QStringList tablesAreRegular(Tagged &file) {
    QStringList wrong;
    file.each([&](const Element &table) {
        if (table.type != "/Table")
            return;
        std::vector<int> below; // rows that cells above still cover, by column
        int width = 0;
        bool headed = false;
        for (const Element &row : table.kids) {
            if (row.type != "/TR") {
                wrong << u"a table holds "_s + QString::fromStdString(row.type);
                continue;
            }
            int columns = 0;
            std::vector<int> next;
            for (const int rows : below)
                columns += rows > 0 ? 1 : 0;
            int covered = 0;
            for (const Element &cell : row.kids) {
                if (cell.type == "/TH" && !cell.object.getKey("/A").hasKey("/Scope"))
                    wrong << u"a heading cell without scope"_s;
                headed = headed || cell.type == "/TH";
                columns += attribute(cell, "/ColSpan");
                if (attribute(cell, "/RowSpan") > 1)
                    covered = std::max(covered, attribute(cell, "/RowSpan"));
            }
            std::erase_if(below, [](int &rows) { return --rows <= 0; });
            for (const Element &cell : row.kids) {
                if (attribute(cell, "/RowSpan") > 1)
                    below.push_back(attribute(cell, "/RowSpan") - 1);
            }
            if (width > 0 && columns != width)
                wrong << u"%1 columns instead of %2"_s.arg(columns).arg(width);
            width = columns;
        }
        if (!headed)
            wrong << u"a table without heading cells"_s;
    });
    return wrong;
}

QStringList listsHoldItems(Tagged &file) {
    QStringList wrong;
    file.each([&](const Element &element) {
        for (const Element &kid : element.kids) {
            if ((element.type == "/L") != (kid.type == "/LI") ||
                (element.type == "/LI" && kid.type != "/Lbl" && kid.type != "/LBody"))
                wrong << QString::fromStdString(kid.type + " in " + element.type);
        }
    });
    return wrong;
}

QStringList figuresAreDescribed(Tagged &file) {
    QStringList wrong;
    file.each([&](const Element &element) {
        if (element.type != "/Figure")
            return;
        Handle alternative = element.object.getKey("/Alt");
        if (!alternative.isString() || alternative.getUTF8Value().size() < 3)
            wrong << u"no alternative text"_s;
        Handle box = element.object.getKey("/A").getKey("/BBox");
        Handle paper = element.object.getKey("/Pg").getKey("/MediaBox");
        for (int i = 0; i < 4; ++i) {
            const double value = box.getArrayItem(i).getNumericValue();
            if (value < 0 || value > paper.getArrayItem(i % 2 + 2).getNumericValue())
                wrong << u"its box leaves the page"_s;
        }
    });
    return wrong;
}

QStringList linksAreDescribed(Tagged &file) {
    QStringList wrong;
    int annotations = 0;
    int links = 0;
    for (Handle page : file.pdf.getAllPages()) {
        if (!page.getKey("/Tabs").isNameAndEquals("/S"))
            wrong << u"the order of tabulators is not that of the structure"_s;
        if (!page.hasKey("/Annots"))
            continue;
        for (Handle annotation : page.getKey("/Annots").getArrayAsVector()) {
            ++annotations;
            if (!annotation.getKey("/Contents").isString() ||
                annotation.getKey("/Contents").getUTF8Value().empty())
                wrong << u"a link does not say where it leads"_s;
        }
    }
    file.each([&](const Element &element) { links += element.links; });
    if (annotations != links)
        wrong << u"%1 links of %2 have an element"_s.arg(links).arg(annotations);
    return wrong;
}

QStringList fontsAreEmbeddedAndNamed(Tagged &file) {
    static const QRegularExpression subset(u"^/[A-Z]{6}\\+"_s);
    QStringList wrong;
    for (Handle page : file.pdf.getAllPages()) {
        for (auto &[name, font] : page.getKey("/Resources").getKey("/Font").getDictAsMap()) {
            Handle own = font.getKey("/DescendantFonts").getArrayItem(0);
            Handle descriptor = own.getKey("/FontDescriptor");
            const QString base = QString::fromStdString(font.getKey("/BaseFont").getName());
            if (!subset.match(base).hasMatch() || own.getKey("/BaseFont").getName() != base.toStdString() ||
                descriptor.getKey("/FontName").getName() != base.toStdString())
                wrong << base;
            if (!descriptor.getKey("/FontFile2").isStream())
                wrong << u"not embedded"_s;
            if (descriptor.hasKey("/CIDSet"))
                wrong << u"a list of glyphs that may lack some"_s;
            if (!own.hasKey("/CIDToGIDMap") || !own.hasKey("/W"))
                wrong << u"no glyphs or widths"_s;
        }
    }
    return wrong;
}

/// Both are thousandths of the size.
QStringList widthsAreThoseOfTheFont(Tagged &file) {
    QStringList wrong;
    std::set<QPDFObjGen> known;
    for (Handle page : file.pdf.getAllPages()) {
        for (auto &[name, font] : page.getKey("/Resources").getKey("/Font").getDictAsMap()) {
            if (!known.insert(font.getObjGen()).second)
                continue;
            Handle own = font.getKey("/DescendantFonts").getArrayItem(0);
            const auto bytes = own.getKey("/FontDescriptor").getKey("/FontFile2").getStreamData();
            const QRawFont embedded(QByteArray(reinterpret_cast<const char *>(bytes->getBuffer()),
                                               static_cast<qsizetype>(bytes->getSize())),
                                    1000, QFont::PreferNoHinting);
            std::vector<Handle> list = own.getKey("/W").getArrayAsVector();
            if (!embedded.isValid() || list.size() != 2 || !list[1].isArray()) {
                wrong << u"a font or its widths cannot be read"_s;
                continue;
            }
            auto glyph = static_cast<quint32>(list[0].getIntValueAsInt());
            for (Handle width : list[1].getArrayAsVector()) {
                const auto advances = embedded.advancesForGlyphIndexes({glyph}, QRawFont::UseDesignMetrics);
                if (advances.size() != 1 || std::abs(advances[0].x() - width.getNumericValue()) > 1)
                    wrong << u"glyph %1 is %2 wide"_s.arg(glyph).arg(width.getNumericValue());
                ++glyph;
            }
        }
    }
    if (known.empty())
        wrong << u"no fonts"_s;
    return wrong;
}

QStringList textIsText(Tagged &file) {
    QStringList wrong;
    for (const PageReader &page : file.pages) {
        if (page.accentAlone)
            wrong << u"an accent without its letter"_s;
        if (page.artifacts.contains(u'\0'))
            wrong << u"U+0000"_s;
    }
    if (!file.text().contains(u' '))
        wrong << u"no blanks"_s;
    return wrong;
}

QStringList filesAreDescribed(Tagged &file) {
    QStringList wrong;
    for (Handle each : file.pdf.getRoot().getKey("/AF").getArrayAsVector()) {
        for (const char *key : {"/F", "/UF", "/Desc", "/AFRelationship"}) {
            if (!each.hasKey(key))
                wrong << QString::fromLatin1(key);
        }
    }
    return wrong;
}

struct CheckedRequirement {
    const char *name;
    QStringList (*wrong)(Tagged &);
};

/// Each stands in doc/tagged-pdf.md with its result.
constexpr CheckedRequirement requirements[]{
    {"identified as PDF/A-3a and PDF/UA-1", isIdentified},
    {"language and title", hasLanguageAndTitle},
    {"all content marked or artifact, found from both sides", contentIsMarked},
    {"standard structure types only", elementsAreKnown},
    {"headings skip no level", headingsSkipNoLevel},
    {"tables regular, with scoped heading cells", tablesAreRegular},
    {"lists hold items of label and body", listsHoldItems},
    {"figures with alternative text and box", figuresAreDescribed},
    {"links with description and element", linksAreDescribed},
    {"fonts embedded and named as subsets", fontsAreEmbeddedAndNamed},
    {"widths in the PDF are those of the font", widthsAreThoseOfTheFont},
    {"every glyph maps to its character", textIsText},
    {"attached files described", filesAreDescribed},
};

QStringList exampleNames() {
    QStringList result = storedDocuments;
    for (const QString &name : QDir(QStringLiteral(EXAMPLES)).entryList({u"*.palmer"_s})) {
        if (!result.contains(name.chopped(7)))
            result << name.chopped(7);
    }
    return result;
}

} // namespace

/// No validator of PDF/A-3a or PDF/UA-1 is at hand: this is our own check of what a program can check.
class TaggedPdf : public QObject {
    Q_OBJECT

private slots:
    void meetsEachRequirement_data();
    void meetsEachRequirement();
    void theListNamesEachRequirement();
    void isReadInTheOrderOfTheReport_data();
    void isReadInTheOrderOfTheReport();
    void longTablesAreToldRowByRow();
};

void TaggedPdf::meetsEachRequirement_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Language::Id>("language");
    int number = 0;
    for (const QString &name : exampleNames()) {
        const Language::Id language = ++number % 2 ? Language::Id::french : Language::Id::english;
        QTest::newRow(qPrintable(name)) << name << language;
    }
}

void TaggedPdf::meetsEachRequirement() {
    QFETCH(const QString, name);
    QFETCH(const Language::Id, language);
    Document document = storedDocument(name);
    document.report.include.push_back(ReportExtra::diagnosis);
    const Report report = reportOf(document, language);
    Tagged file(pdfOf(report));
    for (const CheckedRequirement &requirement : requirements) {
        const QStringList wrong = requirement.wrong(file);
        QVERIFY2(wrong.isEmpty(),
                 qPrintable(QString::fromUtf8(requirement.name) + u": "_s + wrong.mid(0, 10).join(u" · "_s)));
    }
}

void TaggedPdf::theListNamesEachRequirement() {
    QFile list(QStringLiteral(PALMER_SOURCE_DIR "/doc/tagged-pdf.md"));
    QVERIFY(list.open(QIODevice::ReadOnly));
    const QByteArray text = list.readAll();
    for (const CheckedRequirement &requirement : requirements)
        QVERIFY2(text.contains(requirement.name), requirement.name);
}

void TaggedPdf::isReadInTheOrderOfTheReport_data() {
    QTest::addColumn<QString>("name");
    for (const QString &name : storedDocuments)
        QTest::newRow(qPrintable(name)) << name;
}

/// Headings, running text and verdicts, as they follow in the report; nothing of them is an artifact.
void TaggedPdf::isReadInTheOrderOfTheReport() {
    QFETCH(const QString, name);
    const Report report = arrangedForPages(reportOf(storedDocument(name), Language::Id::english));
    const Tagged file(pdfOf(report));
    const QString text = squeezed(file.text());
    qsizetype at = 0;
    int found = 0;
    for (const Block &block : report.blocks) {
        QString words;
        if (const auto *heading = std::get_if<Heading>(&block))
            words = heading->text + heading->note.plain();
        else if (const auto *paragraph = std::get_if<Paragraph>(&block))
            words = paragraph->text;
        else if (const auto *table = std::get_if<Table>(&block); table && !table->rows.empty())
            words = table->rows.back().front().text.plain();
        words = squeezed(words);
        if (words.contains(u'%') && words.contains(u'1'))
            continue; // with a page number
        const qsizetype next = text.indexOf(words, at);
        QVERIFY2(next >= 0, qPrintable(words));
        at = next + words.size();
        found += words.isEmpty() ? 0 : 1;
    }
    QVERIFY(found > 5);
}

void TaggedPdf::longTablesAreToldRowByRow() {
    Table table;
    table.columns = {columnOf(Phrase(u"i"_s), 20), columnOf(Phrase(u"x"_s), 20)};
    for (int i = 0; i < 2001; ++i)
        table.rows.push_back({Cell(QString::number(i)), Cell(u"1"_s)});
    Report report;
    report.language = u"en"_s;
    report.title = u"Rows"_s;
    report.blocks = {Heading{1, u"Rows"_s}, table};
    Tagged file(pdfOf(report));
    QCOMPARE(tablesAreRegular(file), QStringList());
    int cells = 0;
    file.each([&](const Element &element) { cells += element.type == "/TD" ? 1 : 0; });
    QCOMPARE(cells, 2001);
}

QTEST_MAIN(TaggedPdf)

#include "taggedpdf.moc"
