// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/machinetrend.h"

#include "kernel/measurement/testfacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace palmer {

namespace {

constexpr double daysOfYear = 365.25;

bool hasValue(const RegisteredTest &test, const std::string &id) {
    const RegisteredResult *result = resultOf(test, id);
    return result && result->value;
}

bool isClose(std::optional<double> a, std::optional<double> b, double tolerance) {
    if (!a || !b)
        return a.has_value() == b.has_value();
    return std::abs(*a - *b) <= tolerance * std::max(std::abs(*a), std::abs(*b));
}

QStringList propertiesOf(const std::string &setUp) {
    return QString::fromStdString(setUp).split(QStringLiteral("; "), Qt::SkipEmptyParts);
}

/// Returns the properties that a set-up has and `first` lacks, and the names of those it does not have at
/// all.
QStringList differingProperties(const std::string &first, const std::string &setUp) {
    if (first == setUp)
        return {};
    const QStringList mine = propertiesOf(setUp);
    const QStringList others = propertiesOf(first);
    QStringList result = mine;
    result.removeIf([&](const QString &property) { return others.contains(property); });
    for (const QString &property : others) {
        const QString name = property.section(u' ', 0, 0);
        if (std::ranges::none_of(mine, [&](const QString &one) { return one.section(u' ', 0, 0) == name; }))
            result << name + QStringLiteral(" –");
    }
    return result;
}

std::optional<InterventionKind> kindBefore(const RegisteredTest &test, const RegisteredTest *before) {
    if (test.purpose == Purpose::afterRepair)
        return InterventionKind::repair;
    if (test.purpose == Purpose::afterCollision)
        return InterventionKind::collision;
    const bool foundToLeft = before && before->role == TestRole::asFound && test.role == TestRole::asLeft;
    // A test as found with the purpose compensation precedes the compensation.
    const bool compensated =
        (test.purpose == Purpose::compensation && test.role != TestRole::asFound) ||
        (before && before->purpose == Purpose::compensation && before->role == TestRole::asFound);
    if (compensated)
        return InterventionKind::compensation;
    return foundToLeft ? std::optional(InterventionKind::adjustment) : std::nullopt;
}

/// True for a repetition on the same day, which belongs to the same intervention.
bool isRepeated(const RegisteredTest &test, const RegisteredTest *before) {
    return before && before->date == test.date && before->purpose == test.purpose &&
           before->role == test.role;
}

/// Returns only the newest of several tests with the same readings.
std::vector<const ListedTest *> newestOfReadings(const std::vector<ListedTest> &tests, int &left) {
    std::set<QString> seen;
    std::vector<const ListedTest *> result;
    for (auto test = tests.rbegin(); test != tests.rend(); ++test) {
        if (seen.insert(test->test.fingerprint).second)
            result.push_back(&*test);
        else
            ++left;
    }
    std::ranges::reverse(result);
    return result;
}

class Maker {
public:
    Maker(const std::vector<ListedTest> &tests, const std::string &parameter) {
        m_trend.parameter = parameter;
        std::vector<ListedTest> dated;
        for (const ListedTest &test : tests) {
            if (!traitsOf(test.test.kind).isJudged)
                continue;
            if (test.test.date && dateOf(*test.test.date).isValid())
                dated.push_back(test);
            else
                m_trend.withoutDate += hasValue(test.test, parameter) ? 1 : 0;
        }
        m_dated = std::move(dated);
    }

    MachineTrend make() {
        const std::vector<const ListedTest *> list = newestOfReadings(m_dated, m_trend.sameReadings);
        std::vector<std::size_t> stretches;
        const RegisteredTest *before = nullptr;
        for (const ListedTest *test : list) {
            addIntervention(test->test, before);
            stretches.push_back(m_trend.interventions.size());
            before = &test->test;
        }
        for (std::size_t i = list.size(); i-- > 0;) // the newest test names its series
            addEntry(*list[i], stretches[i]);
        for (TrendSeries &series : m_trend.series)
            std::ranges::reverse(series.entries);
        if (!m_trend.series.empty())
            fit(m_trend.series.front());
        return std::move(m_trend);
    }

private:
    void addIntervention(const RegisteredTest &test, const RegisteredTest *before) {
        const auto kind = kindBefore(test, before);
        if (!kind || isRepeated(test, before))
            return;
        const bool foundToLeft = before && before->role == TestRole::asFound && test.role == TestRole::asLeft;
        m_trend.interventions.push_back({*kind, *test.date, yearsOf(dateOf(*test.date)), foundToLeft});
    }

