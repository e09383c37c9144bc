// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/attachedfile.h"

#include "document/sha256.h"
#include "document/writedocument.h"

#include <algorithm>

namespace palmer {

namespace {

constexpr int shortDigits = 16;
constexpr int groupSize = 4;

bool holdsBytes(const Test &test) {
    return std::ranges::any_of(test.imports, [](const ImportedFile &file) { return file.data.has_value(); });
}

} // namespace

bool holdsOriginals(const Document &document) {
    return std::ranges::any_of(document.tests, [](const TestPointer &test) { return holdsBytes(*test); });
}

QByteArray attachedFile(const Document &document, Originals originals) {
    if (originals == Originals::include)
        return writeDocument(document);
    Document attached = document;
    for (TestPointer &test : attached.tests) {
        if (!holdsBytes(*test))
            continue; // do not copy many readings needlessly
        Test withoutBytes = *test;
        for (ImportedFile &file : withoutBytes.imports)
            file.data.reset();
        test = std::make_shared<const Test>(std::move(withoutBytes));
    }
    QByteArray file = writeDocument(attached);
    file.squeeze(); // kept while the report is made
    return file;
}

QString attachedFileName(const Document &document) {
    constexpr qsizetype longest = 80;
    QString name = QString::fromStdString(document.report.number).trimmed().left(longest);
    for (QChar &c : name) {
        const bool fits = c.isLetterOrNumber() || c.isSurrogate() || QStringView(u" .-_+()#&").contains(c);
        c = fits ? c : u'-';
    }
    while (name.startsWith(u'.') || name.startsWith(u'-')) // such a file is hidden, or read as an option
        name.remove(0, 1);
    return (name.isEmpty() ? QStringLiteral("report") : name) + QStringLiteral(".palmer");
}

QString fingerprint(const QByteArray &attachedFile) {
    return QString::fromStdString(sha256(attachedFile));
}

QString shortFingerprint(const QString &fingerprint) {
    QString result = fingerprint.left(shortDigits);
    for (qsizetype i = shortDigits - groupSize; i > 0; i -= groupSize)
        result.insert(i, u' ');
    return result;
}

} // namespace palmer
