#include "report/attachedfile.h"

#include "document/writedocument.h"

#include <QCryptographicHash>
#include <algorithm>

namespace palmer {

namespace {

constexpr int shortDigits = 16;
constexpr int groupSize = 4;

} // namespace

QByteArray attachedFile(const Document &document) {
    Document attached = document;
    for (TestPointer &test : attached.tests) {
        if (std::ranges::none_of(test->imports,
                                 [](const ImportedFile &file) { return file.data.has_value(); }))
            continue; // many readings are not copied for nothing
        Test withoutBytes = *test;
        for (ImportedFile &file : withoutBytes.imports)
            file.data.reset();
        test = std::make_shared<const Test>(std::move(withoutBytes));
    }
    return writeDocument(attached);
}

QString fingerprint(const QByteArray &attachedFile) {
    return QString::fromLatin1(QCryptographicHash::hash(attachedFile, QCryptographicHash::Sha256).toHex());
}

QString shortFingerprint(const QString &fingerprint) {
    QString result = fingerprint.left(shortDigits);
    for (qsizetype i = shortDigits - groupSize; i > 0; i -= groupSize)
        result.insert(i, u' ');
    return result;
}

} // namespace palmer
