// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/uncertainty/uncertaintypage.h"

#include "editing/typicalvalues.h"
#include "figures/testfigures.h"
#include "kernel/evaluation/decideuncertainty.h"
#include "kernel/uncertainty/circularbudget.h"
#include "kernel/uncertainty/positioningbudget.h"
#include "language/decimals.h"
#include "language/rounding.h"
#include "report/parts/parts.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"
#include "ui/elidedlabel.h"
#include "ui/figures/figurecard.h"
#include "ui/forms/decisionrulemembers.h"
#include "ui/madewidgets.h"
#include "ui/model/editname.h"
#include "ui/rowtable.h"
#include "ui/theme.h"
#include "ui/uncertainty/simulationrow.h"

#include <QApplication>
#include <QButtonGroup>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

constexpr const char *context = "palmer::ui::UncertaintyPage";
constexpr int figureHeight = 210;
constexpr std::array methods{UncertaintyMethod::budget, UncertaintyMethod::budgetActual,
                             UncertaintyMethod::monteCarlo, UncertaintyMethod::direct,
                             UncertaintyMethod::none};

namespace contributionColumn {
enum { name, calculation, size, expanded, count };
}
namespace resultColumn {
enum { symbol, budget, actual, simulation, interval, distribution, shift, difference, count };
}

template <auto... members>
auto positioning() {
    return ofMeasurement<PositioningMeasurement, &PositioningMeasurement::uncertainty, members...>();
}

template <auto... members>
auto circular() {
    return ofMeasurement<CircularMeasurement, &CircularMeasurement::uncertainty, members...>();
}

template <auto member>
auto length() {
    return ofMeasurement<CircularMeasurement, &CircularMeasurement::referenceLength, member>();
}

bool asksForCentring(const Test &test) {
    return partOr(false, test.measurement, [](auto &m) -> decltype(m.centring == Centring::instrument) {
        return m.centring == Centring::instrument;
    });
}

using Amount = std::optional<double>;

QString withSign(double value, Quantity quantity, int decimals, const Language &language) {
    const QString text = language.number(value, quantity, decimals);
    return value > 0 ? QStringLiteral("+") + text : text;
}

/// A coverage factor that always exists: an emptied field means the k = 2 of certificates.
Member<Amount> coverageOf(Member<double> member) {
    return converted<Amount, double>(
        std::move(member), [](const double &k) { return Amount(k); },
        [](const Amount &k) { return k.value_or(2); });
}

Member<Amount> trialsOf(Member<std::optional<long long>> member) {
    return converted<Amount, std::optional<long long>>(
        std::move(member),
        [](const std::optional<long long> &trials) {
            return trials ? Amount(static_cast<double>(*trials)) : std::nullopt;
        },
        [](const Amount &trials) {
            return trials ? std::optional(static_cast<long long>(*trials)) : std::nullopt;
        });
}

Member<Amount> seedOf(Member<long long> member) {
    return converted<Amount, long long>(
        std::move(member), [](const long long &seed) { return Amount(static_cast<double>(seed)); },
        [](const Amount &seed) { return static_cast<long long>(seed.value_or(1)); });
}

/// The U stated for a parameter; emptying the field removes it.
Member<Amount> statedFor(const Member<ExpandedUncertainties> &member, const std::string &id) {
    return {[read = member.read, id](const FormSource &source) {
                const ExpandedUncertainties all = read(source);
                const auto found = all.find(id);
                return found == all.end() ? std::nullopt : Amount(found->second);
            },
            [id](Document &document, std::size_t index, const Amount &value) {
                editTest(document, index, [&](Test &test) {
                    withUncertainty(test, [&](auto &inputs) {
                        if (value)
                            inputs.expanded[id] = *value;
                        else
                            inputs.expanded.erase(id);
                    });
                });
            }};
}

/// Source of E_VE: 0 for a typed value, otherwise the number of a drift test. A typed value takes precedence.
Member<int> environmentFrom(std::vector<std::string> drifts) {
    return {[drifts](const FormSource &source) {
                int choice = 0;
                if (!source.test)
                    return choice;
                withUncertainty(*source.test, [&](const auto &inputs) {
                    const auto found = std::ranges::find(drifts, inputs.driftTest.value_or(""));
                    if (inputs.driftTest && !inputs.environmentalVariation && found != drifts.end())
                        choice = static_cast<int>(found - drifts.begin()) + 1;
                });
                return choice;
            },
            [drifts](Document &document, std::size_t index, const int &choice) {
                editTest(document, index, [&](Test &test) {
                    withUncertainty(test, [&](auto &inputs) {
                        if (choice <= 0) {
                            inputs.driftTest.reset();
                        } else {
                            inputs.driftTest = drifts.at(static_cast<std::size_t>(choice) - 1);
                            inputs.environmentalVariation.reset();
                        }
                    });
                });
            }};
}

/// A result whose U can be entered: its key in the file, and its symbol.
struct StatedResult {
    std::string key;
    QString symbol;
};

/// The results of a test, indexed ones once (by the key of limits), and further ones stated in the file.
std::vector<StatedResult> statedResults(const Test &test, const TestEvaluation &evaluation) {
    std::vector<StatedResult> results;
    const auto add = [&](const std::string &key, const QString &symbol) {
        if (std::ranges::find(results, key, &StatedResult::key) == results.end())
            results.push_back({key, symbol});
    };
    for (const Parameter &parameter : evaluation.parameters) {
        Parameter plain = parameter;
        plain.index.clear();
        add(parameter.term.id, QString::fromStdString(plainSymbol(plain)));
    }
    withUncertainty(test, [&](const auto &inputs) {
        for (const auto &[key, value] : inputs.expanded)
            add(key, QString::fromStdString(key));
    });
    return results;
}

