// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/trendfigure.h"

#include "figures/ticks.h"
#include "kernel/evaluation/conformity.h"
#include "register/listing.h"
#include "register/trendoutput.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

constexpr int bandSteps = 24;

double year(double time) {
    return calendarYear(dateOfYears(time));
}

class Panel {
public:
    Panel(const MachineTrend &trend, const TrendSpan &span, const QDate &today, const Language &language)
        : m_trend(trend)
        , m_span(span)
        , m_scale(unitScale(trendQuantity(trend), language.units()))
        , m_language(language) {
        m_panel.symbol = plainSymbolOf(trend.parameter);
        const std::size_t end = trend.parameter.find('_');
        if (end != std::string::npos)
            m_panel.y.subscript = QString::fromStdString(trend.parameter.substr(end + 1));
        m_panel.y.symbol = m_panel.symbol.chopped(m_panel.y.subscript.size());
        m_panel.statement = trendStatement(trend, language);
        m_panel.today = calendarYear(today);
        m_panel.y.unit = language.unit(trendQuantity(trend));
        m_panel.unitName = unitInWords(trend, language);
        m_panel.y.quantity = m_panel.symbol;
        m_panel.x.quantity = language.text(REPORT_TEXT("report", "Date"));
    }

    TrendPanel make(int mostTicks) {
        addSeries();
        addLimits();
        addInterventions();
        addLine();
        const double level = m_most != 0 ? 0.1 * std::abs(m_most) : 1; // for one value without U
        const double room = m_most > m_least ? 0.06 * (m_most - m_least) : level;
        const double bottom = m_least >= 0 ? std::max(0.0, m_least - room) : m_least - room;
        setRange(m_panel.y, bottom, m_most + room, 4, TickSteps::values, m_language);
        setRange(m_panel.x, m_span.from, m_span.to, mostTicks, TickSteps::values, m_language);
        m_panel.x.ticks.clear(); // years without digit grouping
        const double step = std::max(1.0, m_panel.x.step);
        for (int tick = static_cast<int>(std::ceil(m_span.from / step)); tick * step <= m_span.to; ++tick)
            m_panel.x.ticks.push_back({tick * step, QString::number(static_cast<int>(tick * step))});
        if (m_panel.x.ticks.empty())
            addMonths(mostTicks);
        return std::move(m_panel);
    }

private:
    /// Adds month ticks if no year begins in the span, as an axis needs a number.
    void addMonths(int mostTicks) {
        constexpr int monthsOfYear = 12;
        std::vector<Tick> months;
        const int last = static_cast<int>(std::ceil(m_span.to * monthsOfYear));
        for (int month = static_cast<int>(m_span.from * monthsOfYear); month <= last; ++month) {
            const QDate first(month / monthsOfYear, month % monthsOfYear + 1, 1);
            if (const double at = calendarYear(first); at >= m_span.from && at <= m_span.to)
                months.push_back({at, shortMonthText(first, m_language)});
        }
        const std::size_t most = static_cast<std::size_t>(std::max(1, mostTicks));
        const std::size_t step = (months.size() + most - 1) / most;
        for (std::size_t i = 0; i < months.size(); i += step)
            m_panel.x.ticks.push_back(months[i]);
    }

    void see(double value) {
        m_least = m_seen ? std::min(m_least, value) : value;
        m_most = m_seen ? std::max(m_most, value) : value;
        m_seen = true;
    }

    void addSeries() {
        for (std::size_t i = 0; i < m_trend.series.size(); ++i) {
            const TrendEntry *before = nullptr;
            for (const TrendEntry &entry : m_trend.series[i].entries) {
                TrendValue value{calendarYear(dateOf(entry.date)), *entry.result.value * m_scale};
                if (entry.result.expandedUncertainty)
                    value.expanded = *entry.result.expandedUncertainty * m_scale;
                value.mark = i > 0                               ? TrendMark::otherSeries
                             : entry.role == TestRole::asLeft    ? TrendMark::asLeft
                             : entry.role == TestRole::notStated ? TrendMark::noRole
                                                                 : TrendMark::asFound;
                value.exceeds = entry.result.verdict == Verdict::doesNotConform;
                see(value.y + value.expanded.value_or(0));
                see(value.y - value.expanded.value_or(0));
                const bool joins =
                    i == 0 && before && before->stretch == entry.stretch && before->role == entry.role;
                if (joins)
                    m_panel.joined.push_back(
                        {{m_panel.values.back().x, m_panel.values.back().y}, {value.x, value.y}});
                m_panel.values.push_back(value);
                before = &entry;
            }
        }
    }

