// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/machinepage.h"

#include "document/bounds.h"
#include "ui/forms/templatebutton.h"

namespace palmer::ui {

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
              1, Allowed::whole);
    beginRow();
    addText("controller", ofMachine<&Machine::controller>());
    addText({"", QT_TR_NOOP("Location")}, ofMachine<&Machine::location>());
    beginRow();
    addLongText({"", QT_TR_NOOP("Condition")}, ofMachine<&Machine::condition>())->setMost(mostOfLine);
    addStretch();
    refresh();
}

} // namespace palmer::ui