/// In lower case, for use within a sentence.
QString lowered(QString name) {
    if (!name.isEmpty())
        name[0] = name[0].toLower();
    return name;
}

/// A rule between two parts of the page.
QFrame *makeRule(QWidget *parent) {
    auto *rule = new QFrame(parent);
    rule->setProperty("rule", true);
    rule->setFixedHeight(1);
    return rule;
}

} // namespace

/// Short name of a contribution, e.g. "Expansion, machine".
QString UncertaintyPage::shortName(const Contribution &contribution) const {
    struct Name {
        const char *id = nullptr;
        const char *source = nullptr;
    };
    static constexpr std::array names{Name{deviceId, QT_TR_NOOP("Instrument")},
                                      Name{misalignmentId, QT_TR_NOOP("Misalignment")},
                                      Name{"temperatureMachine", QT_TR_NOOP("Temperature, machine")},
                                      Name{"temperatureInstrument", QT_TR_NOOP("Temperature, instrument")},
                                      Name{"expansionMachine", QT_TR_NOOP("Expansion, machine")},
                                      Name{"expansionInstrument", QT_TR_NOOP("Expansion, instrument")},
                                      Name{environmentalVariationId, QT_TR_NOOP("Environmental variation")},
                                      Name{displacementId, QT_TR_NOOP("Displacement")}};
    const auto found = std::ranges::find_if(
        names, [&](const Name &name) { return std::string_view(name.id) == contribution.id; });
    return found == names.end() ? contributionName(contribution, language()) : word(found->source);
}

UncertaintyPage::UncertaintyPage(DocumentModel &model, Evaluator &evaluator, Selection &selection,
                                 QWidget *parent)
    : Form(context, Page::uncertainty, model, parent)
    , m_simulator(evaluator) {
    setObjectName(QStringLiteral("uncertaintyPage"));
    makeTypical();
    follow(selection);
    refresh();
}

Quantity UncertaintyPage::deviation() const {
    return shownTest() ? deviationQuantity(*shownTest()) : Quantity::deviation;
}

QString UncertaintyPage::missingText(int count) const {
    const UncertaintyMethod *method = shownTest() ? methodOf(*shownTest()) : nullptr;
    if (method && *method == UncertaintyMethod::none) // there is no budget to be incomplete
        return tr("uncertainty not stated");
    if (method && *method == UncertaintyMethod::direct)
        return tr("not every uncertainty stated");
    if (awaitsSimulation())
        return tr("simulation not made yet");
    return tr("%n input(s) of the budget missing", nullptr, count);
}

/// True if the deciding simulation has not been started; nothing else needs to be stated.
bool UncertaintyPage::awaitsSimulation() const {
    if (!m_simulation || test() >= evaluated().tests.size())
        return false;
    const UncertaintyEvaluation &uncertainty = evaluated().tests[test()]->uncertainty;
    return uncertainty.method == UncertaintyMethod::monteCarlo && uncertainty.wantsSimulation() &&
           !uncertainty.simulation;
}

void UncertaintyPage::focusSimulation() {
    showPart(*m_simulation);
    m_simulation->focusButton();
}

bool UncertaintyPage::focusField(const QString &id) {
    if (Form::focusField(id))
        return true;
    if (!awaitsSimulation())
        return false;
    focusSimulation();
    return true;
}

bool UncertaintyPage::focusNextRequired(bool forward) {
    if (Form::focusNextRequired(forward))
        return true;
    if (!awaitsSimulation() || m_simulation->isAncestorOf(QApplication::focusWidget()))
        return false;
    focusSimulation();
    return true;
}

// ---- Building --------------------------------------------------------------------------------------------

void UncertaintyPage::forgetParts() {
    m_built.clear();
    m_fields.clear();
    m_methods = {};
    m_methodNote = nullptr;
    m_perMetre = m_length = m_environment = m_duration = m_repeatability = m_trials = nullptr;
    m_advice = nullptr;
    m_contributions = nullptr;
    m_results = nullptr;
    m_simulation = nullptr;
    m_decides = nullptr;
    m_distribution = nullptr;
    m_distributionTitle = nullptr;
    m_rule = nullptr;
    clear();
}

void UncertaintyPage::prepare() {
    const Test *shown = shownTest();
    const Edition *edition = shown ? findEdition(shown->edition) : nullptr;
    const UncertaintyMethod *method = shown ? methodOf(*shown) : nullptr;
    if (!edition || !method) {
        if (!m_built.isEmpty())
            forgetParts();
        m_typical->hide();
        return;
    }
    const bool rotary = motionOf(*shown) == Motion::rotary;
    const bool perMetre = asksPerMetre(*shown);
    const bool centring = asksForCentring(*shown);
    QStringList wanted{QString::fromUtf8(edition->word), rotary ? QStringLiteral("°") : QString(),
                       perMetre ? QStringLiteral("/m") : QString(),
                       centring ? QStringLiteral("+") : QString(),
                       QString::number(static_cast<int>(*method))};
    std::vector<QByteArray> driftNames;
    std::vector<std::string> drifts;
    for (const TestPointer &drift : driftTestsFor(*evaluated().document, *shown)) {
        drifts.push_back(drift->id);
        driftNames.push_back(driftTestName(*drift, language()).toUtf8());
        wanted << QString::fromStdString(drift->id) << QString::fromUtf8(driftNames.back());
    }
    if (*method == UncertaintyMethod::direct) {
        for (const StatedResult &result : statedResults(*shown, *evaluated().tests[test()]))
            wanted << QString::fromStdString(result.key);
    }
    // The emptied value keeps its field until the page is shown again.
    const bool onlyLess =
        wanted.size() < m_built.size() && isAncestorOf(QApplication::focusWidget()) &&
        std::ranges::all_of(wanted, [&](const QString &word) { return m_built.contains(word); });
    if (wanted == m_built || onlyLess)
        return;
    forgetParts();
    m_built = wanted;
    m_drifts = std::move(drifts);
    m_driftNames = std::move(driftNames);
    addMethods();
    if (*method == UncertaintyMethod::direct) {
        addStatedUncertainties(*edition, rotary);
    } else if (usesContributions(*method)) {
        withUncertainty(*shown, [this](const auto &inputs) { addInputs(inputs); });
        addContributions();
        addResults(axisOf(*shown));
    }
    addDecision();
    addStretch();
}

