// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// palmer-laws FILES [SEED [FOLDER]]: follows so many generated test files through every exit of the program
// and prints what does not hold, each kind of violation once with the seed of its file, and the counts; with
// FOLDER it writes the files there instead, SEED.palmer each.
#include "laws/doors.h"
#include "laws/importchoices.h"
#include "laws/laws.h"

#include "document/savedocument.h"

#include <QApplication>
#include <QDir>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace palmer::laws;

namespace {

/// "palmer-laws doors 2000 1": tables of each kind, seed.
int followDoorsOnly(int tables, std::uint64_t seed) {
    int differ = 0;
    const DoorCounts doors = followDoors(tables, seed, [&](const std::string &door, const std::string &what) {
        constexpr int shown = 10;
        if (differ++ < shown)
            std::printf("%s: %s\n", door.c_str(), what.c_str());
    });
    std::printf("tables %d, asked %d, refused %d, comparisons equal %d, different %d\n", doors.tables,
                doors.asked, doors.refused, doors.equal, differ);
    for (const auto &[door, count] : doors.differing)
        std::printf("%s: %d differ\n", door.c_str(), count);
    return differ > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}

/// "palmer-laws choices 20 1": files of each kind, seed.
int followChoicesOnly(int rounds, std::uint64_t seed) {
    std::map<std::string, int> laws;
    const ChoiceCounts all =
        followChoices(rounds, seed, [&](const std::string &law, const std::string &what) {
            if (laws[law]++ == 0)
                std::printf("%s: %s\n=====\n", law.c_str(), what.c_str());
        });
    std::printf("files %d, refused %d, answers %d, failures %d\n", all.files, all.refused, all.answers,
                all.failures);
    for (const auto &[law, count] : laws)
        std::printf("%s: %d failures\n", law.c_str(), count);
    for (const auto &[key, count] : all.asked)
        std::printf("%s: asked %d times\n", key.c_str(), count);
    for (const std::string &key : all.missing())
        std::printf("%s: in no file\n", key.c_str());
    return all.failures > 0 || !all.missing().empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}

} // namespace

int main(int argc, char **argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    if (argc > 1 && std::strcmp(argv[1], "doors") == 0)
        return followDoorsOnly(argc > 2 ? std::atoi(argv[2]) : 500,
                               argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
    if (argc > 1 && std::strcmp(argv[1], "choices") == 0)
        return followChoicesOnly(argc > 2 ? std::atoi(argv[2]) : 20,
                                 argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
    const int files = argc > 1 ? std::atoi(argv[1]) : 1000;
    const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    if (argc > 3) {
        const QDir folder(QString::fromLocal8Bit(argv[3]));
        folder.mkpath(QStringLiteral("."));
        for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(files); ++seed)
            palmer::saveBytes(QByteArray::fromStdString(fileOf(seed)),
                              folder.filePath(QStringLiteral("%1.palmer").arg(seed)));
        return EXIT_SUCCESS;
    }
    std::map<std::string, int> kinds;
    const auto print = [&](std::uint64_t seed, const Violation &violation) {
        std::string kind = violation.law + ": " + violation.what;
        for (char &c : kind) {
            if (c >= '0' && c <= '9')
                c = '#';
        }
        constexpr std::size_t ofAKind = 70;
        if (kinds[kind.substr(0, ofAKind)]++ == 0)
            std::printf("%llu %s: %s\n", static_cast<unsigned long long>(seed), violation.law.c_str(),
                        violation.what.c_str());
    };
    const Counts all = followFiles(files, first, 0, print);
    std::printf("files %d, refused %d, tests %d, limits %d, results printed %d, statements taken away %d, "
                "texts looked for %d, "
                "numbers %d, pages compared %d, PDF %d, CSV read back %d\n",
                all.files, all.refused, all.tests, all.limits, all.results, all.statements, all.texts,
                all.numbers, all.pages, all.reports, all.readBack);
    int violations = all.refused;
    for (const auto &[law, count] : all.violations) {
        std::printf("%s: %d violations\n", law.c_str(), count);
        violations += count;
    }
    return violations > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
