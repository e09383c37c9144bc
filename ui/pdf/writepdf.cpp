#include "ui/pdf/writepdf.h"

#include "document/documenterror.h"
#include "ui/pdf/finishpdf.h"
#include "ui/pdf/pages.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>

namespace palmer::ui {

namespace {

constexpr int dotsPerInch = 1200;

QByteArray pagesAsPdf(const Pages &pages) {
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(dotsPerInch);
    writer.setPageLayout(QPageLayout(
        QPageSize(pages.front().size, QPageSize::Point, QString(), QPageSize::FuzzyOrientationMatch),
        QPageLayout::Portrait, QMarginsF(0, 0, 0, 0), QPageLayout::Point));
    QPainter painter(&writer);
    bool first = true;
    for (const PrintedPage &page : pages) {
        if (!first)
            writer.newPage();
        first = false;
        painter.save();
        painter.scale(dotsPerInch / 72.0, dotsPerInch / 72.0);
        drawPage(painter, page);
        painter.restore();
    }
    painter.end();
    return pdf;
}

} // namespace

void writePdf(const Report &report, QIODevice &device) {
    const QByteArray pdf = finishPdf(pagesAsPdf(layoutPages(report)),
                                     {report.title, report.laboratory, report.language, report.date});
    if (device.write(pdf) != pdf.size())
        throw Error(
            Error::Kind::unwritable,
            {REPORT_TEXT("report",
                         "the file could not be saved, for want of permission or space; what was "
                         "there before is unchanged: save it under another name or in another folder")});
}

} // namespace palmer::ui