void UncertaintyPage::makeTypical() {
    m_typical = made<QToolButton>("typicalValues", trait::strongFocus, trait::segment("only"), this);
    m_typical->setPopupMode(QToolButton::InstantPopup);
    m_typical->setMenu(new QMenu(m_typical));
    connect(m_typical->menu(), &QMenu::aboutToShow, this, &UncertaintyPage::fillTypical);
    addToBar(m_typical);
}

/// Buttons for the method that decides.
void UncertaintyPage::addMethods() {
    beginRow();
    auto *bar = new QWidget(body());
    auto *row = inRow(bar, noMargins, 0, {});
    auto *group = new QButtonGroup(bar);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        auto *button = made<QToolButton>(QStringLiteral("method%1").arg(static_cast<int>(methods[i])),
                                         trait::checkable, trait::strongFocus,
                                         trait::segment(i == 0                    ? "first"
                                                        : i + 1 == methods.size() ? "last"
                                                                                  : "middle"),
                                         bar);
        group->addButton(button, static_cast<int>(i));
        row->addWidget(button);
        m_methods[i] = button;
    }
    connect(group, &QButtonGroup::idClicked, this,
            [this](int id) { chooseMethod(methods.at(static_cast<std::size_t>(id))); });
    row->addStretch();
    addWidget(bar);
    beginRow(); // it does not fit next to the buttons
    m_methodNote = made<QLabel>("methodNote", trait::secondary, trait::wrapped, body());
    addWidget(m_methodNote);
}

void UncertaintyPage::chooseMethod(UncertaintyMethod method) {
    const QByteArray name = changeOf(context, QT_TR_NOOP("Method of the uncertainty"));
    edit(name.constData(), [this, method](Document &document) {
        editTest(document, test(), [method](Test &changed) {
            withUncertainty(changed, [method](auto &inputs) { inputs.method = method; });
        });
    });
}

void UncertaintyPage::fillTypical() {
    QMenu *menu = m_typical->menu();
    menu->clear();
    if (!shownTest())
        return;
    for (const TypicalValue &value : typicalValues(*evaluated().document, *shownTest(), language())) {
        const QAction *action = menu->addAction(value.value + QStringLiteral(" – ") + value.source);
        connect(action, &QAction::triggered, this, [this, value] {
            edit(QT_TRANSLATE_NOOP("edits", "take a typical value"), [&](Document &document) {
                document = withTypicalValue(std::move(document), test(), value);
            });
        });
    }
}

/// Value and source of E_VE; the choice is shown only if there are drift tests.
void UncertaintyPage::addEnvironment(Quantity size, Member<Amount> member) {
    m_environment = addNumber({"environmentalVariation", QT_TR_NOOP("Env. variation E_VE")}, size,
                              std::move(member), 1, Allowed::notNegative);
    m_fields[environmentalVariationId] = m_environment;
    if (m_drifts.empty())
        return;
    std::vector<const char *> words{QT_TR_NOOP("typed in")};
    for (const QByteArray &name : m_driftNames)
        words.push_back(name.constData());
    addChoice({"driftTest", QT_TR_NOOP("E_VE from")}, words, environmentFrom(m_drifts), false);
    m_duration = addNumber({"duration", QT_TR_NOOP("Test lasted, min")}, Quantity::number,
                           ofTest([](auto &test) { return &test.duration; }), 1, Allowed::positive);
}

/// Settings of the simulation.
void UncertaintyPage::addTrials(Member<std::optional<long long>> trials, Member<long long> seed) {
    m_trials = addNumber("trials", Quantity::count, trialsOf(std::move(trials)), 1, Allowed::counting);
    addNumber({"seed", QT_TR_NOOP("Seed")}, Quantity::count, seedOf(std::move(seed)), 1, Allowed::whole);
}

