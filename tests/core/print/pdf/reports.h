// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/readdocument.h"
#include "patience.h"
#include "print/pdf/writepdf.h"
#include "report/composereport.h"

#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <map>
#include <utility>

namespace palmer::testdata {

using namespace Qt::StringLiterals;

inline const QStringList storedDocuments{u"iso230-2-1988-example"_s,
                                         u"limits-2006"_s,
                                         u"long-axis-with-zone"_s,
                                         u"one-direction"_s,
                                         u"one-direction-with-gaps"_s,
                                         u"rotary-axis"_s,
                                         u"two-tests"_s,
                                         u"iso230-4-full-circles-xy"_s,
                                         u"iso230-4-partial-arc-zx"_s,
                                         u"iso230-4-feedback-yz"_s,
                                         u"mixed"_s};

inline Document storedDocument(const QString &name) {
    for (const QString &folder : {QStringLiteral(DOCUMENTS), QStringLiteral(EXAMPLES)}) {
        QFile file(folder + u'/' + name + u".palmer"_s);
        if (file.open(QIODevice::ReadOnly))
            return readDocument(file.readAll());
    }
    qFatal("there is no document %s", qPrintable(name));
}

inline Report reportOf(const Document &document, Language::Id language) {
    return composeReport(evaluate(std::make_shared<const Document>(document)), Language(language),
                         {u"Palmer 0.1.0"_s, true});
}

inline QByteArray pdfOf(const Report &report) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writePdf(report, buffer);
    return buffer.data();
}

/// That of a stored document, made once in a program.
inline const QByteArray &storedPdf(const QString &name, Language::Id language) {
    static std::map<std::pair<QString, Language::Id>, QByteArray> made;
    QByteArray &pdf = made[{name, language}];
    if (pdf.isEmpty())
        pdf = pdfOf(reportOf(storedDocument(name), language));
    return pdf;
}

/// Output of a program of poppler that reads a PDF from its standard input ("-").
inline QByteArray run(const QString &program, const QStringList &arguments, const QByteArray &pdf) {
    QProcess process;
    process.start(program, arguments);
    process.write(pdf);
    process.closeWriteChannel();
    if (!process.waitForFinished(patience) || process.exitCode() != 0)
        qFatal("%s failed: %s", qPrintable(program), process.readAllStandardError().constData());
    return process.readAllStandardOutput();
}

/// Text of each page in the order it was drawn.
inline QStringList pageTexts(const QByteArray &pdf) {
    QStringList pages =
        QString::fromUtf8(run(u"pdftotext"_s, {u"-raw"_s, u"-enc"_s, u"UTF-8"_s, u"-"_s, u"-"_s}, pdf))
            .split(u'\f');
    pages.removeLast(); // behind the last form feed
    return pages;
}

/// Without white space, compatibility forms made equal.
inline QString squeezed(const QString &text) {
    static const QRegularExpression space(u"\\s+"_s, QRegularExpression::UseUnicodePropertiesOption);
    return text.normalized(QString::NormalizationForm_KC).remove(space);
}

/// The pages as grey pictures.
inline QList<QImage> pictures(const QByteArray &pdf, double dotsPerInch) {
    const QTemporaryDir folder;
    run(u"pdftoppm"_s,
        {u"-r"_s, QString::number(dotsPerInch), u"-gray"_s, u"-"_s, folder.filePath(u"page"_s)}, pdf);
    QList<QImage> result;
    for (const QString &name : QDir(folder.path()).entryList(QDir::Files, QDir::Name))
        result << QImage(folder.filePath(name));
    return result;
}

} // namespace palmer::testdata
