// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/registeredtest.h"

#include "document/edits.h"
#include "document/filewords.h"
#include "document/writedocument.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/conditions.h"
#include "kernel/measurement/testfacts.h"
#include "kernel/uncertainty/circularbudget.h"
#include "kernel/uncertainty/positioningbudget.h"
#include "kernel/words/shortest.h"
#include "report/tables/summary.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <QCryptographicHash>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace palmer {

namespace {

constexpr double coverage = 2;

std::vector<const Instrument *> instrumentsOf(const Document &document, const Test &test) {
    std::vector<const Instrument *> result;
    for (const Instrument &instrument : document.instruments) {
        if (std::ranges::find(test.instruments, instrument.id) != test.instruments.end())
            result.push_back(&instrument);
    }
    return result;
}

TestPointer withoutImportedBytes(const Test &test) {
    auto copy = std::make_shared<Test>(test);
    for (ImportedFile &file : copy->imports)
        file.data.reset();
    return copy;
}

/// Returns a digest of all inputs of the evaluation of a test, and nothing else in its file.
QString digestOf(const Document &document, const Test &test, const QString &program) {
    Document part;
    part.machine = document.machine;
    for (const Instrument *instrument : instrumentsOf(document, test))
        part.instruments.push_back(*instrument);
    part.tests.push_back(withoutImportedBytes(test));
    if (const std::string *drift = driftTestOf(test)) {
        const auto found =
            std::ranges::find(document.tests, *drift, [](const TestPointer &t) { return t->id; });
        if (found != document.tests.end() && (*found)->id != test.id)
            part.tests.push_back(withoutImportedBytes(**found));
    }
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(program.toUtf8() + '\n');
    hash.addData(writeDocument(part));
    return QString::fromLatin1(hash.result().toHex());
}

/// Hash of the readings and their positions.
class Fingerprint {
public:
    void add(double value) {
        m_hash.addData(QByteArrayView(reinterpret_cast<const char *>(&value), sizeof value)); // NOLINT
    }
    void add(const std::vector<double> &values) {
        add(static_cast<double>(values.size()));
        for (const double value : values)
            add(value);
    }
    void add(const std::vector<std::optional<double>> &values) {
        for (const auto &value : values) {
            add(value ? 1.0 : 0.0);
            add(value.value_or(0));
        }
    }
    [[nodiscard]] QString result() const {
        constexpr qsizetype bytes = 16; // enough to distinguish readings
        return QString::fromLatin1(m_hash.result().first(bytes).toHex());
    }

private:
    QCryptographicHash m_hash{QCryptographicHash::Sha256};
};

void addReadings(Fingerprint &print, const PositioningMeasurement &m) {
    print.add(m.targets);
    for (const Run &run : m.runs) {
        print.add(run.approach == Direction::positive ? 1.0 : -1.0);
        print.add(run.deviations);
    }
}

void addReadings(Fingerprint &print, const CircularMeasurement &c) {
    print.add(c.nominalRadius);
    for (const Arc &arc : c.arcs) {
        print.add(arc.sense == Sense::clockwise ? 1.0 : -1.0);
        print.add(arc.angles);
        print.add(arc.radialDeviations);
    }
}

void addReadings(Fingerprint &print, const DriftMeasurement &drift) {
    print.add(drift.times);
    print.add(drift.deviations);
    for (const DriftChannel &channel : drift.channels)
        print.add(channel.values);
    for (const DriftTemperature &temperature : drift.temperatures)
        print.add(temperature.values);
}

QString fingerprintOf(const Test &test) {
    Fingerprint print;
    std::visit([&](const auto &measurement) { addReadings(print, measurement); }, test.measurement);
    return print.result();
}

/// Key of instruments that share a systematic error: device and certificate. Empty if unidentified.
std::string instrumentKey(const std::vector<const Instrument *> &instruments) {
    std::string key;
    for (const Instrument *instrument : instruments) {
        if (!instrument->serialNumber.empty())
            key += (key.empty() ? "" : "; ") + instrument->serialNumber +
                   (instrument->certificate.empty() ? "" : "/" + instrument->certificate);
    }
    return key;
}

/// The parts of U shared by tests, and their share in each result.
class Sharing {
public:
    Sharing(const Document &document, const Test &test, const TestEvaluation &evaluation,
            const QString &digest)
        : m_test(test)
        , m_evaluation(evaluation) {
        m_instrument = instrumentKey(instrumentsOf(document, test));
        m_known = !m_instrument.empty();
        if (!m_known) // only this test
            m_instrument = "? " + digest.left(16).toStdString();
        for (const Contribution &contribution : evaluation.uncertainty.contributions)
            addPart(contribution);
    }

