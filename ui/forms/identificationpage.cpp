#include "ui/forms/identificationpage.h"

#include <QCoreApplication>

namespace palmer::ui {

namespace {

constexpr char context[] = "palmer::ui::IdentificationPage";

template <std::string ReportHead::*text>
QString of(const FormSource &source) {
    return stated(source.document.report.*text);
}

template <std::optional<std::string> ReportHead::*date>
QString dateOf(const FormSource &source) {
    return statedDate(source.document.report.*date, source.language);
}

template <auto part, auto text>
QString within(const FormSource &source) {
    return stated(source.document.report.*part.*text);
}

} // namespace

IdentificationPage::IdentificationPage(QWidget *parent)
    : Form(context, Page::identification, parent) {
    setObjectName(QStringLiteral("identificationPage"));
    addSection(QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Report"));
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Title"), of<&ReportHead::title>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Number"), of<&ReportHead::number>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Revision"), of<&ReportHead::revision>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Replaces"), of<&ReportHead::replaces>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Date of issue"),
            dateOf<&ReportHead::date>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Performed from"),
            dateOf<&ReportHead::performedFrom>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "to"), dateOf<&ReportHead::performedTo>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Place"), of<&ReportHead::place>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Operator"),
            of<&ReportHead::operatorName>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Order"), of<&ReportHead::order>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Procedure"), of<&ReportHead::procedure>);

    addSection(QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Laboratory"));
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Name"),
            within<&ReportHead::laboratory, &Laboratory::name>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Accreditation"),
            within<&ReportHead::laboratory, &Laboratory::accreditation>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Address"),
            within<&ReportHead::laboratory, &Laboratory::address>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Authorised by"),
            within<&ReportHead::authorisedBy, &Authorisation::name>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Function"),
            within<&ReportHead::authorisedBy, &Authorisation::function>);

    addSection(QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Customer and supplier"));
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Customer"),
            within<&ReportHead::customer, &Party::name>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Address of the customer"),
            within<&ReportHead::customer, &Party::address>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Supplier"),
            within<&ReportHead::supplier, &Party::name>);
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Address of the supplier"),
            within<&ReportHead::supplier, &Party::address>);

    addSection(QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Remarks"));
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Adjustments made"),
            of<&ReportHead::adjustments>);
    beginRow();
    addText("", QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Remarks"), of<&ReportHead::remarks>);
    addStretch();
    refresh();
}

} // namespace palmer::ui
