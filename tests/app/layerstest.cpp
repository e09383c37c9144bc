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

const QString root = QStringLiteral(PALMER_SOURCE_DIR);

/// A folder below the project and the folders whose headers it may include, as they are written in includes.
/// Its own are always allowed; each of the others is used.
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
    {"core/kernel/planning", "kernel/numerics kernel/measurement kernel/evaluation"},
    {"core/kernel/simulation", "kernel/numerics kernel/measurement kernel/uncertainty kernel/evaluation"},
    {"core/kernel/diagnosis",
     "kernel/words kernel/numerics kernel/measurement kernel/evaluation kernel/simulation"},
    {"core/kernel/comparison",
     "kernel/numerics kernel/measurement kernel/uncertainty kernel/evaluation kernel/simulation"},
    {"core/kernel/thermal", "kernel/numerics"},
    {"core/kernel/trend", "kernel/numerics"},
    {"core/kernel/typetest", "kernel/numerics"},
    {"core/language", "kernel/words kernel/numerics kernel/measurement"},
    {"core/system", ""},
    {"core/document", "system kernel language"},
    {"core/tables", "system kernel/words document"},
    {"core/import", "system kernel document tables"},
    {"core/figures", "system kernel document language"},
    {"core/editing", "kernel document language tables import"},
    {"core/report/blocks", "kernel document figures"},
    {"core/report/words", "kernel document language report/blocks"},
    {"core/report/tables", "kernel document language report/blocks report/words"},
    {"core/report/parts", "kernel document language figures report/blocks report/words report/tables"},
    {"core/report/explanations", "kernel document language figures report/words"},
    {"core/report/help", "kernel document language report/blocks report/words report/explanations"},
    {"core/report", "kernel document language figures"},
    {"core/export", "kernel document language tables import report"},
    {"core/validation", "system kernel document language export report"},
    {"core/proof", "kernel document language report"},
    {"core/register", "system kernel document language figures report proof"},
    {"core/print", "system kernel document language figures report proof export"},
    {"ui/model", "system kernel document tables editing"},
    {"ui", "kernel document language tables import figures editing report print ui/model"},
    {"ui/figures", "kernel document language figures report print ui ui/model"},
    {"ui/forms", "kernel document language editing report print ui ui/model"},
    {"ui/results", "kernel document language report print ui ui/model"},
    {"ui/readings", "kernel document language figures editing report print ui ui/model"},
    {"ui/drift", "kernel document language editing report ui ui/model ui/figures"},
    {"ui/circles", "kernel document language tables import editing figures print ui ui/model ui/forms"},
    {"ui/uncertainty", "kernel language figures editing report ui ui/model ui/forms ui/figures"},
    {"ui/comparison", "kernel document language import figures report ui ui/model ui/figures"},
    {"ui/diagnosis", "kernel document language figures report print ui ui/model ui/figures"},
    {"ui/proof", "proof ui"},
    {"ui/help", "kernel document report validation print ui ui/model"},
    {"ui/navigation", "kernel document report ui ui/model"},
    {"ui/welcome", "kernel document import ui"},
    {"ui/import", "kernel document language import figures ui ui/model ui/figures"},
    {"ui/dialogs",
     "kernel document language import figures editing report export validation print ui ui/model ui/forms "
     "ui/figures"},
    {"ui/register", "kernel document language figures report register print ui ui/model ui/figures ui/help "
                    "ui/dialogs"},
    {"ui/window",
     "system kernel document language import figures editing report export print register ui ui/model "
     "ui/figures "
     "ui/forms ui/results ui/readings ui/drift ui/circles ui/uncertainty ui/comparison ui/diagnosis ui/proof "
     "ui/help ui/navigation ui/welcome ui/import ui/dialogs ui/register"},
    {"app",
     "system kernel document language import validation export figures editing report proof register print "
     "ui ui/model ui/window commandline commands formats"},
};

bool hasRow(const QString &folder) {
    return std::ranges::any_of(layers, [&](const Layer &layer) { return folder == layer.folder; });
}

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
    QStringList unused = allowed;
    unused.removeLast(); // its own
    const int files = eachSource(root + '/' + folder, [&](const QString &name, const QString &text) {
        const QString own = QFileInfo(name).path().mid(root.size() + 1);
        if (own != folder && hasRow(own))
            return; // looked at by its own row
        for (const auto &match : include.globalMatch(text)) {
            const QString from = match.captured(1);
            const auto holds = [&](const QString &layer) {
                return from == layer || (layer != "ui" && from.startsWith(layer + '/'));
            };
            QVERIFY2(std::ranges::any_of(allowed, holds), qPrintable(name + " includes " + from));
            unused.removeIf(holds);
        }
    });
    QVERIFY2(unused.isEmpty(), qPrintable(folder + " does not include " + unused.join(' ')));
    QVERIFY(files > 0);
}

void LayersTest::everyFolderHasItsPlace() {
    for (const QString &above :
         {QString("/core"), QString("/core/kernel"), QString("/core/report"), QString("/ui")}) {
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
