#include "ui/uncertainty/uncertaintypage.h"

#include "kernel/evaluation/decideuncertainty.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/uncertainty/positioningbudget.h"
#include "language/rounding.h"
#include "report/uncertaintyparts.h"
#include "report/wording.h"
#include "ui/theme.h"
#include "ui/uncertainty/contributionbars.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QtMath>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr char context[] = "palmer::ui::UncertaintyPage";
constexpr int rowHeight = 24;
constexpr int contributionDecimals = 2;
constexpr double smallShare = 0.05; ///< of the largest: nothing stands out

template <class T>
T &reach(T &whole) {
    return whole;
}
template <class T, class Part, class... Rest>
auto &reach(T &whole, Part part, Rest... rest) {
    return reach(whole.*part, rest...);
}

template <auto... members>
auto positioning() {
    return ofTest([](auto &test) {
        auto *measurement = std::get_if<PositioningMeasurement>(&test.measurement);
        return measurement ? &reach(measurement->uncertainty, members...) : nullptr;
    });
}

template <auto... members>
auto circular() {
    return ofTest([](auto &test) {
        auto *measurement = std::get_if<CircularMeasurement>(&test.measurement);
        return measurement ? &reach(measurement->uncertainty, members...) : nullptr;
    });
}

using Amount = std::optional<double>;

/// A factor that is always there: an emptied field is the k = 2 of certificates.
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

/// The U stated for a parameter; an emptied field takes it out.
Member<Amount> statedFor(Member<ExpandedUncertainties> member, const std::string &id) {
    return {[read = member.read, id](const FormSource &source) {
                const ExpandedUncertainties all = read(source);
                const auto found = all.find(id);
                return found == all.end() ? std::nullopt : Amount(found->second);
            },
            [id](Document &document, std::size_t index, const Amount &value) {
                editTest(document, index, [&](Test &test) {
                    std::visit(
                        [&](auto &measurement) {
                            if constexpr (requires { measurement.uncertainty.expanded; }) {
                                if (value)
                                    measurement.uncertainty.expanded[id] = *value;
                                else
                                    measurement.uncertainty.expanded.erase(id);
                            }
                        },
                        test.measurement);
                });
            }};
}

QTableWidget *makeTable(const char *name, int columns, QWidget *parent) {
    auto *table = new QTableWidget(0, columns, parent);
    table->setObjectName(QString::fromLatin1(name));
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setShowGrid(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(rowHeight);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    return table;
}

void setCell(QTableWidget *table, int row, int column, const QString &text, bool number, bool bold = false) {
    auto *item = new QTableWidgetItem(text);
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (bold) {
        QFont font = themeFont(TextSize::base);
        font.setBold(true);
        item->setFont(font);
    }
    table->setItem(row, column, item);
}

/// High enough for all rows: the page scrolls, not the table.
void fitRows(QTableWidget *table) {
    table->setFixedHeight(table->horizontalHeader()->sizeHint().height() + table->rowCount() * rowHeight + 2);
}

QString capital(QString text) {
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text;
}

} // namespace

UncertaintyPage::UncertaintyPage(DocumentModel &model, Evaluator &evaluator, Selection &selection,
                                 QWidget *parent)
    : Form(context, Page::uncertainty, model, parent)
    , m_simulator(evaluator) {
    setObjectName(QStringLiteral("uncertaintyPage"));
    follow(selection);
    connect(&m_simulator, &Simulator::progressed, this, &UncertaintyPage::showSimulation);
    connect(&m_simulator, &Simulator::finished, this, &UncertaintyPage::showSimulation);
    refresh();
}

Quantity UncertaintyPage::deviation() const {
    const auto *measurement =
        shownTest() ? std::get_if<PositioningMeasurement>(&shownTest()->measurement) : nullptr;
    return measurement ? deviationQuantity(*measurement) : Quantity::deviation;
}

QString UncertaintyPage::missingText(int count) const {
    return tr("%n input(s) of the budget missing", nullptr, count);
}

