// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/writepdf.h"

#include "document/documenterror.h"
#include "export/dcc.h"
#include "print/pdf/pages.h"
#include "print/pdf/tags.h"
#include "report/attachedfile.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QTemporaryFile>
#include <algorithm>
#include <map>
#include <memory>

namespace palmer {

namespace {

constexpr int dotsPerInch = 1200;

/// Where Qt draws so many pages: a few into memory, more into a file that nobody else can read and that is
/// gone afterwards, for they would take more memory than all the rest.
std::unique_ptr<QIODevice> placeFor(std::size_t pages) {
    constexpr std::size_t few = 64;
    if (pages > few) {
        auto file = std::make_unique<QTemporaryFile>();
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

/// Also tells `tagging` what is drawn. What has been drawn is given up: of a long report, pages laid out take
/// more memory than all the rest.
void drawPages(Pages &pages, Tagging &tagging, QIODevice &to) {
    QPdfWriter writer(&to);
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b); // output intent, no transparency
    writer.setResolution(dotsPerInch);
    writer.setPageLayout(QPageLayout(
        QPageSize(pages.front().size, QPageSize::Point, QString(), QPageSize::FuzzyOrientationMatch),
        QPageLayout::Portrait, QMarginsF(0, 0, 0, 0), QPageLayout::Point));
    QPainter painter(&writer);
    bool first = true;
    for (PrintedPage &page : pages) {
        if (!first)
            writer.newPage();
        first = false;
        tagging.beginPage();
        painter.save();
        painter.scale(dotsPerInch / 72.0, dotsPerInch / 72.0);
        drawPage(painter, page);
        painter.restore();
        page.parts = {};
    }
    painter.end();
    if (const auto *file = qobject_cast<QFileDevice *>(&to); file && file->error() != QFileDevice::NoError)
        throwUnwritable();
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
void addNavigation(PdfProperties &properties, const Pages &pages,
                   const std::vector<Structure::Index> &elements) {
    std::map<QString, std::pair<PdfPlace, QString>> anchors;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        for (const Bookmark &bookmark : pages[i].bookmarks) {
            properties.bookmarks.push_back({bookmark.level, oneLine(bookmark.title), placeOf(i, bookmark.y)});
            if (!bookmark.anchor.isEmpty())
                anchors.emplace(bookmark.anchor, std::pair(placeOf(i, bookmark.y), oneLine(bookmark.title)));
        }
    }
    auto element = elements.begin();
    for (std::size_t i = 0; i < pages.size(); ++i) {
        for (const PageLink &link : pages[i].links) {
            const Structure::Index own = *element++;
            if (const auto target = anchors.find(link.anchor); target != anchors.end())
                properties.links.push_back(
                    {static_cast<int>(i), link.area, target->second.first, target->second.second, own});
        }
    }
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

void writePdf(const Report &report, QIODevice &device, const QByteArray &results,
              const QByteArray &certificate) {
    writePdf(report, device, attachmentsOf(report.testFileName, report.testFile, results, certificate));
}

void writePdf(const Report &report, QIODevice &device, const std::vector<PdfAttachment> &attachments) {
    Pages pages = layoutPages(report);
    PdfProperties properties;
    properties.metadata = {oneLine(report.title), oneLine(report.laboratory), report.language, report.date,
                           report.making};
    properties.xmp = xmpPacket(properties.metadata);
    properties.attachments = attachments;
    Tagging tagging(Language::fromName(report.language).value_or(Language(Language::Id::english)));
    const std::unique_ptr<QIODevice> drawn = placeFor(pages.size());
    drawPages(pages, tagging, *drawn);
    properties.structure = tagging.takeStructure();
    addNavigation(properties, pages, tagging.links());
    drawn->seek(0);
    if (!finishPdf(*drawn, properties, device))
        throwUnwritable();
}

} // namespace palmer
