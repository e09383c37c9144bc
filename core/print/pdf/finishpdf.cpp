// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/finishpdf.h"

#include "print/pdf/pdffile.h"
#include "print/pdf/structuretree.h"
#include "print/pdf/tagpdf.h"

#include <QFile>
#include <QStringList>
#include <algorithm>
#include <iterator>
#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/InputSource.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace palmer {

namespace {

using Handle = QPDFObjectHandle;

Handle text(const QString &value) {
    return Handle::newUnicodeString(value.toStdString());
}

/// "D:20261120000000Z"
std::string pdfDate(const QString &iso) {
    QString digits = iso;
    digits.remove(u'-');
    return "D:" + digits.toStdString() + "000000Z";
}

void setInformation(QPDF &document, const ReportMetadata &metadata) {
    Handle information = Handle::newDictionary();
    information.replaceKey("/Title", text(metadata.title));
    information.replaceKey("/Creator", text(QStringLiteral("Palmer")));
    if (!metadata.author.isEmpty())
        information.replaceKey("/Author", text(metadata.author));
    if (!metadata.date.isEmpty()) {
        information.replaceKey("/CreationDate", Handle::newString(pdfDate(metadata.date)));
        information.replaceKey("/ModDate", Handle::newString(pdfDate(metadata.date)));
    }
    document.getTrailer().replaceKey("/Info", document.makeIndirectObject(information));
}

void setMetadata(QPDF &document, const QByteArray &xmp) {
    Handle packet = Handle::newStream(&document, xmp.toStdString());
    packet.getDict().replaceKey("/Type", Handle::newName("/Metadata"));
    packet.getDict().replaceKey("/Subtype", Handle::newName("/XML"));
    document.getRoot().replaceKey("/Metadata", packet);
}

/// Replaces the library's helper, which would compress again and compute an MD5 of all readings that is not
/// needed: the report prints their SHA-256.
Handle packedStream(QPDF &document, const PdfAttachment &attachment) {
    const QByteArray &packed = attachment.packed.get();
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast,cppcoreguidelines-pro-type-const-cast)
    auto *bytes = reinterpret_cast<unsigned char *>(const_cast<char *>(packed.constData())); // not copied
    Handle stream = Handle::newStream(
        &document, std::make_shared<Buffer>(bytes, static_cast<std::size_t>(packed.size())));
    Handle size = Handle::newDictionary();
    size.replaceKey("/Size", Handle::newInteger(attachment.size));
    stream.getDict().replaceKey("/Type", Handle::newName("/EmbeddedFile"));
    stream.getDict().replaceKey("/Filter", Handle::newName("/FlateDecode"));
    stream.getDict().replaceKey("/Params", size);
    return stream;
}

/// The library's helpers write neither the relationship nor the list of associated files.
void attach(QPDF &document, const std::vector<PdfAttachment> &attachments, const QString &date) {
    Handle associated = Handle::newArray();
    QPDFEmbeddedFileDocumentHelper files(document);
    for (const PdfAttachment &attachment : attachments) {
        QPDFEFStreamObjectHelper stream(packedStream(document, attachment));
        stream.setSubtype(attachment.mimeType.toStdString());
        if (!date.isEmpty()) {
            stream.setCreationDate(pdfDate(date));
            stream.setModDate(pdfDate(date));
        }
        const std::string name = attachment.name.toStdString();
        auto file = QPDFFileSpecObjectHelper::createFileSpec(document, name, stream);
        file.setDescription(attachment.description.toStdString());
        file.getObjectHandle().replaceKey("/AFRelationship", Handle::newName(attachment.relationship));
        files.replaceEmbeddedFile(name, file);
        associated.appendItem(file.getObjectHandle());
    }
    if (!attachments.empty())
        document.getRoot().replaceKey("/AF", associated);
}

/// Replaces the sRGB profile by one with its curves as formulas: viewers invert Qt's tables of 1 024 values
/// on each page, which takes longer than drawing it.
void setColourProfile(QPDF &document) {
    Handle intents = document.getRoot().getKey("/OutputIntents");
    if (!intents.isArray())
        return;
    QFile file(QStringLiteral(":/colour/srgb.icc"));
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error("no colour profile");
    intents.getArrayItem(0)
        .getKey("/DestOutputProfile")
        .replaceStreamData(file.readAll().toStdString(), Handle::newNull(), Handle::newNull());
}

double heightOf(Handle page) {
    return page.getKey("/MediaBox").getArrayItem(3).getNumericValue();
}