void UncertaintyPage::prepare() {
    const Test *shown = shownTest();
    const Edition *edition = shown ? findEdition(shown->edition) : nullptr;
    const auto *linear = shown ? std::get_if<PositioningMeasurement>(&shown->measurement) : nullptr;
    const auto *circles = shown ? std::get_if<CircularMeasurement>(&shown->measurement) : nullptr;
    if (!edition || (!linear && !circles)) {
        m_built.clear();
        m_perMetre = nullptr;
        m_contributions = nullptr;
        clear();
        return;
    }
    const bool rotary = linear && linear->axis.motion == Motion::rotary;
    const UncertaintyMethod method = linear ? linear->uncertainty.method : circles->uncertainty.method;
    const QStringList wanted{QString::fromUtf8(edition->word), rotary ? QStringLiteral("°") : QString(),
                             QString::number(static_cast<int>(method))};
    if (wanted == m_built)
        return;
    m_built = wanted;
    m_perMetre = nullptr;
    m_typical = nullptr;
    m_contributions = nullptr;
    clear();
    beginRow();
    const std::vector<UncertaintyMethod> methods{UncertaintyMethod::none, UncertaintyMethod::budget,
                                                 UncertaintyMethod::monteCarlo, UncertaintyMethod::direct};
    addChoice("method", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Method that decides, k = 2"),
              {QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "none"),
               QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "budget"),
               QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Monte Carlo"),
               QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "entered directly")},
              linear ? choiceOf(positioning<&PositioningUncertaintyInputs::method>(), methods)
                     : choiceOf(circular<&CircularUncertaintyInputs::method>(), methods),
              false);
    if (method == UncertaintyMethod::direct) {
        addStatedUncertainties(*edition, rotary);
    } else if (method != UncertaintyMethod::none) {
        if (linear)
            addPositioningInputs(rotary);
        else
            addCircularInputs();
        addOutcome();
    }
    addStretch();
}

void UncertaintyPage::addPositioningInputs(bool rotary) {
    using Inputs = PositioningUncertaintyInputs;
    const Quantity size = rotary ? Quantity::arcSeconds : Quantity::micrometres;
    addSection(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Inputs"));
    beginRow();
    addChoice("", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Instrument stated by"),
              {QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "certificate"),
               QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "range of its error")},
              choiceOf<DeviceKind>(positioning<&Inputs::device, &DeviceUncertainty::kind>(),
                                   {DeviceKind::certificate, DeviceKind::range}),
              false);
    addNumber("device", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Instrument, fixed"), size,
              positioning<&Inputs::device, &DeviceUncertainty::fixed>(), 1, Allowed::notNegative);
    if (!rotary)
        m_perMetre = addNumber(
            "device", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Instrument, per metre"), size,
            positioning<&Inputs::device, &DeviceUncertainty::perMetre>(), 1, Allowed::notNegative);
    addNumber(
        "device", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "k of the certificate"), Quantity::number,
        coverageOf(positioning<&Inputs::device, &DeviceUncertainty::coverageFactor>()), 1, Allowed::positive);
    if (!rotary) {
        beginRow();
        addNumber("misalignmentRange", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Misalignment"),
                  Quantity::position, positioning<&Inputs::misalignmentRange>(), 1, Allowed::notNegative);
        addNumber("length", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Length L, if not the travel"),
                  Quantity::position, positioning<&Inputs::length>(), 1, Allowed::positive);
        beginRow();
        addNumber("temperatureRange", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Range of θ, machine"),
                  Quantity::temperature,
                  positioning<&Inputs::temperatureRange, &MachineAndInstrument::machine>(), 1,
                  Allowed::notNegative);
        addNumber("temperatureRange",
                  QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Range of θ, instrument"),
                  Quantity::temperature,
                  positioning<&Inputs::temperatureRange, &MachineAndInstrument::instrument>(), 1,
                  Allowed::notNegative);
        addNumber("expansionRange", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Range of α, machine"),
                  Quantity::expansion, positioning<&Inputs::expansionRange, &MachineAndInstrument::machine>(),
                  1, Allowed::notNegative);
        addNumber(
            "expansionRange", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Range of α, instrument"),
            Quantity::expansion, positioning<&Inputs::expansionRange, &MachineAndInstrument::instrument>(), 1,
            Allowed::notNegative);
        beginRow();
        m_typical = addButton(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage",
                                                "Take 3.4 µm/(m·°C) as range of α of the machine: gives "
                                                "the typical minimum of ISO 230-2"),
                              [this] { takeTypicalRange(); });
        m_typical->setObjectName(QStringLiteral("typicalRange"));
    }
    beginRow();
    addNumber("environmentalVariation",
              QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Environmental variation E_VE"), size,
              positioning<&Inputs::environmentalVariation>(), 1, Allowed::notNegative);
    addChoice("", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Drift in the simulation"),
              {QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "independent"),
               QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "linear in time")},
              choiceOf<DriftModel>(positioning<&Inputs::driftModel>(),
                                   {DriftModel::independent, DriftModel::linear}),
              false);
    addNumber("", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Trials, empty: adaptive"),
              Quantity::count, trialsOf(positioning<&Inputs::trials>()), 1, Allowed::whole);
    addNumber("", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Seed"), Quantity::count,
              seedOf(positioning<&Inputs::seed>()), 1, Allowed::whole);
}

