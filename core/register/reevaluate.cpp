// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/reevaluate.h"

#include "register/registeredtest.h"
#include "register/storedsentence.h"

#include <algorithm>
#include <map>

namespace palmer {

std::vector<Unreadable> reevaluate(std::vector<ListedTest> &tests, const Edition &edition) {
    std::vector<Unreadable> lost;
    std::map<QString, std::vector<RegisteredTest>> files; // files already read
    std::erase_if(tests, [&](ListedTest &listed) {
        if (listed.test.kind != edition.kind)
            return false;
        const TestPlace &place = listed.places.front();
        auto file = files.find(place.path);
        if (file == files.end()) {
            std::vector<RegisteredTest> read;
            try {
                if (auto document = documentOfFile(place.path))
                    read = registeredTests(evaluate(std::make_shared<const Document>(std::move(*document)),
                                                    nullptr, edition.word),
                                           QStringLiteral(" "));
            } catch (const Error &error) {
                lost.push_back({place.path, storedSentence(error)});
            }
            file = files.emplace(place.path, std::move(read)).first;
        }
        const auto index = static_cast<std::size_t>(place.test) - 1;
        const bool isThere =
            index < file->second.size() && file->second[index].fingerprint == listed.test.fingerprint;
        if (isThere) {
            RegisteredTest fresh = file->second[index];
            fresh.digest = listed.test.digest;
            listed.test = std::move(fresh);
        }
        return !isThere;
    });
    return lost;
}

} // namespace palmer
