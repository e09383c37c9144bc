// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/impossiblevalues.h"

#include "document/bounds.h"
#include "document/fieldpath.h"
#include "document/fields.h"
#include "document/place.h"
#include "document/statedthings.h"
#include "kernel/uncertainty/inputs.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace palmer {

namespace {

constexpr Text expectedAscending = REPORT_TEXT("report", "expected times that ascend");

/// Names of values whose key is not the name of a stated thing. Paths are without indices.
struct NamedField {
    std::string_view path;
    Text name;
};
constexpr std::array namedFields{
    NamedField{"conditions.expansion.machine",
               REPORT_TEXT("report", "coefficient of thermal expansion of the machine")},
    NamedField{"conditions.expansion.instrument",
               REPORT_TEXT("report", "coefficient of thermal expansion of the instrument")},
    NamedField{"targetChoice.interval", REPORT_TEXT("report", "Nominal interval")},
    NamedField{"targetChoice.period", REPORT_TEXT("report", "Period of the error")},
    NamedField{"referenceLength.expandedUncertainty", inputs::referenceLength},
    NamedField{"uncertainty.device.fixed", inputs::fixedPart},
    NamedField{"uncertainty.device.perMetre", inputs::perMetre},
    NamedField{"uncertainty.misalignmentRange", inputs::misalignment},
    NamedField{"uncertainty.temperatureRange.machine", inputs::thetaRangeMachine},
    NamedField{"uncertainty.temperatureRange.instrument", inputs::thetaRangeInstrument},
    NamedField{"uncertainty.expansionRange.machine", inputs::alphaRangeMachine},
    NamedField{"uncertainty.expansionRange.instrument", inputs::alphaRangeInstrument},
    NamedField{"uncertainty.environmentalVariation", inputs::environment},
    NamedField{"uncertainty.displacement.expanded", inputs::displacement},
    NamedField{"uncertainty.resolution", REPORT_TEXT("report", "resolution of the instrument")},
    NamedField{"uncertainty.pointNoise", inputs::pointNoise},
    NamedField{"uncertainty.centring", inputs::centring},
    NamedField{"uncertainty.temperatureStandardUncertainty.machine", inputs::thetaOfMachine},
    NamedField{"uncertainty.temperatureStandardUncertainty.instrument", inputs::thetaOfInstrument},
    NamedField{"uncertainty.expansionStandardUncertainty.machine", inputs::alphaOfMachine},
    NamedField{"uncertainty.expansionStandardUncertainty.instrument", inputs::alphaOfInstrument},
};

std::string withoutIndices(std::span<const FieldStep> steps) {
    std::string path;
    for (const FieldStep &step : steps) {
        if (!step.index)
            path += (path.empty() ? "" : ".") + step.key;
    }
    return path;
}

Text nameOf(std::span<const FieldStep> steps, FileUnit unit) {
    const std::string path = withoutIndices(steps);
    if (path == "agreedPoints.value")
        return unit == FileUnit::feed ? REPORT_TEXT("report", "agreed feed")
                                      : REPORT_TEXT("report", "agreed limit of the temperature gradient");
    const auto named = std::ranges::find(namedFields, path, &NamedField::path);
    if (named != namedFields.end())
        return named->name;
    const StatedThing *thing = statedThing(steps.back().key);
    return thing ? thing->name : Text{};
}

Subject subjectOf(std::string_view path) {
    if (path.starts_with("uncertainty.") || path.starts_with("referenceLength."))
        return Subject::uncertainty;
    if (path.starts_with("agreedPoints["))
        return Subject::agreedPoints;
    return path.starts_with("times[") ? Subject::readings : Subject::conditions;
}

Finding findingAt(const std::string &place, Message message) {
    Finding finding;
    finding.id = "impossibleValue";
    finding.keys = {place};
    finding.subject = subjectOf(place);
    finding.message = std::move(message);
    return finding;
}

/// Visits the fields of a test; the functions for values are members because they call each other.
class ImpossibleFinder {
public:
    ImpossibleFinder(Motion motion, std::vector<ImpossibleValue> &found, const Place &place,
                     unsigned inherited = nothing)
        : m_motion(motion)
        , m_found(found)
        , m_place(place)
        , m_inherited(inherited) {}

