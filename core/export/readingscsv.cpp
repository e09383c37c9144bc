// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/resultsjson.h"

#include "document/filewords.h"
#include "document/json.h"
#include "document/statements.h"
#include "import/palmercsv.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/measurement/testfacts.h"
#include "language/csvwriter.h"
#include "report/tables/resultcolumns.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace palmer {

namespace {

using Json = nlohmann::ordered_json;

const char *unitOf(Motion motion) {
    return motion == Motion::linear ? "mm" : "°";
}

/// Writes what the numbers depend on: the statements, the unit, the sign.
void writeStatements(CsvWriter &csv, const Document &document, std::size_t index) {
    const Test &test = *document.tests[index];
    csv.statement(palmercsv::format, palmercsv::formatWord);
    csv.statement(palmercsv::unit, unitOf(motionOf(test)));
    if (kindOf(test) == Kind::positioning)
        csv.statement(palmercsv::sign, "actualMinusTarget");
    for (const Statement &statement : statementsOf(document, index))
        csv.statement(statement.path, statement.value, statement.number);
}

void writeReadings(CsvWriter &csv, const PositioningMeasurement &m, const TestEvaluation &evaluation) {
    const std::string unit = std::string(" (") + unitOf(m.axis.motion) + ')';
    csv.text("i");
    csv.text(palmercsv::target + unit);
    std::array<int, 2> runs{};
    for (const Run &run : m.runs) {
        const bool up = run.approach == Direction::positive;
        csv.text(palmercsv::deviation + (' ' + std::to_string(++runs[up ? 0 : 1])) + (up ? " ↑" : " ↓") +
                 unit);
    }
    struct Statistic {
        const char *heading = nullptr;
        const char *id = nullptr;
    };
    constexpr std::array statistics{Statistic{"mean ↑", "mean+"},       Statistic{"mean ↓", "mean-"},
                                    Statistic{"mean", "mean"},          Statistic{"reversal", "reversal"},
                                    Statistic{"std ↑", "s+"},           Statistic{"std ↓", "s-"},
                                    Statistic{"mean - cs ↑", "lower+"}, Statistic{"mean + cs ↑", "upper+"},
                                    Statistic{"mean - cs ↓", "lower-"}, Statistic{"mean + cs ↓", "upper-"}};
    for (const Statistic &row : statistics)
        csv.text(row.heading + unit);
    csv.endRow();
    const PositioningResults &results = resultsOf(m, evaluation);
    for (std::size_t i = 0; i < m.targets.size(); ++i) {
        csv.number(static_cast<double>(i + 1));
        csv.number(m.targets[i]);
        for (const Run &run : m.runs)
            csv.number(run.deviations[i]);
        for (const Statistic &row : statistics)
            csv.number(evaluation.edition ? targetValue(row.id, results.targets[i], evaluation.edition->c)
                                          : std::nullopt);
        csv.endRow();
    }
}

void writeReadings(CsvWriter &csv, const CircularMeasurement &m, const TestEvaluation & /*evaluation*/) {
    csv.text("angle (°)");
    csv.text("radial deviation (mm)");
    csv.endRow();
    for (const Arc &arc : m.arcs) {
        csv.comment(fileWord(arc.sense));
        for (std::size_t i = 0; i < arc.angles.size(); ++i) {
            csv.number(arc.angles[i]);
            csv.number(arc.radialDeviations[i]);
            csv.endRow();
        }
    }
}

void writeReadings(CsvWriter &csv, const DriftMeasurement &m, const TestEvaluation & /*evaluation*/) {
    csv.text("time (s)");
    const std::vector<DriftChannel> channels = channelsOf(m);
    // Their names, which may look like units, are stated above.
    for (std::size_t i = 0; i < channels.size(); ++i)
        csv.text(palmercsv::deviation + (m.channels.empty() ? std::string() : ' ' + std::to_string(i + 1)) +
                 (channels[i].quantity == ChannelQuantity::deviation ? " (mm)" : " (deg)"));
    for (std::size_t i = 0; i < m.temperatures.size(); ++i)
        csv.text(palmercsv::temperature + (' ' + std::to_string(i + 1)) + " (°C)");
    csv.endRow();
    for (std::size_t i = 0; i < m.times.size(); ++i) {
        csv.number(m.times[i]);
        for (const DriftChannel &channel : channels)
            csv.number(channel.values[i]);
        for (const DriftTemperature &temperature : m.temperatures)
            csv.number(temperature.values[i]);
        csv.endRow();
    }
}

Json asJson(const PositioningMeasurement &m) {
    Json runs = Json::array();
    for (const Run &run : m.runs) {
        Json values = Json::array();
        for (const auto &value : run.deviations)
            values.push_back(value ? Json(*value) : Json(nullptr));
        runs.push_back({{"approach", fileWord(run.approach)}, {"deviations", std::move(values)}});
    }
    return {{"targets", m.targets}, {"runs", std::move(runs)}};
}

Json asJson(const CircularMeasurement &m) {
    Json arcs = Json::array();
    for (const Arc &arc : m.arcs)
        arcs.push_back({{"sense", fileWord(arc.sense)},
                        {"angles", arc.angles},
                        {"radialDeviations", arc.radialDeviations}});
    return {{"nominalRadius", m.nominalRadius}, {"arcs", std::move(arcs)}};
}

Json asJson(const DriftMeasurement &m) {
    if (m.channels.empty() && m.temperatures.empty())
        return {{"times", m.times}, {"deviations", m.deviations}};
    const auto listOf = [](const std::vector<std::optional<double>> &values) {
        Json list = Json::array();
        for (const auto &value : values)
            list.push_back(value ? Json(*value) : Json(nullptr));
        return list;
    };
    Json channels = Json::array();
    for (const DriftChannel &channel : channelsOf(m))
        channels.push_back({{"name", channel.name},
                            {"quantity", fileWord(channel.quantity)},
                            {"values", listOf(channel.values)}});
    Json temperatures = Json::array();
    for (const DriftTemperature &one : m.temperatures)
        temperatures.push_back({{"measures", one.measures}, {"values", listOf(one.values)}});
    return {{"times", m.times}, {"channels", std::move(channels)}, {"temperatures", std::move(temperatures)}};
}

} // namespace