void UncertaintyPage::addInputs(const PositioningUncertaintyInputs & /*inputs*/) {
    using Inputs = PositioningUncertaintyInputs;
    using Both = MachineAndInstrument;
    const bool rotary = motionOf(*shownTest()) == Motion::rotary;
    const Quantity size = rotary ? Quantity::arcSeconds : Quantity::micrometres;
    beginRow();
    addChoice({"device", QT_TR_NOOP("Instrument by")},
              {QT_TR_NOOP("certificate"), QT_TR_NOOP("range of its error")},
              choiceOf<DeviceKind>(positioning<&Inputs::device, &DeviceUncertainty::kind>(),
                                   {DeviceKind::certificate, DeviceKind::range}),
              false);
    m_fields[deviceId] =
        addNumber({"device", QT_TR_NOOP("Instrument, fixed part")}, size,
                  positioning<&Inputs::device, &DeviceUncertainty::fixed>(), 1, Allowed::notNegative);
    if (asksPerMetre(*shownTest()))
        m_perMetre =
            addNumber({"device", QT_TR_NOOP("Instrument, per metre")}, size,
                      positioning<&Inputs::device, &DeviceUncertainty::perMetre>(), 1, Allowed::notNegative);
    addNumber({"coverageFactor", QT_TR_NOOP("k of the certificate")}, Quantity::number,
              coverageOf(positioning<&Inputs::device, &DeviceUncertainty::coverageFactor>()), 1,
              Allowed::positive);
    beginRow();
    if (!rotary) {
        m_fields[misalignmentId] =
            addNumber("misalignmentRange", Quantity::position, positioning<&Inputs::misalignmentRange>(), 1,
                      Allowed::notNegative);
        m_length =
            addNumber("length", Quantity::position, positioning<&Inputs::length>(), 1, Allowed::positive);
    }
    addEnvironment(size, positioning<&Inputs::environmentalVariation>());
    if (!rotary) {
        if (m_drifts.empty()) // aligns with the other rows
            addWidget(new QWidget(body()));
        beginRow();
        m_fields["temperatureMachine"] =
            addNumber({"temperatureRange", QT_TR_NOOP("Range of θ, machine")}, Quantity::temperature,
                      positioning<&Inputs::temperatureRange, &Both::machine>(), 1, Allowed::notNegative);
        m_fields["temperatureInstrument"] =
            addNumber({"temperatureRange", QT_TR_NOOP("Range of θ, instr.")}, Quantity::temperature,
                      positioning<&Inputs::temperatureRange, &Both::instrument>(), 1, Allowed::notNegative);
        m_fields["expansionMachine"] =
            addNumber({"expansionRange", QT_TR_NOOP("Range of α, machine")}, Quantity::expansion,
                      positioning<&Inputs::expansionRange, &Both::machine>(), 1, Allowed::notNegative);
        m_fields["expansionInstrument"] =
            addNumber({"expansionRange", QT_TR_NOOP("Range of α, instr.")}, Quantity::expansion,
                      positioning<&Inputs::expansionRange, &Both::instrument>(), 1, Allowed::notNegative);
    }
}

void UncertaintyPage::addInputs(const CircularUncertaintyInputs & /*inputs*/) {
    using Inputs = CircularUncertaintyInputs;
    using Both = MachineAndInstrument;
    constexpr Quantity size = Quantity::micrometres;
    beginRow();
    m_fields[displacementId] =
        addNumber({"displacement", QT_TR_NOOP("Displacement, U")}, size,
                  circular<&Inputs::displacement, &ExpandedValue::expanded>(), 1, Allowed::notNegative);
    addNumber({"coverageFactor", QT_TR_NOOP("k of the displacement")}, Quantity::number,
              coverageOf(circular<&Inputs::displacement, &ExpandedValue::coverageFactor>()), 1,
              Allowed::positive);
    m_fields[referenceLengthId] =
        addNumber({"referenceLength", QT_TR_NOOP("Reference length, U")}, size,
                  length<&ReferenceLength::expandedUncertainty>(), 1, Allowed::notNegative);
    addNumber({"coverageFactor", QT_TR_NOOP("k of the length")}, Quantity::number,
              coverageOf(length<&ReferenceLength::coverageFactor>()), 1, Allowed::positive);
    beginRow();
    m_fields[resolutionId] = addNumber({"resolution", QT_TR_NOOP("Resolution")}, size,
                                       circular<&Inputs::resolution>(), 1, Allowed::notNegative);
    m_fields[pointNoiseId] = addNumber({"pointNoise", QT_TR_NOOP("Noise of a point, u")}, size,
                                       circular<&Inputs::pointNoise>(), 1, Allowed::notNegative);
    m_repeatability = addNumber({"repeatability", QT_TR_NOOP("Repeatability, u")}, size,
                                circular<&Inputs::repeatability>(), 1, Allowed::notNegative);
    m_fields[repeatabilityId] = m_repeatability;
    if (asksForCentring(*shownTest()))
        m_fields[centringId] = addNumber({"centring", QT_TR_NOOP("Centring, u")}, size,
                                         circular<&Inputs::centring>(), 1, Allowed::notNegative);
    beginRow();
    addEnvironment(size, circular<&Inputs::environmentalVariation>());
    addChoice({"sameSensor", QT_TR_NOOP("Temperature sensors")},
              {QT_TR_NOOP("one each"), QT_TR_NOOP("one for machine and instrument")},
              choiceOf<bool>(circular<&Inputs::sameSensor>(), {false, true}), false);
    beginRow();
    m_fields[correctionId] = addNumber(
        {"temperatureStandardUncertainty", QT_TR_NOOP("u of θ, machine")}, Quantity::temperature,
        circular<&Inputs::temperatureStandardUncertainty, &Both::machine>(), 1, Allowed::notNegative);
    addNumber({"temperatureStandardUncertainty", QT_TR_NOOP("u of θ, instr.")}, Quantity::temperature,
              circular<&Inputs::temperatureStandardUncertainty, &Both::instrument>(), 1,
              Allowed::notNegative);
    addNumber({"expansionStandardUncertainty", QT_TR_NOOP("u of α, machine")}, Quantity::expansion,
              circular<&Inputs::expansionStandardUncertainty, &Both::machine>(), 1, Allowed::notNegative);
    addNumber({"expansionStandardUncertainty", QT_TR_NOOP("u of α, instr.")}, Quantity::expansion,
              circular<&Inputs::expansionStandardUncertainty, &Both::instrument>(), 1, Allowed::notNegative);
}

