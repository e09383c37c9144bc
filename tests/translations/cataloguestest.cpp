// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include <QDir>
#include <QDirIterator>
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
    QString source;
    QString comment;
    bool counted = false;
    QStringList translations; // the plural forms, or one

    QString key() const { return source + u'\u0004' + comment + u'\u0004' + (counted ? "n" : ""); }
};

QList<Entry> entriesOf(const QString &path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(path));
    QList<Entry> entries;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"message")
            entries.append(Entry{{}, {}, xml.attributes().value("numerus") == u"yes", {}});
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

QStringList placesOf(const QString &text) {
    static const QRegularExpression place("%[1-9n]");
    QStringList places;
    for (auto match = place.globalMatch(text); match.hasNext();)
        places += match.next().captured();
    places.removeDuplicates();
    places.sort();
    return places;
}

QString catalogue(const char *name) {
    return QString(CATALOGUES) + u'/' + name;
}

/// Words that are the same in both languages.
const QSet<QString> sameInBoth{"Contribution", "Positions",    "Date",       "Machine",      "Signature",
                               "Signatures",   "Verdict",      "Instrument", "Instruments",  "Position",
                               "minimum",      "maximum",      "note",       "Air",          "Cycle",
                               "Point",        "page %1 / %2", "Centre",     "Centre %1",    "Source",
                               "Centre, F",    "Compensation", "Points",     "Angles",       "Correction C",
                               "positions",    "rad",          "mrad",       "µrad",         "mdeg",
                               "gon",          "µin",          "min",        "Format",       "Arc (°)",
                               "air",          "machine",      "point .",    "Page",         "Type",
                               "Verdicts",     "Angle",        "Sources",    "source 1",     "Budget (GUM)",
                               "amplitude",    "compensation", "collision",  "intervention", "Machines"};

/// What is wrong with the typography of a French text; empty where nothing is.
QString fault(const QString &text) {
    static const QList<std::pair<QRegularExpression, QString>> rules{
        {QRegularExpression("(?<!\u202F)[;!?]"), "U+202F is missing before ; ! or ?"},
        {QRegularExpression("[ \u202F]:|(?<!\u00A0):(?=[\\s\u00A0]|$)"), "U+00A0 is missing before a colon"},
        {QRegularExpression("'"), "a straight apostrophe"},
        {QRegularExpression("\""), "straight quotation marks"},
        {QRegularExpression("«(?![\u00A0\u202F])|(?<![\u00A0\u202F])»"), "no-break space is missing in « »"},
        {QRegularExpression("  |^ | $"), "a space too many"},
        {QRegularExpression("\\.\\.\\."), "three points instead of …"},
        {QRegularExpression("[0-9] ?(µm|mm|°C|%(?![1-9n]))"), "a unit without its no-break space"},
        {QRegularExpression("\\b(selon|sous|pour|de|par|d’après)[ \u00A0]ISO"),
         "a standard without its article"},
    };
    for (const auto &[rule, meaning] : rules)
        if (rule.match(text).hasMatch())
            return meaning;
    return {};
}

/// Counts that are never 1, or are gone in a moment.
const QSet<QString> neverOne{
    "%1 common targets; the first %2 cycles of each test",
    "U of the difference: one simulation of both tests (JCGM 101), %1 trials, 95.45 %. Whole cycles are "
    "drawn anew, a method of this program: residuals widened by half of Student’s t of 2n − 2 degrees of "
    "freedom; band of the curves by Bonferroni.",
    "%1 of %2 values reproduced.",
    "%1 readings: mean %2, range %3",
    "%1, %2: %3 points evaluated from %4 to %5",
    "The workbook has %1 sheets; “%2” is read.",
    "The workbook has %1 sheets; “%2” is read, which is hidden.",
    "The workbook has %1 sheets, several with a measurement; “%2” is read.",
    "The workbook has %1 sheets, several with rows of numbers; “%2” is read, the others are not.",
    "Monte Carlo: %1 of %2 trials",
    "Monte Carlo: %1 trials",
    "%1 runs on a bow: its ends lie towards +%2.", // an axis
    "%1 runs on a bow: its ends lie towards −%2.",
    "this text has %1 characters; expected no more than %2",
    "polygon of %1 faces",
    "fewer than %1 tests since the last intervention",
    "%1 in %2 years", // with a decimal
    "%1 machines may be meant by “%2”: %3; say the number before its name",
    "the number of a history has at most %1 characters",
    "x_ij is actual position minus target position; %1 counts targets, %2 runs; ↑ and ↓ are approaches in "
    "the positive and the negative direction. A clause that is not known is not printed.", // letters
};

} // namespace

