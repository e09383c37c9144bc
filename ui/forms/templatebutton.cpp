// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/templatebutton.h"

#include "document/edits.h"
#include "document/filewords.h"
#include "document/savedocument.h"
#include "ui/errorbox.h"
#include "ui/model/documentmodel.h"
#include "ui/model/selection.h"
#include "ui/model/templatestore.h"
#include "ui/saving.h"
#include "ui/windowlanguage.h"

#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>

namespace palmer::ui {

namespace {

/// Elides long names, which would make the menu too wide.
QAction *addNamed(QMenu &menu, const Template &content) {
    constexpr int mostCharacters = 48;
    const QFontMetrics metrics = menu.fontMetrics();
    const QString name = QString::fromStdString(content.name);
    QAction *action =
        menu.addAction(metrics.elidedText(name, Qt::ElideRight, metrics.averageCharWidth() * mostCharacters)
                           .replace(u'&', QStringLiteral("&&")));
    action->setToolTip(name);
    return action;
}

} // namespace

TemplateButton::TemplateButton(Kind kind, DocumentModel &model, Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_kind(kind)
    , m_model(model)
    , m_selection(selection) {
    setObjectName(QStringLiteral("templates"));
    setProperty("segment", QStringLiteral("only"));
    setFocusPolicy(Qt::StrongFocus);
    setPopupMode(QToolButton::InstantPopup);
    setMenu(new QMenu(this));
    connect(menu(), &QMenu::aboutToShow, this, &TemplateButton::fill);
    retranslate();
}

bool TemplateButton::fits(const Template &content) const {
    if (content.content.index() != static_cast<std::size_t>(m_kind))
        return false;
    const auto &tests = m_model.document()->tests;
    const Test *test = m_selection.test() < tests.size() ? tests[m_selection.test()].get() : nullptr;
    if (m_kind == Kind::conditions)
        return test && conditionsOf(*test);
    const auto *set = std::get_if<LimitSet>(&content.content);
    return !set || (test && palmer::fits(*set, *test));
}

bool TemplateButton::apply(const Template &content) {
    if (!fits(content))
        return false;
    m_model.edit(QT_TRANSLATE_NOOP("edits", "fill from a template"), [&](Document &document) {
        if (const auto *machine = std::get_if<Machine>(&content.content))
            document.machine = *machine;
        else if (const auto *instrument = std::get_if<Instrument>(&content.content))
            addInstrument(document, *instrument);
        else if (const auto *laboratory = std::get_if<Laboratory>(&content.content))
            document.report.laboratory = *laboratory;
        else
            editTest(document, m_selection.test(), [&](Test &test) {
                if (const auto *declarations = std::get_if<Declarations>(&content.content))
                    applyDeclarations(test, *declarations);
                else
                    applyLimitSet(test, std::get<LimitSet>(content.content));
            });
    });
    return true;
}

Template TemplateButton::current(const QString &name) const {
    const Document &document = *m_model.document();
    Template result{name.toStdString(), Machine()};
    switch (m_kind) {
    case Kind::machine:
        result.content = document.machine;
        break;
    case Kind::instrument:
        result.content = document.instruments.empty() ? Instrument() : document.instruments.back();
        break;
    case Kind::laboratory:
        result.content = document.report.laboratory;
        break;
    case Kind::limits:
        result.content = m_selection.test() < document.tests.size()
                             ? limitSetOf(*document.tests[m_selection.test()])
                             : LimitSet();
        break;
    case Kind::conditions:
        result.content = m_selection.test() < document.tests.size()
                             ? declarationsOf(*document.tests[m_selection.test()])
                             : Declarations();
        break;
    }
    return result;
}

QString TemplateButton::suggestedName() const {
    const Document &document = *m_model.document();
    switch (m_kind) {
    case Kind::machine:
        return QString::fromStdString(document.machine.name);
    case Kind::instrument:
        return document.instruments.empty() ? QString()
                                            : QString::fromStdString(document.instruments.back().description);
    case Kind::laboratory:
        return QString::fromStdString(document.report.laboratory.name);
    case Kind::limits:
    case Kind::conditions:
        return QString::fromStdString(document.machine.name);
    }
    return {};
}

void TemplateButton::fill() {
    menu()->clear();
    QStringList unreadable;
    const std::vector<StoredTemplate> stored = storedTemplates(&unreadable);
    bool any = false;
    for (const StoredTemplate &one : stored) {
        if (!fits(one.content))
            continue;
        any = true;
        connect(addNamed(*menu(), one.content), &QAction::triggered, this,
                [this, one] { apply(one.content); });
    }
    if (!any)
        menu()->addAction(tr("No template yet"))->setEnabled(false);
    for (const QString &path : unreadable)
        menu()->addAction(tr("Cannot be read: %1").arg(QFileInfo(path).fileName()))->setEnabled(false);
    menu()->addSeparator();
    const auto add = [this](const QString &text, const char *name, void (TemplateButton::*slot)()) {
        QAction *action = menu()->addAction(text);
        action->setObjectName(QLatin1StringView(name));
        connect(action, &QAction::triggered, this, slot);
    };
    add(tr("&Keep as template…"), "keepTemplate", &TemplateButton::keep);
    add(tr("&Take from a file…"), "takeTemplate", &TemplateButton::applyFile);
    add(tr("&Save to a file…"), "saveTemplate", &TemplateButton::save);
    if (!any)
        return;
    QMenu *removal = menu()->addMenu(tr("&Delete a template"));
    for (const StoredTemplate &one : stored) {
        if (!fits(one.content))
            continue;
        connect(addNamed(*removal, one.content), &QAction::triggered, this, [one] { removeTemplate(one); });
    }
}

void TemplateButton::keep() {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("Keep as template"), tr("Name of the template"),
                                               QLineEdit::Normal, suggestedName(), &accepted);
    if (!accepted || name.trimmed().isEmpty())
        return;
    try {
        storeTemplate(current(name.trimmed()));
    } catch (const Error &error) {
        showError(this, tr("The template cannot be kept"), error);
    }
}

void TemplateButton::applyFile() {
    QFileDialog dialog(this, tr("Take a template from a file"));
    dialog.setObjectName(QStringLiteral("templateDialog"));
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilters({tr("Templates (*.palmer-template)"), tr("All files (*)")});
    if (dialog.exec() != QDialog::Accepted)
        return;
    try {
        const Template content = openTemplate(dialog.selectedFiles().constFirst());
        if (apply(content)) {
            if (!content.name.empty())
                storeTemplate(content);
            return;
        }
        QMessageBox box(QMessageBox::Information, dialog.windowTitle(),
                        tr("This template is for another page: open it there."), QMessageBox::Ok, this);
        box.setObjectName(QStringLiteral("templateBox"));
        box.exec();
    } catch (const Error &error) {
        showError(this, tr("The template cannot be read"), error);
    }
}

void TemplateButton::save() {
    SaveDialog dialog(this, tr("Save a template to a file"),
                      {tr("Templates (*.palmer-template)"), tr("All files (*)")});
    dialog.setObjectName(QStringLiteral("templateDialog"));
    dialog.selectFile(suggestedName().replace(u'/', u'-'));
    if (dialog.exec() != QDialog::Accepted)
        return;
    try {
        const QString path = dialog.selectedFiles().constFirst();
        saveBytes(writeTemplate(current(suggestedName())), path);
        saySaved(this, path);
    } catch (const Error &error) {
        showError(this, tr("The template cannot be saved"), error);
    }
}

void TemplateButton::retranslate() {
    setText(tr("Templates"));
    setToolTip(tr("Fill this page from a template, or keep it as one"));
}

} // namespace palmer::ui
