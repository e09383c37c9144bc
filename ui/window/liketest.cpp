// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/liketest.h"

#include "document/readdocument.h"
#include "document/savedocument.h"
#include "editing/takestatements.h"
#include "kernel/measurement/testfacts.h"
#include "ui/register/registerqueries.h"

#include <algorithm>
#include <tuple>

namespace palmer::ui {

namespace {

QString asListed(const ListedMachine &machine) {
    return QStringLiteral("%1 · %2").arg(machine.title(), machine.serialNumber);
}

/// Newer tests rank higher, those of the same axis highest; of equal ones the last in the register is taken.
auto rankOf(const Test &test, const RegisteredTest &other) {
    return std::tuple(kindOf(test) == other.kind && axesOf(test) == other.axis, kindOf(test) == other.kind,
                      other.date.value_or(""), other.time.value_or(""));
}

auto rankOf(const Test &test, const Test &other) {
    return std::tuple(areOfOneAxis(test, other), kindOf(test) == kindOf(other), other.date.value_or(""),
                      other.time.value_or(""));
}

} // namespace

std::optional<LikeTest> lastTestOfMachine(const std::shared_ptr<const Document> &document, std::size_t index,
                                          const QString &path, const QString &address,
                                          const QString &machine) {
    const Test &test = *document->tests[index];
    const Machine &own = document->machine;
    const QString identity =
        machineIdentity({QString::fromStdString(own.name), QString::fromStdString(own.manufacturer),
                         QString::fromStdString(own.model), QString::fromStdString(own.serialNumber)});
    std::optional<ListedTest> registered;
    for (const MachineRow &row : readMachines(address)) {
        const bool isMeant =
            machine.isEmpty() ? row.machine.identity == identity : asListed(row.machine) == machine;
        if (!isMeant)
            continue;
        for (const ListedTest &one : readTests(address, row.machine.id)) {
            const TestPlace &place = one.places.front();
            if (place.state == u"read" && place.path != path && traitsOf(one.test.kind).isJudged &&
                (!registered || rankOf(test, one.test) >= rankOf(test, registered->test)))
                registered = one;
        }
    }
    const auto here = lastTestLike(*document, index);
    if (here && (!registered || rankOf(test, *document->tests[*here]) >= rankOf(test, registered->test)))
        return LikeTest{document, *here, {}};
    if (!registered)
        return std::nullopt;
    const TestPlace &place = registered->places.front();
    auto read = std::make_shared<const Document>(readDocument(readBytes(place.path)));
    const auto at = static_cast<std::size_t>(place.test - 1);
    if (at >= read->tests.size()) // the file has changed since it was registered
        return std::nullopt;
    return LikeTest{std::move(read), at, place.path};
}

QStringList machinesOfRegister(const QString &address) {
    QStringList names;
    for (const MachineRow &row : readMachines(address))
        names << asListed(row.machine);
    return names;
}

} // namespace palmer::ui
