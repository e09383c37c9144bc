// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include <QFile>
#include <QMap>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

namespace {

struct Entry {
    QString context;
    QString source;
    QString comment;
    bool counted = false;
    QStringList translations; // the plural forms, or one

    QString key() const { return QStringList{context, source, comment, counted ? "n" : ""}.join(u'\u0004'); }
};

QList<Entry> entriesOf(const QString &path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(path));
    QList<Entry> entries;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"name")
            context = xml.readElementText();
        else if (xml.name() == u"message")
            entries.append(Entry{context, {}, {}, xml.attributes().value("numerus") == u"yes", {}});
        else if (xml.name() == u"source")
            entries.last().source = xml.readElementText();
        else if (xml.name() == u"comment")
            entries.last().comment = xml.readElementText();
        else if (xml.name() == u"numerusform" || (xml.name() == u"translation" && !entries.last().counted))
            entries.last().translations += xml.readElementText();
    }
    if (xml.hasError())
        qFatal("%s: %s", qPrintable(path), qPrintable(xml.errorString()));
    return entries;
}

QSet<QString> keysOf(const QString &path) {
    QSet<QString> keys;
    for (const Entry &entry : entriesOf(path))
        keys += entry.key();
    return keys;
}

/// Texts of the report that the window may share: French by source.
QMap<QString, QString> textsOfTheReport() {
    QMap<QString, QString> texts;
    for (const Entry &entry : entriesOf(QString(CATALOGUES) + "/report_fr.ts")) {
        if (!entry.counted && entry.comment.isEmpty())
            texts[entry.source] = entry.translations.first();
    }
    return texts;
}

QStringList placesOf(const QString &text) {
    static const QRegularExpression place("%[1-9n]");
    QStringList places;
    for (auto match = place.globalMatch(text); match.hasNext();)
        places += match.next().captured();
    places.removeDuplicates();
    places.sort();
    return places;
}

QString catalogue(const QString &name) {
    return QString(CATALOGUES) + u'/' + name;
}

QString fault(const QString &text) {
    static const QList<std::pair<QRegularExpression, QString>> rules{
        {QRegularExpression("(?<!\u202F)[;!?]"), "U+202F is missing before ; ! or ?"},
        {QRegularExpression("[ \u202F]:|(?<!\u00A0):(?=[\\s\u00A0]|$)"), "U+00A0 is missing before a colon"},
        {QRegularExpression("«(?![\u00A0\u202F])|(?<![\u00A0\u202F])»"), "the space inside « » can break"},
        {QRegularExpression("'"), "a straight apostrophe"},
        {QRegularExpression("\""), "straight quotation marks"},
        {QRegularExpression("  |^ | $"), "a space too many"},
        {QRegularExpression("\\.\\.\\."), "three points for an ellipsis"},
    };
    for (const auto &[rule, meaning] : rules)
        if (rule.match(text).hasMatch())
            return meaning;
    return {};
}

} // namespace

class WindowCataloguesTest : public QObject {
    Q_OBJECT

private slots:
    void areComplete_data();
    void areComplete();
    void holdTheTextsOfTheSources_data() { areComplete_data(); }
    void holdTheTextsOfTheSources();
    void keepPlacesAndMnemonics();
    void areFrench();
    void sayNothingTwice();
};

void WindowCataloguesTest::areComplete_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("French") << "ui_fr.ts";
    QTest::newRow("English plurals") << "ui_en.ts";
}

void WindowCataloguesTest::areComplete() {
    QFETCH(QString, name);
    QFile file(catalogue(name));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto found = QRegularExpression("type=\"(unfinished|vanished|obsolete)\"")
                           .match(QString::fromUtf8(file.readAll()));
    QVERIFY2(!found.hasMatch(), qPrintable(found.captured()));
    const QList<Entry> entries = entriesOf(catalogue(name));
    QVERIFY(!entries.isEmpty());
    for (const Entry &entry : entries) {
        QCOMPARE(entry.translations.size(), entry.counted ? 2 : 1);
        for (const QString &translation : entry.translations)
            QVERIFY2(!translation.trimmed().isEmpty(), qPrintable(entry.source));
        static const QSet<QString> others{"edits", "examples",
                                          // of Qt, whose own French is incomplete
                                          "QAbstractFileIconProvider", "QFileDialog", "QPlatformTheme"};
        QVERIFY2(entry.context.startsWith("palmer::ui::") || others.contains(entry.context),
                 qPrintable(entry.context + ": tr() would look in another context"));
    }
}

void WindowCataloguesTest::holdTheTextsOfTheSources() {
    QFETCH(QString, name);
    const bool plurals = name == u"ui_en.ts";
    const QTemporaryDir folder;
    const QString copy = folder.filePath(name);
    QVERIFY(QFile::copy(catalogue(name), copy));
    QStringList arguments = QString(OPTIONS).split(u'|');
    if (plurals)
        arguments += "-pluralonly";
    arguments += {SOURCES, "-ts", copy, "-target-language", plurals ? "en" : "fr"};
    QProcess lupdate;
    lupdate.start(LUPDATE, arguments);
    QVERIFY2(lupdate.waitForFinished(patience), qPrintable(lupdate.errorString()));
    QVERIFY2(lupdate.exitStatus() == QProcess::NormalExit && lupdate.exitCode() == 0,
             lupdate.readAllStandardError());
    const QSet<QString> committed = keysOf(catalogue(name)), sources = keysOf(copy);
    const QStringList added = (sources - committed).values(), gone = (committed - sources).values();
    const auto shared = textsOfTheReport();
    QStringList missing;
    for (const QString &key : added) {
        const QStringList parts = key.split(u'\u0004'); // context, source, comment, counted
        if (parts[3] == "n" || !shared.contains(parts[1]))
            missing += key;
    }
    QVERIFY2(missing.isEmpty(), qPrintable("not in the catalogue: " + missing.join(" | ")));
    QVERIFY2(gone.isEmpty(), qPrintable("no longer in the sources: " + gone.join(" | ")));
}

void WindowCataloguesTest::keepPlacesAndMnemonics() {
    for (const Entry &entry : entriesOf(catalogue("ui_fr.ts"))) {
        for (const QString &translation : entry.translations) {
            QStringList expected = placesOf(entry.source), found = placesOf(translation);
            if (entry.counted) { // one may be said in words
                expected.removeAll("%n");
                found.removeAll("%n");
            }
            QVERIFY2(found == expected, qPrintable(entry.source + " -> " + translation));
            QVERIFY2(entry.source.contains(u'&') == translation.contains(u'&'),
                     qPrintable(entry.source + " -> " + translation));
        }
    }
}

void WindowCataloguesTest::areFrench() {
    for (const Entry &entry : entriesOf(catalogue("ui_fr.ts"))) {
        for (const QString &translation : entry.translations)
            QVERIFY2(fault(translation).isEmpty(), qPrintable(translation + ": " + fault(translation)));
    }
}

/// Texts that window and report share stand only in the catalogue of the report.
void WindowCataloguesTest::sayNothingTwice() {
    const auto shared = textsOfTheReport();
    QVERIFY(!shared.isEmpty());
    for (const Entry &entry : entriesOf(catalogue("ui_fr.ts")))
        QVERIFY2(entry.counted || shared.value(entry.source) != entry.translations.first(),
                 qPrintable(entry.context + ": " + entry.source));
}

QTEST_GUILESS_MAIN(WindowCataloguesTest)
#include "windowcataloguestest.moc"