void UncertaintyPage::addCircularInputs() {
    using Inputs = CircularUncertaintyInputs;
    using Both = MachineAndInstrument;
    constexpr Quantity size = Quantity::micrometres;
    addSection(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Inputs"));
    beginRow();
    addNumber("displacement", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Displacement, U"), size,
              circular<&Inputs::displacement, &ExpandedValue::expanded>(), 1, Allowed::notNegative);
    addNumber("displacement", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "k of the certificate"),
              Quantity::number, coverageOf(circular<&Inputs::displacement, &ExpandedValue::coverageFactor>()),
              1, Allowed::positive);
    addNumber("resolution", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Resolution"), size,
              circular<&Inputs::resolution>(), 1, Allowed::notNegative);
    addNumber("environmentalVariation",
              QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Environmental variation E_VE"), size,
              circular<&Inputs::environmentalVariation>(), 1, Allowed::notNegative);
    beginRow();
    addNumber("pointNoise", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Noise of a point, u"), size,
              circular<&Inputs::pointNoise>(), 1, Allowed::notNegative);
    addNumber("repeatability", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Repeatability, u"), size,
              circular<&Inputs::repeatability>(), 1, Allowed::notNegative);
    addNumber("centring", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Centring, u"), size,
              circular<&Inputs::centring>(), 1, Allowed::notNegative);
    beginRow();
    addNumber("temperatureStandardUncertainty",
              QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "u of θ, machine"), Quantity::temperature,
              circular<&Inputs::temperatureStandardUncertainty, &Both::machine>(), 1, Allowed::notNegative);
    addNumber("temperatureStandardUncertainty",
              QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "u of θ, instrument"), Quantity::temperature,
              circular<&Inputs::temperatureStandardUncertainty, &Both::instrument>(), 1,
              Allowed::notNegative);
    addNumber("expansionStandardUncertainty",
              QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "u of α, machine"), Quantity::expansion,
              circular<&Inputs::expansionStandardUncertainty, &Both::machine>(), 1, Allowed::notNegative);
    addNumber("expansionStandardUncertainty",
              QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "u of α, instrument"), Quantity::expansion,
              circular<&Inputs::expansionStandardUncertainty, &Both::instrument>(), 1, Allowed::notNegative);
    beginRow();
    addChoice("", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Temperature sensors"),
              {QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "one each"),
               QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "one for machine and instrument")},
              choiceOf<bool>(circular<&Inputs::sameSensor>(), {false, true}), false);
    addNumber("", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Trials, empty: adaptive"),
              Quantity::count, trialsOf(circular<&Inputs::trials>()), 1, Allowed::whole);
    addNumber("", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Seed"), Quantity::count,
              seedOf(circular<&Inputs::seed>()), 1, Allowed::whole);
}

void UncertaintyPage::addStatedUncertainties(const Edition &edition, bool rotary) {
    addSection(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Expanded uncertainties, k = 2"));
    const Quantity size = rotary ? Quantity::arcSeconds : Quantity::micrometres;
    const TestEvaluation &evaluation = *evaluated().tests[test()];
    constexpr int fieldsInRow = 4;
    int count = 0;
    for (const Parameter &parameter : evaluation.parameters) {
        if (count++ % fieldsInRow == 0)
            beginRow();
        Field *field =
            addNumber("expanded", QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "U of %1"), size,
                      statedFor(edition.circles ? circular<&CircularUncertaintyInputs::expanded>()
                                                : positioning<&PositioningUncertaintyInputs::expanded>(),
                                parameterId(parameter)),
                      1, Allowed::notNegative);
        field->setLabelArgument(QString::fromStdString(plainSymbol(parameter)));
    }
}