void UncertaintyPage::addStatedUncertainties(const Edition &edition, bool rotary) {
    addSection(QT_TR_NOOP("Expanded uncertainties, k = 2"));
    const Quantity size = rotary ? Quantity::arcSeconds : Quantity::micrometres;
    constexpr int fieldsInRow = 4;
    int count = 0;
    for (const StatedResult &result : statedResults(*shownTest(), *evaluated().tests[test()])) {
        if (count++ % fieldsInRow == 0)
            beginRow();
        Field *field =
            addNumber({"expanded", QT_TR_NOOP("U(%1)")}, size,
                      statedFor(edition.circles ? circular<&CircularUncertaintyInputs::expanded>()
                                                : positioning<&PositioningUncertaintyInputs::expanded>(),
                                result.key),
                      1, Allowed::notNegative);
        field->setLabelArgument(result.symbol);
    }
    for (; count % fieldsInRow != 0; ++count) // aligns the last row with the others
        addWidget(new QWidget(body()));
}

void UncertaintyPage::addContributions() {
    beginRow();
    addWidget(makeRule(body()));
    addSection(QT_TR_NOOP("Contributions"));
    m_advice = made<QPushButton>("advice", trait::link, trait::notDefault, body());
    connect(m_advice, &QPushButton::clicked, this, [this] { focusContribution(m_contributions->key(0)); });
    addToSection(m_advice);
    beginRow();
    m_contributions = new RowTable("contributions", contributionColumn::count, body());
    connect(m_contributions, &QTableWidget::activated, this,
            [this](const QModelIndex &index) { focusContribution(m_contributions->key(index.row())); });
    addWidget(m_contributions);
}

void UncertaintyPage::addResults(bool linear) {
    using Positioning = PositioningUncertaintyInputs;
    using Circular = CircularUncertaintyInputs;
    beginRow();
    addWidget(makeRule(body()));
    addSection(QT_TR_NOOP("Results, %1"), language().unit(deviation()));
    m_simulation = new SimulationRow(m_simulator, body());
    addToSection(m_simulation, 1);
    beginRow();
    m_results = new RowTable("methods", resultColumn::count, body());
    connect(m_results, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0) {
            m_chosen = m_results->key(row);
            showDistribution();
        }
    });
    addWidget(m_results);
    beginRow();
    m_decides = made<QLabel>("decides", trait::wrapped, trait::secondary, body());
    addWidget(m_decides);
    beginRow();
    m_distributionTitle = made<QLabel>("distributionTitle", body());
    addWidget(m_distributionTitle);
    beginRow();
    m_distribution = made<FigureCard>("distribution", body());
    m_distribution->setFixedHeight(figureHeight);
    addWidget(m_distribution);
    beginRow();
    addWidget(makeRule(body()));
    addSection(QT_TR_NOOP("Simulation"));
    beginRow();
    if (linear) {
        addTrials(positioning<&Positioning::trials>(), positioning<&Positioning::seed>());
        addChoice({"driftModel", QT_TR_NOOP("Drift of the readings")},
                  {QT_TR_NOOP("independent"), QT_TR_NOOP("linear in time")},
                  choiceOf<DriftModel>(positioning<&Positioning::driftModel>(),
                                       {DriftModel::independent, DriftModel::linear}),
                  false, 2);
    } else {
        addTrials(circular<&Circular::trials>(), circular<&Circular::seed>());
    }
}

/// Use of U in the verdict; the same fields as on the limits page.
void UncertaintyPage::addDecision() {
    beginRow();
    addWidget(makeRule(body()));
    addSection(QT_TR_NOOP("Decision"));
    beginRow();
    addChoice({"", QT_TR_NOOP("Rule")},
              {QT_TR_NOOP("simple acceptance"), QT_TR_NOOP("ISO 14253-1: conformity is to be proven"),
               QT_TR_NOOP("non-conformity is to be proven")},
              decisionRuleMember(), false, 2);
    addNumber({"", QT_TR_NOOP("Guard band, times U")}, Quantity::number, guardFactorMember(), 1,
              Allowed::notNegative);
    beginRow();
    m_rule = made<QLabel>("decisionRuleText", trait::wrapped, trait::secondary, body());
    addWidget(m_rule);
}

void UncertaintyPage::focusContribution(const QString &id) {
    const auto found = m_fields.find(id.toStdString());
    if (found != m_fields.end())
        focusPart(*found->second);
}

// ---- Showing ---------------------------------------------------------------------------------------------

void UncertaintyPage::refreshOthers() {
    if (!m_methodNote || test() >= evaluated().tests.size())
        return;
    const TestEvaluation &evaluation = *evaluated().tests[test()];
    showMethods(evaluation);
    showPlaceholders(evaluation);
    // Machine and instrument share the name of an input, though only one of them may be missing.
    for (const Contribution &contribution : evaluation.uncertainty.contributions) {
        const auto found = m_fields.find(contribution.id);
        if (found != m_fields.end() && contribution.defects.empty())
            found->second->setRequired(false);
    }
    if (evaluated().isPending(test()))
        return; // the tables keep the former data until the results are ready
    if (m_contributions)
        showContributions(evaluation);
    if (m_results) {
        showResults(evaluation);
        showDistribution();
        m_simulation->show(evaluated(), test(), language());
    }
    const Writer write(language());
    const TestPart part{write, evaluated(), *shownTest(), evaluation, test(), 1, 1};
    m_rule->setFont(themeFont(TextSize::small));
    m_rule->setText(decisionText(part));
}

