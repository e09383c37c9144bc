// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/print/pdf/generator.h"
#include "kernel/measurement/testfacts.h"
#include "report/tables/resulttable.h"

#include <QDir>

using namespace palmer;
using namespace palmer::testdata;

namespace {

constexpr double dotsPerInch = 30;
constexpr double dotsPerMillimetre = dotsPerInch / 25.4;
constexpr double topMargin = 15; // mm, as those below
constexpr double bottomMargin = 18;
constexpr double mostBlank = 1.0 / 3; ///< of a page with results

/// The page, from 0, on which a text stands; −1: on none.
qsizetype pageOf(const QString &text, const QStringList &pages, qsizetype from = 0) {
    for (qsizetype i = from; i < pages.size(); ++i) {
        if (pages[i].contains(squeezed(text)))
            return i;
    }
    return -1;
}

/// What is free between the lowest ink and the footer, as part of the height of the text.
double blankPart(const QImage &page) {
    const int bottom = static_cast<int>(page.height() - bottomMargin * dotsPerMillimetre);
    const int top = static_cast<int>(topMargin * dotsPerMillimetre);
    int lowest = top;
    for (int y = top; y < bottom; ++y) {
        for (int x = 0; x < page.width(); ++x) {
            if (qGray(page.pixel(x, y)) < 200)
                lowest = y;
        }
    }
    return static_cast<double>(bottom - lowest) / (bottom - top);
}

/// What a reader looks for on the first page of a test.
struct Sought {
    QString head = {};    ///< its last line
    QString verdict = {}; ///< label and word
    QString word = {};
    QString statements = {};
    QString reason = {};  ///< why the limits are met or not
    QString heading = {}; ///< of the results; empty: there are none
    QStringList rows = {};
};

std::vector<Sought> soughtIn(const Report &report) {
    std::vector<Sought> tests;
    const Heading *heading = nullptr;
    for (const Block &block : report.blocks) {
        if (const auto *head = std::get_if<TestHead>(&block)) {
            tests.push_back({head->right.rows.back().key});
            heading = nullptr;
        }
        if (const auto *found = std::get_if<Heading>(&block))
            heading = found;
        const auto *verdict = std::get_if<VerdictLine>(&block);
        if (verdict && !verdict->large) {
            tests.back().verdict = verdict->label + verdict->word;
            tests.back().word = verdict->word;
            tests.back().statements =
                verdict->limits.label + verdict->limits.state + verdict->limits.text.plain();
            tests.back().reason = verdict->limits.text.plain();
        }
        const auto *table = std::get_if<Table>(&block);
        if (table && heading && table->unbroken && tests.back().heading.isEmpty() &&
            table->columns.size() > 2 && table->columns[0].titleSpan == 2) {
            tests.back().heading = heading->text;
            for (const auto &row : table->rows)
                tests.back().rows << row[0].text.plain() + row[1].text.plain();
        }
    }
    std::erase_if(tests, [](const Sought &test) { return test.verdict.isEmpty(); }); // the summary
    return tests;
}

} // namespace

/// The verdict stands below the head of a test, the results on the same page or whole on the next.
class FirstPageTest : public QObject {
    Q_OBJECT

private slots:
    void resultsAndVerdictAreThere_data();
    void resultsAndVerdictAreThere();
    void theDecisionIsReadAtOnce_data();
    void theDecisionIsReadAtOnce();
    void aTestOf11TargetsHasFourPages();
    void certificatesHaveTwoPages_data();
    void certificatesHaveTwoPages();
    void purposesHaveOnePage_data();
    void purposesHaveOnePage();
    void aLongHeadKeepsTheVerdict();
    void resultsStandBeforeAFigureWithoutRoom();
};

void FirstPageTest::resultsAndVerdictAreThere_data() {
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<Language::Id>("language");
    constexpr unsigned seeds = 30;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const bool french = seed % 2 == 0;
        QTest::newRow(qPrintable(u"seed %1 in %2"_s.arg(seed).arg(french ? u"French"_s : u"English"_s)))
            << seed << (french ? Language::Id::french : Language::Id::english);
    }
}

