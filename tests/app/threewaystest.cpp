// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "app/runcli.h"
#include "document/savedocument.h"
#include "import/importmeasurement.h"
#include "ui/application.h"
#include "ui/dialogs/reportdialog.h"
#include "ui/import/importassistant.h"
#include "ui/window/shownwindow.h"

#include <QAction>
#include <QClipboard>
#include <QHashSeed>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;

namespace {

QByteArray run(const QStringList &arguments) {
    return palmer::testdata::runCli(arguments).out;
}

/// id → value, of all parameters of a test.
QMap<QString, double> values(const TestEvaluation &evaluation) {
    QMap<QString, double> map;
    for (const Parameter &parameter : evaluation.parameters) {
        if (parameter.value)
            map[QString::fromStdString(parameterId(parameter))] = *parameter.value;
    }
    return map;
}

QMap<QString, double> values(const QJsonValue &test) {
    QMap<QString, double> map;
    for (const QJsonValue parameter : test["parameters"].toArray()) {
        if (parameter["value"].isDouble())
            map[parameter["id"].toString()] = parameter["value"].toDouble();
    }
    return map;
}

} // namespace

/// The same numbers, to the last bit, whichever way they come in: a file in the window, the clipboard, the
/// command line. The same report, whichever way it goes out.
class ThreeWaysTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }

    void theSameNumbers_data() {
        QTest::addColumn<QString>("name");
        for (const char *name :
             {"tables/typical.csv", "tables/bare-alternating.txt", "tables/list-arrows.csv",
              "tables/runs-down.csv", "tables/two-blocks.csv", "tables/rotary.csv", "tables/inches.txt",
              "tables/hundred-targets.csv", "tables/circle-both-senses.csv", "tables/circle-xy.csv",
              "tables/drift.csv", "rtl/typical.rtl", "rtl/missing-and-shuffled.rtl",
              "b5r/typical-absolute.b5r", "indexed/typical.txt", "ren/typical.ren"})
            QTest::newRow(name) << name;
    }

    void theSameNumbers() {
        QFETCH(QString, name);
        const QString path = DATA + name;
        const QByteArray bytes = readBytes(path);

        const ShownWindow opened;
        opened.window->importFiles({path});
        accept(opened);
        const Test file = *opened.window->model().document()->tests.at(0);

        const ShownWindow pasted;
        QGuiApplication::clipboard()->setText(QString::fromUtf8(bytes));
        pasted.find<QAction>("importClipboard")->trigger();
        accept(pasted);
        const Test clipboard = *pasted.window->model().document()->tests.at(0);

        QTemporaryDir folder;
        run({"import", path, "--accept", "--set", "unread=leave", "-o", folder.filePath("x.palmer")});
        const Test commandLine = *openDocument(folder.filePath("x.palmer")).tests.at(0);

        QVERIFY(clipboard.measurement == file.measurement);
        QVERIFY(commandLine.measurement == file.measurement);
        const QJsonObject results =
            QJsonDocument::fromJson(run({"evaluate", "--json", path, "--accept", "--set", "unread=leave"}))
                .object();
        const auto shown = values(*opened.window->evaluator().current().tests.at(0));
        QCOMPARE(values(results["tests"][0]), shown);
        QVERIFY(!shown.isEmpty() || std::holds_alternative<DriftMeasurement>(file.measurement));
    }

    void theSameReport_data() {
        QTest::addColumn<QString>("name");
        for (const char *name : {"iso230-2-1988-example", "rotary-axis", "x-axis-as-found-as-left",
                                 "iso230-4-full-circles-xy", "machine-acceptance-sheet", "thermal-behaviour"})
            QTest::newRow(name) << name;
    }

    /// Byte for byte that of the window and of the command line.
    void theSameReport() {
        QFETCH(QString, name);
        QTemporaryDir folder;
        const ShownWindow shown(examplePath(name.toLatin1()));
        ReportDialog dialog(shown.window->model(), shown.window->evaluator(), shown.window);
        dialog.show();
        QTRY_VERIFY(!dialog.isSimulating());
        QSignalSpy saved(&dialog, &ReportDialog::saved);
        dialog.saveTo(folder.filePath("window.pdf"));
        QVERIFY(saved.count() > 0 || saved.wait(patience));
        const QStringList files = saved.front().front().toStringList();
        QVERIFY(!files.isEmpty());
        run({"report", EXAMPLES + name + ".palmer", "-o", folder.filePath("command.pdf")});
        for (const QString &file : files) {
            const QByteArray bytes = readBytes(file);
            QVERIFY(bytes.startsWith("%PDF"));
            QVERIFY2(readBytes(QString(file).replace("window", "command")) == bytes, qPrintable(file));
        }
    }

private:
    static void accept(const ShownWindow &shown) {
        auto *assistant = shown.find<ImportAssistant>("importAssistant");
        while (!assistant->imported().questions.empty()) {
            auto *leave = assistant->findChild<QPushButton *>("answer.unread.leave");
            (leave && leave->isVisible() ? leave : assistant->findChild<QPushButton *>("confirmAll"))
                ->click();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        }
        assistant->findChild<QPushButton *>("acceptImport")->click();
        QVERIFY(shown.window->hasDocument());
    }
};

PALMER_TEST(runThreeWaysTest) {
    QHashSeed::setDeterministicGlobalSeed();              // as the programs do
    const auto application = makeApplication(argc, argv); // and its fonts
    ThreeWaysTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "threewaystest.moc"
