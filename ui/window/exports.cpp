// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/exports.h"

#include "document/savedocument.h"
#include "document/testfile.h"
#include "export/dcc.h"
#include "export/resultsjson.h"
#include "figures/figuretexts.h"
#include "figures/testfigures.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/model/background.h"
#include "ui/saving.h"
#include "ui/windowlanguage.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <functional>

namespace palmer::ui {

namespace {

constexpr const char *folderSetting = "window/exportFolder";

QString say(const char *text) {
    return QCoreApplication::translate("palmer::ui::Exports", text);
}

char markOf(ExportForm form) {
    return form == ExportForm::csvWithComma ? ',' : '.';
}

void refuse(QWidget *window, const QString &path, const Error &error) {
    showError(
        window,
        say(QT_TRANSLATE_NOOP("palmer::ui::Exports", "%1 cannot be saved")).arg(QFileInfo(path).fileName()),
        error, QMessageBox::Critical, say(QT_TRANSLATE_NOOP("palmer::ui::Exports", "Export")));
}

void ask(QWidget *window, const QString &title, const QStringList &forms,
         const std::function<QByteArray(ExportForm)> &bytes) {
    auto *dialog = made<SaveDialog>("exportDialog", window, title, forms,
                                    QSettings().value(QLatin1StringView(folderSetting)).toString());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QFileDialog::fileSelected, window, [=](const QString &path) {
        QSettings().setValue(QLatin1StringView(folderSetting), QFileInfo(path).absolutePath());
        try {
            requireNoTestFileName(path);
            const auto form = static_cast<ExportForm>(std::max<qsizetype>(0, dialog->filterOf(path)));
            awaited([&] { saveBytes(bytes(form), path); });
            saySaved(window, path);
        } catch (const Error &error) {
            refuse(window, path, error);
        }
    });
    dialog->open();
}

QStringList csvForms() {
    return {say(QT_TRANSLATE_NOOP("palmer::ui::Exports", "CSV, decimal point (*.csv)")),
            say(QT_TRANSLATE_NOOP("palmer::ui::Exports", "CSV, decimal comma (*.csv)"))};
}

} // namespace

QByteArray exportedReadings(const EvaluatedDocument &evaluated, std::size_t test, ExportForm form,
                            const QString &fileName) {
    if (form == ExportForm::json)
        return readingsJson(evaluated, fileName, windowLanguage());
    if (form == ExportForm::dcc) {
        const EvaluatedDocument own = evaluate(evaluated.document, &evaluated); // no view
        requireForDcc(own, windowLanguage());
        return dcc(own);
    }
    return readingsCsv(evaluated, test, windowLanguage(), markOf(form));
}

QByteArray exportedFigure(const EvaluatedDocument &evaluated, std::size_t test, ExportForm form) {
    const Test &shown = *evaluated.document->tests[test];
    const TestEvaluation &evaluation = *evaluated.tests[test];
    return figureCsv(figureOfTest(shown, evaluation, windowLanguage()), windowLanguage(), markOf(form));
}

void askExportOfReadings(QWidget *window, const EvaluatedDocument &evaluated, std::size_t test,
                         const QString &fileName) {
    ask(window, say(QT_TRANSLATE_NOOP("palmer::ui::Exports", "Export readings and results")),
        csvForms() << say(QT_TRANSLATE_NOOP("palmer::ui::Exports", "JSON, all tests (*.json)"))
                   << say(QT_TRANSLATE_NOOP("palmer::ui::Exports",
                                            "Digital calibration certificate, all tests (*.xml)")),
        [=](ExportForm form) { return exportedReadings(evaluated, test, form, fileName); });
}

void askExportOfFigure(QWidget *window, const EvaluatedDocument &evaluated, std::size_t test) {
    ask(window, say(QT_TRANSLATE_NOOP("palmer::ui::Exports", "Export the data of the figure")), csvForms(),
        [=](ExportForm form) { return exportedFigure(evaluated, test, form); });
}

} // namespace palmer::ui