    void addEntry(const ListedTest &listed, std::size_t stretch) {
        const RegisteredTest &test = listed.test;
        if (!hasValue(test, m_trend.parameter))
            return;
        if (m_trend.series.empty()) {
            m_trend.kind = test.kind;
            m_trend.angular = test.angular;
        }
        auto series = std::ranges::find_if(
            m_trend.series, [&](const TrendSeries &one) { return !differenceOf(one, test).any(); });
        if (series == m_trend.series.end()) {
            TrendSeries fresh{test.edition, test.feed, test.travel, test.correction, test.setUp, {}, {}};
            if (!m_trend.series.empty())
                fresh.difference = differenceOf(m_trend.series.front(), test);
            m_trend.series.push_back(std::move(fresh));
            series = std::prev(m_trend.series.end());
        }
        TrendEntry entry;
        entry.date = *test.date;
        entry.time = yearsOf(dateOf(*test.date));
        entry.result = *resultOf(test, m_trend.parameter);
        entry.role = test.role;
        entry.purpose = test.purpose;
        entry.rule = test.rule;
        entry.file = listed.places.empty() ? QString() : listed.places.front().path;
        entry.test = listed.places.empty() ? 1 : listed.places.front().test;
        entry.digest = test.digest;
        entry.sinceLast = listed.sinceLast;
        entry.stretch = stretch;
        for (std::size_t i = 0; i < test.parts.size(); ++i) {
            if ((entry.result.shared >> i & 1U) != 0)
                entry.shared.push_back({test.parts[i].source, test.parts[i].u * entry.result.sharedFactor});
        }
        series->entries.push_back(std::move(entry));
    }

    void fit(const TrendSeries &series) {
        const std::size_t stretch = m_trend.interventions.size();
        std::vector<TrendPoint> points;
        for (const TrendEntry &entry : series.entries) {
            if (entry.stretch != stretch)
                continue;
            if (points.empty())
                m_trend.since = entry.date;
            points.push_back({entry.time, *entry.result.value, entry.result.own, entry.shared});
            m_trend.withoutParts = m_trend.withoutParts || entry.result.withoutParts;
        }
        m_trend.count = points.size();
        const TrendEntry &newest = series.entries.back();
        m_trend.limit = newest.result.limit;
        m_trend.bound = newest.result.bound;
        const bool hasToProve = newest.rule == Rule::iso14253_1;
        if (hasToProve)
            m_trend.reserve = newest.result.guardBand.value_or(0);
        m_trend.line = trendLine(points);
        if (!m_trend.line || (hasToProve && !newest.result.guardBand))
            return;
        TrendLimits limits;
        if (m_trend.limit && m_trend.bound != Bound::lower)
            limits.upper = m_trend.limit;
        if (m_trend.limit && m_trend.bound != Bound::upper)
            limits.lower = m_trend.bound == Bound::lower ? *m_trend.limit : -*m_trend.limit;
        m_trend.notBefore = notBefore(*m_trend.line, limits, m_trend.reserve);
    }

    std::vector<ListedTest> m_dated;
    MachineTrend m_trend;
};

} // namespace

SeriesDifference differenceOf(const TrendSeries &series, const RegisteredTest &test) {
    constexpr double sameFeed = 1e-6;
    const double sameTravel = traitsOf(test.kind).isOfAxis ? travelTolerance : radiusTolerance;
    return {series.edition != test.edition, !isClose(series.feed, test.feed, sameFeed),
            !isClose(series.travel, test.travel, sameTravel), series.correction != test.correction,
            differingProperties(series.setUp, test.setUp)};
}

MachineTrend machineTrend(const std::vector<ListedTest> &tests, const std::string &parameter) {
    return Maker(tests, parameter).make();
}

std::vector<std::string> parametersOf(const std::vector<ListedTest> &tests) {
    std::vector<std::string> result;
    const auto add = [&result](const std::string &id) {
        if (std::ranges::find(result, id) == result.end())
            result.push_back(id);
    };
    for (const char *id : {"A", "E", "R", "M", "B"}) {
        for (const ListedTest &test : tests) {
            if (hasValue(test.test, id))
                add(id);
        }
    }
    for (auto test = tests.rbegin(); test != tests.rend(); ++test) {
        for (const RegisteredResult &one : test->test.results) {
            if (one.value)
                add(one.id);
        }
    }
    return result;
}

std::vector<std::string> mainParametersOf(const std::vector<ListedTest> &tests) {
    constexpr std::size_t most = 4;
    const std::vector<std::string> all = parametersOf(tests);
    const auto has = [&all](const char *id) { return std::ranges::find(all, id) != all.end(); };
    std::vector<std::string> result;
    constexpr std::array<std::array<const char *, 3>, 4> ofAxes{
        {{"A", "A+", "A-"}, {"E", "E+", "E-"}, {"R", "R+", "R-"}, {"B", "Bmean", "P"}}};
    for (const auto &choice : ofAxes) {
        const auto found = std::ranges::find_if(choice, has);
        if (found != choice.end())
            result.emplace_back(*found);
    }
    for (const std::string &id : all) {
        const std::string quantity = quantityOf(id);
        const bool ofCircles = quantity == "G(b)" || quantity == "G" || quantity == "D" || quantity == "H";
        if (result.size() < most && ofCircles && std::ranges::find(result, id) == result.end())
            result.push_back(id);
    }
    for (const std::string &id : all) {
        if (result.empty())
            result.push_back(id);
    }
    return result;
}

QDate dateOf(const std::string &iso) {
    return QDate::fromString(QString::fromStdString(iso), Qt::ISODate);
}

double yearsOf(const QDate &date) {
    return static_cast<double>(QDate(2000, 1, 1).daysTo(date)) / daysOfYear;
}

QDate dateOfYears(double years) {
    constexpr double rounding = 1e-6; // of a day
    return QDate(2000, 1, 1).addDays(static_cast<qint64>(std::floor(years * daysOfYear + rounding)));
}

} // namespace palmer
