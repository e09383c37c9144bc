// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

/// Includes point only leftwards in the chain of CONTRIBUTING.md.
class LayersTest : public QObject {
    Q_OBJECT

private slots:
    void nothingOfTheWindow_data();
    void nothingOfTheWindow();
    void includesPointLeftwards_data();
    void includesPointLeftwards();
    void everyFolderHasItsPlace();
};

namespace {

const QString root = QStringLiteral(PROJECT);

/// A folder below the project and the folders whose headers it may include, as they are written in includes.
/// Its own are always allowed.
struct Layer {
    const char *folder;
    const char *mayInclude;
};

constexpr Layer layers[]{
    {"core/kernel/words", ""},
    {"core/kernel/numerics", ""},
    {"core/kernel/measurement", "kernel/words"},
    {"core/kernel/uncertainty", "kernel/words kernel/numerics kernel/measurement"},
    {"core/kernel/evaluation", "kernel/words kernel/numerics kernel/measurement kernel/uncertainty"},
    {"core/kernel/planning",
     "kernel/words kernel/numerics kernel/measurement kernel/uncertainty kernel/evaluation"},
    {"core/kernel/simulation",
     "kernel/words kernel/numerics kernel/measurement kernel/uncertainty kernel/evaluation"},
    {"core/kernel/diagnosis", "kernel/words kernel/numerics kernel/measurement kernel/uncertainty "
                              "kernel/evaluation kernel/simulation"},
    {"core/kernel/trend", "kernel/numerics"},
    {"core/language", "kernel/words kernel/measurement"},
    {"core/document", "kernel language"},
    {"core/tables", "kernel/words kernel/numerics document"},
    {"core/import", "kernel document tables"},
    {"core/validation", "kernel document tables import"},
    {"core/figures", "kernel document language"},
    {"core/editing", "kernel document language tables import"},
    {"core/report/blocks", "kernel document figures"},
    {"core/report/words", "kernel document language report/blocks"},
    {"core/report/tables", "kernel document language report/blocks report/words"},
    {"core/report/parts", "kernel document language figures report/blocks report/words report/tables"},
    {"core/report/explanations", "kernel document language figures report/blocks report/words"},
    {"core/report/help",
     "kernel document language validation report/blocks report/words report/explanations"},
    {"core/report", "kernel document language tables import validation figures"},
    {"core/export", "kernel document language tables import figures report"},
    {"core/proof", "kernel document language tables import validation figures report export"},
    {"core/register", "kernel document language export figures report proof"},
    {"core/print", "kernel document language figures report proof export"},
    {"ui",
     "kernel document language tables import validation export figures editing report proof register print "
     "ui"},
    {"app",
     "kernel document language tables import validation export figures editing report proof register print "
     "ui commandline commands formats"},
};

template <class Visit>
int eachSource(const QString &folder, Visit visit) {
    int files = 0;
    QDirIterator walk(folder, {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        QFile file(walk.next());
        if (!file.open(QIODevice::ReadOnly))
            return 0;
        ++files;
        visit(file.fileName(), QString::fromUtf8(file.readAll()));
    }
    return files;
}

} // namespace

void LayersTest::nothingOfTheWindow_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("forbidden");
    QTest::newRow("no window in core")
        << root + "/core"
        << R"(#include\s*<(Qt(Widgets|Charts|PrintSupport)\b|Q(Widget|Application|Chart)\b|QPrint))";
    for (const Layer &layer : layers) {
        const QString folder = layer.folder;
        if (folder.startsWith("core/") && folder != "core/print")
            QTest::addRow("no drawing in %s", layer.folder)
                << root + '/' + folder
                << R"(#include\s*<(Qt(Gui|Svg)\b|Q(Painter|Pen|Color|Font|GuiApplication)\b))";
    }
    QTest::newRow("no Qt in the kernel") << root + "/core/kernel"
                                         << R"(#include\s*<Q)";
}

void LayersTest::nothingOfTheWindow() {
    QFETCH(QString, folder);
    QFETCH(QString, forbidden);
    const QRegularExpression pattern(forbidden);
    const int files = eachSource(folder, [&](const QString &name, const QString &text) {
        const auto match = pattern.match(text);
        QVERIFY2(!match.hasMatch(), qPrintable(name + ": " + match.captured()));
    });
    QVERIFY(files > 0);
}

void LayersTest::includesPointLeftwards_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QStringList>("allowed");
    for (const Layer &layer : layers) {
        const QString folder = layer.folder;
        const QString own = folder.startsWith("core/") ? folder.mid(5) : folder;
        QTest::newRow(layer.folder) << folder
                                    << QString(layer.mayInclude).split(' ', Qt::SkipEmptyParts) +
                                           QStringList{own};
    }
}

void LayersTest::includesPointLeftwards() {
    QFETCH(QString, folder);
    QFETCH(QStringList, allowed);
    static const QRegularExpression include(R"(^\s*#include\s*"([^"]+)/[^"/]+")",
                                            QRegularExpression::MultilineOption);
    const int files = eachSource(root + '/' + folder, [&](const QString &name, const QString &text) {
        for (const auto &match : include.globalMatch(text)) {
            const QString from = match.captured(1);
            const bool isAllowed = std::ranges::any_of(
                allowed, [&](const QString &layer) { return from == layer || from.startsWith(layer + '/'); });
            QVERIFY2(isAllowed, qPrintable(name + " includes " + from));
        }
    });
    QVERIFY(files > 0);
}

void LayersTest::everyFolderHasItsPlace() {
    for (const QString &above : {QString("/core"), QString("/core/kernel"), QString("/core/report")}) {
        for (const QString &folder : QDir(root + above).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            const QString path = (above + '/' + folder).mid(1);
            const bool isLayer =
                std::ranges::any_of(layers, [&](const Layer &layer) { return path == layer.folder; });
            QVERIFY2(isLayer || path == "core/kernel", qPrintable(path));
        }
    }
}

QTEST_GUILESS_MAIN(LayersTest)
#include "layerstest.moc"
