// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/documentmodel.h"
#include "document/savedocument.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

using namespace palmer;
using palmer::ui::DocumentModel;

namespace {

Document example() {
    return openDocument(QStringLiteral(":/examples/rotary-axis.palmer"));
}

void rename(DocumentModel &model, const char *name, const QString &mergeKey = {}) {
    model.edit(
        "name the machine", [name](Document &document) { document.machine.name = name; }, mergeKey);
}

/// 200 targets, 200 runs: steps of a reading hold that reading alone.
Document largeDocument() {
    Document document = example();
    auto test = std::make_shared<Test>(*document.tests[0]);
    auto &measurement = std::get<PositioningMeasurement>(test->measurement);
    measurement.targets.clear();
    measurement.runs.clear();
    for (int i = 0; i < 200; ++i) {
        measurement.targets.push_back(i);
        measurement.runs.push_back({i % 2 == 0 ? Direction::positive : Direction::negative,
                                    std::vector<std::optional<double>>(200, 0.001 * i)});
    }
    document.tests[0] = std::move(test);
    return document;
}

void setReading(DocumentModel &model, std::size_t run, std::size_t target, std::optional<double> value,
                const QString &mergeKey = {}) {
    model.edit(
        "type a reading",
        [=](Document &document) {
            auto test = std::make_shared<Test>(*document.tests[0]);
            std::get<PositioningMeasurement>(test->measurement).runs[run].deviations[target] = value;
            document.tests[0] = std::move(test);
        },
        mergeKey);
}

} // namespace

class DocumentModelTest : public QObject {
    Q_OBJECT

private slots:
    void editsThroughOneDoor();
    void dropsChangesThatChangeNothing();
    void mergesStepsOfOneKey();
    void dropsMergedStepsThatComeBack();
    void doesNotMergeAcrossSaving();
    void sharesUnchangedTests();
    void forgetsStepsOfTheFormerDocument();
    void staysAsItIsWhenSavingFails();
    void goesBackAndForthThroughALargeTest();
    void mergesStepsOfALargeTest();
    void forgetsTheFirstOfManyLargeSteps();
};

void DocumentModelTest::editsThroughOneDoor() {
    DocumentModel model;
    model.setDocument(example(), {});
    const ui::DocumentPointer before = model.document();
    QSignalSpy changed(&model, &DocumentModel::changed);
    rename(model, "lathe");
    QCOMPARE(changed.count(), 1);
    QCOMPARE(model.document()->machine.name, std::string("lathe"));
    QCOMPARE(model.undoStack()->undoText(), QStringLiteral("name the machine"));
    QVERIFY(model.isModified());
    model.undoStack()->undo();
    QVERIFY(*model.document() == *before);
    QVERIFY(!model.isModified());
    model.undoStack()->redo();
    QCOMPARE(model.document()->machine.name, std::string("lathe"));
    QCOMPARE(changed.count(), 3);
}

void DocumentModelTest::dropsChangesThatChangeNothing() {
    DocumentModel model;
    model.setDocument(example(), {});
    const std::string name = model.document()->machine.name;
    QSignalSpy changed(&model, &DocumentModel::changed);
    rename(model, name.c_str());
    QCOMPARE(changed.count(), 0);
    QCOMPARE(model.undoStack()->count(), 0);
}

void DocumentModelTest::mergesStepsOfOneKey() {
    DocumentModel model;
    model.setDocument(example(), {});
    const std::string before = model.document()->machine.name;
    rename(model, "l", QStringLiteral("machine.name"));
    rename(model, "la", QStringLiteral("machine.name"));
    rename(model, "lathe", QStringLiteral("machine.name"));
    QCOMPARE(model.undoStack()->count(), 1);
    rename(model, "mill", QStringLiteral("another field"));
    QCOMPARE(model.undoStack()->count(), 2);
    rename(model, "drill");
    rename(model, "press");
    QCOMPARE(model.undoStack()->count(), 4);
    for (int i = 0; i < 4; ++i)
        model.undoStack()->undo();
    QCOMPARE(model.document()->machine.name, before);
}

void DocumentModelTest::dropsMergedStepsThatComeBack() {
    DocumentModel model;
    model.setDocument(example(), {});
    const std::string before = model.document()->machine.name;
    rename(model, "lathe", QStringLiteral("machine.name"));
    rename(model, before.c_str(), QStringLiteral("machine.name"));
    QCOMPARE(model.undoStack()->count(), 0);
    QCOMPARE(model.document()->machine.name, before);
}

void DocumentModelTest::doesNotMergeAcrossSaving() {
    const QTemporaryDir folder;
    DocumentModel model;
    model.setDocument(example(), {});
    rename(model, "l", QStringLiteral("machine.name"));
    model.save(folder.filePath(QStringLiteral("saved.palmer")));
    QVERIFY(!model.isModified());
    rename(model, "lathe", QStringLiteral("machine.name"));
    QVERIFY(model.isModified());
    model.undoStack()->undo();
    QVERIFY(!model.isModified());
    QVERIFY(*model.document() == openDocument(model.path()));
}

