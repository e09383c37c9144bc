// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/readdocument.h"
#include "document/writedocument.h"
#include "register/listing.h"
#include "register/machinechoices.h"
#include "register/queries.h"
#include "register/register.h"
#include "register/scan.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QString>
#include <array>
#include <atomic>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

/// Test files of machines, made here, and what a register says of them.
namespace palmer::testdata {

/// What a file of one positioning test says; the deviations are level · (0 … 1) along the axis, µm.
struct Sample {
    std::string machine = "Machine 017";
    std::string maker = "Maker A";
    std::string model = "CU 1000";
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
        R"(", "manufacturer": ")" + sample.maker + R"(", "model": ")" + sample.model +
        R"(", "serialNumber": ")" + sample.serial +
        R"("}, "instruments": [{"id": "laser", "description": "laser", "serialNumber": ")" +
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

/// Two tests of machines that differ in one field of their identity, however alike it looks.
struct MachinePair {
    Sample one;
    Sample other;
    QString field;
};

inline std::vector<MachinePair> differingMachines(int count, unsigned seed) {
    std::mt19937 random(seed);
    const QStringList letters{"A", "b", "1",      "2",      "12", "-",      ".",
                              "/", " ", "\u00e9", "\u0394", "_",  "\uff11", "#"};
    const auto text = [&] {
        QString result;
        for (int i = 0; i < 6; ++i)
            result += letters.at(static_cast<qsizetype>(random() % static_cast<unsigned>(letters.size())));
        return result;
    };
    /// The same letters and digits with other marks between them, or another text of the same letters.
    const auto alike = [&](const QString &given) {
        QString result = given;
        while (asCompared(result) == asCompared(given)) {
            const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(result.size() + 1));
            switch (random() % 3) {
            case 0:
                result.insert(at, letters.at(5 + static_cast<qsizetype>(random() % 3)));
                break;
            case 1:
                result = result.mid(at) + result.left(at);
                break;
            default:
                result.remove(QRegularExpression("[-./_#]"));
                result += QString(random() % 2, u'-') + (result.isEmpty() ? "x" : "");
                result.insert(at % (result.size() + 1), " ");
            }
        }
        return result.toStdString();
    };
    struct Field {
        const char *name;
        std::string Sample::*field;
        bool isIdentified;
        bool hasMaker = true;
    };
    constexpr std::array fields{Field{"maker", &Sample::maker, true},
                                Field{"serial number", &Sample::serial, true},
                                Field{"serial number without maker", &Sample::serial, true, false},
                                Field{"type without maker", &Sample::model, true, false},
                                Field{"name without serial number", &Sample::machine, false},
                                Field{"maker without serial number", &Sample::maker, false},
                                Field{"type without serial number", &Sample::model, false}};
    std::vector<MachinePair> result;
    for (int i = 0; i < count; ++i) {
        const Field &field = fields.at(static_cast<std::size_t>(i) % fields.size());
        MachinePair pair;
        for (const auto member : {&Sample::machine, &Sample::maker, &Sample::model})
            pair.one.*member = (text() + "m").toStdString();
        if (!field.hasMaker)
            pair.one.maker.clear();
        pair.one.serial = field.isIdentified ? (text() + "7").toStdString() : i % 2 ? "" : " - ";
        pair.one.level = 5 + 0.01 * i;
        pair.other = pair.one;
        pair.other.*field.field = alike(QString::fromStdString(pair.one.*field.field));
        pair.field = QString("%1: \"%2\" and \"%3\"")
                         .arg(field.name, QString::fromStdString(pair.one.*field.field),
                              QString::fromStdString(pair.other.*field.field));
        result.push_back(std::move(pair));
    }
    return result;
}

inline int fromEnvironment(const char *name, int otherwise) {
    return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : otherwise;
}

/// Scans such pairs (PAIRS of the environment, otherwise 100); returns those that became one machine.
inline QStringList silentlyJoined(Register &reg, const QString &folder, unsigned seed) {
    const std::vector<MachinePair> pairs = differingMachines(fromEnvironment("PAIRS", 100), seed);
    const auto place = [&](std::size_t pair, const char *which) {
        return folder + QString("/%1 %2.palmer").arg(pair).arg(which);
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        writeFile(place(i, "a"), fileOf(pairs[i].one));
        writeFile(place(i, "b"), fileOf(pairs[i].other));
    }
    (void)scan(reg, {folder});
    std::map<QString, int> machineOf;
    for (const ListedTest &test : tests(reg.database(), {})) {
        for (const TestPlace &one : test.places)
            machineOf[one.path] = test.machine;
    }
    QStringList joined;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (machineOf.at(place(i, "a")) == machineOf.at(place(i, "b")))
            joined << pairs[i].field;
    }
    return joined;
}

/// Everything a register says of its tests, as `register list --json` prints it.
inline QByteArray listed(Database &database, const TestFilter &filter = {}) {
    QByteArray result;
    for (const ListedTest &test : tests(database, filter))
        result += listedTestJson(test);
    return result;
}

/// Reads a register many times (READS of the environment, otherwise 100) while it is made anew from the
/// folder again and again; returns what was neither the register before nor the one after.
inline QStringList wrongReads(const QString &address, const QString &folder) {
    const int count = fromEnvironment("READS", 100);
    const auto content = [&]() -> QByteArray {
        Register reg(address, Register::Open::read);
        QByteArray result;
        for (const ListedMachine &machine : machines(reg.database())) {
            TestFilter filter;
            filter.machines = {machine.id};
            result += machine.title().toUtf8() + '\n' + listed(reg.database(), filter);
        }
        return result;
    };
    const QByteArray before = content();
    std::atomic<bool> ends = false;
    QString trouble;
    int rebuilds = 0;
    std::thread writer([&] {
        while (!ends) {
            try {
                Register reg(address, Register::Open::rebuild);
                (void)scan(reg, {folder}, {.jobs = 1});
                ++rebuilds;
            } catch (const Error &error) {
                trouble = Language(Language::Id::english).sentence(error.message);
            }
        }
    });
    QStringList wrong;
    QByteArray after = before;
    for (int i = 0; i < count || after == before; ++i) {
        try {
            const QByteArray now = content();
            if (after == before)
                after = now;
            else if (now != after)
                wrong << QString::fromUtf8(now.left(200));
        } catch (const Error &error) {
            wrong << Language(Language::Id::english).sentence(error.message);
        }
    }
    ends = true;
    writer.join();
    if (!trouble.isEmpty())
        wrong << trouble;
    if (rebuilds < 2)
        wrong << QString("made anew only %1 times").arg(rebuilds);
    return wrong;
}

} // namespace palmer::testdata
