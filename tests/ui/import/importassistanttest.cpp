#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/import/importassistant.h"

#include "ui/window/shownwindow.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;

namespace {

QByteArray bytesOf(const char *name) {
    QFile file(QString(DATA) + name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no %s", name);
    return file.readAll();
}

const PositioningMeasurement &positioning(const Test &test) {
    return std::get<PositioningMeasurement>(test.measurement);
}

void pick(const QWidget &dialog, const QString &box, const QString &word) {
    auto *words = dialog.findChild<QComboBox *>(box);
    QVERIFY2(words, qPrintable(box));
    words->setCurrentIndex(words->findData(word));
    QVERIFY2(words->currentIndex() >= 0, qPrintable(word));
    emit words->activated(words->currentIndex());
}

QPushButton *importButton(const QWidget &dialog) {
    return dialog.findChild<QPushButton *>("acceptImport");
}

/// The assistant that the window shows.
ImportAssistant &assistantOf(const ShownWindow &shown) {
    auto *dialog = shown.window->findChild<ImportAssistant *>();
    if (!dialog || !dialog->isVisible())
        qFatal("no assistant");
    return *dialog;
}

} // namespace

/// The import assistant, alone and in the window.
class ImportAssistantTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        setWindowLanguage(Language::Id::english);
        QFile::remove(importProfilesPath());
    }

    void showsTextTableChoicesAndRemarks() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        QCOMPARE(importButton(dialog)->text(), QString("&Import 23 readings"));
        QVERIFY(dialog.findChild<QLabel *>("guessed.sign")->isVisible());
        QVERIFY(!dialog.findChild<QLabel *>("guessed.unit")->isVisible()); // the file says µm
        const auto *raw = dialog.findChild<QAbstractItemView *>("importRaw")->model();
        QCOMPARE(raw->index(3, 0).data().toString(), QString("0,00;-3,0;2,3;-2,0;1,1;-1,9;3,2"));
        const auto pieces = qobject_cast<const RawTextModel *>(raw)->pieces(3);
        QCOMPARE(pieces[0].role, CellRole::position);
        QCOMPARE(pieces[2].role, CellRole::positive);
        QCOMPARE(pieces[4].role, CellRole::negative);
        QVERIFY(qobject_cast<const RawTextModel *>(raw)->isProblem(6)); // "-4,,7"
        const auto *table = dialog.findChild<QAbstractItemView *>("importTable")->model();
        QCOMPARE(table->rowCount(), 4);
        QCOMPARE(table->columnCount(), 7);
        QCOMPARE(table->index(0, 1).data().toString(), QString("−3.0"));
        QCOMPARE(table->index(3, 6).data().toString(), QString("–"));
    }

    void aConfirmedGuessIsNoGuess() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        const Imported before = dialog.imported();
        dialog.findChild<QPushButton *>("confirm.sign")->click();
        QVERIFY(!dialog.findChild<QLabel *>("guessed.sign")->isVisible());
        QVERIFY(*dialog.imported().test == *before.test);
        QVERIFY(dialog.imported().questions.size() < before.questions.size());
    }

    void anotherChoiceReadsAnew() {
        ImportAssistant dialog(bytesOf("tables/bare-alternating.txt"), "bare.txt", nullptr);
        const auto first = [&] { return positioning(*dialog.imported().test).runs[0]; };
        QCOMPARE(first().deviations[0], std::optional(-0.003));
        pick(dialog, "import.unit", "mm");
        QCOMPARE(first().deviations[0], std::optional(-3.0));
        pick(dialog, "import.sign", "targetMinusActual");
        QCOMPARE(first().deviations[0], std::optional(3.0));
        pick(dialog, "import.directions", "sideBySide");
        QCOMPARE(positioning(*dialog.imported().test).runs[0].approach, Direction::positive);
        QCOMPARE(dialog.findChild<QComboBox *>("import.directions")->currentData().toString(),
                 QString("sideBySide"));
    }

    void whatCannotBeReadUnderAChoiceIsSaidAndNotAccepted() {
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        pick(dialog, "import.delimiter", "bar");
        QVERIFY(!importButton(dialog)->isEnabled());
        QVERIFY(!dialog.findChild<QLabel *>("importRefusal")->text().isEmpty());
        pick(dialog, "import.delimiter", "semicolon");
        QVERIFY(importButton(dialog)->isEnabled());
        QCOMPARE(importButton(dialog)->text(), QString("&Import 23 readings"));
    }

    void remembersChoicesUnderAName() {
        {
            ImportAssistant dialog(bytesOf("tables/bare-alternating.txt"), "bare.txt", nullptr);
            pick(dialog, "import.unit", "mm");
            QVERIFY(dialog.saveProfile("laser"));
            QCOMPARE(dialog.findChild<QComboBox *>("import.profile")->currentText(), QString("laser"));
            dialog.accept();
        }
        // The same kind of file begins with the profile used last, which can be seen and left.
        ImportAssistant dialog(bytesOf("tables/bare-alternating.txt"), "next.txt", nullptr);
        QCOMPARE(dialog.findChild<QComboBox *>("import.profile")->currentText(), QString("laser"));
        QCOMPARE(positioning(*dialog.imported().test).runs[0].deviations[0], std::optional(-3.0));
        auto *profiles = dialog.findChild<QComboBox *>("import.profile");
        profiles->setCurrentIndex(0);
        emit profiles->activated(0);
        QCOMPARE(positioning(*dialog.imported().test).runs[0].deviations[0], std::optional(-0.003));
    }

    void temperaturesWithoutATestAreRefused() {
        ImportAssistant dialog(bytesOf("tables/temperatures.csv"), "t.csv", nullptr);
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
        QVERIFY(dialog.findChild<QLabel *>("importRefusal")->text().contains("need a test"));
    }

    void comesIntoTheOpenFileAsOneStep() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        const Document before = *shown.window->model().document();
        shown.window->importFiles({QString(DATA) + "tables/typical.csv"});
        importButton(assistantOf(shown))->click();
        const auto &tests = shown.window->model().document()->tests;
        QCOMPARE(tests.size(), before.tests.size() + 1);
        QCOMPARE(positioning(*tests.back()).targets.size(), std::size_t(4));
        QCOMPARE(tests.back()->imports[0].fileName, std::string("typical.csv"));
        QCOMPARE(shown.window->model().undoStack()->count(), 1);
        shown.window->model().undoStack()->undo();
        QVERIFY(*shown.window->model().document() == before);
    }

    void anOpenedMeasurementMakesANewFile() {
        const ShownWindow shown;
        shown.window->openFile(QString(DATA) + "tables/circle-radius.csv");
        importButton(assistantOf(shown))->click();
        QVERIFY(shown.window->hasDocument());
        QCOMPARE(shown.window->model().document()->tests.size(), std::size_t(1));
        QVERIFY(shown.window->model().isModified());
    }

    void severalFilesComeOneAfterTheOther() {
        const ShownWindow shown;
        shown.window->importFiles({QString(DATA) + "tables/typical.csv", QString(DATA) + "refused/test.xcal",
                                   QString(DATA) + "tables/circle-radius.csv",
                                   QString(DATA) + "tables/temperatures.csv"});
        importButton(assistantOf(shown))->click();
        // The refused one is said and stops nothing; the next goes into what the first has opened.
        QVERIFY(shown.window->findChild<QMessageBox *>("errorBox"));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(!assistantOf(shown).wantsNewDocument());
        importButton(assistantOf(shown))->click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        importButton(assistantOf(shown))->click();
        const auto &tests = shown.window->model().document()->tests;
        QCOMPARE(tests.size(), std::size_t(2));
        QVERIFY(std::holds_alternative<CircularMeasurement>(tests[1]->measurement));
        QVERIFY(!positioning(*tests[0]).conditions.common.sensors.empty());
        QCOMPARE(shown.window->model().undoStack()->count(), 2);
    }

    void filesCanBeDropped() {
        const ShownWindow shown;
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(QString(DATA) + "tables/typical.csv")});
        QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(shown.window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(shown.window, &drop);
        importButton(assistantOf(shown))->click();
        QVERIFY(shown.window->hasDocument());
    }

    void theClipboardIsAFileToo() {
        const ShownWindow shown;
        QGuiApplication::clipboard()->setText(QString::fromUtf8(bytesOf("tables/typical.csv")));
        shown.find<QAction>("importClipboard")->trigger();
        QCOMPARE(importButton(assistantOf(shown))->text(), QString("&Import 23 readings"));
        // Another text in its place; one that is nothing changes nothing.
        QGuiApplication::clipboard()->setText(QString::fromUtf8(bytesOf("tables/circle-radius.csv")));
        assistantOf(shown).findChild<QPushButton *>("importPaste")->click();
        QVERIFY(std::holds_alternative<CircularMeasurement>(assistantOf(shown).imported().test->measurement));
        QGuiApplication::clipboard()->setText("nothing");
        assistantOf(shown).findChild<QPushButton *>("importPaste")->click();
        QVERIFY(!assistantOf(shown).findChild<QLabel *>("importRefusal")->text().isEmpty());
        QVERIFY(std::holds_alternative<CircularMeasurement>(assistantOf(shown).imported().test->measurement));
    }

    void theBytesAreKeptOnRequest() {
        const QByteArray bytes = bytesOf("tables/typical.csv");
        ImportAssistant dialog(bytes, "typical.csv", nullptr);
        Document without;
        dialog.addTo(without);
        QVERIFY(!without.tests[0]->imports[0].data);
        QCOMPARE(without.tests[0]->imports[0].sha256, sha256(bytes));
        dialog.findChild<QCheckBox *>("keepBytes")->setChecked(true);
        Document with;
        dialog.addTo(with);
        QCOMPARE(QByteArray::fromBase64(QByteArray::fromStdString(*with.tests[0]->imports[0].data)), bytes);
    }

    void everyChoiceCanBeMade_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QStringList>("choices");
        QTest::newRow("table of an axis")
            << "tables/bare-alternating.txt"
            << QStringList{"delimiter", "decimalMark",  "layout", "directions",    "content",
                           "unit",      "positionUnit", "sign",   "correctionTo20"};
        QTest::newRow("ballbar") << "b5r/typical-absolute.b5r"
                                 << QStringList{"unit",           "startAngle", "arc",  "calibrated",
                                                "correctionTo20", "feed",       "plane"};
    }

    void everyChoiceCanBeMade() {
        QFETCH(QString, file);
        QFETCH(QStringList, choices);
        ImportAssistant dialog(bytesOf(qPrintable(file)), file, nullptr);
        dialog.show();
        for (const QString &choice : choices) {
            const auto *box = dialog.findChild<QWidget *>("import." + choice);
            QVERIFY2(box && box->isVisible() && box->isEnabled(), qPrintable(choice));
        }
    }

    void aHugeFileIsRefusedWithoutReadingIt() {
        QTemporaryDir folder;
        QFile huge(folder.filePath("huge.csv"));
        QVERIFY(huge.open(QIODevice::WriteOnly));
        if (!huge.resize(qint64(2) << 30))
            QSKIP("no sparse files here");
        huge.close();
        const ShownWindow shown;
        shown.window->importFiles({huge.fileName()});
        QVERIFY(shown.window->findChild<QMessageBox *>("errorBox"));
        QVERIFY(!shown.window->hasDocument());
    }

    void aRefusedFileIsOneSentence() {
        const ShownWindow shown;
        shown.window->importFiles({QString(DATA) + "refused/test.xcal"});
        auto *box = shown.window->findChild<QMessageBox *>("errorBox");
        QVERIFY(box && box->informativeText().contains("Renishaw CARTO"));
        box->close();
        QVERIFY(!shown.window->hasDocument());
    }

    void speaksFrench() {
        setWindowLanguage(Language::Id::french);
        ImportAssistant dialog(bytesOf("tables/typical.csv"), "typical.csv", nullptr);
        dialog.show();
        QCOMPARE(dialog.findChild<QComboBox *>("import.delimiter")->accessibleName(), QString("Séparateur"));
    }
};

QTEST_MAIN(ImportAssistantTest)
#include "importassistanttest.moc"