    /// Limits hold from their test on, the first one from the beginning.
    void addLimits() {
        std::vector<const TrendEntry *> all;
        for (const TrendSeries &series : m_trend.series) {
            for (const TrendEntry &entry : series.entries)
                all.push_back(&entry);
        }
        std::ranges::stable_sort(all, {}, &TrendEntry::time);
        std::vector<QPointF> steps;
        for (const TrendEntry *entry : all) {
            const double at =
                steps.empty() && entry == all.front() ? m_span.from : calendarYear(dateOf(entry->date));
            if (!entry->result.limit) {
                endLimit(steps, at);
                continue;
            }
            const double limit = *entry->result.limit * m_scale;
            see(limit);
            if (steps.empty()) {
                steps.emplace_back(at, limit);
            } else if (steps.back().y() != limit) {
                steps.emplace_back(at, steps.back().y());
                steps.emplace_back(at, limit);
            }
        }
        endLimit(steps, m_span.to);
    }

    void endLimit(std::vector<QPointF> &steps, double at) {
        if (steps.empty())
            return;
        steps.emplace_back(at, steps.back().y());
        m_panel.limits.push_back(std::move(steps));
        steps.clear();
    }

    void addInterventions() {
        for (const Intervention &one : m_trend.interventions) {
            TrendIntervention drawn{calendarYear(dateOf(one.date)), interventionName(one.kind, m_language)};
            if (one.fromFoundToLeft && !m_trend.series.empty())
                addArrow(drawn, one);
            m_panel.interventions.push_back(std::move(drawn));
        }
    }

    void addArrow(TrendIntervention &drawn, const Intervention &one) const {
        const std::vector<TrendEntry> &entries = m_trend.series.front().entries;
        const auto left = std::ranges::find(entries, one.date, &TrendEntry::date);
        for (auto entry = left; entry != entries.end() && entry->date == one.date; ++entry) {
            if (entry->role != TestRole::asLeft || entry == entries.begin())
                continue;
            const TrendEntry &found = *std::prev(entry);
            drawn.found = QPointF(calendarYear(dateOf(found.date)), *found.result.value * m_scale);
            drawn.left = QPointF(calendarYear(dateOf(entry->date)), *entry->result.value * m_scale);
            return;
        }
    }

    void addLine() {
        if (!m_trend.line || !m_trend.line->isShown())
            return;
        const TrendLine &line = *m_trend.line;
        const double end = trendHorizon(line);
        const auto place = [&](double time) { return QPointF(year(time), line.at(time) * m_scale); };
        for (int i = 0; i <= bandSteps; ++i) {
            const double time = line.first + (end - line.first) * i / bandSteps;
            const double away = line.oneSided * line.uncertaintyAt(time);
            const BandPoint point{year(time), (line.at(time) - away) * m_scale,
                                  (line.at(time) + away) * m_scale};
            if (point.x <= m_span.to)
                m_panel.band.push_back(point);
        }
        m_panel.line = {place(line.first), place(line.last)};
        m_panel.later = {place(line.last), place(end)};
        see(m_panel.later.back().y());
        if (m_trend.notBefore.state == NotBefore::State::date && m_trend.limit) {
            const double sign = m_trend.bound != Bound::upper && line.at(m_trend.notBefore.time) < 0 ? -1 : 1;
            const double limit = m_trend.bound == Bound::lower ? *m_trend.limit : sign * *m_trend.limit;
            m_panel.notBefore = QPointF(year(m_trend.notBefore.time), limit * m_scale);
        }
    }

    const MachineTrend &m_trend;
    TrendSpan m_span;
    double m_scale;
    const Language &m_language;
    TrendPanel m_panel;
    bool m_seen = false;
    double m_least = 0;
    double m_most = 1;
};

} // namespace

