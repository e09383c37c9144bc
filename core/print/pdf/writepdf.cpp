// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/writepdf.h"

#include "document/documenterror.h"
#include "export/dcc.h"
#include "print/pdf/pages.h"
#include "print/pdf/tags.h"
#include "report/attachedfile.h"
#include "system/memory.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryFile>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>

namespace palmer {

namespace {

constexpr int dotsPerInch = 1200;
constexpr std::size_t fewPages = 64;

/// Remembers that the disk was full, which QPdfWriter does not ask.
class FileOfPages : public QTemporaryFile {
public:
    [[nodiscard]] bool isComplete() { return flush() && !m_failed; }

protected:
    qint64 writeData(const char *bytes, qint64 size) override {
        const qint64 written = QTemporaryFile::writeData(bytes, size);
        m_failed = m_failed || written != size;
        return written;
    }

private:
    bool m_failed = false;
};

/// Where Qt draws so many pages: a few into memory, more into a file that nobody else can read and that is
/// gone afterwards, for they would take more memory than all the rest.
std::unique_ptr<QIODevice> placeFor(std::size_t pages) {
    if (pages > fewPages) {
        auto file = std::make_unique<FileOfPages>();
        if (file->open())
            return file;
    }
    auto memory = std::make_unique<QBuffer>();
    memory->open(QIODevice::ReadWrite);
    return memory;
}

[[noreturn]] void throwUnwritable() {
    throw Error(Error::Kind::unwritable,
                {REPORT_TEXT("report",
                             "the file could not be saved, for want of permission or space; what was "
                             "there before is unchanged: save it under another name or in another folder")});
}

[[noreturn]] void throwTooLarge() {
    throw Error(
        Error::Kind::unwritable,
        {REPORT_TEXT("report", "a PDF of more than 4 GB cannot be written; choose less for the report, "
                               "or divide its tests among several files")});
}

/// The pages as Qt draws them, and what else is written of each.
struct DrawnPages {
    std::unique_ptr<QIODevice> pdf;
    std::vector<std::vector<Bookmark>> bookmarks; ///< by page
    std::vector<std::vector<PageLink>> links;     ///< likewise
};

/// Draws one page after the other; also tells `tagging` what is drawn.
DrawnPages drawPages(Report report, Tagging &tagging) {
    constexpr std::size_t manyBlocks = 2000;
    if (report.blocks.size() > manyBlocks)
        returnFreeMemory(); // that of the evaluation and of its results
    std::optional<LaidOutReport> laidOut(std::in_place, std::move(report));
    const std::size_t count = laidOut->pageCount();
    DrawnPages result;
    result.pdf = placeFor(count);
    PrintedPage page = laidOut->page(0);
    QPdfWriter writer(result.pdf.get());
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b); // output intent, no transparency
    writer.setResolution(dotsPerInch);
    writer.setPageLayout(
        QPageLayout(QPageSize(page.size, QPageSize::Point, QString(), QPageSize::FuzzyOrientationMatch),
                    QPageLayout::Portrait, QMarginsF(0, 0, 0, 0), QPageLayout::Point));
    QPainter painter(&writer);
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) {
            writer.newPage();
            page = laidOut->page(i);
        }
        tagging.beginPage();
        painter.save();
        painter.setPen(Qt::NoPen); // after a new page Qt takes a pen as it is only when one is set
        painter.scale(dotsPerInch / 72.0, dotsPerInch / 72.0);
        drawPage(painter, page);
        painter.restore();
        result.bookmarks.push_back(std::move(page.bookmarks));
        result.links.push_back(std::move(page.links));
    }
    painter.end();
    if (auto *file = dynamic_cast<FileOfPages *>(result.pdf.get()); file && !file->isComplete())
        throwUnwritable();
    result.pdf->seek(0);
    page = {};
    laidOut.reset();
    if (count > fewPages)
        returnFreeMemory(); // that of the report is free now
    return result;
}

