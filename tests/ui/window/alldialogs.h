// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernel/evaluation/positioningdata.h"
#include "register/queries.h"
#include "ui/circles/arcdialog.h"
#include "ui/dialogs/comparedialog.h"
#include "ui/dialogs/compensationdialog.h"
#include "ui/dialogs/feeddialog.h"
#include "ui/dialogs/newcircledialog.h"
#include "ui/dialogs/newtestdialog.h"
#include "ui/dialogs/plandialog.h"
#include "ui/dialogs/recoverydialog.h"
#include "ui/dialogs/reportdialog.h"
#include "ui/dialogs/shortcutsdialog.h"
#include "ui/help/helpwindow.h"
#include "ui/import/importassistant.h"
#include "ui/register/foldersdialog.h"
#include "ui/register/registerservice.h"
#include "ui/register/registerwindow.h"
#include "ui/register/troubledfiles.h"
#include "ui/window/settingsdialog.h"
#include "ui/window/shownwindow.h"

#include <QMenuBar>
#include <memory>
#include <variant>
#include <vector>

/// A table of three targets with a column nobody can tell the sign of, so that the assistant has questions.
inline QByteArray smallTable() {
    return "Position;1 +;1 -;2 +;2 -\n0;0,1;0,2;0,3;0,4\n100;1,1;1,2;1,3;1,4\n200;2,1;2,2;2,3;2,4\n";
}

/// Every dialog and every window beside the main one, over the document of that, each as its user first sees
/// it; none is shown.
inline std::vector<std::unique_ptr<QWidget>> allDialogs(palmer::ui::MainWindow &window,
                                                        palmer::ui::RegisterService &service) {
    using namespace palmer;
    using namespace palmer::ui;
    const Language &words = windowLanguage();
    const EvaluatedDocument evaluated = window.evaluator().current();
    CircularMeasurement circle;
    circle.nominalRadius = 100;
    palmer::Test other;
    other.title = "X";
    std::vector<std::unique_ptr<QWidget>> all;
    auto newTest = std::make_unique<NewTestDialog>(words);
    newTest->offerStatementsOf(other);
    all.push_back(std::move(newTest));
    auto newCircle = std::make_unique<NewCircleDialog>(words);
    newCircle->offerStatementsOf(other);
    all.push_back(std::move(newCircle));
    all.push_back(std::make_unique<ArcDialog>(circle, words, QStringLiteral("1.5\n2.5\n3.5\n")));
    all.push_back(std::make_unique<ArcDialog>(circle, words, QString()));
    const auto &first = window.model().document()->tests.at(0)->measurement;
    if (std::holds_alternative<PositioningMeasurement>(first)) {
        all.push_back(std::make_unique<PlanDialog>(window.model(), 0));
        all.push_back(std::make_unique<CompensationDialog>(evaluated, 0));
    }
    all.push_back(std::make_unique<ReportDialog>(window.model(), window.evaluator()));
    all.push_back(std::make_unique<CompareDialog>(evaluated, 0));
    all.push_back(std::make_unique<FeedDialog>());
    all.push_back(std::make_unique<SettingsDialog>());
    all.push_back(std::make_unique<ShortcutsDialog>(*window.menuBar()));
    all.push_back(std::make_unique<RecoveryDialog>(std::vector<Recovery>(3)));
    all.push_back(std::make_unique<ImportAssistant>(smallTable(), QStringLiteral("a.csv"), nullptr));
    all.push_back(std::make_unique<HelpWindow>());
    all.push_back(std::make_unique<FoldersDialog>(QStringList{QStringLiteral("/somewhere")}));
    all.push_back(std::make_unique<TroubledFiles>(std::vector<ListedSource>(2)));
    all.push_back(std::make_unique<RegisterWindow>(service));
    return all;
}