void UncertaintyPage::showMethods(const TestEvaluation &evaluation) {
    const bool linear = axisOf(*shownTest());
    const UncertaintyMethod method = *methodOf(*shownTest());
    const std::array names{tr("Budget"), tr("Actual targets"), tr("Monte Carlo"), tr("Direct"), tr("None")};
    const std::array tips{
        linear ? tr("The verdict is based on the budget (GUM) of the contributors that public drafts of "
                    "annex A name")
               : tr("The verdict is based on the budget (GUM) of the contributors of ISO 230-4, 4.6"),
        tr("The verdict is based on the budget with what the actual targets carry of its systematic part "
           "(Palmer's method)"),
        tr("The verdict is based on the Monte Carlo simulation (GUM Supplement 1)"),
        tr("The expanded uncertainty of every result is entered"), tr("No uncertainty is stated")};
    for (std::size_t i = 0; i < methods.size(); ++i) {
        m_methods[i]->setText(names.at(i));
        m_methods[i]->setToolTip(tips.at(i));
        m_methods[i]->setAccessibleName(tr("Method: %1").arg(names.at(i)));
        m_methods[i]->setChecked(methods[i] == method);
        m_methods[i]->setVisible(linear || methods[i] != UncertaintyMethod::budgetActual);
    }
    m_methodNote->setFont(themeFont(TextSize::small));
    const QString coverage = coverageNote(coverageOf(evaluation, evaluated().document->report), language());
    m_methodNote->setText(method == UncertaintyMethod::none ? QString()
                          : evaluation.view                 ? tr("a view: see the edition")
                          : coverage.isEmpty()              ? tr("used for the verdict")
                                                            : tr("used for the verdict · %1").arg(coverage));
    m_typical->setText(tr("Values"));
    m_typical->setToolTip(tr("Take a typical value, with its source"));
    m_typical->setAccessibleName(tr("Typical values with their source"));
    m_typical->setVisible(usesContributions(method));
}

/// Shows the values used for empty fields.
void UncertaintyPage::showPlaceholders(const TestEvaluation &evaluation) {
    if (m_perMetre)
        m_perMetre->setUnit(tr("%1/m").arg(language().unit(
            deviation() == Quantity::deviation ? Quantity::micrometres : Quantity::arcSeconds)));
    if (m_trials)
        m_trials->setPlaceholder(tr("adaptive"));
    if (m_length && evaluation.uncertainty.length)
        m_length->setPlaceholder(
            language().number(certain(*evaluation.uncertainty.length), Quantity::position));
    if (m_environment)
        m_environment->setPlaceholder(driftPlaceholder());
    if (m_duration) // over which the drift test is asked for its range
        m_duration->setVisible(driftTestOf(*shownTest()) && m_environment->text().isEmpty());
    if (m_repeatability) {
        const auto &contributions = evaluation.uncertainty.contributions;
        const auto found = std::ranges::find_if(
            contributions, [](const Contribution &c) { return std::string_view(c.id) == repeatabilityId; });
        const bool repeated = found != contributions.end() && found->expanded;
        constexpr double coverage = 2;
        m_repeatability->setPlaceholder(
            repeated
                ? language().number(*found->expanded / coverage, Quantity::deviation, contributionDecimals)
                : QString());
    }
}

/// E_VE of the selected drift test; empty if there is none.
QString UncertaintyPage::driftPlaceholder() const {
    const std::string *id = driftTestOf(*shownTest());
    for (const TestPointer &drift : driftTestsFor(*evaluated().document, *shownTest())) {
        if (!id || *id != drift->id)
            continue;
        const auto found = driftVariation(*evaluated().document, drift->id, *shownTest());
        return found ? language().number(found->value, deviationQuantity(*shownTest()), contributionDecimals)
                     : QString();
    }
    return {};
}

void UncertaintyPage::showContributions(const TestEvaluation &evaluation) {
    namespace column = contributionColumn;
    const auto &contributions = evaluation.uncertainty.contributions;
    const BarFigure figure = budgetFigure(*shownTest(), evaluation, language());
    const auto ordered = bySize(contributions);
    m_contributions->setAccessibleName(tr("Contributions to the uncertainty, the largest first"));
    m_contributions->setHead(column::name, tr("Contribution"), false);
    m_contributions->setHead(column::calculation, tr("Calculation"), false);
    m_contributions->setHead(column::size, {}, false);
    m_contributions->setHead(column::expanded, QStringLiteral("U ") + figure.x.unit, true);
    m_contributions->setRowCount(static_cast<int>(figure.bars.size()));
    for (std::size_t i = 0; i < figure.bars.size(); ++i) {
        const Contribution &contribution = *ordered[i];
        const Bar &bar = figure.bars[i];
        const int row = static_cast<int>(i);
        const QString share = tr("%1 % of U²").arg(bar.share);
        auto *name = m_contributions->setCell(row, column::name, shortName(contribution), false);
        name->setToolTip(contributionName(contribution, language()));
        name->setData(RowTable::keyRole, bar.id);
        name->setData(Qt::AccessibleTextRole,
                      QStringLiteral("%1: %2 %3, %4").arg(name->text(), bar.value, figure.x.unit, share));
        auto *calculation = m_contributions->setCell(
            row, column::calculation,
            contribution.expanded ? language().sentence(contribution.inputs) : tr("not stated"), false);
        calculation->setFont(themeFont(TextSize::small));
        calculation->setForeground(
            token(contribution.expanded ? Token::secondaryText : Token::unsure, palette()));
        calculation->setToolTip(calculation->text());
        auto *size = m_contributions->setCell(row, column::size, {}, false);
        size->setData(RowTable::barRole, bar.size / figure.x.to);
        size->setData(RowTable::firstRole, bar.first);
        size->setData(Qt::AccessibleTextRole, share);
        size->setToolTip(share);
        m_contributions->setCell(row, column::expanded, bar.value, true);
    }
    constexpr int leastBar = 64;
    m_contributions->fit(column::size, leastBar, {column::calculation, column::name});
    const Contribution *first = evaluation.uncertainty.complete ? toImproveFirst(contributions) : nullptr;
    m_advice->setVisible(first);
    if (first)
        m_advice->setText(
            tr("improve first: %1, %2 % of U²")
                .arg(lowered(shortName(*first)), shareText(shareOf(*first, contributions), language())));
}