void DocumentModelTest::sharesUnchangedTests() {
    DocumentModel model;
    model.setDocument(openDocument(QStringLiteral(":/examples/long-axis-with-zone.palmer")), {});
    const auto before = model.document();
    model.edit("title", [](Document &document) {
        auto test = std::make_shared<Test>(*document.tests[0]);
        test->title = "another";
        document.tests[0] = test;
    });
    QVERIFY(model.document()->tests[0] != before->tests[0]);
    QVERIFY(model.document()->tests[1] == before->tests[1]);
}

void DocumentModelTest::forgetsStepsOfTheFormerDocument() {
    DocumentModel model;
    model.setDocument(example(), {});
    rename(model, "lathe");
    model.setDocument(example(), {});
    QVERIFY(!model.undoStack()->canUndo());
    QVERIFY(!model.isModified());
}

void DocumentModelTest::staysAsItIsWhenSavingFails() {
    const QTemporaryDir folder;
    DocumentModel model;
    model.setDocument(example(), {});
    rename(model, "lathe");
    QSignalSpy file(&model, &DocumentModel::fileChanged);
    QVERIFY_EXCEPTION_THROWN(model.save(folder.filePath(QStringLiteral("missing/file.palmer"))), Error);
    QVERIFY(model.isModified());
    QVERIFY(model.path().isEmpty());
    QCOMPARE(file.count(), 0);
}

/// Readings, other fields and many readings in turn: each step back and forth gives the document it had.
void DocumentModelTest::goesBackAndForthThroughALargeTest() {
    DocumentModel model;
    model.setDocument(largeDocument(), {});
    std::vector<Document> states{*model.document()};
    for (std::size_t step = 0; step < 40; ++step) {
        if (step % 5 == 3)
            rename(model, std::to_string(step).c_str(), QStringLiteral("name"));
        else if (step % 7 == 4)
            model.edit("clear a run", [step](Document &document) {
                auto test = std::make_shared<Test>(*document.tests[0]);
                auto &run = std::get<PositioningMeasurement>(test->measurement).runs[step];
                run.deviations.assign(run.deviations.size(), std::nullopt);
                document.tests[0] = std::move(test);
            });
        else
            setReading(model, step, 3 * step, step % 4 == 0 ? std::nullopt : std::optional(0.5),
                       QStringLiteral("typed %1").arg(step));
        states.push_back(*model.document());
        QVERIFY(states.back() != states[states.size() - 2]);
    }
    QCOMPARE(model.undoStack()->count(), 40);
    for (std::size_t step = 40; step-- > 0;) {
        model.undoStack()->undo();
        QVERIFY(*model.document() == states[step]);
    }
    QVERIFY(!model.isModified());
    for (std::size_t step = 1; step <= 40; ++step) {
        model.undoStack()->redo();
        QVERIFY(*model.document() == states[step]);
    }
    model.undoStack()->setIndex(17);
    QVERIFY(*model.document() == states[17]);
    setReading(model, 0, 0, 7.0);
    model.undoStack()->undo();
    QVERIFY(*model.document() == states[17]);
}

void DocumentModelTest::mergesStepsOfALargeTest() {
    DocumentModel model;
    model.setDocument(largeDocument(), {});
    const Document before = *model.document();
    for (const double value : {1.0, 2.0, 3.0})
        setReading(model, 3, 4, value, QStringLiteral("typed"));
    QCOMPARE(model.undoStack()->count(), 1);
    const Document after = *model.document();
    model.undoStack()->undo();
    QVERIFY(*model.document() == before);
    model.undoStack()->redo();
    QVERIFY(*model.document() == after);
    setReading(model, 3, 4, 0.003, QStringLiteral("typed")); // as it was
    QCOMPARE(model.undoStack()->count(), 0);
    QVERIFY(*model.document() == before);
}

/// Steps that leave no reading as it was are kept as long as all together are bounded.
void DocumentModelTest::forgetsTheFirstOfManyLargeSteps() {
    DocumentModel model;
    model.setDocument(largeDocument(), {});
    std::vector<Document> states{*model.document()};
    const auto shift = [&](int step) {
        model.edit("shift", [step](Document &document) {
            auto test = std::make_shared<Test>(*document.tests[0]);
            for (auto &run : std::get<PositioningMeasurement>(test->measurement).runs)
                run.deviations.assign(100'000, 1.0 + step); // 2 × 10⁷ readings
            std::get<PositioningMeasurement>(test->measurement).targets.assign(100'000, 0);
            document.tests[0] = std::move(test);
        });
    };
    rename(model, "first");
    shift(0);
    shift(1);
    shift(2);
    rename(model, "second");
    QVERIFY(model.undoStack()->count() < 5);
    QVERIFY(model.isModified());
    QVERIFY(model.undoStack()->canUndo() && !model.undoStack()->canRedo());
    QCOMPARE(model.undoStack()->undoText(), QStringLiteral("name the machine"));
    const Document last = *model.document();
    while (model.undoStack()->canUndo())
        model.undoStack()->undo();
    QVERIFY(model.isModified()); // the saved state cannot be reached any more
    while (model.undoStack()->canRedo())
        model.undoStack()->redo();
    QVERIFY(*model.document() == last);
}

QTEST_GUILESS_MAIN(DocumentModelTest)
#include "documentmodeltest.moc"