class CataloguesTest : public QObject {
    Q_OBJECT

private slots:
    void areComplete_data();
    void areComplete();
    void holdTheTextsOfTheSources_data();
    void holdTheTextsOfTheSources();
    void knowTheTextsTheWindowTakesFromThem();
    void translateEveryText_data();
    void translateEveryText();
    void knowFrenchTypography_data();
    void knowFrenchTypography();
    void areFrench();
    void countsHaveTheirPlurals();
    void leaveOutWordsThatWereGivenUp_data();
    void leaveOutWordsThatWereGivenUp();
};

void CataloguesTest::areComplete_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("French") << "report_fr.ts";
    QTest::newRow("English plurals") << "report_en.ts";
}

void CataloguesTest::areComplete() {
    QFETCH(QString, name);
    QFile file(catalogue(qPrintable(name)));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString written = QString::fromUtf8(file.readAll());
    const auto found = QRegularExpression("type=\"(unfinished|vanished|obsolete)\"").match(written);
    QVERIFY2(!found.hasMatch(),
             qPrintable(found.captured() + " near " + written.mid(found.capturedStart() - 200, 200)));
    QVERIFY2(!written.contains("<location"), "places in the sources make every change of code a change here");
}

void CataloguesTest::holdTheTextsOfTheSources_data() {
    areComplete_data();
}

void CataloguesTest::holdTheTextsOfTheSources() {
    QFETCH(QString, name);
    const bool plurals = name == u"report_en.ts";
    QTemporaryDir folder;
    const QString copy = folder.filePath(name);
    QVERIFY(QFile::copy(catalogue(qPrintable(name)), copy));
    QStringList arguments = QString(OPTIONS).split(u'|');
    if (plurals)
        arguments += "-pluralonly";
    arguments += QString(SOURCES).split(u'|');
    arguments += {"-ts", copy, "-target-language", plurals ? "en" : "fr"};
    QProcess lupdate;
    lupdate.start(LUPDATE, arguments);
    QVERIFY2(lupdate.waitForFinished(patience), qPrintable(lupdate.errorString()));
    QVERIFY2(lupdate.exitStatus() == QProcess::NormalExit && lupdate.exitCode() == 0,
             lupdate.readAllStandardError());

    const QSet<QString> committed = keysOf(catalogue(qPrintable(name))), sources = keysOf(copy);
    QVERIFY2(plurals || !sources.isEmpty(), "lupdate found no text at all");
    const QStringList added = (sources - committed).values(), gone = (committed - sources).values();
    QVERIFY2(added.isEmpty(), qPrintable("not in the catalogue: " + added.join(" | ")));
    QVERIFY2(gone.isEmpty(), qPrintable("no longer in the sources: " + gone.join(" | ")));
}