void UncertaintyPage::showResults(const TestEvaluation &evaluation) {
    namespace column = resultColumn;
    nameResultColumns(evaluation.uncertainty.method);
    std::vector<HistogramFigure> histograms;
    const QSignalBlocker quiet(m_results);
    m_results->setRowCount(0);
    for (const Parameter &parameter : evaluation.parameters) {
        if (!isPrinted(parameter, evaluated().document->report))
            continue;
        const int row = m_results->rowCount();
        m_results->insertRow(row);
        showResult(row, parameter, evaluation);
        if (!parameter.simulated)
            continue;
        showSimulated(row, parameter);
        if (auto figure = histogramFigure(*shownTest(), evaluation, parameter, language(),
                                          finestResolution(*evaluated().document, *shownTest()))) {
            auto *distribution = m_results->setCell(row, column::distribution, {}, false);
            distribution->setData(RowTable::histogramRole, static_cast<int>(histograms.size()));
            distribution->setData(Qt::AccessibleTextRole, figure->title);
            distribution->setToolTip(figure->title);
            histograms.push_back(std::move(*figure));
        }
        if (parameter.budgetUncertainty && *parameter.budgetUncertainty > 0)
            showDifference(row, parameter);
        if (evaluation.uncertainty.outdated)
            showOutdated(row);
    }
    m_results->setHistograms(std::move(histograms));
    constexpr int leastHistogram = 70;
    m_results->fit(column::distribution, leastHistogram);
    const int chosen = std::max(0, m_results->rowOf(m_chosen));
    if (m_results->rowCount() > 0) {
        m_results->setCurrentCell(chosen, 0);
        m_chosen = m_results->key(chosen);
    }
    const Writer write(language());
    const TestPart part{write, evaluated(), *shownTest(), evaluation, test(), 1, 1};
    m_decides->setFont(themeFont(TextSize::small));
    QStringList said{tr("Bold: the U used for the verdict."), methodText(part)};
    if (evaluation.uncertainty.outdated)
        said.prepend(tr("Grey: simulated before the last edit of the test, outdated."));
    m_decides->setText(said.join(u' '));
}

void UncertaintyPage::nameResultColumns(UncertaintyMethod method) {
    namespace column = resultColumn;
    m_results->setAccessibleName(tr("Expanded uncertainty of the results by both methods"));
    m_results->setHead(column::symbol, {}, false);
    m_results->setHead(column::budget, tr("Budget") + tr(", k = 2"), true);
    m_results->setHead(column::actual, tr("actual targets"), true);
    m_results->setHead(column::simulation, tr("Monte Carlo, 95.45 %"), true);
    // Space is short, and the report always has this line.
    m_results->setColumnHidden(column::actual, method != UncertaintyMethod::budgetActual);
    m_results->setHead(column::interval, tr("interval"), true);
    m_results->setHead(column::distribution, tr("distribution"), false);
    m_results->setHead(column::shift, tr("shift"), true);
    m_results->setHead(column::difference, tr("difference"), false);
}

/// Shows the U of all methods; the columns of the simulation remain empty.
void UncertaintyPage::showResult(int row, const Parameter &parameter, const TestEvaluation &evaluation) {
    namespace column = resultColumn;
    const Quantity quantity = deviation();
    const auto resolution = finestResolution(*evaluated().document, *shownTest());
    const QString none = QStringLiteral("–");
    const auto expanded = [&](const std::optional<double> &value) {
        return value ? QStringLiteral("± ") +
                           language().uncertainty(*value, quantity,
                                                  decimalsWithUncertainty(*value, quantity, resolution))
                     : none;
    };
    auto *symbol =
        m_results->setCell(row, column::symbol, QString::fromStdString(plainSymbol(parameter)), false, true);
    symbol->setData(RowTable::keyRole, QString::fromStdString(parameterId(parameter)));
    const auto showMethod = [&](int at, const std::optional<double> &value, UncertaintyMethod method) {
        const bool decides = parameter.decidedBy == method;
        // The deciding U is formatted as in the results.
        const QString text =
            value && decides
                ? QStringLiteral("± ") +
                      printedNumbers(parameter, *shownTest(), *evaluated().document, language()).uncertainty
                : expanded(value);
        auto *cell = m_results->setCell(row, at, text, true, decides);
        if (decides)
            cell->setData(Qt::AccessibleTextRole, tr("%1, used for the verdict").arg(cell->text()));
        return cell;
    };
    showMethod(column::budget, parameter.budgetUncertainty, UncertaintyMethod::budget);
    auto *actual = showMethod(column::actual, parameter.actualUncertainty, UncertaintyMethod::budgetActual);
    if (parameter.effectiveSystematic && evaluation.uncertainty.systematic)
        actual->setToolTip(
            tr("k = 2; %1 of the systematic part S = %2 is carried by the actual targets")
                .arg(expanded(parameter.effectiveSystematic), expanded(evaluation.uncertainty.systematic)));
    showMethod(column::simulation,
               parameter.simulated ? std::optional(parameter.simulated->expanded()) : std::nullopt,
               UncertaintyMethod::monteCarlo);
    for (int empty = column::interval; empty < column::count; ++empty)
        m_results->setCell(row, empty, empty == column::distribution ? QString() : none,
                           empty != column::difference);
}