void FirstPageTest::resultsAndVerdictAreThere() {
    QFETCH(const unsigned, seed);
    QFETCH(const Language::Id, language);
    const Report report = reportOf(Generator(seed).document(), language);
    const QByteArray pdf = pdfOf(report);
    QStringList pages;
    for (const QString &page : pageTexts(pdf))
        pages << squeezed(page);
    const QList<QImage> images = pictures(pdf, dotsPerInch);
    qsizetype from = 0;
    for (const Sought &test : soughtIn(report)) {
        const qsizetype verdict = pageOf(test.verdict, pages, from);
        QVERIFY2(verdict >= 0, qPrintable(test.verdict));
        QVERIFY2(pages[verdict].contains(squeezed(test.statements)), qPrintable(pages[verdict]));
        QVERIFY2(pages[verdict].contains(squeezed(test.head)), qPrintable(u"no head with "_s + test.verdict));
        QVERIFY2(verdict + 1 == pages.size() || blankPart(images[verdict]) <= mostBlank,
                 qPrintable(u"page %1: %2 blank"_s.arg(verdict + 1).arg(blankPart(images[verdict]))));
        from = verdict + 1;
        if (test.heading.isEmpty())
            continue;
        const qsizetype results = pageOf(test.heading, pages, verdict);
        QVERIFY2(results == verdict || results == verdict + 1, qPrintable(test.heading));
        for (const QString &row : test.rows)
            QVERIFY2(pages[results].contains(squeezed(row)), qPrintable(row));
    }
}

/// With random limits and rules: the word of the verdict, the deciding quantity with its value and its limit
/// end in the upper third of the page.
void FirstPageTest::theDecisionIsReadAtOnce_data() {
    QTest::addColumn<unsigned>("seed");
    constexpr unsigned seeds = 20;
    for (unsigned seed = 1; seed <= seeds; ++seed)
        QTest::newRow(qPrintable(QString::number(seed))) << seed;
}

void FirstPageTest::theDecisionIsReadAtOnce() {
    QFETCH(unsigned, seed);
    static const QStringList names{u"limits-2006"_s, u"budget-2006"_s, u"rotary-axis"_s,
                                   u"iso230-2-1988-example"_s, u"iso230-4-full-circles-xy"_s};
    Document document = storedDocument(names[static_cast<qsizetype>(seed) % names.size()]);
    Test test = *document.tests.front();
    do {
        Generator(++seed * 1000).addLimits(test);
    } while (!hasLimits(test.limits));
    document.tests = {std::make_shared<const Test>(test)};
    const auto language = seed % 2 == 0 ? Language::Id::french : Language::Id::english;
    const Report report = reportOf(document, language);
    const Sought sought = soughtIn(report).front();
    const QString third =
        squeezed(QString::fromUtf8(run(u"pdftotext"_s,
                                       {u"-l"_s, u"1"_s, u"-x"_s, u"0"_s, u"-y"_s, u"0"_s, u"-W"_s, u"595"_s,
                                        u"-H"_s, u"281"_s, u"-"_s, u"-"_s},
                                       pdfOf(report))));
    QVERIFY2(third.contains(squeezed(sought.word)), qPrintable(third));
    QVERIFY2(third.contains(squeezed(sought.reason)), qPrintable(sought.reason + u'\n' + third));
    const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
    const bool named = std::ranges::any_of(
        printedResults(*evaluated.document, test, *evaluated.tests[0], Language(language)),
        [&](const PrintedResult &result) {
            return !result.limit.isEmpty() && sought.reason.contains(result.limit) &&
                   sought.reason.contains(QString(result.value).remove(u'−')) &&
                   (test.decisionRule.rule == Rule::simpleAcceptance ||
                    sought.reason.contains(result.uncertainty));
        });
    QVERIFY2(named, qPrintable(sought.reason));
}

/// 11 × 5 × 2: a certificate of two pages, and an annex of two.
void FirstPageTest::aTestOf11TargetsHasFourPages() {
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        const QString end =
            squeezed(language == Language::Id::french ? u"Fin du certificat"_s : u"End of the certificate"_s);
        const QStringList pages =
            pageTexts(pdfOf(reportOf(storedDocument(u"iso230-2-1988-example"_s), language)));
        QCOMPARE(pages.size(), 4);
        QVERIFY(squeezed(pages[1]).contains(end));
        QVERIFY(squeezed(pages[2]).contains(language == Language::Id::french ? u"Annexe"_s : u"Annex"_s));
    }
}

void FirstPageTest::certificatesHaveTwoPages_data() {
    QTest::addColumn<Language::Id>("language");
    for (const QString &name :
         {u"iso230-2-1988-example"_s, u"rotary-axis"_s, u"iso230-4-full-circles-xy"_s,
          u"iso230-4-partial-arc-zx"_s, u"iso230-4-feedback-yz"_s, u"limits-2006"_s, u"one-direction"_s,
          u"thermal-behaviour"_s, u"budget-2006"_s, u"one-direction-with-gaps"_s}) {
        QTest::newRow(qPrintable(name + u", English"_s)) << Language::Id::english;
        QTest::newRow(qPrintable(name + u", French"_s)) << Language::Id::french;
    }
}