/// What the window says in words of the report has to stand in core, too: there it is collected.
void CataloguesTest::knowTheTextsTheWindowTakesFromThem() {
    QSet<QString> known;
    for (const Entry &entry : entriesOf(catalogue("report_fr.ts")))
        known += entry.source;
    static const QRegularExpression text(
        R"x(REPORT_TEXT(?:_COUNTED)?(?:_FOR)?\(\s*"report",\s*((?:"(?:[^"\\]|\\.)*"\s*)+))x");
    static const QRegularExpression joint(R"("\s*")");
    int sourcesRead = 0;
    QDirIterator sources(WINDOW_SOURCES, {"*.cpp", "*.h"}, QDir::Files, QDirIterator::Subdirectories);
    while (sources.hasNext()) {
        QFile file(sources.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString code = QString::fromUtf8(file.readAll());
        for (auto match = text.globalMatch(code); match.hasNext();) {
            QString literal = match.next().captured(1).trimmed();
            literal = literal.mid(1, literal.size() - 2).remove(joint);
            QVERIFY2(known.contains(literal), qPrintable(file.fileName() + ": " + literal));
        }
        ++sourcesRead;
    }
    QVERIFY(sourcesRead > 0);
}

void CataloguesTest::translateEveryText_data() {
    areComplete_data();
}

void CataloguesTest::translateEveryText() {
    QFETCH(QString, name);
    QSet<QString> seen;
    for (const Entry &entry : entriesOf(catalogue(qPrintable(name)))) {
        const QByteArray place = entry.source.toUtf8();
        QVERIFY2(!seen.contains(entry.source + u'\u0004' + entry.comment), place);
        seen += entry.source + u'\u0004' + entry.comment;
        QVERIFY2(entry.counted || !entry.source.contains("(s)"),
                 place + ": (s) belongs to REPORT_TEXT_COUNTED");
        QVERIFY2(!entry.counted || entry.source.contains("%n"), place + ": a plural of what?");
        QVERIFY2(entry.counted || !entry.source.contains("%n"),
                 place + ": a count belongs to REPORT_TEXT_COUNTED, or several have no translation");
        QCOMPARE(entry.translations.size(), entry.counted ? 2 : 1);
        for (qsizetype form = 0; form < entry.translations.size(); ++form) {
            QStringList expected = placesOf(entry.source), found = placesOf(entry.translations[form]);
            if (form == 0 && entry.counted) { // one may be said in words
                expected.removeAll("%n");
                found.removeAll("%n");
            }
            QVERIFY2(!entry.translations[form].trimmed().isEmpty(), place);
            QVERIFY2(found == expected, place + " -> " + entry.translations[form].toUtf8());
        }
    }
}

void CataloguesTest::knowFrenchTypography_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("right");
    QTest::newRow("colon") << "écart\u00A0: %1" << true;
    QTest::newRow("designation") << "ISO 230-2:2006, 500:1" << true;
    QTest::newRow("semicolon, question, exclamation") << "un\u202F; deux\u202F? trois\u202F!" << true;
    QTest::newRow("quotes and apostrophe") << "l’axe «\u00A0X\u00A0»" << true;
    QTest::newRow("unit") << "0,1\u00A0µm" << true;
    QTest::newRow("plain space before a colon") << "écart : %1" << false;
    QTest::newRow("narrow space before a colon") << "écart\u202F: %1" << false;
    QTest::newRow("no space before a colon") << "écart: %1" << false;
    QTest::newRow("no space before a last colon") << "écart:" << false;
    QTest::newRow("plain space before a semicolon") << "un ; deux" << false;
    QTest::newRow("no space before a question mark") << "un?" << false;
    QTest::newRow("straight apostrophe") << "l'axe" << false;
    QTest::newRow("straight quotes") << "\"X\"" << false;
    QTest::newRow("plain space in quotes") << "« X »" << false;
    QTest::newRow("plain space before a unit") << "0,1 µm" << false;
}

void CataloguesTest::knowFrenchTypography() {
    QFETCH(QString, text);
    QTEST(fault(text).isEmpty(), "right");
}

void CataloguesTest::areFrench() {
    static const QRegularExpression word("[[:alpha:]]*[[:lower:]][[:alpha:]]*",
                                         QRegularExpression::UseUnicodePropertiesOption);
    const auto hasWord = [](const QString &text) {
        for (auto match = word.globalMatch(text); match.hasNext();)
            if (match.next().capturedLength() > 2)
                return true;
        return false;
    };
    for (const Entry &entry : entriesOf(catalogue("report_fr.ts")))
        for (const QString &translation : entry.translations) {
            const QByteArray found = translation.toUtf8();
            QVERIFY2(fault(translation).isEmpty(), found + ": " + fault(translation).toUtf8());
            const bool same =
                translation == entry.source && hasWord(translation) && !sameInBoth.contains(translation);
            QVERIFY2(!same, found + " is the English text");
        }
}

