// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/evaluation/edition.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <algorithm>

using namespace palmer;

class Editions : public QObject {
    Q_OBJECT

private slots:
    void wordsAreThoseOfTheFile();
    void everyRowHasSymbolNameAndFunction();
    void clausesAreThoseOfTheTable_data();
    void clausesAreThoseOfTheTable();
    void aliasesBelongToTheirFamily();
    void parametersAreKnownById();
    void rowsSayAllOfAParameter();
    void oneOfEachKindIsTheDefault();
    void everyEditionIsAmongThoseOfItsKind();
    void lettersAreThoseOfTheSymbols();
};

void Editions::wordsAreThoseOfTheFile() {
    QStringList words;
    for (const Edition *edition : editions()) {
        words << QString::fromUtf8(edition->word);
        QCOMPARE(findEdition(edition->word), edition);
    }
    const QStringList expected{QStringLiteral("ISO 230-2:1988"),      QStringLiteral("ISO 230-2:1997"),
                               QStringLiteral("ISO 230-2:2006"),      QStringLiteral("ISO 230-2:2014"),
                               QStringLiteral("VDI/DGQ 3441:1977"),   QStringLiteral("GB/T 17421.2-2000"),
                               QStringLiteral("GB/T 17421.2-2016"),   QStringLiteral("GB/T 17421.2-2023"),
                               QStringLiteral("JIS B 6190-2:2008"),   QStringLiteral("JIS B 6190-2:2016"),
                               QStringLiteral("GOST ISO 230-2-2016"), QStringLiteral("ISO 230-4:1996"),
                               QStringLiteral("ISO 230-4:2005"),      QStringLiteral("ISO 230-4:2022")};
    QCOMPARE(words, expected);
    QVERIFY(!findEdition("ISO 230-2:2015"));
}

void Editions::everyRowHasSymbolNameAndFunction() {
    for (const Edition *edition : editions()) {
        QSet<QString> ids;
        for (const Row &row : edition->rows) {
            QVERIFY(*row.term.symbol.base && !row.term.name.empty() && row.value && row.needs);
            QVERIFY2(!ids.contains(QString::fromUtf8(row.term.id)), row.term.id);
            ids << QString::fromUtf8(row.term.id);
        }
        for (const TargetTerm &term : edition->targetTerms)
            QVERIFY(*term.symbol.base && !term.name.empty());
    }
}

void Editions::clausesAreThoseOfTheTable_data() {
    QTest::addColumn<QString>("edition");
    QTest::addColumn<QString>("clauses"); // of A A+ E E+ M R R+ B Bmean r, as far as the edition has them
    QTest::newRow("1988") << QStringLiteral("ISO 230-2:1988")
                          << QStringLiteral("A 2.13;A+ 2.13;R 2.12;R+ 2.12;Bmean 6.3;r 7");
    QTest::newRow("2006") << QStringLiteral("ISO 230-2:2006")
                          << QStringLiteral(
                                 "A 2.24;A+ 2.23;E 2.21;E+ 2.20;M 2.22;R 2.19;R+ 2.18;B 2.13;Bmean 2.14");
    QTest::newRow("2014") << QStringLiteral("ISO 230-2:2014")
                          << QStringLiteral("A 3.27;A+ 3.26;E ;E+ ;M ;R 3.22;R+ 3.21;UPR ;B ;Bmean ");
    for (const char *without :
         {"ISO 230-2:1997", "VDI/DGQ 3441:1977", "GB/T 17421.2-2016", "GOST ISO 230-2-2016"})
        QTest::newRow(without) << QString::fromUtf8(without) << QString();
}

void Editions::clausesAreThoseOfTheTable() {
    QFETCH(QString, edition);
    QFETCH(QString, clauses);
    const Edition *found = findEdition(edition.toStdString());
    QVERIFY(found);
    QStringList rows;
    for (const Row &row : found->rows) {
        const QString id = QString::fromUtf8(row.term.id);
        if (clauses.isEmpty())
            QCOMPARE(row.term.clause, "");
        else if (!id.endsWith(u'-') && !(id.startsWith(u'r') && id.size() > 1))
            rows << id + u' ' + QString::fromUtf8(row.term.clause);
    }
    QCOMPARE(rows.join(u';'), clauses);
    const QRegularExpression known(
        QStringLiteral("^(|1|2\\.\\d+|3\\.\\d+|4\\.[12]|4\\.3\\.[1-4]|5|Foreword \\(7\\))$"));
    for (const Requirement &row : found->requirements)
        QVERIFY2(known.match(QString::fromUtf8(row.clause)).hasMatch(), row.clause);
}

