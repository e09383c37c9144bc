// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "export/resultsjson.h"
#include "print/pdf/writepdf.h"
#include "print/proof/verifyreport.h"
#include "report/composereport.h"

#include <QBuffer>
#include <QByteArray>
#include <QFile>
#include <QRegularExpression>
#include <functional>
#include <map>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFPageObjectHelper.hh>
#include <qpdf/QPDFWriter.hh>
#include <random>

/// What one does who wants another report to be believed: takes the PDF apart and puts it together again.
namespace palmer::testdata {

using namespace Qt::StringLiterals;
using Handle = QPDFObjectHandle;
using Random = std::mt19937_64;

inline std::size_t below(Random &random, std::size_t n) {
    return n == 0 ? 0 : static_cast<std::size_t>(random() % n);
}

/// A report as the program writes it, with its attachments.
inline QByteArray reportPdf(const EvaluatedDocument &evaluated, Language::Id language, bool annex = true) {
    const Report report = composeReport(evaluated, Language(language),
                                        {u"Palmer " PALMER_VERSION ""_s, true, {}, {}, {}, annex});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writePdf(report, buffer, attachedResults(evaluated));
    return buffer.data();
}

inline Verification verified(const QByteArray &pdf) {
    return verifyReport(openReport(pdf).value());
}

/// The PDF after `change`, written anew.
inline QByteArray changed(const QByteArray &pdf, const std::function<void(QPDF &)> &change) {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));
    change(document);
    QPDFWriter writer(document);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char *>(buffer->getBuffer()), static_cast<qsizetype>(buffer->getSize())};
}

/// The same PDF as bytes in which every object stands by itself.
inline QByteArray withoutObjectStreams(const QByteArray &pdf) {
    QPDF document;
    document.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));
    QPDFWriter writer(document);
    writer.setOutputMemory();
    writer.setObjectStreamMode(qpdf_o_disable);
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char *>(buffer->getBuffer()), static_cast<qsizetype>(buffer->getSize())};
}

inline QByteArray dataOf(Handle stream) {
    const auto buffer = stream.getStreamData(qpdf_dl_generalized);
    return {reinterpret_cast<const char *>(buffer->getBuffer()), static_cast<qsizetype>(buffer->getSize())};
}

/// The sign that each glyph of a font stands for, by its number.
inline std::map<int, QChar> signsOf(Handle font) {
    std::map<int, QChar> signs;
    Handle toUnicode = font.getKey("/ToUnicode");
    if (!toUnicode.isStream())
        return signs;
    static const QRegularExpression list(u"<([0-9A-F]{4})> <[0-9A-F]{4}> \\[([^\\]]*)\\]"_s);
    static const QRegularExpression code(u"<([0-9A-F]{4})>"_s);
    auto lists = list.globalMatch(QString::fromLatin1(dataOf(toUnicode)));
    while (lists.hasNext()) {
        const auto match = lists.next();
        int glyph = match.captured(1).toInt(nullptr, 16);
        auto codes = code.globalMatch(match.captured(2));
        while (codes.hasNext())
            signs[glyph++] = QChar(codes.next().captured(1).toUShort(nullptr, 16));
    }
    return signs;
}

/// A glyph as a page draws it.
struct DrawnGlyph {
    qsizetype at = 0; ///< of its four hexadecimal digits in the content stream
    std::string font;
    int glyph = 0;
    QChar sign;
};

struct PageContent {
    QByteArray stream;
    std::map<std::string, std::map<int, QChar>> fonts;
    std::vector<DrawnGlyph> glyphs;
};

inline PageContent contentOf(Handle page) {
    PageContent result;
    QPDFPageObjectHelper helper(page);
    const auto contents = page.getPageContents();
    for (Handle stream : contents)
        result.stream += dataOf(stream) + '\n';
    Handle fonts = page.getKey("/Resources").getKey("/Font");
    for (const std::string &name : fonts.getKeys())
        result.fonts[name.substr(1)] = signsOf(fonts.getKey(name));
    static const QRegularExpression operation(u"/(\\w+) [0-9.]+ Tf|<([0-9A-Fa-f]{4})> Tj"_s);
    auto matches = operation.globalMatch(QString::fromLatin1(result.stream));
    std::string font;
    while (matches.hasNext()) {
        const auto match = matches.next();
        if (match.hasCaptured(1)) {
            font = match.captured(1).toStdString();
            continue;
        }
        const int glyph = match.captured(2).toInt(nullptr, 16);
        const auto &signs = result.fonts[font];
        const auto sign = signs.find(glyph);
        result.glyphs.push_back(
            {match.capturedStart(2), font, glyph, sign == signs.end() ? QChar() : sign->second});
    }
    return result;
}

inline void setContent(QPDF &document, Handle page, const QByteArray &stream) {
    page.replaceKey("/Contents", Handle::newStream(&document, stream.toStdString()));
}

/// Draws another sign of the same kind (`kind` says which are) in the place of one drawn on that page, chosen
/// at random. False where the page has none, or its font no other.
inline bool redraw(QPDF &document, int pageIndex, Random &random, const std::function<bool(QChar)> &kind,
                   const std::function<bool(QChar)> &replacement) {
    Handle page = document.getAllPages().at(static_cast<std::size_t>(pageIndex));
    PageContent content = contentOf(page);
    std::vector<DrawnGlyph> eligible;
    for (const DrawnGlyph &glyph : content.glyphs) {
        if (kind(glyph.sign))
            eligible.push_back(glyph);
    }
    if (eligible.empty())
        return false;
    const DrawnGlyph chosen = eligible[below(random, eligible.size())];
    std::vector<int> others;
    for (const auto &[glyph, sign] : content.fonts[chosen.font]) {
        if (glyph != chosen.glyph && sign != chosen.sign && replacement(sign))
            others.push_back(glyph);
    }
    if (others.empty())
        return false;
    const int other = others[below(random, others.size())];
    content.stream.replace(chosen.at, 4, QByteArray::number(other, 16).rightJustified(4, '0'));
    setContent(document, page, content.stream);
    return true;
}

inline bool isDigit(QChar c) {
    return c >= u'0' && c <= u'9';
}

/// The stream of the attachment whose name ends so.
inline Handle attachment(QPDF &document, const std::string &ending) {
    Handle files = document.getRoot().getKey("/AF");
    for (int i = 0; i < files.getArrayNItems(); ++i) {
        Handle file = files.getArrayItem(i);
        if (file.getKey("/UF").getUTF8Value().ends_with(ending))
            return file.getKey("/EF").getKey("/F");
    }
    return Handle::newNull();
}

inline void replaceAttachment(QPDF &document, const std::string &ending, const QByteArray &bytes) {
    attachment(document, ending).replaceStreamData(bytes.toStdString(), Handle::newNull(), Handle::newNull());
}

} // namespace palmer::testdata
