// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/equipmentpages.h"

#include "document/bounds.h"
#include "document/instruments.h"
#include "ui/forms/templatebutton.h"
#include "ui/model/documentmodel.h"

#include <QCompleter>
#include <QLineEdit>
#include <QPushButton>
#include <QStringListModel>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr const char *instrumentsContext = "palmer::ui::InstrumentsPage";

/// A member of the instrument of that index; the first statement creates a missing instrument.
template <auto... member>
auto ofInstrument(std::size_t index) {
    using T = std::remove_cvref_t<decltype(reach(std::declval<Instrument &>(), member...))>;
    return Member<T>{[index](const FormSource &source) {
                         const auto &instruments = source.document.instruments;
                         return index < instruments.size() ? reach(instruments[index], member...) : T();
                     },
                     [index](Document &document, std::size_t, const T &value) {
                         if (index < document.instruments.size()) {
                             reach(document.instruments[index], member...) = value;
                         } else if (value != T()) {
                             Instrument instrument;
                             reach(instrument, member...) = value;
                             addInstrument(document, std::move(instrument));
                         }
                     }};
}

/// The ID, which tests refer to. The field refuses one already in use.
Member<std::string> idOf(std::size_t index) {
    Member<std::string> member = ofInstrument<&Instrument::id>(index);
    member.write = [index, write = member.write](Document &document, std::size_t test,
                                                 const std::string &id) {
        if (index < document.instruments.size())
            renameInstrument(document, index, id);
        else
            write(document, test, id);
    };
    return member;
}

/// Offers these texts below the field while one is typed.
void completeFrom(Field &field, QStringList texts) {
    auto *line = qobject_cast<QLineEdit *>(field.edit());
    texts.removeAll(QString());
    texts.removeDuplicates();
    auto *completer = line->completer();
    if (!completer) {
        completer = new QCompleter(line);
        completer->setModel(new QStringListModel(completer));
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        completer->setFilterMode(Qt::MatchContains);
        line->setCompleter(completer);
        QObject::connect(completer, qOverload<const QString &>(&QCompleter::activated), line,
                         [line](const QString &text) { emit line->textEdited(text); });
    }
    static_cast<QStringListModel *>(completer->model())->setStringList(texts);
}

} // namespace

InstrumentsPage::InstrumentsPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Form(instrumentsContext, Page::instruments, model, parent)
    , m_documents(model)
    , m_selection(selection) {
    setObjectName(QStringLiteral("instrumentsPage"));
    follow(selection);
    addToBar(new TemplateButton(TemplateButton::Kind::instrument, model, selection, this));
    refresh();
}

/// Fields for each instrument, or one empty set if there is none.
void InstrumentsPage::prepare() {
    const auto instruments =
        evaluated().document ? evaluated().document->instruments : std::vector<Instrument>();
    const std::size_t count = instruments.size();
    const QString wanted = QString::number(std::max<std::size_t>(1, count)) + (count == 0 ? u'-' : u'+');
    // The empty set is not rebuilt while its first field is being typed in.
    const bool sameFields = !m_built.isEmpty() && m_built.chopped(1) == wanted.chopped(1) && count <= 1;
    std::vector<Quantity> resolutions(std::max<std::size_t>(1, count), Quantity::deviation);
    for (std::size_t k = 0; k < count; ++k)
        resolutions[k] = resolutionQuantity(*evaluated().document, instruments[k]);
    if ((m_built == wanted && m_resolutions == resolutions) || (sameFields && isAncestorOf(focusWidget())))
        return;
    m_built = wanted;
    m_resolutions = std::move(resolutions);
    clear();
    m_descriptions.clear();
    m_traces.clear();
    for (std::size_t k = 0; k < std::max<std::size_t>(1, count); ++k)
        addFields(k);
    beginRow();
    addButton(QT_TR_NOOP("Add an instrument"), [this] {
        edit(QT_TRANSLATE_NOOP("edits", "add an instrument"),
             [](Document &document) { addInstrument(document, Instrument()); });
        focusPart(*m_descriptions.back());
    })->setObjectName(QStringLiteral("addInstrument"));
    addStretch();
}