    template <class T>
    void operator()(const char *key, const T &member, unsigned demands = nothing) {
        check(member, Place(m_place, key), demandsIn(m_inherited, demands));
    }
    void object(const char *key, const auto &members) {
        const Place place(m_place, key);
        ImpossibleFinder finder(m_motion, m_found, place);
        members(finder);
    }
    void extensions(const char * /*key*/, const std::string & /*text*/) {}

private:
    template <class T>
    void check(const T &value, const Place &place, unsigned demands) {
        if constexpr (std::is_class_v<T>) {
            ImpossibleFinder finder(m_motion, m_found, place, demands);
            fields(finder, value);
        } else if constexpr (std::is_same_v<T, double>) {
            checkNumber(value, place, demands);
        }
    }
    void check(const std::string & /*text*/, const Place & /*place*/, unsigned /*demands*/) {}
    void check(const Point3 & /*point*/, const Place & /*place*/, unsigned /*demands*/) {}
    template <class T>
    void check(const std::optional<T> &value, const Place &place, unsigned demands) {
        if (value)
            check(*value, place, demands);
    }
    template <class T>
    void check(const std::vector<T> &values, const Place &place, unsigned demands) {
        if constexpr (std::is_same_v<T, double>) {
            if ((demands & ascending) != 0)
                checkTimes(values, place);
        } else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::optional<double>>) {
            for (std::size_t i = 0; i < values.size(); ++i)
                check(values[i], Place(place, i), demands);
        }
    }
    template <class T>
    void check(const std::map<std::string, T> &values, const Place &place, unsigned demands) {
        for (const auto &[key, value] : values)
            check(value, Place(place, key), demands);
    }

    void checkNumber(double value, const Place &place, unsigned demands) {
        const auto expected = (demands & questioned) != 0 ? expectedInstead(value, demands) : std::nullopt;
        if (!expected)
            return;
        const std::string path = place.text();
        const FileUnit unit = fileUnitOf(demands);
        const Text name = nameOf(stepsOf(path), unit);
        m_found.push_back({path, value, *expected,
                           findingAt(path, {REPORT_TEXT("report", "Impossible value for “%1”: %2."),
                                            {name, Number{value, quantityOf(unit, m_motion)}}})});
    }

    void checkTimes(const std::vector<double> &times, const Place &place) {
        const auto fallen = std::ranges::is_sorted_until(times);
        if (fallen == times.end())
            return;
        const std::string path = Place(place, static_cast<std::size_t>(fallen - times.begin())).text();
        const Number before{*std::prev(fallen), Quantity::time};
        const Number after{*fallen, Quantity::time};
        const auto steps = stepsOf(path);
        const auto sensor =
            std::ranges::find_if(steps, [](const FieldStep &step) { return step.index.has_value(); });
        Message message =
            steps.front().key == "times"
                ? Message{REPORT_TEXT("report",
                                      "Impossible value: the times of the drift test fall from %1 to %2."),
                          {before, after}}
                : Message{REPORT_TEXT("report", "Impossible value: the times of the temperatures of sensor "
                                                "%3 fall from %1 to %2."),
                          {before, after, wholeNumber(sensor->index.value() + 1)}};
        m_found.push_back({path, *fallen, expectedAscending, findingAt(path, std::move(message))});
    }

    Motion m_motion;
    std::vector<ImpossibleValue> &m_found;
    const Place &m_place;
    unsigned m_inherited;
};

} // namespace

std::vector<ImpossibleValue> impossibleValues(const Test &test) {
    std::vector<ImpossibleValue> found;
    const Place root;
    ImpossibleFinder finder(motionOf(test), found, root);
    fields(finder, test);
    return found;
}

std::vector<Finding> findImpossible(const Test &test) {
    std::vector<Finding> findings;
    for (ImpossibleValue &impossible : impossibleValues(test))
        findings.push_back(std::move(impossible.finding));
    return findings;
}

} // namespace palmer
