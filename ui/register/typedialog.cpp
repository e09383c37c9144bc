// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/typedialog.h"

#include "document/savedocument.h"
#include "print/pdf/writepdf.h"
#include "register/listing.h"
#include "register/typeoutput.h"
#include "ui/errorbox.h"
#include "ui/figures/figurecard.h"
#include "ui/help/reporthtml.h"
#include "ui/madewidgets.h"
#include "ui/saving.h"
#include "ui/sizeonscreen.h"
#include "ui/windowlanguage.h"

#include <QBuffer>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTextBrowser>
#include <algorithm>

namespace palmer::ui {

TypeDialog::TypeDialog(std::vector<TypeTest> tests, QWidget *parent)
    : QDialog(parent)
    , m_tests(std::move(tests))
    , m_parameter(made<QComboBox>("typeParameter", this))
    , m_figure(made<LineView>("typeFigure", this))
    , m_quantiles{made<LineView>("typeQuantiles", this), made<LineView>("typeLogarithms", this)}
    , m_text(made<QTextBrowser>("typeText", this)) {
    constexpr QSize usual(900, 720);
    setObjectName(QStringLiteral("typeDialog"));
    const ListedMachine &machine = m_tests.front().members.front().machine;
    setWindowTitle(tr("Type test of %1").arg((machine.manufacturer + u' ' + machine.model).trimmed()));
    for (const TypeTest &test : m_tests)
        m_parameter->addItem(QString::fromStdString(test.axis) + QStringLiteral(" · ") +
                             plainSymbolOf(test.parameter));
    m_parameter->setAccessibleName(tr("Axis and parameter"));
    m_figure->setAccessibleName(tr("Values of the machines"));
    m_text->setAccessibleName(windowTitle());
    m_text->setFrameShape(QFrame::NoFrame);
    auto *label = new QLabel(tr("&Axis and parameter"), this);
    label->setBuddy(m_parameter);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto *pdf = buttons->addButton(tr("&Save PDF…"), QDialogButtonBox::ActionRole);
    pdf->setObjectName(QStringLiteral("saveType"));
    pdf->setAutoDefault(false);
    connect(pdf, &QPushButton::clicked, this, &TypeDialog::save);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const auto most =
        std::ranges::max_element(m_tests, {}, [](const TypeTest &test) { return test.members.size(); });
    m_parameter->setCurrentIndex(static_cast<int>(most - m_tests.begin())); // the first of those
    connect(m_parameter, &QComboBox::currentIndexChanged, this, &TypeDialog::show);
    auto *choice = inRow(8, {label, m_parameter, Placed::stretch()});
    auto *quantiles = inColumn(styleSpacing, {m_quantiles[0], m_quantiles[1]});
    auto *figures = inRow(8, {{m_figure, 3}, {quantiles, 2}});
    inColumn(this, styleMargins, styleSpacing, {choice, {figures, 1}, {m_text, 1}, buttons});
    resize(sizeOnScreen(*this, usual));
    show(m_parameter->currentIndex());
}

void TypeDialog::show(int index) {
    const TypeTest &test = m_tests.at(static_cast<std::size_t>(index));
    m_figure->setFigure(typeFigure(test, windowLanguage()));
    for (const std::size_t i : {0U, 1U}) {
        LineFigure figure = quantileFigure(test, i == 1, windowLanguage());
        const bool shown = !figure.lines.empty();
        m_quantiles.at(i)->setVisible(shown);
        m_quantiles.at(i)->setAccessibleName(figure.title);
        m_quantiles.at(i)->setToolTip(figure.title);
        m_quantiles.at(i)->setFigure(shown ? std::optional<Figure>(std::move(figure)) : std::nullopt);
    }
    m_text->setHtml(reportHtml(composeTypeTest(test, windowLanguage())));
}

void TypeDialog::save() {
    const TypeTest &test = m_tests.at(static_cast<std::size_t>(m_parameter->currentIndex()));
    const Report report = composeTypeTest(test, windowLanguage(), true);
    const QString path = askForPdf(this, tr("Save the type test"), QString(report.title).remove(u':'));
    if (path.isEmpty())
        return;
    try {
        QBuffer pdf;
        pdf.open(QIODevice::WriteOnly);
        writePdf(report, pdf);
        saveBytes(pdf.data(), path);
        saySaved(this, path);
    } catch (const Error &error) {
        showError(this, tr("The type test was not saved"), error);
    }
}

void showTypeTests(std::vector<TypeTest> tests, QWidget *parent) {
    if (tests.empty()) {
        QMessageBox::information(parent, TypeDialog::tr("No type test"),
                                 TypeDialog::tr("The machines of this type have no test with a result."));
        return;
    }
    auto *dialog = new TypeDialog(std::move(tests), parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace palmer::ui
