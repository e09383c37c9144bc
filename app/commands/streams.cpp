#include "commands/streams.h"

#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/testfile.h"
#include "import/importmeasurement.h"

#include <QFile>
#include <algorithm>
#include <cstdio>

namespace palmer {

namespace {

constexpr qint64 blockSize = qint64(1) << 20;

QByteArray standardInput() {
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly))
        throw Error(Error::Kind::unreadable, {REPORT_TEXT("report", "the file cannot be read (%1)"),
                                              {input.errorString().toStdString()}});
    QByteArray bytes;
    for (QByteArray block = input.read(blockSize); !block.isEmpty(); block = input.read(blockSize)) {
        bytes += block;
        demandReadable(bytes.size());
    }
    if (input.error() != QFileDevice::NoError)
        throw Error(Error::Kind::unreadable, {REPORT_TEXT("report", "the file cannot be read (%1)"),
                                              {input.errorString().toStdString()}});
    return bytes;
}

QString oneLine(QString text) {
    std::ranges::replace_if(
        text, [](QChar c) { return c.category() == QChar::Other_Control || c == QChar::LineSeparator; },
        u' ');
    return text;
}

} // namespace

void printOut(const QByteArray &bytes) {
    const auto size = static_cast<std::size_t>(bytes.size());
    if (std::fwrite(bytes.constData(), 1, size, stdout) != size || std::fflush(stdout) != 0)
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "standard output cannot be written"), {}});
}

void printOut(const QString &text) {
    printOut(text.toUtf8());
}

void printError(const QString &text) {
    const QByteArray line = (QStringLiteral("palmer-cli: ") + oneLine(text) + u'\n').toUtf8();
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

void printError(const QString &file, const Error &error, const Language &language) {
    QString text = file + QStringLiteral(": ");
    if (!error.place.empty())
        text += QString::fromStdString(error.place) + QStringLiteral(": ");
    printError(text + language.sentence(error.message));
}

void printRemarks(const QString &file, const std::vector<Remark> &remarks, const Language &language) {
    for (const Remark &remark : remarks) {
        QString text = file + QStringLiteral(": ");
        if (remark.line > 0) {
            text += QString::number(remark.line);
            if (remark.column > 0)
                text += u':' + QString::number(remark.column);
            text += QStringLiteral(": ");
        }
        printError(text + language.sentence(remark.message));
    }
}

QByteArray bytesFrom(const QString &file) {
    return file == QLatin1StringView("-") ? standardInput() : readBytes(file);
}

Document documentFrom(const QString &file, const Language &language) {
    const QByteArray bytes = bytesFrom(file);
    if (isTestFile(bytes, file))
        return readDocument(bytes);
    Imported imported = importMeasurement(bytes, file);
    const std::vector<Remark> remarks = imported.remarks;
    Document document;
    addImported(document, std::move(imported), bytes, file, false);
    printRemarks(file, remarks, language);
    return document;
}

} // namespace palmer