void UncertaintyPage::addOutcome() {
    addSection(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Contributions"));
    beginRow();
    m_advice = new QLabel(body());
    m_advice->setObjectName(QStringLiteral("advice"));
    m_advice->setWordWrap(true);
    addWidget(m_advice);
    beginRow();
    m_contributions = makeTable("contributions", 4, body());
    m_contributions->setItemDelegateForColumn(2, new ContributionBars(m_contributions));
    m_contributions->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    addWidget(m_contributions);
    addSection(QT_TRANSLATE_NOOP("palmer::ui::UncertaintyPage", "Both methods"));
    beginRow();
    auto *run = new QWidget(body());
    auto *row = new QHBoxLayout(run);
    row->setContentsMargins(0, 0, 0, 0);
    m_simulationText = new QLabel(run);
    m_simulationText->setObjectName(QStringLiteral("simulationText"));
    m_simulationText->setWordWrap(true);
    m_bar = new QProgressBar(run);
    m_bar->setTextVisible(false);
    m_bar->setFixedWidth(96);
    m_simulate = new QPushButton(run);
    m_simulate->setObjectName(QStringLiteral("simulate"));
    m_cancel = new QPushButton(run);
    m_cancel->setObjectName(QStringLiteral("cancelSimulation"));
    row->addWidget(m_simulationText, 1);
    row->addWidget(m_bar);
    row->addWidget(m_simulate);
    row->addWidget(m_cancel);
    connect(m_simulate, &QPushButton::clicked, this, [this] {
        m_simulator.start(evaluated(), {test()});
        showSimulation();
    });
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_simulator.cancel(); });
    addWidget(run);
    beginRow();
    m_results = makeTable("methods", 7, body());
    m_results->horizontalHeader()->setStretchLastSection(true);
    addWidget(m_results);
}

void UncertaintyPage::takeTypicalRange() {
    edit(QT_TRANSLATE_NOOP("edits", "take a typical range"), [this](Document &document) {
        editTest(document, test(), [](Test &changed) {
            if (auto *measurement = std::get_if<PositioningMeasurement>(&changed.measurement))
                measurement->uncertainty.expansionRange.machine = typicalExpansionRange;
        });
    });
}

void UncertaintyPage::refreshOthers() {
    if (m_perMetre)
        m_perMetre->setUnit(QStringLiteral("µm/m"));
    if (!m_contributions || test() >= evaluated().tests.size())
        return;
    const TestEvaluation &evaluation = *evaluated().tests[test()];
    if (m_typical) {
        const auto *measurement = std::get_if<PositioningMeasurement>(&shownTest()->measurement);
        m_typical->setVisible(measurement && !measurement->uncertainty.expansionRange.machine);
        m_typical->setToolTip(tr("A width of 3.4 µm/(m·°C), rectangular, is an expanded uncertainty of "
                                 "2 µm/(m·°C), which ISO 230-2 calls the typical minimum."));
    }
    showContributions(evaluation);
    showResults(evaluation);
    showSimulation();
}

void UncertaintyPage::showContributions(const TestEvaluation &evaluation) {
    const auto &contributions = evaluation.uncertainty.contributions;
    const auto ordered = bySize(contributions);
    double largest = 0;
    for (const Contribution &contribution : contributions)
        largest = std::max(largest, contribution.expanded.value_or(0));
    m_contributions->setAccessibleName(tr("Contributions to the uncertainty, the largest first"));
    m_contributions->setHorizontalHeaderLabels(
        {tr("Contribution"), tr("Calculation"), tr("Size"), tr("U in %1").arg(language().unit(deviation()))});
    m_contributions->setRowCount(static_cast<int>(ordered.size()));
    QString advice;
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        const Contribution &contribution = *ordered[i];
        const int row = static_cast<int>(i);
        const double share = shareOf(contribution, contributions);
        const QString name = capital(language().text(contribution.name));
        setCell(m_contributions, row, 0, name, false);
        setCell(m_contributions, row, 1,
                contribution.expanded ? language().sentence(contribution.inputs) : tr("not stated"), false);
        setCell(m_contributions, row, 2, {}, false);
        QTableWidgetItem *bar = m_contributions->item(row, 2);
        bar->setData(ContributionBars::partRole,
                     largest > 0 ? contribution.expanded.value_or(0) / largest : 0.0);
        const QString percent = tr("%1 % of U²").arg(language().number(share * 100, Quantity::number, 0));
        bar->setData(Qt::AccessibleTextRole, percent);
        bar->setToolTip(percent);
        setCell(m_contributions, row, 3,
                contribution.expanded && contribution.applies
                    ? language().number(*contribution.expanded, deviation(), contributionDecimals)
                    : QStringLiteral("–"),
                true);
        if (i == 0 && contribution.expanded && evaluation.uncertainty.complete && share >= smallShare)
            advice = tr("To improve first: %1, %2").arg(language().text(contribution.name), percent);
    }
    m_advice->setText(advice);
    m_advice->setVisible(!advice.isEmpty());
    fitRows(m_contributions);
}

