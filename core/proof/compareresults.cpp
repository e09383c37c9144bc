// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/documenterror.h"
#include "document/json.h"
#include "proof/compare.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

using nlohmann::json;

constexpr std::size_t mostDifferences = 10'000;

QString textOf(const json &value) {
    constexpr qsizetype longest = 300;
    const QString text = value.is_string() ? QString::fromStdString(value.get<std::string>())
                                           : QString::fromStdString(compactJson(value));
    return text.size() > longest ? text.left(longest) + u'…' : text;
}

/// True if two numbers differ only by rounding, as sines, exponentials and sums (last digits) and fits to
/// many points (some 10⁻¹² relative) do on another processor: such a report is no forgery.
bool differInRounding(const json &printed, const json &follows) {
    if (!printed.is_number() || !follows.is_number())
        return false;
    constexpr double relative = 1e-9;
    constexpr double least = 1e-12; // mm and degrees: differences of pure rounding noise
    const auto a = printed.get<double>();
    const auto b = follows.get<double>();
    return std::abs(a - b) <= std::max(least, relative * std::max(std::abs(a), std::abs(b))) &&
           (printed.is_number_float() || follows.is_number_float());
}

class ResultsComparison {
public:
    explicit ResultsComparison(bool sameProgram)
        : m_sameProgram(sameProgram) {}

    void compare(const json &printed, const json &follows, const QString &path) {
        if (m_found.size() >= mostDifferences || printed == follows)
            return;
        if (differInRounding(printed, follows))
            m_rounded = true;
        else if (printed.is_object() && follows.is_object())
            compareObjects(printed, follows, path);
        else if (printed.is_array() && follows.is_array() && printed.size() == follows.size())
            compareArrays(printed, follows, path);
        else
            add(textOf(printed), textOf(follows), path);
    }

    [[nodiscard]] std::vector<Difference> take() { return std::move(m_found); }
    /// True if numbers differ, but only by rounding.
    [[nodiscard]] bool isRounded() const { return m_rounded; }

private:
    void add(const QString &printed, const QString &follows, const QString &path) {
        m_found.push_back({0, {}, printed, follows, QStringLiteral("results.json: ") + path, {}});
    }

    void compareObjects(const json &printed, const json &follows, const QString &path) {
        for (const auto &[key, value] : follows.items()) {
            const QString place = (path.isEmpty() ? path : path + u'.') + QString::fromStdString(key);
            if (!m_sameProgram && path.isEmpty() && key == "program")
                continue;
            if (const auto found = printed.find(key); found != printed.end())
                compare(*found, value, place);
            else if (m_sameProgram) // a newer program writes more keys
                add({}, textOf(value), place);
        }
        for (const auto &[key, value] : printed.items()) {
            if (!follows.contains(key))
                add(textOf(value), {}, (path.isEmpty() ? path : path + u'.') + QString::fromStdString(key));
        }
    }

    void compareArrays(const json &printed, const json &follows, const QString &path) {
        for (std::size_t i = 0; i < follows.size(); ++i)
            compare(printed[i], follows[i], path + u'[' + QString::number(i) + u']');
    }

    bool m_sameProgram;
    bool m_rounded = false;
    std::vector<Difference> m_found;
};

Difference said(Text what) {
    return {0, {}, {}, {}, {}, Message{what}};
}

} // namespace

std::vector<Difference> compareResults(const QByteArray &printed, const QByteArray &follows,
                                       bool sameProgram) {
    if (printed == follows)
        return {};
    if (printed.isEmpty())
        return {
            said(REPORT_TEXT("report", "the results (results.json) that the report carried are missing"))};
    try {
        const auto parsed = [](const QByteArray &bytes) {
            return parseJson({bytes.constData(), static_cast<std::size_t>(bytes.size())});
        };
        ResultsComparison comparison(sameProgram);
        comparison.compare(parsed(printed), parsed(follows), {});
        std::vector<Difference> found = comparison.take();
        if (found.empty() && sameProgram && !comparison.isRounded())
            return {said(REPORT_TEXT("report", "the results (results.json) are written in another form"))};
        return found;
    } catch (const Error &) {
        return {said(REPORT_TEXT("report", "the results (results.json) cannot be read"))};
    }
}

} // namespace palmer