void Editions::aliasesBelongToTheirFamily() {
    for (const auto &[alias, family] : {std::pair{"GB/T 17421.2-2016", "ISO 230-2:2006"},
                                        {"GB/T 17421.2-2000", "ISO 230-2:1997"},
                                        {"GB/T 17421.2-2023", "ISO 230-2:2014"},
                                        {"JIS B 6190-2:2016", "ISO 230-2:2014"},
                                        {"GOST ISO 230-2-2016", "ISO 230-2:2014"},
                                        {"JIS B 6190-2:2008", "ISO 230-2:2006"}}) {
        const Edition *a = findEdition(alias);
        const Edition *f = findEdition(family);
        QCOMPARE(a->family, f->word);
        QCOMPARE(a->c, f->c);
        QCOMPARE(a->rows.size(), f->rows.size());
        for (std::size_t k = 0; k < a->rows.size(); ++k)
            QVERIFY(a->rows[k].value == f->rows[k].value);
    }
}

void Editions::parametersAreKnownById() {
    for (const char *id : {"A", "A+", "E-", "M", "Bmean", "r", "UPR", "P", "Psmean"})
        QVERIFY2(isParameter(Kind::positioning, id), id);
    for (const char *id : {"G", "G(b)", "F", "Fmax", "Fmin", "D", "H", "Gf", "G(b)f"})
        QVERIFY2(isParameter(Kind::circular, id), id);
    QVERIFY(!isParameter(Kind::positioning, "G"));
    QVERIFY(!isParameter(Kind::circular, "A"));
    QVERIFY(isAgreementPoint(Kind::positioning, "measuringReference"));
    QVERIFY(isAgreementPoint(Kind::positioning, "stepCycle"));
    QVERIFY(isAgreementPoint(Kind::circular, "testParameters"));
    QVERIFY(!isAgreementPoint(Kind::circular, "dwell"));
}

void Editions::rowsSayAllOfAParameter() {
    for (const Edition *edition : editions()) {
        const std::vector<const Term *> terms = termsOf(*edition);
        QCOMPARE(terms.empty(), false);
        QSet<QString> families;
        for (const Term *term : terms) {
            const QString family = QString::fromUtf8(term->family);
            QVERIFY2(!family.isEmpty(), term->id);
            // The first of a family is read first, but for the two ends of F.
            const bool isSigned = term->bound != Bound::magnitude;
            QVERIFY2(families.contains(family) || isSigned || term->weight == Weight::main, term->id);
            families << family;
            QCOMPARE(*term->also != 0, isSigned);
            QCOMPARE(term->of == Of::axis, term->circle == OfCircle::nothing);
            QCOMPARE(term->of == Of::axis, edition->kind == Kind::positioning);
            QVERIFY(term->isMeantBy(term->id) && !term->isMeantBy(""));
            QCOMPARE(term->isMeantBy("F"), isSigned);
        }
        for (const TargetTerm &term : edition->targetTerms) {
            QVERIFY2((term.needs & bothWays) != 0, term.id);
            QVERIFY2(*term.largest == 0 || isParameter(Kind::positioning, term.largest), term.id);
        }
    }
}

void Editions::oneOfEachKindIsTheDefault() {
    QCOMPARE(std::string(defaultEdition(Kind::positioning).word), std::string("ISO 230-2:2014"));
    QCOMPARE(std::string(defaultEdition(Kind::circular).word), std::string("ISO 230-4:2005"));
    for (const Kind kind : {Kind::positioning, Kind::circular})
        QCOMPARE(std::ranges::count_if(editions(),
                                       [kind](const Edition *e) { return e->kind == kind && e->isDefault; }),
                 1);
}

void Editions::everyEditionIsAmongThoseOfItsKind() {
    std::vector<const Edition *> all;
    for (const Kind kind : allKinds) {
        for (const Edition *edition : editionsOf(kind)) {
            QCOMPARE(edition->kind, kind);
            all.push_back(edition);
        }
    }
    QVERIFY(std::ranges::equal(all, editions()));
    QCOMPARE(wordsOf(editionsOf(Kind::circular)),
             std::string("ISO 230-4:1996, ISO 230-4:2005, ISO 230-4:2022"));
    QCOMPARE(wordsOf(editionsOf(Kind::circular).first(1)), std::string("ISO 230-4:1996"));
    QCOMPARE(wordsOf({}), std::string());
}

void Editions::lettersAreThoseOfTheSymbols() {
    for (const Edition *edition : editions()) {
        const bool is1988 = edition->family == QByteArray("ISO 230-2:1988");
        QCOMPARE(QByteArray(edition->targetLetter), QByteArray(is1988 ? "j" : "i"));
        QCOMPARE(QByteArray(edition->runLetter), QByteArray(is1988 ? "i" : "j"));
        for (const TargetTerm &term : edition->targetTerms)
            QCOMPARE(QByteArray(term.symbol.subscript), QByteArray(edition->targetLetter));
    }
}

QTEST_GUILESS_MAIN(Editions)
#include "editions.moc"
