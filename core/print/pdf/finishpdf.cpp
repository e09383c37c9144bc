// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/finishpdf.h"

#include "print/pdf/tagpdf.h"

#include <QFile>
#include <QStringList>
#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFWriter.hh>
#include <stdexcept>

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

} // namespace

QByteArray finishPdf(const QByteArray &pdf, const PdfProperties &properties) {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));

    Handle root = document.getRoot();
    root.replaceKey("/Lang", text(properties.metadata.language));
    root.replaceKey("/ViewerPreferences", Handle::parse("<< /DisplayDocTitle true >>"));
    root.replaceKey("/PageLabels", Handle::parse("<< /Nums [0 << /S /D >>] >>"));
    setColourProfile(document);
    setMetadata(document, properties.xmp);
    setInformation(document, properties.metadata);
    document.getTrailer().removeKey("/ID"); // it is random
    root.removeKey("/Names");
    attach(document, properties.attachments, properties.metadata.date);
    const std::vector<Handle> &pages = document.getAllPages();
    const std::vector<Handle> annotations = addLinks(document, pages, properties.links);
    if (!properties.structure.empty())
        tagPdf(document, properties, annotations);
    addBookmarks(document, pages, properties.bookmarks);

    QPDFWriter writer(document);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.setMinimumPDFVersion("1.7");
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes of libqpdf
    return {reinterpret_cast<const char *>(buffer->getBuffer()), static_cast<qsizetype>(buffer->getSize())};
}

} // namespace palmer