    [[nodiscard]] std::vector<SharedPart> parts() const { return m_parts; }

    void share(RegisteredResult &result, const Parameter &parameter) {
        if (!parameter.expandedUncertainty)
            return;
        const double u = *parameter.expandedUncertainty / coverage;
        const auto whole = parameter.decidedBy == UncertaintyMethod::budgetActual
                               ? parameter.actualUncertainty
                               : parameter.budgetUncertainty;
        const bool hasParts = usesContributions(parameter.decidedBy) && whole && *whole > 0;
        if (!hasParts) {
            takeAsOne(result, u);
            return;
        }
        double squares = 0;
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            if (m_ids[i].empty() || !isIn(m_ids[i], parameter))
                continue;
            result.shared |= 1U << i;
            squares += m_parts[i].u * m_parts[i].u;
        }
        // If the simulated U differs from the budget, all parts are scaled alike.
        const double growth = *parameter.expandedUncertainty / *whole;
        double sharedWhole = squares;
        if (parameter.decidedBy == UncertaintyMethod::budgetActual && parameter.effectiveSystematic &&
            m_evaluation.uncertainty.systematic.value_or(0) > 0) {
            const double part = *parameter.effectiveSystematic / *m_evaluation.uncertainty.systematic;
            sharedWhole = squares * part * part;
        }
        const double budgeted = *whole / coverage;
        result.sharedFactor = squares > 0 ? growth * std::sqrt(sharedWhole / squares) : 1;
        result.own = growth * std::sqrt(std::max(0.0, budgeted * budgeted - sharedWhole));
    }

private:
    static constexpr std::size_t mostParts = 30; ///< bits of `shared`

    void add(const char *id, const std::string &source, double u) {
        if (m_parts.size() >= mostParts || u == 0)
            return;
        m_ids.emplace_back(id);
        m_parts.push_back({source, u});
    }

    [[nodiscard]] double signOf(SensorMeasures what) const {
        const Conditions *conditions = conditionsOf(m_test);
        const auto theta = conditions ? meanTemperature(*conditions, what) : std::nullopt;
        return theta && *theta < referenceTemperature ? -1 : 1;
    }

    /// Environmental variation, misalignment, repeatability, noise, resolution and centring are not shared:
    /// they are ignored here.
    void addPart(const Contribution &contribution) {
        const std::string_view id = contribution.id;
        const double u = contribution.expanded.value_or(0) / coverage;
        if (id == deviceId || id == displacementId || id == referenceLengthId)
            add(contribution.id, "device " + m_instrument, u);
        else if (id == "expansionMachine") // α of the machine: opposite sign below 20 °C
            add(contribution.id, "expansion of the machine", signOf(SensorMeasures::machine) * u);
        else if (id == "expansionInstrument")
            add(contribution.id, "expansion " + m_instrument, signOf(SensorMeasures::instrument) * u);
        else if (id == "temperatureMachine" || id == "temperatureInstrument")
            add(contribution.id, std::string(id) + ' ' + m_instrument, u);
        else if (id == correctionId)
            add(contribution.id, "correction " + m_instrument, signOf(SensorMeasures::machine) * u);
    }

