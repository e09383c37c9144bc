// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/measurement/test.h"

#include <cstddef>
#include <optional>

namespace palmer::ui {

/// Menus of the window; `bar` holds the permanent ones.
enum class WindowMenu {
    none,
    bar,
    file,
    recent,
    examples,
    exports,
    edit,
    history,
    test,
    view,
    units,
    tools,
    help
};
inline constexpr std::size_t windowMenus = static_cast<std::size_t>(WindowMenu::help) + 1;

/// Actions of the menus, described by the table in mainwindowactions.cpp. `afterReadings` and `afterCircles`
/// are the separators after actions inserted by pages.
enum class WindowAction {
    none,
    newTest,
    newCircle,
    open,
    import,
    importClipboard,
    save,
    saveAs,
    report,
    exportReadings,
    exportFigure,
    compensation,
    newWindow,
    close,
    quit,
    undo,
    redo,
    search,
    addTest,
    addCircle,
    addDrift,
    renameTest,
    duplicateTest,
    repeatTest,
    fillLikeLast,
    deleteTest,
    showInReport,
    afterReadings,
    afterCircles,
    previousTest,
    nextTest,
    setEdition,
    ownEdition,
    readingsPage,
    conditionsPage,
    agreedPointsPage,
    limitsPage,
    uncertaintyPage,
    comparisonPage,
    diagnosisPage,
    thermalPage,
    nextMissing,
    previousMissing,
    nextPane,
    previousPane,
    maximiseFigure,
    largerText,
    smallerText,
    normalText,
    micrometres,
    millimetres,
    inches,
    arcSeconds,
    degrees,
    french,
    english,
    plan,
    compare,
    feed,
    allTests,
    settings,
    help,
    shortcuts,
    validation,
    about,
    aboutQt
};
inline constexpr std::size_t windowActions = static_cast<std::size_t>(WindowAction::aboutQt) + 1;

/// State of the window that decides which actions are enabled.
struct WindowSituation {
    bool open = false;              ///< a document is open
    std::size_t tests = 0;          ///< number of tests in it
    std::size_t test = 0;           ///< index of the test in view
    std::optional<Kind> kind;       ///< of the test in view; null: none
    bool hasResults = false;        ///< the test in view has up-to-date results
    bool hasEdition = false;        ///< the test in view is evaluated under an edition
    bool hasTargets = false;        ///< the test in view has targets
    bool underOtherEdition = false; ///< the test in view is shown under another edition than its own
    bool canUndo = false;
    bool canRedo = false;
};

} // namespace palmer::ui
