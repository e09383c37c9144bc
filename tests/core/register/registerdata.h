// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/readdocument.h"
#include "document/writedocument.h"
#include "register/listing.h"
#include "register/queries.h"
#include "register/register.h"
#include "register/scan.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QString>
#include <cstdlib>
#include <string>
#include <vector>

/// Test files of machines, made here, and what a register says of them.
namespace palmer::testdata {

/// What a file of one positioning test says; the deviations are level · (0 … 1) along the axis, µm.
struct Sample {
    std::string machine = "Machine 017";
    std::string maker = "Maker A";
    std::string serial = "000-017";
    std::string axis = "X";
    std::string date = "2024-04-16";
    double level = 9.4;
    std::string purpose = "periodic";
    std::string role = "asFound";
    std::string edition = "ISO 230-2:2014";
    double feed = 6000;
    double travel = 1000;
    double limit = 16; ///< µm; 0: none
    std::string remarks = {};
    std::string instrument = "LSR-1";
    std::string rule = "simple acceptance";
    std::string uncertainty = R"("method": "budget", "device": {"kind": "certificate", "fixed": 0.1,
        "perMetre": 0.8, "coverageFactor": 2}, "misalignmentRange": 0.5,
        "temperatureRange": {"machine": 0.2, "instrument": 0.1},
        "expansionRange": {"machine": 2.0, "instrument": 0.0}, "environmentalVariation": 0.6)";
};

inline QByteArray fileOf(const Sample &sample) {
    constexpr int targets = 5;
    std::string positions;
    std::string runs;
    for (int i = 0; i < targets; ++i)
        positions += (i ? ", " : "") + std::to_string(sample.travel * i / (targets - 1));
    for (int run = 0; run < 4; ++run) {
        std::string deviations;
        for (int i = 0; i < targets; ++i) {
            const double scatter = 0.0001 * ((run / 2 + i) % 2) + (run % 2) * 0.0005;
            deviations += (i ? ", " : "") + std::to_string(sample.level / 1000 * i / (targets - 1) + scatter);
        }
        runs += std::string(run ? ", " : "") + R"({"approach": ")" + (run % 2 ? "negative" : "positive") +
                R"(", "deviations": [)" + deviations + "]}";
    }
    const std::string limits =
        sample.limit > 0 ? R"("A": {"value": )" + std::to_string(sample.limit / 1000) + "}" : "";
    const std::string text =
        R"({"format": "palmer test report", "version": 2, "machine": {"name": ")" + sample.machine +
        R"(", "manufacturer": ")" + sample.maker + R"(", "model": "CU 1000", "serialNumber": ")" +
        sample.serial + R"("}, "instruments": [{"id": "laser", "description": "laser", "serialNumber": ")" +
        sample.instrument + R"(", "certificate": "C-1", "calibrationDue": "2027-01-31"}],
        "tests": [{"kind": "positioning", "id": "t", "title": "test", "date": ")" +
        sample.date + R"(", "instruments": ["laser"], "edition": ")" + sample.edition + R"(", "purpose": ")" +
        sample.purpose + R"(", "role": ")" + sample.role + R"(", "remarks": ")" + sample.remarks +
        R"(", "decisionRule": {"rule": ")" + sample.rule + R"("}, "axis": {"name": ")" + sample.axis +
        R"(", "motion": "linear", "travel": 1100},
        "targets": [)" +
        positions + R"(], "runs": [)" + runs + R"(], "limits": {)" + limits + R"(},
        "conditions": {"feed": )" +
        std::to_string(sample.feed) +
        R"(, "feedMode": "programmed", "correctionTo20": "applied by the instrument",
        "sensors": [{"measures": "machine", "start": 20.5, "end": 20.5},
                    {"measures": "instrument", "start": 20.5, "end": 20.5}],
        "expansion": {"machine": 11.0, "instrument": 0.0}}, "uncertainty": {)" +
        sample.uncertainty + "}}]}";
    return writeDocument(readDocument(QByteArray::fromStdString(text)));
}

inline void writeFile(const QString &path, const QByteArray &bytes) {
    QDir().mkpath(QFileInfo(path).absolutePath());
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

/// Everything a register says of its tests, as `register list --json` prints it.
inline QByteArray listed(Database &database, const TestFilter &filter = {}) {
    QByteArray result;
    for (const ListedTest &test : tests(database, filter))
        result += listedTestJson(test);
    return result;
}

} // namespace palmer::testdata