    [[nodiscard]] bool isIn(const std::string &id, const Parameter &parameter) const {
        const auto *centring = partOr<const Centring *>(
            nullptr, m_test.measurement, [](auto &m) -> decltype(&m.centring) { return &m.centring; });
        if (centring)
            return takesUp(contributionsOf(parameter.term.circle, *centring), id);
        return parameter.effectiveSystematic.has_value(); // results that include S have an effective S
    }

    /// A U without separate parts: attributed to the instrument, known or not.
    void takeAsOne(RegisteredResult &result, double u) {
        result.withoutParts = true;
        const std::string source = m_known ? "device " + m_instrument : "an instrument";
        if (!m_whole) {
            if (m_parts.size() >= mostParts || u == 0) {
                result.own = u;
                return;
            }
            m_whole = m_parts.size();
            m_ids.emplace_back();
            m_parts.push_back({m_known ? "device " + m_instrument : "an instrument", 1}); // times u
        }
        result.shared = 1U << *m_whole;
        result.sharedFactor = u;
    }

    const Test &m_test;
    const TestEvaluation &m_evaluation;
    std::string m_instrument;
    bool m_known = false;
    std::vector<std::string> m_ids; ///< of the contributions; empty: a U without parts
    std::vector<SharedPart> m_parts;
    std::optional<std::size_t> m_whole; ///< the part representing a U without parts
};

std::string joined(std::initializer_list<std::string> words) {
    std::string result;
    for (const std::string &word : words) {
        if (!word.empty())
            result += (result.empty() ? "" : " ") + word;
    }
    return result;
}

/// "tool X 10 Z 120"; empty: nothing stated.
QString offsetText(const QString &property, const Point3 &point) {
    QString text;
    for (std::size_t i = 0; i < point.size(); ++i) {
        if (point.at(i))
            text += QStringLiteral(" %1 ").arg(QChar(static_cast<char16_t>(u'X' + i))) +
                    QString::fromStdString(shortest(*point.at(i)));
    }
    return text.isEmpty() ? text : property + text;
}

/// Properties and those that all tests have; `direction` of runs or arcs.
template <class Run, class Direction>
std::string setUpOf(QStringList properties, const Conditions &conditions, const std::vector<Run> &runs,
                    Direction Run::*direction) {
    const QString compensation = QString::fromStdString(conditions.compensation).simplified();
    if (!compensation.isEmpty())
        properties << QStringLiteral("compensation ") + QString(compensation).replace(u';', u',');
    const auto first = std::ranges::count(runs, Direction{}, direction);
    properties
        << offsetText(QStringLiteral("tool"), conditions.toolOffset)
        << offsetText(QStringLiteral("workpiece"), conditions.workpieceOffset)
        << QStringLiteral("runs %1 + %2").arg(first).arg(static_cast<std::ptrdiff_t>(runs.size()) - first);
    properties.removeAll(QString());
    return properties.join(QStringLiteral("; ")).toStdString();
}

void describe(RegisteredTest &result, const PositioningMeasurement &m, const PositioningResults &results) {
    if (m.conditions.feedMode != FeedMode::rapid)
        result.feed = m.conditions.feed;
    if (!m.targets.empty())
        result.travel = measurementTravel(m);
    result.setUp =
        setUpOf({m.conditions.feedMode == FeedMode::rapid ? QStringLiteral("rapid") : QString(),
                 m.cycle == Cycle::step ? QStringLiteral("step") : QString(),
                 m.zone ? QStringLiteral("zone ") + QString::fromStdString(shortText(*m.zone)) : QString()},
                m.conditions.common, m.runs, &Run::approach);
    const auto finite = [](double value) {
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    };
    for (std::size_t i = 0; i < std::min(m.targets.size(), results.targets.size()); ++i)
        result.curve.push_back({m.targets[i], finite(results.targets[i].positive.mean),
                                finite(results.targets[i].negative.mean)});
}

void describe(RegisteredTest &result, const CircularMeasurement &c, const CircularResults & /*results*/) {
    result.feed = c.feed;
    result.travel = c.nominalRadius;
    result.setUp = setUpOf({c.source == SignalSource::feedback ? QStringLiteral("feedback") : QString()},
                           c.conditions.common, c.arcs, &Arc::sense);
}

