// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/keptdocument.h"

#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <memory>
#include <type_traits>
#include <variant>

namespace palmer {

namespace {

/// Calls `use` with each long column of readings of a test, in order.
template <class AnyTest, class Use>
void forEachColumn(AnyTest &test, Use use) {
    std::visit(
        [&](auto &measurement) {
            if constexpr (requires { measurement.runs; }) {
                use(measurement.targets);
                for (auto &run : measurement.runs)
                    use(run.deviations);
            } else if constexpr (requires { measurement.arcs; }) {
                for (auto &arc : measurement.arcs) {
                    use(arc.angles);
                    use(arc.radialDeviations);
                }
            } else if constexpr (requires { measurement.times; }) {
                use(measurement.times);
                use(measurement.deviations);
            }
        },
        test.measurement);
}

/// A column of readings that may be missing, or of numbers.
using AnyColumn = std::variant<const std::vector<std::optional<double>> *, const std::vector<double> *>;

std::vector<AnyColumn> columnsOf(const Test &test) {
    std::vector<AnyColumn> columns;
    forEachColumn(test, [&](const auto &column) { columns.emplace_back(&column); });
    return columns;
}

using OwnCells = std::vector<std::pair<std::size_t, std::optional<double>>>;

constexpr std::size_t sizeOfColumn = 5; ///< memory of a column that refers to the other test, in readings

/// The cells that differ; null if they are more than an eighth.
std::optional<OwnCells> ownCells(const AnyColumn &column, const AnyColumn &other) {
    return std::visit(
        [&](const auto *cells) -> std::optional<OwnCells> {
            const auto *const *others = std::get_if<decltype(cells)>(&other);
            if (!others || (*others)->size() != cells->size())
                return {};
            OwnCells own;
            for (std::size_t i = 0; i < cells->size(); ++i) {
                if ((*cells)[i] == (**others)[i])
                    continue;
                if (own.size() >= cells->size() / 8)
                    return {};
                own.emplace_back(i, (*cells)[i]);
            }
            return own;
        },
        column);
}

} // namespace

KeptDocument::KeptDocument(const Document &document, const Document &beside, std::size_t least)
    : m_rest(document) {
    m_rest.tests.clear();
    for (std::size_t i = 0; i < document.tests.size(); ++i)
        m_parts.push_back(part(document, i, beside, least));
}

KeptDocument::Part KeptDocument::part(const Document &document, std::size_t index, const Document &beside,
                                      std::size_t least) {
    const TestPointer &test = document.tests[index];
    if (const auto shared = std::ranges::find(beside.tests, test); shared != beside.tests.end())
        return {{}, static_cast<std::size_t>(shared - beside.tests.begin()), {}};
    const std::size_t readings = readingsOf(*test);
    if (readings < least)
        return {test, 0, {}};
    // Tests are compared only at the same index, as a document is edited one test at a time.
    std::vector<std::optional<Column>> found;
    std::size_t kept = readings;
    if (document.tests.size() == beside.tests.size()) {
        const auto columns = columnsOf(*test);
        const auto others = columnsOf(*beside.tests[index]);
        kept = 0;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            // The same column, or the one shifted by inserting or removing a run or arc before it.
            const std::size_t moved = i + others.size() - columns.size();
            found.emplace_back();
            for (const std::size_t from : {i, moved}) {
                if (found.back() || from >= others.size())
                    continue;
                if (auto own = ownCells(columns[i], others[from]))
                    found.back() = Column{from, std::move(*own)};
            }
            const std::size_t size =
                std::visit([](const auto *column) { return column->size(); }, columns[i]);
            kept += found.back() ? found.back()->own.size() : size;
        }
    }
    kept += found.size() * sizeOfColumn;
    if (2 * kept > readings) {
        m_readings += readings;
        return {test, 0, {}};
    }
    m_readings += kept;
    auto light = std::make_shared<Test>(*test);
    std::size_t i = 0;
    forEachColumn(*light, [&](auto &column) {
        if (found[i++])
            std::remove_reference_t<decltype(column)>().swap(column);
    });
    return {std::move(light), index, std::move(found)};
}

Document KeptDocument::with(const Document &beside) const {
    Document document = m_rest;
    for (const Part &part : m_parts) {
        if (!part.test || part.columns.empty()) {
            document.tests.push_back(part.test ? part.test : beside.tests[part.beside]);
            continue;
        }
        auto test = std::make_shared<Test>(*part.test);
        const auto others = columnsOf(*beside.tests[part.beside]);
        std::size_t i = 0;
        forEachColumn(*test, [&]<class Cell>(std::vector<Cell> &column) {
            const auto &kept = part.columns[i++];
            if (!kept)
                return;
            column = *std::get<const std::vector<Cell> *>(others[kept->from]);
            for (const auto &[place, value] : kept->own) {
                if constexpr (std::is_same_v<Cell, double>)
                    column[place] = *value;
                else
                    column[place] = value;
            }
        });
        document.tests.push_back(std::move(test));
    }
    return document;
}

} // namespace palmer
