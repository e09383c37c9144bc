// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzz target without a fuzzer: its corpus, then as many random changes of it as asked for, always the
// same. For compilers without libFuzzer, and for a short run among the tests.
//
//     replay COUNT FOLDER…

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace {

constexpr std::size_t largest = 1 << 16; // larger files of the corpus run as they are only

std::vector<std::string> corpus(int count, char **folders) {
    std::vector<std::filesystem::path> paths;
    for (int i = 0; i < count; ++i) {
        for (const auto &entry : std::filesystem::recursive_directory_iterator(folders[i])) {
            if (entry.is_regular_file() && entry.path().extension() != ".expected")
                paths.push_back(entry.path());
        }
    }
    std::ranges::sort(paths);
    std::vector<std::string> files;
    for (const auto &path : paths) {
        std::ifstream file(path, std::ios::binary);
        files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return files;
}

void run(const std::string &bytes) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(bytes.data()), bytes.size());
}

std::string changed(std::string bytes, const std::vector<std::string> &files, std::mt19937 &random) {
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (auto changes = 1 + below(4); changes > 0; --changes) {
        const std::size_t at = below(bytes.size() + 1);
        switch (below(7)) {
        case 0:
            if (at < bytes.size())
                bytes[at] = static_cast<char>(random());
            break;
        case 1:
            bytes.erase(at, 1 + below(30));
            break;
        case 2:
            bytes.insert(at, 1, "0123456789.,;:-+eE \t\n\r\"#%/[]=<>&"[below(33)]);
            break;
        case 3:
            bytes.insert(at, bytes.substr(below(bytes.size()), below(60)));
            break;
        case 4: {
            const std::string &other = files[below(files.size())];
            bytes.insert(at, other.substr(below(other.size()), below(200)));
            break;
        }
        case 5:
            bytes.resize(at);
            break;
        default: {
            constexpr const char *words[]{"nan", "1e308", "-1e308", "999999999999", "\xFF\xFE",
                                          "0",   "-",     "\n\n",   ";;;;",         "1e-320"};
            bytes.insert(at, words[below(std::size(words))]);
        }
        }
    }
    return bytes;
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 3) {
        std::fprintf(stderr, "replay COUNT FOLDER…\n");
        return 2;
    }
    const std::vector<std::string> files = corpus(argc - 2, argv + 2);
    if (files.empty()) {
        std::fprintf(stderr, "the corpus is empty\n");
        return 2;
    }
    for (const std::string &file : files)
        run(file);
    std::mt19937 random(1);
    const int count = std::atoi(argv[1]);
    for (int i = 0; i < count; ++i) {
        const std::string &file = files[random() % files.size()];
        if (file.size() > largest)
            continue;
        const std::string bytes = changed(file, files, random);
        // The input that a crash came from is left behind.
        if (const char *found = std::getenv("PALMER_FUZZ_FOUND"))
            std::ofstream(found, std::ios::binary) << bytes;
        run(bytes);
    }
    std::printf("%zu files, %d changes\n", files.size(), count);
    return 0;
}
