// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// palmer-laws FILES [SEED [OUT.palmer]]: follows so many generated test files through every exit of the
// program and prints what does not hold, each kind of violation once with the seed of its file, and the
// counts; OUT.palmer is the last of the files.
#include "laws/laws.h"

#include "document/savedocument.h"

#include <QApplication>
#include <cstdio>
#include <cstdlib>

using namespace palmer::laws;

int main(int argc, char **argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    const int files = argc > 1 ? std::atoi(argv[1]) : 1000;
    const int first = argc > 2 ? std::atoi(argv[2]) : 1;
    const Json schema = Json::parse(palmer::readBytes(QStringLiteral(PALMER_SCHEMA)).toStdString());
    Counts all;
    std::map<std::string, int> kinds;
    for (int seed = first; seed < first + files; ++seed) {
        Generator generator(schema, static_cast<std::uint64_t>(seed));
        const Json file = generator.file();
        if (argc > 3 && seed == first + files - 1)
            palmer::saveBytes(QByteArray::fromStdString(file.dump(2)), QString::fromLocal8Bit(argv[3]));
        Laws laws(generator, 0, static_cast<std::uint64_t>(seed));
        for (const Violation &violation : laws.follow(file, seed % 20 == 0)) {
            std::string kind = violation.law + ": " + violation.what;
            for (char &c : kind) {
                if (c >= '0' && c <= '9')
                    c = '#';
            }
            if (kinds[kind.substr(0, 70)]++ == 0)
                std::printf("%d %s: %s\n", seed, violation.law.c_str(), violation.what.c_str());
        }
        const Counts &counts = laws.counts();
        all.files += counts.files;
        all.refused += counts.refused;
        all.tests += counts.tests;
        all.limits += counts.limits;
        all.statements += counts.statements;
        all.texts += counts.texts;
        all.numbers += counts.numbers;
        all.pages += counts.pages;
        all.reports += counts.reports;
        for (const auto &[law, count] : counts.violations)
            all.violations[law] += count;
    }
    int violations = all.refused;
    std::printf("files %d, refused %d, tests %d, limits %d, statements taken away %d, texts looked for %d, "
                "numbers %d, pages compared %d, PDF %d\n",
                all.files, all.refused, all.tests, all.limits, all.statements, all.texts, all.numbers,
                all.pages, all.reports);
    for (const auto &[law, count] : all.violations) {
        std::printf("%s: %d violations\n", law.c_str(), count);
        violations += count;
    }
    return violations > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
