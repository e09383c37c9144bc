// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernel/diagnosis/sourcewords.h"

#include <QTest>

#include <functional>

using namespace palmer;

namespace {

/// Two senses at a stated feed, and what was found there: nothing.
struct Setup {
    std::vector<DiagnosedCircle> circles;
    DiagnosisOptions options;
    Diagnosis diagnosis;

    Setup() { addCircle(1000.0 / 60); }

    void addCircle(std::optional<double> feed) {
        DiagnosedCircle circle;
        circle.feed = feed;
        circle.arcs.resize(2);
        circle.arcs[1].sense = Sense::clockwise;
        circles.push_back(circle);
    }
    SourceEstimate &addSource(InfluenceId id, PlaneAxis axis, double value, double u) {
        SourceEstimate source;
        source.id = id;
        source.axis = axis;
        source.value = value;
        source.u = u;
        return diagnosis.sources.emplace_back(source);
    }
    void addPlay(double first, double second, double u = 0.001) {
        addSource(InfluenceId::lateralPlay, PlaneAxis::first, first, u);
        addSource(InfluenceId::lateralPlay, PlaneAxis::second, second, u);
    }
    void addDrift(std::optional<double> step) {
        addSource(InfluenceId::radiusDrift, PlaneAxis::none, 0.001, 0.0001).step = step;
    }
};

using Change = std::function<void(Setup &)>;

} // namespace

Q_DECLARE_METATYPE(Change)

class RemarksTest : public QObject {
    Q_OBJECT

private slots:
    void remarks_data() {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QByteArray>("expected"); // how the remarks begin
        const auto row = [](const char *name, Change change, const char *expected) {
            QTest::newRow(name) << std::move(change) << QByteArray(expected);
        };
        row(
            "nothing to say", [](Setup &) {}, "");
        row(
            "one sense", [](Setup &s) { s.circles[0].arcs[1].sense = Sense::counterclockwise; },
            "One sense only");
        row(
            "one arc", [](Setup &s) { s.circles[0].arcs.resize(1); }, "One sense only");
        row(
            "feedback", [](Setup &s) { s.circles[0].feedback = true; }, "Feedback signal");
        row(
            "no feed", [](Setup &s) { s.circles[0].feed.reset(); }, "The contouring feed is not stated");
        row(
            "lag", [](Setup &s) { s.diagnosis.lagAngle = -0.4; }, "The path lies %1");
        row(
            "drift with a step", [](Setup &s) { s.addDrift(0.002); }, "The pause between the arcs");
        row(
            "drift without a step", [](Setup &s) { s.addDrift({}); }, "");
        row(
            "the pause is known",
            [](Setup &s) {
                s.addDrift(0.002);
                s.options.pause = 0;
            },
            "");
        const char *const step = "Lateral play of both axes";
        row(
            "opposite and alike", [](Setup &s) { s.addPlay(0.010, -0.010); }, step);
        row(
            "alike within 20 %", [](Setup &s) { s.addPlay(-0.010, 0.0119); }, step);
        row(
            "not alike", [](Setup &s) { s.addPlay(-0.010, 0.0121); }, "");
        row(
            "nor smaller", [](Setup &s) { s.addPlay(0.010, -0.0079); }, "");
        row(
            "not opposite", [](Setup &s) { s.addPlay(0.010, 0.010); }, "");
        row(
            "just known", [](Setup &s) { s.addPlay(0.010, -0.010, 0.0019); }, step);
        row(
            "not known", [](Setup &s) { s.addPlay(0.010, -0.010, 0.0021); }, "");
        row(
            "one of them not known",
            [](Setup &s) {
                s.addPlay(0.010, -0.010);
                s.diagnosis.sources[1].value.reset();
            },
            "");
        row(
            "one axis alone",
            [](Setup &s) { s.addSource(InfluenceId::lateralPlay, PlaneAxis::first, 0.01, 0); }, "");
        row(
            "the step is a part of the drift",
            [](Setup &s) {
                s.addPlay(0.010, -0.010);
                s.addDrift(0.002);
                s.options.pause = 1;
            },
            "");
        row(
            "a drift without step explains nothing",
            [](Setup &s) {
                s.addPlay(0.010, -0.010);
                s.addDrift({});
            },
            step);
        row(
            "two circles, two feeds", [](Setup &s) { s.addCircle(2000.0 / 60); }, "Two feeds:");
        row(
            "three circles, two feeds",
            [](Setup &s) {
                s.addCircle(2000.0 / 60);
                s.addCircle(1000.0 / 60 + 1e-5); // the same to 0.001 mm/s
            },
            "Two feeds:");
        row(
            "three feeds",
            [](Setup &s) {
                s.addCircle(2000.0 / 60);
                s.addCircle(3000.0 / 60);
            },
            "");
        row(
            "all at once",
            [](Setup &s) {
                s.circles[0].feedback = true;
                s.circles[0].feed.reset();
                s.diagnosis.lagAngle = 1;
            },
            "Feedback signal|The contouring feed is not stated|The path lies %1");
    }

    void remarks() {
        QFETCH(Change, change);
        QFETCH(QByteArray, expected);
        Setup setup;
        change(setup);
        const QByteArrayList beginnings = expected.isEmpty() ? QByteArrayList() : expected.split('|');
        const auto found = diagnosisRemarks(setup.circles, setup.options, setup.diagnosis);
        QCOMPARE(static_cast<qsizetype>(found.size()), beginnings.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            QVERIFY2(QByteArray(found[k].text.source).startsWith(beginnings[qsizetype(k)]),
                     found[k].text.source);
    }
};

QTEST_GUILESS_MAIN(RemarksTest)
#include "remarks.moc"
