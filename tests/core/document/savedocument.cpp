#include "document/savedocument.h"

#include "core/document/completefile.h"
#include "document/readdocument.h"
#include "document/writedocument.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <limits>
#include <optional>

using namespace palmer;

namespace {

std::optional<Error> errorOfSaving(const Document &document, const QString &path) {
    try {
        saveDocument(document, path);
        return {};
    } catch (const Error &error) {
        return error;
    }
}

std::optional<Error> errorOfOpening(const QString &path) {
    try {
        (void)openDocument(path);
        return {};
    } catch (const Error &error) {
        return error;
    }
}

QByteArray contentOf(const QString &path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class SaveDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void whatWasSavedIsOpenedEqually() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("é x.palmer"));
        const Document document = readDocument(completeFile());
        saveDocument(Document(), path);
        saveDocument(document, path);
        QVERIFY(openDocument(path) == document);
        QCOMPARE(contentOf(path), writeDocument(document));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(),
                 1); // nothing is left beside
    }

    void aMissingFolderIsAnError() {
        const QTemporaryDir folder;
        const auto error = errorOfSaving({}, folder.filePath(QStringLiteral("none/x.palmer")));
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unwritable);
        QVERIFY(!QDir(folder.filePath(QStringLiteral("none"))).exists());
    }

    void aFolderIsNoTarget() {
        const QTemporaryDir folder;
        const auto error = errorOfSaving({}, folder.path());
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unwritable);
        QVERIFY(QDir(folder.path()).exists());
    }

    void aFullDeviceIsAnErrorAndStaysADevice() {
        const auto error = errorOfSaving({}, QStringLiteral("/dev/full"));
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unwritable);
        const QFileInfo device(QStringLiteral("/dev/full"));
        QVERIFY(device.exists() && !device.isFile());
    }

    void aFailedSaveLeavesTheOldFile() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.palmer"));
        saveDocument({}, path);
        const QByteArray before = contentOf(path);
        Document broken;
        Instrument instrument;
        instrument.resolution = std::numeric_limits<double>::infinity();
        broken.instruments.push_back(instrument);
        QVERIFY(errorOfSaving(broken, path));
        QCOMPARE(contentOf(path), before);
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    }

    void whatCannotBeReadIsAnError_data() {
        QTest::addColumn<QString>("path");
        QTest::newRow("missing file") << QStringLiteral("/nowhere/x.palmer");
        QTest::newRow("folder") << QDir::tempPath();
        QTest::newRow("no name") << QString();
    }
    void whatCannotBeReadIsAnError() {
        QFETCH(QString, path);
        const auto error = errorOfOpening(path);
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::unreadable);
    }

    void anEmptyFileIsAnError() {
        const auto error = errorOfOpening(QStringLiteral("/dev/null"));
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::syntax);
    }

    void anEndlessFileIsAnError() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("x.palmer"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.resize((qint64(1) << 30) + 1)); // a hole, no bytes on disk
        file.close();
        const auto error = errorOfOpening(path);
        QVERIFY(error);
        QVERIFY(error->kind == Error::Kind::tooLarge);
    }
};

QTEST_APPLESS_MAIN(SaveDocumentTest)
#include "savedocument.moc"
