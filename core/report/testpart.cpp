#include "report/testpart.h"

#include "kernel/evaluation/correctionto20.h"
#include "report/wording.h"

#include <algorithm>

namespace palmer {

bool TestPart::leavesOut(ReportPart part) const {
    return std::ranges::find(head().leaveOut, part) != head().leaveOut.end();
}

QString TestPart::headAnchor() const {
    return QStringLiteral("test-") + QString::number(number);
}

QString TestPart::findingsAnchor() const {
    return QStringLiteral("findings-") + QString::number(number);
}

Quantity PositioningPart::along() const {
    return positionQuantity(measurement);
}

Quantity PositioningPart::deviation() const {
    return deviationQuantity(measurement);
}

bool CircularPart::asksFor(std::string_view quantity) const {
    return std::ranges::any_of(evaluation.parameters, [&](const Parameter &parameter) {
        return parameter.required && std::string_view(parameter.term.id).starts_with(quantity);
    });
}

bool CircularPart::needsLength() const {
    return !feedback() && (asksFor("F") || asksFor("D"));
}

bool CircularPart::holdsAt20() const {
    const Conditions &conditions = measurement.conditions.common;
    const auto isKnown = [&](SensorMeasures what) { return meanTemperature(conditions, what).has_value(); };
    return isCorrectedTo20(conditions) ||
           (!results.notCorrected && isKnown(SensorMeasures::machine) && isKnown(SensorMeasures::instrument));
}

QString CircularPart::plane() const {
    const std::string axes = measurement.plane.first + measurement.plane.second;
    return QString::fromStdString(axes.empty() ? "–" : axes);
}

QString testName(const Writer &write, const Test &test) {
    const auto nameOr = [](const std::string &name) {
        return QString::fromStdString(name.empty() ? "–" : name);
    };
    if (const auto *m = std::get_if<PositioningMeasurement>(&test.measurement))
        return write.say(REPORT_TEXT("report", "Positioning test of the %1 axis"), nameOr(m->axis.name));
    if (const auto *c = std::get_if<CircularMeasurement>(&test.measurement))
        return write.say(REPORT_TEXT("report", "Circular test in the %1 plane"),
                         nameOr(c->plane.first + c->plane.second));
    return write.say(REPORT_TEXT("report", "Drift test of the %1 axis"),
                     nameOr(std::get<DriftMeasurement>(test.measurement).axis.name));
}

QString joined(const QStringList &texts, const QString &separator) {
    QStringList filled;
    std::ranges::copy_if(texts, std::back_inserter(filled),
                         [](const QString &text) { return !text.isEmpty(); });
    return filled.join(separator);
}

QString partyText(const Party &party) {
    QString address = QString::fromStdString(party.address);
    return joined({QString::fromStdString(party.name), address.replace(u'\n', QStringLiteral(", "))});
}

void addHeading(std::vector<Block> &blocks, const QString &text, Phrase note, const QString &anchor) {
    blocks.emplace_back(Heading{2, text, std::move(note), anchor});
}

} // namespace palmer
