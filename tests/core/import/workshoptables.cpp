#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/importpicture.h"
#include "core/import/workshoptable.h"
#include "import/importmeasurement.h"

#include <QTest>

#include <cmath>

using namespace palmer;

namespace {

bool sameRun(const Run &run, const std::vector<double> &micrometres) {
    if (run.deviations.size() != micrometres.size())
        return false;
    for (std::size_t i = 0; i < micrometres.size(); ++i) {
        // What the decimals of the file say, to the last bits.
        if (!run.deviations[i] || std::abs(*run.deviations[i] - micrometres[i] / 1000) > 1e-12)
            return false;
    }
    return true;
}

bool isRight(const Imported &imported, const testdata::WorkshopTable &table) {
    const auto *read =
        imported.test ? std::get_if<PositioningMeasurement>(&imported.test->measurement) : nullptr;
    if (!read || read->targets != table.targets ||
        read->runs.size() != table.positive.size() + table.negative.size())
        return false;
    std::size_t up = 0;
    std::size_t down = 0;
    for (const Run &run : read->runs) {
        const bool positive = run.approach == Direction::positive;
        const auto &side = positive ? table.positive : table.negative;
        std::size_t &next = positive ? up : down;
        if (next >= side.size() || !sameRun(run, side[next++]))
            return false;
    }
    return true;
}

} // namespace

/// Random tables with known truth: nearly all are read right, and none wrong without a question.
class WorkshopTablesTest : public QObject {
    Q_OBJECT

private slots:
    void areReadRightOrAsked() {
        constexpr int tables = 600;
        constexpr int mostWrong = tables * 5 / 100;
        std::mt19937 random(20240312);
        int wrong = 0;
        int silent = 0;
        for (int i = 0; i < tables; ++i) {
            const testdata::WorkshopTable table = testdata::workshopTable(random);
            QString outcome;
            bool asked = true; // a refusal is said
            try {
                const Imported imported = importMeasurement(table.bytes, "x.csv");
                if (isRight(imported, table))
                    continue;
                asked = std::ranges::any_of(imported.questions, isAboutThisFile);
                outcome = testdata::picture(imported) + '\n' + testdata::questions(imported);
            } catch (const Error &error) {
                outcome = Language(Language::Id::english).sentence(error.message);
            }
            ++wrong;
            silent += asked ? 0 : 1;
            qInfo("%d %s\n%s\n%s", i, qPrintable(table.description), qPrintable(table.text.left(600)),
                  qPrintable(outcome));
        }
        qInfo("%d of %d tables wrong, %d of them silently", wrong, tables, silent);
        QCOMPARE(silent, 0);
        QVERIFY(wrong <= mostWrong);
    }

private:
    /// Sign and correction to 20 °C are asked of every file: they say nothing about a doubt.
    static bool isAboutThisFile(const Question &question) {
        return question.id != "sign" && question.id != "correctionTo20";
    }
};

QTEST_GUILESS_MAIN(WorkshopTablesTest)
#include "workshoptables.moc"
