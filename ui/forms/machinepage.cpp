#include "ui/forms/machinepage.h"

#include <QCoreApplication>

namespace palmer::ui {

namespace {

constexpr char context[] = "palmer::ui::MachinePage";

template <std::string Machine::*text>
QString of(const FormSource &source) {
    return stated(source.document.machine.*text);
}

} // namespace

MachinePage::MachinePage(QWidget *parent)
    : Form(context, Page::machine, parent) {
    setObjectName(QStringLiteral("machinePage"));
    addSection(QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Machine"));
    beginRow();
    addText("name", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Name"), of<&Machine::name>);
    beginRow();
    addText("manufacturer", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Manufacturer"),
            of<&Machine::manufacturer>);
    addText("model", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Type"), of<&Machine::model>);
    beginRow();
    addText("serialNumber", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Serial number"),
            of<&Machine::serialNumber>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Year of construction"),
            [](const FormSource &source) {
                const auto &year = source.document.machine.year;
                return year ? QString::number(*year) : QString();
            });
    beginRow();
    addText("controller", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Numerical control"),
            of<&Machine::controller>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Location"), of<&Machine::location>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::MachinePage", "Condition"), of<&Machine::condition>);
    addStretch();
    refresh();
}

} // namespace palmer::ui
