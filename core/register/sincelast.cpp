// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/sincelast.h"

#include "document/documenterror.h"
#include "kernel/measurement/testfacts.h"
#include "register/jsonline.h"
#include "register/scan.h"
#include "report/parts/comparedtests.h"

#include <algorithm>

namespace palmer {

namespace {

/// The file of a test, evaluated; without document if it cannot be read or has other readings now.
EvaluatedDocument fileOf(const ListedTest &listed) {
    const TestPlace &place = listed.places.front();
    try {
        auto document = documentOfFile(place.path);
        const auto index = static_cast<std::size_t>(place.test) - 1;
        if (!document || index >= document->tests.size())
            return {};
        EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(std::move(*document)));
        const bool same =
            registeredTests(evaluated, QStringLiteral(" "))[index].fingerprint == listed.test.fingerprint;
        return same ? evaluated : EvaluatedDocument();
    } catch (const Error &) {
        return {};
    }
}

} // namespace

std::optional<std::size_t> lastBefore(const std::vector<ListedTest> &tests, std::size_t of) {
    const RegisteredTest &now = tests[of].test;
    if (!traitsOf(now.kind).isJudged)
        return std::nullopt;
    for (std::size_t i = of; i-- > 0;) {
        const RegisteredTest &one = tests[i].test;
        if (one.kind == now.kind && one.axis == now.axis && one.angular == now.angular &&
            one.fingerprint != now.fingerprint)
            return i;
    }
    return std::nullopt;
}

std::shared_ptr<const SinceLast> sinceLast(const ListedTest &before, const ListedTest &now) {
    const EvaluatedDocument was = fileOf(before);
    const EvaluatedDocument is = fileOf(now);
    if (!was.document || !is.document)
        return nullptr;
    const auto placed = [](const EvaluatedDocument &file, const ListedTest &listed) {
        return PlacedTest{&file, static_cast<std::size_t>(listed.places.front().test) - 1};
    };
    return std::make_shared<const SinceLast>(
        SinceLast{before.places.front(), before.test.date, compare(placed(was, before), placed(is, now))});
}

void findChanges(std::vector<ListedTest> &tests) {
    for (std::size_t i = 0; i < tests.size(); ++i) {
        if (const auto last = lastBefore(tests, i))
            tests[i].sinceLast = sinceLast(tests[*last], tests[i]);
    }
}

const ComparedParameter *changeOf(const SinceLast &change, const std::string &result) {
    const auto &all = change.comparison.parameters;
    const auto found = std::ranges::find(all, result, comparedId);
    return found == all.end() ? nullptr : &*found;
}

Json changeJson(Json head, const ComparedParameter &change) {
    head.update({{"difference", change.difference},
                 {"expandedUncertainty", orNull(change.uncertainty)},
                 {"word", change.word ? Json(fileWord(*change.word)) : Json()}});
    return head;
}

QString sinceLastWord(const SinceLast &change, const Language &language) {
    const auto word = wordOfAll(change.comparison);
    return word ? language.text(changeText(*word)) : reasonOf(change.comparison, language);
}

} // namespace palmer