void InstrumentsPage::addFields(std::size_t k) {
    const bool several = m_built.chopped(1).toInt() > 1;
    if (several)
        addSection(QT_TR_NOOP("Instrument %1"), QString::number(k + 1));
    else
        addSection(QT_TR_NOOP("Instrument"));
    if (m_built.endsWith(u'+')) {
        addSectionButton(QT_TR_NOOP("Remove the instrument"), [this, k] {
            edit(QT_TRANSLATE_NOOP("edits", "remove an instrument"),
                 [k](Document &document) { removeInstrument(document, k); });
        })->setObjectName(QStringLiteral("removeInstrument%1").arg(k));
    }
    beginRow();
    m_descriptions.push_back(
        addText({"instruments", QT_TR_NOOP("Description")}, ofInstrument<&Instrument::description>(k), 2));
    Field *id = addText({"", QT_TR_NOOP("Short name")}, idOf(k));
    id->edit()->setObjectName(QStringLiteral("field.id.%1").arg(k));
    id->setReader([this, k](const QString &typed) -> Field::Reading {
        const auto &instruments = m_documents.document()->instruments;
        const std::string wanted = typed.toStdString();
        for (std::size_t i = 0; i < instruments.size(); ++i) {
            if (i != k && instruments[i].id == wanted)
                return {{}, tr("another instrument is called so")};
        }
        if (typed.isEmpty() && k < instruments.size())
            return {{}, tr("the tests name the instrument so: it cannot be empty")};
        return {typed, {}};
    });
    beginRow();
    addText({"", QT_TR_NOOP("Manufacturer")}, ofInstrument<&Instrument::manufacturer>(k));
    addText({"", QT_TR_NOOP("Type")}, ofInstrument<&Instrument::model>(k));
    addText("serialNumber", ofInstrument<&Instrument::serialNumber>(k));
    beginRow();
    addText("certificate", ofInstrument<&Instrument::certificate>(k));
    addText("calibratedBy", ofInstrument<&Instrument::calibratedBy>(k));
    beginRow();
    Field *laboratory = addText({"", QT_TR_NOOP("Traceable to")},
                                ofInstrument<&Instrument::traceability, &Traceability::laboratory>(k), 2);
    Field *accreditation =
        addText({"", QT_TR_NOOP("Its accreditation")},
                ofInstrument<&Instrument::traceability, &Traceability::accreditation>(k), 2);
    beginRow();
    m_traces.push_back({laboratory, accreditation,
                        addText({"", QT_TR_NOOP("Its certificate")},
                                ofInstrument<&Instrument::traceability, &Traceability::certificate>(k))});
    beginRow();
    addDate("calibrationDate", ofInstrument<&Instrument::calibrationDate>(k));
    addDate("calibrationDue", ofInstrument<&Instrument::calibrationDue>(k));
    addNumber({"", QT_TR_NOOP("Resolution")}, m_resolutions[k], ofInstrument<&Instrument::resolution>(k), 1,
              Allowed::notNegative);
}

/// An empty field says what holds in its place; one that is typed offers what the other instruments state.
void InstrumentsPage::refreshOthers() {
    const auto &instruments = evaluated().document->instruments;
    QStringList laboratories;
    QStringList accreditations;
    for (const Instrument &instrument : instruments) {
        for (const std::string &name : {instrument.traceability.laboratory, instrument.calibratedBy})
            laboratories << QString::fromStdString(name);
        accreditations << QString::fromStdString(instrument.traceability.accreditation);
    }
    for (std::size_t k = 0; k < std::min(m_traces.size(), instruments.size()); ++k) {
        const auto &[laboratory, accreditation, certificate] = m_traces[k];
        const Instrument &instrument = instruments[k];
        laboratory->setPlaceholder(QString::fromStdString(instrument.calibratedBy));
        certificate->setPlaceholder(QString::fromStdString(instrument.certificate));
        const std::string &calibratedBy = instrument.traceability.laboratory.empty()
                                              ? instrument.calibratedBy
                                              : instrument.traceability.laboratory;
        // Another instrument of the same laboratory tells its accreditation: to be chosen, not typed again.
        QStringList offered;
        for (const Instrument &other : instruments) {
            const Traceability &trace = other.traceability;
            const bool same =
                (trace.laboratory.empty() ? other.calibratedBy : trace.laboratory) == calibratedBy;
            if (same && !trace.accreditation.empty())
                offered << QString::fromStdString(trace.accreditation);
        }
        completeFrom(*laboratory, laboratories);
        completeFrom(*accreditation, offered.isEmpty() ? accreditations : offered);
    }
}

namespace {

constexpr const char *machineContext = "palmer::ui::MachinePage";

template <auto member>
auto ofMachine() {
    return ofDocument([](auto &document) -> auto & { return document.machine.*member; });
}

} // namespace

MachinePage::MachinePage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Form(machineContext, Page::machine, model, parent) {
    setObjectName(QStringLiteral("machinePage"));
    follow(selection);
    addToBar(new TemplateButton(TemplateButton::Kind::machine, model, selection, this));
    addSection(QT_TR_NOOP("Machine"));
    beginRow();
    addText("name", ofMachine<&Machine::name>());
    beginRow();
    addText("manufacturer", ofMachine<&Machine::manufacturer>());
    addText("model", ofMachine<&Machine::model>());
    beginRow();
    addText("serialNumber", ofMachine<&Machine::serialNumber>());
    addNumber({"", QT_TR_NOOP("Year of construction")}, Quantity::count,
              converted<Amount, std::optional<int>>(
                  ofMachine<&Machine::year>(),
                  [](const std::optional<int> &year) { return year ? Amount(*year) : Amount(); },
                  [](const Amount &year) {
                      return year ? std::optional<int>(static_cast<int>(*year)) : std::nullopt;
                  }),
              1, Allowed::counting);
    beginRow();
    addText("controller", ofMachine<&Machine::controller>());
    addText({"", QT_TR_NOOP("Location")}, ofMachine<&Machine::location>());
    beginRow();
    addLongText({"condition", QT_TR_NOOP("Condition")}, ofMachine<&Machine::condition>())
        ->setMost(mostOfLine);
    addStretch();
    refresh();
}

} // namespace palmer::ui
