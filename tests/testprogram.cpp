// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "testprogram.h"

#include <cstdio>
#include <map>
#include <string>

namespace palmer::testdata {

namespace {

std::map<std::string, int (*)(int, char **)> &rows() {
    static std::map<std::string, int (*)(int, char **)> all;
    return all;
}

/// "core/document/edits" of ".../tests/core/document/edits.cpp"
std::string nameOf(const std::string &file) {
    const std::string folder = PALMER_SOURCE_DIR "/tests/";
    const std::size_t from = file.starts_with(folder) ? folder.size() : 0;
    return file.substr(from, file.rfind('.') - from);
}

} // namespace

TestRow::TestRow(const char *file, int (*run)(int, char **)) {
    rows().emplace(nameOf(file), run);
}

} // namespace palmer::testdata

int main(int argc, char *argv[]) {
    const auto &rows = palmer::testdata::rows();
    const auto row = argc > 1 ? rows.find(argv[1]) : rows.end();
    if (row == rows.end()) {
        std::fprintf(stderr, "%s TEST [OPTION]…, TEST one of\n", argv[0]);
        for (const auto &[name, run] : rows)
            std::fprintf(stderr, "%s\n", name.c_str());
        return 2;
    }
    return row->second(argc - 1, argv + 1); // Qt names folders by argv[0]: each test has its own
}