QByteArray readingsCsv(const EvaluatedDocument &evaluated, std::size_t index, const Language &language,
                       char decimalMark) {
    const Test &test = *evaluated.document->tests[index];
    const TestEvaluation &evaluation = *evaluated.tests[index];
    CsvWriter csv(decimalMark);
    writeStatements(csv, *evaluated.document, index);
    std::visit([&](const auto &measurement) { writeReadings(csv, measurement, evaluation); },
               test.measurement);
    if (evaluation.parameters.empty())
        return csv.bytes();
    csv.endRow();
    const auto columns = resultColumns(inCsv);
    for (const ResultColumn *column : columns)
        csv.text(column->heading);
    csv.endRow();
    for (const Parameter &parameter : evaluation.parameters) {
        for (const ResultColumn *column : columns) {
            const Json told = column->told({parameter, evaluation.uncertainty, language});
            if (told.is_string())
                csv.text(told.get<std::string>());
            else
                csv.number(told.is_number() ? std::optional(told.get<double>()) : std::nullopt);
        }
        csv.endRow();
    }
    return csv.bytes();
}

QByteArray readingsJson(const EvaluatedDocument &evaluated, const QString &fileName,
                        const Language &language) {
    Json file = Json::parse(resultsJson(evaluated, fileName, language, JsonForm::oneLine).toStdString());
    for (std::size_t i = 0; i < evaluated.document->tests.size(); ++i) {
        file["tests"][i]["readings"] = std::visit([](const auto &measurement) { return asJson(measurement); },
                                                  evaluated.document->tests[i]->measurement);
    }
    return QByteArray::fromStdString(printJson(file));
}

} // namespace palmer