void UncertaintyPage::showResults(const TestEvaluation &evaluation) {
    const Quantity quantity = deviation();
    const auto resolution = finestResolution(*evaluated().document, *shownTest());
    const auto uncertainty = [&](const std::optional<double> &value) {
        return value ? QStringLiteral("± ") +
                           language().uncertainty(*value, quantity,
                                                  decimalsWithUncertainty(*value, quantity, resolution))
                     : QStringLiteral("–");
    };
    m_results->setAccessibleName(tr("Expanded uncertainty of the results by both methods"));
    m_results->setHorizontalHeaderLabels({tr("Result"), tr("Budget"), tr("Monte Carlo"),
                                          tr("95.45 % interval"), tr("Shift"), tr("Difference"),
                                          tr("Decides")});
    m_results->setRowCount(0);
    for (const Parameter &parameter : evaluation.parameters) {
        if (!isPrinted(parameter, evaluated().document->report))
            continue;
        const int row = m_results->rowCount();
        m_results->insertRow(row);
        const bool byBudget = parameter.decidedBy == UncertaintyMethod::budget;
        const bool bySimulation = parameter.decidedBy == UncertaintyMethod::monteCarlo;
        const auto &simulated = parameter.simulated;
        QString interval = QStringLiteral("–");
        QString shift = interval;
        QString difference = interval;
        if (simulated) {
            const int decimals = decimalsWithUncertainty(simulated->expanded(), quantity, resolution);
            interval = language().number(simulated->low, quantity, decimals) + QStringLiteral(" … ") +
                       language().number(simulated->high, quantity, decimals);
            shift = language().number(simulated->shift(), quantity, decimals);
            if (parameter.budgetUncertainty && *parameter.budgetUncertainty > 0) {
                const double ratio = simulated->expanded() / *parameter.budgetUncertainty - 1;
                difference = language().number(ratio * 100, Quantity::number, 0) + QStringLiteral("\u00A0%");
                if (methodsDiffer(parameter))
                    difference = tr("%1, more than 20 %").arg(difference);
            }
        }
        setCell(m_results, row, 0, QString::fromStdString(plainSymbol(parameter)), false, true);
        setCell(m_results, row, 1, uncertainty(parameter.budgetUncertainty), true, byBudget);
        setCell(m_results, row, 2,
                uncertainty(simulated ? std::optional(simulated->expanded()) : std::nullopt), true,
                bySimulation);
        setCell(m_results, row, 3, interval, true);
        setCell(m_results, row, 4, shift, true);
        setCell(m_results, row, 5, difference, true);
        setCell(m_results, row, 6,
                byBudget       ? tr("budget")
                : bySimulation ? tr("Monte Carlo")
                               : QStringLiteral("–"),
                false);
    }
    fitRows(m_results);
}

void UncertaintyPage::showSimulation() {
    if (!m_contributions || test() >= evaluated().tests.size())
        return;
    const TestEvaluation &evaluation = *evaluated().tests[test()];
    const auto count = [this](long long trials) {
        return language().number(static_cast<double>(trials), Quantity::count, 0);
    };
    const bool running = m_simulator.isRunning() && m_simulator.test() == test();
    m_simulate->setText(tr("Simulate"));
    m_simulate->setToolTip(tr("Run the Monte Carlo simulation of this test"));
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel the simulation"));
    m_bar->setAccessibleName(tr("Progress of the simulation"));
    m_simulate->setVisible(!running);
    m_simulate->setEnabled(evaluation.uncertainty.wantsSimulation() && !evaluation.view);
    m_cancel->setVisible(running);
    m_bar->setVisible(running);
    QString text;
    if (running) {
        const SimulationProgress &progress = m_simulator.progress();
        text = tr("%1 trials").arg(count(progress.trials));
        if (const auto left = m_simulator.secondsLeft())
            text += QStringLiteral(" · ") + tr("%1 s left").arg(qCeil(*left));
        m_bar->setRange(0, progress.of ? 100 : 0);
        if (progress.of)
            m_bar->setValue(static_cast<int>(100 * progress.trials / *progress.of));
    } else if (const auto &simulation = evaluation.uncertainty.simulation) {
        text = tr("%1 trials, seed %2").arg(count(simulation->trials), count(simulation->seed));
        if (evaluation.uncertainty.outdated)
            text += QStringLiteral(" · ") + tr("outdated: the test was edited since");
    } else {
        text = evaluation.uncertainty.wantsSimulation() ? tr("not simulated yet")
                                                        : tr("needs a complete budget");
    }
    m_simulationText->setText(text);
}

} // namespace palmer::ui