/// "1 questions are open": a count before the name of what is counted is %n of a REPORT_TEXT_COUNTED.
void CataloguesTest::countsHaveTheirPlurals() {
    static const QRegularExpression counted(
        "%[1-9][ \u00A0](arcs|characters|columns|cycles|decimals|faces|files|formulas|limits|lines|"
        "machines|months|numbers|pages|parameters|points|questions|readings|requirements|rows|runs|samples|"
        "sensors|sheets|targets|tests|trials|values|years)\\b");
    QStringList wrong;
    for (const Entry &entry : entriesOf(catalogue("report_fr.ts"))) {
        if (!entry.counted && counted.match(entry.source).hasMatch() && !neverOne.contains(entry.source))
            wrong += entry.source;
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(" | ")));
}

/// One thing has one name in report, window, help and command line: what was given up for another word.
void CataloguesTest::leaveOutWordsThatWereGivenUp_data() {
    QTest::addColumn<bool>("french");
    QTest::addColumn<QString>("pattern");
    const auto row = [](bool french, const char *pattern) { QTest::newRow(pattern) << french << pattern; };
    for (const char *pattern : {"L’édition (%1|ISO) ",
                                "de plus que (la bande|l’incertitude)",
                                "ne peut être refusé(?!e à ce titre)",
                                "[Vv]erdict (est )?pris",
                                "qui gouverne",
                                "qui décide|[Uu] du budget décide",
                                "[Ll]igne de mesurage :",
                                "Précisions sur la machine",
                                "ne connaît pas de rejet",
                                "[Vv]aleur ici|^Ici −",
                                "exigences? non tenue",
                                "avertissement",
                                "[Rr]efus prouvé",
                                "fois U",
                                "[Gg]raine",
                                "[Pp]oint d’arrêt",
                                "[Dd]ésalignement",
                                "Var\\. environn|Instr\\.",
                                "[Pp]ériode de l’écart",
                                "[Zz]éro du déplacement",
                                "^(Complète, en|À vide)",
                                "(selon|de) (ISO|VDI) ",
                                "Le même calcul",
                                "articles? [0-9]+\\.[0-9]",
                                "[Nn]e pas tenir compte",
                                "Copier l’essai",
                                "Refaire l’essai",
                                "U de [AREMB]\\b",
                                "un chacun",
                                "coupe de %",
                                "^Plus (petit|grand)$",
                                "[Mm]arque décimale",
                                "\\b[KkM]o\\b"}) // sizes as file dialogs say them: Kio, Mio
        row(true, pattern);
    for (const char *pattern :
         {"place of the (2 m )?working zone", "\\b[Bb]idirectional", "means and limits at",
          "taken from (the )?unrounded", "that rules the parameter", "(budget|simulation) decides",
          "[Tt]o improve first", "errors of measurement shift", "is surer", "may not be rejected",
          "centred anew", "was not unloaded", "stand-ins?\\b", "\\b[kKM]B\\b"})
        row(false, pattern);
}

void CataloguesTest::leaveOutWordsThatWereGivenUp() {
    QFETCH(bool, french);
    QFETCH(QString, pattern);
    const QRegularExpression word(pattern, QRegularExpression::UseUnicodePropertiesOption);
    QVERIFY(word.isValid());
    for (const char *name : {"report_fr.ts", "ui_fr.ts", "report_en.ts", "ui_en.ts"})
        for (const Entry &entry : entriesOf(catalogue(name))) {
            const bool isFrench = QLatin1StringView(name).endsWith(QLatin1StringView("fr.ts"));
            QStringList texts = isFrench == french ? entry.translations : QStringList();
            if (!french)
                texts += entry.source;
            for (const QString &text : texts)
                QVERIFY2(!word.match(QString(text).replace(u'\u00A0', u' ')).hasMatch(),
                         name + (": " + text).toUtf8());
        }
}

QTEST_GUILESS_MAIN(CataloguesTest)
#include "cataloguestest.moc"