double calendarYear(const QDate &date) {
    return date.year() + (date.dayOfYear() - 1.0) / date.daysInYear();
}

TrendSpan trendSpan(const std::vector<MachineTrend> &trends, const QDate &today) {
    constexpr double margin = 0.03;
    double first = calendarYear(today);
    double last = first;
    for (const MachineTrend &trend : trends) {
        for (const TrendSeries &series : trend.series) {
            for (const TrendEntry &entry : series.entries) {
                first = std::min(first, calendarYear(dateOf(entry.date)));
                last = std::max(last, calendarYear(dateOf(entry.date)));
            }
        }
        if (trend.line && trend.line->isShown())
            last = std::max(last, year(trendHorizon(*trend.line)));
    }
    const double room = std::max(margin * (last - first), 0.1);
    return {first - room, last + room};
}

TrendPanel trendPanel(const MachineTrend &trend, const TrendSpan &span, const QDate &today,
                      const Language &language, int mostTicks) {
    return Panel(trend, span, today, language).make(mostTicks);
}

TrendPanel smallTrendPanel(const MachineTrend &trend, const TrendSpan &span, const QDate &today,
                           const Language &language) {
    constexpr int mostTicks = 5;
    TrendPanel panel = trendPanel(trend, span, today, language, mostTicks);
    panel.statement = shortTrendStatement(trend, language);
    return panel;
}

TrendFigure trendFigure(const QString &title, const MachineTrend &trend, const QDate &today,
                        const Language &language) {
    constexpr int mostTicks = 12;
    QStringList notes{editionOf(trend), otherSeries(trend, language)};
    notes.removeAll(QString());
    return {title,
            {},
            notes.join(QStringLiteral(" · ")),
            {trendPanel(trend, trendSpan({trend}, today), today, language, mostTicks)},
            trendLegend(language, {trend})};
}

std::vector<TrendLegendEntry> trendLegend(const Language &language, const std::vector<MachineTrend> &trends) {
    const auto inAny = [&trends](auto has) { return std::ranges::any_of(trends, has); };
    const auto hasEntry = [&](auto is) {
        return inAny([&](const MachineTrend &trend) {
            return !trend.series.empty() && std::ranges::any_of(trend.series.front().entries, is);
        });
    };
    const auto hasRole = [&](TestRole role) {
        return hasEntry([role](const TrendEntry &entry) { return entry.role == role; });
    };
    struct Possible {
        TrendSign sign{};
        Text text;
        bool occurs = false;
    };
    const std::array rows{
        Possible{TrendSign::asFound, REPORT_TEXT("report", "as found; bar: ± U"), hasRole(TestRole::asFound)},
        Possible{TrendSign::asLeft, REPORT_TEXT("report", "as left"), hasRole(TestRole::asLeft)},
        Possible{TrendSign::noRole, REPORT_TEXT("report", "role not stated"), hasRole(TestRole::notStated)},
        Possible{TrendSign::otherSeries, REPORT_TEXT("report", "another series, not joined"),
                 inAny([](const MachineTrend &trend) { return trend.series.size() > 1; })},
        Possible{TrendSign::limit, REPORT_TEXT("report", "agreed limit"),
                 inAny([](const MachineTrend &trend) {
                     return std::ranges::any_of(trend.series, [](const TrendSeries &series) {
                         return std::ranges::any_of(series.entries, [](const TrendEntry &entry) {
                             return entry.result.limit.has_value();
                         });
                     });
                 })},
        Possible{TrendSign::line, REPORT_TEXT("report", "line, bounds of 95 %"),
                 inAny([](const MachineTrend &trend) { return trend.line && trend.line->isShown(); })},
        Possible{TrendSign::intervention, REPORT_TEXT("report", "intervention"),
                 inAny([](const MachineTrend &trend) { return !trend.interventions.empty(); })}};
    std::vector<TrendLegendEntry> legend;
    for (const Possible &row : rows) {
        if (row.occurs)
            legend.push_back({row.sign, language.text(row.text)});
    }
    return legend;
}

} // namespace palmer
