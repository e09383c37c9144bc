// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/identificationpage.h"

#include "document/bounds.h"
#include "document/savedocument.h"
#include "print/pdf/logo.h"
#include "ui/forms/templatebutton.h"
#include "ui/madewidgets.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

constexpr const char *identificationContext = "palmer::ui::IdentificationPage";
constexpr QSize pictureRoom(180, 48);
constexpr qint64 largestPicture = qint64{4} * 1024 * 1024; ///< bytes; stored in every file and report

template <auto member>
auto ofReport() {
    return ofDocument([](auto &document) -> auto & { return document.report.*member; });
}

template <auto part, auto member>
auto within() {
    return ofDocument([](auto &document) -> auto & { return document.report.*part.*member; });
}

struct SignerWord {
    Signer signer = Signer::operatorSigns;
    const char *word = nullptr;
};
constexpr std::array signerWords{
    SignerWord{Signer::operatorSigns, QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Operator")},
    SignerWord{Signer::laboratory, QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Laboratory")},
    SignerWord{Signer::supplier, QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Supplier")},
    SignerWord{Signer::customer, QT_TRANSLATE_NOOP("palmer::ui::IdentificationPage", "Customer")},
};

} // namespace

IdentificationPage::IdentificationPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Form(identificationContext, Page::identification, model, parent) {
    setObjectName(QStringLiteral("identificationPage"));
    follow(selection);
    addToBar(new TemplateButton(TemplateButton::Kind::laboratory, model, selection, this));
    addSection(QT_TR_NOOP("Report"));
    beginRow();
    addText({"", QT_TR_NOOP("Title")}, ofReport<&ReportHead::title>());
    beginRow();
    addText("number", ofReport<&ReportHead::number>());
    addText({"", QT_TR_NOOP("Revision")}, ofReport<&ReportHead::revision>());
    addText({"", QT_TR_NOOP("Replaces")}, ofReport<&ReportHead::replaces>());
    addText({"", QT_TR_NOOP("Reason of the revision")}, ofReport<&ReportHead::revisionReason>());
    beginRow();
    addDate({"date", QT_TR_NOOP("Date of issue")}, ofReport<&ReportHead::date>());
    addDate({"", QT_TR_NOOP("Performed from")}, ofReport<&ReportHead::performedFrom>());
    addDate({"", QT_TR_NOOP("to")}, ofReport<&ReportHead::performedTo>());
    beginRow();
    addText("place", ofReport<&ReportHead::place>());
    addText({"", QT_TR_NOOP("Operator")}, ofReport<&ReportHead::operatorName>());
    beginRow();
    addText({"", QT_TR_NOOP("Order")}, ofReport<&ReportHead::order>());
    addText({"", QT_TR_NOOP("Procedure")}, ofReport<&ReportHead::procedure>());
    addText({"", QT_TR_NOOP("Deviations from the method")}, ofReport<&ReportHead::deviationsFromMethod>());
    addLaboratory();
    addParties();
    addRemarks();
    addStretch();
    refresh();
}

void IdentificationPage::addLaboratory() {
    addSection(QT_TR_NOOP("Laboratory"));
    beginRow();
    addText({"", QT_TR_NOOP("Name")}, within<&ReportHead::laboratory, &Laboratory::name>());
    addText({"", QT_TR_NOOP("Accreditation")}, within<&ReportHead::laboratory, &Laboratory::accreditation>());
    const auto code = [](const QString &typed) { return typed.trimmed().toUpper(); };
    Member<std::string> country = within<&ReportHead::laboratory, &Laboratory::country>();
    country.write = [code, write = country.write](Document &document, std::size_t test,
                                                  const std::string &typed) {
        write(document, test, code(QString::fromStdString(typed)).toStdString());
    };
    addText({"country", QT_TR_NOOP("Country")}, std::move(country))
        ->setReader([code](const QString &typed) -> Field::Reading {
            static const QRegularExpression letters(QStringLiteral("^([A-Z]{2})?$"));
            if (!letters.match(code(typed)).hasMatch())
                return {{}, tr("two letters (ISO 3166-1), as FR")};
            return {code(typed), {}};
        });
    beginRow();
    addLongText("address", within<&ReportHead::laboratory, &Laboratory::address>());
    beginRow();
    addText("authorisedBy", within<&ReportHead::authorisedBy, &Authorisation::name>());
    addText({"", QT_TR_NOOP("Function")}, within<&ReportHead::authorisedBy, &Authorisation::function>());

    addPicture(QT_TR_NOOP("Logo"), QT_TR_NOOP("Choose the logo…"), QT_TR_NOOP("Remove the logo"),
               &Laboratory::logo);
    addPicture(QT_TR_NOOP("Mark of the accreditation body"), QT_TR_NOOP("Choose the mark…"),
               QT_TR_NOOP("Remove the mark"), &Laboratory::mark);
}

void IdentificationPage::addParties() {
    addSection(QT_TR_NOOP("Customer and supplier"));
    beginRow();
    addText({"customer", QT_TR_NOOP("Customer")}, within<&ReportHead::customer, &Party::name>());
    addLongText({"customer", QT_TR_NOOP("Address of the customer")},
                within<&ReportHead::customer, &Party::address>());
    addText({"", QT_TR_NOOP("Contact")}, within<&ReportHead::customer, &Party::contact>());
    beginRow();
    addText({"", QT_TR_NOOP("Supplier")}, within<&ReportHead::supplier, &Party::name>());
    addLongText({"", QT_TR_NOOP("Address of the supplier")},
                within<&ReportHead::supplier, &Party::address>());

    addSection(QT_TR_NOOP("Signatures"));
    addSigners();
}

void IdentificationPage::addRemarks() {
    addSection(QT_TR_NOOP("Remarks"));
    beginRow();
    addLongText({"", QT_TR_NOOP("Adjustments made")}, ofReport<&ReportHead::adjustments>())
        ->setMost(mostOfLine);
    beginRow();
    addLongText({"", QT_TR_NOOP("Remarks")}, ofReport<&ReportHead::remarks>());
}

void IdentificationPage::addPicture(const char *label, const char *choose, const char *remove,
                                    Picture picture) {
    beginRow();
    auto *shown = made<QLabel>(label, body());
    shown->setMinimumHeight(pictureRoom.height());
    addWidget(shown);
    addButton(choose, [this, picture] { choosePicture(picture); });
    QPushButton *button = addButton(remove, [this, picture] {
        edit(QT_TRANSLATE_NOOP("edits", "remove the picture"),
             [&](Document &document) { (document.report.laboratory.*picture).reset(); });
    });
    m_pictures.push_back({picture, shown, button, {}, false});
}

void IdentificationPage::choosePicture(Picture picture) {
    QFileDialog dialog(this, tr("Choose a picture"));
    dialog.setObjectName(QStringLiteral("pictureDialog"));
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilters({tr("Pictures (*.png *.svg)"), tr("All files (*)")});
    if (dialog.exec() != QDialog::Accepted)
        return;
    QString problem;
    QByteArray bytes;
    try {
        bytes = readBytes(dialog.selectedFiles().constFirst(), largestPicture);
        if (Logo(bytes).empty())
            problem = tr("This is no picture that a report can show. Choose a PNG or an SVG.");
    } catch (const Error &error) {
        problem =
            error.kind == Error::Kind::tooLarge
                ? tr("The picture is larger than 4 MiB: it stands in every report. Choose a smaller one.")
                : tr("The file cannot be read.");
    }
    if (!problem.isEmpty()) {
        QMessageBox box(QMessageBox::Warning, tr("Choose a picture"), problem, QMessageBox::Ok, this);
        box.setObjectName(QStringLiteral("pictureBox"));
        box.exec();
        return;
    }
    edit(QT_TRANSLATE_NOOP("edits", "choose a picture"),
         [&](Document &document) { document.report.laboratory.*picture = bytes.toBase64().toStdString(); });
}

void IdentificationPage::addSigners() {
    beginRow();
    for (const SignerWord &row : signerWords) {
        auto *box = made<QCheckBox>(QStringLiteral("signs.") + QString::fromLatin1(row.word), body());
        addWidget(box);
        m_signers.emplace_back(row.signer, box);
        connect(box, &QCheckBox::clicked, this, [this, signer = row.signer](bool signs) {
            edit(QT_TRANSLATE_NOOP("edits", "change who signs"), [&](Document &document) {
                // In the order printed in the report.
                std::vector<Signer> &signers = document.report.signatures;
                std::erase(signers, signer);
                if (signs)
                    signers.push_back(signer);
                std::ranges::sort(signers);
            });
        });
    }
}

void IdentificationPage::refreshOthers() {
    for (std::size_t i = 0; i < m_signers.size(); ++i) {
        const auto &[signer, box] = m_signers[i];
        box->setText(word(signerWords[i].word));
        const auto &signers = evaluated().document->report.signatures;
        box->setChecked(std::ranges::find(signers, signer) != signers.end());
    }
    for (PictureRow &row : m_pictures) {
        const auto &picture = evaluated().document->report.laboratory.*row.picture;
        const QString name = word(row.shown->objectName().toUtf8().constData());
        row.remove->setVisible(picture.has_value());
        row.shown->setAccessibleName(name);
        if (!picture)
            row.shown->setText(tr("%1: none").arg(name));
        if (row.isDrawn && row.drawn == picture)
            continue;
        row.isDrawn = true;
        row.drawn = picture;
        const Logo logo(picture ? QByteArray::fromBase64(QByteArray::fromStdString(*picture)) : QByteArray());
        if (logo.empty())
            continue;
        QPixmap pixmap(pictureRoom * devicePixelRatio());
        pixmap.setDevicePixelRatio(devicePixelRatio());
        pixmap.fill(Qt::white); // as on paper
        QPainter painter(&pixmap);
        const QSizeF size = logo.size(pictureRoom);
        logo.draw(painter, QRectF(QPointF(0, (pictureRoom.height() - size.height()) / 2), size));
        painter.end();
        row.shown->setPixmap(pixmap);
    }
}

} // namespace palmer::ui
