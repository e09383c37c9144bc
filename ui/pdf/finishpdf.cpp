#include "ui/pdf/finishpdf.h"

#include <QStringList>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFWriter.hh>

namespace palmer::ui {

namespace {

QPDFObjectHandle text(const QString &value) {
    return QPDFObjectHandle::newUnicodeString(value.toStdString());
}

/// "D:20261120000000Z"
QPDFObjectHandle pdfDate(const QString &iso) {
    QString digits = iso;
    digits.remove(u'-');
    return QPDFObjectHandle::newString("D:" + digits.toStdString() + "000000Z");
}

} // namespace

QByteArray finishPdf(const QByteArray &pdf, const PdfProperties &properties) {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("report", pdf.constData(), static_cast<std::size_t>(pdf.size()));

    QPDFObjectHandle root = document.getRoot();
    root.replaceKey("/Lang", text(properties.language));
    root.removeKey("/Metadata");
    root.replaceKey("/ViewerPreferences", QPDFObjectHandle::parse("<< /DisplayDocTitle true >>"));

    QPDFObjectHandle information = QPDFObjectHandle::newDictionary();
    information.replaceKey("/Title", text(properties.title));
    information.replaceKey("/Creator", text(QStringLiteral("Palmer")));
    if (!properties.author.isEmpty())
        information.replaceKey("/Author", text(properties.author));
    if (!properties.date.isEmpty()) {
        information.replaceKey("/CreationDate", pdfDate(properties.date));
        information.replaceKey("/ModDate", pdfDate(properties.date));
    }
    document.getTrailer().replaceKey("/Info", document.makeIndirectObject(information));

    QPDFWriter writer(document);
    writer.setOutputMemory();
    writer.setDeterministicID(true);
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.setMinimumPDFVersion("1.7");
    writer.write();
    const auto buffer = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char *>(buffer->getBuffer()), static_cast<qsizetype>(buffer->getSize())};
}

} // namespace palmer::ui