/// Destination at this place over the full page width, keeping the zoom.
Handle destination(const std::vector<Handle> &pages, const PdfPlace &place) {
    const Handle &page = pages.at(static_cast<std::size_t>(place.page));
    return Handle::newArray({page, Handle::newName("/XYZ"), Handle::newInteger(0),
                             Handle::newReal(heightOf(page) - place.y, 2), Handle::newNull()});
}

/// Returns the annotations.
std::vector<Handle> addLinks(QPDF &document, const std::vector<Handle> &pages,
                             const std::vector<PdfLink> &links) {
    std::vector<Handle> annotations;
    for (const PdfLink &link : links) {
        Handle page = pages.at(static_cast<std::size_t>(link.page));
        const double height = heightOf(page);
        Handle annotation = Handle::parse("<< /Type /Annot /Subtype /Link /F 4 /Border [0 0 0] >>");
        annotation.replaceKey("/Rect", Handle::newArray({Handle::newReal(link.area.left(), 2),
                                                         Handle::newReal(height - link.area.bottom(), 2),
                                                         Handle::newReal(link.area.right(), 2),
                                                         Handle::newReal(height - link.area.top(), 2)}));
        annotation.replaceKey("/Dest", destination(pages, link.target));
        if (!page.hasKey("/Annots"))
            page.replaceKey("/Annots", Handle::newArray());
        annotation.replaceKey("/Contents", text(link.title));
        annotations.push_back(document.makeIndirectObject(annotation));
        page.getKey("/Annots").appendItem(annotations.back());
    }
    return annotations;
}

/// Links the items of one level below `parent`, with `shown` of them and their children open.
void tie(Handle parent, std::vector<Handle> &items, std::size_t shown) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        items[i].replaceKey("/Parent", parent);
        if (i > 0)
            items[i].replaceKey("/Prev", items[i - 1]);
        if (i + 1 < items.size())
            items[i].replaceKey("/Next", items[i + 1]);
    }
    if (items.empty())
        return;
    parent.replaceKey("/First", items.front());
    parent.replaceKey("/Last", items.back());
    parent.replaceKey("/Count", Handle::newInteger(static_cast<long long>(shown)));
}

void addBookmarks(QPDF &document, const std::vector<Handle> &pages,
                  const std::vector<PdfBookmark> &bookmarks) {
    if (bookmarks.empty())
        return;
    Handle outline = document.makeIndirectObject(Handle::parse("<< /Type /Outlines >>"));
    std::vector<Handle> above;
    std::vector<Handle> below;
    for (const PdfBookmark &bookmark : bookmarks) {
        Handle item = document.makeIndirectObject(Handle::newDictionary());
        item.replaceKey("/Title", text(bookmark.title));
        item.replaceKey("/Dest", destination(pages, bookmark.target));
        if (bookmark.level == 0 || above.empty()) {
            if (!above.empty())
                tie(above.back(), below, below.size());
            below.clear();
            above.push_back(item);
        } else {
            below.push_back(item);
        }
    }
    tie(above.back(), below, below.size());
    tie(outline, above, bookmarks.size());
    document.getRoot().replaceKey("/Outlines", outline);
}

/// Lets libqpdf read what Qt wrote without having it in memory.
class DeviceSource : public InputSource {
public:
    explicit DeviceSource(QIODevice &device)
        : m_device(device) {}

    qpdf_offset_t findAndSkipNextEOL() override {
        const auto isEnd = [](char c) { return c == '\r' || c == '\n'; };
        char c = 0;
        while (m_device.getChar(&c) && !isEnd(c)) {
        }
        const qpdf_offset_t end = m_device.pos() - (isEnd(c) ? 1 : 0);
        while (m_device.getChar(&c)) {
            if (!isEnd(c)) {
                m_device.ungetChar(c);
                break;
            }
        }
        return end;
    }
    [[nodiscard]] std::string const &getName() const override { return m_name; }
    qpdf_offset_t tell() override { return m_device.pos(); }
    void seek(qpdf_offset_t offset, int whence) override {
        m_device.seek(offset + (whence == SEEK_CUR   ? m_device.pos()
                                : whence == SEEK_END ? m_device.size()
                                                     : 0));
    }
    void rewind() override { m_device.seek(0); }
    size_t read(char *bytes, size_t length) override {
        last_offset = m_device.pos();
        return static_cast<size_t>(std::max(m_device.read(bytes, static_cast<qint64>(length)), qint64(0)));
    }
    void unreadCh(char) override { m_device.seek(m_device.pos() - 1); }

private:
    QIODevice &m_device;
    std::string m_name = "report";
};