/// Shows interval and shift of a simulated parameter, and how certain its U is.
void UncertaintyPage::showSimulated(int row, const Parameter &parameter) {
    namespace column = resultColumn;
    const SimulatedParameter &simulated = *parameter.simulated;
    const Quantity quantity = deviation();
    const auto small = [&](double value, int digits) {
        constexpr int most = 6;
        return significant(value * unitScale(quantity, language().units()), digits, most, language());
    };
    if (simulated.expandedError)
        m_results->item(row, column::simulation)
            ->setToolTip(tr("2s of U: %1; tolerance of u: %2")
                             .arg(small(2 * *simulated.expandedError, 2), small(simulated.tolerance(), 1)));
    const auto resolution = finestResolution(*evaluated().document, *shownTest());
    const int decimals = decimalsWithUncertainty(simulated.expanded(), quantity, resolution);
    auto *interval =
        m_results->setCell(row, column::interval,
                           language().number(simulated.low, quantity, decimals) + QStringLiteral(" … ") +
                               language().number(simulated.high, quantity, decimals),
                           true);
    interval->setFont(themeFont(TextSize::small));
    interval->setForeground(token(Token::secondaryText, palette()));
    auto *shift = m_results->setCell(row, column::shift,
                                     withSign(simulated.shift(), quantity, decimals, language()), true);
    shift->setFont(themeFont(TextSize::small));
    if (simulated.largeShift()) {
        shift->setForeground(token(Token::unsure, palette()));
        shift->setToolTip(
            tr("More than a third of the U of the simulation: the budget U is used for the verdict"));
    }
}

/// Dims the results of a simulation made before the last edit; none of them is bold.
void UncertaintyPage::showOutdated(int row) {
    namespace column = resultColumn;
    for (const int at :
         {column::simulation, column::interval, column::distribution, column::shift, column::difference}) {
        QTableWidgetItem *cell = m_results->item(row, at);
        QFont font = cell->font();
        font.setBold(false);
        if (cell->data(Qt::FontRole).isValid())
            cell->setFont(font);
        cell->setForeground(token(Token::secondaryText, palette()));
        cell->setData(RowTable::outdatedRole, true);
        cell->setData(RowTable::warningRole, {});
        const QString read = cell->data(Qt::AccessibleTextRole).toString();
        cell->setData(Qt::AccessibleTextRole, tr("%1, outdated").arg(read.isEmpty() ? cell->text() : read));
    }
}

/// Shows the difference of the simulation's U from the budget's.
void UncertaintyPage::showDifference(int row, const Parameter &parameter) {
    const double ratio = parameter.simulated->expanded() / *parameter.budgetUncertainty - 1;
    constexpr double percent = 100;
    auto *difference =
        m_results->setCell(row, resultColumn::difference,
                           tr("%1 %").arg(withSign(ratio * percent, Quantity::number, 0, language())), false,
                           methodsDiffer(parameter));
    if (methodsDiffer(parameter)) {
        difference->setData(RowTable::warningRole, tr("> 20 %"));
        difference->setForeground(token(Token::unsure, palette()));
        difference->setData(Qt::AccessibleTextRole, tr("%1, more than 20 %").arg(difference->text()));
        difference->setToolTip(tr("The methods differ by more than 20 %: the findings give the reason"));
    }
}

/// Shows the histogram of the result selected in the table.
void UncertaintyPage::showDistribution() {
    if (!m_distribution || test() >= evaluated().tests.size())
        return;
    const TestEvaluation &evaluation = *evaluated().tests[test()];
    std::optional<HistogramFigure> figure;
    for (const Parameter &parameter : evaluation.parameters) {
        if (QString::fromStdString(parameterId(parameter)) == m_chosen)
            figure = histogramFigure(*shownTest(), evaluation, parameter, language(),
                                     finestResolution(*evaluated().document, *shownTest()));
    }
    m_distribution->setVisible(figure.has_value());
    m_distributionTitle->setVisible(figure.has_value());
    m_distributionTitle->setFont(themeFont(TextSize::head));
    m_distributionTitle->setText(figure && evaluation.uncertainty.outdated
                                     ? tr("%1, outdated").arg(figure->title)
                                 : figure ? figure->title
                                          : QString());
    m_distribution->setAccessibleName(figure ? figure->title : QString());
    m_distribution->setAccessibleDescription(
        figure ? QStringList{figure->evaluatedText, figure->meanText, figure->coverageText}.join(
                     QStringLiteral(", "))
               : QString());
    m_distribution->setFigure(figure ? std::optional<Figure>(std::move(*figure)) : std::nullopt);
}

} // namespace palmer::ui