/// On A4; on the shorter paper three pages at most.
void FirstPageTest::certificatesHaveTwoPages() {
    QFETCH(const Language::Id, language);
    Document document = storedDocument(QString::fromUtf8(QTest::currentDataTag()).section(u',', 0, 0));
    const QString end =
        squeezed(language == Language::Id::french ? u"Fin du certificat"_s : u"End of the certificate"_s);
    for (const Paper paper : {Paper::a4, Paper::letter}) {
        document.report.paper = paper;
        const QStringList pages = pageTexts(pdfOf(reportOf(document, language)));
        const auto found =
            std::ranges::find_if(pages, [&](const QString &page) { return squeezed(page).contains(end); });
        const auto count = found - pages.begin() + 1;
        QVERIFY2(count <= (paper == Paper::a4 ? 2 : 3), qPrintable(QString::number(count)));
    }
}

void FirstPageTest::purposesHaveOnePage_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<Language::Id>("language");
    QTest::addColumn<QStringList>("parts"); // from the head to the last
    const auto english = Language::Id::english;
    const auto french = Language::Id::french;
    const QString both = u"x-axis-as-found-as-left"_s;
    QTest::newRow("comparison") << both << english
                                << QStringList{u"Comparison of two tests"_s, u"bi-directional ± U"_s,
                                               u"Statement"_s};
    QTest::newRow("comparison, French")
        << both << french
        << QStringList{u"Comparaison de deux essais"_s, u"bidirectionnel ± U"_s, u"Énoncé"_s};
    const QString thermal = u"thermal-behaviour"_s;
    QTest::newRow("thermal") << thermal << english
                             << QStringList{u"Drift and temperatures"_s, u"Ranges of the record"_s,
                                            u"What the drift explains"_s, u"End of the report"_s};
    QTest::newRow("thermal, French") << thermal << french
                                     << QStringList{u"Dérive et températures"_s, u"Étendues du relevé"_s,
                                                    u"Ce que la dérive explique"_s, u"Fin du rapport"_s};
}

/// On A4.
void FirstPageTest::purposesHaveOnePage() {
    QFETCH(const QString, name);
    QFETCH(const Language::Id, language);
    QFETCH(const QStringList, parts);
    QStringList pages;
    for (const QString &page : pageTexts(pdfOf(reportOf(storedDocument(name), language))))
        pages << squeezed(page);
    const qsizetype head = pageOf(parts.front(), pages);
    QVERIFY(head >= 0);
    for (const QString &part : parts)
        QCOMPARE(pageOf(part, pages, head), head);
}

/// With more head than leaves room for results: the verdict is not carried away with them.
void FirstPageTest::aLongHeadKeepsTheVerdict() {
    for (const Paper paper : {Paper::a4, Paper::letter}) {
        Document document = storedDocument(u"limits-2006"_s);
        document.report.paper = paper;
        document.report.customer.address = "a\nb\nc\nd\ne\nf\ng\nh";
        document.report.supplier.address = document.report.customer.address;
        document.report.customer.name = std::string(300, 'n');
        const Report report = reportOf(document, Language::Id::english);
        const Sought sought = soughtIn(report).front();
        const QStringList pages = pageTexts(pdfOf(report));
        QVERIFY(squeezed(pages[0]).contains(squeezed(sought.verdict)));
        QVERIFY(!squeezed(pages[0]).contains(squeezed(sought.heading)));
        QVERIFY(squeezed(pages[1]).contains(squeezed(sought.heading)));
        for (const QString &row : sought.rows)
            QVERIFY2(squeezed(pages[1]).contains(squeezed(row)), qPrintable(row));
        QVERIFY(!squeezed(pages[1]).contains(squeezed(sought.verdict)));
    }
}

/// Where not even the figure finds room below the head: the page holds verdict and results.
void FirstPageTest::resultsStandBeforeAFigureWithoutRoom() {
    for (const QString &name : {u"iso230-4-full-circles-xy"_s, u"iso230-4-partial-arc-zx"_s}) {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            Document document = storedDocument(name);
            document.report.paper = Paper::letter;
            const auto words = [](int count) {
                std::string text;
                for (int i = 0; i < count; ++i)
                    text += "n ";
                return text;
            };
            document.report.laboratory.name = words(150);
            document.report.title = words(120);
            document.report.customer.name = words(120);
            document.report.supplier.name = document.report.customer.name;
            const Report report = reportOf(document, language);
            const Sought sought = soughtIn(report).front();
            const QByteArray pdf = pdfOf(report);
            const QString first = squeezed(pageTexts(pdf).front());
            QVERIFY(first.contains(squeezed(sought.verdict)));
            QVERIFY(first.contains(squeezed(sought.heading)));
            for (const QString &row : sought.rows)
                QVERIFY2(first.contains(squeezed(row)), qPrintable(row));
            QVERIFY(blankPart(pictures(pdf, dotsPerInch).front()) <= 1.0 / 3);
        }
    }
}

QTEST_MAIN(FirstPageTest)
#include "firstpage.moc"
