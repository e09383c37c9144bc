#undef QT_NO_CAST_FROM_ASCII

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

class LayersTest : public QObject {
    Q_OBJECT

private slots:
    void includesStayInTheirLayer_data();
    void includesStayInTheirLayer();
};

void LayersTest::includesStayInTheirLayer_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("forbidden");
    QTest::newRow("no window in core") << CORE << R"(#include\s*<Qt(Gui|Widgets|Charts|Svg|PrintSupport)\b)";
    QTest::newRow("no class of the window in core")
        << CORE << R"(#include\s*<Q(Widget|Painter|Pen|Color|Font|Chart|Application|GuiApplication)\b)";
    QTest::newRow("no Qt in the kernel") << CORE "/kernel"
                                         << R"(#include\s*<Q)";
    QTest::newRow("the kernel looks at nothing above it") << CORE "/kernel"
                                                          << R"(#include\s*"(?!kernel/))";
}

void LayersTest::includesStayInTheirLayer() {
    QFETCH(QString, folder);
    QFETCH(QString, forbidden);
    const QRegularExpression pattern(forbidden);
    int files = 0;
    QDirIterator walk(folder, {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        QFile file(walk.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        ++files;
        const auto match = pattern.match(file.readAll());
        QVERIFY2(!match.hasMatch(), qPrintable(file.fileName() + ": " + match.captured()));
    }
    QVERIFY(files > 10);
}

QTEST_GUILESS_MAIN(LayersTest)
#include "layerstest.moc"