/// A property on one line, without control characters.
QString oneLine(QString text) {
    std::ranges::replace_if(
        text, [](QChar c) { return c.category() == QChar::Other_Control; }, u' ');
    return text;
}

PdfPlace placeOf(std::size_t page, double y) {
    return {static_cast<int>(page), y};
}

/// Adds the bookmarks of all pages, and the links to those with an anchor.
/// `elements`: of the links of all pages, in their order.
void addNavigation(PdfProperties &properties, const DrawnPages &pages,
                   const std::vector<Structure::Index> &elements) {
    std::map<QString, std::pair<PdfPlace, QString>> anchors;
    for (std::size_t i = 0; i < pages.bookmarks.size(); ++i) {
        for (const Bookmark &bookmark : pages.bookmarks[i]) {
            properties.bookmarks.push_back({bookmark.level, oneLine(bookmark.title), placeOf(i, bookmark.y)});
            if (!bookmark.anchor.isEmpty())
                anchors.emplace(bookmark.anchor, std::pair(placeOf(i, bookmark.y), oneLine(bookmark.title)));
        }
    }
    auto element = elements.begin();
    for (std::size_t i = 0; i < pages.bookmarks.size(); ++i) {
        for (const PageLink &link : pages.links[i]) {
            const Structure::Index own = *element++;
            if (const auto target = anchors.find(link.anchor); target != anchors.end())
                properties.links.push_back(
                    {static_cast<int>(i), link.area, target->second.first, target->second.second, own});
        }
    }
}

FinishedPdf writtenPdf(Report report, QIODevice &device, const std::vector<PdfAttachment> &attachments) {
    PdfProperties properties;
    properties.metadata = {oneLine(report.title), oneLine(report.laboratory), report.language, report.date,
                           report.making};
    properties.xmp = xmpPacket(properties.metadata);
    properties.attachments = attachments;
    report.testFile.clear(); // is attached
    Tagging tagging(Language::fromName(report.language).value_or(Language(Language::Id::english)));
    DrawnPages pages = drawPages(std::move(report), tagging);
    properties.structure = tagging.takeStructure();
    addNavigation(properties, pages, tagging.links());
    pages.bookmarks = {};
    pages.links = {};
    return finishPdf(*pages.pdf, properties, device);
}

} // namespace

std::vector<PdfAttachment> attachmentsOf(const QString &testFileName, const QByteArray &testFile,
                                         const QByteArray &results, const QByteArray &certificate) {
    std::vector<PdfAttachment> attachments;
    const auto add = [&](const QString &name, const char *type, const char *relationship,
                         const char *description, const QByteArray &bytes) {
        if (!bytes.isEmpty())
            attachments.push_back(
                {name, type, relationship, QString::fromLatin1(description), bytes.size(), packed(bytes)});
    };
    if (testFileName == historyFileName)
        add(testFileName, "application/json", "/Data", "Values of the history", testFile);
    else
        add(testFileName, "application/vnd.palmer+json", "/Source", "Test file", testFile);
    add(QStringLiteral("results.json"), "application/json", "/Data", "Results", results);
    add(QString::fromLatin1(dccFileName), "application/xml", "/Data", "Digital calibration certificate",
        certificate);
    return attachments;
}

void writePdf(Report report, QIODevice &device, const QByteArray &results, const QByteArray &certificate) {
    const std::vector<PdfAttachment> attachments =
        attachmentsOf(report.testFileName, report.testFile, results, certificate);
    writePdf(std::move(report), device, attachments);
}

void writePdf(Report report, QIODevice &device, const std::vector<PdfAttachment> &attachments) {
    const FinishedPdf finished = writtenPdf(std::move(report), device, attachments);
    returnFreeMemory(); // that of the structure: what was written may have to be read
    if (finished == FinishedPdf::tooLarge)
        throwTooLarge();
    if (finished == FinishedPdf::refused)
        throwUnwritable();
}

} // namespace palmer
