// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/arcs.h"
#include "import/layouts/conditioncolumns.h"
#include "import/layouts/positioningcolumns.h"

#include "document/place.h"
#include "import/layouts/sections.h"
#include "import/notelabels.h"
#include "tables/contenterror.h"
#include "tables/dates.h"

#include <QRegularExpression>
#include <QString>
#include <algorithm>

// Several tests in a table of circles: one is read, the others are asked about.

namespace palmer {

namespace {

class OneTest {
public:
    OneTest(TableReading &reading, CircleColumns &columns)
        : m(reading)
        , m_columns(columns) {}

    void keep() {
        keepLinesOfOneTest();
        keepColumnsOfOneTest();
        keepOneState();
    }

private:
    /// Leaves the lines of other planes, feeds, machines out, asked.
    void keepLinesOfOneTest() {
        takeConditions(m, m.result.columns, true, m_columns);
        if (m_columns.isOfOtherTest.empty())
            return;
        for (TableBlock &block : m.body.blocks)
            std::erase_if(block.rows, [&](std::uint32_t row) { return m_columns.isOfOtherTest[row]; });
        std::erase_if(m.body.blocks, [](const TableBlock &block) { return block.rows.empty(); });
    }

    /// Facts that the headings of all paths of one test share.
    struct PathFacts {
        std::string plane; ///< "XY"
        std::string feed;  ///< of "F500", "2000 mm/min"
        std::string day;   ///< as written

        [[nodiscard]] std::string text() const {
            std::string all = plane;
            for (const std::string &fact : {feed, day})
                all += (all.empty() || fact.empty() ? "" : ", ") + fact;
            return all;
        }
    };

    [[nodiscard]] PathFacts factsOf(std::size_t column) const {
        static const QRegularExpression plane(QStringLiteral(R"(\b([XYZ]{2}|G1[789])\b)"),
                                              QRegularExpression::CaseInsensitiveOption);
        static const QRegularExpression feed(QStringLiteral(R"(\bF\s?=?\s?(\d{2,})\b|(\d+)\s*mm/min)"),
                                             QRegularExpression::CaseInsensitiveOption);
        static const QRegularExpression day(
            QStringLiteral(R"(\d{4}-\d{1,2}-\d{1,2}|\d{1,2}[./]\d{1,2}[./]\d{2,4})"));
        const QString heading = QString::fromStdString(m.body.columns[column].heading);
        const auto ofFeed = feed.match(heading);
        return {planeIn(plane.match(heading).captured(1).toStdString()),
                (ofFeed.captured(1) + ofFeed.captured(2)).toStdString(),
                day.match(heading).captured().toStdString()};
    }

    void removePath(std::size_t k) {
        const auto at = static_cast<std::ptrdiff_t>(k);
        m.result.columns[m_columns.seconds[k]].role = ColumnRole::ignored;
        m_columns.conditions.push_back(m_columns.seconds[k]);
        m_columns.seconds.erase(m_columns.seconds.begin() + at);
        if (m_columns.firsts.empty())
            return;
        m_columns.firsts.erase(m_columns.firsts.begin() + at);
        m_columns.first = m_columns.firsts.empty() ? std::nullopt : std::optional(m_columns.firsts.front());
    }

    /// Keeps the paths of one test, asked, where the headings name several: "CCW F500; CCW F2000", "XY; YZ".
    void keepColumnsOfOneTest() {
        std::vector<std::string> tests;
        std::string list;
        for (const std::size_t c : m_columns.seconds) {
            std::string test = factsOf(c).text();
            if (test.empty())
                return;
            if (std::ranges::find(tests, test) != tests.end())
                continue;
            list += (list.empty() ? "" : "; ") + test;
            tests.push_back(std::move(test));
        }
        std::string read = tests.front();
        if (tests.size() > 1) {
            read = m.choices.resolve("part", read, Origin::guessed).value;
            if (std::ranges::find(tests, read) == tests.end())
                refuseContent(REPORT_TEXT("report", "%1 cannot be %2; known: %3"), nameOfChoice("part"), read,
                              list);
            m.remarks
                .problem("part",
                         REPORT_TEXT("report", "Columns: the headings name several tests (%1); those of “%2” "
                                               "are read, the others are tests of their own."),
                         list, read)
                .answers = tests;
        }
        for (std::size_t k = m_columns.seconds.size(); k-- > 0;) {
            if (factsOf(m_columns.seconds[k]).text() != read)
                removePath(k);
        }
        const PathFacts facts = factsOf(m_columns.seconds.front());
        if (m.notes.plane.empty())
            m.notes.plane = facts.plane;
        if (!m.notes.feed)
            m.notes.feed = numberIn(facts.feed);
        if (!m.notes.date && m.notes.dateText.empty() && !facts.day.empty()) {
            m.notes.date = isoDate(facts.day);
            m.notes.dateText = m.notes.date ? std::string() : facts.day;
        }
    }

    /// The heading or title that names a state.
    [[nodiscard]] std::string wordsOfState() const {
        for (const std::size_t c : m_columns.seconds) {
            if (m.body.columns[c].words.state != TestRole::notStated)
                return m.body.columns[c].heading;
        }
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t head : m.titlesOf(block)) {
                if (readTitle(m.textOf(head)).state != TestRole::notStated)
                    return m.textOf(head);
            }
        }
        return {};
    }

    /// Keeps the paths as found, or as left, asked where there are both.
    void keepOneState() {
        const auto ofColumn = [&](std::size_t c) { return m.body.columns[c].words.state; };
        const auto ofBlock = [&](const TableBlock &block) { return m.stateOf(block); };
        const auto has = [&](TestRole state) {
            return std::ranges::find(m_columns.seconds, state, ofColumn) != m_columns.seconds.end() ||
                   std::ranges::find(m.body.blocks, state, ofBlock) != m.body.blocks.end();
        };
        const bool found = has(TestRole::asFound);
        const bool left = has(TestRole::asLeft);
        if (found != left)
            m.stateFound = statedState(m, found ? TestRole::asFound : TestRole::asLeft, wordsOfState());
        if (!found || !left)
            return;
        m.stateFound = resolveState(m);
        for (std::size_t k = m_columns.seconds.size(); k-- > 0;) {
            const TestRole state = ofColumn(m_columns.seconds[k]);
            if (state != TestRole::notStated && state != m.stateFound)
                removePath(k);
        }
        TestRole last = TestRole::notStated; // holds until another is named
        std::erase_if(m.body.blocks, [&](const TableBlock &block) {
            last = ofBlock(block) == TestRole::notStated ? last : ofBlock(block);
            return last != TestRole::notStated && last != m.stateFound;
        });
    }

    TableReading &m;
    CircleColumns &m_columns;
};

} // namespace

void keepOneTest(TableReading &reading, CircleColumns &columns) {
    OneTest(reading, columns).keep();
}

} // namespace palmer
