// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/historypdf.h"

#include "document/savedocument.h"
#include "print/pdf/writepdf.h"
#include "register/history.h"
#include "register/register.h"
#include "ui/saving.h"
#include "ui/windowlanguage.h"

#include <QBuffer>
#include <QInputDialog>
#include <QMessageBox>
#include <variant>

namespace palmer::ui {

void HistoryPdf::save(const QString &address, const ListedMachine &machine) {
    QInputDialog ask(&m_window);
    ask.setObjectName(QStringLiteral("historyNumber"));
    ask.setWindowTitle(tr("History report"));
    ask.setLabelText(tr("Number of the history, printed on every page; may be empty:"));
    ask.setTextValue(proposedHistoryNumber(machine, QDate::currentDate()));
    if (ask.exec() != QDialog::Accepted)
        return;
    const QString number = ask.textValue().simplified();
    const QString path =
        askForPdf(&m_window, tr("Save the history"), number.isEmpty() ? machine.title() : number);
    if (path.isEmpty())
        return;
    m_lane.start(
        [address, machine, number,
         language = windowLanguage()](const Background::Job &) -> std::variant<Report, Error> {
            try {
                Register reg(address, Register::Open::read);
                History history = historyOf(reg.database(), machine, QDate::currentDate(),
                                            QStringLiteral("Palmer " PALMER_VERSION));
                history.number = number;
                return composeHistory(history, language);
            } catch (const Error &error) { // e.g. connection lost
                return error;
            }
        },
        [this, path](const std::variant<Report, Error> &composed) {
            try {
                if (const auto *error = std::get_if<Error>(&composed))
                    throw *error;
                QBuffer pdf;
                pdf.open(QIODevice::WriteOnly);
                writePdf(std::get<Report>(composed), pdf);
                saveBytes(pdf.data(), path);
                saySaved(&m_window, path);
            } catch (const Error &error) {
                QMessageBox::warning(&m_window, tr("The history was not saved"),
                                     windowLanguage().sentence(error.message));
            }
        });
}

} // namespace palmer::ui
