// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/streams.h"
#include "document/savedocument.h"
#include "document/writedocument.h"
#include "export/diagnosisjson.h"
#include "kernel/diagnosis/synthesize.h"
#include "kernel/evaluation/edition.h"
#include "kernel/measurement/plane.h"
#include "kernel/measurement/testfacts.h"
#include "system/files.h"

#include <QFileInfo>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palmer {

namespace {

constexpr const char *truthOption = "truth";

constexpr std::array synthesizeOptions{
    Option{"source", "ID[:AXIS]=VALUE[@SHAPE]",
           REPORT_TEXT("report", "an influence, in the units of the diagnosis (µm, µm/m, µrad, ms); after @ "
                                 "the pitch of cyclic in mm (10), the width of reversalSpike in degrees "
                                 "(1.5), the expansion of temperature in µm/(m·°C) (11.7), the frequency of "
                                 "vibration in Hz (10). drift: response:X=µm/°C@min (40), straight:X=µm/h, "
                                 "temperature=°C@h, the swing of the air and its period (12)"),
           true},
    Option{"plane", "XY", REPORT_TEXT("report", "circular: the plane, first and second axis"), false,
           "circular"},
    Option{"radius", "150", REPORT_TEXT("report", "circular: nominal radius, mm"), false, "circular"},
    Option{"feed", "1000",
           REPORT_TEXT("report", "circular: contouring feed, mm/min; several times: a test each"), true,
           "circular"},
    Option{"points", "1800", REPORT_TEXT("report", "circular: points in each sense"), false, "circular"},
    Option{"senses", "both|counterclockwise|clockwise", REPORT_TEXT("report", "circular: what is measured"),
           false, "circular"},
    Option{"arc", "FROM:TO", REPORT_TEXT("report", "circular: the arc, degrees; without it 0:360"), false,
           "circular"},
    Option{"pause", "0", REPORT_TEXT("report", "circular: pause between the senses, in turns"), false,
           "source"},
    Option{"axis", "X", REPORT_TEXT("report", "positioning: name of the axis"), false, "positioning"},
    Option{"travel", "1000", REPORT_TEXT("report", "positioning: from the first target to the last, mm"),
           false, "positioning"},
    Option{"targets", "11", REPORT_TEXT("report", "positioning: number of targets"), false, "positioning"},
    Option{"runs", "5", REPORT_TEXT("report", "positioning: runs each way"), false, "positioning"},
    Option{"hours", "8", REPORT_TEXT("report", "drift: length of the record, h"), false, "drift"},
    Option{"step", "60", REPORT_TEXT("report", "drift: time between two values, s"), false, "drift"},
    Option{"noise", "0.1", REPORT_TEXT("report", "standard deviation of the noise, µm; without it 0")},
    Option{"correlation", "0", REPORT_TEXT("report", "of neighbouring readings, 0 to below 1"), false,
           "noise"},
    Option{"resolution", "0", REPORT_TEXT("report", "step of the readings, µm; 0: none"), false,
           "source|noise"},
    Option{"seed", "N",
           REPORT_TEXT("report", "start of the random numbers: the same gives the same measurement"), false,
           "noise"},
    Option{truthOption, "OUT.json", REPORT_TEXT("report", "writes there what the measurement was made from")},
    Option{"o", "OUT.palmer", REPORT_TEXT("report", "the test file to write")},
    forceOption,
};

/// The value of an option within bounds.
double number(const Invocation &invocation, const char *option, double otherwise, double least, double most) {
    const auto given = invocation.value(option);
    if (!given)
        return otherwise;
    return numberBetween(option, *given, least, most);
}

std::size_t count(const Invocation &invocation, const char *option, std::size_t otherwise, long long most) {
    const auto given = invocation.value(option);
    return given ? static_cast<std::size_t>(wholeBetween(option, *given, 1, most)) : otherwise;
}

constexpr double smallest = 1e-3;
constexpr double largest = 1e6;
constexpr double micrometres = 1000; ///< per millimetre

SynthesizedNoise noise(const Invocation &invocation) {
    SynthesizedNoise result;
    constexpr double most = 1e4;
    result.deviation = number(invocation, "noise", 0, 0, most) / micrometres;
    result.correlation = number(invocation, "correlation", 0, 0, 0.9999);
    result.resolution = number(invocation, "resolution", 0, 0, most) / micrometres;
    result.seed = seedOf(invocation).value_or(result.seed);
    return result;
}

/// A source of deviation of a positioning test, with its word for --source.
struct PositioningKey {
    const char *id = nullptr;
    double PositioningSynthesis::*value = nullptr;
    double base = 0; ///< base units per unit of the option
    double zero = 0; ///< offset
};
constexpr std::array positioningKeys{
    PositioningKey{"scale", &PositioningSynthesis::scale, 1e-6, 0},
    PositioningKey{"cyclic", &PositioningSynthesis::cyclic, 1e-3, 0},
    PositioningKey{"backlash", &PositioningSynthesis::backlash, 1e-3, 0},
    PositioningKey{"reversal", &PositioningSynthesis::reversal, 1e-3, 0},
    PositioningKey{"drift", &PositioningSynthesis::drift, 1e-3, 0},
    PositioningKey{"temperature", &PositioningSynthesis::temperature, 1, 20}};

constexpr const char *circularWord = "circular";
constexpr const char *driftWord = "drift";
constexpr const char *vibrationWord = "vibration"; // no influence: no diagnosis finds it

[[noreturn]] void refuseSource(const Invocation &invocation, const QString &given) {
    std::string ids;
    const auto add = [&ids](const char *id) { ids += (ids.empty() ? "" : ", ") + std::string(id); };
    if (invocation.arguments.front() == QLatin1StringView(driftWord)) {
        for (const char *id : {"response", "straight", "temperature"})
            add(id);
    } else if (invocation.arguments.front() == QLatin1StringView(circularWord)) {
        for (const Influence &influence : influences())
            add(influence.word);
        add(vibrationWord);
    } else {
        for (const PositioningKey &key : positioningKeys)
            add(key.id);
    }
    refuse("source", given, "ID[:AXIS]=VALUE[@SHAPE]; ID: " + ids);
}

/// The parts of "backlash:X=6@10".
struct GivenSource {
    QString whole;
    QString id;
    QString axis;
    double value = 0;
    std::optional<double> shape;
};

std::vector<GivenSource> givenSources(const Invocation &invocation) {
    std::vector<GivenSource> result;
    for (const QString &whole : invocation.values("source")) {
        const qsizetype equals = whole.indexOf(u'=');
        if (equals < 0)
            refuseSource(invocation, whole);
        GivenSource source;
        source.whole = whole;
        const QStringList name = whole.left(equals).split(u':');
        const QStringList value = whole.mid(equals + 1).split(u'@');
        if (name.size() > 2 || value.size() > 2)
            refuseSource(invocation, whole);
        source.id = name[0];
        source.axis = name.value(1);
        source.value = numberGiven("source", value[0]);
        if (value.size() > 1) {
            source.shape = numberGiven("source", value[1]);
            if (!(*source.shape > 0))
                refuseSource(invocation, whole);
        }
        result.push_back(source);
    }
    return result;
}

std::vector<double> feeds(const Invocation &invocation) {
    std::vector<double> result;
    const QStringList all = invocation.values("feed");
    for (const QString &given : all.isEmpty() ? QStringList(QStringLiteral("1000")) : all) {
        result.push_back(numberBetween("feed", given, smallest, largest));
    }
    return result;
}

Plane plane(const Invocation &invocation) {
    const QString given = invocation.value("plane").value_or(QStringLiteral("XY"));
    const std::optional<Plane> named = planeOf(given.toStdString());
    if (!named)
        refuse("plane", given, "XY");
    return *named;
}

CircularSource circularSource(const GivenSource &given, const Plane &plane, const Invocation &invocation) {
    const Influence *row = findInfluence(given.id.toUtf8().constData());
    if (!row)
        refuseSource(invocation, given.whole);
    CircularSource source;
    source.id = row->id;
    const std::string axis = given.axis.toStdString();
    if (row->ofAxis) {
        if (axis != plane.first && axis != plane.second)
            refuseSource(invocation, given.whole);
        source.axis = axis == plane.first ? PlaneAxis::first : PlaneAxis::second;
    } else if (!axis.empty()) {
        refuseSource(invocation, given.whole);
    }
    source.value = baseParameter(row->id, given.value);
    constexpr double pitch = 10;  // mm
    constexpr double width = 1.5; // degrees
    const bool shaped = row->id == InfluenceId::cyclic || row->id == InfluenceId::reversalSpike;
    if (given.shape && !shaped)
        refuseSource(invocation, given.whole);
    source.shape = given.shape.value_or(row->id == InfluenceId::cyclic ? pitch : width);
    return source;
}

CircularSynthesis circular(const Invocation &invocation) {
    CircularSynthesis asked;
    asked.plane = plane(invocation);
    asked.radius = number(invocation, "radius", asked.radius, smallest, largest);
    constexpr long long most = 4'000'000; // a file holds 10⁷ readings, in two senses
    asked.points = count(invocation, "points", asked.points, most);
    asked.pause = number(invocation, "pause", 0, 0, largest);
    const QString senses = invocation.value("senses").value_or(QStringLiteral("both"));
    if (senses == QLatin1StringView("counterclockwise"))
        asked.senses = {Sense::counterclockwise};
    else if (senses == QLatin1StringView("clockwise"))
        asked.senses = {Sense::clockwise};
    if (asked.senses.size() == 1 && invocation.has("pause"))
        refuseEffect("--pause", "--senses both");
    if (const auto arc = invocation.value("arc")) {
        asked.arc = intervalGiven("arc", *arc);
        if (asked.arc.to - asked.arc.from > 360 || std::abs(asked.arc.from) > largest)
            refuse("arc", *arc, "FROM:TO");
    }
    for (const GivenSource &given : givenSources(invocation)) {
        if (given.id != QLatin1StringView(vibrationWord)) {
            asked.sources.push_back(circularSource(given, asked.plane, invocation));
            continue;
        }
        if (!given.axis.isEmpty())
            refuseSource(invocation, given.whole);
        asked.vibration = {given.value / micrometres, given.shape.value_or(asked.vibration.frequency)};
    }
    asked.noise = noise(invocation);
    return asked;
}

PositioningSynthesis positioning(const Invocation &invocation) {
    PositioningSynthesis asked;
    if (invocation.has("pause"))
        refuseEffect("--pause", circularWord);
    asked.axis = invocation.value("axis").value_or(QStringLiteral("X")).toStdString();
    const double travel = number(invocation, "travel", 1000, smallest, largest);
    constexpr long long mostTargets = 10'000;
    const std::size_t targets = count(invocation, "targets", 11, mostTargets);
    for (std::size_t i = 0; i < targets; ++i)
        asked.targets.push_back(targets > 1 ? travel * double(i) / double(targets - 1) : 0);
    constexpr long long mostRuns = 500;
    asked.runs = static_cast<int>(count(invocation, "runs", 5, mostRuns));
    for (const GivenSource &given : givenSources(invocation)) {
        const auto key = std::ranges::find_if(positioningKeys, [&](const PositioningKey &row) {
            return given.id == QLatin1StringView(row.id);
        });
        const bool otherAxis = !given.axis.isEmpty() && given.axis.toStdString() != asked.axis;
        if (key == positioningKeys.end() || otherAxis)
            refuseSource(invocation, given.whole);
        asked.*(key->value) = given.value * key->base + key->zero;
        if (!given.shape)
            continue;
        if (given.id == QLatin1StringView("cyclic"))
            asked.pitch = *given.shape;
        else if (given.id == QLatin1StringView("temperature"))
            asked.expansion = *given.shape;
        else
            refuseSource(invocation, given.whole);
    }
    asked.noise = noise(invocation);
    return asked;
}

DriftSynthesis drift(const Invocation &invocation) {
    constexpr double minute = 60;
    constexpr double hour = 3600;
    constexpr double mostHours = 1000;
    constexpr double mostRows = 1e6;
    DriftSynthesis asked;
    if (invocation.has("pause"))
        refuseEffect("--pause", circularWord);
    asked.length = number(invocation, "hours", asked.length / hour, smallest, mostHours) * hour;
    asked.step =
        number(invocation, "step", asked.step, std::max(smallest, asked.length / mostRows), asked.length);
    for (const GivenSource &given : givenSources(invocation)) {
        if (given.id == QLatin1StringView("temperature") && given.axis.isEmpty()) {
            asked.swing = given.value;
            asked.period = given.shape ? *given.shape * hour : asked.period;
            continue;
        }
        const bool responds = given.id == QLatin1StringView("response");
        if ((!responds && given.id != QLatin1StringView("straight")) || (!responds && given.shape))
            refuseSource(invocation, given.whole);
        const std::string name = given.axis.isEmpty() ? "X" : given.axis.toStdString();
        auto channel = std::ranges::find(asked.channels, name, &DriftChannelSynthesis::name);
        if (channel == asked.channels.end())
            channel = asked.channels.insert(asked.channels.end(), DriftChannelSynthesis{name});
        (responds ? channel->perDegree : channel->slope) = given.value / micrometres / (responds ? 1 : hour);
        if (given.shape)
            channel->tau = *given.shape * minute;
    }
    if (asked.channels.empty())
        asked.channels.emplace_back();
    asked.noise = noise(invocation);
    return asked;
}

/// True if a cyclic error is 0 at every target.
bool hidesCyclic(const PositioningSynthesis &asked) {
    constexpr double nothing = 1e-6;
    return asked.cyclic != 0 && std::ranges::all_of(asked.targets, [&](double target) {
               return std::abs(std::remainder(target, asked.pitch / 2)) < nothing * asked.pitch;
           });
}

TestPointer madeTest(const Language &language, const char *id, decltype(Test::measurement) measurement) {
    Test test;
    test.id = id;
    test.title = language.text(REPORT_TEXT("report", "Made by computation, not measured")).toStdString();
    test.measurement = std::move(measurement);
    if (isJudged(test))
        test.edition = defaultEdition(kindOf(test)).word;
    return std::make_shared<const Test>(std::move(test));
}

int write(const Document &document, const QByteArray &truth, const Invocation &invocation,
          const QString &output) {
    std::vector<FileToSave> files{{writeDocument(document), output}};
    if (const auto other = invocation.value(truthOption))
        files.push_back({truth, *other});
    return written(invocation, files); // both or none
}

/// Throws UsageError if outputs have endings of other kinds of files or are the same file.
void requireOutputs(const Invocation &invocation, const QString &output) {
    requireOutput(invocation, output, {"palmer", "json"});
    const auto truth = invocation.value(truthOption);
    if (!truth)
        return;
    requireOutput(invocation, *truth, {"json"});
    if (isSameFile(*truth, output) ||
        QFileInfo(*truth).absoluteFilePath() == QFileInfo(output).absoluteFilePath())
        throw UsageError({REPORT_TEXT("report", "%1 and %2 would both be written as %3; choose another name"),
                          {std::string("-o"), std::string("--truth"), output.toStdString()}});
}

int runSynthesize(const Invocation &invocation) {
    const QString &kind = invocation.arguments.front();
    const bool isCircular = kind == QLatin1StringView(circularWord);
    const bool isDrift = kind == QLatin1StringView(driftWord);
    if (invocation.arguments.size() != 1 ||
        (!isCircular && !isDrift && kind != QLatin1StringView("positioning")))
        throw UsageError({REPORT_TEXT("report", "the command %1 takes one word: %2"),
                          {std::string("synthesize"), std::string("circular|positioning|drift")}},
                         invocation.arguments.size() == 1 ? kind : QString(), partsOf(synthesizeCommand()));
    const QString output = neededOutput(invocation, "synthesize", "-o OUT.palmer");
    requireOutputs(invocation, output);
    Document document;
    document.writtenBy = "Palmer " PALMER_VERSION;
    if (isDrift) {
        const DriftSynthesis asked = drift(invocation);
        document.tests.push_back(madeTest(namesLanguage(invocation), "made", synthesizeDrift(asked)));
        return write(document, truthJson(asked), invocation, output);
    }
    if (!isCircular) {
        const PositioningSynthesis asked = positioning(invocation);
        if (hidesCyclic(asked))
            printError(invocation.language.sentence(
                {REPORT_TEXT("report", "Every target lies where a cyclic error of the pitch %1 is 0: it does "
                                       "not show in the readings. Choose other --targets, another --travel "
                                       "or pitch."),
                 {Number{asked.pitch, Quantity::position}}}));
        document.tests.push_back(madeTest(namesLanguage(invocation), "made", synthesizePositioning(asked)));
        return write(document, truthJson(asked), invocation, output);
    }
    CircularSynthesis asked = circular(invocation);
    const std::vector<double> all = feeds(invocation);
    for (std::size_t i = 0; i < all.size(); ++i) {
        CircularSynthesis one = asked;
        one.feed = all[i];
        one.noise.seed += static_cast<long long>(i); // independent noise for every test
        const std::string id = "made-" + std::to_string(i + 1);
        document.tests.push_back(madeTest(namesLanguage(invocation), id.c_str(), synthesizeCircular(one)));
    }
    return write(document, truthJson(asked, all), invocation, output);
}

} // namespace

Command synthesizeCommand() {
    return {"synthesize", "circular|positioning|drift",
            REPORT_TEXT("report", "a measurement with known truth"), synthesizeOptions, runSynthesize};
}

} // namespace palmer
