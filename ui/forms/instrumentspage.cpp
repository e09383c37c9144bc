#include "ui/forms/instrumentspage.h"

#include <QCoreApplication>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr char context[] = "palmer::ui::InstrumentsPage";

/// A member of the instrument of that index.
template <std::string Instrument::*text>
Form::Value of(std::size_t index) {
    return [index](const FormSource &source) {
        const auto &instruments = source.document.instruments;
        return index < instruments.size() ? stated(instruments[index].*text) : QString();
    };
}

template <std::optional<std::string> Instrument::*date>
Form::Value dateOf(std::size_t index) {
    return [index](const FormSource &source) {
        const auto &instruments = source.document.instruments;
        return index < instruments.size() ? statedDate(instruments[index].*date, source.language) : QString();
    };
}

} // namespace

InstrumentsPage::InstrumentsPage(QWidget *parent)
    : Form(context, Page::instruments, parent) {
    setObjectName(QStringLiteral("instrumentsPage"));
    refresh();
}

/// Fields for each instrument; one empty set where there is none.
void InstrumentsPage::prepare() {
    const std::size_t count =
        evaluated().document ? std::max<std::size_t>(1, evaluated().document->instruments.size()) : 1;
    if (m_built == count)
        return;
    m_built = count;
    clear();
    for (std::size_t k = 0; k < count; ++k) {
        addSection(QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Instrument"));
        beginRow();
        addText("instruments", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Description"),
                of<&Instrument::description>(k), 2);
        addText("", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Short name"), of<&Instrument::id>(k));
        beginRow();
        addText("", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Manufacturer"),
                of<&Instrument::manufacturer>(k));
        addText("", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Type"), of<&Instrument::model>(k));
        addText("serialNumber", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Serial number"),
                of<&Instrument::serialNumber>(k));
        beginRow();
        addText("certificate", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Calibration certificate"),
                of<&Instrument::certificate>(k));
        addText("", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Calibrated by"),
                of<&Instrument::calibratedBy>(k));
        beginRow();
        addText("calibrationDate", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Calibrated on"),
                dateOf<&Instrument::calibrationDate>(k));
        addText("", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Calibration due"),
                dateOf<&Instrument::calibrationDue>(k));
        addNumber("", QT_TRANSLATE_NOOP("palmer::ui::InstrumentsPage", "Resolution"), QStringLiteral("µm"),
                  [k](const FormSource &source) {
                      const auto &instruments = source.document.instruments;
                      return k < instruments.size()
                                 ? stated(instruments[k].resolution, Quantity::deviation, source.language)
                                 : QString();
                  });
    }
    addStretch();
}

} // namespace palmer::ui