void describe(RegisteredTest & /*result*/, const Unjudged auto & /*measurement*/, const auto & /*results*/) {}

RegisteredResult resultOf(const Parameter &parameter, const DecisionRule &rule,
                          std::optional<double> resolution) {
    RegisteredResult result;
    result.id = parameterId(parameter);
    if (parameter.value && std::isfinite(*parameter.value))
        result.value = parameter.value;
    result.expandedUncertainty = parameter.expandedUncertainty;
    if (parameter.expandedUncertainty && parameter.decidedBy != UncertaintyMethod::monteCarlo)
        result.k = coverage;
    if (parameter.limit)
        result.limit = parameter.limit->value;
    result.guardBand = parameter.guardBand;
    result.bound = parameter.bound;
    result.verdict = parameter.verdict;
    const PrintedNumbers printed =
        printedNumbers(parameter, rule, resolution, Language(Language::Id::english));
    result.decimals = printed.decimals;
    result.uncertaintyDecimals = printed.uncertaintyDecimals;
    return result;
}

RegisteredTest registeredTest(const EvaluatedDocument &evaluated, std::size_t index, const QString &program) {
    const Document &document = *evaluated.document;
    const Test &test = *document.tests[index];
    const TestEvaluation &evaluation = *evaluated.tests[index];
    RegisteredTest result;
    result.digest = digestOf(document, test, program);
    result.fingerprint = fingerprintOf(test);
    result.machineName = document.machine.name;
    result.manufacturer = document.machine.manufacturer;
    result.model = document.machine.model;
    result.serialNumber = document.machine.serialNumber;
    result.location = document.machine.location;
    result.kind = kindOf(test);
    result.title = test.title;
    result.id = test.id;
    if (evaluation.edition)
        result.edition = evaluation.edition->word;
    result.axis = axesOf(test);
    result.angular = motionOf(test) == Motion::rotary;
    if (const Conditions *conditions = conditionsOf(test))
        result.correction = conditions->correctionTo20;
    withResults(test, evaluation, [&](const auto &measurement, const auto &results) {
        describe(result, measurement, results);
    });
    result.date = test.date;
    result.time = test.time;
    result.purpose = test.purpose;
    result.role = test.role;
    result.verdict = evaluation.verdict;
    result.rule = test.decisionRule.rule;
    result.accordance = evaluation.accordance();
    result.counts = countRequirements(evaluation.findings);
    result.awaitsSimulation = isSimulationDue(evaluated, index, SimulateWhich::monteCarloOnly);
    for (const Instrument *instrument : instrumentsOf(document, test))
        result.instruments.push_back(
            {joined({instrument->description, instrument->manufacturer, instrument->model}),
             instrument->serialNumber, instrument->certificate, instrument->calibrationDue});
    Sharing sharing(document, test, evaluation, result.digest);
    const std::optional<double> resolution = finestResolution(document, test);
    for (const Parameter &parameter : evaluation.parameters) {
        result.results.push_back(resultOf(parameter, test.decisionRule, resolution));
        sharing.share(result.results.back(), parameter);
    }
    result.parts = sharing.parts();
    return result;
}

} // namespace

std::vector<RegisteredTest> registeredTests(const EvaluatedDocument &evaluated, const QString &program) {
    std::vector<RegisteredTest> result;
    for (std::size_t i = 0; i < evaluated.tests.size(); ++i)
        result.push_back(registeredTest(evaluated, i, program));
    return result;
}

bool hasLimit(const RegisteredTest &test) {
    return std::ranges::any_of(test.results, [](const RegisteredResult &r) { return r.limit.has_value(); });
}

const RegisteredResult *resultOf(const RegisteredTest &test, const std::string &id) {
    const auto found = std::ranges::find(test.results, id, &RegisteredResult::id);
    return found == test.results.end() ? nullptr : &*found;
}

std::string quantityOf(const std::string &resultId) {
    return resultId.substr(0, resultId.find('_'));
}

} // namespace palmer
