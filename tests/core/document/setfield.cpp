// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/setfield.h"

#include "document/documenterror.h"

#include <QTest>

using namespace palmer;

namespace {

Document ofEachKind() {
    Document document;
    const auto add = [&](auto measurement, const char *edition) {
        Test test;
        test.id = "t" + std::to_string(document.tests.size());
        test.edition = edition;
        test.measurement = std::move(measurement);
        document.tests.push_back(std::make_shared<const Test>(std::move(test)));
    };
    PositioningMeasurement axis;
    axis.axis.name = "X";
    axis.targets = {0, 100};
    add(axis, "ISO 230-2:2014");
    CircularMeasurement circle;
    circle.plane = {"X", "Y"};
    circle.nominalRadius = 100;
    add(circle, "ISO 230-4:2005");
    return document;
}

} // namespace

/// Fields by their paths.
class SetFieldTest : public QObject {
    Q_OBJECT

private slots:
    void keysOfEveryKindAreKnown() {
        for (const char *path : {"machine.name", "tests[0].title", "report", "limits.A.value", "targets[0]",
                                 "nominalRadius", "plane", "axis.name", "role", "instruments[1].id", "times"})
            QVERIFY2(beginsAsField(path), path);
        for (const char *path : {"", "A", "machin", "machines.name", "[0]", ".name", "delimiter"})
            QVERIFY2(!beginsAsField(path), path);
    }

    void aPathOfTheFileIsThatOfOne() {
        const Document changed = withField(ofEachKind(), "machine.serialNumber", "0815");
        QCOMPARE(changed.machine.serialNumber, std::string("0815")); // no number
        QCOMPARE(changed.tests.size(), std::size_t(2));
        const Document second = withField(ofEachKind(), "tests[1].title", "b");
        QCOMPARE(second.tests[0]->title, std::string());
        QCOMPARE(second.tests[1]->title, std::string("b"));
    }

    void anyOtherIsThatOfEveryTest() {
        const Document changed = withField(ofEachKind(), "date", "2026-01-02");
        for (const TestPointer &test : changed.tests)
            QCOMPARE(test->date, std::optional<std::string>("2026-01-02"));
    }

    void aNumberMayHaveAComma() {
        for (const char *value : {"0.02", "0,02", "2e-2"}) {
            const Document changed = withField(ofEachKind(), "tests[0].limits.A.value", value);
            QCOMPARE(changed.tests[0]->limits.at("A").value, std::optional(0.02));
        }
    }

    void anElementBehindTheLastIsAdded() {
        const Document changed = withField(ofEachKind(), "instruments[0].id", "laser");
        QCOMPARE(changed.instruments.size(), std::size_t(1));
        QCOMPARE(changed.instruments[0].id, std::string("laser"));
        QVERIFY(throws("instruments[2].id", "laser"));
    }

    void whatTheFileDoesNotKnowIsRefused() {
        QVERIFY(throws("machine.year", "old"));
        QVERIFY(throws("tests[0].nominalRadius", "100")); // of a circle alone
        QVERIFY(throws("machine.name.first", "a"));
        QVERIFY(throws("report.paper", "A5"));
    }

private:
    static bool throws(const char *path, const char *value) {
        try {
            (void)withField(ofEachKind(), path, value);
        } catch (const Error &) {
            return true;
        }
        return false;
    }
};

QTEST_GUILESS_MAIN(SetFieldTest)
#include "setfield.moc"
