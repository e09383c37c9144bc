// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "report/help/help.h"
#include "document/statedthings.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "report/blocks/plaintext.h"

#include <QRegularExpression>
#include <QTest>
#include <algorithm>

using namespace palmer;

class HelpTest : public QObject {
    Q_OBJECT

private slots:
    void everySymbolHasItsFormula_data() {
        QTest::addColumn<Language::Id>("id");
        QTest::newRow("in English") << Language::Id::english;
        QTest::newRow("in French") << Language::Id::french;
    }
    void everySymbolHasItsFormula() {
        QFETCH(Language::Id, id);
        const auto pages = composeHelp(Language(id));
        int tables = 0;
        for (const HelpPage &page : pages) {
            QVERIFY(!page.id.isEmpty() && !page.title.isEmpty() && !page.content.blocks.empty());
            for (const Block &block : page.content.blocks) {
                const auto *table = std::get_if<Table>(&block);
                if (!table)
                    continue;
                ++tables;
                QVERIFY(!table->rows.empty());
                for (const auto &row : table->rows) {
                    QVERIFY2(!row[0].text.plain().isEmpty(), qPrintable(page.id));
                    QVERIFY2(!row[1].text.plain().isEmpty(), qPrintable(page.id));
                    QVERIFY2(row[2].text.plain().contains("="),
                             qPrintable(page.id + " " + row[0].text.plain()));
                    QVERIFY2(!row[2].text.plain().contains('%'), qPrintable(row[2].text.plain()));
                }
            }
        }
        QVERIFY(tables >= 20);
    }

    void everyEditionHasItsPage() {
        const auto pages = composeHelp(Language(Language::Id::english));
        for (const Edition *edition : editions()) {
            const QString id = QString("editions.") + edition->word;
            QVERIFY2(std::ranges::find(pages, id, &HelpPage::id) != pages.end(), edition->word);
        }
    }

    void theFactorIsThatOfTheEdition() {
        const auto pages = composeHelp(Language(Language::Id::english));
        const auto text = [&](const char *edition) {
            return plainText(std::ranges::find(pages, QString("editions.") + edition, &HelpPage::id)->content,
                             400);
        };
        QVERIFY(text("ISO 230-2:1988").contains("+ 3sj"));
        QVERIFY(text("ISO 230-2:2006").contains("+ 2si"));
        QVERIFY(text("ISO 230-2:1988").contains("j counts targets, i runs"));
        QVERIFY(text("ISO 230-2:1988").contains("Σ xij↑"));
        QVERIFY(text("ISO 230-2:2006").contains("i counts targets, j runs"));
        QVERIFY(text("ISO 230-2:2006").contains("2.24")); // clause of A
        QVERIFY(text("ISO 230-4:2005").contains("3.4"));  // clause of G
    }

    /// Whatever a finding may say to be missing is explained at its first field.
    void everyStatementIsExplained() {
        const auto explained = [&](const auto &rows) {
            for (const auto &row : rows) {
                if (row.name.empty())
                    continue;
                const std::string path = row.keys[0];
                const std::string key = path.substr(path.rfind('.') + 1);
                const StatedThing *thing = statedThing(key);
                QVERIFY2(thing && !thing->meaning.empty(), path.c_str());
            }
        };
        for (const Edition *edition : editions()) {
            explained(edition->requirements);
            if (edition->circles)
                explained(edition->circles->requirements);
        }
    }
};

QTEST_APPLESS_MAIN(HelpTest)
#include "helptest.moc"