/// Writes all that the document needs, but the objects `written`.
void writeObjects(PdfFile &file, QPDF &document, std::set<QPDFObjGen> written) {
    std::vector<Handle> found{document.getRoot(), document.getTrailer().getKey("/Info")};
    while (!found.empty()) {
        Handle object = found.back();
        found.pop_back();
        if (object.isIndirect() && !written.insert(object.getObjGen()).second)
            continue;
        Handle entries = object.isStream() ? object.getDict().shallowCopy() : object;
        if (object.isStream()) {
            entries.removeKey("/Length");
            const auto data = object.getRawStreamData();
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of libqpdf
            const std::string_view bytes(reinterpret_cast<const char *>(data->getBuffer()), data->getSize());
            std::string text = entries.unparse();
            text = text.substr(2, text.size() - 4);                                   // between << and >>
            const bool isOpen = entries.getKey("/Type").isNameAndEquals("/Metadata"); // for any program
            isOpen || entries.hasKey("/Filter") ? file.addStream(object.getObjectID(), text, bytes)
                                                : file.addPacked(object.getObjectID(), text, bytes);
        } else if (object.isIndirect()) {
            file.add(object.getObjectID(), object.unparseResolved());
        }
        if (entries.isArray()) {
            std::ranges::copy(entries.getArrayAsVector(), std::back_inserter(found));
        } else if (entries.isDictionary()) {
            for (const auto &[key, value] : entries.getDictAsMap())
                found.push_back(value);
        }
    }
}

/// Numbers of what was written that the structure refers to.
struct WrittenDrawing {
    std::unique_ptr<PdfFile> file;
    std::vector<WrittenPage> pages;
    std::vector<int> annotations;
    MarkedContents contents;
    int tree = 0; ///< of the structure tree, which is yet to be written
    std::string trailer;
};

/// Writes all but the structure, which takes so much memory that the document must be gone before.
WrittenDrawing writeDrawing(QIODevice &drawn, const PdfProperties &properties, QIODevice &to) {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processInputSource(std::make_shared<DeviceSource>(drawn));

    Handle root = document.getRoot();
    root.replaceKey("/Lang", text(properties.metadata.language));
    root.replaceKey("/ViewerPreferences", Handle::parse("<< /DisplayDocTitle true >>"));
    root.replaceKey("/PageLabels", Handle::parse("<< /Nums [0 << /S /D >>] >>"));
    setColourProfile(document);
    setMetadata(document, properties.xmp);
    setInformation(document, properties.metadata);
    root.removeKey("/Names");
    attach(document, properties.attachments, properties.metadata.date);
    const std::vector<Handle> &pages = document.getAllPages();
    const std::vector<Handle> annotations = addLinks(document, pages, properties.links);
    auto key = static_cast<long long>(pages.size());
    for (Handle annotation : annotations)
        annotation.replaceKey("/StructParent", Handle::newInteger(key++));
    addBookmarks(document, pages, properties.bookmarks);
    const Handle tree = document.makeIndirectObject(Handle::newDictionary());
    root.replaceKey("/StructTreeRoot", tree);
    root.replaceKey("/MarkInfo", Handle::parse("<< /Marked true >>"));

    WrittenDrawing result;
    result.tree = tree.getObjectID();
    result.file = std::make_unique<PdfFile>(to, properties.pack, result.tree + 1);
    result.contents.resize(pages.size());
    PageTagger tagger(properties.structure);
    std::set<QPDFObjGen> written{tree.getObjGen()};
    for (std::size_t i = 0; i < pages.size(); ++i) {
        Handle page = pages[i];
        page.replaceKey("/StructParents", Handle::newInteger(static_cast<long long>(i)));
        page.replaceKey("/Tabs", Handle::newName("/S"));
        const Handle content = page.getKey("/Contents");
        result.file->addPacked(content.getObjectID(), {}, tagger.taggedContent(page, result.contents[i]));
        written.insert(content.getObjGen());
        result.pages.push_back({page.getObjectID(), heightOf(page)});
    }
    writeObjects(*result.file, document, std::move(written));
    for (const Handle &annotation : annotations)
        result.annotations.push_back(annotation.getObjectID());
    result.trailer = "/Root " + root.unparse() + " /Info " + document.getTrailer().getKey("/Info").unparse();
    return result;
}

} // namespace

FinishedPdf finishPdf(QIODevice &drawn, const PdfProperties &properties, QIODevice &to) try {
    WrittenDrawing written = writeDrawing(drawn, properties, to);
    writeStructure(*written.file, written.tree, properties, std::move(written.contents), written.pages,
                   written.annotations);
    return written.file->end(written.trailer) ? FinishedPdf::complete : FinishedPdf::refused;
} catch (const PdfTooLarge &) {
    return FinishedPdf::tooLarge;
}

} // namespace palmer
