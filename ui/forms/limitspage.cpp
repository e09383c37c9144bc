#include "ui/forms/limitspage.h"

#include "report/resulttable.h"

#include <QCoreApplication>

namespace palmer::ui {

namespace {

constexpr char context[] = "palmer::ui::LimitsPage";

const Limit *limitOf(const FormSource &source, const std::string &id) {
    if (!source.test)
        return nullptr;
    const auto found = source.test->limits.find(id);
    return found == source.test->limits.end() ? nullptr : &found->second;
}

QString rule(const FormSource &source) {
    if (!source.test)
        return {};
    switch (source.test->decisionRule.rule) {
    case Rule::simpleAcceptance:
        return QCoreApplication::translate(context,
                                           QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "simple acceptance"));
    case Rule::iso14253_1:
        return QCoreApplication::translate(
            context, QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "ISO 14253-1: conformity is to be proven"));
    case Rule::rejectionProven:
        return QCoreApplication::translate(
            context, QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "non-conformity is to be proven"));
    }
    return {};
}

} // namespace

LimitsPage::LimitsPage(Selection &selection, QWidget *parent)
    : Form(context, Page::limits, parent) {
    follow(selection);
    setObjectName(QStringLiteral("limitsPage"));
    refresh();
}

/// A row of fields for each parameter that the edition of the test knows.
void LimitsPage::prepare() {
    const Test *shown =
        test() < evaluated().tests.size() ? evaluated().document->tests[test()].get() : nullptr;
    const Edition *edition = shown ? findEdition(shown->edition) : nullptr;
    const auto *measurement = shown ? std::get_if<PositioningMeasurement>(&shown->measurement) : nullptr;
    const bool rotary = measurement && measurement->axis.motion == Motion::rotary;
    if (!edition || (edition == m_built && rotary == m_rotary))
        return;
    m_built = edition;
    m_rotary = rotary;
    clear();
    addSection(QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "Decision rule"));
    beginRow();
    addText("decisionRule", QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "Rule"), rule, 2);
    addNumber("", QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "Guard band, times U"), {},
              [](const FormSource &source) {
                  return source.test
                             ? source.language.number(source.test->decisionRule.guardFactor, Quantity::number)
                             : QString();
              });
    addSection(QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "Agreed limits"));
    const Quantity quantity = rotary ? Quantity::angularDeviation : Quantity::deviation;
    for (const Row &row : edition->rows) {
        const std::string id = row.term.id;
        beginRow();
        Field *limit =
            addNumber("limits", QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "Limit of %1"),
                      language().unit(quantity), [id, quantity](const FormSource &source) {
                          const Limit *agreed = limitOf(source, id);
                          return agreed ? stated(agreed->value, quantity, source.language) : QString();
                      });
        limit->setLabelArgument(symbolFormula(row.term.symbol).plain());
        addText("", QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "Agreed for edition"),
                [id](const FormSource &source) {
                    const Limit *agreed = limitOf(source, id);
                    return agreed ? stated(agreed->edition.value_or(source.test->edition)) : QString();
                });
        addText(
            "", QT_TRANSLATE_NOOP("palmer::ui::LimitsPage", "Source"),
            [id](const FormSource &source) {
                const Limit *agreed = limitOf(source, id);
                return agreed ? stated(agreed->source) : QString();
            },
            2);
    }
    addStretch();
}

} // namespace palmer::ui
